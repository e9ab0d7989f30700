# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared functions of the tests in Python.

A test is a script of unittest cases that ends with `camaron_testing.main()`:

    import camaron_testing

    class TestFoo(camaron_testing.TestCase):
        def test_bar(self):
            source = self.open(camaron_testing.EXAMPLES / "voronoi-ball.visf")
            ...

    if __name__ == "__main__":
        camaron_testing.main()
"""

import contextlib
import inspect
import os
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy
from mesh_files import read_visf, write_vtk  # for tests
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

from camaron.common import pipeline

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "Examples"
#: A line for the start of a script that imports ParaView, which then takes a second less.
QUICK_START = (
    f"__import__('runpy').run_path({str(ROOT / 'Scripts' / 'camaron' / 'quick_start.py')!r})\n"
)
#: Folder of collected meshes of other programs, or None: see TestCase.data and TestCase.real. Tests that read some get
#: the label shared-data, by which a folder of meshes can be tried alone.
DATA = Path(os.environ.get("CAMARON_SHARED_DATA") or "missing")
DATA = DATA if DATA.is_dir() else None
#: What tests use to read some, as in Testing/CMakeLists.txt.
READS_DATA = re.compile(r"self\.(data|real)\(|camaron_testing\.DATA")
SKIPPED = 77

pipeline.load_plugin()


class TestCase(unittest.TestCase):
    """Has its own folder self.folder, which is deleted afterwards."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="camaron-test-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def open(self, path):
        """The source that reads a file, updated; a test fails on any error of the reader."""
        with pipeline.Messages() as messages:
            source = simple.OpenDataFile(str(path))
            self.assertIsNotNone(source, f"no reader for {path}")
            source.UpdatePipeline()
        self.assertEqual(messages.errors, [])
        return source

    def fetch(self, source, port=0):
        """The data of an output port; of several ranks, that of the first."""
        return servermanager.Fetch(source, idx=port)

    def data(self, name):
        """A file or folder of the collected meshes, for tests that need it.

        Skips the test without the collection; the collection must contain the file.
        """
        if DATA is None:
            self.skipTest("CAMARON_SHARED_DATA names no folder of meshes")
        self.assertTrue((DATA / name).exists(), f"{name} is not in {DATA}")
        return DATA / name

    def real(self, *patterns):
        """Files of the collected meshes, some for each pattern; none without the collection."""
        found = []
        for pattern in patterns if DATA else ():
            paths = sorted(DATA.glob(pattern))
            self.assertTrue(paths, f"{pattern} is not in {DATA}")
            found += paths
        return found

    def start_server(self, ranks=1, plugins="", seconds=600):
        """Starts a pvserver that waits for one client, and returns its port.

        `plugins`: its PV_PLUGIN_PATH; without it the client must bring the plugin.
        """
        if not shutil.which("pvserver") or (ranks > 1 and not shutil.which("mpiexec")):
            self.skipTest("no pvserver or mpiexec")
        port = free_port()
        command = ["pvserver", f"--server-port={port}", "--bind-address=127.0.0.1"]
        if ranks > 1:
            command = ["mpiexec", "--oversubscribe", "-n", str(ranks), *command]
        # The server of 6.1 leaves what it says in the buffer.
        server = subprocess.Popen(
            ["timeout", str(seconds), "stdbuf", "--output=L", *command],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env={**os.environ, "PV_PLUGIN_PATH": str(plugins)},
        )
        self.addCleanup(server.wait, seconds)
        self.addCleanup(server.stdout.close)
        self.addCleanup(server.terminate)
        if not any("Accepting connection" in line for line in server.stdout):
            self.fail("pvserver does not start")
        return port


class FormatTestCase(TestCase):
    """For readers and writers of one format; no source outlives its test."""

    def tearDown(self):
        delete_sources()
        super().tearDown()

    def make(self, name, text):
        """A file of this text."""
        path = self.folder / name
        path.write_text(text)
        return path

    def save(self, name, grid, **options):
        """A file of a grid, by the writer that its name tells; for readers, other tests look at what is in it."""
        writer = vtkXMLUnstructuredGridWriter()  # a file, as all ranks have to know the mesh
        writer.SetFileName(str(self.folder / "grid.vtu"))
        writer.SetInputData(grid)
        writer.Write()
        source = simple.XMLUnstructuredGridReader(FileName=[writer.GetFileName()])
        simple.SaveData(str(self.folder / name), source, **options)
        simple.Delete(source)
        return self.folder / name

    def cells(self, source):
        """Number of cells; ParaView asks for ghost cells, which do not count."""
        cleaned = simple.RemoveGhostInformation(Input=source)
        cleaned.UpdatePipeline(source.SMProxy.GetDataInformation(0).GetTime())
        count = cleaned.GetDataInformation().GetNumberOfCells()
        simple.Delete(cleaned)
        return count


