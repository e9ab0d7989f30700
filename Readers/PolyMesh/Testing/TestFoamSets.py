# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sets and zones of OpenFOAM as selections."""

import gzip
import re
import subprocess

import camaron_testing
import openfoam_case
from camaron import convert, export, select
from paraview import simple

HEADER = (
    "/*---*\\\n| a banner; with {{ braces }} |\n\\*---*/\nFoamFile\n{{\n    version 2.0;\n    format ascii;\n"
    '    arch "LSB;label=32;scalar=64";\n    class {};\n    object {};\n}}\n// * * * //\n\n'
)
BALL = camaron_testing.EXAMPLES / "voronoi-ball.visf"


class TestFoamSets(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        self.case = self.folder / "case" / "case.foam"
        convert(BALL, self.case)
        self.mesh = self.case.parent / "constant" / "polyMesh"

    def put(self, name, kind, body):
        (self.mesh / "sets").mkdir(exist_ok=True)
        (self.mesh / "sets" / name).write_text(HEADER.format(kind, name) + body)

    def ids(self, *steps, mesh=None):
        """What a step selects, as written to a list."""
        target = self.folder / "ids.txt"
        select(mesh or self.case, steps, [target])
        return [int(line) for line in target.read_text().split()]

    def numbers(self, name):
        body = (self.mesh / name).read_text().split("}\n", 1)[1]
        return [int(n) for n in re.findall(r"\d+", body)][1:]

    def test_sets(self):
        """Cells, faces and points, in the case and in the mesh that was written."""
        self.put("some", "cellSet", "3\n(\n7\n1 799)\n")
        self.put("none", "cellSet", "0()\n")
        self.put("walls", "faceSet", "2 ( 5 // the first\n 4000 )")
        self.put("corners", "pointSet", "2(0 9)")
        self.assertEqual(self.ids("Set: Name=some"), [1, 7, 799])
        self.assertEqual(self.ids("Set: Name=none"), [])
        owner, neighbor = self.numbers("owner"), self.numbers("neighbour")
        cells = {owner[5], neighbor[5], owner[4000]}
        cells |= {neighbor[4000]} if len(neighbor) > 4000 else set()
        self.assertEqual(self.ids("Set: Name=walls"), sorted(cells))
        self.assertEqual(self.ids("set: set name=corners; element type=points"), [0, 9])
        path = self.mesh / "sets" / "some"
        self.assertEqual(self.ids(f"Set: SetFile={path}", mesh=BALL), [1, 7, 799])
        # What the plugin wrote, and what is compressed.
        source = self.open(BALL)
        bad = simple.SelectElements(Input=source, Strategy="By id", Ids="3, 20-22")
        export.write_list(bad, self.mesh / "sets" / "mine")
        packed = gzip.compress((self.mesh / "sets" / "mine").read_bytes())
        (self.mesh / "sets" / "mine").unlink()
        (self.mesh / "sets" / "mine.gz").write_bytes(packed)
        self.assertEqual(self.ids("Set: Name=mine"), [3, 20, 21, 22])

    def test_zones(self):
        """Of a mesh with two zones of cells and one of faces, in every encoding."""
        source = simple.OpenDataFile(str(BALL))
        calculator = simple.PythonCalculator(
            Input=source,
            Expression="2 + (numpy.arange(800) % 3 == 0)",
            ArrayName="Zone",
            ArrayAssociation="Cell Data",
        )
        for options in (
            {"Encoding": "ASCII"},
            {"Encoding": "Binary"},
            {"Encoding": "Binary", "LabelSize": "64 bit"},
            {"Encoding": "ASCII", "Compress": 1},
        ):
            simple.SaveData(str(self.case), calculator, Overwrite=1, **options)
            path = self.mesh / "cellZones"
            step = f"Set: SetFile={path}; SetName=fluid-3"
            self.assertEqual(self.ids(step, mesh=BALL), list(range(0, 800, 3)), options)
            if "64 bit" not in options.values():  # ParaView's reader expects 32
                self.assertEqual(self.ids("Set: Name=fluid-3"), list(range(0, 800, 3)), options)

    def test_check_mesh(self):
        """What checkMesh found is selected: as many cells as it says."""
        if not openfoam_case.PROGRAM:
            self.skipTest("no checkMesh")
        flange = camaron_testing.EXAMPLES / "flange.visf"  # two of whose hexahedra are twisted
        convert(flange, self.case, overwrite=True)
        openfoam_case.write_settings(self.case.parent)
        run = subprocess.run(
            openfoam_case.check_mesh(self.case.parent, "-allGeometry", "-allTopology"),
            capture_output=True,
            text=True,
            timeout=120,
            env=openfoam_case.environment(),
        )
        found = re.findall(r"<<Writing (\d+) .*cells.* to set (\w+)", run.stdout)
        self.assertTrue(found, run.stdout)
        for count, name in found:
            self.assertEqual(len(self.ids(f"Set: Name={name}")), int(count), name)

    def test_errors(self):
        """One sentence each, with the file."""
        self.put("some", "cellSet", "3(7 1 799)")
        self.put("short", "cellSet", "3(77 11 ")
        self.put("long", "cellSet", "3000000000(7 1)")
        self.put("word", "cellSet", "2(7 a)")
        self.put("far", "cellSet", "2(7 800)")
        self.put("outside", "faceSet", "1(100000)")
        self.put("corners", "pointSet", "1(0)")
        self.put("other", "dictionary", "1(0)")
        self.put("more", "cellSet", "1(0) 1(7)")
        self.put("uniform", "cellSet", "5{7}")
        self.put("bare", "cellSet", "(7 9)")
        (self.mesh / "sets" / "plain").write_text("1(0)")
        for name, words in {
            "short": "short: byte .*: expected a label, found the end of the file",
            "long": "long: byte .*: expected a list with 3000000000 labels",
            "word": "word: byte .*: expected a label, found 'a",
            "outside": "there is no face 100000 in .*owner: the set is of another mesh",
            "corners": "the set has points, but Element Type is Cells",
            "other": "expected a cellSet, faceSet or pointSet",
            "more": "more: byte .*: expected the end of the file, found '1.7.'",
            "plain": "plain: byte 0: expected FoamFile",
            "nothing": "there is no set or zone named nothing in .*; there are bare, corners, far",
        }.items():
            with self.assertRaisesRegex((RuntimeError, ValueError), words):
                self.ids(f"Set: Name={name}")
        self.assertEqual(self.ids("Set: Name=uniform"), [7])
        self.assertEqual(self.ids("Set: Name=bare"), [7, 9])
        self.put("walls", "faceSet", "1(0)")
        with self.assertRaisesRegex(RuntimeError, "a mesh with 800 cells, and this one has 4080"):
            flange = camaron_testing.EXAMPLES / "flange.visf"
            self.ids(f"Set: SetFile={self.mesh / 'sets' / 'walls'}", mesh=flange)
        zones = '2(a {type cellZone; inGroups 1(x); cellLabels 2(1 2); } "b c" {type cellZone; note "a;b"; cellLabels List<label> 1{3};})'
        (self.mesh / "cellZones").write_text(HEADER.format("regIOobject", "cellZones") + zones)
        self.assertEqual(self.ids("Set: Name=a"), [1, 2])
        path = self.mesh / "cellZones"
        self.assertEqual(self.ids(f"Set: SetFile={path}; SetName=b c"), [3])
        result = select(self.case, ["Set: Name=far"])
        self.assertEqual(result["selected"], 1)
        self.assertTrue(any("1 of 2 labels of far do not exist" in n for n in result["notes"]))
        with self.assertRaisesRegex(RuntimeError, "no Set File is chosen"):
            self.ids("Set:")


if __name__ == "__main__":
    camaron_testing.main()
