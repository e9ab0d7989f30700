# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""M3D files in ParaView: opening, options, collected files, on any number of ranks."""

import unittest

import camaron_testing
import gallery
import numpy
from camaron.common import pipeline
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

NODES = {"T": 4, "P": 5, "R": 6, "H": 8}
#: VTK's number of the type, and where its nodes are in the file.
TYPES = {
    "T": (10, [0, 1, 2, 3]),
    "P": (14, [0, 1, 2, 3, 4]),
    "R": (13, [0, 2, 1, 3, 5, 4]),
    "H": (12, [0, 1, 2, 3, 4, 5, 6, 7]),
}
COLLECTED = [
    "camaron_cube",
    "camaron_tetrahedrons",
    "dev_codes23",
    "mesher_roi_cortex",
    "mesher_roi_cyl50",
]


def parse(path):
    """Points and elements of an M3D file, by a reader of the test's own."""
    words = path.read_text().split("\n")
    rows = [line.split() for line in words if line.strip()]
    count = int(rows[1][0])
    points = []
    for row in rows[2 : 2 + count]:
        values = [float(word) for word in row[1:]]
        add = values[3:6] if row[0] == "2" else [0, 0, 0]
        points.append([values[i] + add[i] for i in range(3)])
    elements = [
        (row[0], [int(word) for word in row[1 : 1 + NODES[row[0]]]]) for row in rows[4 + count :]
    ]
    assert len(elements) == int(rows[3 + count][0])
    return numpy.array(points), elements


class TestM3D(camaron_testing.FormatTestCase):
    def meshes(self):
        """Files of all elements, none of them inside out."""
        return [self.save("mixed.m3d", gallery.mixed(4))] + self.real(
            *(f"m3d/{name}.m3d" for name in COLLECTED)
        )

    def test_counts(self):
        """Points and cells are those of the file, on any number of ranks."""
        for path in self.meshes():
            name = path.name
            points, elements = parse(path)
            owned = simple.RemoveGhostInformation(Input=self.open(path))
            owned.UpdatePipeline()
            information = owned.GetDataInformation()
            self.assertEqual(information.GetNumberOfCells(), len(elements), name)
            if camaron_testing.rank_count() == 1:  # else ranks share points
                self.assertEqual(information.GetNumberOfPoints(), len(points), name)

    @unittest.skipIf(camaron_testing.rank_count() > 1, "compares whole meshes")
    def test_elements(self):
        """Types, nodes and places of elements are those of the file."""
        for path in self.meshes():
            name = path.name
            points, elements = parse(path)
            grid = self.fetch(self.open(path))
            types = vtk_to_numpy(grid.GetCellTypesArray()).tolist()
            self.assertEqual(types, [TYPES[letter][0] for letter, _ in elements], name)
            numpy.testing.assert_array_equal(vtk_to_numpy(grid.GetPoints().GetData()), points)
            connectivity = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).tolist()
            expected = [nodes[i] for letter, nodes in elements for i in TYPES[letter][1]]
            self.assertEqual(connectivity, expected, name)

    def test_no_inverted_elements(self):
        """If this fails, nodes are in the wrong order: the generators' elements are all positive."""
        for path in self.meshes():
            source = self.open(path)
            quality = simple.ElementQuality(Input=source, Criteria=["Volume"])
            for piece in camaron_testing.pieces(quality):
                if piece.GetNumberOfCells():
                    volumes = vtk_to_numpy(piece.GetCellData().GetArray("Volume"))
                    self.assertGreater(volumes.min(), 0, path.name)

    @unittest.skipIf(camaron_testing.rank_count() > 1, "compares whole meshes")
    def test_reference(self):
        """The generator's own VTK file of the mesh: the same points and cells in the same order."""
        expected = self.fetch(self.open(self.data("m3d/mesher_roi_cortex_reference.vtk")))
        grid = self.fetch(self.open(self.data("m3d/mesher_roi_cortex.m3d")))
        for get in (
            lambda mesh: mesh.GetCellTypesArray(),
            lambda mesh: mesh.GetCells().GetOffsetsArray(),
            lambda mesh: mesh.GetCells().GetConnectivityArray(),
        ):
            numpy.testing.assert_array_equal(vtk_to_numpy(get(grid)), vtk_to_numpy(get(expected)))
        places = vtk_to_numpy(grid.GetPoints().GetData()).astype("float32")
        numpy.testing.assert_array_equal(places, vtk_to_numpy(expected.GetPoints().GetData()))

    def test_other_format(self):
        """A file of another format with this extension is rejected; the error names the format."""
        other = self.folder / "other.m3d"
        other.write_bytes(b"3DMO" + bytes(range(60)))
        for path in [other, *self.real("malformed/m3d_other_format_bztsrc_suzanne.m3d")]:
            with pipeline.Messages() as messages:
                source = simple.M3DReader(FileNames=[str(path)])
                source.UpdatePipeline()
            self.assertEqual(source.GetDataInformation().GetNumberOfCells(), 0)
            self.assertTrue(any("Model 3D" in text for text in messages.errors), messages.errors)


if __name__ == "__main__":
    camaron_testing.main()
