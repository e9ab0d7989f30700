# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Catalyst script of the examples, for a series of files that ParaView plays as a simulation and for simulations in
C++ and in Python, on 1 and 2 ranks."""

import csv
import importlib.util
import shutil
import subprocess

import camaron_testing
from inspection_testing import difference, read_picture
from paraview import simple

EXAMPLE = camaron_testing.EXAMPLES / "insitu"
SCRIPT = EXAMPLE / "check_quality.py"
#: Heights of the mesh at the steps; dihedral angles shrink with them. The third one fails.
HEIGHTS = (1, 0.5, 0.1, 0.02)
#: A simulation of three steps on three cells per rank. At step 1, the last rank passes a fault instead of its mesh.
SIMULATION = """
import sys
from paraview.catalyst import bridge
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkTable, vtkUnstructuredGrid
from vtkmodules.vtkParallelCore import vtkMultiProcessController
script, fault = (sys.argv + [""])[1:3]
controller = vtkMultiProcessController.GetGlobalController()
rank = controller.GetLocalProcessId()
is_last = rank == controller.GetNumberOfProcesses() - 1

def mesh(fault):
    grid, points = vtkUnstructuredGrid(), vtkPoints()
    for i in range(16):
        points.InsertNextPoint(3 * rank + i % 4, i // 4 % 2, i // 8)
    grid.SetPoints(points)
    for i in range(3):
        ids = [i + k for k in (0, 1, 5, 4, 8, 9, 13, 12)]
        if fault == "id":
            ids[0] = 999
        grid.InsertNextCell(VTK_HEXAHEDRON, 8, ids)
    return {"none": None, "table": vtkTable()}.get(fault, grid)

bridge.initialize()
bridge.add_pipeline(script, 2)
for step in range(3):
    bridge.coprocess(float(step), step, mesh(fault if is_last and step == 1 else ""))
    if rank == 0:
        print("simulated", step, flush=True)
bridge.finalize()
"""


@camaron_testing.require_display()
class TestInSitu(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        if not shutil.which("pvbatch"):
            self.skipTest("no pvbatch")

    def save_steps(self):
        mesh = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[0, 6] * 3))
        for step, height in enumerate(HEIGHTS):
            flat = simple.Transform(Input=mesh)
            flat.Transform.Scale = [1, 1, height]
            simple.SaveData(str(self.folder / f"step_{step}.vtu"), flat)

    def play_steps(self, folder, ranks=None, without=()):
        """The files that the script writes for the steps, and its output."""
        command = ["pvbatch", "--sym", "-m", "paraview.demos.filedriver_miniapp"]
        command += ["-g", str(self.folder / "step_*.vtu"), "-s", str(SCRIPT)]
        return self.simulate(folder, ranks, *command, without=without)

    def simulate(self, folder, ranks, *command, without=(), status=0):
        """The files that the script writes, and its output; `without` names variables of the environment."""
        folder = self.folder / folder
        environment = camaron_testing.environment_alone(without)
        environment.update(CAMARON_INSITU_FOLDER=str(folder), CAMARON_INSITU_INTERVAL="3")
        done = camaron_testing.run_ranks(
            ranks,
            *command,
            timeout=120,
            env=environment,
            cwd=self.folder,
        )
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return folder, done.stdout + done.stderr

    def test_verdicts(self):
        """Output every third step and where the mesh first fails; the same on two ranks."""
        self.save_steps()
        alone, text = self.play_steps("alone")
        for step, verdict in enumerate(("pass", "pass", "fail", "fail")):
            self.assertIn(f"step {step}, time {step}: {verdict}", text)
        names = sorted(path.name for path in alone.iterdir())
        kinds = ("quality", "verdicts", "worst")
        self.assertEqual(
            names,
            [f"{k}_{s:06}.{'png' if k == 'quality' else 'csv'}" for k in kinds for s in (0, 2, 3)],
        )
        with open(alone / "verdicts_000002.csv", newline="", encoding="utf-8") as file:
            rows = {row["Criterion"]: row for row in csv.DictReader(file)}
        self.assertEqual(rows["Volume"]["Verdict"], "pass")
        self.assertEqual(rows["MinDihedralAngle"]["Verdict"], "fail")
        self.assertEqual(rows["MinDihedralAngle"]["Cells"], "1080")
        if not shutil.which("mpiexec"):
            self.skipTest("no mpiexec")
        both, _ = self.play_steps("both", 2)
        self.compare(alone, both)

    def test_no_display(self):
        """Where ParaView would need a display, tables are written without pictures, and the simulation goes on."""
        self.save_steps()
        folder, text = self.play_steps("blind", without=("DISPLAY",))
        self.assertIn("step 3, time 3: fail", text)
        tables = {path.name for path in folder.iterdir() if path.suffix == ".csv"}
        self.assertEqual(len(tables), 6, tables)

    def compare(self, alone, both):
        """The files of one rank and of two."""
        names = sorted(path.name for path in alone.iterdir())
        self.assertEqual(names, sorted(path.name for path in both.iterdir()))
        for name in names:
            if name.endswith(".csv"):
                self.assertEqual((both / name).read_bytes(), (alone / name).read_bytes(), name)
            else:
                pictures = read_picture(alone / name), read_picture(both / name)
                self.assertLess(difference(*pictures), 0.01, name)

    def test_stop(self):
        """A simulation stops at the step whose mesh fails; the same on two ranks."""
        if (
            not shutil.which("ninja")
            or importlib.util.find_spec("paraview.modules.vtkPVInSitu") is None
        ):
            self.skipTest("no ninja, or a ParaView without Catalyst")
        folder = self.folder / "build"
        for step in (
            ["-G", "Ninja", "-S", str(EXAMPLE), "-B", str(folder)],
            ["--build", str(folder)],
        ):
            done = subprocess.run(["cmake", *step], capture_output=True, text=True, timeout=300)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        driver = [str(folder / "sheared_block"), str(SCRIPT), "20"]
        alone, text = self.simulate("alone", None, *driver)
        # The last layer has the slope 0.25 * step * (16 + 15) / 16; 10 degrees are a slope of 5.67.
        self.assertIn("step 11, time 11: pass", text)
        self.assertIn("stopped at step 12: the mesh fails its rules", text)
        self.assertNotIn("step 13", text)
        if not shutil.which("mpiexec"):
            self.skipTest("no mpiexec")
        both, text = self.simulate("both", 2, *driver)
        self.assertIn("stopped at step 12: the mesh fails its rules", text)
        self.compare(alone, both)
        (self.folder / "file").touch()
        for ranks in (None, 2):
            folder, text = self.simulate("file/none", ranks, *driver, status=1)
            self.assertIn(f"the check ends at step 0: {folder}: Not a directory", text)
            self.assertIn("stopped at step 0: the mesh cannot be checked", text)


class TestErrors(camaron_testing.TestCase):
    """An error on any rank is said once and ends the check on all of them; none waits for another."""

    def setUp(self):
        super().setUp()
        if not shutil.which("pvbatch") or not shutil.which("mpiexec"):
            self.skipTest("no pvbatch or mpiexec")
        (self.folder / "file").touch()
        (self.folder / "simulation.py").write_text(camaron_testing.QUICK_START + SIMULATION)

    def simulate(self, fault="", changes=(), ranks=2, **settings):
        """The exit status and the output of a simulation; `changes` are texts of the script and others instead."""
        text = SCRIPT.read_text()
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new, 1)
        script = self.folder / "script.py"
        script.write_text(text)
        environment = camaron_testing.environment_alone(("DISPLAY",))
        environment["CAMARON_INSITU_FOLDER"] = str(self.folder / "quality")
        environment["CAMARON_INSITU_INTERVAL"] = "1"
        environment.update({f"CAMARON_INSITU_{name}": value for name, value in settings.items()})
        arguments = filter(None, [fault])  # pvbatch cannot decode an empty one
        done = camaron_testing.run_ranks(
            ranks,
            *("pvbatch", "--sym", self.folder / "simulation.py", script, *arguments),
            timeout=200,  # where ranks wait for each other
            env=environment,
            cwd=self.folder,
        )
        self.assertNotIn("Traceback", done.stderr)
        return done.returncode, done.stdout + done.stderr

    def check(self, reason, *arguments, when="at step 1", **settings):
        """The reason is said once, and the simulation ends well; nothing of the step is left."""
        status, text = self.simulate(*arguments, **settings)
        self.assertEqual(text.count(f"the check ends {when}: {reason}"), 1, text)
        self.assertEqual(text.count("the check ends"), 1, text)
        self.assertIn("simulated 2", text)
        self.assertEqual(status, 0, text)
        left = {path.name for path in (self.folder / "quality").glob("*")}
        left.discard("quality_000000.png")  # 6.1 draws without a display
        steps = 1 if when == "at step 1" else 0
        self.assertEqual(len(left), 2 * steps, left)

    def test_mesh(self):
        """A mesh that one rank passes; it is fine at the first step."""
        reason = "The mesh cannot be evaluated: cell 0 uses point 999, but the mesh has 16 points"
        self.check(reason, "id")
        for fault, found in (("none", "vtkDataObject"), ("table", "vtkTable")):
            self.check(f'channel "input": expected a mesh, found {found}', fault)

    def test_settings(self):
        """What all ranks cannot use, and what the first one cannot."""
        when = "at step 0"
        for ranks in (1, 2):
            folder = str(self.folder / "file" / "quality")
            self.check(f"{folder}: Not a directory", when=when, ranks=ranks, FOLDER=folder)
        reason = "rules:2: expected the name of a criterion, found 'Volum'; did you mean Volume?"
        self.check(reason, "", [("Volume >", "Volum >")], when=when)
        when = "before the first step"
        reason = "CRITERION: expected the name of a criterion, found 'None'"
        self.check(reason, "", [('CRITERION = "Min', 'CRITERION = "None"  # ')], when=when)
        reason = "CAMARON_INSITU_INTERVAL: expected a number of steps, found '0'"
        self.check(reason, when=when, INTERVAL="0")

    def test_one_rank(self):
        """What goes wrong in Python on the last rank alone, before the first step and later."""
        fail = "if RANK == RANKS - 1: raise OSError(2, 'No such file', '/here')"
        when, place = "before the first step", "    quality = ElementQuality("
        self.check("/here: No such file", "", [(place, f"    {fail}\n{place}")], when=when)
        place = "    mesh.UpdatePipeline(time)"
        fail = fail.replace("if", "if time == 1 and")
        lines = [f"    {fail}", place]
        if camaron_testing.paraview_version() >= (6, 1):  # where all ranks wait for this one there
            lines.reverse()
        change = [(place, "\n".join(lines))]
        self.check("/here: No such file", "", change)
        status, text = self.simulate("", change, ON_ERROR="stop")
        self.assertEqual(text.count("the simulation ends at step 1: /here: No such file"), 1, text)
        self.assertNotIn("simulated 1", text)
        self.assertEqual(status, 2, text)

    def test_full_disk(self):
        """A table that cannot be written is not there."""
        limit = "import resource; resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))"
        place = "        FOLDER.mkdir("
        path = self.folder / "quality" / "verdicts_000000.csv"
        change = [(place, f"        {limit}\n{place}")]
        self.check(f"{path}: File too large", "", change, when="at step 0")


if __name__ == "__main__":
    camaron_testing.main()
