# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Selections on a server, one process and two, are those of ParaView alone; so are their files on the client."""

import camaron_testing
import TestClientServer
from camaron import export, selection
from paraview import simple


def select(source, **properties):
    made = simple.SelectElements(Input=source, **properties)
    made.UpdatePipeline()
    made.UpdatePropertyInformation()
    return made


def count(made):
    return made.GetPropertyValue("NumberOfSelectedElements")


class TestSelectServer(camaron_testing.TestCase):
    serve = TestClientServer.TestClientServer.serve

    def results(self):
        """Numbers of elements that strategies select, and lists of them, by global ids."""
        mesh = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4]))
        warped = simple.WarpByScalar(Input=mesh, Scalars=["POINTS", "RTData"], ScaleFactor=0.004)
        ids = simple.GlobalPointAndCellIds(Input=warped)
        quality = simple.ElementQuality(Input=ids, Criteria=["MinDihedralAngle", "Volume"])
        first = select(quality, Array="MinDihedralAngle", Strategy="Worst share", WorstShare=2)
        grown = select(first, Strategy="Expand", Adjacency="Edge", NumberOfRings=2)
        ball = simple.SelectElements(
            Input=grown,
            Strategy="Shape",
            Shape="Sphere",
            Placement="Intersects",
            Combination="Intersect",
        )
        ball.Shape.Center, ball.Shape.Radius = [0.5, 0, 0.5], 3.1
        ball.UpdatePipeline()
        ball.UpdatePropertyInformation()
        faces = simple.MeshElements(Input=ball)
        on_faces = select(faces, Strategy="Change kind", Elements=ball, Quantifier="All")
        back = select(ball, Strategy="Change kind", Elements=on_faces)
        points = select(ball, ElementType="Points", Strategy="Change kind", Quantifier="All")
        parts = select(ball, Strategy="Part", Adjacency="Vertex")
        steps = [first, grown, ball, on_faces, back, points, parts]
        counts = [count(step) for step in steps]
        lists = []
        for step in (ball, back, points, parts):
            path = self.folder / "ids.csv"
            export.write_list(step, path)
            lists.append(path.read_text())
        for step in (ball, points):
            selection.set_active_selection(step)
            extract = simple.ExtractSelection(Input=step)
            extract.UpdatePipeline()
            # Of the port with ids, too.
            by_ids = simple.ExtractSelection(Input=step, Selection=simple.OutputPort(step, 1))
            by_ids.UpdatePipeline()
            for made in (extract, by_ids):
                if step is ball:
                    counts.append(made.GetDataInformation().GetNumberOfCells())
        return counts, lists

    def test_servers(self):
        counts, lists = self.results()
        self.assertTrue(all(counts), counts)
        self.assertEqual(counts[7:], [counts[2]] * 2)
        for ranks in (1, 2):
            self.serve(ranks)
            there = self.results()
            simple.Disconnect()
            self.assertEqual(there[0], counts, ranks)
            for own, other in zip(lists, there[1]):
                first_columns = [[row.split(",")[0] for row in text.splitlines()] for text in (own, other)]
                self.assertEqual(*first_columns)


if __name__ == "__main__":
    camaron_testing.main()
