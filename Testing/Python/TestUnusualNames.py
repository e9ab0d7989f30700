# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of arrays and blocks with marks of XML or control characters: files are read again, terminals obey nothing."""

import os
from urllib.parse import quote

import camaron_testing
import gallery
from camaron import conversion, convert, inspect
from camaron.common import console, pipeline, text
from camaron.common.inputs import Inputs
from paraview import simple
from vtkmodules.vtkCommonCore import (
    vtkDoubleArray,
    vtkIntArray,
    vtkStringArray,
    vtkUnsignedCharArray,
)
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkUnstructuredGrid

PLY = """ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
property float {}
element face 1
property list uchar int vertex_indices
property float {}
end_header
0 0 0 1
1 0 0 2
0 1 0 3
3 0 1 2 7
"""
#: Of ParaView's own format, which has names of any characters.
VTK = """# vtk DataFile Version 4.2
mesh
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 3 float
0 0 0 1 0 0 0 1 0
CELLS 1 4
3 0 1 2
CELL_TYPES 1
5
POINT_DATA 3
FIELD FieldData 2
{} 1 3 float
1 2 3
{} 1 3 float
4 5 6
"""
#: Names that XML can hold, if they are escaped.
MARKS = ('a<b&"c', "a&lt;b", "'a'>b", "&amp;", "<img/src=x>")
FORMATS = (".vtu", ".pvtu", ".pvd", ".vtkhdf", ".vtk", ".xmf", ".ply")
#: Names that some format or other cannot hold.
ODD = (
    "]]>",
    "ctl\x01\x1b[31m",
    "new\nline",
    "  blank  ",
    "caf\udce9",
    "a b",
    '"q"',
    "(y)",
    "#x",
    "end",
    "",
)
#: The plugin's formats that have names, with options.
OWN = {"ply": {}, "ts": {"dialect": "GOCAD"}, "cdb": {}, "msh": {}}


