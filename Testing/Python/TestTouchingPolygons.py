# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Polygons and faces that touch themselves: their area by criterion is that of their triangles and that of their pixels."""

import camaron_testing
import numpy
from camaron import convert
from camaron.inspection import pictures
from inspection_testing import make_view, picture, read_picture
from paraview import simple
from touching_shapes import BLOCKS, POLYGONS, make_prisms
from vtkmodules.util.numpy_support import vtk_to_numpy


def write_off(corners) -> str:
    numbers = {corner: i for i, corner in enumerate(dict.fromkeys(corners))}
    lines = ["OFF", f"{len(numbers)} 1 0", *(f"{x} {y} 0" for x, y in numbers)]
    lines.append(" ".join(map(str, [len(corners), *(numbers[corner] for corner in corners)])))
    return "\n".join(lines) + "\n"


class TestTouchingPolygons(camaron_testing.TestCase):
    def files(self):
        for name, (corners, area) in POLYGONS.items():
            path = self.folder / f"{name}.off"
            path.write_text(write_off(corners))
            yield name, path, area

    def evaluate(self, path, *names):
        quality = simple.ElementQuality(Input=self.open(path), Criteria=list(names))
        arrays = self.fetch(quality).GetCellData()
        return [arrays.GetArray(name).GetValue(0) for name in names]

    def test_criteria(self):
        """They touch themselves but do not cross: CellStatus has no 2 (edges that cross)."""
        for name, path, area in self.files():
            with self.subTest(name):
                found, status = self.evaluate(path, "Area", "CellStatus")
                self.assertAlmostEqual(found, area, places=12)
                self.assertEqual(int(status) & 2, 0)

    def test_triangles(self):
        """The triangles of the conversion have the area of the polygons, and no crossings are reported."""
        for name, path, area in self.files():
            for suffix, options in ((".tri", {"unsupported_cells": "Convert"}), (".stl", {})):
                with self.subTest(name, suffix=suffix):
                    target = f"{name}{suffix}"
                    notes = convert(path, self.folder / target, **options)
                    self.assertNotIn("cross", " ".join(notes))
                    found = self.areas(self.open(self.folder / target)).sum()
                    self.assertAlmostEqual(found, area, places=5)

    def blocks(self):
        for name, (outline, volume, area) in BLOCKS.items():
            yield name, make_prisms(outline), volume, area

    def areas(self, surface):
        quality = simple.ElementQuality(Input=surface, Criteria=["Area"])
        return vtk_to_numpy(self.fetch(quality).GetCellData().GetArray("Area"))

    def test_faces_of_polyhedra(self):
        """The surface as it is and in triangles has the area of the criterion."""
        for name, block, volume, area in self.blocks():
            with self.subTest(name):
                quality = simple.ElementQuality(Input=block, Criteria=["Volume", "SurfaceArea"])
                arrays = self.fetch(quality).GetCellData()
                self.assertAlmostEqual(arrays.GetArray("Volume").GetValue(0), volume, places=12)
                self.assertAlmostEqual(arrays.GetArray("SurfaceArea").GetValue(0), area, places=12)
                faces = self.areas(simple.MeshSurface(Input=block))
                self.assertEqual(len(faces), len(BLOCKS[name][0]))
                self.assertAlmostEqual(faces.sum(), area, places=12)
                triangles = self.areas(simple.MeshSurface(Input=block, Triangulate=1))
                self.assertGreater(len(triangles), len(faces))
                self.assertAlmostEqual(triangles.sum(), area, places=12)

    def test_conversion_of_polyhedra(self):
        """Tetrahedra from one vertex overlap, which is reported."""
        for name, block, _, area in self.blocks():
            path = self.folder / f"{name}.visf"
            simple.SaveData(str(path), proxy=block)
            with self.subTest(name):
                notes = convert(path, self.folder / f"{name}.m3d", unsupported_cells="Convert")
                self.assertIn("not convex", " ".join(notes))
                convert(path, self.folder / f"{name}.stl")
                stl = self.open(self.folder / f"{name}.stl")
                self.assertAlmostEqual(self.areas(stl).sum(), area, places=5)

    def test_selection_in_polyhedra(self):
        """A ball in the hole is not in the block, one in the block is."""
        for name, block, _, _ in self.blocks():
            for center, found in (((1.5, 1.5, 0.5), 0), ((0.5, 0.5, 0.5), 1), ((2.5, 1.5, 0.5), 1)):
                with self.subTest(name, center=center):
                    select = simple.SelectElements(Input=block, Strategy="Shape", Shape="Sphere")
                    select.Placement = "Intersects"
                    select.Shape.Center, select.Shape.Radius = center, 0.3
                    marks = self.fetch(select).GetCellData().GetArray("Selected")
                    self.assertEqual(marks.GetValue(0), found)

    @camaron_testing.require_display()
    def test_pictures(self):
        """As many pixels as the area has, but for some along the edges; through the hole of a block one sees."""
        self.view = make_view()
        self.view.CameraParallelProjection = 1
        for name, path, area in self.files():
            self.check_pixels(name, self.open(path), area)
        for name, block, volume, _ in self.blocks():
            self.check_pixels(name, block, volume)

    @camaron_testing.require_display()
    def test_report(self):
        """Pictures of reports, too, have holes where the polygons have them."""
        for name, path, area in self.files():
            with self.subTest(name):
                source = self.open(path)
                camera = pictures.Camera(source.GetDataInformation().GetBounds())
                scene = pictures.Scene()
                scene.view.OrientationAxesVisibility = 0
                scene.show(source, DiffuseColor=[0, 0, 0], AmbientColor=[0, 0, 0])
                scene.save(camera, self.folder / f"{name}.png")
                scene.close()
                colors = read_picture(self.folder / f"{name}.png")
                pixel = (2 * camera.scale / colors.shape[0]) ** 2
                found = pixel * numpy.count_nonzero(colors.sum(axis=2) < 3 * 128)
                self.assertAlmostEqual(found, area, delta=0.02 * area + 0.05)

    def check_pixels(self, name, source, area):
        view = self.view
        shown = {
            "Mesh Inspection": source,
            "Surface": simple.MeshSurface(Input=source, Triangulate=1),
        }
        for representation, proxy in shown.items():
            with self.subTest(name, representation=representation):
                display = simple.Show(proxy, view)
                display.SetRepresentationType(representation)
                display.AmbientColor = display.DiffuseColor = [0, 0, 0]
                view.CameraPosition, view.CameraFocalPoint = [2, 2, 10], [2, 2, 0]
                view.CameraViewUp = [0, 1, 0]
                picture(view)  # the first one moves the camera
                view.CameraPosition, view.CameraFocalPoint = [2, 2, 10], [2, 2, 0]
                view.CameraParallelScale = 4
                colors = picture(view)
                simple.Hide(proxy, view)
                pixel = (2 * view.CameraParallelScale / colors.shape[0]) ** 2
                found = pixel * numpy.count_nonzero(colors.sum(axis=2) < 3 * 128)
                self.assertAlmostEqual(found, area, delta=0.02 * area + 0.05)


if __name__ == "__main__":
    camaron_testing.main()
