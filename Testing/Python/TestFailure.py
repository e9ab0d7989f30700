# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that cannot be read: one error of all ranks, and nothing is written of them."""

import shutil
import subprocess

from paraview import simple

import camaron_testing

#: What every rank runs: it opens the file that is meant for it, writes it again, and says what it has.
SCRIPT = """
import pathlib, sys
from camaron import pipeline
pipeline.load_plugin()
from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController
rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
*paths, target = sys.argv[1:]
source = simple.VisfReader(FileNames=[paths[rank % len(paths)]])
source.UpdatePipeline()
reader = source.GetClientSideObject()
cells = reader.GetOutputDataObject(0).GetNumberOfCells()
simple.SaveData(target, source)
said = f"rank {rank}: {cells} cells, code {reader.GetReader().GetErrorCode()}"
pathlib.Path(f"{target}.{rank}").write_text(said)
"""
#: What every rank runs: it converts a file, and says so.
CONVERSION = """
import pathlib, sys
from camaron import convert
from vtkmodules.vtkParallelCore import vtkMultiProcessController
rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
convert(*sys.argv[1:])
pathlib.Path(f"{sys.argv[2]}.{rank}").write_text("done")
"""
#: What every rank runs: it opens a file.
OPENING = """
import sys
from camaron import pipeline
pipeline.load_plugin()
from paraview import simple
simple.OpenDataFile(sys.argv[1]).UpdatePipeline()
"""
FILE_NOT_OPENED, TRUNCATED = 20002, 20004  # of vtkErrorCode


class TestFailure(camaron_testing.TestCase):
    def run_script(self, text, *arguments):
        """What a script on two ranks gives that all run it."""
        mpiexec, pvbatch = shutil.which("mpiexec"), shutil.which("pvbatch")
        if not mpiexec or not pvbatch:
            self.skipTest("no mpiexec or pvbatch")
        script = self.folder / "script.py"
        script.write_text(text)
        command = [mpiexec, "-n", "2", pvbatch, "--sym", str(script)]
        return subprocess.run(
            [*command, *map(str, arguments)], capture_output=True, text=True, timeout=200
        )

    def run_ranks(self, *paths):
        """Standard error, and what each of two ranks says; `paths` are taken in turn."""
        target = self.folder / "target.visf"
        run = self.run_script(SCRIPT, *paths, target)
        self.assertFalse(target.exists(), run.stderr)
        said = sorted(self.folder.glob("target.visf.*"))
        return run.stderr, [path.read_text() for path in said]

    def test_all_ranks_convert(self):
        """The first rank writes; for the others that is no failure."""
        target = self.folder / "ball.ply"
        run = self.run_script(CONVERSION, camaron_testing.EXAMPLES / "voronoi-ball.visf", target)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertTrue(target.exists())
        self.assertEqual(len(list(self.folder.glob("ball.ply.*"))), 2, run.stderr)

    def test_one_error_of_all_ranks(self):
        """Every rank reads the file and fails; people want to know once."""
        bad = self.folder / "bad.visf"
        bad.write_text("2 1\n3\n0 0 0\n1 0 0\n")
        errors, outcome = self.run_ranks(bad)
        self.assertEqual(errors.count("bad.visf:2: expected at least 18 bytes"), 1, errors)
        self.assertEqual(errors.count("target.visf is not written"), 1, errors)
        self.assertEqual(outcome, [f"rank {i}: 0 cells, code {TRUNCATED}" for i in range(2)])

    def test_one_rank_fails(self):
        """Half a mesh is no mesh: the other gives up what it has."""
        good = camaron_testing.EXAMPLES / "voronoi-ball.visf"
        errors, outcome = self.run_ranks(good, self.folder / "missing.visf")
        self.assertEqual(errors.count("missing.visf"), 1, errors)
        self.assertEqual(outcome, [f"rank {i}: 0 cells, code {FILE_NOT_OPENED}" for i in range(2)])

    def test_ranks_read_different_states(self):
        """Parts of two meshes are no mesh: a file that was replaced before the second rank opened it."""
        before, after = self.folder / "before", self.folder / "after"
        for folder in (before, after):
            folder.mkdir()
            shutil.copy(camaron_testing.EXAMPLES / "voronoi-ball.visf", folder / "mesh.visf")
        errors, outcome = self.run_ranks(before / "mesh.visf", after / "mesh.visf")
        self.assertEqual(errors.count("mesh.visf: cannot read the file: another program"), 1, errors)
        self.assertEqual(outcome, [f"rank {i}: 0 cells, code {FILE_NOT_OPENED}" for i in range(2)])

    def test_one_warning_of_all_ranks(self):
        """Also of points that only the second rank has; a point of both counts for each."""
        bad = self.folder / "bad.tri"
        points = [f"{i} {i * i} {i * i * i}" for i in range(8)]
        points[0], points[7] = "0 nan 0", "1 0 inf"
        triangles = [f"{i} {i + 1} {i + 2}" for i in range(6)]
        bad.write_text("\n".join(["8", *points, "6", *triangles, ""]))
        errors = self.run_script(OPENING, bad).stderr
        expected = "bad.tri: 2 points with a coordinate that is not finite, the first is point 0 (counted from 0; "
        self.assertEqual(errors.count(expected), 1, errors)
        self.assertEqual(errors.count("not finite"), 1, errors)
        points[0], points[3] = "0 0 0", "1 0 inf"
        bad.write_text("\n".join(["8", *points, "6", *triangles, ""]))
        errors = self.run_script(OPENING, bad).stderr
        self.assertIn("bad.tri: 3 points with a coordinate that is not finite, the first is point 3", errors)

    def test_empty_meshes_are_written(self):
        """A mesh that is empty for no error is a mesh."""
        source = self.open(camaron_testing.EXAMPLES / "voronoi-ball.visf")
        nothing = simple.Clip(Input=source, ClipType="Plane", Invert=0)
        nothing.ClipType.Origin = [1000, 0, 0]
        target = self.folder / "empty.visf"
        simple.SaveData(str(target), nothing)
        self.assertEqual(target.read_text(), "2 0\n0\n")


@camaron_testing.require_display()
class TestMending(camaron_testing.TestCase):
    """What is drawn follows again once the reason of a failure is gone."""

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
        chosen = simple.Threshold(Input=ids, Scalars=["CELLS", "Selected"], LowerThreshold=1, UpperThreshold=1)
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
        whole = (camaron_testing.EXAMPLES / "voronoi-ball.visf").read_bytes()
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
