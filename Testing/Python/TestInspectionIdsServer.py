# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ids that Mesh Inspection writes on a server, of one process and of three, are in the picture that comes from there."""

import camaron_testing
import numpy
import TestClientServer
from inspection_testing import labels, make_view, picture, turn
from paraview import simple

RED = [1, 0, 0]
KINDS = ("Point", "Edge", "Face", "Cell")


def red(image):
    return (image[:, :, 0] > 190) & (image[:, :, 1:].max(axis=2) < 110)


@camaron_testing.require_display()
class TestInspectionIdsServer(camaron_testing.TestCase):
    serve = TestClientServer.TestClientServer.serve

    def mesh(self):
        mesh = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2]))
        return simple.PassArrays(Input=mesh, PointDataArrays=[], CellDataArrays=[])

    def write(self, source, kinds, threshold, **properties):
        """Where the picture is red with the ids of some kinds, and these ids if they were drawn here."""
        view = make_view()
        view.RemoteRenderThreshold = threshold
        display = simple.Show(source, view)
        display.SetRepresentationType("Mesh Inspection")
        for kind in kinds:
            setattr(display, f"Draw{kind}Ids", 1)
            setattr(display, f"{kind}IdColor", RED)
        for name, value in properties.items():
            setattr(display, name, value)
        turn(view)
        marks = red(picture(view))
        found = labels(view)
        simple.Delete(view)
        return marks, found

    def elements(self, source):
        """Of each kind pairs of an id in the piece of a process and a place."""
        elements = simple.MeshElements(Input=source)
        outputs = [simple.OutputPort(elements, i) for i in (2, 1, 0)] + [source]
        found = []
        for output in outputs:
            numbered = simple.PointAndCellIds(Input=output)
            places = self.fetch(simple.CellCenters(Input=numbered))
            ids = places.GetPointData().GetArray("CellIds")
            found.append(
                {
                    (int(ids.GetTuple1(i)), *numpy.round(places.GetPoint(i), 3))
                    for i in range(places.GetNumberOfPoints())
                }
            )
        return found

    def test_servers(self):
        """Drawn there they are in the picture; on the client, each is one of the process that the element is from."""
        expected = {kind: self.write(self.mesh(), [kind], 0)[0] for kind in ("Point", "Face")}
        for ranks in (1, 3):
            self.serve(ranks)
            mesh = self.mesh()
            for kind, alone in expected.items():
                with self.subTest(ranks=ranks, kind=kind):
                    marks, found = self.write(mesh, [kind], 0)
                    self.assertIsNone(found)
                    self.assertGreater(alone.sum(), 300)
                    if ranks == 1:
                        self.assertLess((marks != alone).sum(), 20)
                    else:  # other numbers, but as many
                        self.assertLess(abs(marks.sum() / alone.sum() - 1), 0.35)
            with self.subTest(ranks=ranks, where="client"):
                # Through the mesh one sees cells with their ids in the middle.
                _, (kinds, ids, places, _) = self.write(mesh, KINDS, 100000, DrawFaces=0, IdSize=6)
                for kind, known in enumerate(self.elements(mesh)):
                    mine = kinds == kind
                    self.assertGreater(mine.sum(), 10, KINDS[kind])
                    found = {
                        (int(number), *numpy.round(place, 3))
                        for number, place in zip(ids[mine], places[mine])
                    }
                    self.assertEqual(found - known, set(), KINDS[kind])
            simple.Disconnect()


if __name__ == "__main__":
    camaron_testing.main()
