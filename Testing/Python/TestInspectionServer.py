# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mesh Inspection on a server, one process and two: pictures and selections are those of Surface.

Drawn there (remote rendering, composed by IceT) and, from data that are sent over, on the client.
"""

import camaron_testing
import TestClientServer
from inspection_testing import difference, make_view, picture, selected, turn
from paraview import simple


@camaron_testing.require_display()
class TestInspectionServer(camaron_testing.TestCase):
    serve = TestClientServer.TestClientServer.serve

    @staticmethod
    def make():
        mesh = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6]))
        mesh.UpdatePipeline()
        return mesh

    def compare(self, where, source):
        sets, pictures = [], []
        view = make_view()
        view.RemoteRenderThreshold = 0 if where == "server" else 100000
        for representation in ("Surface", "Mesh Inspection"):
            display = simple.Show(source, view)
            display.SetRepresentationType(representation)
            simple.ColorBy(display, ("POINTS", "RTData"))
            display.DrawEdges = 0
            turn(view)
            pictures.append(picture(view))
            sets.append([selected(view, source, kind) for kind in ("cells", "points")])
        simple.Delete(view)
        self.assertLess(difference(*pictures), 0.012)
        self.assertGreater(difference(pictures[0], pictures[0] * 0 + 255), 0.1)
        (cells, points), (same_cells, same_points) = sets
        self.assertGreater(min(len(cells), len(points)), 100)
        self.assertEqual(cells, same_cells)
        # Points where two processes meet are drawn by both, in the same place: either is right.
        self.assertLess(len(points ^ same_points), 1 + len(points) / 50)

    def translucent(self, source):
        """It would show faces between pieces, as Surface does."""
        view = make_view()
        view.RemoteRenderThreshold = 0
        display = simple.Show(source, view)
        display.SetRepresentationType("Mesh Inspection")
        simple.ColorBy(display, ("POINTS", "RTData"))
        display.DrawEdges, display.Opacity = 0, 0.5
        turn(view)
        made = picture(view)
        simple.Delete(view)
        return made

    def beyond(self, source):
        """What is drawn farther out than the mesh is."""
        view = make_view()
        view.RemoteRenderThreshold = 0
        display = simple.Show(source, view)
        display.SetRepresentationType("Mesh Inspection")
        display.DrawEdges, display.DrawNormals, display.NormalLength = 0, "Faces", 0.1
        turn(view)
        made = picture(view)
        simple.Delete(view)
        return made

    def stays_in_view(self, source):
        """Cut by a plane that is fixed in the first picture of a camera just set, and in that of another one."""
        view = make_view()
        view.RemoteRenderThreshold = 0
        display = simple.Show(source, view)
        display.SetRepresentationType("Mesh Inspection")
        display.DrawEdges, display.CutBy, display.CutShape = 0, "Exactly", "Plane"
        display.CutShape.Origin, display.CutShape.Normal = [0, 0, 0], [1, 0.2, 0.3]
        display.CutMovesWith = "View"
        turn(view)
        pictures = [picture(view)]
        view.CameraPosition = [-x for x in view.CameraPosition]
        pictures.append(picture(view))
        simple.Delete(view)
        return pictures

    def save_state(self, path):
        """The picture of a cut that is not the first of the list, and a state file of it."""
        view = make_view()
        display = simple.Show(self.make(), view)
        display.SetRepresentationType("Mesh Inspection")
        display.CutBy, display.CutShape = "Centroid", "Sphere"
        display.CutShape.Center, display.CutShape.Radius = [0, 0, 6], 6
        turn(view)
        made = picture(view)
        simple.SaveState(str(path))
        return made

    def test_servers(self):
        path = self.folder / "cut.pvsm"
        alone = self.stays_in_view(self.make())
        self.serve(1)
        found = self.check_server(alone)
        cut = self.save_state(path)
        simple.Disconnect()
        self.serve(2)
        with self.subTest("a state file of another server"):
            simple.LoadState(str(path))
            self.assertLess(difference(cut, picture(simple.GetActiveView())), 0.004)
        for what, expected, made in zip(
            ("translucent", "normals"), found, self.check_server(alone)
        ):
            with self.subTest(what):
                self.assertLess(difference(expected, made), 0.004)
        simple.Disconnect()

    def check_server(self, alone):
        """Compares what the server draws with Surface and with a cut alone; two pictures that are the same on any."""
        mesh = self.make()
        for expected, made in zip(alone, self.stays_in_view(mesh)):
            with self.subTest(cut="stays in view"):
                self.assertLess(difference(expected, made), 0.004)
                self.assertGreater(difference(made, made * 0 + 255), 0.02)
        for where in ("server", "client"):
            with self.subTest(where=where):
                self.compare(where, mesh)
        return self.translucent(mesh), self.beyond(mesh)


if __name__ == "__main__":
    camaron_testing.main()
