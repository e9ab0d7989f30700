# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of Quality Statistics, written to CSV, are the same byte for byte on any number of ranks.

No all and sum here: programmable sources replace them in the main module.
"""

import csv
import os
import shutil
import sys
import tempfile
from pathlib import Path

import camaron_testing
import mesh_parts
import numpy
from camaron.common import pipeline, tables
from paraview import servermanager, simple
from paraview.servermanager import OutputPort
from vtkmodules.util.numpy_support import vtk_to_numpy

ARRAYS = list(mesh_parts.make_values(1))
CRITERIA = [
    "Volume",
    "Area",
    "EquiangleSkewness",
    "EdgeLengthRatio",
    "MaxNeighborNormalAngle",
    "MaxNonOrthogonality",
    "MaxFaceSkewness",
    "MinVolumeRatio",
    "OrthogonalQuality",
    "CellDeterminant",
]
EXAMPLES = ("flange.visf", "voronoi-ball.visf")
UNDEFINED_BY_MATERIAL = {
    "GroupBy": "Cell array",
    "GroupArray": "Material",
    "WorstValues": "Undefined",
}
#: Histograms of the cells whose material is not 0, in the bins of all cells.
SELECTED = {
    "Moments": 0,
    "OnlySelected": 1,
    "SelectionArray": "Material",
    "HistogramRange": "All elements",
}
PORTS = ("statistics", "histogram", "worst", "curve")
RANK = servermanager.vtkProcessModule.GetProcessModule().GetPartitionId()


def save_tables(source, folder, **properties):
    """Writes the tables as a user would; returns their columns as text.

    ParaView's writer sorts the columns by name when there are several ranks.
    """
    properties = {
        "Arrays": ARRAYS,
        "NumberOfWorst": 30,
        "WeightArray": "Volume",
        "CurvePoints": 20,
        **properties,
    }
    statistics = simple.QualityStatistics(Input=source, **properties)
    statistics.UpdatePipeline()
    for port, name in enumerate(PORTS):
        simple.SaveData(
            str(folder / f"{name}.csv"), proxy=OutputPort(statistics, port), Precision=17
        )
    return read_tables(folder)


def read_tables(folder):
    tables = {}
    for name in PORTS:
        with open(folder / f"{name}.csv", newline="") as file:
            tables[name] = list(csv.DictReader(file))
    return tables


def save_reference(folder):
    """The same by a single process on the whole mesh, with and without global ids."""
    for global_ids in (False, True):
        target = folder / str(global_ids)
        target.mkdir()
        whole = mesh_parts.split_source(global_ids=global_ids)
        save_tables(whole, target, GroupBy="Cell type", WorstValues="Largest")
        target = folder / f"null-{global_ids}"
        target.mkdir()
        save_tables(whole, target, **UNDEFINED_BY_MATERIAL)
        target = folder / f"selected-{global_ids}"
        target.mkdir()
        save_tables(whole, target, **SELECTED)
    target = folder / "blocks"
    target.mkdir()
    save_tables(make_blocks(), target, GroupBy="Block")
    for name in EXAMPLES:
        target = folder / name
        target.mkdir()
        save_tables(evaluate_example(name), target, Arrays=[], GroupBy="Cell type")


def make_blocks():
    """Two blocks, each spread over the ranks, the second one with ghosts."""
    return simple.GroupDatasets(
        Input=[mesh_parts.split_source(), mesh_parts.split_source(ghost_layer=20)],
        OutputType="vtkPartitionedDataSetCollection",
        BlockNames=["rotor", "stator"],
    )


def evaluate_example(name):
    """Criteria of an example, one of them with neighbors, for which readers provide ghost cells."""
    source = simple.OpenDataFile(str(camaron_testing.EXAMPLES / name))
    return simple.ElementQuality(Input=source, Criteria=CRITERIA)


def points_of_cells(grid):
    return numpy.unique(vtk_to_numpy(grid.GetCells().GetConnectivityArray()))


class TestRanks(camaron_testing.TestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.references = Path(tempfile.mkdtemp(prefix="camaron-test-"))
        cls.addClassCleanup(shutil.rmtree, cls.references, ignore_errors=True)
        camaron_testing.run_alone(__file__, cls.references, timeout=200)

    def reference(self, name):
        return read_tables(self.references / str(name))

    def compare(self, tables, expected, message=""):
        """Points have no global ids in these meshes, so in several pieces they have no names."""
        for mine, other in zip(tables["worst"], expected["worst"]):
            vertices = mine.pop("Vertices")
            self.assertIn(vertices, ("", other.pop("Vertices")))
            if camaron_testing.rank_count() == 1:
                self.assertTrue(vertices)
        for name in PORTS:
            self.assertEqual(tables[name], expected[name], f"{name} {message}")

    def check(self, global_ids, **options):
        source = mesh_parts.split_source(global_ids=global_ids, **options)
        tables = save_tables(source, self.folder, GroupBy="Cell type", WorstValues="Largest")
        expected = self.reference(global_ids)
        for name in PORTS:
            self.assertGreaterEqual(len(expected[name]), len(ARRAYS))
        self.compare(tables, expected, options)

    def check_with_ghosts(self, name, longest, properties):
        """With an empty rank, and many rows in a table."""
        for global_ids in (False, True):
            source = mesh_parts.split_source(global_ids=global_ids, ghost_layer=40, empty_rank=True)
            tables = save_tables(source, self.folder, **properties)
            expected = self.reference(f"{name}-{global_ids}")
            self.assertGreater(len(expected[longest]), 100)
            self.compare(tables, expected)

    def test_undefined_by_material(self):
        """Groups are the same wherever the cells are; so are the cells without a value."""
        self.check_with_ghosts("null", "worst", UNDEFINED_BY_MATERIAL)

    def test_selected(self):
        """Without moments, and with the bins of all cells."""
        self.check_with_ghosts("selected", "histogram", SELECTED)

    def test_pieces(self):
        """Consecutive ranges of cells: ids are their places in the whole mesh."""
        self.check(False)

    def test_global_ids(self):
        """Ids are the global ones, which decide ties."""
        self.check(True)

    def test_ghosts(self):
        """Ghost cells neither count nor take an index."""
        self.check(False, ghost_layer=40)
        self.check(True, ghost_layer=40)

    def test_empty_rank(self):
        """A rank without cells and arrays takes part in every collective call."""
        self.check(False, empty_rank=True)

    def test_redistributed(self):
        """ParaView's own redistribution, which shuffles cells between ranks."""
        source = mesh_parts.split_source(global_ids=True)
        moved = simple.RedistributeDataSet(Input=source, GenerateGlobalCellIds=0)
        tables = save_tables(moved, self.folder, GroupBy="Cell type", WorstValues="Largest")
        self.compare(tables, self.reference(True))

    def test_blocks(self):
        """Indices count one block after the other, whichever ranks have them."""
        tables = save_tables(make_blocks(), self.folder, GroupBy="Block")
        self.assertEqual({row["Group"] for row in tables["statistics"]}, {"All", "rotor", "stator"})
        self.compare(tables, self.reference("blocks"))

    def test_points(self):
        """A point at the border of pieces counts once, with and without ghost cells around them."""
        whole = mesh_parts.make_mesh()
        x, y, z = vtk_to_numpy(whole.GetPoints().GetData()).T
        field_of_all = 0.1 * x + 17 * y + 0.3 * z * x
        for options in ({}, {"ghost_layer": 40}, {"empty_rank": True}, {"global_ids": True}):
            field = simple.Calculator(
                Input=mesh_parts.split_source(**options),
                ResultArrayName="Field",
                Function="0.1*coordsX + 17*coordsY + 0.3*coordsZ*coordsX",
            )
            statistics = simple.QualityStatistics(
                Input=field, ElementType="Points", Arrays=["Field"], CurvePoints=11
            )
            (row,) = tables.fetch(statistics)
            # Parts of the mesh come without the point that no cell has.
            is_whole = camaron_testing.rank_count() - options.get("empty_rank", False) <= 1
            values = field_of_all if is_whole else field_of_all[points_of_cells(whole)]
            with self.subTest(**options):
                self.assertEqual(row["Count"], len(values))
                self.assertEqual((row["Min"], row["Max"]), (values.min(), values.max()))
                self.assertAlmostEqual(row["Mean"], values.mean(), delta=1e-12)
                self.assertAlmostEqual(row["StdDev"], values.std(ddof=1), delta=1e-12)
                for percent in (1, 25, 50, 99):
                    expected = numpy.percentile(values, percent)
                    self.assertAlmostEqual(row[f"P{percent}"], expected, delta=1e-12)
                curve = tables.fetch(statistics, 3)
                self.assertEqual(
                    [p["Count"] for p in curve], [(values <= p["Value"]).sum() for p in curve]
                )

    def test_all_time_steps(self):
        """Every rank goes through all steps, also one that has no part of the mesh."""
        steps = simple.TimeSource(Growing=1)
        moved = simple.RedistributeDataSet(Input=steps, GenerateGlobalCellIds=0)
        properties = {"Arrays": ["Cell Value"], "AllTimeSteps": 1}
        expected = tables.fetch(simple.QualityStatistics(Input=steps, **properties))
        found = tables.fetch(simple.QualityStatistics(Input=moved, **properties))
        self.assertGreater(len(expected), 3)
        keys = ("Time", "Count", "Min", "Max", "Sum", "StdDev", "Skewness", "P50")
        self.assertEqual(
            [[str(row[key]) for key in keys] for row in found],
            [[str(row[key]) for key in keys] for row in expected],
        )

    def test_examples(self):
        """From the file to the tables: pieces and ghosts as the reader makes them."""
        for name in EXAMPLES:
            tables = save_tables(
                evaluate_example(name), self.folder, Arrays=[], GroupBy="Cell type"
            )
            expected = self.reference(name)
            self.assertNotIn("", [row["Vertices"] for row in tables["worst"]])
            for table in PORTS:
                for row in tables[table] + expected[table]:
                    row.pop(
                        "IdSpace", None
                    )  # only pieces have global ids, which then are the indices
                self.assertEqual(tables[table], expected[table], f"{table} of {name}")

    def test_groups_of_texts(self):
        """As those of the numbers with these names, though not every rank has each of them."""
        source, rows = mesh_parts.named_source(), {}
        for array in ("Material", "Name"):
            statistics = simple.QualityStatistics(
                Input=source, Arrays=["Volume"], GroupBy="Cell array", GroupArray=array
            )
            rows[array] = tables.fetch(statistics)
        if RANK == 0:
            groups = {row["Group"]: (row["Count"], row["Max"]) for row in rows["Name"]}
            self.assertEqual(list(groups), ["All", *"abcdefg"])
            by_number = [(row["Count"], row["Max"]) for row in rows["Material"]]
            self.assertEqual(list(groups.values()), by_number)

    def test_ranges_file(self):
        """Only rank 0 has the file; all ranks count by it, and all stop where it is wrong."""
        if RANK == 0:
            (self.folder / "mine.txt").write_text("Volume * 0.001\n")
            (self.folder / "wrong.txt").write_text("Volume low high\n")
        quality = evaluate_example("voronoi-ball.visf")
        counts = []
        for name in ("", "mine.txt"):
            path = str(self.folder / name) if name else ""
            statistics = simple.QualityStatistics(Input=quality, Arrays=["Volume"], RangesFile=path)
            row = {r["Criterion"]: r for r in tables.fetch(statistics)}["Volume"]
            counts.append((row["AcceptableHigh"], row["AboveCount"]))
        self.assertEqual(counts[0][1], 0)
        self.assertEqual(counts[1][0], 0.001)
        self.assertGreater(counts[1][1], 0)
        with pipeline.Messages() as messages:
            statistics = simple.QualityStatistics(
                Input=quality, Arrays=["Volume"], RangesFile=str(self.folder / "wrong.txt")
            )
            statistics.UpdatePipeline()
        self.assertRegex(" ".join(messages.errors), "wrong.txt:1: expected the lower limit")

    def test_complete_on_rank_0(self):
        """Other ranks have the columns but no rows: appended by Fetch there is each row once."""
        source = mesh_parts.split_source()
        statistics = simple.QualityStatistics(Input=source, Arrays=ARRAYS)
        statistics.UpdatePipeline()
        self.assertEqual(self.fetch(statistics, 0).GetNumberOfRows(), len(ARRAYS))
        self.assertEqual(
            statistics.GetDataInformation(0).DataInformation.GetNumberOfRows(), len(ARRAYS)
        )


if __name__ == "__main__":
    if len(sys.argv) > 1:
        save_reference(Path(sys.argv[1]))
        os._exit(0)
    camaron_testing.main()
