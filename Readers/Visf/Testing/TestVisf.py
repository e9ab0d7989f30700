# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Visf files in ParaView: opening, saving, series, states, errors, on any number of ranks."""

import shutil
import struct
import unittest
from collections import Counter
from pathlib import Path

from paraview import simple

import camaron_testing
from camaron.common import pipeline
from camaron_testing import EXAMPLES

ENCODINGS = ["ASCII", "Binary Little Endian", "Binary Big Endian", "Binary Version 0.2"]
MESHES = ["flange.visf", "voronoi-ball.visf", "polygon-ring.visf"]


def parse(path):
    """Number of vertices, polygons and polyhedra of a file, by a reader of the test's own."""
    data = Path(path).read_bytes()
    if data[:1] == b"2":
        numbers = iter(data.split())
        next(numbers), next(numbers)
        read = lambda: int(next(numbers))
        skip = lambda count: [next(numbers) for _ in range(count)]
    else:
        order = ">" if data[:1] in b"0\0" else "<"
        position = 5

        def read():
            nonlocal position
            position += 4
            return struct.unpack_from(order + "i", data, position - 4)[0]

        def skip(count):
            nonlocal position
            position += 4 * count

    def lists():
        return [[read() for _ in range(read())] for _ in range(read())]

    vertices = read()
    skip(3 * vertices)
    polygons = lists()
    for _ in polygons if read() else []:
        skip(read())
    try:
        return vertices, polygons, lists()
    except (StopIteration, struct.error):
        return vertices, polygons, []


def counts(path):
    """Numbers of vertices, polygons and polyhedra of a file."""
    vertices, polygons, polyhedra = parse(path)
    return vertices, len(polygons), len(polyhedra)


