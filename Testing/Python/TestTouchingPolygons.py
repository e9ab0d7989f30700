# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Polygons that touch themselves: their area by criterion is that of their triangles and that of their pixels."""

import camaron_testing
import numpy
from camaron import convert
from inspection_testing import make_view, picture
from paraview import simple

#: Name, corners in the plane, area by the shoelace formula.
POLYGONS = {
    "first-again": ([(0, 0), (2, 0), (0.5, 0.5), (0, 2), (0, 0)], 1.0),
    "keyhole": (
        [(0, 0), (3, 0), (3, 3), (0, 3), (0, 0), (1, 1), (1, 2), (2, 2), (2, 1), (1, 1)],
        8.0,
    ),
    "two-holes": (
        [(0, 0), (7, 0), (7, 3), (0, 3), (0, 0), (1, 1), (1, 2), (2, 2), (4, 2), (5, 2)]
        + [(5, 1), (4, 1), (4, 2), (2, 2), (2, 1), (1, 1)],
        19.0,
    ),
    "vertex": ([(0, 0), (1, 0), (1, 1), (2, 1), (2, 2), (1, 2), (1, 1), (0, 1)], 2.0),
    "edge": (
        [(0, 0), (3, 0), (3, 3), (0, 3), (0, 1), (1, 1), (1, 2), (2, 2), (2, 1), (0, 1)],
        8.0,
    ),
}


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
        """What is converted to triangles has the area, and nothing is said of crossings."""
        for name, path, area in self.files():
            for suffix, options in ((".tri", {"unsupported_cells": "Convert"}), (".stl", {})):
                with self.subTest(name, suffix=suffix):
                    target = f"{name}{suffix}"
                    notes = convert(path, self.folder / target, **options)
                    self.assertNotIn("cross", " ".join(notes))
                    quality = simple.ElementQuality(
                        Input=self.open(self.folder / target), Criteria=["Area"]
                    )
                    areas = self.fetch(quality).GetCellData().GetArray("Area")
                    found = sum(areas.GetValue(i) for i in range(areas.GetNumberOfTuples()))
                    self.assertAlmostEqual(found, area, places=5)

    @camaron_testing.require_display()
    def test_pictures(self):
        """As many pixels as the area has, but for some along the edges."""
        view = make_view()
        view.CameraParallelProjection = 1
        for name, path, area in self.files():
            source = self.open(path)
            shown = {
                "Mesh Inspection": source,
                "Surface": simple.MeshSurface(Input=source, Triangulate=1),
            }
            for representation, proxy in shown.items():
                with self.subTest(name, representation=representation):
                    display = simple.Show(proxy, view)
                    display.SetRepresentationType(representation)
                    display.AmbientColor = display.DiffuseColor = [0, 0, 0]
                    view.CameraPosition, view.CameraFocalPoint = [2, 1.5, 10], [2, 1.5, 0]
                    view.CameraViewUp = [0, 1, 0]
                    view.CameraParallelScale = 4
                    colors = picture(view)
                    simple.Hide(proxy, view)
                    pixel = (2 * view.CameraParallelScale / colors.shape[0]) ** 2
                    found = pixel * numpy.count_nonzero(colors.sum(axis=2) < 3 * 128)
                    self.assertAlmostEqual(found, area, delta=0.02 * area + 0.05)


if __name__ == "__main__":
    camaron_testing.main()
