# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mesh Inspection without the graphics card: the same pictures and selections, made by VTK's filters."""

import camaron_testing
import gallery
import numpy
from inspection_testing import PictureTestCase, difference, selected
from mesh_parts import producer
from paraview import simple
from vtkmodules.vtkCommonDataModel import (
    VTK_CUBIC_LINE,
    VTK_LAGRANGE_CURVE,
    VTK_LAGRANGE_PYRAMID,
    VTK_POLY_LINE,
    VTK_QUADRATIC_EDGE,
    VTK_QUADRATIC_HEXAHEDRON,
    VTK_QUADRATIC_WEDGE,
)


def hexahedra():
    mesh = simple.AppendDatasets(Input=[simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5])])
    return simple.Elevation(
        Input=simple.PointAndCellIds(Input=mesh),
        LowPoint=[-5, -5, -5],
        HighPoint=[5, 5, 5],
        ScalarRange=[-1.0, 1.0],
    )


def polyhedra():
    mesh = simple.OpenDataFile(str(camaron_testing.EXAMPLES / "voronoi-ball.visf"))
    return simple.Elevation(
        Input=mesh, LowPoint=[-1, -1, -1], HighPoint=[1, 1, 1], ScalarRange=[-1.0, 1.0]
    )


@camaron_testing.require_display()
class TestInspectionProcessor(PictureTestCase):
    color_range = (-1.0, 1.0)

    def compare(self, mesh, tolerance=0.004, **properties):
        """Both pictures; the second one is made by the processor."""
        frame = simple.Outline(Input=mesh)
        pictures = []
        for draw_with in ("Graphics card", "Processor"):
            display = self.show(mesh, DrawWith=draw_with, **properties)
            pictures.append(self.take(frame))
        display.DrawWith = "Graphics card"
        self.same(*pictures, tolerance)
        return pictures

    def test_surface(self):
        for mesh in (hexahedra(), polyhedra()):
            for properties in ({"color": ("POINTS", "Elevation")}, {"Opacity": 0.5}):
                with self.subTest(**properties):
                    self.compare(mesh, **properties)

    def test_edges(self):
        """Of cells so large that the edges on the graphics card do not fade."""
        for mesh in (hexahedra(), producer(gallery.polyhedra())):
            # Edges of triangles of polygons are VTK's, as wide as VTK draws them.
            self.compare(mesh, 0.03, DrawEdges=1, EdgeColor=[1, 0, 0])

    def test_edges_of_curved_cells(self):
        """They are those of the cells, not of the parts into which faces are divided."""
        mesh = producer(gallery.bent(gallery.quadratic_mixed()))
        for level in (1, 3):
            for faces in (1, 0):
                with self.subTest(level=level, faces=faces):
                    red = []
                    for draw_with in ("Graphics card", "Processor"):
                        display = self.show(
                            mesh, DrawWith=draw_with, DrawEdges=1, EdgeColor=[1, 0, 0]
                        )
                        display.DrawFaces, display.NonlinearSubdivisionLevel = faces, level
                        shown = self.take()
                        red.append(((shown[..., 0] > 150) & (shown[..., 1] < 90)).mean())
                    self.assertGreater(red[0], 0.003)
                    self.assertLess(abs(red[1] - red[0]), 0.5 * red[0])

    def red(self, mesh, draw_with, faces=1, level=1, **properties):
        """The part of the picture that is edges."""
        display = self.show(
            mesh, DrawWith=draw_with, DrawEdges=1, EdgeColor=[1, 0, 0], **properties
        )
        display.DrawFaces, display.NonlinearSubdivisionLevel = faces, level
        if properties:
            display.CutShape.Center, display.CutShape.Radius = [0.8, 0.7, 0.9], 0.9
        shown = self.take()
        return ((shown[..., 0] > 150) & (shown[..., 1] < 90)).mean()

    def test_edges_of_exact_cuts(self):
        """Cells and their sections have edges, not the parts into which filters cut them."""
        for mesh in (gallery.mixed(), gallery.quadratic_mixed()):
            source = producer(gallery.bent(mesh))
            for faces, level in ((1, 1), (1, 2), (0, 2)):
                with self.subTest(faces=faces, level=level):
                    red = [
                        self.red(source, how, faces, level, CutBy="Exactly", CutShape="Sphere")
                        for how in ("Graphics card", "Processor")
                    ]
                    self.assertGreater(red[0], 0.003)
                    self.assertLess(abs(red[1] - red[0]), 0.5 * red[0])

    def test_collapsed_cells(self):
        """A quadratic wedge written as a hexahedron has the edges of a wedge; a Lagrange pyramid, for which VTK reports errors, is drawn by its vertices."""
        bottom = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0.5, -0.3, 0), (0.5, 0.5, 0), (0, 0.5, 0)]
        points = (
            bottom + [(x, y, 1) for x, y, _ in bottom] + [(x, y, 0.5) for x, y, _ in bottom[:3]]
        )
        native = (VTK_QUADRATIC_WEDGE, [0, 1, 2, 6, 7, 8, 3, 4, 5, 9, 10, 11, 12, 13, 14])
        other = (
            VTK_QUADRATIC_HEXAHEDRON,
            [0, 1, 2, 2, 6, 7, 8, 8, 3, 4, 2, 5, 9, 10, 8, 11, 12, 13, 14, 14],
        )
        for level in (1, 3):
            pictures = []
            for cell in (native, other):
                mesh = producer(gallery.make_grid(points, [cell], turns=False))
                self.red(mesh, "Processor", level=level)
                pictures.append(self.take())
            self.same(*pictures, 0.004)
        corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 1)]
        middles = [(0.5, 0.5, 0.1 * i) for i in range(9)]
        pyramid = [(VTK_LAGRANGE_PYRAMID, list(range(14)))]
        mesh = producer(gallery.make_grid(corners + middles, pyramid, turns=False))
        with camaron_testing.pipeline.Messages() as messages:
            red = [self.red(mesh, how, level=2) for how in ("Graphics card", "Processor")]
        self.assertGreater(red[0], 0.003)
        self.assertLess(abs(red[1] - red[0]), 0.5 * red[0])
        self.assertLessEqual(len(messages.errors + messages.warnings), 1)

    def test_curves(self):
        """Quadratic edges, cubic lines and Lagrange curves are divided as edges of faces are."""
        curves = (
            (VTK_QUADRATIC_EDGE, [0, 1, 0.5], [0, 0, 0.6]),
            (VTK_CUBIC_LINE, [0, 1, 1 / 3, 2 / 3], [0, 0, 0.5, -0.4]),
            (VTK_LAGRANGE_CURVE, [0, 1, 0.25, 0.5, 0.75], [0, 0, 0.5, -0.4, 0.5]),
        )
        for kind, t, height in curves:
            t, height = numpy.array(t), numpy.array(height)
            curve = numpy.polynomial.Polynomial.fit(t, height, len(t) - 1)
            nodes = [(x, 0.3 * x, y) for x, y in zip(t, height)]
            mesh = producer(gallery.make_grid(nodes, [(kind, list(range(len(t))))]))
            for level, parts in ((0, 1), (2, 4), (4, 16)):
                along = numpy.linspace(0, 1, parts + 1)
                points = [(x, 0.3 * x, float(curve(x))) for x in along] + nodes
                line = (VTK_POLY_LINE, list(range(parts + 1)))
                expected = producer(gallery.make_grid(points, [line]))
                frame = simple.Outline(Input=expected)
                for draw_with in ("Graphics card", "Processor"):
                    pictures = []
                    for shown in (mesh, expected):
                        display = self.show(shown, DrawWith=draw_with, LineWidth=4)
                        display.DiffuseColor = [0, 0, 0]
                        display.NonlinearSubdivisionLevel = level
                        pictures.append(self.take(frame))
                    with self.subTest(kind=kind, level=level, draw_with=draw_with):
                        self.assertLess(difference(*pictures), 0.001)
                        self.assertGreater(difference(pictures[0], pictures[0] * 0 + 255), 0.005)

            display = self.show(mesh, LineWidth=4)
            display.NonlinearSubdivisionLevel = 4
            self.take()
            points = {id for *_, id in selected(self.view, mesh, "points")}
            self.assertEqual(points, set(range(len(t))))

    def test_surface_is_made_once(self):
        """Moving the camera draws the same surface."""
        mesh = producer(gallery.bent(gallery.quadratic_mixed()))
        display = self.show(mesh, DrawWith="Processor", DrawEdges=1)
        display.NonlinearSubdivisionLevel = 2
        self.take()
        made = []
        for _ in range(3):
            self.view.CameraPosition = [1.1 * x for x in self.view.CameraPosition]
            simple.Render(self.view)
            actors = self.view.GetClientSideObject().GetRenderer().GetActors()
            mappers = [
                actors.GetItemAsObject(i).GetMapper() for i in range(actors.GetNumberOfItems())
            ]
            surfaces = [mapper.GetInput() for mapper in mappers if mapper and mapper.GetInput()]
            made.append([s.GetMTime() for s in surfaces if s.GetNumberOfPolys() > 0])
        self.assertGreater(len(made[0]), 0)
        self.assertEqual(made[0], made[1])
        self.assertEqual(made[0], made[2])

    def test_continuous_colors(self):
        """Colors of cells by a map that is no table; they follow its changes."""
        quality = simple.ElementQuality(Input=polyhedra(), Criteria=["MinDihedralAngle"])
        color, self.color_range = ("CELLS", "MinDihedralAngle"), None
        table = self.show(quality, color=color).LookupTable
        table.Discretize, table.AutomaticRescaleRangeMode = 0, "Never"
        before, _ = self.compare(quality, color=color)
        table.ColorSpace, table.RGBPoints = "RGB", [16, 1, 0, 0, 40, 0, 1, 0, 90, 0, 0, 1]
        after, _ = self.compare(quality, color=color)
        self.assertGreater(difference(before, after), 0.05)

    def test_cuts(self):
        for mesh in (hexahedra(), polyhedra()):
            display = self.show(mesh, CutShape="Sphere")
            scale = 0.2 * mesh.GetDataInformation().GetBounds()[1]
            display.CutShape.Center, display.CutShape.Radius = [
                2 * scale,
                scale,
                5 * scale,
            ], 3.6 * scale
            for cut in ("Centroid", "Any vertex", "All vertices", "Exactly"):
                for keeps in ("Inside", "Outside"):
                    with self.subTest(cut=cut, keeps=keeps):
                        # Clip's sphere is one of straight pieces.
                        tolerance = 0.02 if cut == "Exactly" else 0.004
                        color = ("POINTS", "Elevation")
                        self.compare(mesh, tolerance, color=color, CutBy=cut, CutKeeps=keeps)

    def test_isosurfaces(self):
        self.compare(
            polyhedra(),
            color=("POINTS", "Elevation"),
            DrawFaces=0,
            DrawIsosurfaces=1,
            IsosurfaceArray=["POINTS", "Elevation"],
            IsosurfaceValues=[-0.4, 0.0, 0.3],
        )

    def test_selections(self):
        """Also where a cut leaves other cells and points, in other places, than the mesh has."""
        mesh = hexahedra()
        frame = simple.Outline(Input=mesh)
        sets = []
        for draw_with in ("Graphics card", "Processor"):
            display = self.show(mesh, DrawWith=draw_with, CutBy="Any vertex", CutShape="Sphere")
            display.CutShape.Center, display.CutShape.Radius = [3, 3, 5], 4
            self.take(frame)
            sets.append([selected(self.view, mesh, kind) for kind in ("cells", "points")])
        self.assertGreater(min(map(len, sets[0])), 100)
        self.assertEqual(*sets)

    def test_selections_of_curved_cells(self):
        """New points between the nodes are no points of the mesh."""
        mesh = producer(gallery.bent(gallery.quadratic_mixed()))
        for level in (1, 3):
            for edges in (0, 1):
                sets = []
                for draw_with in ("Graphics card", "Processor"):
                    display = self.show(mesh, DrawWith=draw_with, DrawEdges=edges)
                    display.NonlinearSubdivisionLevel = level
                    self.take()
                    sets.append([selected(self.view, mesh, kind) for kind in ("cells", "points")])
                with self.subTest(level=level, edges=edges):
                    self.assertGreater(min(map(len, sets[0])), 5)
                    self.assertEqual(*sets)


if __name__ == "__main__":
    camaron_testing.main()
