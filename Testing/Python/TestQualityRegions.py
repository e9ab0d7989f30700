# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Quality Regions against numpy, and the same rows however the mesh is split."""

import builtins  # ParaView's scripts of sources replace min and sum in this module
import math
import unittest

import camaron_testing
import mesh_parts
import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

COLUMNS = "Rank Count WorstValue WorstId IdSpace X Y Z Size Volume Block".split()
BAD = {"Array": "EdgeLengthRatio", "Range": "Custom", "LowerLimit": "0.12"}


def make_whole(rank, ranks, **options):
    """All of the mesh on the first rank."""
    return mesh_parts.make_full_mesh(**options) if rank == 0 else vtkUnstructuredGrid()


def whole_source(**options):
    return mesh_parts.rank_source(__file__, "make_whole", "vtkUnstructuredGrid", options)


def links(cell, kind):
    """What a cell may share with others, as sets of points."""
    if kind == "Vertex":
        return [frozenset([cell.GetPointId(i)]) for i in range(cell.GetNumberOfPoints())]
    count, get = {
        "Face": (cell.GetNumberOfFaces(), cell.GetFace),
        "Edge": (cell.GetNumberOfEdges(), cell.GetEdge),
    }[kind]
    elements = []
    for i in range(count):
        ids = get(i).GetPointIds()
        elements.append(frozenset(ids.GetId(k) for k in range(ids.GetNumberOfIds())))
    return elements


def find_regions(grid, bad, kind):
    """Lists of connected cells, the largest first, then by the smallest id; ids are indices."""
    of_elements, regions = {}, {cell: {cell} for cell in bad}
    for cell in bad:
        for element in links(grid.GetCell(cell), kind):
            other = regions[of_elements.setdefault(element, cell)]
            if other is not regions[cell]:
                other |= regions[cell]
                regions.update(dict.fromkeys(other, other))
    unique = {builtins.min(region): sorted(region) for region in regions.values()}
    return sorted(unique.values(), key=lambda region: (-len(region), region[0]))


def describe(grid, region, values, volumes):
    """The row of a region; the worst value is the smallest one."""
    worst = builtins.min(region, key=lambda cell: (values[cell], cell))
    cells = [
        vtk_to_numpy(grid.GetCell(cell).GetPoints().GetData()).astype(float) for cell in region
    ]
    points = numpy.concatenate(cells)
    center = numpy.mean([cell.mean(axis=0) for cell in cells], axis=0)
    size = numpy.linalg.norm(points.max(axis=0) - points.min(axis=0))
    volume = math.fsum(abs(volumes[cell]) for cell in region)
    return [len(region), values[worst], worst, "Index", *center, size, volume, ""]


