# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Catalyst script of the examples, for a series of files that ParaView plays as a simulation, on 1 and 2 ranks."""

import csv
import shutil
import subprocess

import camaron_testing
from inspection_testing import difference, read_picture
from paraview import simple

SCRIPT = camaron_testing.EXAMPLES / "insitu" / "check_quality.py"
#: Heights of the mesh at the steps; dihedral angles shrink with them. The third one fails.
HEIGHTS = (1, 0.5, 0.1, 0.02)


@camaron_testing.require_display()
class TestInSitu(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        if not shutil.which("pvbatch"):
            self.skipTest("no pvbatch")
        mesh = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[0, 6] * 3))
        for step, height in enumerate(HEIGHTS):
            flat = simple.Transform(Input=mesh)
            flat.Transform.Scale = [1, 1, height]
            simple.SaveData(str(self.folder / f"step_{step}.vtu"), flat)

    def simulate(self, folder, *ranks):
        """The files that the script writes, and its output."""
        folder = self.folder / folder
        environment = camaron_testing.environment_alone()
        environment.update(CAMARON_INSITU_FOLDER=str(folder), CAMARON_INSITU_INTERVAL="3")
        command = [*ranks, "pvbatch", "--sym", "-m", "paraview.demos.filedriver_miniapp"]
        steps = ["-g", str(self.folder / "step_*.vtu"), "-s", str(SCRIPT)]
        done = subprocess.run(
            [*command, *steps],
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
        alone, text = self.simulate("alone")
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
        both, _ = self.simulate("both", "mpiexec", "--oversubscribe", "-n", "2")
        for name in names:
            if name.endswith(".csv"):
                self.assertEqual((both / name).read_bytes(), (alone / name).read_bytes(), name)
            else:
                pictures = read_picture(alone / name), read_picture(both / name)
                self.assertLess(difference(*pictures), 0.01, name)


if __name__ == "__main__":
    camaron_testing.main()
