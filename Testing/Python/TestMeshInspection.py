# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The representation Mesh Inspection shows and selects what Surface does of the same cells."""

import camaron_testing
import gallery
from inspection_testing import difference, make_view, picture, selected, turn
from mesh_parts import producer
from paraview import simple


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
        yield "surface", simple.PointAndCellIds(
            Input=simple.Sphere(ThetaResolution=20, PhiResolution=20)
        )
        sphere = simple.Sphere(ThetaResolution=20, PhiResolution=20, Center=[9, 0, 0], Radius=4)
        yield "blocks", simple.GroupDatasets(Input=[tetrahedra(), simple.PointAndCellIds(Input=sphere)])

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
