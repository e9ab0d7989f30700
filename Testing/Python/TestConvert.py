# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""camaron.convert: formats, options of writers, errors."""

import csv
import os
import re
import resource
import shutil
import signal
import subprocess
import time
import unittest.mock

import camaron_testing
import numpy
from camaron import check, convert
from camaron.common import pipeline
from camaron.common.inputs import Inputs  # ParaView's programmable sources delete "inputs" here
from camaron.conversion import storable_names, write, write_source
from paraview import simple
from vtkmodules.vtkCommonCore import (
    vtkDoubleArray,
    vtkPoints,
    vtkSignedCharArray,
    vtkStringArray,
    vtkVersion,
)
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

CUBE = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
TETRAHEDRA = [(10, (0, 1, 3, 4)), (10, (2, 3, 1, 6))]

#: Bytes that files may have at most, to stand for a disk that is full.
FULL = 3000


class TestConvert(camaron_testing.TestCase):
    def cells(self, path):
        return self.fetch(self.open(path)).GetNumberOfCells()

    def mesh(self):
        return camaron_testing.write_vtk(self.folder / "two.vtk", CUBE, TETRAHEDRA)

    def test_grid_to_grid(self):
        target = self.folder / "two.vtu"
        self.assertEqual(convert(self.mesh(), target), [])
        self.assertEqual(self.cells(target), 2)

    def test_volume_to_surface(self):
        """Formats of surfaces get the boundary; the tetrahedra share no face, so it has 8."""
        for name in ("two.stl", "two.ply", "two.vtp"):
            notes = convert(self.mesh(), self.folder / name)
            self.assertEqual(len(notes), 1, name)
            self.assertIn("boundary", notes[0])
            self.assertEqual(self.cells(self.folder / name), 8, name)

    def test_surface_to_surface(self):
        """No note about a boundary if the mesh is a surface."""
        quads = camaron_testing.write_vtk(
            self.folder / "q.vtk", CUBE, [(9, (0, 1, 2, 3)), (9, (4, 5, 6, 7))]
        )
        for name, cells in (("q.vtp", 2), ("q.obj", 2), ("q.stl", 4)):
            self.assertEqual(convert(quads, self.folder / name), [], name)
            self.assertEqual(self.cells(self.folder / name), cells, name)

    def test_collections_of_blocks(self):
        """Formats whose writers take collections only get a tree of blocks as one."""
        blocks = simple.GroupDatasets(Input=[self.open(self.mesh()), simple.Cone()])
        simple.SaveData(str(self.folder / "tree.vtm"), blocks)
        grids = simple.GroupDatasets(Input=[self.open(self.mesh()), self.open(self.mesh())])
        simple.SaveData(str(self.folder / "grids.vtm"), grids)
        convert(self.folder / "tree.vtm", self.folder / "collection.vtpc")
        collection = self.open(self.folder / "collection.vtpc")
        collection.UpdatePipeline()
        self.assertEqual(collection.GetDataInformation().GetNumberOfCells(), 2 + 7)
        convert(self.folder / "grids.vtm", self.folder / "grids.exo")
        self.assertEqual(check(self.folder / "grids.exo", ["Volume > 0"])["cells"], 4)

    def test_upper_case(self):
        """An extension in upper case is the same one."""
        for name, cells in (
            ("A.VTU", 2),
            ("A.STL", 8),
            ("A.VISF", 2),
            ("A.CASE", 2),
            ("A.CSV", None),
        ):
            convert(self.mesh(), self.folder / name)
            self.assertTrue((self.folder / name).is_file(), name)
            if cells:
                lower = self.folder / name.lower()
                (self.folder / name).rename(lower)
                self.assertEqual(self.cells(lower), cells, name)

    def test_lines(self):
        """Formats of triangles report which cells they omit."""
        cells = [*TETRAHEDRA, (3, (0, 1)), (4, (5, 6, 7)), (1, (2,)), (1, (3,))]
        source = camaron_testing.write_vtk(self.folder / "lines.vtk", CUBE, cells)
        lost = "Omitted, because these are not triangles: 2 vertices, 1 line, 1 poly line."
        self.assertIn(lost, convert(source, self.folder / "lines.stl"))
        surface = self.folder / "lines.vtp"
        self.assertNotIn(lost, convert(source, surface))
        self.assertEqual(convert(surface, self.folder / "again.stl"), [lost])
        self.assertEqual(self.cells(self.folder / "again.stl"), 8)

    def test_surface_to_grid(self):
        convert(self.mesh(), self.folder / "two.stl")
        self.assertEqual(convert(self.folder / "two.stl", self.folder / "surface.vtu"), [])
        self.assertEqual(self.cells(self.folder / "surface.vtu"), 8)

    def test_round_trip(self):
        """A mesh that goes from Visf to .vtu and back has the same points, faces and cells."""
        for name in ("voronoi-ball", "flange", "polygon-ring"):
            original = camaron_testing.EXAMPLES / f"{name}.visf"
            between, back = self.folder / f"{name}.vtu", self.folder / f"{name}.visf"
            convert(original, between)
            convert(between, back)
            (points, *shapes), (again, *shapes_again) = map(
                camaron_testing.read_visf, (original, back)
            )
            numpy.testing.assert_array_equal(points.astype("f4"), again.astype("f4"))

            # Faces may be numbered otherwise and start elsewhere: cells as sets of sets of points.
            def as_sets(faces, cells):
                sets = [frozenset(face) for face in faces]
                return [frozenset(sets[f] for f in cell) for cell in cells] or sets

            self.assertEqual(as_sets(*shapes), as_sets(*shapes_again), name)

    def test_options(self):
        """Options have an effect in any spelling, and texts of choices are matched."""
        ascii_file, binary = self.folder / "a.vtu", self.folder / "b.vtu"
        convert(self.mesh(), ascii_file, **{"data-mode": "ascii"})
        convert(self.mesh(), binary, DataMode="Appended")
        self.assertIn(b'format="ascii"', ascii_file.read_bytes())
        self.assertNotIn(b'format="ascii"', binary.read_bytes())

    def test_wrong_options(self):
        for options, reason in (
            ({"data_mod": "ascii"}, "did you mean data-mode?"),
            ({"data_mod": "ascii"}, "--data-mode ascii|binary|appended (appended)"),
            ({"data_mode": "asci"}, "one of ascii, binary, appended"),
            ({"encode_appended_data": "maybe"}, "must be on or off, not maybe"),
            (
                {"time_step_stride": "two"},
                "time_step_stride must be an integer of at least 1, not two",
            ),
            ({"file_name_suffix": "-%d", "time_step_stride": 0}, "of at least 1, not 0"),
        ):
            with self.assertRaisesRegex(ValueError, re.escape(reason)):
                convert(self.mesh(), self.folder / "x.vtu", **options)
        self.assertFalse((self.folder / "x.vtu").exists())

    def test_arrays(self):
        """Naming arrays chooses them, all others of that kind stay away; unknown ones are refused."""
        source = self.folder / "arrays.vtk"
        source.write_text(
            camaron_testing.write_vtk(self.folder / "plain.vtk", CUBE, TETRAHEDRA).read_text()
            + "\nCELL_DATA 2\nFIELD f 2\na 1 2 float\n1 2\nb 1 2 float\n3 4\n"
            + "POINT_DATA 8\nFIELD f 2\np 1 8 float\n1 2 3 4 5 6 7 8\n"
            + "q,r 1 8 float\n1 2 3 4 5 6 7 8\n"
        )
        for target, more in (("t.ply", {"write-cells": "on"}), ("t.vtu", {}), ("t.vtk", {})):
            for options, points, cells in (
                ({}, ["p", "q,r"], ["a", "b"]),
                ({"point-data-arrays": "p"}, ["p"], ["a", "b"]),
                ({"PointDataArrays": ["p"], "cell_data_arrays": "none"}, ["p"], []),
                ({"point-data-arrays": "q,r", "cell-data-arrays": "b, a"}, ["q,r"], ["a", "b"]),
                ({"point-data-arrays": "none", "cell-data-arrays": "all"}, [], ["a", "b"]),
            ):
                with self.subTest(target=target, options=options):
                    path = self.folder / target
                    convert(source, path, **options, **more)
                    data = pipeline.open_mesh(path).source
                    self.assertEqual(sorted(data.PointData.keys()), points)
                    self.assertEqual(sorted(data.CellData.keys()), cells)
                    simple.Delete(data)
            (self.folder / target).unlink()
            for options, reason in (
                ({"point-data-arrays": "pp"}, "no array of points is named pp (did you mean p?)"),
                ({"cell-data-arrays": "a,p"}, "no array of cells is named p; the mesh has a, b"),
                ({"cell-data-arrays": "A"}, "the mesh has a, b"),
                (
                    {"field-data-arrays": "x"},
                    "unknown option" if "ply" in target else "the mesh has none",
                ),
            ):
                with self.assertRaisesRegex(ValueError, re.escape(reason)):
                    convert(source, self.folder / target, **options)
                self.assertFalse((self.folder / target).exists())
        with self.assertRaisesRegex(ValueError, r"--point-data-arrays NAME,NAME\|none \(all\)"):
            convert(source, self.folder / "t.ply", point_data_array="p")

    def test_single_precision(self):
        """ParaView's writers of STL and EnSight round without a word; near the origin nothing is worth one."""
        for name in ("q.stl", "q.case"):
            for far, notes in ((0, 0), (5e6, 1)):
                points = [(far + 0.01 * x + 1e-9, y, z) for x, y, z in CUBE]
                quads = [(9, (0, 1, 2, 3)), (9, (4, 5, 6, 7))]
                source = camaron_testing.write_vtk(self.folder / "q.vtk", points, quads)
                said = [note for note in convert(source, self.folder / name) if "precision" in note]
                self.assertEqual(len(said), notes, (name, said))
            words = "rounded to multiples of 0.5 in a mesh of size 1.4"
            self.assertIn(words, said[0])

    def test_arrays_of_stl(self):
        """For a format of ParaView that stores no arrays, a note lists the lost ones."""
        source = camaron_testing.write_vtk(self.folder / "q.vtk", CUBE, [(9, (0, 1, 2, 3))])
        source.write_text(source.read_text() + "\nCELL_DATA 1\nFIELD f 1\na 1 1 float\n1\n")
        lost = "*.stl files store no arrays; not written: a of cells."
        self.assertEqual(convert(source, self.folder / "q.stl"), [lost])

    def test_numbers(self):
        """Numbers outside the range of an option are refused, and the range is named."""
        source = self.mesh()
        for name, options, reason in (
            ("x.m3d", {"digits": "99"}, "digits must be an integer from 0 to 17, not 99"),
            ("x.m3d", {"digits": "-5"}, "from 0 to 17, not -5"),
            ("x.m3d", {"digits": "9.7"}, "from 0 to 17, not 9.7"),
            ("x.off", {"digits": "abc"}, "from 0 to 17, not abc"),
            ("x.ele", {"first-id": 7}, "first-id must be one of 0, 1, not 7"),
        ):
            with self.assertRaisesRegex(ValueError, reason):
                convert(source, self.folder / name, **options)
            self.assertFalse((self.folder / name).exists())
        convert(source, self.folder / "x.m3d", digits="17")
        with self.assertRaisesRegex(ValueError, r"--digits 0\.\.17 \(0\)"):
            convert(source, self.folder / "x.m3d", digit=9)

    def test_table(self):
        """Formats that store only a table are reported as such."""
        source, target = self.mesh(), self.folder / "two.csv"
        (note,) = convert(source, target, field_association="Point Data")
        self.assertIn("Only a table of the point data was written", note)
        self.assertEqual(len(target.read_text().splitlines()), 1 + len(CUBE))
        (note,) = convert(source, target, field_association="cell-data")
        self.assertIn("of the cell data", note)

    def test_blocks(self):
        """A format of blocks says what it lacks, and where the mesh fits."""
        message = "store meshes of several blocks, and this mesh has none: write two.vtu"
        with self.assertRaisesRegex(ValueError, message):
            convert(self.mesh(), self.folder / "two.vtm")

    def test_crash(self):
        """What would end the program is refused."""
        with self.assertRaisesRegex(ValueError, r"write two.exo, which has the same format"):
            convert(self.mesh(), self.folder / "two.gen")

    def test_no_further_arrays(self):
        """A surface in a format for surfaces gets no arrays that it did not have."""
        source, target = self.folder / "square.off", self.folder / "square.vtp"
        source.write_text("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")
        self.assertEqual(convert(source, target), [])
        grid = self.fetch(self.open(target))
        self.assertEqual(grid.GetNumberOfCells(), 1)
        data = grid.GetCellData(), grid.GetPointData()
        self.assertEqual([one.GetNumberOfArrays() for one in data], [0, 0])

    def test_texts_in_a_table(self):
        """Tables keep names, texts and all digits, and no spreadsheet runs them as a formula."""
        grid = vtkUnstructuredGrid()
        points = vtkPoints()
        points.InsertNextPoint(0.1, 0, 0)
        points.InsertNextPoint(1, 0, 0)
        grid.SetPoints(points)
        texts = ['=1+"1"', "\n=1, b's|"]
        for name in ('=HYPERLINK("x")', '-a, "b"'):
            array = vtkStringArray()
            array.SetName(name)
            for value in texts:
                array.InsertNextValue(value)
            grid.GetPointData().AddArray(array)
        numbers = vtkDoubleArray()
        numbers.SetName("third")
        numbers.InsertNextValue(1 / 3)
        numbers.InsertNextValue(-2)
        grid.GetPointData().AddArray(numbers)
        bytes_ = vtkSignedCharArray()  # which VTK writes as characters
        bytes_.SetName("byte")
        bytes_.InsertNextValue(-1)
        bytes_.InsertNextValue(44)
        grid.GetPointData().AddArray(bytes_)
        target = self.folder / "texts.csv"
        producer = simple.TrivialProducer()
        producer.GetClientSideObject().SetOutput(grid)
        write_source(producer, target, [])
        with open(target, newline="", encoding="utf-8") as file:
            header, *rows = csv.reader(file)
        columns = dict(zip(header, zip(*rows)))
        self.assertEqual(columns['\'=HYPERLINK("x")'], ('\'=1+"1"', "'\n=1, b's|"))
        self.assertEqual(columns['\'-a, "b"'], columns['\'=HYPERLINK("x")'])
        self.assertEqual([float(value) for value in columns["third"]], [1 / 3, -2])
        self.assertEqual(columns["byte"], ("-1", "44"))
        whole = target.read_bytes()
        for mark in "'", "|":
            write(producer, target, {"string-delimiter": mark}, Inputs())
            self.assertTrue(target.read_text("utf-8").startswith(mark))
            with open(target, newline="", encoding="utf-8") as file:
                self.assertEqual([header, *rows], list(csv.reader(file, quotechar=mark)))
        write(producer, target, {"use-string-delimiter": "off"}, Inputs())
        bare = whole.replace(b'""', b"\0").replace(b'"', b"").replace(b"\0", b'"')
        self.assertEqual(target.read_bytes(), bare)
        with self.assertRaisesRegex(RuntimeError, "must be different"):
            write(producer, target, {"string-delimiter": ","}, Inputs())
        with self.assertRaisesRegex(RuntimeError, "field-delimiter cannot be the quotation mark"):
            options = {"string-delimiter": "'", "field-delimiter": '"'}
            write(producer, target, options, Inputs())

    def test_marks_of_a_large_table(self):
        """Marks are changed a part at a time; no part ends within a text."""
        table = self.folder / "large.csv"
        table.write_text('"a ""b""\nit\'s",1\n' * 200_000)
        storable_names.set_mark(self.folder, "'")
        self.assertEqual(table.read_text(), "'a \"b\"\nit''s',1\n" * 200_000)
        self.assertEqual(list(self.folder.iterdir()), [table])

    def test_new_folder(self):
        """The creation of a folder is reported, and undone after an error."""
        folder = self.folder / "new" / "folder"
        (note,) = convert(self.mesh(), folder / "two.visf")
        self.assertEqual(note, f"The folder {folder} was created.")
        self.assertEqual(convert(self.mesh(), folder / "again.visf"), [])
        with self.assertRaises(ValueError):
            convert(self.mesh(), self.folder / "other" / "two.m3d", digits=99)
        self.assertFalse((self.folder / "other").exists())
        with self.assertRaisesRegex(OSError, "two.vtk: cannot write to this folder: File exists"):
            convert(self.mesh(), self.folder / "two.vtk" / "x.visf")

    def test_folders_of_pieces(self):
        """Pieces never replace those of another mesh, nor what else lies in their folder."""
        first, second = self.folder / "m.pvtu", self.folder / "m.pvtp"
        convert(self.mesh(), first)
        with self.assertRaisesRegex(RuntimeError, "m for its pieces already exists"):
            convert(self.mesh(), second)
        self.assertFalse(second.exists())
        self.assertEqual(self.cells(first), 2)
        (self.folder / "m" / "mine.txt").write_text("mine")
        convert(camaron_testing.EXAMPLES / "voronoi-ball.visf", first)
        self.assertEqual(self.cells(first), 800)
        self.assertEqual((self.folder / "m" / "mine.txt").read_text(), "mine")
        taken = self.folder / "taken.vtu"
        taken.mkdir()
        (taken / "mine.txt").write_text("mine")
        with self.assertRaisesRegex(OSError, "there is a folder of this name"):
            convert(self.mesh(), taken)
        self.assertEqual((taken / "mine.txt").read_text(), "mine")

    def test_files_that_are_replaced(self):
        """A link stays a link, permissions stay, and write-protected files are not replaced."""
        source, link = self.mesh(), self.folder / "link.vtu"
        (self.folder / "other").mkdir()
        real = self.folder / "other" / "real.vtu"
        real.write_text("old")
        real.chmod(0o600)
        link.symlink_to(real)
        convert(source, link)
        self.assertTrue(link.is_symlink())
        self.assertEqual((self.cells(real), real.stat().st_mode & 0o777), (2, 0o600))
        self.assertEqual(list((self.folder / "other").iterdir()), [real])
        real.write_text("old")
        with unittest.mock.patch("os.access", return_value=False):
            with self.assertRaisesRegex(PermissionError, "real.vtu: the file is write-protected"):
                convert(source, real)
        self.assertEqual(real.read_text(), "old")

    def test_ghosts(self):
        """Ghost cells that pieces bring along are no cells of one file."""
        pieces, target = self.folder / "ghost.vtu", self.folder / "real.vtk"
        convert(self.mesh(), pieces, data_mode="ascii")
        array = '<DataArray type="UInt8" Name="vtkGhostType" format="ascii"> 0 1 </DataArray>'
        text = re.sub(r"<CellData[^>]*>", lambda found: found[0] + array, pieces.read_text())
        pieces.write_text(text)
        self.assertEqual(convert(pieces, target), ["Omitted: 1 ghost cell."])
        self.assertEqual(self.cells(target), 1)
        convert(pieces, self.folder / "surface.vtp")
        self.assertEqual(self.cells(self.folder / "surface.vtp"), 4)

    def test_compressed(self):
        with self.assertRaisesRegex(ValueError, "not written: write x.msh and compress it"):
            convert(self.mesh(), self.folder / "x.msh.gz")

    def test_names_that_are_only_read(self):
        """Extensions that are read but not written are answered by the name that is, and the options."""
        for name, reason in (
            ("x.coff", "write x.off with --vertex-colors NAME,"),
            ("x.noff", "write x.off with --write-normals,"),
            ("x.4off", "write x.off, which"),
            (
                "x.stcnoff",
                "x.off with --write-texture-coordinates --vertex-colors NAME --write-normals,",
            ),
            ("x.face", "write x.ele with --write-boundary-faces,"),
            *((f"x.{kind}", "write x.ele, which") for kind in ("edge", "neigh", "poly", "smesh")),
        ):
            with self.assertRaisesRegex(ValueError, f"not written under that name: .*{reason}"):
                convert(self.mesh(), self.folder / name)

    def test_errors(self):
        broken = self.folder / "broken.vtu"
        broken.write_text('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid"><Unstr')
        for source, target, error in (
            (self.folder / "none.vtu", "x.vtk", RuntimeError),
            (broken, "x.vtk", RuntimeError),
            (self.mesh(), "x.vtuu", ValueError),
            (self.mesh(), "x", ValueError),
            (self.mesh(), "two.vtk", ValueError),
        ):
            before = sorted(self.folder.iterdir())
            with self.assertRaises(error):
                convert(source, self.folder / target)
            self.assertEqual(sorted(self.folder.iterdir()), before, "nothing may be left behind")

    def test_cells_that_writers_do_not_know(self):
        """Cells at which writers of ParaView would end or never end are refused; what was there stays."""
        faces = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
        stream = [len(faces)] + [x for face in faces for x in (len(face), *face)]
        source = camaron_testing.write_vtk(self.folder / "poly.vtk", CUBE, [(42, stream)])
        for name in ("poly.e", "poly.exo", "poly.vtkhdf"):
            target = self.folder / name
            target.write_text("old")
            with self.assertRaisesRegex(
                ValueError, f"{name}: .* polyhedra, and the mesh has 1: choose .vtu"
            ):
                convert(source, target)
            self.assertEqual(target.read_text(), "old")
        polygon = camaron_testing.write_vtk(self.folder / "polygon.vtk", CUBE, [(7, (0, 1, 2, 3))])
        with self.assertRaisesRegex(ValueError, "cannot store polygons, and the mesh has 1: "):
            convert(polygon, self.folder / "polygon.exo")

    def test_refused_cells(self):
        """Cells that a format cannot store are an error unless an option says what to do with them."""
        source, target = self.mesh(), self.folder / "two.tri"
        quads = camaron_testing.write_vtk(self.folder / "q.vtk", CUBE, [(9, (0, 1, 2, 3))])
        self.assertIn("boundary", " ".join(convert(source, target)))
        target.unlink()
        with self.assertRaisesRegex(RuntimeError, "1 cell of type quad"):
            convert(quads, target)
        self.assertFalse(target.exists())
        (note,) = convert(quads, target, unsupported_cells="convert")
        self.assertIn("cut into triangles", note)
        self.assertEqual(self.cells(target), 2)
        command = camaron_testing.run_command("convert", quads, target)
        self.assertIn("set --unsupported-cells to Convert", command.stderr)

    def test_command_options(self):
        """Options may stand anywhere, flags need no value, names after -- may begin with a dash."""
        run = camaron_testing.run_command
        source = camaron_testing.EXAMPLES / "voronoi-ball.visf"
        target = self.folder / "-c.visf"
        good = run(
            *("convert", "--option", "Encoding=Binary Big Endian", "--write-neighbors"),
            *("--", source, target.name),
            cwd=self.folder,
        )
        self.assertEqual((good.returncode, good.stderr), (0, ""))
        self.assertEqual(target.read_bytes()[:1], b"0")
        again = run("convert", "--", target.name, "d.visf", cwd=self.folder)
        self.assertEqual((again.returncode, again.stderr), (0, ""))
        bad = run("convert", source, self.folder / "d.visf", "--encodin", "x")
        self.assertEqual(bad.returncode, 2)
        self.assertIn("did you mean encoding?", bad.stderr)
        self.assertIn("--encoding ascii|binary-little-endian|", bad.stderr)

    def test_other_formats(self):
        """Files of other programs with our extensions go to ParaView's own readers, with a note."""
        mesh = (
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n"
            "$EndNodes\n$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n"
        )
        for comments in ("", "$Comments\nof whoever wrote it\n$EndComments\n"):
            gmsh = self.folder / "g.msh"
            gmsh.write_text(comments + mesh)
            try:
                notes = convert(gmsh, self.folder / "g.vtu")
            except RuntimeError as error:  # a ParaView without its reader
                self.assertRegex(str(error), "this is a Gmsh mesh, for which this ParaView has no")
            else:
                self.assertRegex(notes[0], "This is a Gmsh mesh; ParaView's own reader")
                self.assertEqual(self.cells(self.folder / "g.vtu"), 1)

    def test_unreadable(self):
        """Each error gives the reason in a few words."""
        (self.folder / "empty.visf").write_text("")
        (self.folder / "text.visf").write_text("Dear diary")
        (self.folder / "x.unheard").write_text("Dear diary")
        (self.folder / "text.msh").write_text("Dear diary")
        (self.folder / "open.cas").write_text('(a "x')
        (self.folder / "folder.msh").mkdir()
        os.mkfifo(self.folder / "pipe.visf")
        for name, reason in (
            ("text.msh", "text.msh:1: expected a section of a Fluent mesh"),
            ("open.cas", "open.cas:1: expected a closing parenthesis for the section"),
            ("folder.msh", "this is a folder, not a mesh"),
            ("empty.visf", "the file is empty"),
            ("text.visf", "expected a Visf file"),
            ("x.unheard", r"there is no reader for \*.unheard files; camaron convert --help"),
            (".", "this is a folder, not a mesh"),
            ("pipe.visf", "this is a pipe or a device"),
        ):
            with self.assertRaisesRegex(RuntimeError, reason):
                convert(self.folder / name, self.folder / "y.vtu")

    def test_pipes(self):
        """A pipe gets the bytes of the file and stays a pipe; so does one behind a link."""
        expected = self.folder / "a.visf"
        convert(self.mesh(), expected)
        pipe, link = self.folder / "pipe.visf", self.folder / "link.visf"
        os.mkfifo(pipe)
        link.symlink_to(pipe)
        for target in (pipe, link):
            with open(pipe, "rb", opener=lambda path, _: os.open(path, os.O_RDWR)) as reading:
                convert(self.mesh(), target)
                self.assertEqual(
                    reading.read(expected.stat().st_size), expected.read_bytes(), target.name
                )
            self.assertTrue(pipe.is_fifo() and link.is_symlink())

    def test_full_disk(self):
        """A file that could not be written to its end is an error, whether or not its writer says so.

        Files may not grow beyond a limit here, which is as if the disk were full.
        """
        source = self.folder / "source.vtu"
        convert(camaron_testing.EXAMPLES / "flange.visf", source)
        convert(source, self.folder / "surface.vtp")
        targets = (
            "source.case source.xmf source.vtk surface.obj surface.geo surface.csv surface.vtp"
        )
        if (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()) < (9, 6):
            targets += " source.vtkhdf"  # the HDF5 of later ones ends the program
        for name in targets.split():
            mesh = source if name.startswith("source") else self.folder / "surface.vtp"
            target = self.folder / f"full-{name}"
            target.write_text("old")
            before = sorted(self.folder.iterdir())
            limits = resource.getrlimit(resource.RLIMIT_FSIZE)
            resource.setrlimit(resource.RLIMIT_FSIZE, (FULL, limits[1]))
            try:
                with self.subTest(name), self.assertRaises((RuntimeError, OSError)) as caught:
                    convert(mesh, target)
            finally:
                resource.setrlimit(resource.RLIMIT_FSIZE, limits)
            self.assertNotIn("0x", str(caught.exception).replace(str(self.folder), ""))
            self.assertEqual(target.read_text(), "old")
            self.assertEqual(sorted(self.folder.iterdir()), before, name)

    def test_too_little_space(self):
        """Formats whose writer would end the program on a full disk are not begun."""
        with unittest.mock.patch("camaron.common.files.free_space", return_value=100):
            with self.assertRaisesRegex(
                RuntimeError, "x.exo: the disk has 100 B free, and the mesh"
            ):
                convert(self.mesh(), self.folder / "x.exo")
            with self.assertRaisesRegex(RuntimeError, "x.obj: .*the disk is full"):
                convert(self.mesh(), self.folder / "x.obj")
        convert(self.mesh(), self.folder / "x.exo")
        self.assertTrue((self.folder / "x.exo").exists())

    def test_companions(self):
        """Companion files of a target do not replace files of another mesh; EnSight's have the name of the target."""
        for name, other in (("m.xmf", "m.h5"), ("m.ele", "m.node"), ("n.case", "n.0.00000.geo")):
            (self.folder / other).write_text("mine")
            with self.assertRaisesRegex(
                RuntimeError, f"{name}: the file .*{other}, which is written with it"
            ):
                convert(self.mesh(), self.folder / name)
            self.assertEqual((self.folder / other).read_text(), "mine")
            self.assertFalse((self.folder / name).exists())
            (self.folder / other).unlink()
            for _ in range(2):  # its own are replaced
                convert(self.mesh(), self.folder / name)
                self.assertEqual(self.cells(self.folder / name), 2)
        self.assertFalse((self.folder / "n.0.case").exists())
        # Nor those of the mesh itself; and what stays of another one is told.
        before = [(self.folder / name).read_bytes() for name in ("m.node", "m.ele")]
        with self.assertRaisesRegex(ValueError, "m.node: this file is read"):
            convert(self.folder / "m.ele", self.folder / "m.node", first_id=1)
        after = [(self.folder / name).read_bytes() for name in ("m.node", "m.ele")]
        self.assertEqual(after, before)
        (self.folder / "m.neigh").write_text("old")
        notes = convert(self.mesh(), self.folder / "m.ele")
        self.assertIn("Files of the same name do not belong to this mesh: m.neigh.", notes)

    def test_killed(self):
        """Whatever ends the process while it writes, no folder of its own stays behind."""
        script = "import sys, time\nfrom camaron.common.files import Staging\n"
        script += "from camaron.common.inputs import Inputs\n"
        script += "with Staging(sys.argv[1], Inputs()) as staging:\n"
        script += "    (staging.path / 'x.part').write_text('x')\n"
        script += "    print('ready', flush=True)\n"
        script += "    time.sleep(240)\n"
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
            with subprocess.Popen(
                [shutil.which("pvpython"), "-c", script, str(self.folder / "new" / "folder")],
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
            ) as process:
                self.addCleanup(process.kill)
                while process.stdout.readline().strip() not in (b"ready", b""):
                    pass
                self.assertTrue((self.folder / "new" / "folder").is_dir())
                process.send_signal(number)
                process.wait()
            end = time.monotonic() + 60
            while list(self.folder.iterdir()) and time.monotonic() < end:
                time.sleep(0.05)
            self.assertEqual(list(self.folder.rglob("*")), [], number)

    def test_field_data(self):
        """Field data that a format cannot store is reported."""
        source = self.folder / "fields.vtu"
        script = """
import vtk
for name in ("Origin", "TimeValue"):
    array = vtk.vtkDoubleArray()
    array.SetName(name)
    array.InsertNextValue(1.5)
    self.GetOutput().GetFieldData().AddArray(array)
self.GetOutput().SetPoints(vtk.vtkPoints())
self.GetOutput().Allocate(1)
for x in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)):
    self.GetOutput().GetPoints().InsertNextPoint(x)
self.GetOutput().InsertNextCell(vtk.VTK_TETRA, 4, (0, 1, 2, 3))
self.GetOutput().GetCellData().AddArray(array)
"""
        made = simple.ProgrammableSource(OutputDataSetType="vtkUnstructuredGrid", Script=script)
        simple.SaveData(str(source), made)
        for suffix in ("visf", "m3d", "ts", "ele", "msh", "cdb", "tri", "off", "ply"):
            notes = " ".join(convert(source, self.folder / f"f.{suffix}"))
            self.assertRegex(notes, "field data; not written: Origin( |$)", suffix)
            if suffix in ("visf", "m3d", "ts", "msh"):  # of cells it is an array like any other
                self.assertRegex(notes, "arrays; not written: TimeValue( |$)", suffix)

    def test_digits(self):
        """Coordinates of more digits than a format is given are counted."""
        source = self.folder / "digits.ts"
        source.write_text(
            "4 1 0\n0 0 0\n1 0 0\n0 0.142857142857142857 0\n0 0 12.3456789\n0 1 2 3\n"
        )
        for suffix, digits in (("m3d", 9), ("cdb", 14)):
            (note,) = convert(source, self.folder / f"d.{suffix}", digits=digits)
            self.assertIn(
                f"1 point rounded to {digits} digits (set Digits to 17 for full precision): point 2",
                note,
            )
            self.assertEqual(convert(source, self.folder / f"e.{suffix}", digits=17), [])
        self.assertEqual(convert(source, self.folder / "all.m3d"), [])

    def test_command(self):
        """The command line passes options on, prints errors in one line and exits with 2."""
        good = camaron_testing.run_command(
            "convert", self.mesh(), self.folder / "c.vtu", "--compressor-type", "LZ4"
        )
        self.assertEqual((good.returncode, good.stderr), (0, ""))
        self.assertIn(b"vtkLZ4DataCompressor", (self.folder / "c.vtu").read_bytes())
        bad = camaron_testing.run_command(
            "convert", self.folder / "none.vtu", self.folder / "d.vtu"
        )
        self.assertEqual(bad.returncode, 2)
        self.assertEqual(bad.stderr, f"camaron: {self.folder}/none.vtu: there is no such file\n")


if __name__ == "__main__":
    camaron_testing.main()