class TestQualityRegions(camaron_testing.TestCase):
    def rows(self, source, **properties):
        regions = simple.QualityRegions(Input=source, **properties)
        regions.UpdatePipeline()
        table = servermanager.Fetch(regions)
        if table.GetNumberOfRows() == 0 and camaron_testing.rank_count() > 1:
            return [], 0  # ParaView merges empty tables of ranks to one without columns
        columns = [table.GetColumn(c) for c in range(table.GetNumberOfColumns())]
        self.assertEqual([column.GetName() for column in columns], COLUMNS)
        total = table.GetFieldData().GetAbstractArray("NumberOfRegions").GetValue(0)
        rows = [[column.GetValue(r) for column in columns] for r in range(table.GetNumberOfRows())]
        self.assertEqual([row[0] for row in rows], list(range(1, len(rows) + 1)))
        return rows, total

    def assert_close(self, row, expected):
        self.assertEqual(row[1:5], expected[:4])
        numpy.testing.assert_allclose(row[5:9], expected[4:8], rtol=1e-13)
        self.assertTrue(math.isclose(row[9], expected[8], rel_tol=1e-13))
        self.assertEqual(row[10], expected[9])

    def test_rows(self):
        """Every number of every region, for each adjacency; ranks and ghosts make no difference."""
        grid = mesh_parts.make_full_mesh()
        data = mesh_parts.make_values(grid.GetNumberOfCells())
        values, volumes = data["EdgeLengthRatio"], data["Volume"]
        bad = numpy.flatnonzero(values < 0.12).tolist()
        for kind in ("Face", "Edge", "Vertex"):
            expected = find_regions(grid, bad, kind)
            self.assertGreater(len(expected[0]), 2)
            self.assertGreater(len(expected), 3)
            rows, total = self.rows(
                mesh_parts.split_source(), Adjacency=kind, NumberOfRegions=0, **BAD
            )
            self.assertEqual((len(rows), total), (len(expected), len(expected)))
            for row, region in zip(rows, expected):
                self.assert_close(row, describe(grid, region, values, volumes))
            whole = self.rows(whole_source(), Adjacency=kind, NumberOfRegions=0, **BAD)
            self.assertEqual((rows, total), whole)
            for options in ({"ghost_layer": 40}, {"empty_rank": True}):
                found = self.rows(
                    mesh_parts.split_source(**options), Adjacency=kind, NumberOfRegions=3, **BAD
                )
                self.assertEqual(found, (rows[:3], total), options)
        self.assertEqual(self.rows(whole_source(), **BAD), (rows[:100], total))  # by vertices

    def test_global_ids(self):
        """Ids are the global ones, also if ParaView moves cells to other ranks."""
        expected = self.rows(whole_source(global_ids=True), **BAD)
        self.assertEqual(expected[0][0][4], "Global id")
        source = mesh_parts.split_source(global_ids=True)
        self.assertEqual(self.rows(source, **BAD), expected)
        moved = simple.RedistributeDataSet(Input=source, GenerateGlobalCellIds=0)
        self.assertEqual(self.rows(moved, **BAD), expected)

    def test_same_as_parts(self):
        """The acceptable range judges tetrahedra alone; regions are the parts of Select Elements."""
        source = mesh_parts.split_source()
        chosen = {"Array": "EquiangleSkewness", "Range": "Acceptable"}
        rows, total = self.rows(source, Adjacency="Face", NumberOfRegions=0, **chosen)
        bad = simple.SelectElements(Input=source, **chosen)
        for number in (1, total):
            part = simple.SelectElements(Input=bad, Strategy="Component", ComponentNumber=number)
            part.UpdatePipeline()
            part.UpdatePropertyInformation()
            count = part.GetPropertyValue("NumberOfSelectedElements")
            self.assertEqual(rows[number - 1][1], count)
        bad.UpdatePropertyInformation()
        count = bad.GetPropertyValue("NumberOfSelectedElements")
        self.assertGreater(count, 5)
        self.assertEqual(builtins.sum(row[1] for row in rows), count)

    def test_undefined(self):
        """Undefined values are bad on request, and never worse than others."""
        grid = mesh_parts.make_full_mesh()
        values = mesh_parts.make_values(grid.GetNumberOfCells())["EdgeLengthRatio"]
        bad = numpy.flatnonzero((values < 0.12) | numpy.isnan(values)).tolist()
        expected = find_regions(grid, bad, "Face")
        rows, total = self.rows(
            mesh_parts.split_source(), IncludeUndefined=1, Adjacency="Face", **BAD
        )
        self.assertEqual(total, len(expected))
        nulls = 0
        for row, region in zip(rows, expected):
            known = [cell for cell in region if not math.isnan(values[cell])]
            worst = builtins.min(
                known or region, key=lambda cell: (values[cell], cell) if known else cell
            )
            self.assertEqual(row[1], len(region))
            self.assertEqual((str(row[2]), row[3]), (str(values[worst]), worst))
            nulls += not known
        self.assertGreater(nulls, 0)

    def test_without_bad_end(self):
        """Without a criterion, the value farthest from the range is the worst."""
        count = mesh_parts.make_mesh().GetNumberOfCells()
        self.assertGreater(count, 500)
        limits = {"Array": "Number", "Range": "Custom", "UpperLimit": str(count - 3)}
        rows, total = self.rows(mesh_parts.split_source(), LowerLimit="3", **limits)
        self.assertEqual(total, 2)
        self.assertEqual(sorted(row[1:4] for row in rows), [[2, count - 1, count - 1], [3, 0, 0]])

    def test_blocks(self):
        """Cells of different blocks are not connected, and rows name their block."""
        blocks = simple.GroupDatasets(
            Input=[mesh_parts.split_source(), mesh_parts.split_source(ghost_layer=20)],
            OutputType="vtkPartitionedDataSetCollection",
            BlockNames=["rotor", "stator"],
        )
        alone, total = self.rows(whole_source(), NumberOfRegions=0, **BAD)
        rows, twice = self.rows(blocks, NumberOfRegions=0, **BAD)
        self.assertEqual(twice, 2 * total)
        for name in ("rotor", "stator"):
            found = [row for row in rows if row[-1] == name]
            self.assertEqual(
                [row[1:3] + row[5:10] for row in found], [row[1:3] + row[5:10] for row in alone]
            )

    def test_nothing_bad(self):
        rows, total = self.rows(mesh_parts.split_source(), Array="Constant", Range="Custom")
        self.assertEqual((rows, total), ([], 0))

    @unittest.skipIf(camaron_testing.rank_count() > 1, "messages of one rank")
    def test_errors(self):
        source = mesh_parts.producer(mesh_parts.make_full_mesh())
        for properties, reason in (
            ({"Adjacency": "Side"}, "Adjacency must be Face, Edge or Vertex, not 'Side'"),
            ({"LowerLimit": "low"}, "Lower Limit: expected a number, found 'low'"),
            ({"Array": "Missing"}, "no one-component cell array named 'Missing'"),
            ({"Array": "Material", "Range": "Acceptable"}, "no acceptable range is known"),
            ({"NumberOfRegions": -1}, "Number Of Regions must be 0 or more, not -1"),
        ):
            regions = simple.QualityRegions(Input=source, **{**BAD, **properties})
            with camaron_testing.pipeline.Messages() as messages:
                regions.UpdatePipeline()
            self.assertIn(reason, messages.errors[0])
            self.assertEqual(servermanager.Fetch(regions).GetNumberOfRows(), 0)


if __name__ == "__main__":
    camaron_testing.main()
