# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""OFF files in ParaView: opening, saving, series, errors, on any number of ranks."""

import camaron_testing
from camaron.common import pipeline
from paraview import simple

TRIANGLE = "3 1 0\n0 0 0\n1 0 0\n0 1 {}\n3 0 1 2 255 0 0\n"
COUNTS = {  # points and cells, as README.md of the collected files says
    "assimp_Wuson": (3205, 3732),
    "camaron_cube": (8, 6),
    "camaron_vertex_cloud": (8, 8),
    "dev_4off": (231, 220),
    "dev_binary": (231, 220),
    "dev_binary_coff_facecolors": (231, 220),
    "dev_noff2d": (231, 220),
    "dev_noheader": (231, 220),
    "dev_stcnoff": (231, 220),
    "libigl_halftunnel": (831, 784),
    "octree_all_facecolors": (426, 428),
    "polylla_cube_comments_colors": (8, 6),
    "tgt_cactus": (620, 1236),
    "tgt_mpi": (90, 52),
    "trimesh_whitespace_glued_count": (8, 6),
}


class TestPolygonOFF(camaron_testing.FormatTestCase):
    def test_open(self):
        for name in ("a.off", "A.OFF", "b.coff", "c.4off"):
            source = self.open(self.make(name, "OFF\n" + TRIANGLE.format(0)))
            self.assertEqual(type(source).__name__, "PolygonOFFReader")
            self.assertEqual(self.cells(source), 1)
            self.assertEqual(source.CellData["RGBA"].GetNumberOfComponents(), 4)
        source = self.open(self.make("none.off", TRIANGLE.format(0)))
        self.assertEqual(type(source).__name__, "PolygonOFFReader")

    def test_open_collected_files(self):
        for name, (points, cells) in COUNTS.items():
            source = self.open(self.data(f"off/{name}.off"))
            self.assertEqual(type(source).__name__, "PolygonOFFReader")
            self.assertEqual(self.cells(source), cells, name)
            found = source.GetDataInformation().GetNumberOfPoints()
            # Points on seams belong to several ranks.
            self.assertGreaterEqual(found, points, name)
            if camaron_testing.rank_count() == 1:
                self.assertEqual(found, points, name)

    def test_series(self):
        paths = [str(self.make(f"s{i}.off", "OFF " + TRIANGLE.format(i))) for i in range(3)]
        source = simple.PolygonOFFReader(FileNames=paths)
        self.assertEqual(list(source.TimestepValues), [0, 1, 2])
        for i in range(3):
            source.UpdatePipeline(i)
            self.assertEqual(source.GetDataInformation().GetBounds()[5], i)

    def lines(self, path):
        return path.read_text().splitlines()

    def test_save(self):
        path = self.make(
            "in.off",
            "STCNOFF 4 2 0\n"
            + "".join(
                f"{x} {y} 0.1 0 0 1 {9 * x} {8 * y} 7 255 {x} {y}\n" for x in (0, 1) for y in (0, 1)
            )
            + "3 0 2 1 255 0 0 9\n3 1 2 3 0 255 0 9\n",
        )
        source = self.open(path)
        plain, full = self.folder / "plain.off", self.folder / "full.off"
        simple.SaveData(str(plain), source)
        lines = self.lines(plain)
        self.assertEqual(lines[:3], ["OFF", "4 2 0", "0 0 0.1"])
        self.assertEqual(lines[6:], ["3 0 2 1", "3 1 2 3"])
        simple.SaveData(
            str(full),
            source,
            VertexColors="RGBA",
            FaceColors="RGBA",
            WriteNormals=1,
            WriteTextureCoordinates=1,
        )
        lines = self.lines(full)
        self.assertEqual(lines[:3], ["STCNOFF", "4 2 0", "0 0 0.1 0 0 1 0 0 7 255 0 0"])
        self.assertEqual(lines[6:], ["3 0 2 1 255 0 0 9", "3 1 2 3 0 255 0 9"])
        binary = self.folder / "binary.off"
        simple.SaveData(str(binary), self.open(full), Encoding="Binary", FaceColors="RGBA")
        self.assertEqual(binary.stat().st_size, len("OFF BINARY\n") + 12 + 4 * 12 + 2 * 36)
        self.assertEqual(self.cells(self.open(binary)), 2)

    def test_saved_file_does_not_depend_on_ranks(self):
        options = dict(VertexColors="RGBA", FaceColors="ColorIndex", WriteNormals=1)
        meshes = [(self.sheet(), 108, 88)]
        for whole, points, faces in meshes + [
            (path, 231, 220) for path in self.real("off/dev_stcnoff.off")
        ]:
            first, second = self.folder / "first.off", self.folder / "second.off"
            simple.SaveData(str(first), self.open(whole), **options)
            lines = self.lines(first)
            self.assertEqual(lines[:2], ["CNOFF", f"{points} {faces} 0"])
            # Ids of the first faces of the file itself, which says that nothing was sorted anew.
            found = [line.split()[1:5] for line in lines[-faces : 3 - faces]]
            self.assertEqual(found, self.faces(whole, faces)[:3])
            simple.SaveData(str(second), self.open(first), **options)
            self.assertEqual(first.read_bytes(), second.read_bytes())

    def sheet(self):
        """A file of 11 times 8 squares over 12 times 9 points, with colors and normals."""
        points = [
            f"{x} {y} {x * y % 5} 0 0 1 {9 * x} {8 * y} 7 255" for y in range(9) for x in range(12)
        ]
        corners = [x + 12 * y for y in range(8) for x in range(11)]
        faces = [f"4 {i} {i + 1} {i + 13} {i + 12} {i % 7}" for i in corners]
        return self.make("sheet.off", "\n".join(["CNOFF", "108 88 0", *points, *faces]) + "\n")

    def faces(self, path, number):
        """The first four ids of each of the faces, which are the last lines."""
        lines = [line for line in path.read_text().splitlines() if line and line[0] != "#"]
        return [line.split()[1:5] for line in lines[-number:]]

    def test_save_surfaces(self):
        if camaron_testing.rank_count() > 1:
            self.skipTest("an image has no global ids, without which faces between ranks stay")
        path = self.folder / "out.off"
        image = simple.Wavelet(WholeExtent=[0, 2, 0, 2, 0, 2])
        simple.SaveData(str(path), image)
        self.assertEqual(self.lines(path)[1], "26 24 0")
        simple.SaveData(str(path), image, FacesOfVolumes="Every")
        self.assertEqual(self.lines(path)[1], "27 36 0")

    def test_errors(self):
        path = self.make("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")
        with pipeline.Messages() as messages:
            source = simple.PolygonOFFReader(FileNames=[str(path)])
            source.UpdatePipeline()
        self.assertEqual(source.GetDataInformation().GetNumberOfPoints(), 0)
        if camaron_testing.rank_count() == 1:
            self.assertEqual(len(messages.errors), 1)
            self.assertIn("bad.off:6: expected a vertex of a face from 0 to 2", messages.errors[0])


if __name__ == "__main__":
    camaron_testing.main()
