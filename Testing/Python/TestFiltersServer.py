# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""What filters of ours find on a server, one process and two, is what they find in ParaView alone."""

import camaron_testing
import TestClientServer
from camaron import export
from camaron.active_selection import set_active_selection
from camaron.common import tables
from paraview import servermanager, simple

CELLS = 8**3 * 5


def tetrahedra():
    return simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4]))


def warped(mesh):
    return simple.WarpByScalar(Input=mesh, Scalars=["POINTS", "RTData"], ScaleFactor=0.004)


def compare():
    """The tables of Compare Quality and Correlate Quality, and the range of what they add to the mesh."""
    mesh = tetrahedra()
    qualities = [simple.ElementQuality(Input=source) for source in (mesh, warped(mesh))]
    for quality in qualities:
        quality.Criteria = ["MinDihedralAngle", "EdgeLengthRatio", "Volume"]
    comparison = simple.CompareQuality(Input=qualities[0], Other=qualities[1])
    correlation = simple.CorrelateQuality(Input=qualities[1], Field=["POINTS", "RTData"])
    results = []
    for source, port in ((comparison, 0), (comparison, 1), (correlation, 0)):
        source.UpdatePipeline()
        results.append(str(tables.fetch(source, port)))
    for source, port, name in ((comparison, 2, "Volume_Delta"), (correlation, 1, "RTData_Cells")):
        data = simple.OutputPort(source, port).GetDataInformation()
        information = data.GetCellDataInformation().GetArrayInformation(name)
        results.append((data.GetNumberOfCells(), *information.GetComponentRange(0)))
    return results


def analyze():
    """The tables of Quality Statistics by name of column, and the number of cells of a selection by value and its extract."""
    identified = simple.GlobalPointAndCellIds(Input=tetrahedra())
    quality = simple.ElementQuality(Input=identified)
    statistics = simple.QualityStatistics(Input=quality, GroupBy="Cell type")
    statistics.UpdatePipeline()
    results = []
    for port in range(3):
        table = servermanager.Fetch(statistics, idx=port)
        columns = [table.GetColumn(i) for i in range(table.GetNumberOfColumns())]
        results.append(
            {c.GetName(): [c.GetValue(i) for i in range(c.GetNumberOfValues())] for c in columns}
        )
    worst = select(quality, Strategy="Worst N", Array="EdgeLengthRatio", NumberOfWorst=37)
    set_active_selection(worst)
    extract = simple.ExtractSelection(Input=worst)
    extract.UpdatePipeline()
    return *results, (count(worst), extract.GetDataInformation().GetNumberOfCells())


def select(source, **properties):
    made = simple.SelectElements(Input=source, **properties)
    made.UpdatePipeline()
    made.UpdatePropertyInformation()
    return made


def count(made):
    return made.GetPropertyValue("NumberOfSelectedElements")


class TestFiltersServer(camaron_testing.TestCase):
    serve = TestClientServer.TestClientServer.serve

    def select_all_ways(self):
        """Numbers of elements that strategies select, and lists of them, by global ids, in files on the client."""
        ids = simple.GlobalPointAndCellIds(Input=warped(tetrahedra()))
        quality = simple.ElementQuality(Input=ids, Criteria=["MinDihedralAngle", "Volume"])
        first = select(
            quality, Array="MinDihedralAngle", Strategy="Worst percentage", WorstPercentage=2
        )
        grown = select(first, Strategy="Expand", Adjacency="Edge", NumberOfLayers=2)
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
        on_faces = select(faces, Strategy="Change element type", Elements=ball, Quantifier="All")
        back = select(ball, Strategy="Change element type", Elements=on_faces)
        points = select(
            ball, ElementType="Points", Strategy="Change element type", Quantifier="All"
        )
        parts = select(ball, Strategy="Component", Adjacency="Vertex")
        steps = [first, grown, ball, on_faces, back, points, parts]
        counts = [count(step) for step in steps]
        lists = []
        for step in (ball, back, points, parts):
            path = self.folder / "ids.csv"
            export.write_list(step, path)
            lists.append([row.split(",")[0] for row in path.read_text().splitlines()])
        for step in (ball, points):
            set_active_selection(step)
            extract = simple.ExtractSelection(Input=step)
            extract.UpdatePipeline()
            # Of the port with ids, too.
            by_ids = simple.ExtractSelection(Input=step, Selection=simple.OutputPort(step, 1))
            by_ids.UpdatePipeline()
            for made in (extract, by_ids):
                if step is ball:
                    counts.append(made.GetDataInformation().GetNumberOfCells())
        table = simple.QualityRegions(Input=quality, Array="MinDihedralAngle", NumberOfRegions=5)
        table.Range, table.LowerLimit, table.Adjacency = "Custom", "48", "Face"
        table.UpdatePipeline()
        regions = servermanager.Fetch(table)
        total = regions.GetFieldData().GetAbstractArray("NumberOfRegions").GetValue(0)
        return counts, lists, total, str(tables.fetch(table))

    def test_servers(self):
        tables_alone, (statistics, *others, worst), chosen = (
            compare(),
            analyze(),
            self.select_all_ways(),
        )
        self.assertIn("'SameCells': 1", tables_alone[0])
        self.assertEqual(tables_alone[3][0], CELLS)
        self.assertGreater(tables_alone[3][2], 0)
        self.assertEqual(worst, (37, 37))
        self.assertEqual(set(statistics["Count"]), {CELLS})
        counts, _, total, _ = chosen
        self.assertGreater(total, 5)
        self.assertTrue(all(counts), counts)
        self.assertEqual(counts[7:], [counts[2]] * 2)
        for ranks in (1, 2):
            self.serve(ranks)
            with self.subTest(ranks=ranks):
                self.assertEqual(compare(), tables_alone)
                self.assertEqual(self.select_all_ways(), chosen)
                there, *more, worst = analyze()
                self.assertEqual(worst, (37, 37))
                self.assertEqual(there["Count"], statistics["Count"])
                self.assertEqual(set(there["IdSpace"]), {"Global id"})
                if ranks == 1:
                    self.assertEqual(str([there, *more]), str([statistics, *others]))
            simple.Disconnect()


if __name__ == "__main__":
    camaron_testing.main()
