# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command `camaron select`, its files, and the strategies that count."""

import contextlib
import csv
import io
import json
import os
import subprocess

import camaron
import camaron_testing
import gallery
import mesh_parts
import numpy
from camaron import cli
from camaron import export
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

BALL = camaron_testing.EXAMPLES / "voronoi-ball.visf"
SMALL_ANGLES = "By criterion: Array=MinDihedralAngle; Range=Custom; Side=Inside; Upper Limit=60"


class TestSelectCommand(camaron_testing.TestCase):
    def run_select(self, *arguments):
        words = ["select", *map(str, arguments)]
        out, err = io.StringIO(), io.StringIO()
        before = os.getcwd()
        os.chdir(self.folder)
        try:
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
                status = cli.main(words)
        except SystemExit as end:  # argparse's
            status = end.code
        finally:
            os.chdir(before)
        return subprocess.CompletedProcess(words, status, out.getvalue(), err.getvalue())

    def values(self, name):
        """A criterion of the cells of the example."""
        quality = simple.ElementQuality(Input=self.open(BALL), Criteria=[name])
        quality.UpdatePipeline()
        return vtk_to_numpy(self.fetch(quality).GetCellData().GetArray(name))

    def select(self, source, **properties):
        select = simple.SelectElements(Input=source, **properties)
        with camaron_testing.pipeline.Messages() as messages:
            select.UpdatePipeline()
        self.assertEqual(messages.errors, [])
        return select, set(
            numpy.flatnonzero(
                vtk_to_numpy(self.fetch(select).GetCellData().GetArray("Selected"))
            ).tolist()
        )

    def test_files(self):
        """A table, ids, a set and a mesh of the same cells."""
        angles = self.values("MinDihedralAngle")
        expected = numpy.flatnonzero(angles <= 60).tolist()
        self.assertTrue(expected)
        done = self.run_select(
            BALL,
            "--by",
            SMALL_ANGLES,
            "-o",
            "bad.csv",
            "-o",
            "bad.txt",
            "-o",
            "sets/bad",
            "-o",
            "bad.visf",
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn(f"{len(expected)} cells", done.stdout)
        with open(self.folder / "bad.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([int(row["Id"]) for row in rows], expected)
        self.assertEqual(
            [float(row["MinDihedralAngle"]) for row in rows], angles[expected].tolist()
        )
        grid = self.fetch(self.open(BALL))
        for row in rows:
            points = grid.GetCell(int(row["Id"])).GetPoints()
            middle = numpy.mean(
                [points.GetPoint(i) for i in range(points.GetNumberOfPoints())], axis=0
            )
            self.assertLess(
                numpy.abs(middle - [float(row[c]) for c in "XYZ"]).max(),
                1e-12,
                "mean of the points",
            )
            self.assertEqual(row["CellType"], "Polyhedron")
        self.assertEqual((self.folder / "bad.txt").read_text().split(), [str(i) for i in expected])
        lines = (self.folder / "sets" / "bad").read_text().split("\n")
        self.assertIn("    class       cellSet;", lines)
        body = lines[lines.index("(") + 1 : lines.index(")")]
        self.assertEqual(
            (lines[lines.index("(") - 1], body), (str(len(body)), [str(i) for i in expected])
        )
        self.assertEqual(
            self.open(self.folder / "bad.visf").GetDataInformation().GetNumberOfCells(), len(body)
        )

    def test_steps(self):
        """Each goes on from the one before, and they are what the filter does."""
        quality = simple.ElementQuality(Input=self.open(BALL), Criteria=["Volume"])
        first, _ = self.select(quality, Strategy="Worst N", Array="Volume", NumberOfWorst=5)
        second, grown = self.select(first, Strategy="Expand", Adjacency="Edge", NumberOfLayers=2)
        third = simple.SelectElements(
            Input=second,
            Strategy="Shape",
            Shape="Sphere",
            Placement="Any vertex inside",
            Combination="Subtract",
        )
        third.Shape.Center, third.Shape.Radius = [0, 0, 0.5], 0.4
        third.UpdatePipeline()
        third.UpdatePropertyInformation()
        result = camaron.select(
            BALL,
            [
                "worst n: array=Volume; number of worst=5",
                "Expand: Adjacency=edge; NumberOfLayers=2",
                "Shape: Radius=0.4; Shape=sphere; Center=0,0,0.5; Placement=any vertex inside; Combination=subtract",
            ],
        )
        counts = [step["selected"] for step in result["steps"]]
        self.assertEqual(counts[:2], [5, len(grown)])
        self.assertEqual(counts[2], third.GetPropertyValue("NumberOfSelectedElements"))
        self.assertLess(counts[2], counts[1])
        # A limit makes the range a custom one; an array of points may be called Array.
        small = [SMALL_ANGLES.replace(" Range=Custom;", ""), SMALL_ANGLES]
        numbers = [camaron.select(BALL, [step])["selected"] for step in small]
        self.assertEqual(*numbers)
        self.assertTrue(0 < numbers[0] < 800, numbers)
        done = self.run_select(BALL, "--by", "Undefined: Element Type=Points; Array=No")
        self.assertIn("no one-component point array named 'No'", done.stderr)
        done = self.run_select(BALL, "--by", "Boundary: Element Type=Points", "--json")
        self.assertEqual(json.loads(done.stdout)["elements"], "Points")

    def test_errors(self):
        """An error of one line with the most similar name, and no file."""
        for step, reason in (
            ("Wrst N", "did you mean Worst N?"),
            ("Worst N: Arry=Volume", "did you mean Array?"),
            ("Worst N: Volume", "expected NAME=VALUE, found 'Volume'"),
            ("Worst N: Array=Volume; NumberOfWorst=x", "expected a number, found 'x'"),
            (
                "Worst N: Array=Volume; NumberOfWorst=3000000000",
                "NumberOfWorst: expected a smaller number, found '3000000000'",
            ),
            (
                "Half-spaces: Planes=0,0,0,1,0,0,0",
                "Planes: expected a multiple of 6 numbers, found 7",
            ),
            ("Shape: Shape=Sphere; Center=0,0", "Center: "),
            ("Worst N: Array=Volum", "named 'Volum'"),
            ("By id: Ids=4-2", "Ids: 4-2 is a descending range"),
            ("Number of elements: Counts=a", "Counts: expected a number, found 'a'"),
        ):
            done = self.run_select(BALL, "--by", step, "-o", "none.csv")
            self.assertEqual(done.returncode, 2, step)
            self.assertIn(reason, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        for target, reason in (
            ("none.zzz", "no writer for .zzz"),
            ("none", "no writer for files without an extension"),
            ("none.vtu", "no cell is selected"),
            ("first.csv", "first.csv: expected other names for the other outputs"),
        ):
            done = self.run_select(BALL, "--by", "By id: Ids=", "-o", "first.csv", "-o", target)
            self.assertEqual(done.returncode, 2, target)
            self.assertIn(reason, done.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_number_of_elements(self):
        source = self.open(BALL)
        for counted, criterion in (
            ("Faces", "FaceCount"),
            ("Edges", "EdgeCount"),
            ("Vertices", "VertexCount"),
        ):
            counts = self.values(criterion)
            for text, wanted in (("14", {14}), ("13-15, 18", {13, 14, 15, 18}), ("24", {24})):
                _, found = self.select(
                    source, Strategy="Number of elements", Counted=counted, Counts=text
                )
                self.assertEqual(
                    found, {i for i, n in enumerate(counts) if n in wanted}, (counted, text)
                )

    def test_failed_criteria(self):
        """Counted like the rules of the preset say, of the arrays that are there."""
        source = self.open(BALL)
        names = ["MaxNonOrthogonality", "MaxFaceSkewness", "MinFaceWeight", "Volume"]
        ranges = self.folder / "my.ranges"
        ranges.write_text("MaxNonOrthogonality * 10\nMaxFaceSkewness * 0.8\nMinFaceWeight 0.4 *\n")
        quality = simple.ElementQuality(Input=source, Criteria=names)
        fails = (
            (self.values("MaxNonOrthogonality") > 10).astype(int)
            + (self.values("MaxFaceSkewness") > 0.8)
            + (self.values("MinFaceWeight") < 0.4)
        )
        self.assertEqual(set(fails.tolist()), {0, 1, 2, 3})
        for number in (1, 2, 3, 4):
            select, found = self.select(
                quality, Strategy="Failed criteria", RangesFile=str(ranges), NumberOfFailures=number
            )
            self.assertEqual(found, set(numpy.flatnonzero(fails >= number).tolist()))
            counts = self.fetch(select).GetCellData().GetArray("FailedCriteriaCount")
            self.assertEqual(vtk_to_numpy(counts).tolist(), fails.tolist())
        radians = simple.ElementQuality(Input=source, Criteria=names, AngleUnits="Radians")
        _, found = self.select(
            radians, Strategy="Failed criteria", RangesFile=str(ranges), NumberOfFailures=3
        )
        self.assertEqual(found, set(numpy.flatnonzero(fails >= 3).tolist()))

    def test_failed_rules(self):
        """The table has the values by which cells fail."""
        path = self.folder / "bad.csv"
        rule = "MaxNonOrthogonality <= 10"
        camaron.select(BALL, [f"Failed rules: Rules={rule}"], [path])
        rows = list(csv.DictReader(path.open()))
        values = [float(row["MaxNonOrthogonality"]) for row in rows]
        self.assertGreater(min(values), 10)
        self.assertEqual(len(rows), (self.values("MaxNonOrthogonality") > 10).sum())

    def test_lists_of_points_and_blocks(self):
        """Points have a type of their own; blocks are told apart, and elements of several make no set."""
        points = simple.SelectElements(
            Input=self.open(BALL), ElementType="Points", Strategy="By id", Ids="3,5"
        )
        points.UpdatePipeline()
        self.assertEqual(export.write_list(points, self.folder / "points.csv"), 2)
        with open(self.folder / "points.csv", newline="") as file:
            self.assertEqual(
                [(row["Id"], row["CellType"]) for row in csv.DictReader(file)],
                [("3", "Point"), ("5", "Point")],
            )
        export.write_list(points, self.folder / "sets" / "points")
        self.assertIn("pointSet", (self.folder / "sets" / "points").read_text())
        two = simple.GroupDatasets(
            Input=[self.open(BALL), mesh_parts.producer(mesh_parts.make_mesh())]
        )
        both = simple.SelectElements(Input=two, Strategy="By id", Ids="0,800")
        both.UpdatePipeline()
        self.assertEqual(export.write_list(both, self.folder / "both.csv"), 2)
        with open(self.folder / "both.csv", newline="") as file:
            self.assertEqual(len({row["Block"] for row in csv.DictReader(file)}), 2)
        with self.assertRaisesRegex(ValueError, "one block, these are of "):
            export.write_list(both, self.folder / "sets" / "both")
        one = simple.SelectElements(Input=two, Strategy="By id", Ids="0")
        one.UpdatePipeline()
        self.assertEqual(export.write_list(one, self.folder / "sets" / "one"), 1)
        second = simple.SelectElements(
            Input=two, Strategy="By id", Ids="801"
        )  # of which 1 is not the id
        second.UpdatePipeline()
        with self.assertRaisesRegex(ValueError, "of the first mesh, these are of "):
            export.write_list(second, self.folder / "sets" / "second")
        cloud = mesh_parts.producer(
            gallery.make_grid([(9, 9, 9)] * 3, [])
        )  # no cells, but points before
        behind = simple.SelectElements(
            Input=simple.GroupDatasets(Input=[cloud, self.open(BALL)]),
            ElementType="Points",
            Strategy="By id",
            Ids="5",
        )
        behind.UpdatePipeline()
        with self.assertRaisesRegex(ValueError, "of the first mesh, these are of "):
            export.write_list(behind, self.folder / "sets" / "behind")
        with self.assertRaisesRegex(ValueError, "ends in .csv or .txt"):
            export.write_list(points, self.folder / "points.vtu")


if __name__ == "__main__":
    camaron_testing.main()