def definition(path):
    """A file of definitions of proxies as XML; of a reader without options the one that is made from its documentation."""
    text = path.read_text("utf-8")
    if text.startswith("<Documentation"):
        frame = (ROOT / "Readers" / "Base" / "FormatReader.xml.in").read_text("utf-8")
        text = frame.replace("@documentation@", text)
        text = text.replace("@name@", path.stem.removesuffix("Reader"))
        text = text.replace("@label@", path.stem.removesuffix("Reader"))
    shared = (ROOT / "Filters" / "Common" / "SharedProperties.ent").read_text("utf-8")
    text = text.replace("@SharedProperties@", shared)
    return ElementTree.fromstring(re.sub(r"@\w+@", "", text))


def delete_sources():
    """Deletes all sources and filters: the more there are, the longer it takes to make another one."""
    for source in reversed(list(simple.GetSources().values())):
        simple.Delete(source)


def rank_count():
    """Number of MPI ranks."""
    return pipeline.rank_count()


def paraview_version():
    """Major and minor version of ParaView."""
    manager = servermanager.vtkSMProxyManager
    return manager.GetVersionMajor(), manager.GetVersionMinor()


def traces_have_selections():
    """From 6.1 on only states have them; what has a selection as its input is left out of traces."""
    return paraview_version() < (6, 1)


def pieces(source, port=0):
    """The data of an output port, of each rank."""
    source.UpdatePipeline()
    if rank_count() == 1 or source.GetDataInformation(port).IsCompositeDataSet():
        return [servermanager.Fetch(source, rank, idx=port) for rank in range(rank_count())]
    # Fetch would bring the data of all ranks, once for each of them.
    gathered = servermanager.filters.ReductionFilter(
        Input=servermanager.OutputPort(source, port),
        PostGatherHelperName="vtkMultiBlockDataGroupFilter",
    )
    gathered.UpdatePipeline()
    group = gathered.GetClientSideObject().GetOutputDataObject(0)
    return [group.GetBlock(rank) for rank in range(rank_count())]


def own_cells(data):
    """Which cells of a data set are not ghosts, as an array of bool."""
    ghosts = data.GetCellGhostArray()
    return vtk_to_numpy(ghosts) & 1 == 0 if ghosts else numpy.ones(data.GetNumberOfCells(), bool)


def leaves(data):
    """The data sets of composite data, or the one that there is."""
    if not data.IsA("vtkCompositeDataSet"):
        return [data]
    found = []
    it = data.NewIterator()
    it.InitTraversal()
    while not it.IsDoneWithTraversal():
        found.append(it.GetCurrentDataObject())
        it.GoToNextItem()
    return found


def require_display():
    """Decorator: skips a test that renders where there is no display, unless by EGL, which needs none."""
    names = ("DISPLAY", "VTK_DEFAULT_OPENGL_WINDOW")
    has_display = any(map(os.environ.get, names)) or sys.platform in ("win32", "darwin")
    return unittest.skipUnless(has_display, "no display: run under xvfb-run")


def plugin_folder():
    """The folder of the plugin under test."""
    for folder in os.environ["PV_PLUGIN_PATH"].split(os.pathsep):
        if Path(folder, "Camaron.so").exists():
            return Path(folder)
    raise RuntimeError("PV_PLUGIN_PATH has no Camaron.so")


def environment_alone(without=()):
    """The environment without what mpiexec told this process, for one that is no part of the job."""
    prefixes = ("OMPI_", "PMIX_", "PMI_", "PRTE_", "HYDRA_")
    return {
        key: value
        for key, value in os.environ.items()
        if key not in without
        and (
            not key.startswith(prefixes)
            or key.startswith(("OMPI_ALLOW_RUN_AS_ROOT", "OMPI_MCA_btl"))
        )
    }


