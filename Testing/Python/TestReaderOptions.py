# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Options of readers, of the plugin and of ParaView, in every command and function."""

import shutil

import camaron
import camaron_testing
import openfoam_case
from paraview import simple


class TestReaderOptions(camaron_testing.TestCase):
    def grid(self):
        """A file with two cell arrays."""
        source = simple.Wavelet(WholeExtent=[0, 2] * 3)
        for name in ("T", "U"):
            source = simple.Calculator(
                Input=source, AttributeType="Cell Data", ResultArrayName=name, Function="1"
            )
        path = self.folder / "grid.vti"
        simple.SaveData(str(path), source)
        return path

    def arrays(self, reader):
        """The cell arrays after a conversion."""
        out = self.folder / "out.vtu"
        camaron.convert(self.grid(), out, reader=reader)
        return set(self.open(out).CellData.keys())

    def test_arrays(self):
        """Lists of arrays by the names of the property and of its label."""
        for value, expected in (("T", {"T"}), ("T,U", {"T", "U"}), (["U"], {"U"}), ("none", set())):
            for name in ("CellArrayStatus", "cell-arrays", "Cell Arrays"):
                self.assertEqual(self.arrays({name: value}), expected, f"{name} {value}")

    def test_wrong(self):
        for reader, reason in (
            (
                {"CellArrays": "T,V"},
                "grid.vti: CellArrays: no choice is named V; the file has T, U",
            ),
            (
                {"CelArrays": "T"},
                r"unknown option CelArrays \(did you mean .*cell-arrays=NAME,NAME",
            ),
            ({"FileName": "x"}, "unknown option FileName; the options of this reader are "),
        ):
            with self.assertRaisesRegex(ValueError, reason):
                self.arrays(reader)
        flat = self.folder / "flat.visf"
        flat.write_bytes((camaron_testing.EXAMPLES / "voronoi-ball.visf").read_bytes())
        with self.assertRaisesRegex(ValueError, "unknown option Zones; this reader has no options"):
            camaron.check(flat, ["Volume > 0"], reader={"Zones": "a"})
        with self.assertRaisesRegex(ValueError, "need the name of a file"):
            camaron.inspect(simple.Sphere(), self.folder / "report", reader={"Zones": "a"})

    def test_commands(self):
        """Each command passes them on: an unknown one is refused by its reader."""
        mesh, out = self.grid(), self.folder / "out.vtu"
        for words in (
            ("inspect", mesh, "--no-pictures", "-o", self.folder / "report"),
            ("check", mesh, "--rule", "Volume > 0"),
            ("select", mesh, "--by", "All"),
            ("convert", mesh, out),
            ("compare", mesh, mesh, "-o", self.folder / "comparison"),
        ):
            run = camaron_testing.run_command(*words, "--reader", "CellArrays=none")
            self.assertEqual((run.returncode, run.stderr), (0, ""), words)
            run = camaron_testing.run_command(*words, "--reader", "CellArray=none")
            self.assertEqual(run.returncode, 2, words)
            self.assertRegex(run.stderr, f"^camaron: {mesh}: unknown option CellArray ")
            run = camaron_testing.run_command(*words, "--reader=CellArrays")
            self.assertEqual(run.returncode, 2, words)
            self.assertRegex(run.stderr, "--reader: invalid NAME=VALUE value: 'CellArrays'")

    def test_compare(self):
        """One of two readers has to know an option."""
        other = camaron_testing.EXAMPLES / "flange.visf"
        meshes = (self.grid(), other, self.folder / "comparison")
        for pair in (meshes, (meshes[1], meshes[0], meshes[2])):
            camaron.compare(*pair, criteria=["Volume"], reader={"CellArrays": "none"})
            with self.assertRaisesRegex(ValueError, f"{pair[0]}: unknown option Zones"):
                camaron.compare(*pair, criteria=["Volume"], reader={"Zones": "a"})

    def test_arrays_of_another_case(self):
        """All arrays of a decomposed case are read, although those of the case itself were listed first."""
        case = self.folder / "case"
        openfoam_case.write(case, self.open(camaron_testing.EXAMPLES / "voronoi-ball.visf"))
        (case / "case.foam").touch()
        shutil.copytree(case / "constant", case / "processor0" / "constant")
        for folder in (case / "1", case / "processor0" / "1"):
            folder.mkdir()
        header = "FoamFile { version 2.0; format ascii; class volScalarField; object T; }\n"
        values = "boundaryField { walls { type fixedValue; value uniform 0; } }\n"
        field = case / "processor0" / "1" / "T"
        field.write_text(f"{header}internalField uniform 1;\n{values}")
        out = self.folder / "out.vtm"
        for reader, arrays in (
            ({"CaseType": "Decomposed Case"}, ["T"]),
            ({"CaseType": "Decomposed Case", "CellArrays": "T"}, ["T"]),
            ({"CellArrays": "none", "CaseType": "Decomposed Case"}, []),
        ):
            with self.subTest(reader):
                camaron.convert(case / "case.foam", out, reader=reader)
                self.assertEqual(self.open(out).CellData.keys(), arrays)


if __name__ == "__main__":
    camaron_testing.main()