class TestUnusualNames(camaron_testing.TestCase):
    def make(self, of_points, of_cells):
        path = self.folder / "mesh.ply"
        path.write_bytes(PLY.format(of_points, of_cells).encode("utf-8", "surrogateescape"))
        return path

    def make_any(self, *names):
        path = self.folder / "mesh.vtk"
        path.write_text(VTK.format(*(quote(name) for name in names)))
        return path

    def names(self, source):
        return [array.Name for data in (source.PointData, source.CellData) for array in data]

    def test_converted(self):
        """Names do not change, and there is no message, except for a slash in HDF5."""
        for i, name in enumerate(MARKS):
            path = self.make(name, name + "2")
            for suffix in FORMATS:
                target = self.folder / f"{suffix[1:]}{i}{suffix}"
                kept = name.replace("/", "_") if suffix == ".vtkhdf" else name
                self.assertEqual(
                    len(convert(path, target)), int(kept != name), f"{name} in {suffix}"
                )
                again = self.open(target)
                self.assertEqual(self.names(again)[:1], [kept], suffix)
                self.assertIn(kept + "2", self.names(again), suffix)
                simple.Delete(again)

    def test_own_formats(self):
        """The plugin reads what it writes; changed and missing names are reported."""
        for name in MARKS[:1] + ODD:
            if not name and camaron_testing.paraview_version() >= (6, 0):
                continue  # these crash on arrays with an empty name, without the plugin, too
            raw = name.encode("utf-8", "surrogateescape")
            for kind, options in OWN.items():
                path = self.folder / f"own.{kind}"
                source = simple.TrivialProducer()
                source.GetClientSideObject().SetOutput(self.mesh(kind, raw))
                source.UpdatePipeline()
                notes = []
                conversion.write(source, path, options, Inputs(), notes)
                simple.Delete(source)
                found = self.all_names(path)
                if raw not in found:
                    told = self.shown(name) or "an unnamed array"
                    zone = kind == "msh" and ("zone 7" in " ".join(notes) or not name)
                    self.assertTrue(zone or told in " ".join(notes), (kind, name, notes))
                for other in (".vtu", ".vtk"):
                    told = " ".join(convert(path, path.with_suffix(other)))
                    for lost in found - self.all_names(path.with_suffix(other)):
                        self.assertIn(self.shown(lost.decode("utf-8", "surrogateescape")), told)

    def shown(self, name):
        """In a message of one line."""
        return text.printable(name).strip()

    def mesh(self, kind, name):
        """With arrays or a zone of that name, whichever the format knows."""
        grid = gallery.tetrahedra() if kind in ("cdb", "msh") else gallery.triangles()
        kinds = {"cdb": vtkUnsignedCharArray, "msh": vtkIntArray}
        for data, size in (
            (grid.GetPointData(), grid.GetNumberOfPoints()),
            (grid.GetCellData(), grid.GetNumberOfCells()),
        ):
            array = kinds.get(kind, vtkDoubleArray)()
            array.SetName("Zone" if kind == "msh" else name)
            array.SetNumberOfValues(size)
            for i in range(size):
                array.SetValue(i, 7 if kind == "msh" else i % 2)
            data.AddArray(array)
        if kind == "msh":
            for array, label, value in (
                (vtkIntArray(), "ZoneIds", 7),
                (vtkStringArray(), "ZoneNames", name),
                (vtkStringArray(), "ZoneTypes", "fluid"),
            ):
                array.SetName(label)
                array.InsertNextValue(value)
                grid.GetFieldData().AddArray(array)
        return grid

    def all_names(self, path):
        """Of arrays and in arrays, as bytes."""
        source = pipeline.open_mesh(path).source
        data = self.fetch(source)
        found = set()
        for fields in (data.GetPointData(), data.GetCellData(), data.GetFieldData()):
            for i in range(fields.GetNumberOfArrays()):
                array = fields.GetAbstractArray(i)
                found.add(array.GetName())
                if array.IsA("vtkStringArray"):
                    found |= {array.GetValue(k) for k in range(array.GetNumberOfValues())}
        simple.Delete(source)
        return {name if isinstance(name, bytes) else name.encode() for name in found if name}

    def test_chosen_arrays(self):
        """Arrays are chosen by the names that people know."""
        path = self.make(MARKS[0], MARKS[1])
        target = self.folder / "target.vtu"
        convert(path, target, cell_data_arrays=MARKS[1], point_data_arrays="none")
        self.assertEqual(self.names(self.open(target)), [MARKS[1]])

    def test_control_characters(self):
        """XML has none: the name is changed with a harmless message."""
        path = self.make_any("a\x1b[31mb", "plain")
        self.assertEqual(self.names(self.open(path)), ["a\x1b[31mb", "plain"])
        notes = convert(path, self.folder / "target.vtu")
        self.assertEqual(
            notes,
            ["Names that *.vtu files cannot store are changed: 'a?[31mb' to 'a_[31mb'."],
        )
        self.assertEqual(self.names(self.open(self.folder / "target.vtu")), ["a_[31mb", "plain"])

    def test_latin_1(self):
        """Bytes that are no UTF-8 are no XML either."""
        path = self.make("a\udce9b", "plain")
        notes = convert(path, self.folder / "target.vtu")
        self.assertEqual(len(notes), 1, notes)
        self.assertEqual(self.names(self.open(self.folder / "target.vtu")), ["a_b", "plain"])

    def test_two_become_one(self):
        path = self.make_any("a\x01b", "a_b")
        convert(path, self.folder / "target.vtu")
        self.assertEqual(sorted(self.names(self.open(self.folder / "target.vtu"))), ["a_b", "a_b_"])

    def test_blocks_and_components(self):
        grid = vtkUnstructuredGrid()
        pipeline.load_plugin()
        grid.ShallowCopy(self.fetch(self.open(self.make("v", "w"))))
        array = vtkDoubleArray()
        array.SetName("x<y")
        array.SetNumberOfComponents(2)
        array.SetComponentName(0, "u&v")
        array.SetComponentName(1, "plain")
        array.SetNumberOfTuples(3)
        array.Fill(1)
        grid.GetPointData().AddArray(array)
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, grid)
        blocks.GetMetaData(0).Set(blocks.NAME(), "in<let\x07")
        source = simple.TrivialProducer()
        source.GetClientSideObject().SetOutput(blocks)
        source.UpdatePipeline()
        from camaron import conversion

        notes = []
        conversion.write_source(source, self.folder / "target.vtm", notes)
        self.assertEqual(len(notes), 1, notes)
        reader = self.open(self.folder / "target.vtm")
        again = reader.GetClientSideObject().GetOutputDataObject(
            0
        )  # on its way here it gets another name in 6.1
        self.assertEqual(again.GetMetaData(0).Get(again.NAME()), "in<let_")
        found = again.GetBlock(0).GetPointData().GetArray("x<y")
        self.assertEqual(found.GetComponentName(0), "u&v")
        self.assertEqual(array.GetComponentName(0), "u&v")  # as before

    def test_report(self):
        """The mesh of a report is read again, and a change is noted."""
        path = self.make_any(MARKS[0], "b\x07")
        summary = inspect(path, self.folder / "report", criteria=["Area"], with_pictures=False)
        again = self.open(self.folder / "report" / summary["files"]["mesh"])
        self.assertIn(MARKS[0], self.names(again))
        self.assertEqual(
            sum("cannot store" in note for note in summary["notes"]), 1, summary["notes"]
        )

    def test_terminal(self):
        """Neither errors nor tables pass on control characters, wherever they come from."""
        hostile = "\x1b]0;owned\x07\x9b31m\u202e\nx"
        self.assertEqual(text.printable(hostile), "?]0;owned??31m??x")
        bad = self.folder / f"bad{hostile}.visf"
        bad.write_text("2 2\n-1\n")
        good = self.folder / f"good{hostile}.ply"
        self.make("a", "b").rename(good)
        for arguments in (
            ["inspect", bad, "--no-pictures", "-o", self.folder / "report"],
            ["inspect", good, "--no-pictures", "-o", self.folder / f"report{hostile}"],
            ["check", bad, good, "--preset", "General"],
            ["convert", bad, self.folder / "target.vtu"],
            ["convert", good, self.folder / f"target{hostile}.nothing"],
        ):
            run = camaron_testing.run_command(*arguments)
            for line in (run.stdout + run.stderr).split("\n"):
                self.assertEqual(text.printable(line), line)
            for line in run.stderr.splitlines():
                self.assertTrue(line.startswith("camaron: "), run.stderr)
                self.assertLessEqual(line.count("?]0;owned"), 1, line)
            self.assertIn("?]0;owned", run.stdout + run.stderr)

    def test_full_disk(self):
        """A full disk under standard output causes one error that names it."""
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        for arguments in (["criteria"], ["check", self.make("a", "b"), "--preset", "General"]):
            with open("/dev/full", "w") as full:
                run = camaron_testing.run_command(*arguments, stdout=full)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertEqual(run.stderr, "camaron: standard output: No space left on device\n")

    def test_no_space_for_a_file(self):
        """A disk that is full while a file is written: the error gives the final path of the file."""
        from camaron.common.files import Staging

        for path, expected in ((None, self.folder), ("worst.csv", self.folder / "worst.csv")):
            with self.assertRaises(OSError) as caught:
                with Staging(self.folder, Inputs()) as staging:
                    place = path and str(staging.path / path)
                    raise OSError(28, "No space left on device", place)
            self.assertEqual(
                console.reason(caught.exception), f"{expected}: No space left on device"
            )
        self.assertEqual(console.reason(MemoryError(), "big.visf"), "big.visf: out of memory")


if __name__ == "__main__":
    camaron_testing.main()
