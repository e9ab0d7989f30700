# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""TS files in ParaView: opening, collected files, other files, on any number of ranks."""

import unittest

import camaron_testing
import gallery
import numpy
from camaron.common import pipeline
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy


def parse_tetrahedra(path):
    """Points and ids of a file of Camarón, by a reader of the test's own."""
    rows = [line.split("#")[0].split() for line in path.read_text().splitlines()]
    rows = [row for row in rows if row]
    count = int(rows[0][0])
    points = [[float(word) for word in row[:3]] for row in rows[1 : 1 + count]]
    return numpy.array(points), [[int(word) for word in row] for row in rows[1 + count :]]


def parse_surface(path):
    """Points and triangles of a TSurf with one object."""
    points, triangles, index = [], [], {}
    for row in (line.split() for line in path.read_text().splitlines()):
        if row and row[0] in ("VRTX", "PVRTX"):
            index[row[1]] = len(points)
            points.append([float(word) for word in row[2:5]])
        elif row and row[0] == "ATOM":
            index[row[1]] = index[row[2]]
        elif row and row[0] == "TRGL":
            triangles.append(row[1:4])
    return numpy.array(points), [[index[word] for word in row] for row in triangles]


FILES = {"dev_tets_camaron": parse_tetrahedra, "dev_gocad_tsurf": parse_surface}


class TestTS(camaron_testing.FormatTestCase):
    def meshes(self):
        """Files of both kinds with the parser for each."""
        tetrahedra = self.save("tetrahedra.ts", gallery.tetrahedra())
        surface = self.save("surface.ts", gallery.triangles(), Dialect="GOCAD")
        real = [self.real(f"ts/{name}.ts") for name in FILES]
        pairs = [(tetrahedra, parse_tetrahedra), (surface, parse_surface)]
        return pairs + [
            (path, parse) for paths, parse in zip(real, FILES.values()) for path in paths
        ]

    def test_counts(self):
        """Points and cells are those of the file, on any number of ranks."""
        for path, parse in self.meshes():
            name = path.name
            points, cells = parse(path)
            owned = simple.RemoveGhostInformation(Input=self.open(path))
            owned.UpdatePipeline()
            information = owned.GetDataInformation()
            self.assertEqual(information.GetNumberOfCells(), len(cells), name)
            if camaron_testing.rank_count() == 1:  # else ranks share points
                self.assertEqual(information.GetNumberOfPoints(), len(points), name)

    @unittest.skipIf(camaron_testing.rank_count() > 1, "compares whole meshes")
    def test_cells(self):
        """Coordinates and vertices of all cells are those of the file."""
        for path, parse in self.meshes():
            name = path.name
            points, cells = parse(path)
            grid = self.fetch(self.open(path))
            numpy.testing.assert_array_equal(vtk_to_numpy(grid.GetPoints().GetData()), points)
            connectivity = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
            self.assertEqual(connectivity.reshape(len(cells), -1).tolist(), cells, name)

    def test_no_inverted_tetrahedra(self):
        """If this fails, vertices are in the wrong order: all tetrahedra of the file have positive volumes."""
        for path, parse in self.meshes():
            if parse == parse_tetrahedra:
                quality = simple.ElementQuality(Input=self.open(path), Criteria=["Volume"])
                for piece in camaron_testing.pieces(quality):
                    if piece.GetNumberOfCells():
                        volumes = vtk_to_numpy(piece.GetCellData().GetArray("Volume"))
                        self.assertGreater(volumes.min(), 0, path.name)

    def test_other_files(self):
        """Programs with this extension are rejected."""
        path = self.folder / "program.ts"
        path.write_text("import { Mesh } from './mesh';\nexport const count = 4;\n")
        with pipeline.Messages() as messages:
            source = simple.TSReader(FileNames=[str(path)])
            source.UpdatePipeline()
        self.assertEqual(source.GetDataInformation().GetNumberOfCells(), 0)
        self.assertTrue(any("TypeScript" in text for text in messages.errors), messages.errors)

    def test_texts(self):
        """The field data has the description of the surface."""
        text = (
            "GOCAD TSurf 1\nHEADER {\nname:dev\n}\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME Default\n"
            "ZPOSITIVE Depth\nEND_ORIGINAL_COORDINATE_SYSTEM\nTFACE\n"
            "VRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 1 0\nTRGL 1 2 3\nEND\n"
        )
        for path in [self.make("texts.ts", text), *self.real("ts/dev_gocad_tsurf.ts")]:
            field = self.fetch(self.open(path)).GetFieldData()
            self.assertEqual(field.GetAbstractArray("PartName").GetValue(0), "dev")
            self.assertEqual(field.GetAbstractArray("ZPositive").GetValue(0), "Depth")


if __name__ == "__main__":
    camaron_testing.main()