class TestVisf(camaron_testing.FormatTestCase):
    def information(self, source):
        """Numbers of points and cells; ParaView asks for ghost cells, which do not count."""
        cleaned = simple.RemoveGhostInformation(Input=source)
        cleaned.UpdatePipeline(source.SMProxy.GetDataInformation(0).GetTime())
        information = cleaned.GetDataInformation()
        numbers = information.GetNumberOfPoints(), information.GetNumberOfCells()
        simple.Delete(cleaned)
        return numbers

    def measures(self, source):
        """Length, area and volume of the mesh."""
        sizes = simple.CellSize(Input=source)
        integral = simple.IntegrateVariables(Input=sizes)
        cells = self.fetch(integral).GetCellData()
        values = {
            cells.GetArrayName(i): cells.GetArray(i).GetTuple1(0)
            for i in range(cells.GetNumberOfArrays())
        }
        simple.Delete(integral)
        simple.Delete(sizes)
        return values

    def test_open(self):
        for name in MESHES:
            source = self.open(EXAMPLES / name)
            self.assertEqual(type(source).__name__, "VisfReader")
            vertices, polygons, polyhedra = counts(EXAMPLES / name)
            points, cells = self.information(source)
            if polyhedra:
                self.assertEqual(cells, polyhedra)
            else:
                self.assertEqual(cells, polygons)
            # Points on seams belong to several ranks.
            self.assertGreaterEqual(points, vertices)
            if camaron_testing.rank_count() == 1:
                self.assertEqual(points, vertices)

    def test_save_and_open(self):
        for name in MESHES:
            source = self.open(EXAMPLES / name)
            slow = name == "voronoi-ball.visf"  # Cell Size takes long for polyhedra
            expected = {} if slow else self.measures(source)
            for encoding in ENCODINGS:
                target = str(self.folder / f"saved-{len(encoding)}.visf")
                simple.SaveData(target, source, Encoding=encoding)
                # Seams are gone: as many of everything as in the original.
                self.assertEqual(counts(target), counts(EXAMPLES / name))
                again = self.open(target)
                # Points on seams belong to several ranks.
                what = slice(0 if camaron_testing.rank_count() == 1 else 1, 2)
                self.assertEqual(self.information(again)[what], self.information(source)[what])
                actual = {} if slow else self.measures(again)
                self.assertEqual(actual.keys(), expected.keys())
                for key, value in expected.items():
                    self.assertAlmostEqual(actual[key], value, delta=1e-6 * abs(value))
                simple.Delete(again)

    def test_saved_file_does_not_depend_on_ranks(self):
        source = self.open(EXAMPLES / "flange.visf")
        whole = str(self.folder / "whole.visf")
        simple.SaveData(whole, source)
        copy = str(self.folder / "copy.visf")
        simple.SaveData(copy, self.open(whole))
        self.assertEqual(Path(copy).read_bytes(), Path(whole).read_bytes())

    def test_save_neighbors(self):
        source = self.open(EXAMPLES / "flange.visf")
        small, large = str(self.folder / "small.visf"), str(self.folder / "large.visf")
        simple.SaveData(small, source)
        simple.SaveData(large, source, WriteNeighbors=1)
        self.assertGreater(Path(large).stat().st_size, Path(small).stat().st_size)
        self.assertEqual(counts(large), counts(small))

    def test_save_surface_and_image(self):
        target = str(self.folder / "sphere.visf")
        sphere = simple.Sphere()
        simple.SaveData(target, sphere)
        # Points of this source have no global ids: seams of pieces stay.
        points, cells = self.information(self.open(target))
        self.assertEqual(cells, 96)
        self.assertGreaterEqual(points, 50)
        if camaron_testing.rank_count() == 1:
            self.assertEqual(points, 50)
        image = simple.Wavelet(WholeExtent=[0, 4, 0, 3, 0, 2])
        simple.SaveData(target, image)
        self.assertEqual(counts(target)[2], 24)

    def test_save_blocks(self):
        blocks = simple.GroupDatasets(Input=[self.open(EXAMPLES / name) for name in MESHES[:2]])
        target = str(self.folder / "blocks.visf")
        simple.SaveData(target, blocks)
        expected = [sum(numbers) for numbers in zip(*(counts(EXAMPLES / m) for m in MESHES[:2]))]
        # On several ranks points of both blocks have the same global ids, and stay apart all the same.
        self.assertEqual(list(counts(target)), expected)

    def series(self):
        names = [str(self.folder / f"step{i}.visf") for i in range(3)]
        for i, name in enumerate(names):
            shutil.copy(EXAMPLES / MESHES[i], name)
        return names, simple.OpenDataFile(names)

    def test_save_series(self):
        _, source = self.series()
        target = self.folder / "saved.visf"
        simple.SaveData(str(target), source, WriteTimeSteps=1)
        self.assertFalse(target.exists())
        for i, name in enumerate(MESHES):
            self.assertEqual(counts(self.folder / f"saved_{i}.visf"), counts(EXAMPLES / name))
        source.UpdatePipeline(1)
        simple.SaveData(str(target), source)

    def test_series(self):
        names, source = self.series()
        self.assertEqual(list(source.TimestepValues), [0, 1, 2])
        for i in range(3):
            source.UpdatePipeline(i)
            _, polygons, polyhedra = counts(names[i])
            self.assertEqual(self.information(source)[1], polyhedra or polygons)

    @unittest.skipIf(
        camaron_testing.rank_count() > 1 and camaron_testing.paraview_version() >= (6, 1),
        "ParaView 6.1 does not come back from LoadState on several ranks, whatever the state",
    )
    def test_state(self):
        path = str(self.folder / "mesh.visf")
        shutil.copy(EXAMPLES / "flange.visf", path)
        state = str(self.folder / "state.pvsm")
        expected = self.information(self.open(path))
        simple.SaveState(state)
        self.tearDown()
        simple.LoadState(state)
        (source,) = simple.GetSources().values()
        self.assertEqual(type(source).__name__, "VisfReader")
        source.UpdatePipeline()
        self.assertEqual(self.information(source), expected)

    def test_ghost_cells(self):
        ranks = camaron_testing.rank_count()
        source = self.open(EXAMPLES / "voronoi-ball.visf")
        owned = self.information(source)[1]
        all_cells = source.GetDataInformation().GetNumberOfCells()
        self.assertTrue(all_cells > owned if ranks > 1 else all_cells == owned)
        # With ghost cells there is no surface between the ranks.
        surface = simple.ExtractSurface(Input=source)
        surface.UpdatePipeline()
        _, polygons, polyhedra = parse(EXAMPLES / "voronoi-ball.visf")
        uses = Counter(polygon for cell in polyhedra for polygon in cell)
        boundary = sum(1 for count in uses.values() if count == 1)
        self.assertEqual(self.information(surface)[1], boundary)

    def test_errors(self):
        whole = (EXAMPLES / "voronoi-ball.visf").read_bytes()
        path = self.folder / "half.visf"
        path.write_bytes(whole[: len(whole) // 2])
        with pipeline.Messages() as messages:
            source = simple.VisfReader(FileNames=[str(path)])
            source.UpdatePipeline()
        self.assertEqual(len(messages.errors), 1, messages.errors)
        self.assertIn("half.visf", messages.errors[0])
        self.assertEqual(self.information(source), (0, 0))


if __name__ == "__main__":
    camaron_testing.main()
