# ranks: 1 2 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""OFF files in ParaView: opening, series, errors, on any number of ranks."""

import camaron_testing
from camaron import pipeline
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


class TestPolygonOFF(camaron_testing.TestCase):
    def tearDown(self):
        for source in reversed(list(simple.GetSources().values())):
            simple.Delete(source)
        super().tearDown()

    def make(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def cells(self, source):
        """Number of cells; ParaView asks for ghost cells, which do not count."""
        cleaned = simple.RemoveGhostInformation(Input=source)
        cleaned.UpdatePipeline(source.SMProxy.GetDataInformation(0).GetTime())
        return cleaned.GetDataInformation().GetNumberOfCells()

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
