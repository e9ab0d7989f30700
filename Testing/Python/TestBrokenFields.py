# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files whose mesh is whole and whose arrays are not, as those of a simulation that crashed."""

import re
import shutil

import camaron
import camaron_testing
import openfoam_case
from camaron.common import silent_losses
from paraview import simple

RULES = ["Volume > 0"]


class TestBrokenFields(camaron_testing.TestCase):
    def grid(self, name, **options):
        """A file of eight voxels with point arrays p, q and a cell array c."""
        source = simple.Wavelet(WholeExtent=[0, 2] * 3)
        source = simple.AppendDatasets(Input=source)
        for array, kind in (("p", "Point Data"), ("q", "Point Data"), ("c", "Cell Data")):
            source = simple.Calculator(
                Input=source, AttributeType=kind, ResultArrayName=array, Function="1"
            )
        path = self.folder / name
        simple.SaveData(str(path), source, **options)
        return path

    def cut(self, path, *arrays):
        """Removes most of the values of arrays in a file in ASCII."""
        text = path.read_text("utf-8")
        for array in arrays:
            found = re.search(rf'<DataArray [^>]*Name="{array}"[^>]*>\s*', text)
            end = text.index("<", found.end())
            text = text[: found.end()] + "1 1\n" + text[end:]
        path.write_text(text, "utf-8")
        return path

    def has_note(self, notes, *names):
        found = [note for note in notes if note.startswith("Left out: ")]
        self.assertEqual(len(found), len(names), notes)
        for name in names:
            self.assertTrue(
                any(f"the array {name} cannot be read" in note for note in found), found
            )

    def test_commands(self):
        """The mesh is evaluated, the arrays are named; --strict refuses."""
        path = self.cut(self.grid("grid.vtu", DataMode="Ascii"), "q", "c")
        result = camaron.check(path, RULES)
        self.assertEqual((result["verdict"], result["cells"]), ("pass", 8))
        self.has_note(result["notes"], "q", "c")
        summary = camaron.inspect(path, self.folder / "report", with_pictures=False)
        self.assertEqual(summary["mesh"]["cells"], 8)
        self.has_note(summary["notes"], "q", "c")
        arrays = self.open(self.folder / "report" / "mesh.vtu")
        self.assertIn("p", arrays.PointData.keys())
        self.assertNotIn("q", arrays.PointData.keys())
        out = self.folder / "out.vtu"
        self.has_note(camaron.convert(path, out), "q", "c")
        self.assertEqual(set(self.open(out).PointData.keys()), {"p", "RTData"})
        self.has_note(camaron.select(path, ["All"])["notes"], "q", "c")
        for call in (
            lambda: camaron.check(path, RULES, strict=True),
            lambda: camaron.inspect(path, self.folder / "no", strict=True),
            lambda: camaron.convert(path, self.folder / "no.vtu", strict=True),
            lambda: camaron.select(path, ["All"], strict=True),
            lambda: camaron.compare(path, path, self.folder / "no", strict=True),
        ):
            with self.assertRaisesRegex(
                RuntimeError, "grid.vtu: the array c cannot be read .*; the"
            ):
                call()
        words = ("check", path, "--rule", RULES[0])
        self.assertEqual(camaron_testing.run_command(*words).returncode, 0)
        self.assertEqual(camaron_testing.run_command(*words, "--strict").returncode, 2)

    def test_legacy_file(self):
        """A legacy file that ends early: the array that lacks values goes, with those after it; no number of it stays."""
        for kind, lower in (("Ascii", False), ("Binary", False), ("Ascii", True)):
            whole = self.grid(f"{kind}.vtk", FileType=kind).read_bytes()
            whole = re.sub(rb"\n(SCALARS )?p ", rb"\n\1p%20x ", whole)  # as VTK writes p x
            path = self.folder / f"cut-{kind}.vtk"
            headers = re.compile(
                rb"\n(?:SCALARS (\S+) double[ 1]*\nLOOKUP_TABLE default|(\S+) 1 \d+ \w+)\n"
            )
            kept: set[str] = set()
            for header in headers.finditer(whole):
                lost = (header[1] or header[2]).decode().replace("%20", " ")
                cut = whole[: header.end() + 9]
                if lower:
                    cut = cut.replace(b"SCALARS", b" scalars").replace(b"_DATA", b"_data")
                path.write_bytes(cut)
                with self.subTest(kind, lost=lost, lower=lower):
                    self.has_note(camaron.check(path, RULES)["notes"], lost)
                    with self.assertRaisesRegex(RuntimeError, f"the array {lost} cannot be read"):
                        camaron.check(path, RULES, strict=True)
                    camaron.convert(path, self.folder / "legacy.vtu")
                    found = self.open(self.folder / "legacy.vtu")
                    self.assertEqual({*found.PointData.keys(), *found.CellData.keys()}, kept)
                    self.assertEqual(found.GetDataInformation().GetNumberOfCells(), 8)
                kept = kept | {lost}
            self.assertEqual(kept, {"c", "q", "RTData", "p x"})

    def test_legacy_mesh(self):
        """A legacy file without all points and cells is no mesh, whatever its reader makes of it."""
        ends = {b"POINTS": 30, b"OFFSETS": 40, b"CONNECTIVITY": 40}
        mesh = self.grid("whole.vtk", FileType="Binary").read_bytes()
        structured = self.folder / "structured.vtk"
        simple.SaveData(str(structured), self.wavelet_points(), FileType="Binary")
        cases = [(mesh, key, size) for key, size in ends.items()]
        cases.append((structured.read_bytes(), b"POINTS", 30))
        path = self.folder / "cut.vtk"
        for number, (whole, key, size) in enumerate(cases):
            path.write_bytes(whole[: whole.index(key) + size])
            with self.subTest(key, number=number):
                with self.assertRaisesRegex(RuntimeError, "cut.vtk: .*binary data"):
                    camaron.convert(path, self.folder / "none.vtu")
                self.assertFalse((self.folder / "none.vtu").exists())
        path.write_bytes(mesh[: mesh.index(b"SCALARS q double") + 60])
        before = len(simple.GetSources())
        camaron.check(path, RULES)
        self.assertEqual(len(simple.GetSources()), before)

    def wavelet_points(self):
        """A structured grid."""
        return simple.Transform(Input=simple.Wavelet(WholeExtent=[0, 2] * 3))

    def test_broken_mesh(self):
        """Without points there is no mesh, whatever the arrays."""
        path = self.cut(self.grid("grid.vtu", DataMode="Ascii"), "q", "Points")
        with self.assertRaises(RuntimeError) as raised:
            camaron.check(path, RULES)
        self.assertNotIn('"q"', str(raised.exception))

    def test_piece_without_array(self):
        """A piece that lacks an array, of which the list of pieces tells."""
        path = self.grid("grid.vtu", DataMode="Ascii")
        text = path.read_text("utf-8")
        (self.folder / "a.vtu").write_text(text, "utf-8")
        without = re.sub(r'<DataArray [^>]*Name="q".*?</DataArray>', "", text, flags=re.DOTALL)
        (self.folder / "b.vtu").write_text(without, "utf-8")
        points = '<PDataArray type="Float32" Name="Points" NumberOfComponents="3"/>'
        arrays = "".join(f'<PDataArray type="Float64" Name="{name}"/>' for name in "pq")
        pieces = self.folder / "parts.pvtu"
        pieces.write_text(
            '<VTKFile type="PUnstructuredGrid" version="1.0" byte_order="LittleEndian">'
            f"<PUnstructuredGrid><PPointData>{arrays}</PPointData><PPoints>{points}</PPoints>"
            '<Piece Source="a.vtu"/><Piece Source="b.vtu"/></PUnstructuredGrid></VTKFile>'
        )
        result = camaron.check(pieces, RULES)
        self.assertEqual((result["verdict"], result["cells"]), ("pass", 16))
        self.has_note(result["notes"], "q")

    def test_field_of_openfoam(self):
        """A field that was half written when the program died."""
        case = self.folder / "case"
        openfoam_case.write(case, self.open(camaron_testing.EXAMPLES / "voronoi-ball.visf"))
        (case / "case.foam").touch()
        (case / "1").mkdir()
        header = "FoamFile {{ version 2.0; format ascii; class volScalarField; object {}; }}\n"
        for name, size in (("T", 800), ("p", 300)):
            values = "\n".join(["1"] * size)
            end = ")\n;\nboundaryField { }\n" if size == 800 else ""
            (case / "1" / name).write_text(
                header.format(name)
                + f"dimensions [0 0 0 0 0 0 0];\ninternalField nonuniform List<scalar>\n800\n(\n{values}\n{end}"
            )
        result = camaron.check(case / "case.foam", RULES)
        self.assertEqual((result["verdict"], result["cells"]), ("pass", 800))
        self.has_note(result["notes"], "p")
        (case / "1" / "p").write_bytes(bytes(100))
        (case / "1" / "U").touch()
        (case / "2").mkdir()
        (case / "2" / "k").touch()
        for name in (".gitkeep", "k~", "k_0", "k.bak"):
            (case / "2" / name).touch()
        (case / "processor0" / "2").mkdir(parents=True)
        (case / "processor0" / "2" / "old").touch()
        self.has_note(camaron.check(case / "case.foam", RULES, time="first")["notes"], "p", "U")
        self.has_note(camaron.check(case / "case.foam", RULES)["notes"], "k")
        with self.assertRaisesRegex(RuntimeError, "the array k cannot be read"):
            camaron.check(case / "case.foam", RULES, strict=True)

    def test_boundary_of_openfoam(self):
        """A field whose values of cells are whole, and whose boundary is cut, also in a region."""
        case = self.folder / "case"
        openfoam_case.write(case, self.open(camaron_testing.EXAMPLES / "voronoi-ball.visf"))
        (case / "case.foam").touch()
        shutil.copytree(case / "constant" / "polyMesh", case / "constant" / "solid" / "polyMesh")
        (case / "1" / "solid").mkdir(parents=True)
        header = "FoamFile {{ version 2.0; format {}; class {}; object T; }}\n"
        fixed = "boundaryField { walls { type fixedValue; value uniform 0; } }\n// { the end\n"
        whole = header.format("ascii", "volScalarField") + "internalField uniform 1;\n" + fixed
        inside = whole.replace("internalField", "value").replace(
            "volScalarField", "volScalarField::Internal"
        )
        faces = int(
            re.search(r"nFaces (\d+)", (case / "constant/polyMesh/boundary").read_text())[1]
        )
        values = b"nonuniform List<scalar>\n%d\n(" % faces + b"}" * 8 * faces + b")"
        binary = whole.replace("ascii", "binary").encode().replace(b"uniform 0", values)
        # In single precision, with what looks like the end of a list in double precision behind it.
        single = binary.replace(b"binary;", b'binary; arch "LSB;label=32;scalar=32";')
        single = single.replace(b"}" * 8 * faces, b"}" * 4 * faces)
        single = single.replace(b"// { the end", b"//" + b")" * 8 * faces)
        code = 'code #{ if (a) { T.boundaryField()[0]; }\n// } "\n#}; } }\n// end of boundaryField'
        coded = whole.partition("boundaryField")[0] + f"boundaryField // {{\n\t{{ walls {{ {code}"
        fields = {
            b"": [
                whole.encode(),
                inside.partition("boundary")[0].encode(),
                binary,
                single,
                coded.encode(),
            ],
            b"ends before": [
                *(whole[: whole.index(word)].encode() for word in ("boundary", "} }", " }\n//")),
                binary[: binary.rindex(b"}")],
            ],
        }
        for file in (case / "1" / "T", case / "1" / "solid" / "T"):
            for reason, texts in fields.items():
                for number, text in enumerate(texts):
                    with self.subTest(file=file, reason=reason, number=number):
                        file.write_bytes(text)
                        result = camaron.check(case / "case.foam", RULES)
                        found = [n for n in result["notes"] if n.startswith("Incomplete: ")]
                        self.assertEqual(len(found), len(reason) > 0, result["notes"])
                        if reason:
                            with self.assertRaisesRegex(RuntimeError, "the array T ends before"):
                                camaron.check(case / "case.foam", RULES, strict=True)
                        else:
                            camaron.check(case / "case.foam", RULES, strict=True)
            file.write_text(whole)
        (case / "1" / "solid" / "U").touch()
        self.has_note(camaron.check(case / "case.foam", RULES)["notes"], "U")

    def test_ends_of_fields(self):
        """The end of the boundary of a field, where code, macros and comments name it, too."""
        head = "FoamFile { version 2.0; format ascii; class volScalarField; }\ninternalField uniform 1;"
        code = 'code #{ if (a) { T.boundaryField()[0]; } // } " \n#};'
        binary = head.replace("ascii", "binary") + " boundaryField { a { v List<vector> 2("
        single = binary.replace("class", 'arch "LSB;label=32;scalar=32"; class')
        file = self.folder / "T"
        for ends, content in (
            (False, f"{head} boundaryField {{ a {{ {code} v $:boundaryField.b.v; }} }}"),
            (True, f"{head} boundaryField {{ a {{ {code} v $:boundaryField"),
            (True, f"{head} boundaryField {{ a {{ {code[:30]}"),
            (False, f"{head}\nboundaryField\n{{\n}}\n// boundaryField"),
            (False, f"{head}\nboundaryField // {{\n{{ }}\n/* {{ */\n//boundaryField {{"),
            *(
                (True, f"{head}\n{rest}")
                for rest in ("", "bound", "boundaryField", "boundaryField {")
            ),
            *(
                (False, f"{begin}{'}' * size}); }} }}")
                for begin, size in ((binary, 24), (binary, 48))
            ),
            (True, f"{binary}{'}' * 23}"),
            (False, f"{single}{'}' * 24}); }} }}//".ljust(len(single) + 48) + ")"),
            (True, f"{single}{'}' * 23}"),
        ):
            file.write_text(content)
            with self.subTest(content):
                self.assertEqual(silent_losses._is_cut(file), ends)

    def test_collected(self):
        """One of two pieces lacks a point array."""
        result = camaron.check(self.data("reports/pvtu_missing_array/parts.pvtu"), RULES)
        self.assertNotEqual(result["verdict"], "error")
        self.assertTrue(
            any("Left out: the array" in note for note in result["notes"]), result["notes"]
        )


if __name__ == "__main__":
    camaron_testing.main()
