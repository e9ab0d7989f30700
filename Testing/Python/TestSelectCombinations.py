# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Select Elements continues from a selection: of the mesh, of ParaView, of another element type."""

import camaron_testing
import mesh_parts
import numpy
from paraview import selection as paraview_selection
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject

COMBINATIONS = {
    "Replace": lambda a, b: b,
    "Add": lambda a, b: a | b,
    "Subtract": lambda a, b: a - b,
    "Intersect": lambda a, b: a & b,
    "Toggle": lambda a, b: a ^ b,
    "Refine": lambda a, b: a & b,
}


class TestSelectCombinations(camaron_testing.TestCase):
    def select(self, source, **properties):
        """A filter that has run, and what it selects."""
        select = simple.SelectElements(Input=source, **properties)
        with camaron_testing.pipeline.Messages() as messages:
            select.UpdatePipeline()
        self.assertEqual(messages.errors, [])
        select.UpdatePropertyInformation()
        kind = properties.get("ElementType", "Cells") == "Cells"
        attributes = self.fetch(select).GetAttributes(
            vtkDataObject.CELL if kind else vtkDataObject.POINT
        )
        found = set(numpy.flatnonzero(vtk_to_numpy(attributes.GetArray("Selected"))).tolist())
        self.assertEqual(select.GetPropertyValue("NumberOfSelectedElements"), len(found))
        return select, found

    def cubes(self, side):
        """Hexahedra of an image, whose points and cells are numbered x first."""
        return simple.Wavelet(WholeExtent=[0, side] * 3)

    def test_case_of_specification(self):
        """Cells 0 to 5 and 4 to 9: 10, 4, 2 and 8 of them."""
        source = self.cubes(3)
        for name, size in (("Add", 10), ("Subtract", 4), ("Intersect", 2), ("Toggle", 8)):
            for kind in ("Cells", "Points"):
                first, a = self.select(source, Strategy="By id", Ids="0-5", ElementType=kind)
                _, both = self.select(
                    first, Strategy="By id", Ids="4-9", Combination=name, ElementType=kind
                )
                self.assertEqual(a, set(range(6)))
                self.assertEqual(len(both), size)
                self.assertEqual(both, COMBINATIONS[name](a, set(range(4, 10))))

    def test_selections_of_paraview(self):
        """Ids, values, places, queries and expressions are the selection so far."""
        grid = mesh_parts.make_full_mesh(global_ids=True)
        source = mesh_parts.producer(grid)
        values = vtk_to_numpy(grid.GetCellData().GetArray("EdgeLengthRatio"))
        ids = vtk_to_numpy(grid.GetCellData().GetGlobalIds()).tolist()
        sources = {
            "IDSelectionSource": ({"IDs": [0, 3, 0, 7, 0, 8]}, {3, 7, 8}),
            "GlobalIDSelectionSource": ({"IDs": ids[10:14]}, set(range(10, 14))),
            "ThresholdSelectionSource": (
                {"ArrayName": "EdgeLengthRatio", "Thresholds": [0.0, 0.25]},
                set(numpy.flatnonzero(values <= 0.25).tolist()),
            ),
            "SelectionQuerySource": (
                {"QueryString": "EdgeLengthRatio >= 0.5"},
                set(numpy.flatnonzero(values >= 0.5).tolist()),
            ),
        }
        for name, (properties, expected) in sources.items():
            chosen = paraview_selection._createSelection(name, **properties)
            chosen.UpdateVTKObjects()
            self.assertTrue(expected, name)
            _, found = self.select(source, Selection=chosen, Strategy="Current")
            self.assertEqual(found, expected, name)
            for combination, combine in COMBINATIONS.items():
                _, found = self.select(
                    source, Selection=chosen, Strategy="By id", Ids="5-12", Combination=combination
                )
                self.assertEqual(found, combine(expected, set(range(5, 13))), name)

    def test_refine_looks_at_the_selection_only(self):
        grid = mesh_parts.make_full_mesh(global_ids=False)
        values = vtk_to_numpy(grid.GetCellData().GetArray("EdgeLengthRatio"))
        first, _ = self.select(mesh_parts.producer(grid), Strategy="By id", Ids="100-300")
        order = sorted(
            (i for i in range(100, 301) if not numpy.isnan(values[i])), key=lambda i: (values[i], i)
        )
        _, found = self.select(
            first,
            Strategy="Worst N",
            Array="EdgeLengthRatio",
            NumberOfWorst=20,
            Combination="Refine",
        )
        self.assertEqual(found, set(order[:20]))

    def test_other_element_type(self):
        """Points of the selected cells; cells with a selected point."""
        source = self.cubes(2)
        corner = paraview_selection._createSelection(
            "IDSelectionSource", IDs=[0, 0], FieldType="POINT"
        )
        corner.UpdateVTKObjects()
        self.assertEqual(self.select(source, Selection=corner, Strategy="Current")[1], {0})
        middle = paraview_selection._createSelection(
            "IDSelectionSource", IDs=[0, 13], FieldType="POINT"
        )
        middle.UpdateVTKObjects()
        self.assertEqual(
            self.select(source, Selection=middle, Strategy="Current")[1], set(range(8))
        )
        cell = paraview_selection._createSelection("IDSelectionSource", IDs=[0, 0])
        cell.UpdateVTKObjects()
        _, found = self.select(source, Selection=cell, Strategy="Current", ElementType="Points")
        self.assertEqual(found, {0, 1, 3, 4, 9, 10, 12, 13})

    def test_boundary(self):
        """Of 2 x 2 x 2 cubes all, of 3 x 3 x 3 all but the one in the middle."""
        self.assertEqual(len(self.select(self.cubes(2), Strategy="Boundary")[1]), 8)
        _, found = self.select(self.cubes(3), Strategy="Boundary")
        self.assertEqual(found, set(range(27)) - {13})
        _, found = self.select(self.cubes(2), Strategy="Boundary", ElementType="Points")
        self.assertEqual(found, set(range(27)) - {13})
        plane = simple.Plane(XResolution=4, YResolution=3)
        _, found = self.select(plane, Strategy="Boundary")
        self.assertEqual(found, set(range(12)) - {5, 6})
        self.assertEqual(self.select(simple.Box(), Strategy="Boundary")[1], set(range(6)))

    def test_whole(self):
        grid = mesh_parts.make_full_mesh(global_ids=False)
        count = grid.GetNumberOfCells()
        source = mesh_parts.producer(grid)
        self.assertEqual(self.select(source, Strategy="All")[1], set(range(count)))
        self.assertEqual(self.select(source, Strategy="Current")[1], set())
        first, _ = self.select(source, Strategy="By id", Ids="10-20")
        rest = set(range(count)) - set(range(10, 21))
        self.assertEqual(self.select(first, Strategy="Invert")[1], rest)
        null = numpy.isnan(vtk_to_numpy(grid.GetCellData().GetArray("EdgeLengthRatio")))
        self.assertTrue(null.any())
        _, found = self.select(
            first, Strategy="Invert", ExcludeUndefined=True, Array="EdgeLengthRatio"
        )
        self.assertEqual(found, {i for i in rest if not null[i]})

    def test_point_arrays(self):
        grid = mesh_parts.make_mesh()
        count = grid.GetNumberOfPoints()
        values = numpy.arange(count, dtype=float)
        values[::7] = numpy.nan
        array = numpy_to_vtk(values, deep=True)
        array.SetName("Field")
        grid.GetPointData().AddArray(array)
        properties = {"PointArray": "Field", "ElementType": "Points"}
        source = mesh_parts.producer(grid)
        _, found = self.select(source, Strategy="Undefined", **properties)
        self.assertEqual(found, set(range(0, count, 7)))
        _, found = self.select(
            source, Strategy="Worst N", WorstValues="Smallest", NumberOfWorst=3, **properties
        )
        self.assertEqual(found, {1, 2, 3})
        _, found = self.select(source, Range="Custom", UpperLimit="9", Side="Inside", **properties)
        self.assertEqual(found, {1, 2, 3, 4, 5, 6, 8, 9})


if __name__ == "__main__":
    camaron_testing.main()
