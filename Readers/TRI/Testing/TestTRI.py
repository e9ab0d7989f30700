# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""TRI files in ParaView: opening, saving, series, errors, on any number of ranks."""

import camaron_testing
from camaron.common import pipeline
from paraview import simple

#: Two triangles as the writer writes them, the height of a vertex left open.
CAMARON = "4\n0 0 0\n1 0 {}\n0 1 0\n1 1 0\n2\n0 2 1\n1 2 3\n"
CART3D = "4 2\n0 0 0\n1 0 0.1\n0 1 0\n1 1 0\n1 3 2\n2 3 4\n7\n-2\n"
COUNTS = {"camaron_polygon_mesh": (8, 18), "dev_surface": (231, 466)}  # points and cells


class TestTRI(camaron_testing.FormatTestCase):
    def numbers(self, path):
        return [[float(word) for word in line.split()] for line in path.read_text().splitlines()]

    def test_open(self):
        for name in ("a.tri", "A.TRI"):
            source = self.open(self.make(name, CAMARON.format(0.1)))
            self.assertEqual(type(source).__name__, "TRIReader")
            self.assertEqual(self.cells(source), 2)
        source = self.open(self.make("b.tri", CART3D))
        self.assertEqual(self.cells(source), 2)
        self.assertEqual(source.CellData["Component"].GetRange(), (-2, 7))

    def test_open_collected_files(self):
        for name, (points, cells) in COUNTS.items():
            source = self.open(self.data(f"tri/{name}.tri"))
            self.assertEqual(self.cells(source), cells, name)
            if camaron_testing.rank_count() == 1:  # else ranks share points
                self.assertEqual(source.GetDataInformation().GetNumberOfPoints(), points, name)

    def test_series(self):
        texts = [CAMARON.format(i) for i in range(1, 4)]
        source = simple.OpenDataFile([str(self.make(f"s{i}.tri", t)) for i, t in enumerate(texts)])
        self.assertEqual(list(source.TimestepValues), [0, 1, 2])
        for i in (2, 0, 1):
            source.UpdatePipeline(i)
            self.assertEqual(source.GetDataInformation().GetBounds()[5], i + 1)
        target = self.folder / "saved.tri"
        simple.SaveData(str(target), source, WriteTimeSteps=1)
        self.assertFalse(target.exists())
        for i, text in enumerate(texts):
            self.assertEqual((self.folder / f"saved_{i}.tri").read_text(), text)

    def test_save(self):
        source = self.open(self.make("in.tri", CART3D))
        path = self.folder / "out.tri"
        simple.SaveData(str(path), source)
        self.assertEqual(path.read_text(), CAMARON.format(0.1))
        simple.SaveData(str(path), source, Dialect="Cart3D")
        self.assertEqual(path.read_text(), CART3D)

    def test_saved_file_does_not_depend_on_ranks(self):
        for whole, size in [
            (self.sheet(), [108, 176]),
            *((p, [231, 466]) for p in self.real("tri/dev_surface.tri")),
        ]:
            first, second = self.folder / "first.tri", self.folder / "second.tri"
            simple.SaveData(str(first), self.open(whole), Dialect="Cart3D")
            self.assertEqual(self.numbers(first)[0], size)
            simple.SaveData(str(second), self.open(first))
            self.assertEqual(self.numbers(second), self.numbers(whole))

    def sheet(self):
        """A file of 11 times 8 squares, each of two triangles, over 12 times 9 points."""
        points = [f"{x} {y} {x * y % 5}" for y in range(9) for x in range(12)]
        corners = [x + 12 * y for y in range(8) for x in range(11)]
        triangles = [f"{i} {i + 1} {i + 13}\n{i} {i + 13} {i + 12}" for i in corners]
        return self.make("sheet.tri", "\n".join(["108", *points, "176", *triangles]) + "\n")

    def test_save_surfaces(self):
        text = "5 2\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 1\n1 1 1 1\n0 1 2 3\n1 2 3 4\n"
        source = self.open(self.make("tetrahedra.ts", text))
        path = self.folder / "out.tri"
        for choice, triangles in (("Boundary", 6), ("Every", 7)):
            simple.SaveData(str(path), source, FacesOfVolumes=choice)
            self.assertEqual(self.numbers(path)[6], [triangles])

    def test_save_other_cells(self):
        text = "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n4 0 1 2 3\n3 1 4 2\n"
        source = self.open(self.make("quad.off", text))
        path = self.folder / "out.tri"
        for choice, triangles in (("Skip", 1), ("Convert", 3)):
            simple.SaveData(str(path), source, UnsupportedCells=choice)
            points = int(self.numbers(path)[0][0])
            self.assertEqual(self.numbers(path)[1 + points], [triangles], choice)

    def test_errors(self):
        path = self.make("bad.tri", "3\n0 0 0\n1 0 0\n0 1 0\n1\n0 1 7\n")
        with pipeline.Messages() as messages:
            source = simple.TRIReader(FileNames=[str(path)])
            source.UpdatePipeline()
        self.assertEqual(source.GetDataInformation().GetNumberOfPoints(), 0)
        if camaron_testing.rank_count() == 1:
            (error,) = messages.errors
            self.assertIn("bad.tri:6: expected a vertex of a triangle from 0 to 2", error)


if __name__ == "__main__":
    camaron_testing.main()
