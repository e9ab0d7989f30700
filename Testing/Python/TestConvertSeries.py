# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""camaron.convert: series of files and time steps."""

import contextlib
import json
import re

import camaron_testing
from camaron import convert
from paraview import simple

CUBE = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
TETRAHEDRA = [(10, (0, 1, 3, 4)), (10, (2, 3, 1, 6))]


class TestConvertSeries(camaron_testing.TestCase):
    def mesh(self):
        return camaron_testing.write_vtk(self.folder / "two.vtk", CUBE, TETRAHEDRA)

    def write_series(self, name, *files):
        listed = ", ".join(f'{{"name": "{name}", "time": {i}}}' for i, name in enumerate(files))
        path = self.folder / name
        path.write_text(f'{{"file-series-version": "1.0", "files": [{listed}]}}')
        return path

    def write_times(self, time):
        """A series with an entry of which ParaView's parser ends the program."""
        simple.SaveData(str(self.folder / "a.vtu"), self.open(self.mesh()))
        path = self.folder / f"t{len(list(self.folder.iterdir()))}.vtu.series"
        entries = f'{{"name": "a.vtu", "time": 0}}, {{"name": "b.vtu", "time": {time}}}'
        path.write_text(f'{{"file-series-version": "1.0", "files": [{entries}]}}')
        return path

    def test_series(self):
        """A series goes to the plugin's reader where the files under its name would."""
        tetra = camaron_testing.write_vtk(self.folder / "one.vtk", CUBE, TETRAHEDRA[:1])
        for kind in ("msh", "ply", "off"):
            options = {"write_cells": "on"} if kind == "ply" else {}
            alone = []
            for step, source in enumerate((tetra, self.mesh())):
                convert(source, self.folder / f"s{step}.{kind}", **options)
                alone.append(self.folder / f"s{step}-alone.visf")
                convert(self.folder / f"s{step}.{kind}", alone[-1])
            series = self.write_series(f"s.{kind}.series", f"s0.{kind}", f"s1.{kind}")
            for step in range(2):
                target = self.folder / f"{kind}{step}.visf"
                notes = convert(series, target, time=str(step))
                self.assertTrue(any("Of 2 time steps" in note for note in notes), notes)
                self.assertEqual(target.read_bytes(), alone[step].read_bytes(), kind)
            with self.assertRaisesRegex(ValueError, "no time step 7: the steps are 0 to 1"):
                convert(series, self.folder / "x.visf", time="7")

    def test_missing_time_step(self):
        """A file without time has one step, number 0."""
        target = self.folder / "x.visf"
        for time in ("first", "last", "0"):
            self.assertEqual(convert(self.mesh(), target, time=time), [])
        target.unlink()
        for time, reason in (("3", "no time step 3: 0 is the only one"), ("x", "not 'x'")):
            with self.assertRaisesRegex(ValueError, reason):
                convert(self.mesh(), target, time=time)
        self.assertFalse(target.exists())

    def test_broken_steps(self):
        """The error names the file of a series that cannot be read; steps that can be read are."""
        source = simple.AppendDatasets(Input=simple.Wavelet(WholeExtent=[0, 2] * 3))
        target = self.folder / "x.visf"
        for kind in ("vtu", "vtk", "visf"):
            for i in range(3):
                simple.SaveData(str(self.folder / f"s{i}.{kind}"), source)
        pieces = "".join(f'<DataSet timestep="{i}" file="s{i}.vtu"/>' for i in range(3))
        collection = self.folder / "s.pvd"
        collection.write_text(
            f"<VTKFile type='Collection'><Collection>{pieces}</Collection></VTKFile>"
        )
        lists = [
            self.write_series(f"s.{kind}.series", *(f"s{i}.{kind}" for i in range(3)))
            for kind in ("vtu", "vtk", "visf")
        ] + [collection]
        for series in lists:
            kind = series.name.split(".")[1].replace("pvd", "vtu")
            for number, time in ((0, "first"), (1, "1")):
                step = self.folder / f"s{number}.{kind}"
                whole = step.read_bytes()
                for content in (None, b"", b"no mesh", whole[: len(whole) // 3]):
                    step.unlink() if content is None else step.write_bytes(content)
                    with self.subTest(series=series.name, number=number, content=content):
                        with self.assertRaisesRegex(
                            RuntimeError, rf"{series.name}: .*{step.name}.*[a-z]"
                        ):
                            convert(series, target, time=time)
                        if number:
                            convert(series, target, time="last")
                    step.write_bytes(whole)

    def test_broken_parts(self):
        """ParaView leaves out parts of a step that are missing or cut; the commands refuse the step."""
        source = simple.AppendDatasets(Input=simple.Wavelet(WholeExtent=[0, 2] * 3))
        for name in ("a.vtu", "b.vtu"):
            simple.SaveData(str(self.folder / name), source)
        part = "<DataSet timestep='{}' file='{}'/>"
        comment = f"<!-- {part.format(0, 'gone.vtu')} -->"
        pieces = comment + "".join(
            part.format(*one) for one in ((0, "a.vtu"), (0, "b.vtu"), (1, "a.vtu"))
        )
        path = self.folder / "parts.pvd"
        path.write_text(f"<VTKFile type='Collection'><Collection>{pieces}</Collection></VTKFile>")
        convert(path, self.folder / "x.vtm", time="first")
        part = self.folder / "b.vtu"
        whole = part.read_bytes()
        for content in (whole[:900], whole[:-20], b"", b"no mesh", None):
            part.unlink() if content is None else part.write_bytes(content)
            with self.subTest(content=content):
                with self.assertRaisesRegex(RuntimeError, "parts.pvd: b.vtu: "):
                    convert(path, self.folder / "x.vtm", time="first")
                convert(path, self.folder / "x.vtu", time="last")

    def test_steps_without_times(self):
        """Files of a series without times are numbered: the array that is cut is of the step that is read."""
        for step, name in enumerate("ab"):
            simple.SaveData(
                str(self.folder / f"s{step}.vtk"),
                simple.Calculator(Input=self.open(self.mesh()), ResultArrayName=name, Function="1"),
                FileType="Ascii",
            )
            path = self.folder / f"s{step}.vtk"
            text = path.read_text()
            path.write_text(
                text[: re.search(rf"\n(SCALARS )?{name} .*\n(LOOKUP.*\n)?", text).end() + 9]
            )
        series = self.folder / "s.vtk.series"
        mixed = [{"name": "s0.vtk", "time": 7}, "s1.vtk"]
        for files in (["s0.vtk", "s1.vtk"], mixed):
            series.write_text(json.dumps({"file-series-version": "1.0", "files": files}))
            for step, name in enumerate("ab"):
                with self.subTest(files=files, step=step):
                    notes = convert(series, self.folder / "x.visf", time=str(step))
                    lost = [note for note in notes if note.startswith("Left out: ")]
                    self.assertEqual(len(lost), 1, notes)
                    self.assertIn(f"the array {name} cannot be read", lost[0])

    def test_lenient_series(self):
        """What ParaView's parser of JSON accepts, and what of it ends the program."""
        simple.SaveData(str(self.folder / "a.vtu"), self.open(self.mesh()))
        series = self.folder / "a.vtu.series"
        begin = '{"file-series-version": "1.0", "files": [{"name": "a.vtu", "time": '
        for content in (
            f"// a comment\n{begin}0}}, ]}}",
            *(f"{begin}{time}}}]}}" for time in ("null", "true", "1e3")),
        ):
            series.write_text(content)
            with self.subTest(content):
                convert(series, self.folder / "x.visf")
        for content in (
            *(f"{begin}{time}}}]}}" for time in ('"1"', "[]", "{}", "1e999")),
            "[]",
            '{"files": "a.vtu"}',
            '{"files": {"a": 1}}',
        ):
            series.write_text(content)
            with self.subTest(content):
                with self.assertRaisesRegex(RuntimeError, "expected a (series|number)"):
                    convert(series, self.folder / "x.visf")
        for content in (f"{begin}1{'0' * 400}}}]}}", "{"):  # what the reader makes of it
            series.write_text(content)
            with self.subTest(content):
                with contextlib.suppress(RuntimeError):
                    convert(series, self.folder / "x.visf")

    def test_other_series(self):
        """A series that is none, or of another program's files, is no Fluent mesh."""
        (self.folder / "g.msh").write_text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n")
        gmsh = self.write_series("g.msh.series", "g.msh")
        nothing = self.folder / "n.msh.series"
        nothing.write_text('{"files": []}')
        missing = self.write_series("m.msh.series", "missing.msh")
        for series, reason in (
            (gmsh, "(the first file of the series|g.msh: this) is a Gmsh mesh"),
            (nothing, "expected a series of files"),
            (self.write_times('"0"'), r'file 1 of the series, b.vtu, has the time "0", expected a'),
            (self.write_times("NaN"), "b.vtu, has the time NaN, expected a number"),
            (self.write_times('0}, {"time": 1'), "file 2 of the series has no name: expected {"),
            (missing, "missing.msh: there is no such file"),
        ):
            with self.assertRaisesRegex(RuntimeError, reason):
                convert(series, self.folder / "x.visf")

    def test_time_steps(self):
        """One step is converted, with a note, or all steps are written to numbered files."""
        for step in range(2):
            convert(camaron_testing.EXAMPLES / "flange.visf", self.folder / f"s{step}.visf")
        series = self.write_series("s.visf.series", "s0.visf", "s1.visf")
        (note,) = convert(series, self.folder / "one.visf")
        self.assertIn("Of 2 time steps, step 1", note)
        self.assertEqual(convert(series, self.folder / "all.visf", write_time_steps="on"), [])
        names = sorted(path.name for path in self.folder.glob("all*"))
        self.assertEqual(names, ["all_0.visf", "all_1.visf"])


if __name__ == "__main__":
    camaron_testing.main()
