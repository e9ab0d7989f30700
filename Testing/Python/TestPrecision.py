# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Values depend on the coordinates, not on the type in which they are stored."""

import camaron_testing
import gallery
import mesh_parts
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints

BALL = camaron_testing.EXAMPLES / "voronoi-ball.visf"


def with_points(grid, points):
    copy = grid.NewInstance()
    copy.ShallowCopy(grid)
    array = vtkPoints()
    array.SetData(numpy_to_vtk(numpy.ascontiguousarray(points), deep=1))
    copy.SetPoints(array)
    return copy


class TestPrecision(camaron_testing.TestCase):
    def values(self, grid, names=()):
        source = mesh_parts.producer(grid)
        names = names or simple.ElementQuality(Input=source).GetProperty("Criteria").Available
        cells = self.fetch(simple.ElementQuality(Input=source, Criteria=names)).GetCellData()
        return {name: vtk_to_numpy(cells.GetArray(name)) for name in names}

    def meshes(self):
        yield "voronoi", self.fetch(self.open(BALL))
        yield "flange", self.fetch(self.open(camaron_testing.EXAMPLES / "flange.visf"))
        for name in ("tetrahedra", "inverted", "mixed", "polyhedra", "triangles", "polygons"):
            yield name, getattr(gallery, name)()
        # Flat and short to the last digits of single precision.
        warped, cubes = gallery.lattice(6, 5, 4)
        random = numpy.random.default_rng(2)
        points = numpy.array(warped) + random.normal(size=(len(warped), 3)) * 1e-7
        points[::3] = points[numpy.maximum(numpy.arange(0, len(points), 3) - 1, 0)] * (1 + 2e-7)
        yield "short", gallery.make_grid(points.tolist(), [(12, cube) for cube in cubes])

    def test_same_points(self):
        """All criteria are the same bit for bit in the same points of both types, and wherever these lie."""
        for name, grid in self.meshes():
            for shift in (0, 50):
                points = (gallery.points_of(grid) + shift).astype(numpy.float32)
                single = self.values(with_points(grid, points))
                double = self.values(with_points(grid, points.astype(float)))
                self.assertGreater(len(single), 90)
                for criterion, values in single.items():
                    numpy.testing.assert_array_equal(
                        values, double[criterion], err_msg=f"{name} {criterion}"
                    )

    def test_healthy_in_single_precision(self):
        """Short edges, of which Voronoi cells have many, are edges in either precision."""
        ball = self.fetch(self.open(BALL))
        points = gallery.points_of(ball)
        names = ["CellStatus", "OrthogonalQuality"]
        for shift in (0, 1, 5):
            moved = points + shift
            double = self.values(with_points(ball, moved), names)
            single = self.values(with_points(ball, moved.astype(numpy.float32)), names)
            self.assertEqual(int((double["CellStatus"] != 0).sum()), 0)
            changed = single["CellStatus"] != double["CellStatus"]
            self.assertLess(int(changed.sum()), 9, shift)
            difference = abs(single["OrthogonalQuality"] - double["OrthogonalQuality"])
            self.assertLess(int((difference > 0.05).sum()), 9, shift)

    def test_elements(self):
        """So do faces, edges and vertices."""
        for name, grid in self.meshes():
            points = gallery.points_of(grid).astype(numpy.float32)
            for port in range(3):
                single, double = (
                    self.fetch(
                        simple.MeshElements(Input=mesh_parts.producer(with_points(grid, p))), port
                    ).GetCellData()
                    for p in (points, points.astype(float))
                )
                for i in range(single.GetNumberOfArrays()):
                    array = single.GetArray(i)
                    numpy.testing.assert_array_equal(
                        vtk_to_numpy(array),
                        vtk_to_numpy(double.GetArray(i)),
                        err_msg=f"{name} {array.GetName()}",
                    )


camaron_testing.main()
