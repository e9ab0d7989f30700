# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The representation Mesh Inspection shows and selects what Surface does of the same cells."""

import math

import camaron_testing
import gallery
import numpy
from inspection_testing import difference, labels, make_view, picture, selected, turn
from mesh_parts import producer
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_LINE,
    VTK_POLY_LINE,
    VTK_POLY_VERTEX,
    VTK_QUADRATIC_QUAD,
    VTK_TETRA,
    VTK_TRIANGLE,
    VTK_VERTEX,
    vtkUnstructuredGrid,
)


def tetrahedra():
    mesh = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5]))
    return simple.PointAndCellIds(Input=mesh)


@camaron_testing.require_display()
class TestMeshInspection(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        self.view = make_view()
        self.addCleanup(simple.ResetSession)

    def show(self, source, representation, **properties):
        display = simple.Show(source, self.view)
        display.SetRepresentationType(representation)
        for name, value in properties.items():
            setattr(display, name, value)
        return display

    def compare(self, source, color=None, **properties):
        """Pictures of the same source as Surface and as Mesh Inspection without edges."""
        pictures = []
        for representation in ("Surface", "Mesh Inspection"):
            display = self.show(source, representation, DrawEdges=0, **properties)
            if color:
                simple.ColorBy(display, color)
            turn(self.view)
            pictures.append(picture(self.view))
        self.assertLess(difference(*pictures), 0.012)  # warped faces may be cut in two otherwise
        self.assertGreater(difference(pictures[0], pictures[0] * 0 + 255), 0.1)  # there is a mesh
        return pictures

    def inputs(self):
        yield "tetrahedra", tetrahedra()
        yield "polyhedra", producer(gallery.polyhedra())
        yield "mixed", producer(gallery.mixed())
        yield "curved", producer(gallery.bent(gallery.quadratic_mixed()))
        yield "curved tetrahedra", producer(gallery.bent(gallery.quadratic_tetrahedra()))
        yield "surface", simple.PointAndCellIds(
            Input=simple.Sphere(ThetaResolution=20, PhiResolution=20)
        )
        sphere = simple.Sphere(ThetaResolution=20, PhiResolution=20, Center=[9, 0, 0], Radius=4)
        yield "blocks", simple.GroupDatasets(
            Input=[tetrahedra(), simple.PointAndCellIds(Input=sphere)]
        )

    def test_same_picture_and_selection_as_surface(self):
        for name, source in self.inputs():
            with self.subTest(name):
                simple.HideAll(self.view)
                simple.UpdatePipeline(proxy=source)
                self.compare(source)
                sets = {}
                for representation in ("Surface", "Mesh Inspection"):
                    self.show(source, representation)
                    sets[representation] = [
                        selected(self.view, source, kind) for kind in ("cells", "points")
                    ]
                for surface, inspection in zip(sets["Surface"], sets["Mesh Inspection"]):
                    self.assertGreater(len(surface), 5)
                    self.assertEqual(surface, inspection)

    def test_levels_of_curved_cells(self):
        """Nonlinear Subdivision Level divides faces as on Surface; new points are neither selected nor drawn as points."""
        source = producer(gallery.bent(gallery.quadratic_mixed()))
        for level in (0, 3):
            with self.subTest(level):
                simple.HideAll(self.view)
                self.compare(source, NonlinearSubdivisionLevel=level)
                chosen = selected(self.view, source, "cells")
                # Surface has other ids at level 0 (ParaView 5.13).
                self.show(source, "Surface", NonlinearSubdivisionLevel=max(level, 1))
                expected = selected(self.view, source, "cells")
                self.assertGreater(len(chosen), 5)
                self.assertLessEqual(len(chosen ^ expected), 1)  # of a few pixels
        nodes = self.fetch(source).GetNumberOfPoints()
        for drawn in (0, 1):
            display = self.show(source, "Mesh Inspection", DrawEdges=0, DrawPoints=drawn)
            display.NonlinearSubdivisionLevel = 3
            points = selected(self.view, source, "points")
            self.assertGreater(len(points), 5)
            self.assertLess(max(point[-1] for point in points), nodes)
        display.DrawPointIds, display.NumberOfIds = 1, 1000
        simple.Render(self.view)
        self.assertLess(labels(self.view)[1].max(), nodes)
        display.DrawPointIds, display.DrawEdgeIds, display.DrawFaceIds = 0, 1, 1
        found = []
        for level in (0, 1, 3):
            display.NonlinearSubdivisionLevel = level
            simple.Render(self.view)
            found.append(set(zip(*labels(self.view)[:2])))
        self.assertGreater(len({kind for kind, _ in found[0]}), 1)
        for curved in found[1:]:  # the same edges and faces, in slightly other places
            self.assertGreater(len(curved & found[0]), 0.4 * len(found[0] | curved))

    def test_labels_between_nodes(self):
        """Integers at new points are those of a node: there are no labels between two others."""
        grid = vtkUnstructuredGrid()
        grid.SetPoints(vtkPoints())
        for point in [(0, 0), (2, 0), (2, 1), (0, 1), (1, 0), (2, 0.5), (1, 1), (0, 0.5)]:
            grid.GetPoints().InsertNextPoint(*point, 0.1 * point[0] * (2 - point[0]))
        grid.InsertNextCell(VTK_QUADRATIC_QUAD, 8, list(range(8)))
        for name, kind in (("label", int), ("number", float)):
            values = numpy.array([0, 100, 100, 0, 0, 100, 0, 0], kind)
            array = numpy_to_vtk(values, deep=True)
            array.SetName(name)
            grid.GetPointData().AddArray(array)
        source = producer(grid)
        pure = []
        for name in ("label", "number"):
            display = self.show(source, "Mesh Inspection", DrawEdges=0, Ambient=1, Diffuse=0)
            display.NonlinearSubdivisionLevel = 4
            simple.ColorBy(display, ("POINTS", name))
            table = simple.GetColorTransferFunction(name)
            table.ColorSpace, table.RGBPoints = "RGB", [0, 1, 0, 0, 100, 0, 0, 1]
            self.view.CameraPosition, self.view.CameraFocalPoint = [1, 0.5, 5], [1, 0.5, 0]
            shown = picture(self.view).reshape(-1, 3)
            shown = shown[(shown < 200).any(axis=1)]
            self.assertGreater(len(shown), 1000)
            pure.append((shown[:, [0, 2]].max(axis=1) > 245).mean())
        self.assertGreater(pure[0], 0.85)
        self.assertLess(pure[1], 0.6)

    def test_inside_of_curved_cells(self):
        """Isosurfaces are those of the functions of the cells: a sphere where these are of second order."""
        corners, cubes = gallery.lattice(2, 2, 2, lambda *place: place)
        cells = [(VTK_HEXAHEDRON, cube) for cube in cubes]
        grid = gallery.quadratic(gallery.make_grid(corners, cells))
        points = vtk_to_numpy(grid.GetPoints().GetData())
        low, high = points.min(axis=0), points.max(axis=0)
        center, radius = (low + high) / 2, 0.4 * (high - low).min()
        array = numpy_to_vtk(((points - center) ** 2).sum(axis=1), deep=True)
        array.SetName("distance")
        grid.GetPointData().AddArray(array)
        ball = simple.Sphere(Center=center, Radius=radius, ThetaResolution=180, PhiResolution=180)
        source = producer(grid)
        for shown in (ball, source):
            display = self.show(shown, "Surface" if shown is ball else "Mesh Inspection")
            display.ColorArrayName = ["POINTS", ""]
            self.view.CameraFocalPoint, self.view.CameraPosition = center, center + [9, 5, 4]
            self.view.CameraParallelProjection, self.view.CameraParallelScale = 1, 1.2 * radius
            if shown is ball:
                expected = picture(self.view)
                simple.HideAll(self.view)
        display.DrawFaces = display.DrawEdges = 0
        display.IsosurfaceArray, display.IsosurfaceValues = ["POINTS", "distance"], [radius**2]
        display.DrawIsosurfaces, unlike = 1, []
        background = expected[0, 0]
        for level in (0, 3):
            display.NonlinearSubdivisionLevel = level
            found = picture(self.view)
            covered = [(numpy.abs(p - background).max(axis=-1) > 8) for p in (expected, found)]
            unlike.append((covered[0] != covered[1]).mean() / covered[0].mean())
        self.assertLess(unlike[1], 0.02)
        self.assertLess(unlike[1], unlike[0] / 2)

    def test_colors(self):
        """Of cells and points, through a texture or not, on a log scale, with opacity, by categories."""
        source = tetrahedra()
        source.UpdatePipeline()
        self.compare(source, ("POINTS", "RTData"))
        self.compare(source, ("POINTS", "RTData"), InterpolateScalarsBeforeMapping=0)
        ids = "CellIds"
        self.compare(source, ("CELLS", ids))
        table = simple.GetColorTransferFunction(ids)
        table.RescaleTransferFunction(1, 5000)
        table.MapControlPointsToLogSpace()
        table.UseLogScale = 1
        self.compare(source, ("CELLS", ids))
        self.compare(source, ("CELLS", ids), Opacity=0.5)

    def test_colors_of_criteria(self):
        """As VTK maps them, which also has colors for values outside of the map, and so maps one value after the other."""
        mesh = producer(gallery.mixed())
        quality = simple.ElementQuality(Input=mesh, Criteria=["Volume"])
        quality.UpdatePipeline()
        grid = vtkUnstructuredGrid()
        grid.DeepCopy(servermanager.Fetch(quality))
        values = vtk_to_numpy(grid.GetCellData().GetArray("Volume"))
        values[:] = numpy.linspace(-0.2, 1.2, len(values))
        values[:4] = 0.5, math.nan, math.inf, -math.inf
        source = producer(grid)
        display = self.show(source, "Mesh Inspection")
        simple.ColorBy(display, ("CELLS", "Volume"))
        colors = simple.GetColorTransferFunction("Volume")
        colors.AutomaticRescaleRangeMode = "Never"
        colors.RGBPoints = [
            0,
            1,
            0.9,
            0.2,
            0.5,
            0.2,
            0.3,
            0.8,
            0.50001,
            0.9,
            0.2,
            0.1,
            1,
            0.1,
            0,
            0.3,
        ]
        colors.ColorSpace, colors.Discretize, colors.NanColor = "RGB", 0, [0, 1, 0]
        turn(self.view)
        ours = picture(self.view)
        colors.UseBelowRangeColor, colors.BelowRangeColor = 1, [1, 0.9, 0.2]
        numpy.testing.assert_array_equal(ours, picture(self.view))
        colors.RGBPoints = [0, 1, 0.9, 0.2, 1, 0.2, 0.3, 0.8]
        self.assertGreater(difference(ours, picture(self.view)), 0.02)

    def test_whole_cells_are_cut_as_select_elements_selects(self):
        source = tetrahedra()
        for cut, placement in (
            ("Centroid", "Centroid inside"),
            ("Any vertex", "Any vertex inside"),
            ("All vertices", "All vertices inside"),
        ):
            for keep in ("Inside", "Outside"):
                with self.subTest(cut=cut, keep=keep):
                    chosen = simple.SelectElements(
                        Input=source, Strategy="Shape", Shape="Sphere", Placement=placement
                    )
                    chosen.Shape.Center, chosen.Shape.Radius = [2.03, 1.51, 3.07], 4.43
                    kept = simple.Threshold(Input=chosen, Scalars=["CELLS", "Selected"])
                    value = 1 if keep == "Inside" else 0
                    kept.LowerThreshold = kept.UpperThreshold = value
                    simple.ColorBy(self.show(kept, "Surface"), None)
                    turn(self.view)
                    expected = picture(self.view)
                    simple.Hide(kept, self.view)
                    display = self.show(source, "Mesh Inspection", DrawEdges=0)
                    simple.ColorBy(display, None)
                    display.CutBy = cut
                    display.CutShape = "Sphere"
                    display.CutShape.Center, display.CutShape.Radius = [2.03, 1.51, 3.07], 4.43
                    display.CutKeeps = keep
                    self.assertLess(difference(expected, picture(self.view)), 0.004)
                    simple.Hide(source, self.view)
                    display.CutBy = "No cut"

    def test_half_spaces(self):
        """Planes of a table cut as the box that they make, and none cut nothing."""
        source = tetrahedra()
        display = self.show(source, "Mesh Inspection")
        turn(self.view)
        uncut = picture(self.view)
        display.CutBy, display.CutShape = "Any vertex", "Box"
        low, length = [-6, -2.3, 0.4], [5.1, 3.3, 6]
        display.CutShape.Position, display.CutShape.Length = low, length
        boxed = picture(self.view)
        self.assertGreater(difference(uncut, boxed), 0.02)
        display.CutShape = "HalfSpaces"
        self.assertEqual(difference(uncut, picture(self.view)), 0)
        high = [low[i] + length[i] for i in range(3)]
        planes = []
        for axis in range(3):
            normal = [3.0 if i == axis else 0.0 for i in range(3)]
            planes += [*high, *normal, *low, *(-value for value in normal)]
        display.CutShape.Planes = planes
        self.assertEqual(difference(boxed, picture(self.view)), 0)
        # A row that is not complete is told, and nothing is cut by a shape that nobody meant.
        display.CutShape.Planes = planes[:-1]
        with camaron_testing.messages() as told:
            self.assertEqual(difference(uncut, picture(self.view)), 0)
        self.assertIn(
            "a multiple of 6 numbers, a point and a normal for each plane, found 35", told()
        )

    def test_unit_of_coordinates(self):
        """Edges and normals are the same in any unit, and far from the origin: squares of them would not fit float."""
        mesh = tetrahedra()
        pictures = []
        for scale, offset in ((1, 0), (1e12, 0), (1e-9, 0), (1e-3, 1e7)):
            moved = simple.Calculator(
                Input=mesh,
                CoordinateResults=1,
                ResultArrayType="Double",
                Function=f"{scale}*coords + {offset}*iHat - {offset}*kHat",
            )
            display = self.show(moved, "Mesh Inspection", DrawNormals="Faces", SmoothShading=1)
            simple.ColorBy(display, ("POINTS", "RTData"))
            turn(self.view)
            pictures.append(picture(self.view))
            simple.Hide(moved, self.view)
        for other in pictures[1:]:
            self.assertLess(difference(pictures[0], other), 0.01)

    def wires(self):
        """A tetrahedron, a triangle, and lines and vertices of all kinds about them."""
        grid = vtkUnstructuredGrid()
        points = vtkPoints()
        for i in range(24):  # a coil; nothing is in one plane
            points.InsertNextPoint(math.cos(0.7 * i), math.sin(0.7 * i), 0.15 * i)
        grid.SetPoints(points)
        cells = (
            (VTK_TETRA, range(4)),
            (VTK_LINE, (4, 5)),
            (VTK_POLY_LINE, (6, 7, 8, 9)),
            (VTK_VERTEX, (10,)),
            (VTK_POLY_VERTEX, (11, 12, 13)),
            (VTK_TRIANGLE, (14, 15, 16)),
            (VTK_LINE, (17, 18)),
            (VTK_VERTEX, (19,)),
            (VTK_LINE, (20, 21)),
            (VTK_POLY_VERTEX, (22, 23)),
        )
        for kind, ids in cells:
            grid.InsertNextCell(kind, len(ids), list(ids))
        return simple.PointAndCellIds(Input=producer(grid))

    def test_lines_and_vertices(self):
        """Cells without faces are drawn, colored, selected and cut as the others."""
        source = self.wires()
        simple.UpdatePipeline(proxy=source)
        sets = []
        for color in (("CELLS", "CellIds"), ("POINTS", "PointIds")):
            pictures = []
            for representation in ("Surface", "Mesh Inspection"):
                display = self.show(source, representation, DrawEdges=0, LineWidth=3, PointSize=7)
                simple.ColorBy(display, color)
                turn(self.view)
                pictures.append(picture(self.view))
                sets.append([selected(self.view, source, kind) for kind in ("cells", "points")])
            self.assertLess(difference(*pictures), 0.0005)
            self.assertGreater(difference(pictures[0], pictures[0] * 0 + 255), 0.01)
        self.assertEqual(len(sets[0][0]), 10)
        self.assertTrue(all(found == sets[0] for found in sets))
        display.CutBy, display.CutShape = "Centroid", "Plane"
        display.CutShape.Origin, display.CutShape.Normal = [0, 0, 2.325], [0, 0, -1]
        kept = {cell for _, _, cell in selected(self.view, source, "cells")}
        self.assertEqual(kept, set(range(6)))
        display.CutKeeps = "Inside"
        kept = {cell for _, _, cell in selected(self.view, source, "cells")}
        self.assertEqual(kept, set(range(6, 10)))
        display.CutBy = "No cut"

    def test_nothing_but_a_line(self):
        """Empty tables of faces cause no error of OpenGL."""
        grid = vtkUnstructuredGrid()
        points = vtkPoints()
        points.InsertNextPoint(0, 0, 0)
        points.InsertNextPoint(1, 1, 1)
        grid.SetPoints(points)
        grid.InsertNextCell(VTK_LINE, 2, [0, 1])
        display = self.show(producer(grid), "Mesh Inspection", DiffuseColor=[0, 0, 0])
        turn(self.view)
        with camaron_testing.pipeline.Messages() as messages:
            for name, value in (
                ("ShrinkFactor", 0.7),
                ("ExplodeFactor", 0.5),
                ("FacesToDraw", "Complete"),
                ("CutBy", "Any vertex"),
            ):
                seen = picture(self.view)
                setattr(display, name, value)
                left = picture(self.view)
        self.assertEqual(messages.errors + messages.warnings, [])
        self.assertGreater((seen < 250).sum(), 100)
        self.assertEqual((left < 250).sum(), 0)

    def test_hidden_cells(self):
        """Hidden cells, those that finer ones stand for, and those at hidden points are not there."""
        data = self.fetch(tetrahedra())
        corners = vtk_to_numpy(data.GetCells().GetConnectivityArray()).reshape(-1, 4)
        cells = numpy.arange(len(corners)) > len(corners) / 2
        points = numpy.arange(data.GetNumberOfPoints()) > data.GetNumberOfPoints() / 2
        at_points = points[corners].any(axis=1)
        for hidden, given, bit in ((cells, cells, 32), (cells, cells, 8), (at_points, points, 2)):
            with self.subTest(bit=bit):
                pictures = []
                for representation, marks, value in (
                    ("Surface", hidden, 32),
                    ("Mesh Inspection", given, bit),
                ):
                    mesh = data.NewInstance()
                    mesh.ShallowCopy(data)
                    ghosts = numpy_to_vtk(
                        numpy.where(marks, value, 0).astype(numpy.uint8), deep=True
                    )
                    ghosts.SetName("vtkGhostType")
                    kind = 0 if marks is points else 1
                    mesh.GetAttributes(kind).AddArray(ghosts)
                    source = producer(mesh)
                    simple.ColorBy(
                        self.show(source, representation, DrawEdges=0), ("POINTS", "RTData")
                    )
                    if not pictures:
                        turn(self.view)
                    pictures.append(picture(self.view))
                    simple.Hide(source, self.view)
                self.assertLess(difference(*pictures), 0.004)
                self.assertGreater(difference(pictures[0], pictures[0] * 0 + 255), 0.1)

    def test_points_that_are_nowhere(self):
        """A point with NaN, one at infinity and one far away of no cell do not hide the rest of the mesh."""
        source = tetrahedra()
        data = self.fetch(source)
        mesh = data.NewInstance()
        mesh.DeepCopy(data)
        inner = 5 + 11 * 5 + 121 * 5
        mesh.GetPoints().SetPoint(inner, math.nan, 0, 0)
        mesh.GetPoints().SetPoint(inner + 1, math.inf, 0, 0)
        mesh.GetPoints().InsertNextPoint(1e30, 0, 0)
        for array in (mesh.GetPointData().GetArray(i) for i in range(2)):
            array.InsertNextTuple1(array.GetTuple1(0))
        color = ("POINTS", "RTData")
        expected = self.compare(source, color)[1]
        simple.HideAll(self.view)
        simple.ColorBy(self.show(producer(mesh), "Mesh Inspection", DrawEdges=0), color)
        turn(self.view)
        self.assertLess(difference(expected, picture(self.view)), 0.004)

    def test_cut_stays_in_view(self):
        """A plane across the line of sight stays so, wherever the camera goes."""
        source = tetrahedra()
        display = self.show(source, "Mesh Inspection")
        places = [[30, 10, 8], [-8, 30, 10]]  # equally far away
        self.view.CameraFocalPoint, self.view.CameraViewUp = [0, 0, 0], [0, 0, 1]
        self.view.CameraPosition = places[0]
        display.CutBy, display.CutShape, display.CutKeeps = "Centroid", "Plane", "Inside"
        display.CutShape.Origin, display.CutShape.Normal = [0, 0, 0], places[0]
        display.CutMovesWith = "View"
        first = picture(self.view)
        self.view.CameraPosition = places[1]
        stays = picture(self.view)
        display.CutMovesWith = "Mesh"
        self.assertGreater(difference(stays, picture(self.view)), 0.05)
        display.CutShape.Normal = places[1]
        self.assertLess(difference(stays, picture(self.view)), 0.004)
        self.view.CameraPosition = places[0]
        display.CutShape.Normal = places[0]
        self.assertEqual(difference(first, picture(self.view)), 0)


if __name__ == "__main__":
    camaron_testing.main()
