# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""From every format to every other and back: the same points, cells, order and orientation.

A format holds a mesh if what is read back is what was written. For the formats named in HELD this must
be so; of others the test finds out by itself.
"""


import camaron_testing
import gallery
import numpy
from camaron import formats, pipeline
from paraview import simple
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

VOLUMES = {"tetrahedra", "mixed"}
SURFACES = {"triangles", "quads", "polygons", "plane"}
#: Meshes of gallery.py that a format has to hold.
HELD = {
    "Visf": VOLUMES | SURFACES | {"polyhedra", "cloud"},
    "M3D": VOLUMES | {"inverted"},
    "TRI": {"triangles", "cloud"},
    "TS": {"tetrahedra", "inverted"},
    "TetGen": {"tetrahedra", "inverted", "triangles", "quadratic_tetrahedra", "cloud"},
    "FluentMesh": VOLUMES | {"polyhedra", "plane"},
    "MAPDL": VOLUMES
    | {"inverted", "triangles", "quads", "quadratic_tetrahedra", "quadratic_mixed", "cloud"},
    "PolygonOFF": SURFACES | {"cloud"},
    "PolygonPLY": SURFACES | {"cloud"},
}
#: What formats keep of coordinates; others keep all.
PRECISION = {
    "Visf": lambda values: values.astype(numpy.float32),
    "M3D": numpy.vectorize(lambda value: float(f"{value:.8e}")),
}


class TestRoundTrips(camaron_testing.TestCase):
    def save(self, source, path, notes=None):
        """By ParaView's own SaveData, whose errors are those of the writer."""
        with pipeline.Messages() as messages:
            try:
                simple.SaveData(str(path), source)
            except RuntimeError as error:
                messages.errors.append(str(error))
        if notes is not None:
            notes += messages.errors + messages.warnings
        return not messages.errors

    def load(self, path):
        """As the command opens it, which prefers the plugin's readers."""
        opened = pipeline.open_mesh(path)
        self.addCleanup(simple.Delete, opened.source)
        return opened.source

    def differences(self, expected, found, precision=None):
        """What is not the same, in a few words, or None."""
        if expected.GetNumberOfPoints() != found.GetNumberOfPoints():
            return f"{found.GetNumberOfPoints()} points, not {expected.GetNumberOfPoints()}"
        a, b = gallery.points_of(expected), gallery.points_of(found)
        if precision:
            a, b = precision(a), precision(b)
        if not numpy.array_equal(a, b):
            return f"points differ by {numpy.max(numpy.abs(a - b)):.3g}"
        if expected.GetNumberOfCells() != found.GetNumberOfCells():
            return f"{found.GetNumberOfCells()} cells, not {expected.GetNumberOfCells()}"
        for cell, (x, y) in enumerate(zip(gallery.shapes(expected), gallery.shapes(found))):
            if x != y:
                return f"cell {cell} is {y}, not {x}"
        return None

    def names(self, f):
        return f["name"], f["extensions"][0], PRECISION.get(f["name"])

    def test_matrix(self):
        both = [f for f in formats.own_formats() if f["reader"] and f["writer"]]
        self.assertGreaterEqual(len(both), 2)
        pairs = 0
        for mesh, make in gallery.MESHES.items():
            original = make()
            path = self.folder / f"{mesh}.vtu"
            writer = vtkXMLUnstructuredGridWriter()
            writer.SetFileName(str(path))
            writer.SetInputData(original)
            writer.Write()
            source = self.load(path)
            self.assertIsNone(self.differences(original, self.fetch(source)))

            holding = {}  # format: what was read from its file
            for f in both:
                name, extension, precision = self.names(f)
                notes = []
                first = self.folder / f"{mesh}-{name}.{extension}"
                problem = "not written"
                if self.save(source, first, notes):
                    back = self.load(first)
                    problem = self.differences(original, self.fetch(back), precision)
                    if problem is None:
                        holding[name] = (f, back)
                must = mesh in HELD.get(name, ())
                with self.subTest(mesh=mesh, format=name):
                    self.assertTrue(problem is None or not must, f"{problem}; {notes}")

            for a, (_, back) in holding.items():
                for b, (f, _) in holding.items():
                    with self.subTest(mesh=mesh, between=a, and_=b):
                        _, extension, precision = self.names(f)
                        second = self.folder / f"{mesh}-{a}-{b}.{extension}"
                        third = self.folder / f"{mesh}-{a}-{b}-{a}.{self.names(holding[a][0])[1]}"
                        self.assertTrue(self.save(back, second))
                        self.assertTrue(self.save(self.load(second), third))
                        expected, found = self.fetch(back), self.fetch(self.load(third))
                        problem = self.differences(expected, found, precision)
                        self.assertIsNone(problem)
                        pairs += 1
        self.assertGreater(pairs, 5)

    def test_exact_repetition(self):
        """A file that was written, read and written again is the same file, byte by byte."""
        for f in formats.own_formats():
            if not f["reader"] or not f["writer"]:
                continue
            name, extension, _ = self.names(f)
            for mesh in sorted(HELD.get(name, ())):
                grid = self.folder / f"{mesh}.vtu"
                writer = vtkXMLUnstructuredGridWriter()
                writer.SetFileName(str(grid))
                writer.SetInputData(gallery.MESHES[mesh]())
                writer.Write()
                folders = [self.folder / f"{name}-{mesh}-{i}" for i in range(2)]
                source = self.load(grid)
                for folder in folders:
                    folder.mkdir()
                    self.assertTrue(self.save(source, folder / f"m.{extension}"))
                    source = self.load(folder / f"m.{extension}")
                for path in folders[0].iterdir():
                    with self.subTest(format=name, mesh=mesh, file=path.name):
                        self.assertEqual(
                            path.read_bytes(), (folders[1] / path.name).read_bytes()
                        )


if __name__ == "__main__":
    camaron_testing.main()
