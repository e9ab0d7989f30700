# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that cannot be read: one error for all ranks, and nothing is written."""

import json
import shutil
import tempfile
import unittest
from pathlib import Path

import camaron_testing
from paraview import simple

BALL = camaron_testing.EXAMPLES / "voronoi-ball.visf"

#: What every rank runs: it opens the files that are meant for it, writes each again, and says what it has; it opens files
#: that all read, and converts one.
SCRIPT = """
import json, pathlib, sys
from camaron import convert
from camaron.common import pipeline
pipeline.load_plugin()
from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController
rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
folder, jobs = pathlib.Path(sys.argv[1]), json.loads(sys.argv[2])
for name, paths in jobs["read"].items():
    source = simple.VisfReader(FileNames=[paths[rank % len(paths)]])
    source.UpdatePipeline()
    reader = source.GetClientSideObject()
    cells = reader.GetOutputDataObject(0).GetNumberOfCells()
    simple.SaveData(str(folder / f"{name}-written.visf"), source)
    said = f"rank {rank}: {cells} cells, code {reader.GetReader().GetErrorCode()}"
    (folder / f"{name}.{rank}").write_text(said)
    simple.Delete(source)
for path in jobs["open"]:
    simple.OpenDataFile(path).UpdatePipeline()
convert(*jobs["convert"])
(folder / f"converted.{rank}").write_text("done")
"""
FILE_NOT_OPENED, TRUNCATED = 20002, 20004  # of vtkErrorCode


class TestUnreadableFiles(camaron_testing.TestCase):
    @classmethod
    def setUpClass(cls):
        """One job of two ranks for all tests, each of which searches its output for its own files."""
        if not shutil.which("mpiexec") or not shutil.which("pvbatch"):
            raise unittest.SkipTest("no mpiexec or pvbatch")
        folder = cls.ranks = Path(tempfile.mkdtemp(prefix="camaron-test-"))
        cls.addClassCleanup(shutil.rmtree, folder)
        (folder / "bad.visf").write_text("2 1\n3\n0 0 0\n1 0 0\n")
        for name in ("before", "after"):
            (folder / name).mkdir()
            shutil.copy(BALL, folder / name / "mesh.visf")
        points = [f"{i} {i * i} {i * i * i}" for i in range(8)]
        for name, changes in (
            ("two", {0: "0 nan 0", 7: "1 0 inf"}),
            ("three", {3: "1 0 inf", 7: "1 0 inf"}),
        ):
            rows = [changes.get(i, point) for i, point in enumerate(points)]
            triangles = [f"{i} {i + 1} {i + 2}" for i in range(6)]
            (folder / f"{name}.tri").write_text("\n".join(["8", *rows, "6", *triangles, ""]))
        jobs = {
            "read": {
                "bad": ["bad.visf"],
                "half": [BALL, "missing.visf"],
                "replaced": ["before/mesh.visf", "after/mesh.visf"],
            },
            "open": ["two.tri", "three.tri"],
            "convert": [BALL, "ball.ply"],
        }
        script = folder / "script.py"
        script.write_text(SCRIPT)
        command = ("pvbatch", "--sym", script, folder, json.dumps(jobs, default=str))
        run = camaron_testing.run_ranks(2, *command, cwd=folder, timeout=400)
        cls.status, cls.errors = run.returncode, run.stderr

    def check_read(self, name, error, code):
        """No rank has a cell, both have the same error code, and there is one error."""
        self.assertEqual(self.errors.count(error), 1, self.errors)
        self.assertEqual(self.errors.count(f"{name}-written.visf is not written"), 1, self.errors)
        self.assertFalse((self.ranks / f"{name}-written.visf").exists(), self.errors)
        said = [path.read_text() for path in sorted(self.ranks.glob(f"{name}.[0-9]"))]
        self.assertEqual(said, [f"rank {i}: 0 cells, code {code}" for i in range(2)], self.errors)

    def test_all_ranks_convert(self):
        """The first rank writes; the others report no failure."""
        self.assertEqual(self.status, 0, self.errors)
        self.assertTrue((self.ranks / "ball.ply").exists())
        self.assertEqual(len(list(self.ranks.glob("converted.*"))), 2, self.errors)

    def test_one_error_of_all_ranks(self):
        """Every rank reads the file and fails; there is one error."""
        self.check_read("bad", "bad.visf:2: expected at least 18 bytes", TRUNCATED)

    def test_one_rank_fails(self):
        """If one rank fails, the other one has no cells, either."""
        self.check_read("half", "missing.visf", FILE_NOT_OPENED)

    def test_ranks_read_different_states(self):
        """A file that was replaced before the second rank opened it is an error."""
        self.check_read(
            "replaced", "mesh.visf: cannot read the file: another program", FILE_NOT_OPENED
        )

    def test_one_warning_of_all_ranks(self):
        """Also of points that only the second rank has; a point of both counts for each."""
        expected = "two.tri: 2 points with a coordinate that is not finite, the first is point 0 (counted from 0; "
        self.assertEqual(self.errors.count(expected), 1, self.errors)
        expected = "three.tri: 4 points with a coordinate that is not finite, the first is point 3"
        self.assertEqual(self.errors.count(expected), 1, self.errors)
        self.assertEqual(self.errors.count("not finite"), 2, self.errors)

    def test_empty_meshes_are_written(self):
        """A mesh that is empty without an error is written."""
        source = self.open(BALL)
        nothing = simple.Clip(Input=source, ClipType="Plane", Invert=0)
        nothing.ClipType.Origin = [1000, 0, 0]
        target = self.folder / "empty.visf"
        simple.SaveData(str(target), nothing)
        self.assertEqual(target.read_text(), "2 0\n0\n")


