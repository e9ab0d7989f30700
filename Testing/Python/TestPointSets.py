# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Convex point sets are the polyhedra that they are the hulls of, alone and among other cells."""

import camaron_testing
import gallery
import mesh_parts
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_CONVEX_POINT_SET,
    VTK_HEXAHEDRON,
    VTK_POLYHEDRON,
    VTK_WEDGE,
    vtkUnstructuredGrid,
)

# Whose values are those of a type of cell, or of the order in which it has its nodes.
OF_TYPES = ("Verdict", "CellType")


def all_criteria():
    criteria = simple.ElementQuality(Input=simple.Sphere()).GetProperty("Criteria").Available
    return [name for name in criteria if not name.startswith(OF_TYPES)]


def with_points(grid, points):
    copy = vtkUnstructuredGrid()
    copy.ShallowCopy(grid)
    array = vtkPoints()
    array.SetData(numpy_to_vtk(numpy.ascontiguousarray(points), deep=1))
    copy.SetPoints(array)
    return copy


class TestPointSets(camaron_testing.TestCase):
    def values(self, grid, names):
        quality = simple.ElementQuality(Input=mesh_parts.producer(grid), Criteria=names)
        cells = self.fetch(quality).GetCellData()
        return {name: vtk_to_numpy(cells.GetArray(name)) for name in names}

    def compare(self, sets, others, tolerance=1e-9):
        names = all_criteria()
        self.assertGreater(len(names), 80)
        found, expected = self.values(sets, names), self.values(others, names)
        for name in names:
            numpy.testing.assert_allclose(
                found[name], expected[name], rtol=tolerance, atol=tolerance, err_msg=name
            )

    def test_cube(self):
        """All values are those of the hexahedron."""
        points, cubes = gallery.lattice(1, 1, 1, lambda *p: p)
        cube = gallery.make_grid(points, [(VTK_HEXAHEDRON, cubes[0])])
        for order in (list(range(8)), [3, 7, 0, 5, 1, 6, 2, 4]):
            self.compare(gallery.make_grid(points, [(VTK_CONVEX_POINT_SET, order)]), cube)
        found = self.values(
            gallery.make_grid(points, [(VTK_CONVEX_POINT_SET, range(8))]),
            ["FaceCount", "EdgeCount", "MaxDihedralAngle"],
        )
        self.assertEqual([int(found[n][0]) for n in ("FaceCount", "EdgeCount")], [6, 12])
        self.assertAlmostEqual(found["MaxDihedralAngle"][0], 90)

    def test_stack(self):
        """Sets have faces in common with other cells, in any precision and place."""
        turn = numpy.linalg.qr(numpy.random.default_rng(3).normal(size=(3, 3)))[0]
        turn *= numpy.sign(numpy.linalg.det(turn))
        points, cubes = gallery.lattice(3, 3, 3, lambda *p: p)
        whole = [(VTK_HEXAHEDRON, cube) for cube in cubes]
        hexahedra = gallery.make_grid(points, whole)
        mixed = []
        for number, cube in enumerate(cubes):
            faces = [list(face) for face in gallery.faces(hexahedra, number)]
            kinds = [(VTK_CONVEX_POINT_SET, cube), (VTK_HEXAHEDRON, cube), (VTK_POLYHEDRON, faces)]
            mixed.append(kinds[(number * 7) % 3])
        for shift in (0, 10):
            for kind in (numpy.float32, numpy.float64):
                places = ((numpy.array(points) * [1, 1, 0.2]) @ turn.T + shift).astype(kind)
                same = with_points(hexahedra, places)
                tolerance = 1e-5 if kind == numpy.float32 else 1e-8
                for cells in (mixed, [(VTK_CONVEX_POINT_SET, cube) for cube in cubes]):
                    grid = with_points(gallery.make_grid(points, cells), places)
                    names = [
                        "FaceCount",
                        "MaxNonOrthogonality",
                        "OrthogonalQuality",
                        "MaxFaceSkewness",
                        "CellStatus",
                    ]
                    found, expected = self.values(grid, names), self.values(same, names)
                    for name in names:
                        numpy.testing.assert_allclose(
                            found[name], expected[name], atol=tolerance, err_msg=name
                        )
                    elements = simple.MeshElements(Input=mesh_parts.producer(grid))
                    self.assertEqual(self.fetch(elements, 0).GetNumberOfCells(), 108)
                    self.assertEqual(self.fetch(elements, 1).GetNumberOfCells(), 144)
                    surface = simple.MeshSurface(Input=mesh_parts.producer(grid))
                    self.assertEqual(self.fetch(surface).GetNumberOfCells(), 54)

    def test_written(self):
        """Writers have the faces as polygons, too."""
        points, cubes = gallery.lattice(2, 1, 1)
        points = [(x, y, 0.5 * z) for x, y, z in gallery.lattice(2, 1, 1, lambda *p: p)[0]]
        grid = gallery.make_grid(points, [(VTK_CONVEX_POINT_SET, cube) for cube in cubes])
        path = self.folder / "sets.visf"
        simple.SaveData(str(path), proxy=mesh_parts.producer(grid))
        _, faces, cells = camaron_testing.read_visf(path)
        self.assertEqual((len(faces), [len(cell) for cell in cells]), (11, [6, 6]))
        self.assertEqual({len(face) for face in faces}, {4})

    def test_wedge(self):
        points = [(0, 0, 0), (1, 0, 0), (0.3, 0.9, 0), (0, 0.1, 1), (1, 0.1, 1), (0.3, 1.0, 1)]
        found, expected = (
            gallery.make_grid(points, [(kind, list(range(6)))])
            for kind in (VTK_CONVEX_POINT_SET, VTK_WEDGE)
        )
        self.compare(found, expected)


camaron_testing.main()
