# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""A cell that has a number of points which its type cannot have is one error of whatever reads the mesh: there are no
right numbers to show, and what is read beyond its points belongs to other cells or to nobody."""

import itertools
import json
from pathlib import Path

import camaron
import camaron_testing
import inspection_testing
import numpy
from camaron.common import vtk_lists, formats, pipeline
from camaron.inspection import pictures
from paraview import simple
from TestInterruption import PROPERTIES, filter_names
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

#: Two cubes.
POINTS = [(x, y, z) for x in range(3) for z in (0, 1) for y in (0, 1)]
TETRAHEDRON = (10, [0, 1, 2, 4])
GOOD = [TETRAHEDRON, (10, [4, 5, 6, 8]), (10, [1, 3, 2, 7])]
#: A last cell after good ones, and the end of the error.
WRONG = {
    "short-tetrahedron": ((10, [0, 1, 2]), "(tetrahedron) has 3 points, expected 4"),
    "short-hexahedron": ((12, range(6)), "(hexahedron) has 6 points, expected 8"),
    "short-voxel": ((11, range(7)), "(voxel) has 7 points, expected 8"),
    "short-pyramid": ((14, range(4)), "(pyramid) has 4 points, expected 5"),
    "no-points": ((12, []), "(hexahedron) has 0 points, expected 8"),
    "long-wedge": ((13, range(7)), "(wedge) has 7 points, expected 6"),
    "long-triangle": ((5, range(4)), "(triangle) has 4 points, expected 3"),
    "quadratic": ((24, range(4)), "(quadratic tetrahedron) has 4 points, expected 10"),
    "lagrange": ((71, range(9)), "(lagrange tetrahedron) has 9 points, expected 4, 10, 15"),
    "bezier": ((79, range(9)), "(bezier hexahedron) has 9 points, expected 8, 27, 64"),
    "missing-point": ((10, [0, 1, 2, 99]), "uses point 99, but the mesh has 12 points"),
}
#: Several ranks find what one finds, in more time.
SOME = {
    name: wrong
    for name, wrong in WRONG.items()
    if camaron_testing.rank_count() == 1 or name in ("short-tetrahedron", "missing-point")
}
#: The faces of the tetrahedron as a polyhedron, and lists of faces that do not end where they should.
FACES = [4, 3, 0, 1, 2, 3, 0, 1, 4, 3, 1, 2, 4, 3, 0, 2, 4]
WRONG_FACES = {
    "declares-5": ([5, *FACES[1:]], "has 4 faces in its list, expected 5"),
    "declares-3": ([3, *FACES[1:]], "has a list of faces of 17 numbers, expected 13"),
    "declares-many": ([10**9, *FACES[1:]], "has 4 faces in its list, expected 1000000000"),
    "declares-less-than-none": ([-4, *FACES[1:]], "has -4 faces in its list, expected 0 or more"),
    "lacks-a-face": (FACES[:-4], "has 3 faces in its list, expected 4"),
    "ends-in-a-face": (FACES[:-1], "has 3 faces in its list, expected 4"),
    "large-face": ([*FACES[:5], 1000, *FACES[6:]], "has 1 faces in its list, expected 4"),
    "no-list": ([], "has no list of faces"),
}
#: What a type may have; a defect at most.
ALLOWED = [(7, [0, 1]), (7, []), (6, [0, 1]), (2, []), (4, [0]), (0, [0, 1]), (36, [0, 1, 2, 3])]

PIECES = """<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid GhostLevel="0"><PPoints>
<PDataArray type="Float64" NumberOfComponents="3"/></PPoints>{}</PUnstructuredGrid></VTKFile>
"""
BLOCKS = """<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>
<DataSet index="0" name="hub" file="good.vtu"/><DataSet index="1" name="rotor" file="bad.vtu"/>
</vtkMultiBlockDataSet></VTKFile>
"""
#: Of a source with cells of these arrays.
SCRIPT = f"""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
def fill(grid, offsets, ids, types):
    points, cells = vtkPoints(), vtkCellArray()
    for point in {POINTS}:
        points.InsertNextPoint(point)
    cells.SetData(*(numpy_to_vtkIdTypeArray(numpy.array(a, numpy.int64), True) for a in (offsets, ids)))
    grid.SetPoints(points)
    grid.SetCells(numpy_to_vtk(numpy.array(types, numpy.uint8), True), cells)
