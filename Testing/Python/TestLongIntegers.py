# ranks: 1 2
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Integers of 64 bits that no double is are told apart in statistics, groups and selections, and shown as they are."""

import unittest

import camaron
import camaron_testing
import gallery
import mesh_parts
import numpy
from camaron import export
from camaron.common import pipeline, tables
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

IDS = vtkIdTypeArray  # beside the types of numpy
LIMITS = {
    numpy.int64: (2**53, -(2**53) - 9, 2**63 - 9, -(2**63)),
    numpy.uint64: (2**63 - 4, 2**64 - 9),
    IDS: (2**53,),
}
STEPS = [0, 1, 2, 3, 3, 5]

PVTU = """<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid>
<PPoints><PDataArray type="Float64" NumberOfComponents="3"/></PPoints>
<PCellData {attributes}>{arrays}</PCellData>
<Piece Source="part0.vtu"/><Piece Source="part1.vtu"/>
</PUnstructuredGrid></VTKFile>"""


def make_array(name, values, kind):
    if kind is not IDS:
        array = numpy_to_vtk(numpy.array(values, kind), deep=1)
    else:
        array = vtkIdTypeArray()
        array.SetNumberOfValues(len(values))
        vtk_to_numpy(array)[:] = values
    array.SetName(name)
    return array


def all_limits():
    return [(kind, start) for kind, starts in LIMITS.items() for start in starts]


def some_limits():
    """The largest and the smallest of every type, for what takes long."""
    return [
        *dict.fromkeys(
            (kind, limit(starts)) for kind, starts in LIMITS.items() for limit in (min, max)
        )
    ]


class TestLongIntegers(camaron_testing.FormatTestCase):
    def make_mesh(self, values, kind, name="snow", global_ids=False):
        """A source of cubes with such an array, in two pieces."""
        points, cubes = gallery.lattice(len(values), 1, 1)
        grid = gallery.make_grid(points, [(VTK_HEXAHEDRON, cube) for cube in cubes])
        data = grid.GetCellData()
        (data.SetGlobalIds if global_ids else data.AddArray)(make_array(name, values, kind))
        folder = self.folder / str(len(list(self.folder.iterdir())))
        folder.mkdir()
        for part in range(2):
            writer = vtkXMLUnstructuredGridWriter()
            writer.SetFileName(str(folder / f"part{part}.vtu"))
            writer.SetInputData(mesh_parts.extract(grid, part * 4, (4, len(values))[part]))
            writer.Write()
        number = "UInt64" if kind is numpy.uint64 else "Int64"
        arrays = (
            f'<PDataArray type="{number}" Name="{name}" {"IdType='1'" if kind is IDS else ""}/>'
        )
        attributes = f'GlobalIds="{name}"' if global_ids else ""
        self.path = folder / "mesh.pvtu"
        self.path.write_text(PVTU.format(arrays=arrays, attributes=attributes))
        return simple.XMLPartitionedUnstructuredGridReader(FileName=[str(self.path)])

    def rows(self, source, port=0):
        with pipeline.Messages() as messages:
            rows = tables.fetch(source, port)
        self.assertEqual(messages.errors, [])
        self.warnings = messages.warnings
        return rows

    def of_cells(self, source, name, port=0):
        """Values of a cell array, of all ranks."""
        values = []
        for piece in camaron_testing.pieces(source, port):
            if piece.GetNumberOfCells():  # else it has no array either
                array = vtk_to_numpy(piece.GetCellData().GetArray(name))
                values += array[camaron_testing.own_cells(piece)].tolist()
        return values

    def selected(self, source, **properties):
        return numpy.flatnonzero(
            self.of_cells(simple.SelectElements(Input=source, **properties), "Selected")
        ).tolist()

    def between(self, source, low, high):
        return self.selected(
            source,
            Array="snow",
            Strategy="By criterion",
            Range="Custom",
            LowerLimit=str(low),
            UpperLimit=str(high),
            Side="Inside",
        )

    def test_extremes(self):
        for kind, start in all_limits():
            for order in (STEPS, [3, 5, 0, 3, 1, 2]):
                values = [start + step for step in order]
                statistics = simple.QualityStatistics(
                    Input=self.make_mesh(values, kind), Arrays=["snow"]
                )
                (row,) = self.rows(statistics)
                self.assertEqual(
                    (row["ArgMin"], row["ArgMax"]), (order.index(0), order.index(5)), values
                )
                self.assertEqual(
                    (row["MinInteger"], row["MaxInteger"]), (str(start), str(start + 5))
                )
                self.assertEqual(
                    (row["Sum"], row["Mean"]), (float(sum(values)), sum(values) / 6), values
                )
                self.assertEqual(len(self.warnings), 1)
                self.assertIn("beyond 2^53 in snow", self.warnings[0])

    def test_other_numbers(self):
        """Integers that are doubles have all digits, too, and no warning; measures have no integer."""
        source = self.make_mesh([123456789, 2**53, 5, 6, 7, -8], numpy.int64)
        quality = simple.ElementQuality(Input=source, Criteria=["Volume", "FaceCount"])
        statistics = simple.QualityStatistics(Input=quality, Arrays=["snow", "Volume", "FaceCount"])
        found = [(row["MinInteger"], row["MaxInteger"]) for row in self.rows(statistics)]
        self.assertEqual(found, [("-8", str(2**53)), ("", ""), ("6", "6")])
        self.assertEqual(self.warnings, [])

    def test_worst(self):
        for kind, start in all_limits():
            source = self.make_mesh([start + step for step in STEPS], kind)
            worst = {"Array": "snow", "Strategy": "Worst N"}
            for count, expected in ((1, [5]), (2, [3, 5]), (3, [3, 4, 5]), (5, [1, 2, 3, 4, 5])):
                found = self.selected(source, NumberOfWorst=count, WorstValues="Largest", **worst)
                self.assertEqual(found, expected, start)
            self.assertEqual(
                self.selected(source, NumberOfWorst=2, WorstValues="Smallest", **worst), [0, 1]
            )
            for end, steps in (("Largest", [5, 3, 3]), ("Smallest", [0, 1, 2])):
                statistics = simple.QualityStatistics(
                    Input=source, Arrays=["snow"], WorstValues=end, NumberOfWorst=3
                )
                found = [row["ValueInteger"] for row in self.rows(statistics, 2)]
                self.assertEqual(found, [str(start + step) for step in steps])

    def test_selection(self):
        for kind, start in all_limits():
            source = self.make_mesh([start + step for step in STEPS], kind)
            self.assertEqual(self.between(source, start + 1, start + 1), [1], start)
            self.assertEqual(self.between(source, start + 3, start + 4), [3, 4], start)
            self.assertEqual(self.between(source, start + 4, start + 4), [], start)
            self.assertEqual(self.between(source, start + 2, ""), [2, 3, 4, 5], start)
            self.assertEqual(self.between(source, "", start + 1), [0, 1], start)

    def test_groups(self):
        """A group for each number, with its digits as the label, in the order of the numbers."""
        for kind, start in some_limits():
            source = self.make_mesh([start + step for step in (5, 3, 3, 0, 1, 2)], kind)
            quality = simple.ElementQuality(Input=source, Criteria=["Volume"])
            by = {
                "Input": quality,
                "GroupBy": "Cell array",
                "GroupArray": "snow",
                "Arrays": ["Volume"],
            }
            expected = [("All", 6)] + [
                (str(start + step), 1 + (step == 3)) for step in (0, 1, 2, 3, 5)
            ]
            for table in (
                simple.QualityStatistics(**by),
                simple.CompareQuality(**by, Other=quality),
                simple.CorrelateQuality(**by, Field=["CELLS", "snow"]),
            ):
                rows = self.rows(table)
                found = [
                    (row["Group"], row["CountA"] if "CountA" in row else row["Count"])
                    for row in rows
                ]
                self.assertEqual(found, expected)

    def test_groups_of_two_meshes(self):
        """Each cell is in its group there, also where a mesh lacks a group of the other."""
        start = 2**53
        meshes = [
            self.make_mesh([start + i for i in steps], numpy.int64)
            for steps in (STEPS, [1, 1, 7, 7, 7, 0])
        ]
        qualities = [simple.ElementQuality(Input=mesh, Criteria=["Volume"]) for mesh in meshes]
        compared = simple.CompareQuality(
            Input=qualities[0],
            Other=qualities[1],
            Arrays=["Volume"],
            GroupBy="Cell array",
            GroupArray="snow",
        )
        found = {row["Group"]: (row["CountA"], row["CountB"]) for row in self.rows(compared)}
        counts = {0: (1, 1), 1: (1, 2), 2: (1, 0), 3: (2, 0), 5: (1, 0), 7: (0, 3)}
        self.assertEqual(
            found, {"All": (6, 6), **{str(start + i): both for i, both in counts.items()}}
        )

    def test_ids(self):
        for kind, start in all_limits():
            source = self.make_mesh([start + i for i in (0, 1, 2, 3, 4, 5)], kind, "number", True)
            by = {"Strategy": "By id", "IdSpace": "Global id"}
            self.assertEqual(self.selected(source, Ids=str(start + 1), **by), [1], start)
            self.assertEqual(
                self.selected(source, Ids=f"{start + 3}, {start}", **by), [0, 3], start
            )
            self.assertEqual(
                self.selected(source, Ids=f"{start + 1}-{start + 4}", **by), [1, 2, 3, 4], start
            )
            self.assertEqual(
                self.selected(source, Ids=f"{start - 9}", **by) if start > 9 else [], [], start
            )
            chosen = simple.SelectElements(Input=source, Ids=f"{start + 2}", **by)
            (row,) = export._rows(simple.SelectionTable(Input=chosen))
            # What is beyond vtkIdType names no cell; its index does.
            fits = start + 5 < 2**63
            self.assertEqual((row["Id"], row["number"]), (start + 2 if fits else 2, start + 2))

    def test_bins(self):
        """No two edges are the same double, and all cells are counted."""
        for kind, start in all_limits():
            source = self.make_mesh([start + step for step in STEPS], kind)
            bins = self.rows(simple.QualityStatistics(Input=source, Arrays=["snow"]), 1)
            for row in bins:
                self.assertTrue(row["LowerEdge"] < row["UpperEdge"] or len(bins) == 1)
            self.assertEqual(sum(row["Count"] for row in bins), 6)

    def test_differences(self):
        for kind, start in all_limits():
            meshes = [
                self.make_mesh([start + step for step in steps], kind)
                for steps in (STEPS, [3, 1, 3, 3, 2, 0])
            ]
            compared = simple.CompareQuality(
                Input=meshes[0], Other=meshes[1], Arrays=["snow"], Tolerance=0
            )
            (row,) = self.rows(compared)
            self.assertEqual((row["ComparedCount"], row["UnchangedCount"]), (6, 2))
            self.assertEqual(len(self.warnings), 1)
            self.assertEqual(self.of_cells(compared, "snow_Delta", 2), [3, 0, 1, 0, -1, -5])

    def test_correlation(self):
        """What integers have beyond doubles is added to nothing else."""
        values = [2**62 + 511 * step * (-1) ** step for step in range(6)]
        source = self.make_mesh(values, numpy.int64)
        quality = simple.ElementQuality(Input=source, Criteria=["Volume"])
        correlation = simple.CorrelateQuality(
            Input=quality, Field=["CELLS", "snow"], Arrays=["snow", "Volume"]
        )
        itself, other = self.rows(correlation)
        self.assertAlmostEqual(itself["Pearson"], 1, 12)
        self.assertAlmostEqual(itself["Spearman"], 1, 12)
        volumes = self.of_cells(quality, "Volume")
        expected = numpy.corrcoef(numpy.array(values, float) - 2.0**62, volumes)[0, 1]
        self.assertAlmostEqual(other["Pearson"], expected, 9)
        self.assertEqual(len(self.warnings), 1)

    def test_weights(self):
        """An array is weighed by another one, not by what it has beyond doubles."""
        source = self.make_mesh([2**53 + step for step in STEPS], numpy.int64)
        quality = simple.ElementQuality(Input=source, Criteria=["Volume"])
        statistics = simple.QualityStatistics(
            Input=quality, Arrays=["snow", "Volume"], WeightArray="Volume"
        )
        snow, volume = self.rows(statistics)
        self.assertEqual(snow["Weight"], volume["Sum"])

    def test_reported_file(self):
        source = self.open(self.data("reports/integers_beyond_2_53.vtu"))
        (row,) = self.rows(simple.QualityStatistics(Input=source, Arrays=["snow"]))
        self.assertEqual(row["ArgMax"], 5)
        self.assertEqual(len(self.between(source, 2**53 + 1, 2**53 + 1)), 1)

    @unittest.skipIf(camaron_testing.rank_count() > 1, "one process writes these formats")
    def test_formats(self):
        """What is written is read again, or said to be rounded; nothing is cut to 32 bits."""
        exact, real, single = {"vtu", "vtk", "vtkhdf"}, {"exo", "ex2", "xmf", "ply"}, {"case"}
        for kind, start in some_limits():
            values = [start + step for step in STEPS]
            self.make_mesh(values, kind)
            for suffix in exact | real | single:
                new = self.path.parent / f"new.{suffix}"
                notes = camaron.convert(self.path, new)
                rounded = [note for note in notes if "rounded" in note and "snow" in note]
                self.assertEqual(len(rounded), suffix not in exact, suffix)
                source = pipeline.open_mesh(new).source
                found = []
                for leaf in camaron_testing.leaves(
                    source.GetClientSideObject().GetOutputDataObject(0)
                ):
                    data = leaf.GetCellData()
                    array = data.GetArray("snow") or data.GetArray("snow_c")
                    found += [array.GetValue(i) for i in range(array.GetNumberOfValues())]
                if suffix == "ply":  # of the faces
                    self.assertEqual(set(found), set(map(float, values)))
                elif suffix in exact:
                    self.assertEqual(found, values, suffix)
                else:
                    real_type = numpy.float32 if suffix in single else float
                    self.assertEqual(found, [float(real_type(value)) for value in values], suffix)

    def test_commands(self):
        for kind, start in some_limits():
            self.make_mesh([start + step for step in STEPS], kind)
            path, folder = self.path, self.path.parent
            labels = [str(start + step) for step in (0, 1, 2, 3, 5)]
            summary = camaron.inspect(
                path,
                folder / "report",
                criteria=["Volume"],
                group_by="snow",
                with_pictures=False,
                with_mesh=False,
            )
            self.assertEqual([group["group"] for group in summary["criteria"][0]["groups"]], labels)
            rules = [f"Volume > 0 where snow = {start + step}" for step in (0, 1, 3, 4)]
            checks = camaron.check(path, rules)["checks"]
            self.assertEqual([check["cells"] for check in checks], [1, 1, 2, 0])
            self.assertEqual([check["rule"] for check in checks], rules)
            compared = camaron.compare(
                path, path, folder / "comparison", criteria=["Volume"], group_by="snow"
            )
            self.assertEqual(
                [group["group"] for group in compared["criteria"][0]["groups"]], labels
            )
            step = f"By criterion: Array=snow; LowerLimit={start + 1}; UpperLimit={start + 1}; Side=Inside"
            self.assertEqual(camaron.select(path, [step], [folder / "one.csv"])["selected"], 1)
            self.assertTrue(
                (folder / "one.csv").read_text().splitlines()[1].endswith(f",{start + 1}")
            )


camaron_testing.main()
