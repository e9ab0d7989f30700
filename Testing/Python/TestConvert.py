# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""camaron.convert: formats, options of writers, errors."""

import re

import camaron_testing
import numpy
from camaron import convert

CUBE = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
TETRAHEDRA = [(10, (0, 1, 3, 4)), (10, (2, 3, 1, 6))]


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
            ({"encode_appended_data": "maybe"}, "is on or off, not maybe"),
            ({"time_step_stride": "two"}, "cannot be 'two'"),
        ):
            with self.assertRaisesRegex(ValueError, re.escape(reason)):
                convert(self.mesh(), self.folder / "x.vtu", **options)
        self.assertFalse((self.folder / "x.vtu").exists())

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

    def test_failed_write_keeps_the_old_file(self):
        """An Exodus file cannot hold general polyhedra; what was there stays."""
        faces = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
        stream = [len(faces)] + [x for face in faces for x in (len(face), *face)]
        source = camaron_testing.write_vtk(self.folder / "poly.vtk", CUBE, [(42, stream)])
        target = self.folder / "poly.e"
        target.write_text("old")
        with self.assertRaises(RuntimeError):
            convert(source, target)
        self.assertEqual(target.read_text(), "old")

    def test_refused_cells(self):
        """What a format cannot hold is an error unless the user says what to do."""
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
        """Other programs' formats under our extensions go to ParaView's own readers, and say so."""
        gmsh = self.folder / "g.msh"
        gmsh.write_text(
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n"
            "$EndNodes\n$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n"
        )
        try:
            notes = convert(gmsh, self.folder / "g.vtu")
        except RuntimeError as error:  # a ParaView without its reader
            self.assertRegex(str(error), "this is a Gmsh mesh, for which this ParaView has no")
        else:
            self.assertRegex(notes[0], "This is a Gmsh mesh; ParaView's own reader")
            self.assertEqual(self.cells(self.folder / "g.vtu"), 1)

    def test_time_steps(self):
        """One step is taken, and said to be; or all are written to numbered files."""
        for step in range(2):
            convert(camaron_testing.EXAMPLES / "flange.visf", self.folder / f"s{step}.visf")
        series = self.folder / "s.visf.series"
        files = ", ".join(f'{{"name": "s{i}.visf", "time": {i}}}' for i in range(2))
        series.write_text(f'{{"file-series-version": "1.0", "files": [{files}]}}')
        (note,) = convert(series, self.folder / "one.visf")
        self.assertIn("Of 2 time steps number 1", note)
        self.assertEqual(convert(series, self.folder / "all.visf", write_time_steps="on"), [])
        names = sorted(path.name for path in self.folder.glob("all*"))
        self.assertEqual(names, ["all_0.visf", "all_1.visf"])

    def test_unreadable(self):
        """Each says what is wrong in a few words."""
        (self.folder / "empty.visf").write_text("")
        (self.folder / "text.visf").write_text("Dear diary")
        (self.folder / "x.unheard").write_text("Dear diary")
        for name, reason in (
            ("empty.visf", "the file is empty"),
            ("text.visf", "expected a Visf file"),
            ("x.unheard", r"no reader knows files named \*.unheard; camaron convert --help"),
            (".", "this is a folder, not a mesh"),
        ):
            with self.assertRaisesRegex(RuntimeError, reason):
                convert(self.folder / name, self.folder / "y.vtu")

    def test_command(self):
        """The command line passes options on, says errors in one line and exits with 2."""
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