"""


def write_vtu(path, cells, points=POINTS):
    """Of a polyhedron, the list of faces is given."""
    numbers = lambda values: " ".join(map(str, values))
    array = lambda name, values: (
        f'<DataArray type="Int64" Name="{name}" format="ascii">{numbers(values)}</DataArray>'
    )
    faces = ""
    if any(kind == 42 for kind, _ in cells):
        lists = [ids if kind == 42 else [] for kind, ids in cells]
        ends = numpy.cumsum([len(ids) for ids in lists])
        ends = [end if kind == 42 else -1 for (kind, _), end in zip(cells, ends)]
        faces = array("faces", (i for ids in lists for i in ids)) + array("faceoffsets", ends)
        cells = [(kind, TETRAHEDRON[1] if kind == 42 else ids) for kind, ids in cells]
    ends = numpy.cumsum([len(ids) for _, ids in cells])
    path.write_text(
        f'<VTKFile type="UnstructuredGrid" version="1.0"><UnstructuredGrid><Piece NumberOfPoints="{len(points)}" '
        f'NumberOfCells="{len(cells)}"><Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">'
        f"{numbers(x for point in points for x in point)}</DataArray></Points><Cells>"
        f'{array("connectivity", (i for _, ids in cells for i in ids))}{array("offsets", ends)}'
        f'{array("types", (kind for kind, _ in cells))}{faces}'
        "</Cells></Piece></UnstructuredGrid></VTKFile>"
    )
    return path


class TestCellSizes(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        simple.ResetSession()
        pipeline.load_plugin()

    def write(self, name, suffix, cells):
        path = self.folder / f"{name}{suffix}"
        if suffix == ".vtk":
            return camaron_testing.write_vtk(path, POINTS, cells)
        return write_vtu(path, cells)

    def files(self, name):
        """The mesh in a file, and one of them in other files, too, with the place that an error names."""
        last, _ = WRONG[name]
        cells = [*GOOD, last]
        yield self.write(name, ".vtu", cells), "cell 3 "
        if name != "short-tetrahedron":
            return
        yield self.write(name, ".vtk", cells), "cell 3 "
        self.write("good", ".vtu", GOOD)
        self.write("bad", ".vtu", cells)
        names = ["good.vtu"] * 5 + ["bad.vtu"]
        pieces = self.folder / "pieces.pvtu"
        pieces.write_text(PIECES.format("".join(f'<Piece Source="{name}"/>' for name in names)))
        before = len(names) // camaron_testing.rank_count() - 1  # on the last rank
        yield pieces, f"cell {3 * before + 3} "
        blocks = self.folder / "blocks.vtm"
        blocks.write_text(BLOCKS)
        yield blocks, "rotor: cell 3 "

    def refuses(self, path, place, reason, function, *arguments, **options):
        with self.assertRaises(RuntimeError, msg=(function, path)) as caught:
            function(*arguments, **options)
        text = str(caught.exception)
        self.assertIn(f"{path}: ", text)
        self.assertIn(place + reason, text)
        self.assertNotIn("another process", text)
        self.assertNotIn("\n", text)

    def test_commands(self):
        good = self.write("whole", ".vtk", [TETRAHEDRON])
        for name, (_, reason) in SOME.items():
            for path, place in self.files(name):
                with self.subTest(path.name):
                    refuses = lambda *given, **options: self.refuses(
                        path, place, reason, *given, **options
                    )
                    folder = self.folder / "out"
                    refuses(pipeline.open_mesh, path)
                    refuses(camaron.inspect, path, folder)
                    refuses(camaron.check, path, ["Volume > 0"])
                    refuses(camaron.compare, good, path, folder)
                    refuses(camaron.select, path, ["Worst N: Array=Volume; NumberOfWorst=1"])
                    refuses(camaron.select, good, [f"Surface: Surface={path}"])
                    suffixes = [".visf", ".off", ".cdb", ".vtu", ".vtk", ".stl", ".ex2"]
                    if camaron_testing.rank_count() > 1:
                        suffixes = [".visf", ".pvtu"]
                    for suffix in suffixes:
                        refuses(camaron.convert, path, folder.with_suffix(suffix))
                    self.assertEqual(list(self.folder.glob("out*")), [])

    def test_lists_of_faces(self):
        """ParaView's readers crash on some, and take the numbers of the next cell for others."""
        if camaron_testing.rank_count() > 1:
            return
        good = (42, FACES)
        for name, (faces, reason) in WRONG_FACES.items():
            for suffix in (".vtk", ".vtu"):
                for cells, place in (
                    ([good, TETRAHEDRON, (42, faces), good], 2),
                    ([(42, faces), good], 0),
                ):
                    path = self.write(name, suffix, cells)
                    place = f"cell {place} (polyhedron) "
                    self.refuses(path, place, reason, pipeline.open_mesh, path)
                    target = self.folder / "out.pvtu"
                    self.refuses(path, place, reason, camaron.convert, path, target)
        pieces = self.folder / "pieces.pvtu"
        pieces.write_text(PIECES.format('<Piece Source="no-list.vtu"/>'))
        with self.assertRaisesRegex(RuntimeError, "no-list.vtu: cell 0 .polyhedron. has no list"):
            pipeline.open_mesh(pieces)
        for suffix in (".vtk", ".vtu"):
            path = self.write("good", suffix, [good, TETRAHEDRON, good])
            grid = self.fetch(pipeline.open_mesh(path).source)
            self.assertEqual(grid.GetNumberOfCells(), 3)

    def test_lists_of_points(self):
        """The numbers before the points of cells in legacy files, which lead VTK's reader."""
        if camaron_testing.rank_count() > 1:
            return
        text = "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 12 float\n"
        text += " ".join(str(x) for point in POINTS for x in point)
        text += "\nCELLS 2 14\n4 0 1 2 4\n{} 0 1 2 3 4 5 6 7\nCELL_TYPES 2\n10 {}\n"
        path = self.folder / "legacy.vtk"
        for number, kind, reason in (
            (9, 12, "cell 1 (hexahedron) has 9 points, expected 8"),
            (10**9, 12, "cell 1 (hexahedron) has 1000000000 points, expected 8"),
            (-8, 12, "cell 1 (hexahedron) has -8 points, expected 8"),
            (9, 7, "cell 1 (polygon) has 9 points, expected at most 8, after which the list ends"),
            (8, 268, "cell 1 has the type 268, which does not exist"),
        ):
            path.write_text(text.format(number, kind))
            with self.assertRaises(RuntimeError) as caught:
                pipeline.open_mesh(path)
            self.assertEqual(str(caught.exception), f"{path}: {reason}")
        for header in ("POINTS 12", "CELLS 2", "CELLS 2 14"):  # for which VTK would allocate memory
            for written in (header, header.lower(), f"  {header}"):
                path.write_text(text.format(8, 12).replace(header, f"{written}000000000"))
                with self.assertRaisesRegex(
                    RuntimeError, f"expected {header}000000000( 14)?, but the file"
                ):
                    pipeline.open_mesh(path)
        path.write_text(text.format(8, 12).replace("\n\n", "\nPOINTS 12000000000 float\n", 1))
        self.assertEqual(self.fetch(pipeline.open_mesh(path).source).GetNumberOfCells(), 2)

    def test_lists_of_series(self):
        """Of the step that is read."""
        if camaron_testing.rank_count() > 1:
            return
        good, bad = (42, FACES), (42, WRONG_FACES["lacks-a-face"][0])
        names = [self.write(name, ".vtu", [good, one]).name for name, one in zip("ab", (good, bad))]
        inner = self.folder / "inner.vtm"
        inner.write_text(
            '<VTKFile type="vtkMultiBlockDataSet"><vtkMultiBlockDataSet>'
            f'<DataSet index="0" file="{names[1]}"/></vtkMultiBlockDataSet></VTKFile>'
        )
        steps = self.folder / "steps.vtu.series"
        files = [{"name": name, "time": i} for i, name in enumerate(names)]
        steps.write_text(json.dumps({"file-series-version": "1.0", "files": files}))
        collection = self.folder / "steps.pvd"
        collection.write_text(
            '<VTKFile type="Collection"><Collection>'
            f'<DataSet timestep="0" part="0" file="{names[0]}"/>'
            f'<DataSet timestep="1" part="0" file="{inner.name}"/></Collection></VTKFile>'
        )
        for path in (steps, collection):
            with self.assertRaisesRegex(RuntimeError, "b.vtu: cell 1 .polyhedron. has 3 faces"):
                pipeline.open_mesh(path)
            pipeline.open_mesh(path, "first")
        # The reader says what is wrong with lists; ours neither fails nor goes round in circles.
        broken = {"a.series": '{"files": [{}]}', "b.series": "{", "c.vtk": "", "d.vtm": ""}
        broken["e.vtm"] = '<DataSet file="e.vtm"/><DataSet file="c.vtk"/>'
        broken["f.pvd"] = '<DataSet timestep="x" file="b.vtu"/>'
        broken["g.vtk"] = f"CELLS 2 {10**18}\n4 0 1 2 4\nCELL_TYPES {10**18}\n10\n"
        for name, content in broken.items():
            path = self.folder / name
            path.write_text(content)
            vtk_lists.check(path)

    def test_triangles(self):
        """VTK reads the triangles of a binary STL file up to its end, wherever that is."""
        path = self.folder / "cut.stl"
        simple.SaveData(str(path), simple.Sphere())
        whole = path.read_bytes()
        count = self.open(path).GetDataInformation().GetNumberOfCells()
        for size, found in ((84 + 50 * 7, 7), (84 + 50 * 8 + 3, 8)):
            path.write_bytes(whole[:size])
            with self.assertRaisesRegex(
                RuntimeError, f"expected {count} triangles, .* after {found}"
            ):
                pipeline.open_mesh(path)
        path.write_bytes(
            whole[:80] + b"\xff\xff\xff\x7f" + whole[84:]
        )  # of which VTK runs out of memory
        with self.assertRaisesRegex(RuntimeError, f"expected {2**31 - 1} triangles"):
            pipeline.open_mesh(path)
        path.write_bytes(b"solid\nfacet".ljust(80) + whole[80 : 84 + 50 * 7])
        with self.assertRaisesRegex(RuntimeError, f"expected {count} triangles, .* after 7"):
            pipeline.open_mesh(path)
        for number in (0, count, 2**32 - 1):  # some programs do not write it
            path.write_bytes(whole[:80] + number.to_bytes(4, "little") + whole[84:])
            pipeline.open_mesh(path)

    def test_lists_in_binary_files(self):
        path = self.write("good", ".vtk", [(42, FACES), TETRAHEDRON, (42, FACES)])
        source = pipeline.open_mesh(path).source
        for version, integers in ((42, ">i4"), (51, ">i8")):
            writer = vtkUnstructuredGridWriter()
            writer.SetInputData(self.fetch(source))
            writer.SetFileName(str(self.folder / "binary.vtk"))
            writer.SetFileTypeToBinary()
            writer.SetFileVersion(version)
            writer.Write()
            if camaron_testing.rank_count() == 1:
                again = pipeline.open_mesh(writer.GetFileName()).source
                self.assertEqual(again.GetDataInformation().GetNumberOfCells(), 3)
            content = Path(writer.GetFileName()).read_bytes()
            faces, other = (numpy.array(a, integers).tobytes() for a in (FACES, [5, *FACES[1:]]))
            self.assertEqual(content.count(faces), 2, version)
            path = self.folder / "broken.vtk"
            path.write_bytes(other.join(content.rsplit(faces, 1)))
            reason = "has 4 faces in its list, expected 5"
            self.refuses(path, "cell 2 (polyhedron) ", reason, pipeline.open_mesh, path)

    def test_lists_in_binary_xml_files(self):
        if camaron_testing.rank_count() > 1:
            return
        source = self.open(self.write("good", ".vtk", [(42, FACES), TETRAHEDRON, (42, FACES)]))
        for mode, compressor, encoded, header in itertools.product(
            ("Ascii", "Binary", "Appended"), ("None", "ZLib", "LZMA"), (0, 1), (32, 64)
        ):
            writer = vtkXMLUnstructuredGridWriter()
            writer.SetInputData(self.fetch(source))
            writer.SetFileName(str(self.folder / "binary.vtu"))
            getattr(writer, f"SetDataModeTo{mode}")()
            getattr(writer, f"SetCompressorTypeTo{compressor}")()
            writer.SetEncodeAppendedData(encoded)
            getattr(writer, f"SetHeaderTypeToUInt{header}")()
            writer.Write()
            content = Path(writer.GetFileName()).read_bytes()
            if b'"faces"' not in content:
                self.skipTest("this ParaView writes lists of faces in another way")
            found = vtk_lists._read_array(content, b"faces", 0, len(content))
            self.assertEqual([*found], 2 * FACES, (mode, compressor, encoded, header))
        writer.SetEncodeAppendedData(False)
        writer.SetCompressorTypeToNone()
        writer.Write()
        content = Path(writer.GetFileName()).read_bytes()
        faces, other = (numpy.array(a).tobytes() for a in (FACES, [5, *FACES[1:]]))
        path = self.folder / "broken.vtu"
        path.write_bytes(other.join(content.rsplit(faces, 1)))
        reason = "has 4 faces in its list, expected 5"
        self.refuses(path, "cell 2 (polyhedron) ", reason, pipeline.open_mesh, path)

    def test_status(self):
        names = itertools.cycle(("short-tetrahedron", "no-points"))
        for name, arguments in zip(
            names,
            (
                ["inspect", "-o", self.folder / "report"],
                ["check", "--preset", "General"],
                ["convert", self.folder / "copy.vtk"],
                ["convert", self.folder / "copy.visf"],
            ),
        ):
            last, reason = WRONG[name]
            path = self.write(name, ".vtu", [*GOOD, last])
            done = camaron_testing.run_command(arguments[0], path, *arguments[1:])
            self.assertEqual(done.returncode, 2, arguments)
            self.assertEqual(done.stderr, f"camaron: {path}: cell 3 {reason}\n")
            self.assertEqual(done.stdout, "")

    def test_filters(self):
        """Those of the plugin, whoever made the mesh: nothing is read by a command before."""
        names = filter_names()
        self.assertGreater(len(names), 9)
        for name, (_, reason) in SOME.items():
            for path, _ in self.files(name):
                source = simple.OpenDataFile(str(path))
                for filter_name in names:
                    with self.subTest(filter=filter_name, mesh=path.name):
                        properties = PROPERTIES.get(filter_name, lambda _: {})(source)
                        proxy = getattr(simple, filter_name)(**{"Input": source, **properties})
                        with pipeline.Messages() as messages:
                            proxy.UpdatePipeline()
                            if filter_name == "ElementQuality":
                                proxy.UpdatePropertyInformation()  # such as the estimated time
                        self.assertTrue(
                            any(reason in text for text in messages.errors), messages.errors
                        )
                        self.assertFalse(
                            [text for text in messages.errors if "another process" in text]
                        )
                        self.assertEqual(proxy.GetDataInformation().GetNumberOfCells(), 0)
                        simple.Delete(proxy)
                simple.Delete(source)

    def test_writers(self):
        """Those of the plugin, as from File > Save Data."""
        suffixes = {f".{f['extensions'][0]}" for f in formats.own_formats() if f["writer"]}
        self.assertGreater(len(suffixes), 7)
        for name, (_, reason) in SOME.items():
            for path, _ in self.files(name):
                source = simple.OpenDataFile(str(path))
                for suffix in suffixes:
                    target = self.folder / f"out{suffix}"
                    with pipeline.Messages() as messages:
                        simple.SaveData(str(target), proxy=source)
                    self.assertTrue(messages.errors, (path, suffix))
                    self.assertIn(f"out{suffix} is not written: ", messages.errors[0])
                    self.assertIn(reason, messages.errors[0])
                    self.assertEqual(list(self.folder.glob("out*")), [])
                simple.Delete(source)

    def test_time_steps(self):
        """ParaView's writers get no later step that was not checked."""
        if camaron_testing.rank_count() > 1:
            return
        self.write("good", ".vtu", [*GOOD, TETRAHEDRON])
        self.write("bad", ".vtu", [*GOOD, WRONG["short-tetrahedron"][0]])
        series = self.folder / "steps.pvd"
        series.write_text(
            '<VTKFile type="Collection" version="0.1"><Collection><DataSet timestep="0" file="bad.vtu"/>'
            '<DataSet timestep="1" file="good.vtu"/></Collection></VTKFile>'
        )
        self.assertEqual(len(camaron.convert(series, self.folder / "last.vtu")), 1)
        target = self.folder / "all.vtkhdf"
        with self.assertRaisesRegex(RuntimeError, "cell 3 .tetrahedron. has 3 points, expected 4"):
            camaron.convert(series, target, write_all_time_steps="yes")
        self.assertFalse(target.exists())

    def test_what_a_type_may_have(self):
        """Defects, and cells without any meaning, are no reason to refuse a mesh."""
        for number, cell in enumerate(ALLOWED):
            for suffix in (".vtk", ".vtu"):
                path = self.write(f"allowed{number}", suffix, [TETRAHEDRON, cell])
                verdict = camaron.check(path, ["Volume > 0 of tetrahedra"])
                self.assertEqual(verdict["verdict"], "pass", cell)
                camaron.convert(path, self.folder / "copy.visf")

    def test_arrays_that_do_not_fit(self):
        """Of sources that fill the arrays themselves."""
        good = [0, 4, 8], [0, 1, 2, 4, 1, 3, 2, 5], [10, 10]
        for offsets, ids, types, reason in (
            ([0, 4, 9], good[1], good[2], "points of cell 1 have the offsets 4 and 9"),
            ([0, 40, 8], good[1], good[2], "points of cell 0 have the offsets 0 and 40"),
            ([0, 4, 0], good[1], good[2], "points of cell 1 have the offsets 4 and 0"),
            (good[0], good[1], [10], "2 cells, but the types of 1"),
        ):
            source = simple.ProgrammableSource(OutputDataSetType="vtkUnstructuredGrid")
            source.Script = SCRIPT + f"fill(self.GetOutputDataObject(0), {offsets}, {ids}, {types})"
            for name in filter_names():
                properties = PROPERTIES.get(name, lambda _: {})(source)
                proxy = getattr(simple, name)(**{"Input": source, **properties})
                with pipeline.Messages() as messages:
                    proxy.UpdatePipeline()
                self.assertTrue(
                    any(reason in text for text in messages.errors), (name, messages.errors)
                )
                simple.Delete(proxy)
            with pipeline.Messages() as messages:
                simple.SaveData(str(self.folder / "out.visf"), proxy=source)
            self.assertIn(reason, messages.errors[0])

    @camaron_testing.require_display()
    def test_pictures(self):
        """Mesh Inspection reports the mesh and shows nothing of it, and the other blocks."""
        if camaron_testing.rank_count() > 1:
            return
        for name, (_, reason) in SOME.items():
            for path, _ in self.files(name):
                source = simple.OpenDataFile(str(path))
                with pipeline.Messages() as messages:
                    # simple.Show would begin with ParaView's Surface.
                    scene = pictures.Scene()
                    scene.view.OrientationAxesVisibility = 0
                    scene.show(source, DiffuseColor=[1, 0, 0], AmbientColor=[1, 0, 0])
                    inspection_testing.turn(scene.view)
                    image = inspection_testing.picture(scene.view)
                self.assertTrue(any(reason in text for text in messages.errors), messages.errors)
                is_drawn = bool((image < 250).any())
                self.assertEqual(is_drawn, path.suffix == ".vtm", path)
                scene.close()
                simple.Delete(source)

    def test_collected(self):
        """Meshes after reports about other programs."""
        for name, reason in (
            ("tetrahedron_of_3_ids", WRONG["short-tetrahedron"][1]),
            ("pyramid_of_4_ids", WRONG["short-pyramid"][1]),
        ):
            path = self.data(f"reports/{name}.vtu")
            self.refuses(path, "cell 0 ", reason, camaron.inspect, path, self.folder / "report")
            self.refuses(path, "cell 0 ", reason, camaron.convert, path, self.folder / "copy.pvtu")


if __name__ == "__main__":
    camaron_testing.main()
