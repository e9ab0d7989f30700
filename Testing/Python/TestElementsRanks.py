# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mesh Elements gives every face, edge and vertex once, with the same bits, however the mesh is split.

The reference is a single process on the undivided mesh. What would break without: faces at the border of a piece
would lie at the boundary, edges and vertices there would lack the cells of other pieces, and all of them would count
twice or not at all.
"""

import gc
import math
import os
import pickle
import shutil
import sys
from pathlib import Path

import camaron_testing
import numpy
import rank_meshes
from camaron.common import pipeline
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

ARRAYS = {
    "Face": [
        "OwnerCell",
        "NeighborCell",
        "FaceCellCount",
        "IsBoundary",
        "NonOrthogonality",
        "BoundaryNonOrthogonality",
        "FaceSkewness",
        "FaceWeight",
        "VolumeRatio",
        "FacePyramidVolume",
        "FaceTwist",
        "FaceFlatness",
        "Warpage",
        "FaceConcavity",
    ],
    "Edge": [
        "EdgeLength",
        "EdgeCellCount",
        "EdgeFaceCount",
        "IsBoundary",
        "EdgeDihedralAngle",
        "BoundaryEdge",
        "NonManifoldEdge",
        "InconsistentEdge",
        "EdgeMinDihedralAngle",
        "EdgeMaxDihedralAngle",
        "EdgeAngleSum",
        "NonOrthogonality",
        "BoundaryNonOrthogonality",
        "FaceSkewness",
        "FaceWeight",
        "VolumeRatio",
        "FacePyramidVolume",
    ],
    "Vertex": [
        "VertexCellCount",
        "VertexFaceCount",
        "VertexEdgeCount",
        "IsBoundary",
        "UnusedPoint",
        "PointRegionCount",
        "VertexAngleSum",
    ],
}
PORTS = list(ARRAYS)
#: Ids of cells, which the numbers of cells in the whole mesh follow from.
CELL_IDS = ("OwnerCell", "NeighborCell")
#: A mesh read from a file, whose points are in the same order on any number of ranks.
FILE = camaron_testing.EXAMPLES / "flange.visf"
SOLID = ("voronoi", "tetrahedra", "mixed", "overlapping")


def take_elements(source, **options):
    quality = simple.ElementQuality(Input=source, Criteria=["EdgeRatio"])
    properties = {f"{kind}Arrays": names for kind, names in ARRAYS.items()}
    return simple.MeshElements(Input=quality, WorstOfCells=1, **properties, **options)


def take_coincident(source):
    """Coincident elements; the tolerance separates some groups of three and more points."""
    return simple.MeshElements(
        Input=source,
        FaceArrays=["FaceMismatch"],
        EdgeArrays=["EdgeCellCount"],
        VertexArrays=["DuplicatePoint"],
        MergeTolerance=1e-6,
    )


def elements_of(leaf, global_ids):
    """Of the elements of a data set that are no ghosts: a list of their points, and values as bits by name."""
    cells = leaf.GetCellData()
    own = numpy.ones(leaf.GetNumberOfCells(), bool)
    ids = cells.GetGlobalIds()
    columns = {}
    for i in range(cells.GetNumberOfArrays()):
        name, values = cells.GetArrayName(i), vtk_to_numpy(cells.GetArray(i))
        if cells.GetArray(i) == ids:
            continue
        if name == "vtkGhostType":
            own = values == 0
        elif name in CELL_IDS and global_ids:
            columns[name] = numpy.where(values < 0, values, (values - 50) // 2)
        else:
            columns[name] = values.view(numpy.int64) if values.dtype == float else values
    columns["Id"] = vtk_to_numpy(ids) if ids else numpy.arange(leaf.GetNumberOfCells())
    points = [tuple(point) for point in vtk_to_numpy(leaf.GetPoints().GetData()).tolist()]
    lists = [lists for lists in (leaf.GetVerts(), leaf.GetLines(), leaf.GetPolys())]
    lists = next(entry for entry in lists if entry.GetNumberOfCells())
    ends = vtk_to_numpy(lists.GetOffsetsArray()).tolist()
    ids = vtk_to_numpy(lists.GetConnectivityArray()).tolist()
    chosen = numpy.flatnonzero(own)
    places = [sorted(points[p] for p in ids[ends[i] : ends[i + 1]]) for i in chosen.tolist()]
    return places, {name: values[chosen].astype(numpy.int64) for name, values in columns.items()}


def fetch_elements(source, global_ids=False):
    """Faces, edges and vertices of all ranks in the order of their points, then of their values."""
    found = []
    for port in range(3):
        parts = [
            elements_of(leaf, global_ids)
            for piece in camaron_testing.pieces(source, port)
            for leaf in camaron_testing.leaves(piece)
            if leaf.GetNumberOfCells()
        ]
        places = [place for part in parts for place in part[0]]
        names = list(parts[0][1])
        columns = [numpy.concatenate([part[1][name] for part in parts]) for name in names]
        rows = numpy.stack(columns, axis=1).tolist()
        order = sorted(range(len(places)), key=lambda i: (places[i], rows[i]))
        columns = {name: values[order] for name, values in zip(names, columns)}
        found.append(([places[i] for i in order], columns))
    return found


def save_reference(folder):
    reference = {
        mesh: fetch_elements(take_elements(rank_meshes.split_source(mesh)))
        for mesh in rank_meshes.MESHES
    }
    reference["file"] = fetch_elements(take_elements(simple.OpenDataFile(str(FILE))))
    reference["blocks"] = fetch_elements(take_elements(rank_meshes.block_source("tetrahedra")))
    for mesh in rank_meshes.LOOSE:
        source = rank_meshes.split_source(mesh, global_ids=True)
        reference[mesh] = fetch_elements(take_coincident(source))
    (folder / "reference").write_bytes(pickle.dumps(reference))


class TestElementsRanks(camaron_testing.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = Path(camaron_testing.tempfile.mkdtemp(prefix="camaron-test-"))
        camaron_testing.run_alone(__file__, folder, timeout=250)
        cls.reference = pickle.loads((folder / "reference").read_bytes())
        shutil.rmtree(folder)
        gc.freeze()  # else Fetch looks through all of it every time

    def check(self, reference, source, text, global_ids=False, same_order=True, **options):
        """Compares all values; if cells come in another order, reals up to rounding and no ids of cells."""
        elements = take_elements(source, **options)
        with pipeline.Messages() as messages:
            found = fetch_elements(elements, global_ids)
        self.assertEqual(messages.errors, [])
        for kind, own, expected in zip(PORTS, found, self.reference[reference]):
            where = f"{kind} of {reference}, {text}"
            self.assertEqual(len(own[0]), len(expected[0]), where)
            self.assertTrue(own[0] == expected[0], where)
            self.assertEqual(own[1].keys(), expected[1].keys(), where)
            for name, values in expected[1].items():
                if name == "Id" and not (same_order and kind == "Face" or reference == "file"):
                    continue
                wrong = numpy.flatnonzero(own[1][name] != values)
                if not same_order:
                    if (
                        name == "EdgeDihedralAngle"
                    ):  # where polygons disagree, the first one says on which side
                        wrong = wrong[expected[1]["InconsistentEdge"][wrong] == 0]
                    a, b = own[1][name][wrong].view(float), values[wrong].view(float)
                    near = abs(a - b) < 1e-11 * numpy.maximum(1, abs(b))
                    wrong = wrong[~near] if name not in CELL_IDS else wrong[:0]
                self.assertEqual(
                    wrong.tolist()[:5],
                    [],
                    f"{len(wrong)} {name} of {where}: {own[1][name][wrong[:5]]} {values[wrong[:5]]}",
                )
        simple.Delete(elements)
        simple.Delete(source)

    def values(self, mesh, kind, name):
        return self.reference[mesh][PORTS.index(kind)][1][name]

    def test_reference(self):
        """The reference has elements of all types, and its angles add up inside the mesh."""
        for mesh in SOLID:
            self.assertGreater(self.values(mesh, "Face", "IsBoundary").sum(), 10, mesh)
            self.assertGreater((self.values(mesh, "Face", "FaceCellCount") == 2).sum(), 100, mesh)
        self.assertGreater(self.values("overlapping", "Face", "FaceCellCount").max(), 2)
        self.assertGreater(self.values("surfaces", "Edge", "InconsistentEdge").sum(), 2)
        self.assertGreater(self.values("surfaces", "Edge", "NonManifoldEdge").sum(), 2)
        for kind, name, full in (
            ("Edge", "EdgeAngleSum", 360),
            ("Vertex", "VertexAngleSum", 4 * math.pi),
        ):
            for mesh in ("voronoi", "tetrahedra"):
                inner = self.values(mesh, kind, "IsBoundary") == 0
                sums = self.values(mesh, kind, name)[inner].view(float)
                self.assertGreater(sums.size, 10, mesh)
                # Rounded coordinates at both ends of very short edges turn faces.
                self.assertLess(abs(sums / full - 1).max(), 1e-6, mesh)

    def test_pieces(self):
        """Neither ghosts nor ids: cells are found by the places of their points."""
        for mesh in rank_meshes.MESHES:
            self.check(mesh, rank_meshes.split_source(mesh), "pieces")

    def test_file(self):
        """Faces, edges and vertices have the numbers of the undivided mesh as their global ids."""
        self.check("file", simple.OpenDataFile(str(FILE)), "pieces in space")

    def test_ghosts(self):
        """One layer of ghosts in the input, which must neither count nor count twice."""
        for mesh in ("tetrahedra", "surfaces"):
            self.check(mesh, rank_meshes.split_source(mesh, ghosts=True), "ghosts")

    def test_global_ids(self):
        """Cells in any order, so that almost every element is at a border of pieces; ids decide which piece owns it."""
        for mesh, ghosts in (("voronoi", False), ("overlapping", True), ("surfaces", False)):
            source = rank_meshes.split_source(mesh, ghosts=ghosts, global_ids=True, scattered=True)
            self.check(mesh, source, f"ids, ghosts {ghosts}", global_ids=True)

    def test_appended(self):
        """Several pieces in one data set: points of their borders are there more than once, with ghosts cells, too."""
        meshes = (
            ("voronoi", False),
            ("mixed", False),
            ("surfaces", False),
            ("voronoi", True),
            ("mixed", True),
        )
        for mesh, ghosts in meshes:
            source = rank_meshes.split_source(
                mesh, ghosts=ghosts, global_ids=True, scattered=True, appended=3
            )
            self.check(mesh, source, f"appended, ghosts {ghosts}", global_ids=True)

    def test_scattered(self):
        """Without ids, faces may have the other orientation, and cells other numbers."""
        for mesh, ghosts in (("mixed", False), ("tetrahedra", True), ("surfaces", False)):
            source = rank_meshes.split_source(mesh, ghosts=ghosts, scattered=True)
            self.check(mesh, source, "scattered", same_order=False)

    def test_empty_rank(self):
        for mesh in ("mixed", "surfaces"):
            self.check(mesh, rank_meshes.split_source(mesh, empty_rank=True), "empty rank")

    def test_stray_points(self):
        """A point that a piece has for none of its cells is a vertex once, where others have cells at it."""
        source = rank_meshes.source("make_stray", "vtkUnstructuredGrid")
        vertices = simple.OutputPort(
            simple.MeshElements(Input=source, VertexArrays=["UnusedPoint"]), 2
        )
        statistics = simple.QualityStatistics(Input=vertices, Arrays=["UnusedPoint"])
        table = servermanager.Fetch(statistics, idx=0)
        self.assertEqual(table.GetValueByName(0, "Count").ToInt(), 5)
        self.assertEqual(table.GetValueByName(0, "Max").ToDouble(), 0)

    def test_blocks(self):
        """Faces between blocks are a boundary, those between the pieces of a block are not."""
        for parts in (1, 3):
            source = rank_meshes.block_source("tetrahedra", parts=parts)
            self.check("blocks", source, f"{parts} parts")

    def test_connected_blocks(self):
        """Blocks that are connected are pieces of one mesh, numbered block after block."""
        for mesh, parts, global_ids in (
            ("tetrahedra", 1, False),
            ("mixed", 2, False),
            ("voronoi", 2, True),
            ("surfaces", 1, False),
        ):
            source = rank_meshes.block_source(mesh, parts=parts, global_ids=global_ids)
            text = f"connected, {parts} parts, ids {global_ids}"
            self.check(mesh, source, text, global_ids=global_ids, ConnectBlocks=1)

    def check_coincident(self, mesh, source, text, global_ids):
        elements = take_coincident(source)
        found = fetch_elements(elements)
        for kind, own, expected in zip(PORTS, found, self.reference[mesh]):
            self.assertTrue(own[0] == expected[0], f"{kind} of {mesh}, {text}")
            for name, values in expected[1].items():
                if name == "DuplicatePoint" and not global_ids:
                    numpy.testing.assert_array_equal(own[1][name] >= 0, values >= 0, text)
                elif name != "Id":
                    numpy.testing.assert_array_equal(own[1][name], values, f"{name}, {text}")
        simple.Delete(elements)
        simple.Delete(source)

    def test_coincident(self):
        """Points and faces that lie in one place are found, also where they are in different pieces."""
        duplicates = self.values("torn", "Vertex", "DuplicatePoint")
        self.assertGreater((duplicates < 0).sum(), 10)
        self.assertGreater((duplicates >= 0).sum(), 100)
        mismatches = self.values("torn", "Face", "FaceMismatch")
        self.assertGreater(mismatches.sum(), 10)
        self.assertGreater((mismatches == 0).sum(), 50)
        cells = 4 * 3 * 3
        inner = 3 * cells - (4 * 3 + 4 * 3 + 3 * 3)
        self.assertEqual(self.values("doubled", "Face", "FaceMismatch").sum(), 2 * inner)
        for mesh in rank_meshes.LOOSE:
            for options in (
                {"global_ids": True},
                {"global_ids": True, "scattered": True},
                {"global_ids": True, "scattered": True, "ghosts": True},
                {"global_ids": True, "empty_rank": True},
                {"scattered": True},
                {"ghosts": True},
            ):
                has_ids = "global_ids" in options
                if has_ids or mesh == "torn":
                    source = rank_meshes.split_source(mesh, **options)
                    self.check_coincident(mesh, source, str(options), has_ids)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        save_reference(Path(sys.argv[1]))
        os._exit(0)
    camaron_testing.main()
