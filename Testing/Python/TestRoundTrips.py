# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""From every format to every other and back: the same points, cells, order and orientation.

A format stores a mesh if the mesh that is read equals the one that was written. For the files in HELD this is required;
for others the test finds out.
"""


import camaron_testing
import gallery
import numpy
from camaron.common import formats, pipeline
from paraview import simple
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

VOLUMES = {"tetrahedra", "mixed"}
SURFACES = {"triangles", "quads", "polygons", "plane"}
#: Meshes of gallery.py that files of an extension, or of a dialect before it, have to hold.
HELD = {
    "visf": VOLUMES | SURFACES | {"polyhedra", "cloud"},
    "m3d": VOLUMES | {"inverted", "cloud"},
    "m2d": {"triangles", "quads", "cloud"},
    "tri": {"triangles", "cloud"},
    "Cart3D.tri": {"triangles", "cloud"},
    "ts": {"tetrahedra", "inverted", "cloud"},
    "GOCAD.ts": {"triangles", "cloud"},
    "ele": {"tetrahedra", "inverted", "triangles", "quadratic_tetrahedra", "cloud"},
    "node": {"tetrahedra", "inverted", "triangles", "quadratic_tetrahedra", "cloud"},
    "msh": VOLUMES | {"polyhedra", "plane"},
    "cdb": VOLUMES
    | {"inverted", "triangles", "quads", "quadratic_tetrahedra", "quadratic_mixed", "cloud"},
    "off": SURFACES | {"cloud"},
    "ply": VOLUMES | SURFACES | {"polyhedra", "cloud"},
}
#: Files that keep single precision.
SINGLE = {"visf"}
#: Encodings that do, of files that do not otherwise.
SINGLE_ENCODINGS = {("off", "binary"), ("msh", "binary-single"), ("cas", "binary-single")}
#: What to set so that every digit, and every cell, is written, in the dialect that the name says.
OPTIONS = {
    "MAPDL": {"Digits": 17},
    "PolygonPLY": {"WriteCells": 1},
    "Cart3D.tri": {"Dialect": "Cart3D"},
    "GOCAD.ts": {"Dialect": "GOCAD"},
}


class TestRoundTrips(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        self.sources = []

    def save(self, source, path, notes=None, **options):
        """By ParaView's own SaveData, whose errors are those of the writer."""
        dialect = ".".join(path.name.split(".")[-2:])
        writer = formats.own_writer(path)[: -len("Writer")]
        options = options or OPTIONS.get(dialect) or OPTIONS.get(writer, {})
        with pipeline.Messages() as messages:
            try:
                simple.SaveData(str(path), source, **options)
            except RuntimeError as error:
                messages.errors.append(str(error))
        if notes is not None:
            notes += messages.errors + messages.warnings
        return not messages.errors

    def kinds(self):
        """Ends of names that the plugin reads and writes; one of those that mean the same."""
        found = []
        for f in formats.own_formats():
            if f["reader"] and f["writer"]:
                known = [kind for kind in HELD if kind.split(".")[-1] in f["extensions"]]
                found += known or f["extensions"][:1]
        return found

    def source(self, mesh):
        """A source of a mesh of the gallery, and the mesh."""
        path, grid = self.folder / f"{mesh}.vtu", gallery.MESHES[mesh]()
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetFileName(str(path))
        writer.SetInputData(grid)
        writer.Write()
        return self.load(path), grid

    def load(self, path):
        """As the command opens it, which prefers the plugin's readers."""
        opened = pipeline.open_mesh(path)
        self.sources.append(opened.source)
        own = formats.own_readers(path)
        self.assertTrue(not own or opened.source.SMProxy.GetXMLName() in own, "another's reader")
        return opened.source

    def forget(self):
        """Deletes what was loaded last; many sources make ParaView slow."""
        simple.Delete(self.sources.pop())

    def differences(self, expected, found, is_single):
        """What is not the same, in a few words, or None."""
        if expected.GetNumberOfPoints() != found.GetNumberOfPoints():
            return f"{found.GetNumberOfPoints()} points, not {expected.GetNumberOfPoints()}"
        a, b = gallery.points_of(expected), gallery.points_of(found)
        if is_single:
            a, b = a.astype(numpy.float32), b.astype(numpy.float32)
        if not numpy.array_equal(a, b):
            return f"points differ by {numpy.max(numpy.abs(a - b)):.3g}"
        if expected.GetNumberOfCells() != found.GetNumberOfCells():
            return f"{found.GetNumberOfCells()} cells, not {expected.GetNumberOfCells()}"
        for cell, (x, y) in enumerate(zip(gallery.shapes(expected), gallery.shapes(found))):
            if x != y:
                return f"cell {cell} is {y}, not {x}"
        return None

    def test_matrix(self):
        pairs = 0
        for mesh in gallery.MESHES:
            source, original = self.source(mesh)
            self.assertIsNone(self.differences(original, self.fetch(source), False))
            holding = {}  # extension: what was read from such a file
            for kind in self.kinds():
                notes = []
                first = self.folder / f"{mesh}.{kind}"
                problem = "not written"
                if self.save(source, first, notes):
                    back = self.load(first)
                    problem = self.differences(original, self.fetch(back), kind in SINGLE)
                    if problem is None:
                        holding[kind] = back
                with self.subTest(mesh=mesh, kind=kind):
                    must = mesh in HELD.get(kind, ())
                    self.assertTrue(problem is None or not must, f"{problem}; {notes}")

            for a, back in holding.items():
                expected = self.fetch(back)
                for b in holding:
                    with self.subTest(mesh=mesh, kind=a, between=b):
                        second = self.folder / f"{mesh}-{a}-{b}.{b}"
                        third = self.folder / f"{mesh}-{a}-{b}-{a}.{a}"
                        self.assertTrue(self.save(back, second))
                        self.assertTrue(self.save(self.load(second), third))
                        self.forget()
                        found = self.fetch(self.load(third))
                        self.forget()
                        is_single = a in SINGLE or b in SINGLE
                        self.assertIsNone(self.differences(expected, found, is_single))
                        pairs += 1
            while self.sources:
                self.forget()
        self.assertGreater(pairs, 20)

    def test_encodings(self):
        """Text and binary files of either byte order have the same contents, to the precision of the file."""
        seen = set()
        for kind in self.kinds():
            name = formats.own_writer(f"x.{kind}")
            encoding = formats.options(formats.make_writer(name)).get("encoding")
            for choice in encoding.choices if encoding else ():
                seen.add((kind, choice))
                prop = formats.make_writer(name).GetProperty("Encoding")
                (value,) = (v for v in prop.Available if formats.plain(v) == formats.plain(choice))
                for mesh in sorted(HELD.get(kind, ())):
                    with self.subTest(kind=kind, encoding=choice, mesh=mesh):
                        source, original = self.source(mesh)
                        path = self.folder / f"{mesh}-{choice}.{kind}"
                        options = OPTIONS.get(name[: -len("Writer")], {})
                        self.assertTrue(self.save(source, path, Encoding=value, **options))
                        found = self.fetch(self.load(path))
                        is_single = kind in SINGLE or (kind, choice) in SINGLE_ENCODINGS
                        self.assertIsNone(self.differences(original, found, is_single))
                    while self.sources:
                        self.forget()
        self.assertIn(("visf", "binary-big-endian"), seen)

    def test_exact_repetition(self):
        """A file that was written, read and written again is the same file, byte by byte."""
        for kind in self.kinds():
            for mesh in sorted(HELD.get(kind, ())):
                source, _ = self.source(mesh)
                folders = [self.folder / f"{kind}-{mesh}-{i}" for i in range(2)]
                for folder in folders:
                    folder.mkdir()
                    self.assertTrue(self.save(source, folder / f"m.{kind}"))
                    source = self.load(folder / f"m.{kind}")
                while self.sources:
                    self.forget()
                for path in folders[0].iterdir():
                    with self.subTest(mesh=mesh, file=path.name, kind=kind):
                        again = folders[1] / path.name
                        self.assertEqual(path.read_bytes(), again.read_bytes())


if __name__ == "__main__":
    camaron_testing.main()
