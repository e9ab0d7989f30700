# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Element Quality gives every cell the same bits however the mesh is split.

The reference is a single process on the undivided mesh. What would break without: cells at the border of
a piece would count as cells at the boundary, ghosts would count, means would be those of a piece.
"""

import csv
import gc
import os
import pickle
import shutil
import sys
from pathlib import Path

import camaron_testing
import numpy
import rank_meshes
from camaron.common import pipeline
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

#: All that look beyond the cell itself, and one that does not.
CRITERIA = [
    "Volume",
    "RelativeSize",
    "MinNeighborNormalAngle",
    "MaxNeighborNormalAngle",
    "MinSurfaceDihedralAngle",
    "MaxSurfaceDihedralAngle",
    "MaxNonOrthogonality",
    "MaxBoundaryNonOrthogonality",
    "MinNonOrthogonality",
    "MinBoundaryNonOrthogonality",
    "MaxFaceSkewness",
    "MinFaceSkewness",
    "MaxFaceWeight",
    "MaxVolumeRatio",
    "MaxFaceCellCount",
    "MinFaceWeight",
    "MinVolumeRatio",
    "CellVolumeRatio",
    "OrthogonalQuality",
    "CellDeterminant",
    "IsBoundary",
    "RegionId",
    "PointRegionCount",
    "DuplicateCell",
    "VerdictRelativeSizeSquared",
    "VerdictShapeAndSize",
    "VerdictShearAndSize",
]
MISSING_GHOSTS = 5


def evaluate(source, **properties):
    return simple.ElementQuality(
        Input=source, Criteria=CRITERIA, WriteUndefinedMask=1, **properties
    )


def values_of(data_of_ranks):
    """By criterion, the bits and the reasons of all cells that are no ghosts, in the order of cells."""
    parts = []
    for leaf in (leaf for data in data_of_ranks for leaf in camaron_testing.leaves(data)):
        cells = leaf.GetCellData()
        if leaf.GetNumberOfCells() == 0:
            continue
        arrays = {"Number": vtk_to_numpy(cells.GetArray("Number"))}
        for name in CRITERIA:
            arrays[name] = vtk_to_numpy(cells.GetArray(name)).view(numpy.int64)
            arrays[name + "_Undefined"] = vtk_to_numpy(cells.GetArray(name + "_Undefined"))
        ghosts = cells.GetArray("vtkGhostType")
        own = (
            numpy.ones(leaf.GetNumberOfCells(), bool)
            if ghosts is None
            else vtk_to_numpy(ghosts) == 0
        )
        parts.append({name: values[own] for name, values in arrays.items()})
    joined = {name: numpy.concatenate([part[name] for part in parts]) for name in parts[0]}
    order = numpy.argsort(joined["Number"], kind="stable")
    result = {name: values[order] for name, values in joined.items()}
    # Without global ids, numbers of cells and the order of regions are those of the pieces.
    _, first, regions = numpy.unique(result["RegionId"], return_index=True, return_inverse=True)
    result["RegionId"] = first[regions]
    result["DuplicateCell"] = result["DuplicateCell"].view(float) >= 0
    return result


def colors_of(data_of_ranks):
    """The names of the arrays that are offered as the color, of all blocks and ranks with cells."""
    leaves = [leaf for data in data_of_ranks for leaf in camaron_testing.leaves(data)]
    return {leaf.GetCellData().GetScalars().GetName() for leaf in leaves if leaf.GetNumberOfCells()}


def surface_of(source):
    """Of every polygon of the surface the number of the cell behind it, sorted, from all ranks."""
    surface = simple.MeshSurface(Input=source)
    parts = [
        vtk_to_numpy(leaf.GetCellData().GetArray("Number"))
        for data in camaron_testing.pieces(surface)
        for leaf in camaron_testing.leaves(data)
        if leaf.GetNumberOfCells()
    ]
    return numpy.sort(numpy.concatenate(parts)).tolist()


def statistics_of(quality, folder):
    """The rows of the table of statistics as text."""
    names = [
        name for name in CRITERIA if name not in ("RegionId", "DuplicateCell")
    ]  # ids of pieces
    statistics = simple.QualityStatistics(Input=quality, Arrays=names)
    path = folder / "statistics.csv"
    simple.SaveData(str(path), proxy=statistics, Precision=17)
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        for name in [n for n in row if n.startswith("Arg") or n in ("IdSpace", "MinId", "MaxId")]:
            del row[name]  # places depend on global ids
    return rows


def save_reference(folder):
    reference, surfaces, colors = {}, {}, {}
    for mesh in rank_meshes.MESHES:
        quality = evaluate(rank_meshes.split_source(mesh))
        data = camaron_testing.pieces(quality)
        reference[mesh] = values_of(data), statistics_of(quality, folder)
        colors[mesh] = colors_of(data)
        surfaces[mesh] = surface_of(quality)
    quality = evaluate(rank_meshes.block_source("tetrahedra"))
    data = camaron_testing.pieces(quality)
    reference["blocks"] = values_of(data), None
    colors["blocks"] = colors_of(data)
    surfaces["blocks"] = surface_of(quality)
    (folder / "reference").write_bytes(pickle.dumps((reference, surfaces, colors)))


class TestQualityRanks(camaron_testing.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = Path(camaron_testing.tempfile.mkdtemp(prefix="camaron-test-"))
        camaron_testing.run_alone(__file__, folder, timeout=250)
        cls.reference, cls.surfaces, cls.colors = pickle.loads((folder / "reference").read_bytes())
        shutil.rmtree(folder)
        gc.freeze()  # else Fetch looks through all of it every time

    def check(self, reference, source, text, with_statistics=False, before=None, **properties):
        expected, rows = self.reference[reference]
        quality = evaluate(source, **properties)
        if before:
            quality.Criteria = before
            quality.UpdatePipeline()
            quality.Criteria = CRITERIA
        with pipeline.Messages() as messages:  # VTK's reader warns of empty units
            data = camaron_testing.pieces(quality)
        found = values_of(data)
        self.assertEqual(messages.errors, [])
        self.assertEqual(colors_of(data), self.colors[reference], text)
        for name, values in expected.items():
            wrong = numpy.flatnonzero(found[name] != values)
            self.assertEqual(
                wrong.tolist(),
                [],
                f"{name} of {reference}, {text}: {found[name][wrong[:5]]} {values[wrong[:5]]}",
            )
        if rows is not None and with_statistics:
            self.assertEqual(statistics_of(quality, self.folder), rows, text)
        simple.Delete(quality)
        simple.Delete(source)

    def test_reference(self):
        """The reference has values of all criteria, and nothing is missing."""
        count = lambda mesh, name, reason: int(
            (self.reference[mesh][0][name + "_Undefined"] == reason).sum()
        )
        for mesh in rank_meshes.MESHES:
            for name in CRITERIA:
                self.assertEqual(count(mesh, name, MISSING_GHOSTS), 0)
        for mesh in ("voronoi", "tetrahedra", "mixed"):
            self.assertGreater(count(mesh, "MaxNonOrthogonality", 0), 100)
            self.assertGreater(count(mesh, "RelativeSize", 0), 100)
        groups = lambda mesh: self.reference[mesh][0]["PointRegionCount"].view(float)
        self.assertGreater((groups("tetrahedra") == 1).sum(), 100)
        self.assertGreater((groups("sparse") > 1).sum(), 100)
        self.assertGreater(count("surfaces", "MaxSurfaceDihedralAngle", 0), 100)
        self.assertGreater(count("surfaces", "MaxSurfaceDihedralAngle", 3), 100)
        self.assertGreater(count("surfaces", "MaxNeighborNormalAngle", 0), 100)

    def test_pieces(self):
        """Neither ghosts nor ids: neighbors are found by their points."""
        for mesh in rank_meshes.MESHES:
            with_statistics = mesh in ("voronoi", "surfaces")
            self.check(mesh, rank_meshes.split_source(mesh), "pieces", with_statistics)

    def test_duplicates_keep_their_numbers(self):
        """Without global ids cells are known by their numbers in the whole mesh, if pieces are ranges of it."""
        _, cells = rank_meshes.MESHES["overlapping"]()
        numbers = {}
        for number, cell in enumerate(cells):
            numbers.setdefault(frozenset(rank_meshes.points_of(cell)), []).append(number)
        expected = [numbers[frozenset(rank_meshes.points_of(cell))] for cell in cells]
        expected = [alike[0] if len(alike) > 1 else -1 for alike in expected]
        for ghosts in (False, True):
            found = {}
            for data in camaron_testing.pieces(
                evaluate(rank_meshes.split_source("overlapping", ghosts=ghosts))
            ):
                own = camaron_testing.own_cells(data)
                cells = data.GetCellData()
                arrays = [
                    vtk_to_numpy(cells.GetArray(name)) for name in ("Number", "DuplicateCell")
                ]
                found.update(zip(arrays[0][own].tolist(), arrays[1][own].tolist()))
            self.assertEqual([found[i] for i in range(len(expected))], expected, ghosts)

    def test_scattered(self):
        """Cells anywhere, so that almost every face is a border."""
        for mesh in ("voronoi", "sparse", "overlapping", "surfaces"):
            self.check(mesh, rank_meshes.split_source(mesh, scattered=True), "scattered")

    def test_ghosts(self):
        """One layer of ghosts in the input, which must neither count nor count twice."""
        for mesh, scattered in (
            ("voronoi", False),
            ("overlapping", False),
            ("tetrahedra", True),
            ("surfaces", True),
        ):
            source = rank_meshes.split_source(mesh, ghosts=True, scattered=scattered)
            self.check(mesh, source, "ghosts", with_statistics=not scattered)

    def test_global_ids(self):
        for mesh, ghosts in (("voronoi", False), ("surfaces", True), ("tetrahedra", False)):
            source = rank_meshes.split_source(mesh, ghosts=ghosts, global_ids=True)
            self.check(mesh, source, f"ids, ghosts {ghosts}")

    def test_appended(self):
        """Several pieces in one data set: points of their borders are there more than once, with ghosts cells, too."""
        for mesh, ghosts in (
            ("voronoi", False),
            ("surfaces", False),
            ("voronoi", True),
            ("surfaces", True),
        ):
            source = rank_meshes.split_source(
                mesh, ghosts=ghosts, global_ids=True, scattered=True, appended=3
            )
            self.check(mesh, source, f"appended, ghosts {ghosts}")

    def test_global_ids_decide(self):
        """Points at the same place with different ids are not the same: the pieces only touch."""
        found = {}
        for broken in (False, True):
            source = rank_meshes.split_source("tetrahedra", global_ids=True, broken_ids=broken)
            with pipeline.Messages():
                found[broken] = values_of(camaron_testing.pieces(evaluate(source)))[
                    "CellDeterminant"
                ]
        changed = int((found[False] != found[True]).sum())
        self.assertEqual(changed > 0, camaron_testing.rank_count() > 1)

    def test_empty_rank(self):
        for mesh in ("voronoi", "surfaces"):
            self.check(mesh, rank_meshes.split_source(mesh, empty_rank=True), "empty rank")

    def test_one_after_the_other(self):
        """Criteria that are known are the same ones on all ranks, also where there are no cells."""
        source = rank_meshes.split_source("voronoi", empty_rank=True)
        self.check("voronoi", source, "one after the other", before=CRITERIA[::2])

    def test_blocks(self):
        """Faces between blocks are a boundary, those between the pieces of a block are not."""
        for parts, global_ids in ((1, True), (3, False)):
            source = rank_meshes.block_source("tetrahedra", parts=parts, global_ids=global_ids)
            self.check("blocks", source, f"{parts} parts, ids {global_ids}")

    def test_connected_blocks(self):
        """Connected blocks are the same as the undivided mesh; rank 1 lacks one of them."""
        for mesh, parts, global_ids in (
            ("tetrahedra", 1, True),
            ("voronoi", 2, False),
            ("surfaces", 2, True),
        ):
            source = rank_meshes.block_source(mesh, parts=parts, global_ids=global_ids)
            self.check(mesh, source, "connected blocks", ConnectBlocks=1)

    def test_mixed_precision(self):
        """Neighbors find each other where one has points in single precision and the other in double.

        The points of the polyhedra are single anyway, so that nothing changes but what is too small to
        count, unless that is given; those of the tetrahedra are rounded, and values with them.
        """
        made = {
            "pieces": (rank_meshes.split_source, {}),
            "scattered": (rank_meshes.split_source, {"scattered": True}),
            "blocks": (rank_meshes.block_source, {"parts": 2}),
        }
        for text, (make, options) in made.items():
            properties = {"ConnectBlocks": 1} if text == "blocks" else {}
            source = make("voronoi", mixed_precision=True, **options)
            tolerance = {"DegeneracyTolerance": 1e-12}  # the default of double precision
            self.check("voronoi", source, f"mixed precision, {text}", **properties, **tolerance)
            expected, _ = self.reference["tetrahedra"]
            source = make("tetrahedra", mixed_precision=True, **options)
            found = values_of(camaron_testing.pieces(evaluate(source, **properties)))
            for name in CRITERIA:
                reasons = found[name + "_Undefined"]
                numpy.testing.assert_array_equal(
                    reasons, expected[name + "_Undefined"], f"{name}, {text}"
                )
                if name not in ("RegionId", "DuplicateCell"):
                    values, others = (
                        of[name].view(float)[reasons == 0] for of in (found, expected)
                    )
                    rounding = (
                        1e-4 if name.endswith("NonOrthogonality") else 1e-5
                    )  # degrees of small angles
                    numpy.testing.assert_allclose(
                        values, others, rtol=1e-4, atol=rounding, err_msg=name
                    )

    def test_blocks_differ(self):
        """The option changes something, and only at cells between blocks."""
        connected, apart = self.reference["tetrahedra"][0], self.reference["blocks"][0]
        for name in ("MaxNonOrthogonality", "MaxFaceSkewness", "CellDeterminant"):
            changed = int((connected[name] != apart[name]).sum())
            self.assertTrue(0 < changed < len(connected[name]) // 2, f"{name}: {changed}")
        self.assertTrue((connected["RelativeSize"] == apart["RelativeSize"]).all())

    def test_surface(self):
        """Mesh Surface shows no border of a piece."""
        for mesh, options in (
            ("voronoi", {"ghosts": True}),
            ("mixed", {"empty_rank": True}),
            ("overlapping", {"scattered": True}),
        ):
            found = surface_of(rank_meshes.split_source(mesh, **options))
            self.assertEqual(found, self.surfaces[mesh], f"{mesh} {options}")
        for parts in (1, 3):
            found = surface_of(rank_meshes.block_source("tetrahedra", parts=parts))
            self.assertEqual(found, self.surfaces["blocks"], f"{parts} parts")
        self.assertLess(len(self.surfaces["tetrahedra"]), len(self.surfaces["blocks"]))

    def test_ghosts_stay(self):
        """The output has the cells of the input, ghosts included, and makes none of its own."""
        for ghosts in (False, True):
            source = rank_meshes.split_source("voronoi", ghosts=ghosts)
            quality = simple.ElementQuality(Input=source, Criteria=["MaxFaceSkewness"])
            quality.UpdatePipeline()
            source.UpdatePipeline()
            self.assertEqual(
                quality.GetDataInformation().GetNumberOfCells(),
                source.GetDataInformation().GetNumberOfCells(),
            )
        # A source that would make some if it were asked.
        quality = simple.ElementQuality(Input=simple.Wavelet(), Criteria=["MaxFaceSkewness"])
        quality.UpdatePipeline()
        self.assertEqual(quality.GetDataInformation().GetNumberOfCells(), 20**3)
        self.assertNotIn("vtkGhostType", quality.CellData.keys())


if __name__ == "__main__":
    if len(sys.argv) > 1:
        save_reference(Path(sys.argv[1]))
        os._exit(0)
    camaron_testing.main()
