# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Quality Statistics and Select Elements on a server, one process and two, from a client."""

import os
import shutil
import socket
import subprocess
import time

import camaron_testing
from camaron import selection
from paraview import servermanager, simple


class Server:
    """A pvserver on a free port of this machine; leaving the block ends it."""

    def __init__(self, ranks):
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            self.port = probe.getsockname()[1]
        self.command = [shutil.which("pvserver"), f"--server-port={self.port}"]
        if ranks > 1:
            mpiexec = shutil.which("mpiexec")
            flags = ["--oversubscribe"] if "open" in self.version(mpiexec).lower() else []
            self.command = [mpiexec, *flags, "-n", str(ranks), *self.command]

    def version(self, program):
        return subprocess.run([program, "--version"], capture_output=True, text=True).stdout

    def __enter__(self):
        self.process = subprocess.Popen(
            self.command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
        )
        for line in self.process.stdout:
            if "Accepting" in line:
                break
        simple.Connect("127.0.0.1", self.port)
        plugin = next(
            os.path.join(folder, "Camaron.so")
            for folder in os.environ["PV_PLUGIN_PATH"].split(os.pathsep)
            if os.path.exists(os.path.join(folder, "Camaron.so"))
        )
        simple.LoadPlugin(plugin, remote=True, ns=vars(simple))
        return self

    def __exit__(self, *_):
        simple.Disconnect()
        deadline = time.monotonic() + 20
        while self.process.poll() is None and time.monotonic() < deadline:
            time.sleep(0.1)
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()


def evaluate():
    """Everything a client sees."""
    mesh = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4]))
    identified = simple.GenerateGlobalIds(Input=mesh)
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
    results.append(select.GetPropertyValue("NumberOfSelectedCells"))
    selection.set_active_selection(select)
    extract = simple.ExtractSelection(Input=select)
    extract.UpdatePipeline()
    results.append(extract.GetDataInformation().GetNumberOfCells())
    return results


class TestServer(camaron_testing.TestCase):
    def test_one_process(self):
        expected = evaluate()
        self.assertEqual(expected[3:], [37, 37])
        self.assertEqual(expected[0]["Count"], [8**3 * 5] * len(expected[0]["Count"]))
        with Server(1):
            self.assertEqual(str(evaluate()), str(expected))

    def test_two_processes(self):
        if not shutil.which("mpiexec"):
            self.skipTest("no mpiexec")
        with Server(2):
            results = evaluate()
        self.assertEqual(results[3:], [37, 37])
        self.assertEqual(results[0]["Count"], [8**3 * 5] * len(results[0]["Count"]))
        self.assertEqual(set(results[0]["IdSpace"]), {"Global id"})


if __name__ == "__main__":
    camaron_testing.main()
