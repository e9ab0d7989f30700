# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""camaron.convert: formats, options of writers, errors."""

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
            self.assertIn("boundary surface", notes[0])
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
            ({"data_mod": "ascii"}, "did you mean DataMode?"),
            ({"data_mode": "asci"}, "one of Ascii, Binary, Appended"),
        ):
            with self.assertRaisesRegex(ValueError, reason.replace("?", r"\?")):
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
