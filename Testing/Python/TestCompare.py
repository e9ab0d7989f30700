# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command `camaron compare` and camaron.compare: numbers, files, exit status."""

import contextlib
import io
import json
import os
import re
import xml.etree.ElementTree as ElementTree

import camaron_testing
import numpy
from camaron import cli, compare, convert, inspect
from paraview import simple

BALL = camaron_testing.EXAMPLES / "voronoi-ball.visf"
FLANGE = camaron_testing.EXAMPLES / "flange.visf"
CRITERIA = ["Volume", "MinDihedralAngle", "EdgeLengthRatio"]


class TestCompare(camaron_testing.TestCase):
    def stretched(self):
        """The ball three times as high, as a file of ParaView's."""
        transform = simple.Transform(Input=self.open(BALL))
        transform.Transform.Scale = [1, 1, 3]
        path = self.folder / "stretched.vtu"
        simple.SaveData(str(path), transform)
        return path

    def run_compare(self, *arguments):
        out, err = io.StringIO(), io.StringIO()
        before = os.getcwd()
        os.chdir(self.folder)
        try:
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
                status = cli.main(["compare", *map(str, arguments)])
        except SystemExit as end:  # argparse's
            status = end.code
        finally:
            os.chdir(before)
        return status, out.getvalue(), err.getvalue()

    def test_numbers(self):
        """Those of inspect for each mesh; a stretched mesh has the same cells."""
        stretched = self.stretched()
        summary = compare(BALL, stretched, self.folder / "both", criteria=CRITERIA)
        self.assertTrue(summary["same_cells"])
        for mesh, path in (("a", BALL), ("b", stretched)):
            alone = inspect(path, self.folder / mesh, criteria=CRITERIA, with_pictures=False)
            facts = [{**m, "memory": 0} for m in (summary[mesh], alone["mesh"])]
            self.assertEqual(*facts)
            for row, expected in zip(summary["criteria"], alone["criteria"]):
                for key in (
                    "count",
                    "undefined",
                    "infinite",
                    "min",
                    "max",
                    "mean",
                    "std_dev",
                    "out_of_range",
                ):
                    self.assertEqual(row[mesh][key], expected[key], key)
                self.assertEqual(row[mesh]["median"], expected["quantiles"]["50"])
                self.assertEqual(row["acceptable"], expected["acceptable"])
                self.assertAlmostEqual(sum(row["histogram"][mesh]), 1, delta=1e-12)
        rows = {row["name"]: row for row in summary["criteria"]}
        self.assertEqual((rows["Volume"]["improved"], rows["Volume"]["worsened"]), (0, 0))
        self.assertEqual((rows["Volume"]["compared"], rows["Volume"]["unchanged"]), (800, 0))
        self.assertEqual(rows["MinDihedralAngle"]["compared"], 800)
        self.assertGreater(rows["MinDihedralAngle"]["worsened"], 700)
        angles = []
        for path in (BALL, stretched):
            quality = simple.ElementQuality(Input=self.open(path), Criteria=["MinDihedralAngle"])
            data = self.fetch(quality).GetCellData().GetArray("MinDihedralAngle")
            angles.append(numpy.sort([data.GetValue(i) for i in range(800)]))
        shares = [
            numpy.searchsorted(a, numpy.concatenate(angles), side="right") / 800 for a in angles
        ]
        self.assertAlmostEqual(
            rows["MinDihedralAngle"]["distance"], abs(shares[0] - shares[1]).max(), delta=1e-15
        )
        bad = [
            row["name"]
            for row in summary["criteria"]
            if row["b"]["out_of_range"] > row["a"]["out_of_range"]
        ]
        self.assertEqual(summary["worse"], bad)

    def test_itself(self):
        """A mesh has no distance from itself, and nothing is worse."""
        summary = compare(BALL, BALL, self.folder / "both")
        self.assertGreater(len(summary["criteria"]), 10)
        for row in summary["criteria"]:
            self.assertEqual((row["distance"], row["improved"], row["worsened"]), (0, 0, 0))
            self.assertEqual(row["unchanged"], row["compared"])
            self.assertEqual(row["histogram"]["a"], row["histogram"]["b"])
        self.assertEqual(summary["worse"], [])

    def test_other_format(self):
        """A mesh in another format is the same mesh."""
        for path in [FLANGE, *self.real("ansys_cdb/archive_HexBeam.cdb")]:
            convert(path, self.folder / "other.vtu")
            summary = compare(path, self.folder / "other.vtu", self.folder / "both")
            self.assertTrue(summary["same_cells"])
            self.assertGreater(len(summary["criteria"]), 10)
            for row in summary["criteria"]:
                self.assertEqual(
                    (row["distance"], row["unchanged"]), (0, row["compared"]), row["name"]
                )

    def test_files(self):
        summary = compare(BALL, FLANGE, self.folder / "both", criteria=["all"], bins=20)
        self.assertFalse(summary["same_cells"])
        self.assertEqual(sorted(os.listdir(self.folder / "both")), ["report.html", "summary.json"])
        written = json.loads((self.folder / "both" / "summary.json").read_text("utf-8"))
        self.assertEqual(
            [c["name"] for c in written["criteria"]], [c["name"] for c in summary["criteria"]]
        )
        page = (self.folder / "both" / "report.html").read_text("utf-8")
        self.assertFalse(re.search(r"(src|href)=[\"'](?!#|data:)", page), "nothing from elsewhere")
        ElementTree.fromstring(
            page.replace("<!DOCTYPE html>", "")
            .replace('<meta charset="utf-8">', "")
            .replace('<meta name="viewport" content="width=device-width, initial-scale=1">', "")
        )
        for row in summary["criteria"]:
            self.assertIn(f'id="criterion-{row["name"]}"', page)
        anchors = set(re.findall(r'href="#([^"]+)"', page))
        self.assertTrue(anchors <= set(re.findall(r'id="([^"]+)"', page)))

    def test_command(self):
        stretched = self.stretched()
        ranges = self.folder / "ours.txt"  # of all cells; that of the table is not for polyhedra
        ranges.write_text("EquiangleSkewness * 0.9\n")
        chosen = ("--criteria", "EquiangleSkewness,Volume")
        _, out, _ = self.run_compare(BALL, stretched, *chosen)
        self.assertRegex(out, r"(?m)^  EquiangleSkewness ")
        status, out, err = self.run_compare(BALL, stretched, *chosen, "--ranges", ranges)
        self.assertEqual((status, err), (0, ""))
        self.assertRegex(out, r"(?m)^! EquiangleSkewness ")
        self.assertRegex(out, r"(?m)^  Volume .* 1 +0$")
        self.assertIn("Report: voronoi-ball-stretched-comparison", out)
        self.assertTrue((self.folder / "voronoi-ball-stretched-comparison/report.html").exists())
        worse = self.run_compare(BALL, stretched, "--fail-if-worse", "-o", "x", "--ranges", ranges)
        self.assertEqual(worse[0], 1)
        same = self.run_compare(BALL, BALL, "--fail-if-worse", "-o", "x", "--json")
        self.assertEqual(same[0], 0)
        self.assertEqual(json.loads(same[1])["worse"], [])

    def test_groups(self):
        """Groups have the cells that the facts about the meshes tell, and together their extremes."""
        summary = compare(FLANGE, BALL, self.folder / "both", criteria=CRITERIA, group_by="type")
        types = {
            mesh: {t["name"]: t["count"] for t in summary[mesh]["cell_types"]} for mesh in "ab"
        }
        self.assertGreater(len(types["a"]), 1)
        for row in summary["criteria"]:
            for mesh in "ab":
                counts = {group["group"]: group[mesh]["count"] for group in row["groups"]}
                self.assertEqual({name: n for name, n in counts.items() if n}, types[mesh])
                lows = [
                    group[mesh]["min"] for group in row["groups"] if group[mesh]["min"] is not None
                ]
                self.assertEqual(min(lows), row[mesh]["min"])
        page = (self.folder / "both" / "report.html").read_text("utf-8")
        self.assertEqual(page.count("<summary>Groups</summary>"), len(CRITERIA))
        arguments = ["--criteria", "Volume", "-o", "x", "--group-by"]
        status, out, err = self.run_compare(FLANGE, FLANGE, *arguments, "facecount")
        self.assertEqual((status, "did you mean" in err), (2, False), err)  # no array of the file
        evaluated = self.folder / "evaluated.vtu"
        simple.SaveData(
            str(evaluated), simple.ElementQuality(Input=self.open(FLANGE), Criteria=["FaceCount"])
        )
        status, out, err = self.run_compare(evaluated, evaluated, *arguments, "facecount")
        self.assertEqual((status, err), (0, ""))
        self.assertRegex(out, r"(?m)^    6 +")

    def test_errors(self):
        for arguments, reason in (
            (("none.visf", BALL), "none.visf: there is no such file"),
            ((BALL, "none.visf"), "none.visf: there is no such file"),
            ((BALL, BALL, "--criteria", "Volum"), "did you mean Volume"),
            ((BALL,), "required: B"),
        ):
            status, _, err = self.run_compare(*arguments)
            self.assertEqual(status, 2)
            self.assertIn(reason, err)
        self.assertEqual(os.listdir(self.folder), [])

    def test_help(self):
        status, out, _ = self.run_compare("--help")
        self.assertEqual(status, 0)
        self.assertIn("--fail-if-worse", out)


if __name__ == "__main__":
    camaron_testing.main()
