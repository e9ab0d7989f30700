# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ghost cells and points are recognized for any integer type of the marks; other types are rejected."""

import camaron_testing
import gallery
import mesh_parts
import numpy
from camaron import convert
from camaron.common import pipeline
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

INTEGERS = [
    numpy.int8,
    numpy.uint8,
    numpy.int16,
    numpy.uint16,
    numpy.int32,
    numpy.int64,
    numpy.uint64,
]
COPIES = [0] * 6 + [1] * 4


def make_mesh():
    """Six cubes, and four of them once more with points of their own."""
    points, cubes = gallery.lattice(3, 2, 1)
    cells = [(VTK_HEXAHEDRON, cube) for cube in cubes]
    for cube in cubes[1:5]:
        cells.append((VTK_HEXAHEDRON, list(range(len(points), len(points) + 8))))
        points += [points[i] for i in cube]
    return gallery.make_grid(points, cells)


def mark(attributes, values, kind):
    array = numpy_to_vtk(numpy.array(values, kind), deep=1)
    array.SetName("vtkGhostType")
    attributes.AddArray(array)


class TestGhostArrays(camaron_testing.TestCase):
    def count(self, grid, elements="Cells"):
        """What statistics count of the mesh and its criteria."""
        quality = simple.ElementQuality(
            Input=mesh_parts.producer(grid), Criteria=["Volume", "MaxNonOrthogonality"]
        )
        statistics = simple.QualityStatistics(Input=quality, ElementType=elements)
        return quality, self.fetch(statistics)

    def test_integers(self):
        for kind in INTEGERS:
            grid = make_mesh()
            mark(grid.GetCellData(), COPIES, kind)
            quality, table = self.count(grid)
            counts = vtk_to_numpy(table.GetColumnByName("Count"))
            self.assertEqual(set(counts.tolist()), {6}, kind)
            elements = simple.MeshElements(Input=mesh_parts.producer(grid))
            faces = self.fetch(elements, 0)
            self.assertEqual(int(camaron_testing.own_cells(faces).sum()), 29, kind)
            self.assertEqual(self.fetch(quality).GetCellGhostArray().GetNumberOfValues(), 10)
            # The input stays as it was.
            self.assertEqual(
                grid.GetCellData().GetArray("vtkGhostType").GetDataTypeSize(), kind().itemsize
            )

    def test_points(self):
        for kind in INTEGERS:
            grid = make_mesh()
            size = grid.GetNumberOfPoints()
            mark(grid.GetPointData(), [0] * (size - 32) + [1] * 32, kind)
            values = numpy_to_vtk(numpy.arange(size, dtype=float), deep=1)
            values.SetName("number")
            grid.GetPointData().AddArray(values)
            statistics = simple.QualityStatistics(
                Input=mesh_parts.producer(grid), ElementType="Points", Arrays=["number"]
            )
            table = self.fetch(statistics)
            self.assertEqual(table.GetColumnByName("Count").GetValue(0), size - 32, kind)
            self.assertEqual(table.GetColumnByName("Max").GetValue(0), size - 33, kind)

    def test_conversion(self):
        """Ghost cells are not written."""
        for kind in INTEGERS:
            grid = make_mesh()
            mark(grid.GetCellData(), COPIES, kind)
            for name, cells in (("mesh.visf", 6), ("mesh.cdb", 6)):
                writer = vtkXMLUnstructuredGridWriter()
                writer.SetInputData(grid)
                writer.SetFileName(str(self.folder / "mesh.vtu"))
                writer.Write()
                convert(self.folder / "mesh.vtu", self.folder / name)
                data = self.fetch(self.open(self.folder / name))
                self.assertEqual(data.GetNumberOfCells(), cells, (kind, name))

    def test_no_ghosts(self):
        """Filters and writers report marks that are not valid for ghosts."""
        for values, kind, words in (
            (COPIES, numpy.float32, "type float"),
            ([[0, 1]] * 10, numpy.uint8, "tuples of 2"),
            ([300] + COPIES[1:], numpy.int32, "out of range"),
            ([-1] + COPIES[1:], numpy.int64, "out of range"),
        ):
            for where in ("cells", "points"):
                grid = make_mesh()
                data = grid.GetCellData() if where == "cells" else grid.GetPointData()
                if where == "points":
                    values = values[:1] * (grid.GetNumberOfPoints())
                mark(data, values, kind)
                for make in (
                    lambda source: simple.ElementQuality(Input=source),
                    lambda source: simple.QualityStatistics(Input=source),
                    lambda source: simple.MeshElements(Input=source),
                    lambda source: simple.MeshSurface(Input=source),
                    lambda source: simple.MeshKernel(Input=source),
                    lambda source: simple.SelectElements(Input=source),
                ):
                    with pipeline.Messages() as messages:
                        make(mesh_parts.producer(grid)).UpdatePipeline()
                    self.assertTrue(messages.errors, make)
                    self.assertIn(f"vtkGhostType of the {where}", messages.errors[0])
                    if where == "cells":
                        self.assertIn(words, messages.errors[0])
                path = self.folder / "refused.visf"
                with pipeline.Messages() as messages:
                    simple.SaveData(str(path), proxy=mesh_parts.producer(grid))
                self.assertIn("vtkGhostType", "".join(messages.errors))
                self.assertFalse(path.exists())


camaron_testing.main()
