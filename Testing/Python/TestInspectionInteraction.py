# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""What Mesh Inspection draws while the camera moves: above ParaView's threshold the same picture of a coarser mesh."""

import camaron_testing
import TestClientServer
from inspection_testing import PictureTestCase, difference, make_view, picture, turn
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter


def interactive_picture(view):
    """As picture(), of what is seen while the camera moves."""
    view.SMProxy.InteractiveRender()
    grab = vtkWindowToImageFilter()
    grab.SetInput(view.SMProxy.GetRenderWindow())
    grab.ShouldRerenderOff()
    grab.ReadFrontBufferOff()
    grab.Update()
    image = grab.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3).astype(int)


def tetrahedra(size):
    wavelet = simple.Wavelet(WholeExtent=[-size, size, -size, size, -size, size])
    mesh = simple.Tetrahedralize(Input=wavelet)
    mesh.UpdatePipeline()
    return mesh


def silhouette(one):
    """1 where there is something before the white background."""
    return (one.min(axis=-1, keepdims=True) < 250) * 255


@camaron_testing.require_display()
class TestInspectionInteraction(PictureTestCase):
    def setUp(self):
        super().setUp()
        self.view.LODThreshold, self.view.LODResolution = 0, 0

    def compare(self, inside=0.2, outline=0.02):
        """The two pictures are not the same, and yet alike."""
        whole = self.take()
        coarse = interactive_picture(self.view)
        self.assertGreater(difference(whole, coarse), 0)
        self.assertLess(difference(whole, coarse, 60), inside)
        self.assertLess(difference(silhouette(whole), silhouette(coarse)), outline)
        self.assertGreater(difference(whole, whole * 0 + 255), 0.03)
        self.assertEqual(difference(whole, picture(self.view)), 0)  # it is back
        return whole, coarse

    def test_whole_and_cut(self):
        """With lines and vertices, and drawn by the processor."""
        mesh = tetrahedra(8)
        self.show(mesh, color=("POINTS", "RTData"))
        self.compare()
        shape = {"CutShape": "Sphere", "CutBy": "Centroid"}
        for properties in (
            {},
            {"CutBy": "Exactly"},
            {"ColorCutFaces": 1},
            {"GlassShell": 1},
            {"Opacity": 0.5},
            {"CellsToDraw": "All", "ShrinkFactor": 0.7},
            {"DrawNormals": "Faces"},
            {"DrawWith": "Processor"},
            {"BackfaceRepresentation": "Surface"},
        ):
            with self.subTest(properties):
                display = self.show(mesh, color=("POINTS", "RTData"), **{**shape, **properties})
                display.CutShape.Center, display.CutShape.Radius = [6, 4, 10], 8
                # Cut by its own cells, which are large here.
                self.compare(inside=0.35, outline=0.05)
                simple.Delete(display)

    def test_isosurfaces(self):
        mesh = tetrahedra(8)
        self.show(
            mesh,
            DrawFaces=0,
            DrawIsosurfaces=1,
            IsosurfaceArray=["POINTS", "RTData"],
            IsosurfaceValues=[130],
        )
        self.compare(outline=0.1)

    def test_surface_and_blocks(self):
        """Blocks look each as they do."""
        self.show(simple.Sphere(ThetaResolution=200, PhiResolution=200), DrawEdges=1)
        self.compare(outline=0.01)
        blocks = simple.GroupDatasets(
            Input=[tetrahedra(6), simple.Sphere(Center=[12, 0, 0], Radius=4, PhiResolution=60)]
        )
        blocks.BlockNames = ["A", "B"]
        display = self.show(blocks, color=None)
        display.BlockColors = ["/Root/B", "1", "0", "0"]
        for image in self.compare():
            self.assertGreater(
                ((image[:, :, 0] > 100) & (image[:, :, 1:].max(axis=2) < 50)).sum(), 1000
            )
        display.BlockSelectors = ["/Root/B"]
        self.compare()

    def test_threshold(self):
        """What is below the threshold, or is once it is drawn, is drawn as it is."""
        mesh = tetrahedra(16)  # 164 thousand in 8 MB; the 12 thousand triangles outside are 0.5 MB
        display = self.show(mesh)
        for threshold in (2, 1000):
            self.view.LODThreshold = threshold
            self.assertEqual(difference(self.take(), interactive_picture(self.view)), 0)
        self.view.LODThreshold = 2
        display.FacesToDraw = "Complete"
        display.ShrinkFactor = 0.8
        self.assertGreater(difference(self.take(), interactive_picture(self.view)), 0)

    def test_made_when_it_moves(self):
        """The coarse mesh takes longer than the first picture, which does not show it."""
        wavelet = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
        self.show(simple.Tetrahedralize(Input=wavelet))
        manager = self.view.GetClientSideObject().GetDeliveryManager()

        def has_coarse_mesh():
            """Else the whole mesh counts for it."""
            return manager.GetVisibleDataSize(True) < manager.GetVisibleDataSize(False)

        # Of 6 MB, less than 2 are outside.
        for size, threshold, is_made in ((10, 0, True), (14, 2, False), (14, 0, True)):
            wavelet.WholeExtent = [-size, size] * 3
            self.view.LODThreshold = threshold
            self.take()
            self.assertFalse(has_coarse_mesh(), (size, threshold))
            interactive_picture(self.view)
            self.assertEqual(has_coarse_mesh(), is_made, (size, threshold))

    def test_outline(self):
        """Nothing but the box, if ParaView's settings say so."""
        self.show(tetrahedra(6), DiffuseColor=[1, 0, 0], AmbientColor=[1, 0, 0])
        self.view.UseOutlineForLODRendering = 1
        whole = self.take()
        outline = interactive_picture(self.view)
        self.assertLess(
            difference(outline, outline * 0 + 255), 0.1 * difference(whole, whole * 0 + 255)
        )
        self.assertGreater(difference(outline, outline * 0 + 255), 0)


@camaron_testing.require_display()
class TestInteractionServer(camaron_testing.TestCase):
    serve = TestClientServer.TestClientServer.serve

    def test_servers(self):
        """Drawn on the server, or there only while the camera stands still: then the coarse mesh comes over."""
        for ranks in (1, 2):
            self.serve(ranks)
            mesh = tetrahedra(16)
            size = mesh.GetDataInformation().GetMemorySize() / 1024
            for threshold, opacity in ((0, 0.5), (0.7 * size, 1)):
                with self.subTest(ranks=ranks, threshold=threshold, opacity=opacity):
                    view = make_view()
                    view.RemoteRenderThreshold, view.LODThreshold = threshold, 0
                    view.LODResolution, view.ImageReductionFactor = 0, 1
                    display = simple.Show(mesh, view)
                    display.SetRepresentationType("Mesh Inspection")
                    simple.ColorBy(display, ("POINTS", "RTData"))
                    display.DrawEdges, display.Opacity = 0, opacity
                    turn(view)
                    whole = picture(view)
                    coarse = interactive_picture(view)
                    simple.Delete(view)
                    self.assertGreater(difference(whole, coarse), 0)
                    self.assertLess(difference(whole, coarse, 60), 0.1)
                    self.assertLess(difference(silhouette(whole), silhouette(coarse)), 0.02)
            simple.Disconnect()


if __name__ == "__main__":
    camaron_testing.main()
