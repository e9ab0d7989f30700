# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Filters, writers and commands that are aborted or killed: no output, at most one message, and they work again."""

import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

import camaron_testing
from camaron.common import formats, pipeline
from paraview import simple

BALL = camaron_testing.EXAMPLES / "voronoi-ball.visf"
FLANGE = camaron_testing.EXAMPLES / "flange.visf"
#: Inputs and properties that filters need.
PROPERTIES = {
    "CheckQuality": lambda mesh: {"Rules": "Volume > 0"},
    "CompareQuality": lambda mesh: {"Other": mesh},
    "CorrelateQuality": lambda mesh: {"Field": ["CELLS", "FaceCount"]},
    "QualityRegions": lambda mesh: {"Array": "Volume", "Range": "Custom", "LowerLimit": "1"},
    "SelectionTable": lambda mesh: {"Input": simple.SelectElements(Input=mesh, Strategy="All")},
}


#: A client of a server at PORT, a rank of which is killed before or while it takes the steps.
LOSE_SERVER = """
import os, sys
from paraview import simple
import camaron
from camaron.common import pipeline
simple.Connect("127.0.0.1", PORT)
camaron.load_plugin(globals())
path = MESH
mesh = simple.OpenDataFile(path)
mesh.UpdatePipeline()
print("cells", mesh.GetDataInformation().GetNumberOfCells(), flush=True)
sys.stdin.readline()
for step in STEPS:
    try:
        eval(step)
        print("went on", flush=True)
    except Exception as error:
        print(f"{type(error).__name__}: {error}", flush=True)
os._exit(0)
"""
#: Steps of ours: each raises an error.
OUR_STEPS = (
    "pipeline.update_information(mesh)",
    "camaron.load_plugin()",
    "camaron.check(path, ['Volume > 0'])",
    "camaron.check(mesh, ['Volume > 0'])",
    "camaron.select(path, ['All'])",
    "camaron.inspect(path, 'report')",
    "camaron.compare(path, path, 'report')",
    "camaron.convert(path, 'out.vtu')",
)


def processes(program, argument):
    """Ids of the processes of a program that were called with this argument, in order."""
    found = []
    for path in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            name, *arguments = path.read_bytes().decode(errors="replace").split("\0")
        except OSError:  # it has ended
            continue
        if Path(name).name == program and argument in arguments:
            found.append(int(path.parent.name))
    return sorted(found)


def filter_names():
    """Names of all filters of the plugin, by their XML files."""
    texts = (path.read_text() for path in camaron_testing.ROOT.glob("Filters/*/*.xml"))
    groups = (re.search(r'<ProxyGroup name="filters">.*?</ProxyGroup>', t, re.S) for t in texts)
    proxy = r'<(?:SourceProxy|\w+Proxy)\s[^>]*?name="(\w+)"[^>]*class="vtk'
    return sorted({name for g in groups if g for name in re.findall(proxy, g.group())})


def sizes(filter_):
    """Cells or rows of every output."""
    outputs = [filter_.GetOutputDataObject(i) for i in range(filter_.GetNumberOfOutputPorts())]
    return [output.GetNumberOfElements(1) or output.GetNumberOfElements(6) for output in outputs]