def run_ranks(ranks, *command, **options):
    """Runs a command on ranks, or for None without mpiexec: its status, output and errors. Each rank writes to files of its
    own, since mpiexec mixes parts of lines of standard error with the output."""
    command = list(map(str, command))
    options.update(capture_output=True, text=True)
    if not ranks:
        return subprocess.run(command, **options)
    with tempfile.TemporaryDirectory(prefix="camaron-test-") as folder:
        # mpiexec may end ranks, but not what writes their last words.
        to_file = '(trap "" TERM; exec cat >"$0/$$.{}")'
        err, out = map(to_file.format, ("err", "out"))
        each = ["bash", "-o", "pipefail", "-c"]
        each += [f'trap : TERM; {{ "$@" 2>&1 >&3 3>&- | {err}; }} 3>&1 | {out}', folder]
        texts = lambda kind: "".join(
            path.read_text() for path in sorted(Path(folder).glob(f"*.{kind}"))
        )
        try:
            run = subprocess.run(
                ["mpiexec", "--oversubscribe", "-n", str(ranks), *each, *command], **options
            )
        except subprocess.TimeoutExpired as error:
            raise AssertionError(f"{error}\n{texts('out')}\n{texts('err')}") from None
        run.stdout += texts("out")
        run.stderr += texts("err")
    return run


def free_port():
    """A port of this computer that nothing uses."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def run_alone(script, *arguments, timeout):
    """Runs a script in a single process of its own, which starts as a test does; an error if it fails."""
    command = [str(ROOT / "Testing" / "Python" / "run-test"), str(script), *map(str, arguments)]
    subprocess.run(command, env=environment_alone(), check=True, timeout=timeout)


def run_command(*arguments, without=(), **options):
    """Runs the command line in a process of its own; returns it with its output as text.

    `without` names variables of the environment to leave out.
    """
    script = ROOT / "Scripts" / "camaron" / "__main__.py"
    environment = environment_alone(without)
    python = shutil.which("pvpython") or "pvpython"
    if os.path.exists(environment.get("CAMARON_TEST_LIBRARIES", "")):  # as ./camaron does
        environment["CAMARON_LIBRARIES"] = environment["CAMARON_TEST_LIBRARIES"]
        python = Path(environment["CAMARON_LIBRARIES"]).read_text("utf-8").split("\n", 1)[0]
    command = [python, str(script), *map(str, arguments)]
    options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
    return subprocess.run(command, text=True, timeout=240, env=environment, **options)


@contextlib.contextmanager
def messages():
    """Messages of VTK meanwhile, as a function that returns them."""
    window, before = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    try:
        yield window.GetOutput
    finally:
        vtkOutputWindow.SetInstance(before)


class SharedDataLoader(unittest.TestLoader):
    """Loads the tests that read collected meshes, themselves or through functions and methods of the script."""

    def getTestCaseNames(self, case):
        names = super().getTestCaseNames(case)
        return [name for name in names if self._reads(case, ["setUp", "setUpClass", name])]

    def _reads(self, case, names):
        reached = set()
        while names:
            name = names.pop()
            function = getattr(case, name, None) or vars(sys.modules["__main__"]).get(name)
            function = inspect.unwrap(getattr(function, "__func__", function))
            if name in reached or getattr(function, "__module__", None) != "__main__":
                continue
            reached.add(name)
            text = inspect.getsource(function)
            if READS_DATA.search(text):
                return True
            names += re.findall(r"\w+", text)
        return False


def main():
    """Runs the tests of the script, or those named by its arguments (see unittest), and ends the
    process: 0 passed, 1 failed, 77 all skipped.

    With CAMARON_SHARED_DATA_ONLY in the environment only the tests that read collected meshes.
    """
    sys.stdout, sys.stderr = sys.__stdout__, sys.__stderr__
    loader = unittest.defaultTestLoader
    if DATA and os.environ.get("CAMARON_SHARED_DATA_ONLY"):
        loader = SharedDataLoader()
    program = unittest.main("__main__", exit=False, verbosity=2, argv=sys.argv, testLoader=loader)
    result = program.result
    if not result.wasSuccessful():
        status = 1
    else:
        skipped = sum(
            not hasattr(test, "test_case") for test, _ in result.skipped
        )  # no parts of tests
        status = SKIPPED if result.testsRun and skipped == result.testsRun else 0
    sys.stdout.flush()
    sys.stderr.flush()
    under_mpi = any(key in os.environ for key in ("OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"))
    if rank_count() == 1 and not under_mpi:
        os._exit(status)  # pvpython can hang while it closes
    if status:
        sys.exit(status)  # else let pvbatch take leave of MPI, which mpiexec insists on
