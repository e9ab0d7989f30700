# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The render modes of Mesh Inspection: their pictures are those of ParaView pipelines that show the same."""

import camaron_testing
import numpy
from inspection_testing import difference, make_view, picture, turn
from paraview import simple

LOW, HIGH, NULL = [0.9, 0.1, 0.1], [0.1, 0.2, 1.0], [0.0, 0.6, 0.0]
GREY = [0.8, 0.8, 0.8]


def tetrahedra():
    mesh = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5]))
    return simple.PointAndCellIds(Input=mesh)


def table_of(display, low, high):
    """The transfer function of what colours a display, as a ramp from LOW to HIGH."""
    table = display.LookupTable
    table.AutomaticRescaleRangeMode = "Never"
    table.ColorSpace, table.NumberOfTableValues = "RGB", 1024
    table.RGBPoints = [low, *LOW, high, *HIGH]
    table.NanColor = NULL
    return table


@camaron_testing.require_display()
class TestInspectionModes(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        self.view = make_view()
        self.addCleanup(simple.ResetSession)

    def show(self, source, representation="Mesh Inspection", color=None, **properties):
        """The picture of a source alone, and its display."""
        simple.HideAll(self.view)
        display = simple.Show(source, self.view)
        display.SetRepresentationType(representation)
        if color or display.ColorArrayName[1]:
            simple.ColorBy(display, color)
        if color:
            display.SetScalarBarVisibility(self.view, False)
        display.DrawEdges = 0
        for name, value in properties.items():
            setattr(display, name, value)
        return display

    def take(self):
        turn(self.view)
        return picture(self.view)

    def same(self, one, other, tolerance=0.004):
        self.assertLess(difference(one, other), tolerance)
        self.assertGreater(difference(one, one * 0 + 255), 0.1)  # there is a mesh

    def elevation(self, mesh, low, high):
        """What Height and Depth do, as an array of the points on Surface."""
        heights = simple.Elevation(Input=mesh, LowPoint=low, HighPoint=high)
        display = self.show(heights, "Surface", ("POINTS", "Elevation"))
        table_of(display, 0, 1)
        return self.take()

    def test_height(self):
        """The direction may have any length; the ends are those of the bounds, here of a cube around 0."""
        mesh = tetrahedra()
        colors = {"LowColor": LOW, "HighColor": HIGH}
        self.show(mesh, Coloring="Height", **colors)
        self.same(self.take(), self.elevation(mesh, [0, 0, -5], [0, 0, 5]))
        direction = numpy.array([3.0, -4.0, 0.0])
        end = direction / 25 * 35  # the corner (5, -5) is 7 far in the direction of length 5
        display = self.show(mesh, Coloring="Height", HeightDirection=list(direction), **colors)
        self.same(self.take(), self.elevation(mesh, list(-end), list(end)))
        display = self.show(mesh, HeightDirection=[0, 1, 0], **colors)
        display.CustomColorRange, display.ColorRange = 1, [-2, 3]
        self.same(self.take(), self.elevation(mesh, [0, -2, 0], [0, 3, 0]))

    def test_depth(self):
        mesh = tetrahedra()
        self.show(mesh, Coloring="Depth", LowColor=LOW, HighColor=HIGH)
        depth = self.take()
        eye = numpy.array(self.view.CameraPosition)
        look = numpy.array(self.view.CameraFocalPoint) - eye
        look /= numpy.linalg.norm(look)
        distances = [(numpy.array([x, y, z]) - eye) @ look for x in (-5, 5) for y in (-5, 5) for z in (-5, 5)]
        ends = [list(eye + distance * look) for distance in (min(distances), max(distances))]
        self.same(depth, self.elevation(mesh, *ends))

    def test_two_colors(self):
        """Between the ends of the transfer function, whatever it looks like; null has its own colour."""
        mesh = simple.Calculator(Input=tetrahedra(), Function="sqrt(coordsX)", ResultArrayName="Root")
        for kind in ("POINTS", "CELLS"):
            with self.subTest(kind):
                source = simple.PointDatatoCellData(Input=mesh) if kind == "CELLS" else mesh
                display = self.show(source, "Surface", (kind, "Root"))
                table = table_of(display, 0.5, 2)
                # VTK takes texture coordinates next to a null point to be between null and a value.
                expected = self.take()
                table.RGBPoints = [0.5, 0, 0, 0, 2, 1, 1, 1]
                colors = {"LowColor": LOW, "HighColor": HIGH, "NullColor": NULL}
                display = self.show(source, color=(kind, "Root"), Coloring="Two colors", **colors)
                self.same(self.take(), expected, 0.004 if kind == "CELLS" else 0.03)
                table.RescaleTransferFunction(0, 9)
                display.CustomColorRange, display.ColorRange = 1, [0.5, 2]
                self.same(self.take(), expected, 0.004 if kind == "CELLS" else 0.03)

    def test_emphasis(self):
        """Cells out of the range keep their colour, all others are as grey as if the array were."""
        source = tetrahedra()
        source.UpdatePipeline()
        number = source.GetDataInformation().GetNumberOfCells()
        low, high = 0.7 * number, 0.95 * number
        ids = ("CELLS", "CellIds")
        self.show(source, color=ids)
        plain = self.take()
        display = self.show(source, color=ids, Emphasis="Outside range", Dimming=1)
        display.AcceptableRange = [low, high]
        emphasized = self.take()
        function = f"(CellIds>={low})*(CellIds<={high})"
        inside = simple.Calculator(Input=source, AttributeType="Cell Data", Function=function)
        display = self.show(inside, "Surface", ("CELLS", "Result"), Ambient=1, Diffuse=0)
        table_of(display, 0, 1).RGBPoints = [0, 0, 0, 0, 1, 1, 1, 1]
        is_inside = self.take().min(axis=2) > 128  # or background, which is white everywhere
        self.show(source, "Surface", AmbientColor=GREY, DiffuseColor=GREY)
        expected = numpy.where(is_inside[:, :, None], self.take(), plain)
        self.assertGreater(difference(expected, plain), 0.05)
        self.same(emphasized, expected)

    def test_acceptable_range_of_a_criterion(self):
        """An array that is a criterion has its own range; others have none."""
        mesh = simple.ElementQuality(Input=tetrahedra(), Criteria=["MinDihedralAngle", "Volume"])
        for name, isChanged in (("MinDihedralAngle", True), ("Volume", False)):
            color = ("CELLS", name)
            self.show(mesh, color=color)
            plain = self.take()
            self.show(mesh, color=color, Emphasis="Unacceptable", Dimming=1)
            self.assertEqual(difference(plain, self.take()) > 0.1, isChanged, name)

    def test_smooth_shading(self):
        """A ball of tetrahedra is lit like the sphere around it; a mesh with normals has those."""
        sphere = simple.Sphere(ThetaResolution=24, PhiResolution=24)  # with normals
        ball = simple.PassArrays(Input=simple.Delaunay3D(Input=sphere), PointDataArrays=[])
        self.show(ball, "Surface")
        flat = self.take()
        display = self.show(ball)
        self.same(self.take(), flat)
        display.SmoothShading = 1
        smooth = self.take()
        self.assertGreater(difference(flat, smooth, 6), 0.03)
        self.show(sphere, "Surface")
        expected = self.take()
        self.assertLess(difference(smooth, expected, 6), 0.003)
        display.Interpolation = "Flat"
        self.show(ball)
        self.same(self.take(), flat)
        self.show(sphere)
        self.assertLess(difference(self.take(), expected, 6), 0.003)

    def test_smooth_shading_of_edges(self):
        """Edges of a cube stay sharp, and become round when the angle allows it; faces in a cut are flat."""
        mesh = tetrahedra()
        self.show(mesh)
        flat = self.take()
        display = self.show(mesh, SmoothShading=1)
        self.assertLess(difference(flat, self.take(), 3), 0.002)
        display.SmoothAngle = 90
        self.assertGreater(difference(flat, self.take(), 12), 0.02)
        self.show(mesh, CellsToDraw="All", FacesToDraw="Interior", SmoothShading=0)
        inside = self.take()
        self.show(mesh, SmoothShading=1)
        self.assertLess(difference(inside, self.take(), 3), 0.002)


if __name__ == "__main__":
    camaron_testing.main()
