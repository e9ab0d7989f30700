# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""No output replaces a file that was read: of no command, writer, or list of selected elements."""

import contextlib
import io
import os
import shutil
import subprocess
from pathlib import Path

import camaron_testing
import openfoam_case
from camaron import cli, export
from camaron.common import pipeline
from camaron.common.inputs import Inputs
from paraview import simple

BALL = camaron_testing.EXAMPLES / "voronoi-ball.visf"
FLANGE = camaron_testing.EXAMPLES / "flange.visf"
RULE = "Volume > 0\n"


class TestInputFiles(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        self.mesh = Path(shutil.copy(BALL, self.folder / "mesh.visf"))
        self.rules = self.folder / "volume.rules"
        self.rules.write_text(RULE)

    def run_command(self, *words):
        """Status and standard error of a command."""
        out, err = io.StringIO(), io.StringIO()
        try:
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
                status = cli.main([*map(str, words)])
        except SystemExit as end:  # argparse's
            status = end.code
        return status, err.getvalue()

    def files(self):
        """The bytes of all files in the folder."""
        paths = (path for path in self.folder.rglob("*") if path.is_file())
        return {path: path.read_bytes() for path in paths}

    def refused(self, target, *words):
        """A command ends with status 2, names the output in one line, and changes no file."""
        before = self.files()
        status, message = self.run_command(*words)
        self.assertEqual((status, message.count("\n")), (2, 1), (words, message))
        self.assertIn(f"camaron: {target}: this file ", message)
        self.assertIn("choose another name", message)
        self.assertEqual(self.files(), before, words)

    def of_all_commands(self, mesh, target):
        """All ways in which a command can write a file of any name."""
        yield "check", mesh, "--rules", self.rules, "--junit", target
        yield "convert", mesh, target
        yield "select", mesh, "--by", "Worst N: Array=Volume", "-o", target

    def test_other_names_of_the_mesh(self):
        """The same path, another spelling, symbolic and hard links, a link to its folder."""
        (self.folder / "link.visf").symlink_to(self.mesh)
        os.link(self.mesh, self.folder / "hard.visf")
        (self.folder / "sub").mkdir()
        (self.folder / "here").symlink_to(self.folder)
        names = ["mesh.visf", "sub/../mesh.visf", "link.visf", "hard.visf", "here/mesh.visf"]
        for target in (os.path.join(self.folder, name) for name in names):
            for words in self.of_all_commands(self.mesh, target):
                self.refused(target, *words)

    def test_relative_names(self):
        with _chdir(self.folder):
            for words in self.of_all_commands("mesh.visf", "./mesh.visf"):
                self.refused(Path("./mesh.visf") if words[0] != "check" else "./mesh.visf", *words)

    def test_files_of_options(self):
        """Rules and acceptable ranges are inputs, too, and so is the surface of a step."""
        check = ("check", self.mesh, "--rules", self.rules)
        self.refused(self.rules, *check, "--junit", self.rules)
        report = self.folder / "report"
        report.mkdir()
        ranges = report / "summary.json"
        ranges.write_text("Volume 0 1\n")
        self.refused(
            ranges, "inspect", self.mesh, "--no-pictures", "--ranges", ranges, "-o", report
        )
        compare = ("compare", self.mesh, FLANGE, "--ranges", ranges, "-o", report)
        self.refused(ranges, *compare)
        surface = self.folder / "surface.vtp"
        simple.SaveData(str(surface), simple.Sphere())
        inside = f"Surface: Surface={surface}"
        self.refused(surface, "select", self.mesh, "--by", inside, "-o", surface)
        steps = f"Shape file: ShapeFile={self.rules}", f"Failed criteria: RangesFile={self.rules}"
        target = self.folder / "rules.txt"
        target.symlink_to(self.rules)
        for step in steps:
            self.refused(target, "select", self.mesh, "--by", step, "-o", target)

    def test_broken_mesh(self):
        """A mesh that cannot be read is not lost to the report about that."""
        self.mesh.write_bytes(self.mesh.read_bytes()[:3000])
        self.refused(self.mesh, "check", self.mesh, "--rules", self.rules, "--junit", self.mesh)

    def test_other_mesh_of_the_command(self):
        other = shutil.copy(FLANGE, self.folder / "other.visf")
        words = "check", self.mesh, other, "--rules", self.rules
        self.refused(other, *words, "--junit", other)
        report = self.folder / "out" / "other"
        report.mkdir(parents=True)
        inside = report / "mesh.vtu"
        simple.SaveData(str(inside), self.open(FLANGE))
        words = "inspect", "--no-pictures", other, inside, "-o", report.parent
        self.refused(inside, *words)

    def test_companions_of_tetgen(self):
        """The files beside the one that was named."""
        seeds = camaron_testing.ROOT / "Readers" / "TetGen" / "Testing" / "Seeds"
        for name in ("tets.ele", "tets.node", "tets.face"):
            shutil.copy(seeds / name, self.folder)
        mesh, points = self.folder / "tets.ele", self.folder / "tets.node"
        self.refused(points, "check", mesh, "--rules", self.rules, "--junit", points)
        mesh.write_text("3 4 0\n1 1 2 3 99\n")  # broken
        before = points.read_bytes()
        status, message = self.run_command("check", mesh, "--rules", self.rules, "--junit", points)
        self.assertEqual(status, 2)
        self.assertIn("tets.node: this file is read", message.replace("belongs to", ""))
        self.assertEqual(points.read_bytes(), before)

    def pieces(self, *names):
        """Files of a mesh in the formats of ParaView that name others."""
        source = self.open(self.mesh)
        for name in names:
            simple.SaveData(str(self.folder / name), source)
        return source

    def test_pieces_of_paraview(self):
        """Files that .pvtu, .vtm, .pvd and others name, in lists of lists, too."""
        source = self.pieces("mesh.pvtu")
        simple.SaveData(str(self.folder / "blocks.vtm"), simple.GroupDatasets(Input=[source]))
        simple.SaveData(str(self.folder / "steps.pvd"), source)
        (self.folder / "outer.pvd").write_text(
            '<VTKFile type="Collection"><Collection>'
            '<DataSet timestep="0" part="0" file="blocks.vtm"/></Collection></VTKFile>\n'
        )
        tried = 0
        for mesh, pattern in (
            ("mesh.pvtu", "mesh/*"),
            ("blocks.vtm", "blocks/*"),
            ("steps.pvd", "steps/**/*.vt?"),
            ("outer.pvd", "blocks/*"),
            ("outer.pvd", "blocks.vtm"),
        ):
            pieces = [path for path in self.folder.glob(pattern) if path.is_file()]
            self.assertTrue(pieces, pattern)
            for piece in pieces:
                for words in self.of_all_commands(self.folder / mesh, piece):
                    if words[0] == "convert" and piece.suffix == ".vtm":
                        continue  # needs a writer of blocks
                    self.refused(piece, *words)
                    tried += 1
        self.assertGreater(tried, 10)

    def test_standard_output(self):
        """A file to which the shell appends the output; the same file is not one of the arguments."""
        self.pieces("mesh.pvtu")
        piece = next(self.folder.glob("mesh/*"))
        before = piece.read_bytes()
        words = ["check", str(self.folder / "mesh.pvtu"), "--rules", str(self.rules), "--json"]
        with open(piece, "ab") as output:
            done = subprocess.run(
                [
                    shutil.which("pvpython"),
                    str(camaron_testing.ROOT / "Scripts" / "camaron"),
                    *words,
                ],
                stdout=output,
                stderr=subprocess.PIPE,
                text=True,
            )
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("standard output goes to a file of", done.stderr)
        self.assertEqual(piece.read_bytes(), before)

    def test_series(self):
        """Every step of a series, not only the one that is read."""
        shutil.copy(self.mesh, self.folder / "next.visf")
        series = self.folder / "two.visf.series"
        series.write_text(
            '{"file-series-version": "1.0", "files": [{"name": "mesh.visf", "time": 0}, '
            '{"name": "next.visf", "time": 1}]}'
        )
        for target in (self.mesh, self.folder / "next.visf"):
            self.refused(target, "check", series, "--rules", self.rules, "--junit", target)

    def test_openfoam_case(self):
        """The mesh of a case is an input, a set of it is not."""
        openfoam_case.write(self.folder / "case", self.open(self.mesh))
        case = self.folder / "case" / "case.foam"
        case.touch()
        inside = case.parent / "constant" / "polyMesh"
        settings = case.parent / "system" / "controlDict"
        settings.touch()
        for target in (inside / "points", inside / "owner", settings):
            self.refused(target, "check", case, "--rules", self.rules, "--junit", target)
        (inside / "sets").mkdir()
        (inside / "sets" / "bad").write_text("earlier")
        self.assertIsNone(Inputs(case).replaced_by(inside / "sets" / "bad")[0])

    def test_ensight_steps(self):
        """Names of time series have a star for each digit."""
        case = self.folder / "flow.case"
        case.write_text("FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: flow.geo***\n")
        (self.folder / "flow.geo012").touch()
        (self.folder / "flow.geo12").touch()
        inputs = Inputs(case)
        self.assertEqual(inputs.replaced_by(self.folder / "flow.geo012")[0], str(case))
        self.assertIsNone(inputs.replaced_by(self.folder / "flow.geo12")[0])

    def test_reports(self):
        """A report does not replace the mesh that an earlier one wrote, nor its pieces."""
        report = self.folder / "report"
        words = "inspect", "--no-pictures", "-o", report
        self.assertEqual(self.run_command(*words, self.mesh), (0, ""))
        mesh = next(path for path in report.glob("mesh.*"))
        self.refused(mesh, *words, mesh)
        simple.SaveData(str(report / "mesh.pvtu"), self.open(self.mesh))
        mesh.unlink()
        summary = report / "summary.json"
        summary.write_text(summary.read_text().replace(mesh.name, "mesh.pvtu"))
        status, _ = self.run_command(*words, report / "mesh.pvtu")
        self.assertEqual(status, 0)
        self.assertTrue((report / "mesh.pvtu").exists() and any((report / "mesh").iterdir()))

    def test_writers(self):
        """File > Save Data with a writer of the plugin; the mesh went through filters."""
        cut = simple.Threshold(
            Input=simple.ElementQuality(Input=self.open(self.mesh), Criteria=["Volume"]),
            Scalars=["CELLS", "Volume"],
        )
        link = self.folder / "link.off"
        link.symlink_to(self.mesh)
        before = self.mesh.read_bytes()
        for target in (self.mesh, link):
            with pipeline.Messages() as messages, contextlib.suppress(RuntimeError):
                simple.SaveData(str(target), cut)
            self.assertIn("the mesh was read from this file", messages.errors[0])
            self.assertEqual(self.mesh.read_bytes(), before)
        simple.SaveData(str(self.folder / "other.visf"), cut)
        self.assertTrue((self.folder / "other.visf").exists())

    def test_writers_after_readers_of_paraview(self):
        """Readers of ParaView with one and with several names."""
        self.pieces("a.vtu", "b.vtk")
        for name in ("a.vtu", "b.vtk"):
            source = self.open(self.folder / name)
            target = self.folder / f"link-{name}.visf"
            target.symlink_to(self.folder / name)
            before = (self.folder / name).read_bytes()
            with pipeline.Messages() as messages, contextlib.suppress(RuntimeError):
                simple.SaveData(str(target), source)
            self.assertIn("the mesh was read from this file", "".join(messages.errors))
            self.assertEqual((self.folder / name).read_bytes(), before)

    def test_lists(self):
        select = simple.SelectElements(Input=self.open(self.mesh), Strategy="All")
        target = self.folder / "ids.txt"
        os.link(self.mesh, target)
        with self.assertRaisesRegex(ValueError, "ids.txt: this file"):
            export.write_list(select, target)
        self.assertEqual(target.read_bytes(), BALL.read_bytes())

    def test_other_files_are_replaced(self):
        """What was not read by this command may be written, also if another command read it."""
        other = self.folder / "other.visf"
        for words in (
            ("convert", self.mesh, other),
            ("convert", FLANGE, self.mesh),
            ("select", other, "--by", "All", "-o", self.mesh),
            ("check", other, "--rules", self.rules, "--junit", self.folder / "old.xml"),
            ("check", other, "--rules", self.rules, "--junit", self.folder / "old.xml"),
        ):
            self.assertEqual(self.run_command(*words), (0, ""), words)


@contextlib.contextmanager
def _chdir(folder):
    before = os.getcwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)


if __name__ == "__main__":
    camaron_testing.main()
