# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mesh Inspection without the graphics card: the same pictures and selections, made by VTK's filters."""

import camaron_testing
import gallery
from inspection_testing import PictureTestCase, difference, selected
from mesh_parts import producer
from paraview import simple


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
            for properties in (
                {"color": ("POINTS", "Elevation")},
                {"DrawEdges": 1, "EdgeColor": [1, 0, 0]},
                {"Opacity": 0.5},
            ):
                with self.subTest(**properties):
                    # Edges of triangles of polygons are VTK's, as wide as VTK draws them.
                    self.compare(mesh, 0.03 if "DrawEdges" in properties else 0.004, **properties)

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
