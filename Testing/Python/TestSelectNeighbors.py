# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers of neighbors and connected components, compared with sets in Python, for any number of pieces.

No min and max here: programmable sources replace them in the main module.
"""

import functools
import unittest

import camaron_testing
import numpy
import rank_meshes
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

SPLITS = (
    {},
    {"scattered": True, "global_ids": True},
    {"scattered": True, "ghosts": True},
    {"ghosts": True, "empty_rank": True},
)
APPENDED = {"scattered": True, "global_ids": True, "appended": 3}
if camaron_testing.rank_count() == 1:
    MESHES = ("voronoi", "tetrahedra", "overlapping", "surfaces", "mixed")
    SPLITS = (SPLITS[0], APPENDED, {**APPENDED, "ghosts": True})
else:
    MESHES, SPLITS = ("voronoi", "surfaces", "mixed"), SPLITS[1:]
KINDS = ("Face", "Edge", "Vertex")


@functools.lru_cache
def whole(mesh):
    points, cells = rank_meshes.MESHES[mesh]()
    return rank_meshes.take(points, cells, list(range(len(cells))))


@functools.lru_cache
def elements_of(mesh):
    """Of every cell its facets, edges and vertices, each a set of coordinates."""
    grid, found = whole(mesh), []
    for i in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(i)
        solid = cell.GetCellDimension() == 3

        def sets(count, get):
            return {
                frozenset(map(grid.GetPoint, rank_meshes.list_ids(get(j)))) for j in range(count)
            }

        edges = sets(cell.GetNumberOfEdges(), cell.GetEdge)
        facets = sets(cell.GetNumberOfFaces(), cell.GetFace) if solid else edges
        vertices = {frozenset([grid.GetPoint(p)]) for p in rank_meshes.list_ids(cell)}
        found.append({"Face": facets, "Edge": edges, "Vertex": vertices})
    return found


def layers(mesh, kind, seeds, count, allowed=None):
    """The seeds with layers of neighbors; count None for all of them."""
    elements = elements_of(mesh)
    found = set(seeds)
    while count is None or count > 0:
        reached = set().union(*(elements[i][kind] for i in found)) if found else set()
        new = {
            i
            for i in range(len(elements))
            if i not in found and (allowed is None or i in allowed) and elements[i][kind] & reached
        }
        if not new:
            break
        found |= new
        count = None if count is None else count - 1
    return found


def components(mesh, kind, cells):
    """The components of some cells, the largest first, then by their first cell."""
    rest, found = set(cells), []
    while rest:
        part = layers(mesh, kind, {sorted(rest)[0]}, None, rest)
        found.append(part)
        rest -= part
    return sorted(found, key=lambda part: (-len(part), sorted(part)[0]))


class TestSelectNeighbors(camaron_testing.TestCase):
    def numbers(self, select):
        """Which cells of the whole mesh are selected."""
        with camaron_testing.pipeline.Messages() as messages:
            select.UpdatePipeline()
        self.assertEqual(messages.errors, [])
        select.UpdatePropertyInformation()
        found = []
        for piece in camaron_testing.pieces(select):
            data = piece.GetCellData()
            if data.GetArray("Number"):  # a rank without cells has none
                marks = vtk_to_numpy(data.GetArray("Selected")) == 1
                marks &= camaron_testing.own_cells(piece)
                found += vtk_to_numpy(data.GetArray("Number"))[marks].tolist()
        self.assertEqual(len(found), len(set(found)), "a cell that is selected twice")
        self.assertEqual(select.GetPropertyValue("NumberOfSelectedElements"), len(found))
        return set(found)

    def seed(self, source, first, last):
        return simple.SelectElements(
            Input=source,
            Array="Number",
            Range="Custom",
            Side="Inside",
            LowerLimit=str(first),
            UpperLimit=str(last),
        )

    def splits(self):
        for mesh in MESHES:
            count = whole(mesh).GetNumberOfCells()
            for options in SPLITS:
                yield mesh, count, rank_meshes.split_source(mesh, **options), f"{mesh} {options}"
                camaron_testing.delete_sources()

    def test_expand_and_shrink(self):
        for mesh, count, source, message in self.splits():
            middle = count // 2
            some = self.seed(source, middle, middle + 3)
            many = self.seed(source, middle // 2, count)
            others = set(range(middle // 2))
            grown = simple.SelectElements(Input=some, Strategy="Expand")
            less = simple.SelectElements(Input=many, Strategy="Shrink")
            for kind in KINDS:
                grown.Adjacency = less.Adjacency = kind
                for number in (1, 3):
                    grown.NumberOfLayers = number
                    expected = layers(
                        mesh, kind, range(middle, sorted((middle + 4, count))[0]), number
                    )
                    self.assertEqual(self.numbers(grown), expected, f"{message} {kind} {number}")
                expected = set(range(count)) - layers(mesh, kind, others, 1)
                self.assertEqual(self.numbers(less), expected, f"{message} {kind}")

    def test_more_layers_than_cells(self):
        """Growth ends when a layer adds nothing: 2^31 layers take no time."""
        endless = {"Strategy": "Expand", "NumberOfLayers": 2**31 - 1}
        source = rank_meshes.split_source("tetrahedra")
        some = self.seed(source, 0, 0)
        connected = simple.SelectElements(Input=some, Strategy="Connected")
        found = self.numbers(simple.SelectElements(Input=some, **endless))
        self.assertEqual(found, self.numbers(connected))
        self.assertEqual(len(found), whole("tetrahedra").GetNumberOfCells())
        listed = simple.SelectElements(Input=source, Strategy="Connected to ids", Ids="0")
        self.assertEqual(self.numbers(listed), found)
        within = {"OnlyInRange": 1, "Array": "Number", "Side": "Inside", "Range": "Custom"}
        within["UpperLimit"] = str(len(found) // 4)
        for select in (connected, listed):
            for name, value in within.items():
                setattr(select, name, value)
        self.assertEqual(self.numbers(listed), self.numbers(connected))
        self.assertLess(len(self.numbers(listed)), len(found) // 2)
        points = simple.SelectElements(
            Input=some, ElementType="Points", Strategy="Change element type"
        )
        grown = simple.SelectElements(Input=points, ElementType="Points", **endless)
        every = simple.SelectElements(Input=source, ElementType="Points", Strategy="All")
        for select in (grown, every):
            select.UpdatePipeline()
            select.UpdatePropertyInformation()
        self.assertEqual(
            grown.GetPropertyValue("NumberOfSelectedElements"),
            every.GetPropertyValue("NumberOfSelectedElements"),
        )

    def test_stay_within(self):
        for mesh, count, source, message in self.splits():
            some = self.seed(source, count // 2, count // 2)
            allowed = set(range(count // 4, 3 * count // 4))
            found = self.numbers(
                simple.SelectElements(
                    Input=some,
                    Strategy="Expand",
                    NumberOfLayers=4,
                    OnlyInRange=True,
                    Array="Number",
                    Range="Custom",
                    Side="Inside",
                    LowerLimit=str(count // 4),
                    UpperLimit=str(3 * count // 4 - 1),
                )
            )
            self.assertEqual(found, layers(mesh, "Face", {count // 2}, 4, allowed), message)

    def test_connected_and_parts(self):
        for mesh, count, source, message in self.splits():
            low = count // 3
            some = self.seed(source, low, low + count // 3)
            domain = set(range(low, low + count // 3 + 1))
            part = simple.SelectElements(Input=some, Strategy="Component")
            flood = simple.SelectElements(
                Input=self.seed(source, low, low),
                Strategy="Connected",
                OnlyInRange=True,
                Array="Number",
                Range="Custom",
                Side="Inside",
                LowerLimit=str(low),
                UpperLimit=str(low + count // 3),
            )
            for kind in KINDS:
                part.Adjacency = flood.Adjacency = kind
                expected = components(mesh, kind, domain)
                sizes = [len(part) for part in expected]
                for number in {1, 2, len(expected)} & set(range(1, len(expected) + 1)):
                    if "scattered" in message and sizes.count(sizes[number - 1]) > 1:
                        continue  # which comes first is a matter of ids
                    part.ComponentNumber = number
                    self.assertEqual(
                        self.numbers(part), expected[number - 1], f"{message} {kind} {number}"
                    )
                self.assertEqual(
                    self.numbers(flood),
                    next(part for part in expected if low in part),
                    f"{message} {kind}",
                )

    def test_cases_of_specification(self):
        """Corner of 2 x 2 x 2 cubes: 4, 7, 8 cells; middle of 3 x 3 x 3 cubes: 7, 19, 27."""
        for side, cell, sizes in ((2, 0, (4, 7, 8)), (3, 13, (7, 19, 27))):
            cubes = simple.Wavelet(WholeExtent=[0, side] * 3)
            seed = simple.SelectElements(Input=cubes, Strategy="By id", Ids=str(cell))
            for kind, size in zip(KINDS, sizes):
                grown = simple.SelectElements(Input=seed, Strategy="Expand", Adjacency=kind)
                grown.UpdatePipeline()
                grown.UpdatePropertyInformation()
                if camaron_testing.rank_count() == 1:  # images are numbered anew on every rank
                    self.assertEqual(grown.GetPropertyValue("NumberOfSelectedElements"), size)

    def test_feature_angle(self):
        """The faces of a box, each divided into squares, are 90 degrees apart."""
        box = simple.ExtractSurface(
            Input=simple.Wavelet(WholeExtent=[0, 3] * 3), NonlinearSubdivisionLevel=0
        )
        box.UpdatePipeline()
        if camaron_testing.rank_count() > 1:
            return
        seed = simple.SelectElements(Input=box, Strategy="By id", Ids="0")
        for angle, size in ((180, 54), (91, 54), (89, 9), (0, 9)):
            grown = simple.SelectElements(Input=seed, Strategy="Connected", FeatureAngle=angle)
            grown.UpdatePipeline()
            grown.UpdatePropertyInformation()
            self.assertEqual(grown.GetPropertyValue("NumberOfSelectedElements"), size, angle)

    @unittest.skipIf(camaron_testing.rank_count() > 1, "a file for one rank")
    def test_collapsed_cells(self):
        """A cell whose edges have shrunk to points has no edge in common with one at such a point."""
        corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (2, 1, 0), (2, 2, 0), (2, 1, 1)]
        corners += [(0, 0, 1), (1, 0, 1), (1, 1, 1)]
        cells = [(12, (0, 1, 2, 2, 6, 7, 8, 8)), (10, (2, 3, 4, 5))]
        path = camaron_testing.write_vtk(self.folder / "collapsed.vtk", corners, cells)
        numbered = simple.PointAndCellIds(Input=self.open(path), CellIdsArrayName="Number")
        for adjacency, expected in (("Face", {0}), ("Edge", {0}), ("Vertex", {0, 1})):
            for strategy in ("Connected", "Expand"):
                select = simple.SelectElements(
                    Input=self.seed(numbered, 0, 0), Strategy=strategy, Adjacency=adjacency
                )
                self.assertEqual(self.numbers(select), expected, f"{strategy} {adjacency}")

    def test_points(self):
        """Corner of 2 x 2 x 2 cubes: points on its edges, faces, cell."""
        if camaron_testing.rank_count() > 1:
            return
        cubes = simple.Wavelet(WholeExtent=[0, 2] * 3)
        seed = simple.SelectElements(Input=cubes, ElementType="Points", Strategy="By id", Ids="0")
        for kind, expected in (
            ("Edge", {0, 1, 3, 9}),
            ("Face", {0, 1, 3, 4, 9, 10, 12}),
            ("Vertex", {0, 1, 3, 4, 9, 10, 12, 13}),
        ):
            grown = simple.SelectElements(
                Input=seed, ElementType="Points", Strategy="Expand", Adjacency=kind
            )
            grown.UpdatePipeline()
            marks = vtk_to_numpy(self.fetch(grown).GetPointData().GetArray("Selected"))
            self.assertEqual(set(numpy.flatnonzero(marks).tolist()), expected)
        everything = simple.SelectElements(Input=cubes, ElementType="Points", Strategy="All")
        less = simple.SelectElements(Input=everything, ElementType="Points", Strategy="Shrink")
        less.UpdatePipeline()
        less.UpdatePropertyInformation()
        self.assertEqual(less.GetPropertyValue("NumberOfSelectedElements"), 27)


if __name__ == "__main__":
    camaron_testing.main()
