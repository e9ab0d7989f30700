# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Quality Statistics and Select Elements on a server, one process and two, from a client."""

import camaron_testing
import TestClientServer
from camaron import selection
from paraview import servermanager, simple


def evaluate():
    """Everything a client sees."""
    mesh = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4]))
    identified = simple.GlobalPointAndCellIds(Input=mesh)
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
    select = simple.SelectElements(
        Input=quality, Strategy="Worst N", Array="EdgeLengthRatio", NumberOfWorst=37
    )
    select.UpdatePipeline()
    select.UpdatePropertyInformation()
    results.append(select.GetPropertyValue("NumberOfSelectedElements"))
    selection.set_active_selection(select)
    extract = simple.ExtractSelection(Input=select)
    extract.UpdatePipeline()
    results.append(extract.GetDataInformation().GetNumberOfCells())
    return results


class TestServer(camaron_testing.TestCase):
    serve = TestClientServer.TestClientServer.serve

    def test_one_process(self):
        expected = evaluate()
        self.assertEqual(expected[3:], [37, 37])
        self.assertEqual(expected[0]["Count"], [8**3 * 5] * len(expected[0]["Count"]))
        self.serve(1)
        self.assertEqual(str(evaluate()), str(expected))

    def test_two_processes(self):
        self.serve(2)
        results = evaluate()
        self.assertEqual(results[3:], [37, 37])
        self.assertEqual(results[0]["Count"], [8**3 * 5] * len(results[0]["Count"]))
        self.assertEqual(set(results[0]["IdSpace"]), {"Global id"})


if __name__ == "__main__":
    camaron_testing.main()
