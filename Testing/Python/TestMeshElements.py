# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mesh Elements in ParaView: the same faces, edges and vertices on any number of ranks."""

import math
import re
import struct
import unittest

import camaron_testing
import gallery
import mesh_parts
import numpy
from camaron.common import tables
from camaron_testing import EXAMPLES
from paraview import simple
from paraview.servermanager import OutputPort
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkUnstructuredGrid

CELLS = 800  # of the Voronoi ball
RANKS = camaron_testing.rank_count()


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

    @unittest.skipIf(RANKS > 1, "the filter is stopped by the process that it is in")
    def test_stopped(self):
        """Aborted at the first progress report, no port has an output; updated again, all have."""
        mesh = simple.OpenDataFile(str(EXAMPLES / "voronoi-ball.visf"))
        elements = simple.MeshElements(Input=mesh)
        filter_ = elements.GetClientSideObject()
        reports = []

        def stop(*_):
            reports.append(filter_.GetProgress())
            filter_.SetAbortExecuteAndUpdateTime()

        observer = filter_.AddObserver("ProgressEvent", stop)
        elements.UpdatePipeline()
        self.assertLessEqual(set(reports), {0.0, 1.0})
        for port in range(3):
            self.assertEqual(filter_.GetOutputDataObject(port).GetNumberOfCells(), 0)
        filter_.RemoveObserver(observer)
        filter_.AbortExecuteOff()
        for port in range(3):
            filter_.Update(port)
            self.assertGreater(filter_.GetOutputDataObject(port).GetNumberOfCells(), CELLS)

    @unittest.skipIf(RANKS > 1, "every rank would have the cube")
    def test_options_of_element_quality(self):
        """Trusted faces, the tolerance and masks mean the same as there."""
        grid = vtkUnstructuredGrid()
        points = vtkPoints()
        for i in range(8):
            points.InsertNextPoint(i & 1, i >> 1 & 1, i >> 2)
        grid.SetPoints(points)
        inward = [
            (0, 1, 3, 2),
            (4, 6, 7, 5),
            (0, 4, 5, 1),
            (2, 3, 7, 6),
            (0, 2, 6, 4),
            (1, 5, 7, 3),
        ]
        stream = vtkIdList()
        for word in (6, *(word for face in inward for word in (4, *face))):
            stream.InsertNextId(word)
        grid.InsertNextCell(VTK_POLYHEDRON, stream)
        cube = mesh_parts.producer(grid)
        for trusted, sign in ((0, 1), (1, -1)):
            elements = simple.MeshElements(
                Input=cube, TrustFaceOrientation=trusted, WriteUndefinedMask=1, WorstOfCells=1
            )
            quality = simple.ElementQuality(
                Input=cube, TrustFaceOrientation=trusted, Criteria=["MinFacePyramidVolume"]
            )
            quality.UpdatePipeline()
            faces = self.information(elements, 0)
            (value, _) = self.range_of(faces, "FacePyramidVolume")
            self.assertAlmostEqual(value, sign / 6)
            self.assertEqual(
                self.range_of(quality.GetDataInformation(), "MinFacePyramidVolume")[0], value
            )
            self.assertEqual(self.range_of(faces, "FacePyramidVolume_Undefined"), (0.0, 0.0))
            self.assertEqual(self.range_of(faces, "NonOrthogonality_Undefined"), (1.0, 1.0))
            self.assertIsNone(
                faces.GetCellDataInformation().GetArrayInformation("OwnerCell_Undefined")
            )
            self.assertEqual(
                self.range_of(self.information(elements, 1), "EdgeLength_Undefined"), (0.0, 0.0)
            )
        # Where an edge as long as half of the cube has no length, no face has an area.
        flat = simple.MeshElements(
            Input=cube, DegeneracyTolerance=0.6, FaceArrays=["FaceSkewness"], WriteUndefinedMask=1
        )
        self.assertEqual(
            self.range_of(self.information(flat, 0), "FaceSkewness_Undefined"), (2.0, 2.0)
        )

    def test_polygon_criteria_of_faces(self):
        mesh = simple.OpenDataFile(str(EXAMPLES / "flange.visf"))
        elements = simple.MeshElements(Input=mesh, FaceArrays=["OwnerCell"])
        quality = simple.ElementQuality(
            Input=OutputPort(elements, 0), Criteria=["Area", "MaxWarpage"]
        )
        information = self.information(quality, 0)
        self.assertGreater(self.range_of(information, "Area")[0], 0.0)
        self.assertIsNone(
            information.GetCellDataInformation().GetArrayInformation("NonOrthogonality")
        )

    def known_arrays(self):
        """Names of the arrays in the tables, by element type."""
        known = {"Face": [], "Edge": [], "Vertex": []}
        for row in tables.fetch(simple.CriteriaTable(), 3):
            if row["Name"] not in known[row["Element"]]:
                known[row["Element"]].append(row["Name"])
        return known

    @unittest.skipIf(camaron_testing.rank_count() > 1, "the table is on the first rank")
    def test_lists_agree(self):
        """The properties offer the arrays of the tables, and the documentation has a row for each."""
        page = (camaron_testing.ROOT / "Documentation" / "elements.md").read_text("utf-8")
        sections = re.split(r"^## .*$", page, flags=re.MULTILINE)[1:]
        elements = simple.MeshElements(Input=simple.Wavelet())
        for (kind, names), section in zip(self.known_arrays().items(), sections):
            self.assertEqual(elements.GetProperty(f"{kind}Arrays").Available, names)
            documented = re.findall(r"^\| (?:\*\*)?`(\w+)`", section, re.MULTILINE)
            self.assertEqual(list(dict.fromkeys(documented)), names)
        for row in tables.fetch(simple.CriteriaTable(), 3):
            name = f"**`{row['Name']}`**" if row["IsDefault"] else f"`{row['Name']}`"
            unit = row["Unit"] or "(?:-|length[²³]?)"
            start = re.escape(f"| {name} | {row['Cells']} | ")
            end = re.escape(f" | {row['Description']} |")
            self.assertRegex(page, start + unit + end)

    @unittest.skipIf(camaron_testing.rank_count() > 1, "the table is on the first rank")
    def test_registry(self):
        """Arrays are described as criteria are; ranges are those of cells, and only for faces."""
        cells = tables.known_criteria()
        rows = tables.fetch(simple.CriteriaTable(), 3)
        found = {(row["Element"], row["Name"]): row for row in rows}
        self.assertEqual({row["Label"] for row in rows} & {""}, set())
        for name, like in (
            ("NonOrthogonality", "MaxNonOrthogonality"),
            ("FaceWeight", "MinFaceWeight"),
        ):
            row = found["Face", name]
            limits = [row["AcceptableLow"], row["AcceptableHigh"]]
            self.assertEqual(
                [limit if math.isfinite(limit) else None for limit in limits],
                cells[like]["acceptable"],
            )
            self.assertEqual(row["Better"].lower(), cells[like]["better"])
            self.assertEqual(row["Ideal"], cells[like]["ideal"])
            self.assertEqual(row["AcceptableSource"], cells[like]["acceptable_source"])
        self.assertEqual(found["Edge", "NonOrthogonality"]["AcceptableHigh"], math.inf)
        self.assertEqual(found["Edge", "EdgeMinDihedralAngle"]["Better"], "Bigger")
        self.assertEqual(found["Edge", "NonManifoldEdge"]["Ideal"], 0)

    def inner_sums(self, mesh, port, name):
        """Sums of angles around edges (port 1) or points (port 2) that are not at the boundary."""
        elements = simple.MeshElements(
            Input=mesh,
            EdgeArrays=["IsBoundary", name],
            VertexArrays=["IsBoundary", "UnusedPoint", name],
        )
        data = self.fetch(elements, port).GetCellData()
        inner = vtk_to_numpy(data.GetArray("IsBoundary")) == 0
        if port == 2:
            inner &= vtk_to_numpy(data.GetArray("UnusedPoint")) == 0
        sums = vtk_to_numpy(data.GetArray(name))[inner]
        self.assertGreater(sums.size, 100)
        return sums[~numpy.isnan(sums)]

    def assert_angles_around(self, mesh):
        """Around every inner edge there are 360 degrees, around every inner point 4 pi."""
        self.assertLess(abs(self.inner_sums(mesh, 1, "EdgeAngleSum") / 360 - 1).max(), 1e-6)
        sums = self.inner_sums(mesh, 2, "VertexAngleSum")
        self.assertLess(abs(sums / (4 * math.pi) - 1).max(), 1e-10)

    @unittest.skipIf(camaron_testing.rank_count() > 1, "the whole mesh is looked at on one rank")
    def test_angles_around_inner_elements(self):
        self.assert_angles_around(self.open(EXAMPLES / "voronoi-ball.visf"))
        for path in self.real("tetgen/camaron_gen4096.1.node"):
            self.assert_angles_around(self.open(path))

    @unittest.skipIf(camaron_testing.rank_count() > 1, "the whole mesh is looked at on one rank")
    def test_angles_around_warped_polyhedra(self):
        """Full spheres even if faces are warped; an inverted cell at a vertex makes it two spheres."""
        points, cubes = gallery.lattice(7, 6, 6)
        sides = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
        cells = [(VTK_POLYHEDRON, [[cube[i] for i in side] for side in sides]) for cube in cubes]
        meshes = [mesh_parts.producer(gallery.make_grid(points, cells))]
        for path in self.real("ansys_fluent/fluent_mixer_poly_bin.cas"):
            meshes.append(simple.FluentMeshReader(FileNames=[str(path)]))
        for mesh in meshes:
            spheres = self.inner_sums(mesh, 2, "VertexAngleSum") / (4 * math.pi)
            self.assertLess(abs(spheres - spheres.round()).max(), 1e-10)
            self.assertGreater((spheres.round() == 1).mean(), 0.999)

    def test_empty_lists(self):
        """No arrays where none are wanted, also as an argument, which ParaView takes for one that was never set."""
        elements = simple.MeshElements(
            Input=simple.Wavelet(), FaceArrays=[], EdgeArrays=[], VertexArrays=[]
        )
        elements.UpdatePipeline()
        for port in range(3):
            data = OutputPort(elements, port).CellData
            self.assertLessEqual(set(data.keys()), {"vtkGhostType", "GlobalFaceIds"}, port)

    def test_defaults_of_proxy(self):
        """What the XML ticks are the defaults of the tables."""
        elements = simple.MeshElements(Input=simple.Wavelet())
        rows = tables.fetch(simple.CriteriaTable(), 3)
        for kind in ("Face", "Edge", "Vertex"):
            names = elements.SMProxy.GetProperty(f"{kind}Arrays")
            names.ResetToXMLDefaults()
            ticked = [names.GetElement(i) for i in range(0, names.GetNumberOfElements(), 2)]
            wanted = [row["Name"] for row in rows if row["Element"] == kind and row["IsDefault"]]
            self.assertEqual(ticked, list(dict.fromkeys(wanted)))


if __name__ == "__main__":
    camaron_testing.main()
