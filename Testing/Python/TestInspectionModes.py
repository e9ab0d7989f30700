# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The render modes of Mesh Inspection: their pictures are those of ParaView pipelines that show the same."""

import camaron_testing
import gallery
import numpy
from inspection_testing import PictureTestCase, difference, picture, selected, turn
from mesh_parts import producer
from paraview import simple
from TestQualityColors import make
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

LOW, HIGH, NULL = [0.9, 0.1, 0.1], [0.1, 0.2, 1.0], [0.0, 0.6, 0.0]
GRAY = [0.8, 0.8, 0.8]
BLACK, RED = [0, 0, 0], [1, 0, 0]


def tetrahedra():
    mesh = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5]))
    return simple.PointAndCellIds(Input=mesh)


def red(image):
    """Where a picture is red."""
    return (image[:, :, 0] > 128) & (image[:, :, 1] < 64)


def colors_of(acceptable):
    """The color map of a criterion for values from 0 to 60."""
    values, colors, _ = make(0, 60, acceptable)
    return list(numpy.column_stack([values, colors]).ravel())


def picked(view, source, x, y):
    """What a click selects."""
    simple.ClearSelection(source)
    simple.SelectSurfaceCells(Rectangle=[x, y, x, y], View=view)
    selection = source.SMProxy.GetSelectionInput(source.Port)
    ids = selection.GetProperty("Input").GetProxy(0).GetProperty("IDs")
    simple.ClearSelection(source)
    return {(-1, ids.GetElement(0), ids.GetElement(1))}


def unlike(one, other):
    """Part of the marked pixels of either picture that have none of the other within one pixel."""
    wide = lambda marks: sum(
        numpy.roll(marks, (i, k), (0, 1)).astype(int) for i in (-1, 0, 1) for k in (-1, 0, 1)
    )
    lonely = (one & (wide(other) == 0)) | (other & (wide(one) == 0))
    return lonely.sum() / max((one | other).sum(), 1)


def table_of(display, low, high):
    """The transfer function of what colors a display, as a ramp from LOW to HIGH."""
    table = display.LookupTable
    table.AutomaticRescaleRangeMode = "Never"
    table.ColorSpace, table.NumberOfTableValues = "RGB", 1024
    table.RGBPoints = [low, *LOW, high, *HIGH]
    table.NanColor = NULL
    return table


