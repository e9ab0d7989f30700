# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Catalyst script of the examples, for a series of files that ParaView plays as a simulation and for a simulation in
C++, on 1 and 2 ranks."""

import csv
import importlib.util
import shutil
import subprocess

import camaron_testing
from inspection_testing import difference, read_picture
from paraview import simple

EXAMPLE = camaron_testing.EXAMPLES / "insitu"
SCRIPT = EXAMPLE / "check_quality.py"
TWO_RANKS = ("mpiexec", "--oversubscribe", "-n", "2")
#: Heights of the mesh at the steps; dihedral angles shrink with them. The third one fails.
HEIGHTS = (1, 0.5, 0.1, 0.02)


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

    def play_steps(self, folder, *ranks, without=()):
        """The files that the script writes for the steps, and its output."""
        command = [*ranks, "pvbatch", "--sym", "-m", "paraview.demos.filedriver_miniapp"]
        command += ["-g", str(self.folder / "step_*.vtu"), "-s", str(SCRIPT)]
        return self.simulate(folder, *command, without=without)

    def simulate(self, folder, *command, without=()):
        """The files that the script writes, and its output; `without` names variables of the environment."""
        folder = self.folder / folder
        environment = camaron_testing.environment_alone(without)
        environment.update(CAMARON_INSITU_FOLDER=str(folder), CAMARON_INSITU_INTERVAL="3")
        done = subprocess.run(
            command,
            capture_output=True,
            text=True,
            timeout=120,
            env=environment,
            cwd=self.folder,
        )
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
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
        both, _ = self.play_steps("both", *TWO_RANKS)
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
        alone, text = self.simulate("alone", *driver)
        # The last layer has the slope 0.25 * step * (16 + 15) / 16; 10 degrees are a slope of 5.67.
        self.assertIn("step 11, time 11: pass", text)
        self.assertIn("stopped at step 12: the mesh fails its rules", text)
        self.assertNotIn("step 13", text)
        if not shutil.which("mpiexec"):
            self.skipTest("no mpiexec")
        both, text = self.simulate("both", *TWO_RANKS, *driver)
        self.assertIn("stopped at step 12: the mesh fails its rules", text)
        self.compare(alone, both)


if __name__ == "__main__":
    camaron_testing.main()
