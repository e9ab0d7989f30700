# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The isosurfaces of Mesh Inspection are those of ParaView's filters."""

import camaron_testing
import gallery
from inspection_testing import difference, make_view, picture, selected, turn
from mesh_parts import producer
from paraview import simple

VALUES = [80.3, 130.2, 200.7]


@camaron_testing.require_display()
class TestIsosurfaces(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        self.view = make_view()
        self.addCleanup(simple.ResetSession)

    def color(self, display, array):
        if array or display.ColorArrayName[1]:
            simple.ColorBy(display, array)
        if array:  # ColorBy fits the table to the data
            simple.GetColorTransferFunction(array[1]).RescaleTransferFunction(0, 300)

    def of_filter(self, source, color=None):
        display = simple.Show(source, self.view)
        display.SetRepresentationType("Surface")
        display.Interpolation = "Flat"
        self.color(display, color)
        turn(self.view)
        made = picture(self.view)
        simple.Hide(source, self.view)
        return made

    def inspect(self, source, array, values, color=None):
        display = simple.Show(source, self.view)
        display.SetRepresentationType("Mesh Inspection")
        self.color(display, color)
        display.DrawFaces = display.DrawEdges = 0
        display.DrawIsosurfaces = 1
        display.IsosurfaceArray = ["POINTS", array]
        display.IsosurfaceValues = values
        return display, picture(self.view)

    def tetrahedra(self):
        wavelet = simple.Wavelet(WholeExtent=[-8, 8, -8, 8, -8, 8])
        return simple.Tetrahedralize(Input=wavelet)

    def test_tetrahedra(self):
        """In a mesh of tetrahedra they are exactly those of Contour, whatever colors them."""
        source = self.tetrahedra()
        for color in (None, ("POINTS", "RTData")):
            contour = simple.Contour(
                Input=source, ContourBy=["POINTS", "RTData"], Isosurfaces=VALUES, ComputeNormals=0
            )
            expected = self.of_filter(contour, color)
            _, made = self.inspect(source, "RTData", VALUES, color)
            self.assertLess(difference(expected, made), 0.002)
            self.assertGreater(difference(made, made * 0 + 255), 0.1)
            simple.HideAll(self.view)  # and with it the isosurfaces

    def test_values_change(self):
        """More triangles than there was room for, then none at all."""
        source = self.tetrahedra()
        values = [70 + 0.7 * i for i in range(200)]
        contour = simple.Contour(
            Input=source, ContourBy=["POINTS", "RTData"], Isosurfaces=values, ComputeNormals=0
        )
        expected = self.of_filter(contour)
        display, _ = self.inspect(source, "RTData", VALUES)
        display.IsosurfaceValues = values
        self.assertLess(difference(expected, picture(self.view)), 0.002)
        display.IsosurfaceValues = [-1e9]
        empty = picture(self.view)
        self.assertEqual(difference(empty, empty * 0 + 255), 0)

    def test_polyhedra(self):
        """Of a linear field, they are the planes that Slice makes: no crack at shared faces, no gap."""
        meshes = (
            self.open(camaron_testing.EXAMPLES / "voronoi-ball.visf"),
            producer(gallery.mixed()),
        )
        for mesh in meshes:
            bounds = mesh.GetDataInformation().GetBounds()
            middle = [(bounds[2 * i] + bounds[2 * i + 1]) / 2 + 0.0123 for i in range(3)]
            field = simple.Calculator(
                Input=mesh, Function="coordsX+2*coordsY-3*coordsZ", ResultArrayName="Linear"
            )
            cut = simple.Slice(Input=mesh)
            cut.SliceType.Origin, cut.SliceType.Normal = middle, [1, 2, -3]
            expected = self.of_filter(cut)
            value = middle[0] + 2 * middle[1] - 3 * middle[2]
            _, made = self.inspect(field, "Linear", [value])
            self.assertLess(difference(expected, made), 0.004)
            self.assertGreater(difference(made, made * 0 + 255), 0.03)
            simple.HideAll(self.view)

    def test_selection(self):
        """The cells that are seen on the surfaces are those that the values meet."""
        source = self.tetrahedra()
        self.inspect(source, "RTData", VALUES)
        turn(self.view)
        cells = selected(self.view, source, "cells")
        self.assertGreater(len(cells), 100)
        data = self.fetch(source)
        array = data.GetPointData().GetArray("RTData")
        for _, _, cell in cells:
            points = data.GetCell(cell).GetPointIds()
            values = [array.GetValue(points.GetId(i)) for i in range(points.GetNumberOfIds())]
            self.assertTrue(
                any(sorted(values)[0] < value <= sorted(values)[-1] for value in VALUES)
            )


if __name__ == "__main__":
    camaron_testing.main()