@camaron_testing.require_display()
class TestRecovery(camaron_testing.TestCase):
    """The drawing is updated again once the cause of a failure is fixed."""

    def setUp(self):
        super().setUp()
        simple.ResetSession()
        camaron_testing.pipeline.load_plugin()

    def drawn(self, source, view):
        """Cells of what a display has after the view was drawn."""
        simple.Render(view)
        display = simple.GetDisplayProperties(source, view)
        return display.SMProxy.GetRepresentedDataInformation().GetNumberOfCells()

    def test_filter(self):
        sphere = simple.Sphere()
        ids = simple.SelectElements(Input=sphere, Strategy="By id", Ids="1 2")
        chosen = simple.Threshold(
            Input=ids, Scalars=["CELLS", "Selected"], LowerThreshold=1, UpperThreshold=1
        )
        view = simple.CreateRenderView()
        for source in (ids, chosen):
            simple.Show(source, view)
        self.assertEqual(self.drawn(chosen, view), 2)
        with camaron_testing.pipeline.Messages() as messages:
            ids.Ids = "one two"
            simple.Render(view)
        self.assertIn("expected a number", " ".join(messages.errors))
        for text, count in (("1 2 3", 3), ("4", 1)):
            ids.Ids = text
            self.assertEqual(self.drawn(chosen, view), count)
            self.assertEqual(chosen.GetDataInformation().GetNumberOfCells(), count)

    def test_reader(self):
        path = self.folder / "mesh.visf"
        whole = BALL.read_bytes()
        path.write_bytes(whole)
        mesh = simple.OpenDataFile(str(path))
        view = simple.CreateRenderView()
        simple.Show(mesh, view)
        self.assertEqual(self.drawn(mesh, view), 800)
        path.write_bytes(whole[: len(whole) // 2])
        with camaron_testing.pipeline.Messages() as messages:
            simple.ReloadFiles(mesh)
            simple.Render(view)
        self.assertIn("mesh.visf", " ".join(messages.errors))
        shutil.copy(camaron_testing.EXAMPLES / "flange.visf", path)
        simple.ReloadFiles(mesh)
        self.assertEqual(self.drawn(mesh, view), 4080)
        self.assertEqual(mesh.GetDataInformation().GetNumberOfCells(), 4080)


if __name__ == "__main__":
    camaron_testing.main()