@camaron_testing.require_display()
class TestInspectionModes(PictureTestCase):
    def show_too(self, source, representation="Mesh Inspection", **properties):
        """With what is shown already."""
        display = simple.Show(source, self.view)
        display.SetRepresentationType(representation)
        display.DrawNormals, display.DrawPoints, display.DrawEdges = "None", 0, 0
        for name, value in properties.items():
            setattr(display, name, value)

    def test_dense_edges(self):
        """Edges do not vanish where cells are large, and fade where they would hide the colors: also those of long cells,
        and those of triangles and quadrilaterals alike."""
        inside = (slice(110, 190), slice(160, 240))

        def hidden(columns, rows, as_triangles):
            """The part of a color that black edges hide."""
            plane = simple.Plane(XResolution=columns, YResolution=rows)
            mesh = simple.Triangulate(Input=plane) if as_triangles else plane
            self.show(mesh, DrawEdges=1, EdgeColor=BLACK, EdgeOpacity=1, Ambient=1, Diffuse=0)
            simple.ResetCamera(self.view)
            return 1 - picture(self.view)[inside].mean() / 255

        self.show(simple.Plane())
        self.view.CameraPosition, self.view.CameraFocalPoint = [0, 0, 1], [0, 0, 0]
        self.view.CameraViewUp = [0, 1, 0]
        for as_triangles in (False, True):
            amounts = {
                cells: hidden(*cells, as_triangles)
                for cells in ((8, 8), (20, 20), (30, 30), (70, 70), (300, 300), (6, 90))
            }
            with self.subTest(as_triangles=as_triangles, amounts=amounts):
                self.assertGreater(amounts[8, 8], 0.03)
                self.assertGreater(amounts[20, 20], 0.08)
                self.assertLess(max(amounts.values()), 0.3)
                self.assertLess(amounts[6, 90], 0.2)
                self.assertLess(amounts[300, 300], 0.001)

    def test_small_bad_cells(self):
        """A cell beyond the limit of a criterion is drawn some pixels wide, however small it is, and can be picked there;
        cells that are undefined or not judged, and those in other colors, are as large as they are.
        """
        side = 250
        plane = self.fetch(simple.Plane(XResolution=side, YResolution=side))
        here = side * side // 2 + side // 2
        self.view.InteractionMode = "2D"

        def show(bad, acceptable=(20, None), points=None):
            values = numpy.full(side * side, 60.0)
            values[here] = bad
            array = numpy_to_vtk(values, deep=True)
            array.SetName("MinInteriorAngle")
            data = plane.NewInstance()
            data.ShallowCopy(plane)
            data.GetCellData().AddArray(array)
            mesh = producer(data)
            display = self.show(mesh, color=("CELLS", array.GetName()), Ambient=1, Diffuse=0)
            table = display.LookupTable
            table.AutomaticRescaleRangeMode, table.ColorSpace = "Never", "RGB"
            table.RGBPoints = points or colors_of(acceptable)
            table.NanColor = RED
            simple.ResetCamera(self.view)
            simple.Render(self.view)
            return mesh, display

        def count():
            """Pixels that are red rather than blue."""
            taken = picture(self.view)
            return int((taken[:, :, 0] > taken[:, :, 2] + 60).sum())

        mesh, display = show(5)
        found = count()
        self.assertGreaterEqual(found, 6)
        self.assertLess(found, 64)
        taken = picture(self.view)
        y, x = numpy.argwhere(taken[:, :, 0] > taken[:, :, 2] + 60).mean(axis=0).astype(int)
        self.assertIn((-1, 0, here), picked(self.view, mesh, x, y))
        display.Emphasis = "Unacceptable"
        self.assertEqual(count(), found)
        show(20)
        self.assertEqual(count(), 0, "the limit is acceptable")
        show(5, (None, 50))
        self.assertGreater(count(), 5000, "all others are bad")
        show(5, points=[0, *RED, 19, *RED, 20, 0, 0, 1, 60, 0, 0, 1])
        self.assertLess(count(), 4, "another color map")
        show(float("nan"))
        self.assertLess(count(), 4, "undefined")

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
        distances = [
            (numpy.array([x, y, z]) - eye) @ look for x in (-5, 5) for y in (-5, 5) for z in (-5, 5)
        ]
        ends = [list(eye + distance * look) for distance in (min(distances), max(distances))]
        self.same(depth, self.elevation(mesh, *ends))

    def test_two_colors(self):
        """Between the ends of the transfer function, whatever it looks like; undefined values have their own color."""
        mesh = simple.Calculator(
            Input=tetrahedra(), Function="sqrt(coordsX)", ResultArrayName="Root"
        )
        for kind in ("POINTS", "CELLS"):
            with self.subTest(kind):
                source = simple.PointDatatoCellData(Input=mesh) if kind == "CELLS" else mesh
                display = self.show(source, "Surface", (kind, "Root"))
                table = table_of(display, 0.5, 2)
                # VTK takes texture coordinates next to a null point to be between null and a value.
                expected = self.take()
                table.RGBPoints = [0.5, 0, 0, 0, 2, 1, 1, 1]
                colors = {"LowColor": LOW, "HighColor": HIGH, "UndefinedColor": NULL}
                display = self.show(source, color=(kind, "Root"), Coloring="Two colors", **colors)
                self.same(self.take(), expected, 0.004 if kind == "CELLS" else 0.03)
                table.RescaleTransferFunction(0, 9)
                display.CustomColorRange, display.ColorRange = 1, [0.5, 2]
                self.same(self.take(), expected, 0.004 if kind == "CELLS" else 0.03)

    def test_what_sticks_out(self):
        """The first picture after cells moved, or lines grew, is not cut off where the mesh was before."""
        mesh = tetrahedra()
        display = self.show(mesh, DrawNormals="Faces")
        for name, value in (("ExplodeFactor", 4), ("ExplodeFactor", 0), ("NormalLength", 1.5)):
            with self.subTest(name, value=value):
                turn(self.view)
                self.view.CameraPosition = [60, 40, 90]
                setattr(display, name, value)
                first = picture(self.view)
                display.SpecularPower = (
                    100 + value
                )  # anything that makes the view look at the bounds again
                self.assertLess(difference(first, picture(self.view)), 0.0005)

    def test_values_far_from_zero(self):
        """Doubles that differ little, as pressures do, look as those around zero."""
        near = simple.Calculator(
            Input=tetrahedra(), Function="coordsX + coordsY/8", ResultArrayName="Near"
        )
        far = simple.Calculator(Input=near, Function="Near - 1000000000", ResultArrayName="Far")
        pictures = {"Near": [], "Far": []}
        for name, origin in (("Near", 0), ("Far", -1e9)):
            array = ["POINTS", name]
            values = [origin - 3, origin + 0.3, origin + 2.5]
            display = self.show(
                far, DrawFaces=0, DrawIsosurfaces=1, IsosurfaceArray=array, IsosurfaceValues=values
            )
            pictures[name].append(self.take())
            display.DrawFaces, display.DrawIsosurfaces = 1, 0
            lines = {"IsolineFirst": origin + 0.5, "IsolineSpacing": 1.5, "IsolineWidth": 2}
            self.show(far, DrawIsolines=1, IsolineArray=array, **lines)
            pictures[name].append(self.take())
            display.DrawIsolines = 0
            ramp = {"LowColor": LOW, "HighColor": HIGH, "CustomColorRange": 1}
            self.show(
                far, color=array, Coloring="Two colors", ColorRange=[origin - 2, origin + 3], **ramp
            )
            pictures[name].append(self.take())
            display.Coloring = "Transfer function"
        for near_picture, far_picture in zip(*pictures.values()):
            self.same(far_picture, near_picture)
        for i in (0, 1):
            self.assertGreater(difference(pictures["Near"][i], pictures["Near"][i + 1]), 0.05)

    def test_emphasis(self):
        """Cells out of the range keep their color, all others are as gray as if the array were; or
        the other way around."""
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
        display.Emphasis = "Inside range"
        emphasized_inside = self.take()
        function = f"(CellIds>={low})*(CellIds<={high})"
        inside = simple.Calculator(Input=source, AttributeType="Cell Data", Function=function)
        display = self.show(inside, "Surface", ("CELLS", "Result"), Ambient=1, Diffuse=0)
        table_of(display, 0, 1).RGBPoints = [0, 0, 0, 0, 1, 1, 1, 1]
        is_inside = self.take().min(axis=2) > 128  # or background, which is white everywhere
        self.show(source, "Surface", AmbientColor=GRAY, DiffuseColor=GRAY)
        expected = numpy.where(is_inside[:, :, None], self.take(), plain)
        self.assertGreater(difference(expected, plain), 0.05)
        self.same(emphasized, expected)
        self.same(emphasized_inside, numpy.where(is_inside[:, :, None], plain, self.take()))

    def test_acceptable_range_of_a_criterion(self):
        """An array that is a criterion has its own range; others have none."""
        mesh = simple.ElementQuality(Input=tetrahedra(), Criteria=["MinDihedralAngle", "Volume"])
        for name, isChanged in (("MinDihedralAngle", True), ("Volume", False)):
            color = ("CELLS", name)
            self.show(mesh, color=color)
            plain = self.take()
            self.show(mesh, color=color, Emphasis="Unacceptable", Dimming=1)
            self.assertEqual(difference(plain, self.take()) > 0.1, isChanged, name)

    def test_acceptable_range_of_other_shapes(self):
        """A range for tetrahedra lets no polyhedron stand out."""
        ball = simple.OpenDataFile(str(camaron_testing.EXAMPLES / "voronoi-ball.visf"))
        mesh = simple.ElementQuality(Input=ball, Criteria=["EdgeLengthRatio"])
        for emphasis, colors in (("None", True), ("Unacceptable", False)):
            self.show(mesh, color=("CELLS", "EdgeLengthRatio"), Emphasis=emphasis, Dimming=1)
            picture = self.take().astype(int)
            # Lights of ParaView have a tint of their own.
            self.assertEqual(bool((numpy.ptp(picture, axis=2) > 60).any()), colors, emphasis)

    def test_not_judged(self):
        """Cells that the range of the criterion is not for have a color of the map for none of its values."""
        ball = simple.OpenDataFile(str(camaron_testing.EXAMPLES / "voronoi-ball.visf"))
        for mesh, isJudged in ((tetrahedra(), True), (ball, False)):
            mesh = simple.ElementQuality(Input=mesh, Criteria=["MinDihedralAngle"])
            for below, discrete in ((0, 0), (1, 0), (0, 1), (1, 1)):
                display = self.show(mesh, color=("CELLS", "MinDihedralAngle"), Ambient=1, Diffuse=0)
                table = table_of(display, 0, 1)
                table.BelowRangeColor, table.UseBelowRangeColor = RED, below
                table.Discretize, display.MarkCellsNotJudged = discrete, 0
                plain = self.take()
                display.MarkCellsNotJudged = 1
                marked = self.take()
                with self.subTest(judged=isJudged, below=below, discrete=discrete):
                    self.assertEqual(difference(plain, marked) == 0, isJudged)
                    mesh_pixels = (plain != 255).any(axis=2)
                    color = numpy.round(255 * numpy.array(RED if below else NULL))
                    isMarked = abs(marked - color).max(axis=2) <= 1
                    self.assertEqual(isMarked[mesh_pixels].mean() > 0.9, not isJudged)
        for isKnown in (0, 1):  # that the faces are of polyhedra
            surface = simple.MeshSurface(Input=mesh, PassThroughShapes=isKnown)
            display = self.show(surface, color=("CELLS", "MinDihedralAngle"), Ambient=1, Diffuse=0)
            plain = self.take()
            display.MarkCellsNotJudged = 1
            self.assertEqual(difference(plain, self.take()) > 0.1, isKnown == 1)

    def test_judged_below_the_map(self):
        """Values below the color map are not taken for cells that are not judged, which have the color below it."""
        mesh = simple.ElementQuality(Input=producer(gallery.mixed()), Criteria=["MinDihedralAngle"])
        display = self.show(mesh, color=("CELLS", "MinDihedralAngle"), Ambient=1, Diffuse=0)
        table = table_of(display, 100, 120)  # one tetrahedron, and all others, are below
        table.BelowRangeColor, table.UseBelowRangeColor, display.MarkCellsNotJudged = RED, 1, 1
        for table.Discretize in (0, 1):
            taken = self.take()
            for color in (LOW, RED):
                distance = abs(taken - numpy.round(255 * numpy.array(color))).max(axis=2)
                self.assertGreater((distance <= 1).mean(), 0.001, (color, table.Discretize))

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

    def lines(self, starts, directions, length):
        """A source of the lines from `starts` along unit vectors."""
        lines = vtkPolyData()
        points = numpy.stack([starts, starts + length * directions], axis=1).reshape(-1, 3)
        lines.SetPoints(vtkPoints())
        lines.GetPoints().SetData(numpy_to_vtk(points, deep=True))
        cells = vtkCellArray()
        for i in range(len(starts)):
            cells.InsertNextCell(2, [2 * i, 2 * i + 1])
        lines.SetLines(cells)
        return producer(lines)

    def outside(self, mesh):
        """Centroids and unit normals of the outer triangles of a mesh, and its points with theirs."""
        surface = self.fetch(simple.ExtractSurface(Input=mesh))
        points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
        corners = points[vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
        areas = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        sums = numpy.zeros_like(points)
        ids = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        for k in range(3):
            numpy.add.at(sums, ids[:, k], areas)
        unit = lambda rows: rows / numpy.linalg.norm(rows, axis=1)[:, None]
        return (corners.mean(axis=1), unit(areas)), (points, unit(sums))

    def test_edges_alone(self):
        """Lines that are whole wherever they are, also at the outline and when one ends behind the camera."""
        mesh = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2]))
        edges = simple.ExtractEdges(Input=simple.ExtractSurface(Input=mesh))
        shown = {}
        for width, place in ((1, None), (3, None), (2, [0.3, 0.2, 1.1])):
            with self.subTest(width=width, place=place):
                pictures = []
                for source, representation in ((edges, "Surface"), (mesh, "Mesh Inspection")):
                    display = self.show(source, representation, LineWidth=width)
                    display.DiffuseColor = display.AmbientColor = display.EdgeColor = RED
                    if source == mesh:
                        display.DrawEdges, display.DrawFaces = 1, 0
                    turn(self.view)
                    self.view.CameraPosition = place or self.view.CameraPosition
                    pictures.append(
                        picture(self.view).min(axis=2) < 160
                    )  # more than a third of a pixel
                self.assertLess(unlike(*pictures), 0.01)
                shown[width] = pictures[1].sum()
        self.assertGreater(min(shown.values()), 3000)
        self.assertGreater(shown[3], 2 * shown[1])

    def test_normals(self):
        """Lines where a source of lines has them; those of a polygon once; none where nothing is visible."""
        mesh = simple.PassArrays(Input=tetrahedra(), PointDataArrays=[], CellDataArrays=[])
        mesh.UpdatePipeline()
        for which, (starts, directions) in zip(("Faces", "Vertices"), self.outside(mesh)):
            with self.subTest(which):
                lines = self.lines(starts, directions, 1.5)
                self.show(lines, "Surface", LineWidth=2, DiffuseColor=RED, AmbientColor=RED)
                self.show_too(mesh, DiffuseColor=BLACK, AmbientColor=BLACK)
                reference = self.take()
                display = self.show(mesh, LineWidth=2, NormalColor=RED)
                display.DrawNormals, display.NormalLength = which, 1.5 / (10 * 3**0.5)
                self.assertLess(unlike(red(picture(self.view)), red(reference)), 0.01)
                self.assertGreater(red(reference).mean(), 0.02)
                display.CutShape = "Sphere"
                display.CutShape.Radius = 100
                display.CutBy = "Any vertex"
                self.assertEqual(difference(picture(self.view), reference * 0 + 255), 0)
                display.CutBy, display.DrawNormals = "No cut", "None"

    def test_normals_of_polygons(self):
        """One line for each polygon of a polyhedron, from the centroid of its area."""
        mesh = producer(gallery.polyhedra())
        shared = {"LineWidth": 2, "DiffuseColor": BLACK, "AmbientColor": BLACK}
        self.show(
            mesh, DrawFaces=0, DrawNormals="Faces", NormalLength=0.1, NormalColor=RED, **shared
        )
        found = self.take()
        surface = self.fetch(simple.ExtractSurface(Input=mesh))
        points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
        starts, directions = [], []
        for i in range(surface.GetNumberOfCells()):
            ids = surface.GetCell(i).GetPointIds()
            corners = points[[ids.GetId(k) for k in range(ids.GetNumberOfIds())]]
            fans = [corners[k : k + 2] - corners[0] for k in range(1, len(corners) - 1)]
            areas = [numpy.cross(*fan) for fan in fans]
            sizes = numpy.linalg.norm(areas, axis=1)
            starts.append(corners[0] + sizes @ [fan.sum(axis=0) / 3 for fan in fans] / sizes.sum())
            directions.append(sum(areas) / numpy.linalg.norm(sum(areas)))
        diagonal = numpy.linalg.norm(points.max(axis=0) - points.min(axis=0))
        lines = self.lines(numpy.array(starts), numpy.array(directions), 0.1 * diagonal)
        self.show(lines, "Surface", LineWidth=2, DiffuseColor=RED, AmbientColor=RED)
        self.show_too(mesh, DrawFaces=0, **shared)
        self.assertLess(unlike(red(found), red(picture(self.view))), 0.01)
        self.assertGreater(red(found).sum(), 500)

    def test_points(self):
        """All points of the cells that are drawn, those inside too, colored as everything."""
        mesh = tetrahedra()
        cloud = simple.MaskPoints(Input=mesh, OnRatio=1, MaximumNumberofPoints=10000)
        cloud.GenerateVertices = cloud.SingleVertexPerCell = 1
        shared = {"PointSize": 3, "DiffuseColor": BLACK, "AmbientColor": BLACK}
        for color in (None, ("POINTS", "RTData")):
            with self.subTest(color=color):
                self.show(cloud, "Points", color, **shared)
                reference = self.take()
                display = self.show(mesh, color=color, DrawPoints=1, DrawFaces=0, **shared)
                self.same(self.take(), reference, 0.01)
        display.CutBy, display.CutShape = "Any vertex", "Sphere"
        display.CutShape.Center, display.CutShape.Radius = [0, 0, 0], 5.9
        self.assertLess((self.take() < 250).sum(), 0.7 * (reference < 250).sum())
        self.assertGreater((self.take() < 250).sum(), 100)
        display.CutBy = "No cut"

    def test_selection_with_lines_and_points(self):
        """Cells and points are selected as without; of points alone, those inside too."""
        mesh = tetrahedra()
        display = self.show(mesh)
        turn(self.view)
        found = lambda: [selected(self.view, mesh, kind) for kind in ("cells", "points")]
        expected = found()
        display.DrawNormals = "Faces"
        self.assertEqual(found(), expected)
        display.DrawNormals, display.DrawPoints, display.PointSize = "None", 1, 5
        self.assertEqual(found(), expected)
        display.DrawFaces = 0
        self.assertGreater(len(found()[1]), len(expected[1]))


if __name__ == "__main__":
    camaron_testing.main()
