# ranks: 1 2 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mesh Elements in ParaView: the same faces, edges and vertices on any number of ranks."""

import struct

import camaron_testing
from camaron_testing import EXAMPLES
from paraview import simple
from paraview.servermanager import OutputPort


CELLS = 800  # of the Voronoi ball


def sizes(path):
    """Numbers of vertices and polygons of a binary Visf file."""
    data = path.read_bytes()
    (vertices,) = struct.unpack_from("<i", data, 5)
    (polygons,) = struct.unpack_from("<i", data, 9 + 12 * vertices)
    return vertices, polygons


class TestMeshElements(camaron_testing.TestCase):
    def information(self, source, port):
        """Of the elements that no other rank has."""
        kept = simple.RemoveGhostInformation(Input=OutputPort(source, port))
        kept.UpdatePipeline()
        return kept.GetDataInformation()

    def range_of(self, information, name):
        array = information.GetCellDataInformation().GetArrayInformation(name)
        self.assertIsNotNone(array, name)
        return array.GetComponentFiniteRange(0)

    def test_counts(self):
        """Euler: the cells of a mesh without holes have V - E + F - C = 1."""
        mesh = simple.OpenDataFile(str(EXAMPLES / "voronoi-ball.visf"))
        elements = simple.MeshElements(Input=mesh)
        faces, edges = (self.information(elements, port) for port in (0, 1))
        vertices, polygons = sizes(EXAMPLES / "voronoi-ball.visf")
        self.assertEqual(faces.GetNumberOfCells(), polygons)
        self.assertEqual(edges.GetNumberOfCells(), vertices + polygons - CELLS - 1)
        self.assertEqual(self.range_of(faces, "FaceCellCount"), (1.0, 2.0))
        self.assertEqual(self.range_of(faces, "IsBoundary"), (0.0, 1.0))
        self.assertEqual(self.range_of(edges, "EdgeCellCount")[1], 3.0)

    def test_criteria_of_faces_are_those_of_cells(self):
        """The worst face of all is the worst one of a cell."""
        mesh = simple.OpenDataFile(str(EXAMPLES / "voronoi-ball.visf"))
        faces = self.information(simple.MeshElements(Input=mesh), 0)
        quality = simple.ElementQuality(
            Input=mesh, Criteria=["MaxNonOrthogonality", "MaxFaceSkewness", "MinFaceWeight"]
        )
        cells = simple.RemoveGhostInformation(Input=quality)
        cells.UpdatePipeline()
        cells = cells.GetDataInformation()
        for face, cell, end in (
            ("NonOrthogonality", "MaxNonOrthogonality", 1),
            ("FaceSkewness", "MaxFaceSkewness", 1),
            ("FaceWeight", "MinFaceWeight", 0),
        ):
            self.assertAlmostEqual(
                self.range_of(faces, face)[end], self.range_of(cells, cell)[end], places=10
            )

    def test_polygon_criteria_of_faces(self):
        mesh = simple.OpenDataFile(str(EXAMPLES / "flange.visf"))
        elements = simple.MeshElements(Input=mesh, FaceCriteria=0)
        quality = simple.ElementQuality(Input=OutputPort(elements, 0), Criteria=["Area", "MaxWarpage"])
        information = self.information(quality, 0)
        self.assertGreater(self.range_of(information, "Area")[0], 0.0)
        self.assertIsNone(
            information.GetCellDataInformation().GetArrayInformation("NonOrthogonality")
        )


if __name__ == "__main__":
    camaron_testing.main()