class TestInterruption(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        simple.ResetSession()
        pipeline.load_plugin()

    def test_aborted_filters(self):
        """An aborted filter has no output and no message; updated again, it has everything."""
        names = filter_names()
        self.assertGreater(len(names), 9)
        mesh = simple.ElementQuality(Input=self.open(BALL), Criteria=["Volume", "FaceCount"])
        rules = {"Strategy": "Failed rules", "Rules": "MaxNonOrthogonality > 0"}
        cases = [(name, PROPERTIES.get(name, lambda _: {})(mesh)) for name in names]
        for name, properties in [*cases, ("SelectElements", rules)]:
            proxy = getattr(simple, name)(**{"Input": mesh, **properties})
            with pipeline.Messages() as messages:
                proxy.UpdatePipeline()
            self.assertEqual(messages.errors, [], name)
            filter_ = proxy.GetClientSideObject()
            whole = sizes(filter_)
            self.assertGreater(max(whole), 0, name)
            for when in (1, 2, 4):
                with self.subTest(filter=name, report=when):
                    reports = []

                    def stop(*_):
                        reports.append(filter_.GetProgress())
                        if len(reports) == when:
                            filter_.AbortExecuteOn()

                    observer = filter_.AddObserver("ProgressEvent", stop)
                    filter_.Modified()
                    with pipeline.Messages() as messages:
                        filter_.Update()
                    filter_.RemoveObserver(observer)
                    self.assertEqual(messages.errors, [])
                    if len(reports) >= when and reports[when - 1] < 1:
                        self.assertEqual(max(sizes(filter_)), 0)
                    filter_.AbortExecuteOff()
                    filter_.Modified()
                    filter_.Update()
                    self.assertEqual(sizes(filter_), whole)

    def test_aborted_rules(self):
        """The evaluation of rules in Select Elements reports progress, and ends when it is aborted there."""
        mesh = simple.Tetrahedralize(Input=simple.Wavelet())
        rules = {"Strategy": "Failed rules", "Rules": "MaxNonOrthogonality > 0"}
        proxy = simple.SelectElements(Input=mesh, **rules)
        proxy.UpdatePipeline()
        filter_ = proxy.GetClientSideObject()
        reports, most = [], 0.7  # of the evaluation

        def stop(*_):
            reports.append(filter_.GetProgress())
            if 0.1 < reports[-1] < most:
                filter_.AbortExecuteOn()

        filter_.AddObserver("ProgressEvent", stop)
        filter_.Modified()
        filter_.Update()
        self.assertEqual(max(sizes(filter_)), 0)
        inside = [report for report in reports if 0.1 < report < most]
        self.assertGreater(len(inside), 0, reports)
        self.assertLess(max(inside), 0.5)

    def test_aborted_writers(self):
        """An aborted writer leaves no part of the file, and keeps the file that existed."""
        aborted = 40000  # UserError of vtkErrorCode
        mesh = self.open(FLANGE)
        sources = [
            mesh,
            simple.Tetrahedralize(Input=mesh),
            simple.Triangulate(Input=simple.ExtractSurface(Input=mesh)),
        ]
        for known in formats.own_formats():
            if not known["writer"]:
                continue
            path = self.folder / f"mesh.{known['extensions'][0]}"
            path.write_text("before")
            codes = []
            for source in sources:  # there is one for every format
                proxy = formats.make_writer(known["writer"])
                proxy.Input, proxy.FileName = source, str(path)
                writer = proxy.GetClientSideObject()
                stop = lambda *_: writer.GetProgress() > 0 and writer.AbortExecuteOn()
                writer.AddObserver("ProgressEvent", stop)
                with pipeline.Messages():
                    proxy.UpdatePipeline()
                codes.append(writer.GetErrorCode())
                self.assertEqual(path.read_text(), "before", known["name"])
                self.assertEqual([p.name for p in self.folder.iterdir()], [path.name])
            self.assertIn(aborted, codes, known["name"])
            path.unlink()

    def make_large(self):
        path = self.folder / "large.visf"
        with pipeline.Messages():
            simple.SaveData(str(path), simple.Wavelet(WholeExtent=[0, 60] * 3))
        return path

    def test_interrupted_command(self):
        """Signals end a command at once, wherever it is, without a word of Python; no file is left."""
        mesh, folder = self.make_large(), self.folder / "new"
        folder.mkdir()
        script = camaron_testing.ROOT / "Scripts" / "camaron" / "__main__.py"
        command = [shutil.which("pvpython"), script, "convert", mesh, folder / "out.msh"]
        for end in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with subprocess.Popen(
                list(map(str, command)),
                # The launcher sets it, too: UCX, of MPI, would take SIGHUP for a question.
                env={**camaron_testing.environment_alone(), "UCX_DEBUG_SIGNO": "0"},
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
            ) as process:
                self.addCleanup(process.kill)
                while not list(folder.iterdir()) and process.poll() is None:
                    time.sleep(0.01)
                process.send_signal(end)
                output = process.communicate(timeout=60)[0]
            self.assertEqual((process.returncode, output), (-end, b""))
            self.wait_until_empty(folder)

    def wait_until_empty(self, folder):
        """What removes files of a killed process needs a moment."""
        end = time.monotonic() + 30
        while list(folder.iterdir()) and time.monotonic() < end:
            time.sleep(0.05)
        self.assertEqual(list(folder.iterdir()), [])

    @unittest.skipUnless(sys.platform == "linux", "processes are found as on Linux")
    @unittest.skipUnless(shutil.which("mpiexec"), "no mpiexec")
    def test_killed_rank(self):
        """If a rank of a command is killed while it writes, all ranks end, and no file or folder is left."""
        mesh, folder = self.make_large(), self.folder / "new"
        out = str(folder / "out.msh")
        folder.mkdir()
        scripts = camaron_testing.ROOT / "Scripts"
        command = [scripts / "launcher" / "with-ranks", "2", scripts / "camaron" / "__main__.py"]
        command += ["convert", mesh, out, "--ranks", "2"]
        environment = camaron_testing.environment_alone()
        environment["PRTE_MCA_rmaps_default_mapping_policy"] = ":oversubscribe"
        with subprocess.Popen(
            list(map(str, command)),
            env=environment,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        ) as process:
            self.addCleanup(process.kill)
            while not list(folder.iterdir()) and process.poll() is None:
                time.sleep(0.01)
            os.kill(processes("pvbatch", out)[1], signal.SIGKILL)  # others of them clean up later
            self.assertEqual(process.wait(60), 128 + signal.SIGKILL)
        self.wait_until_empty(folder)

    def lose_server(self, *steps, is_busy=False):
        """What a client says about steps after a rank of its server was killed, or, if the server is
        busy, during the first of them."""
        port = self.start_server(2, os.environ["PV_PLUGIN_PATH"])
        script = camaron_testing.QUICK_START + LOSE_SERVER
        script = script.replace("PORT", str(port)).replace("STEPS", f"{steps!r}")
        with subprocess.Popen(
            [shutil.which("pvpython"), "-c", script.replace("MESH", repr(str(BALL)))],
            env=camaron_testing.environment_alone(),
            cwd=self.folder,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        ) as client:
            self.addCleanup(client.kill)
            self.assertRegex(client.stdout.readline(), "^cells [1-9]")
            rank = processes("pvserver", f"--server-port={port}")[-1]
            if is_busy:
                os.kill(rank, signal.SIGSTOP)
                client.stdin.write("\n")
                client.stdin.flush()
                time.sleep(2)
            os.kill(rank, signal.SIGKILL)
            if not is_busy:  # mpiexec has ended the other rank
                while processes("pvserver", f"--server-port={port}"):
                    time.sleep(0.1)
            output, errors = client.communicate("" if is_busy else "\n", timeout=120)
        self.assertEqual(client.returncode, 0, output + errors)
        return output.splitlines(), errors

    @unittest.skipUnless(sys.platform == "linux", "processes are found as on Linux")
    def test_killed_server(self):
        """If a rank of a server is killed, the client's script gets an error and continues."""
        evaluate = "simple.ElementQuality(Input=mesh, Preset='General').UpdatePipeline()"
        said, errors = self.lose_server(evaluate, *OUR_STEPS)
        self.assertEqual(said, ["went on", *[f"RuntimeError: {pipeline.LOST}"] * len(OUR_STEPS)])
        self.assertIn("Server failed to gather information", errors)
        self.assertEqual(list(self.folder.iterdir()), [])

    @unittest.skipUnless(sys.platform == "linux", "processes are found as on Linux")
    def test_killed_busy_server(self):
        """If it is killed while our functions wait for it, they raise the same error."""
        for step in OUR_STEPS[1:6]:
            with self.subTest(step=step):
                said, _ = self.lose_server(step, is_busy=True)
                self.assertEqual(said, [f"RuntimeError: {pipeline.LOST}"])
                self.assertEqual(list(self.folder.iterdir()), [])

    @unittest.skipUnless(sys.platform == "linux", "limits of memory are Linux's")
    def test_memory(self):
        """Lack of memory causes one error, also in threads; with enough memory there is none."""
        path = self.make_large()
        simple.ElementQuality(Input=self.open(BALL)).UpdatePipeline()  # what is made once
        mesh = simple.OpenDataFile(str(path))
        quality = simple.ElementQuality(
            Input=mesh, Criteria=["Volume", "FaceCount", "VertexCount", "MaxDihedralAngle"]
        )
        limit = resource.getrlimit(resource.RLIMIT_AS)
        found = []
        for megabytes in (1, 20, 1000):
            simple.ReloadFiles(mesh)
            with open("/proc/self/statm", encoding="ascii") as file:
                size = int(file.read().split()[0]) * resource.getpagesize()
            resource.setrlimit(resource.RLIMIT_AS, (size + megabytes * 2**20, limit[1]))
            try:
                with pipeline.Messages() as messages:
                    quality.UpdatePipeline()
                    errors = messages.errors
            finally:
                resource.setrlimit(resource.RLIMIT_AS, limit)
            cells = quality.GetDataInformation().GetNumberOfCells()
            self.assertEqual(cells, 0 if errors else 60**3)
            found.append([error for error in errors if "not enough memory" in error])
            self.assertEqual(bool(found[-1]), bool(errors), errors)
        self.assertEqual([len(errors) for errors in found[::2]], [1, 0], found)


if __name__ == "__main__":
    camaron_testing.main()
