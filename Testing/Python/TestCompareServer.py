# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compare Quality and Correlate Quality on a server, one process and two: the tables of ParaView alone, bit for bit."""

import camaron_testing
import TestClientServer
from camaron import tables
from paraview import simple


def evaluate():
    """The tables, and the mean of what the filters add to the mesh."""
    mesh = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4]))
    warped = simple.WarpByScalar(Input=mesh, Scalars=["POINTS", "RTData"], ScaleFactor=0.004)
    qualities = [simple.ElementQuality(Input=source) for source in (mesh, warped)]
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


class TestCompareServer(camaron_testing.TestCase):
    serve = TestClientServer.TestClientServer.serve

    def test_servers(self):
        expected = evaluate()
        self.assertIn("'SameCells': 1", expected[0])
        self.assertEqual(expected[3][0], 8**3 * 5)
        self.assertGreater(expected[3][2], 0)
        for ranks in (1, 2):
            self.serve(ranks)
            there = evaluate()
            simple.Disconnect()
            self.assertEqual(there, expected, ranks)


if __name__ == "__main__":
    camaron_testing.main()
