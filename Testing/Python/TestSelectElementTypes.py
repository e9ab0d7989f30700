# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""From cells to their faces, edges and points and back, against sets in Python, however the mesh is split.

No min, max, any and all here: programmable sources replace them in the main module.
"""

import functools

import camaron_testing
import numpy
import rank_meshes
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

SPLITS = (
    {},
    {"scattered": True, "global_ids": True},
    {"scattered": True, "ghosts": True},
    {"ghosts": True, "empty_rank": True},
    {"scattered": True, "global_ids": True, "appended": 3},
)
ALONE = camaron_testing.rank_count() == 1
MESHES = (
    [(mesh, split) for mesh in ("voronoi", "surfaces", "mixed") for split in (SPLITS[0], SPLITS[4])]
    if ALONE
    else [("mixed", SPLITS[1]), ("surfaces", SPLITS[2]), ("voronoi", SPLITS[3])]
)
KINDS = ("Faces", "Edges", "Points")
QUANTIFIERS = {"Any": any, "All": all}


@functools.lru_cache
def elements_of(mesh):
    """Of every cell its faces (of 3D cells), edges and points, each a set of coordinates."""
    points, cells = rank_meshes.MESHES[mesh]()
    grid, found = rank_meshes.take(points, cells, list(range(len(cells)))), []
    for i in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(i)

        def sets(count, get):
            return {
                frozenset(map(grid.GetPoint, rank_meshes.list_ids(get(j)))) for j in range(count)
            }

        solid = cell.GetCellDimension() == 3
        found.append(
            {
                "Faces": sets(cell.GetNumberOfFaces(), cell.GetFace) if solid else set(),
                "Edges": sets(cell.GetNumberOfEdges(), cell.GetEdge),
                "Points": {frozenset([grid.GetPoint(p)]) for p in rank_meshes.list_ids(cell)},
            }
        )
    return found


def has_faces(mesh):
    return bool(set().union(*(elements["Faces"] for elements in elements_of(mesh))))


def bounding(mesh, kind, cells, quantifier):
    """The elements of which any or all cells are among the given ones."""
    cells_at = {}
    for number, elements in enumerate(elements_of(mesh)):
        for element in elements[kind]:
            cells_at.setdefault(element, []).append(number in cells)
    return {element for element, marks in cells_at.items() if QUANTIFIERS[quantifier](marks)}


def bounded(mesh, kind, marked, quantifier):
    """The cells of which any or all elements are among the given ones."""
    return {
        number
        for number, elements in enumerate(elements_of(mesh))
        if elements[kind] and QUANTIFIERS[quantifier](e in marked for e in elements[kind])
    }


class TestSelectElementTypes(camaron_testing.TestCase):
    def pieces(self, select):
        with camaron_testing.pipeline.Messages() as messages:
            select.UpdatePipeline()
        self.assertEqual(messages.errors, [], select.GetPropertyValue("Strategy"))
        select.UpdatePropertyInformation()
        return camaron_testing.pieces(select)

    def cells(self, select):
        """Which cells of the whole mesh are selected."""
        found = []
        for piece in self.pieces(select):
            data = piece.GetCellData()
            if data.GetArray("Number"):  # a rank without cells has none
                marks = vtk_to_numpy(data.GetArray("Selected")) == 1
                marks &= camaron_testing.own_cells(piece)
                found += vtk_to_numpy(data.GetArray("Number"))[marks].tolist()
        self.assertEqual(len(found), len(set(found)), "a cell that is selected twice")
        self.assertEqual(select.GetPropertyValue("NumberOfSelectedElements"), len(found))
        return set(found)

    def elements(self, select):
        """The points of the selected cells of faces or edges."""
        found = []
        for piece in self.pieces(select):
            marks, own = piece.GetCellData().GetArray("Selected"), camaron_testing.own_cells(piece)
            for i in range(piece.GetNumberOfCells()):
                if marks.GetValue(i) and own[i]:
                    ids = rank_meshes.list_ids(piece.GetCell(i))
                    found.append(frozenset(map(piece.GetPoint, ids)))
        self.assertEqual(len(found), len(set(found)), "an element that is selected twice")
        self.assertEqual(select.GetPropertyValue("NumberOfSelectedElements"), len(found))
        return set(found)

    def points(self, select):
        """The selected points, which are selected in all pieces of owned cells that have them."""
        selected, others = set(), set()
        for piece in self.pieces(select):
            marks = piece.GetPointData().GetArray("Selected")
            for i in numpy.flatnonzero(camaron_testing.own_cells(piece)):
                for p in rank_meshes.list_ids(piece.GetCell(i)):
                    place = frozenset([piece.GetPoint(p)])
                    (selected if marks.GetValue(p) else others).add(place)
        self.assertEqual(selected & others, set(), "copies of a point that differ")
        self.assertEqual(select.GetPropertyValue("NumberOfSelectedElements"), len(selected))
        return selected

    def seeds(self, source, cells):
        """Selects some cells of the mesh by their numbers."""
        calculator = simple.Calculator(
            Input=source, AttributeType="Cell Data", ResultArrayName="Seed"
        )
        calculator.Function = "+".join(f"(Number=={cell})" for cell in sorted(cells))
        return simple.SelectElements(
            Input=calculator,
            Array="Seed",
            Range="Custom",
            Side="Inside",
            LowerLimit="1",
        )

    def splits(self):
        for mesh, options in MESHES:
            count = len(elements_of(mesh))
            # A clump, for the quantifier All, and single cells.
            clump = set(range(count // 3, count // 3 + count // 4)) | {0, count - 1}
            source = rank_meshes.split_source(mesh, **options)
            yield mesh, clump, self.seeds(source, clump), f"{mesh} {options}"
            camaron_testing.delete_sources()

    def test_cells_to_elements_and_back(self):
        for mesh, clump, seeds, message in self.splits():
            self.assertEqual(self.cells(seeds), clump, message)
            elements = simple.MeshElements(Input=seeds)
            for port, kind in enumerate(KINDS[:2]):
                if kind == "Faces" and not has_faces(mesh):
                    continue
                there = simple.SelectElements(
                    Input=servermanager.OutputPort(elements, port),
                    Strategy="Change element type",
                    Elements=seeds,
                )
                back = simple.SelectElements(
                    Input=seeds, Strategy="Change element type", Elements=there
                )
                for quantifier in QUANTIFIERS:
                    there.Quantifier = quantifier
                    expected = bounding(mesh, kind, clump, quantifier)
                    what = f"{message} {kind} {quantifier}"
                    self.assertEqual(self.elements(there), expected, what)
                    for back_quantifier in QUANTIFIERS:
                        back.Quantifier = back_quantifier
                        self.assertEqual(
                            self.cells(back), bounded(mesh, kind, expected, back_quantifier), what
                        )

    def test_cells_to_points_and_back(self):
        for mesh, clump, seeds, message in self.splits():
            points = simple.SelectElements(
                Input=seeds, ElementType="Points", Strategy="Change element type"
            )
            back = simple.SelectElements(Input=points, Strategy="Change element type")
            for quantifier in QUANTIFIERS:
                points.Quantifier = quantifier
                expected = bounding(mesh, "Points", clump, quantifier)
                self.assertEqual(self.points(points), expected, f"{message} {quantifier}")
                for back_quantifier in QUANTIFIERS:
                    back.Quantifier = back_quantifier
                    self.assertEqual(
                        self.cells(back),
                        bounded(mesh, "Points", expected, back_quantifier),
                        message,
                    )

    def test_laws(self):
        for mesh, clump, seeds, message in self.splits():
            points = simple.SelectElements(
                Input=seeds, ElementType="Points", Strategy="Change element type", Quantifier="All"
            )
            back = simple.SelectElements(
                Input=points, Strategy="Change element type", Quantifier="All"
            )
            self.assertLessEqual(self.cells(back), clump, message)
            everything = simple.SelectElements(Input=seeds, Strategy="All")
            there = simple.SelectElements(
                Input=everything,
                ElementType="Points",
                Strategy="Change element type",
                Quantifier="All",
            )
            back = simple.SelectElements(
                Input=there, Strategy="Change element type", Quantifier="All"
            )
            self.assertEqual(self.cells(back), set(range(len(elements_of(mesh)))), message)

    def test_points_to_faces_and_edges(self):
        for mesh, clump, seeds, message in self.splits():
            elements = simple.MeshElements(Input=seeds)
            points = simple.SelectElements(
                Input=seeds, ElementType="Points", Strategy="Change element type", Quantifier="All"
            )
            places = bounding(mesh, "Points", clump, "All")
            for port, kind in enumerate(KINDS[:2]):
                everything = set().union(*(cell[kind] for cell in elements_of(mesh)))
                select = simple.SelectElements(
                    Input=servermanager.OutputPort(elements, port),
                    Strategy="Change element type",
                    Elements=points,
                )
                for quantifier, decide in QUANTIFIERS.items():
                    select.Quantifier = quantifier
                    if everything:
                        expected = {
                            e for e in everything if decide(frozenset([p]) in places for p in e)
                        }
                        self.assertEqual(self.elements(select), expected, f"{message} {kind}")

    def test_points_are_those_of_the_whole_mesh(self):
        for mesh, _clump, seeds, message in self.splits():
            everything = set().union(*(cell["Points"] for cell in elements_of(mesh)))
            select = simple.SelectElements(Input=seeds, ElementType="Points", Strategy="All")
            self.assertEqual(self.points(select), everything, message)

    def test_elements_of_another_mesh(self):
        mesh = rank_meshes.split_source("tetrahedra")
        other = simple.Transform(Input=mesh)
        other.Transform.Translate = [0.1, 0, 0]
        faces = simple.MeshElements(Input=mesh)
        selected = simple.SelectElements(Input=other, Strategy="All")
        self.assert_failure(faces, selected, "points of Elements are not those of the mesh")
        self.assert_failure(faces, mesh, "no array 'Selected'")
        same = simple.SelectElements(Input=mesh, Strategy="All")
        self.assert_failure(mesh, same, "already of the type to select")

    def assert_failure(self, source, elements, text):
        select = simple.SelectElements(
            Input=source, Strategy="Change element type", Elements=elements
        )
        with camaron_testing.pipeline.Messages() as messages:
            select.UpdatePipeline()
        self.assertIn(text, " ".join(messages.errors))


if __name__ == "__main__":
    camaron_testing.main()
