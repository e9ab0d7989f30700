# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example meshes and scripts."""

import collections
import csv
import math
import os
import runpy
import shutil
import subprocess

import camaron_testing
from inspection_testing import read_picture

MESHES = ["flange.visf", "polygon-ring.visf", "voronoi-ball.visf"]


class TestExamples(camaron_testing.TestCase):
    def test_meshes_are_those_of_the_script(self):
        """The script makes the same files, byte for byte."""
        script = runpy.run_path(str(camaron_testing.EXAMPLES / "make_examples.py"))
        script["main"](self.folder)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), MESHES)
        for name in MESHES:
            made, shipped = (folder / name for folder in (self.folder, camaron_testing.EXAMPLES))
            self.assertEqual(made.read_bytes(), shipped.read_bytes(), name)

    def test_meshes_are_sound(self):
        """Cells are closed and fit together; the boundary of the solids and the ring are closed."""
        for name in MESHES:
            _, faces, cells = camaron_testing.read_visf(camaron_testing.EXAMPLES / name)
            uses = collections.Counter(f for cell in cells for f in cell)
            self.assertLessEqual(set(uses.values()), {1, 2}, name)
            boundary = [faces[f] for f in range(len(faces)) if uses[f] < 2]
            for loops in [boundary, *([faces[f] for f in cell] for cell in cells)]:
                edges = collections.Counter(
                    frozenset(edge) for loop in loops for edge in zip(loop, loop[1:] + loop[:1])
                )
                self.assertEqual(set(edges.values()), {2}, name)

    def test_first_script(self):
        """What the README shows runs as it stands, from the root of the repository."""
        (self.folder / "Examples").symlink_to(camaron_testing.EXAMPLES)
        script = camaron_testing.EXAMPLES / "first_script.py"
        environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
        done = subprocess.run(
            [shutil.which("pvpython") or "pvpython", str(script)],
            cwd=self.folder,
            env=environment,
            capture_output=True,
            text=True,
            timeout=120,
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(self.folder / "statistics.csv", newline="", encoding="utf-8") as file:
            rows = {row["Criterion"]: row for row in csv.DictReader(file)}
        self.assertEqual(set(rows), {"Volume", "MinDihedralAngle", "EdgeLengthRatio"})
        self.assertEqual(rows["Volume"]["Count"], "800")
        mesh = self.fetch(self.open(self.folder / "voronoi-ball.vtu"))
        self.assertEqual(mesh.GetNumberOfCells(), 800)
        self.assertTrue(mesh.GetCellData().HasArray("MinDihedralAngle"))

    def test_correlate_flow(self):
        """The cases have all files, and the table is about the difference of the velocities."""
        script = runpy.run_path(str(camaron_testing.EXAMPLES / "correlate_flow.py"))
        folder = self.folder / "flow"
        script["prepare"](camaron_testing.EXAMPLES / "voronoi-ball.visf", folder)
        for scheme, speed in (("corrected", 1), ("uncorrected", 3)):
            case = folder / scheme
            names = {path.name for path in case.rglob("*") if path.is_file()}
            self.assertLess({"points", "U", "p", "k", "epsilon", "nut", "controlDict"}, names)
            text = (case / "0" / "U").read_text("utf-8")
            (case / "7").mkdir()
            (case / "7" / "U").write_text(text.replace("(0 0 0)", f"({speed} 0 0)", 1), "utf-8")
        table = script["compare"](folder)
        self.assertEqual(table.GetNumberOfRows(), 5)
        means = table.GetColumnByName("FieldMeanInside")
        means = [means.GetValue(row) for row in range(5)]
        self.assertEqual([mean for mean in means if not math.isnan(mean)], [2.0] * 4)

    def test_plugin_that_a_script_has_loaded(self):
        """The package finds readers and filters whoever has loaded the plugin, and for which namespace."""
        script = self.folder / "script.py"
        mesh = camaron_testing.EXAMPLES / "voronoi-ball.visf"
        library = camaron_testing.plugin_folder() / "Camaron.so"
        for load in (
            'LoadDistributedPlugin("Camaron", ns=globals())',
            f"LoadPlugin({str(library)!r}, remote=False, ns=globals())",
            f"LoadPlugin({str(library)!r}, remote=False)",
        ):
            script.write_text(
                f"from paraview.simple import *\n{load}\nimport camaron\n"
                f"assert camaron.check({str(mesh)!r}, ['Volume > 0'])['verdict'] == 'pass'\n"
            )
            camaron_testing.run_alone(script, timeout=100)


@camaron_testing.require_display()
class TestPictures(camaron_testing.TestCase):
    def test_pictures(self):
        """Scripts of Mesh Inspection make their pictures, of something colored in front of white. Those of a criterion
        are warm where it is bad, and nowhere of a strong blue."""
        for name in ("cut_under_glass", "isolines", "isosurfaces"):
            with self.subTest(name):
                picture = self.folder / f"{name}.png"
                script = camaron_testing.EXAMPLES / f"{name}.py"
                camaron_testing.run_alone(script, picture, 20000, timeout=100)
                colors = read_picture(picture)
                self.assertEqual(colors.shape[:2], (1000, 1200))
                spread = colors.max(axis=-1) - colors.min(axis=-1)
                self.assertGreater((spread > 40).mean(), 0.05)
                self.assertGreater((colors.min(axis=-1) == 255).mean(), 0.2)
                if name == "cut_under_glass":
                    warmth = colors[..., 0] - colors[..., 2]
                    self.assertGreater((warmth > 80).mean(), 0.01)
                    self.assertEqual((warmth < -80).sum(), 0)


if __name__ == "__main__":
    camaron_testing.main()
