# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fluent files in HDF5 in ParaView: opening, boundaries, real files, on any number of ranks."""

import gzip
import re
import shutil
import unittest

import camaron_testing
import gallery
import numpy
from camaron.common import pipeline, reader_choice
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_WEDGE, vtkUnstructuredGrid

SEEDS = camaron_testing.ROOT / "Readers" / "FluentHDF5" / "Testing" / "Seeds"
OURS = "ANSYSFluentHDF5Reader"

#: Of the collected files: cells, points, Fluent's faces of boundaries by zone, volume or area.
REAL = {
    "simple-duct.msh.h5": (10, 44, {"symm": 40, "inlet": 1, "outflow": 1}, 9.99999904),
    "elbow.msh.h5": (17822, 66407, {"wall-elbow": 2168, "outlet": 155}, 152.59932454750225),
    "mixing_elbow.cas.h5": (17822, 66417, {"wall-elbow": 2168}, 0.0025006550793729397),
    "nozzle-2D.cas.h5": (
        4190,
        4324,
        {"inlet": 48, "outlet": 48, "walls": 178},
        0.08541859435337315,
    ),
}


def blocks_of(source):
    """The blocks of the second output, by name."""
    blocks = servermanager.Fetch(source, idx=1)
    names = [blocks.GetMetaData(i).Get(blocks.NAME()) for i in range(blocks.GetNumberOfBlocks())]
    return {name: blocks.GetBlock(i) for i, name in enumerate(names)}


def enclosed(blocks):
    """The volume, or area, enclosed by boundaries that are oriented outward.

    A polygon consists of triangles from the mean of its points, as in the table of the collected files.
    """
    total = 0.0
    for surface in blocks.values():
        if surface.GetNumberOfCells() == 0:
            continue
        points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
        lines = surface.GetNumberOfLines() > 0
        cells = surface.GetLines() if lines else surface.GetPolys()
        offsets = vtk_to_numpy(cells.GetOffsetsArray())
        ids = vtk_to_numpy(cells.GetConnectivityArray())
        for begin, end in zip(offsets[:-1], offsets[1:]):
            corners = points[ids[begin:end]]
            if lines:  # with the mesh on the left
                total += numpy.cross(corners[0], corners[1])[2] / 2
                continue
            middle = corners.mean(axis=0)
            after = numpy.roll(corners, -1, axis=0)
            total += numpy.einsum("i,ji->", middle, numpy.cross(corners, after)) / 6
    return total


def values_of(source):
    """The chosen fields of cells of all ranks, by Fluent's ids."""
    found = {}
    for grid in camaron_testing.pieces(source):
        cells = grid.GetCellData()
        arrays = [cells.GetArray(i) for i in range(cells.GetNumberOfArrays())]
        arrays = [array for array in arrays if array.GetName().startswith("SV_")]
        ids = cells.GetArray("GlobalCellIds")
        for cell in range(grid.GetNumberOfCells()):
            values = {array.GetName(): array.GetTuple(cell) for array in arrays}
            found[(ids.GetValue(cell) if ids else cell) + 1] = values
    return found


def cells_of(source):
    """Center, zone and type of the cells of all ranks, sorted."""
    found = []
    for grid in camaron_testing.pieces(source):
        zones, ghosts = grid.GetCellData().GetArray("Zone"), grid.GetCellGhostArray()
        for cell in range(grid.GetNumberOfCells()):
            if ghosts is None or ghosts.GetValue(cell) == 0:
                bounds = [round(x, 9) for x in grid.GetCell(cell).GetBounds()]
                found.append((bounds, zones.GetValue(cell), grid.GetCellType(cell)))
    return sorted(found)


def large(kind):
    """Hexahedra, or also wedges, with enough points and faces that ranks load parts of them."""
    points, cubes = gallery.lattice(24, 24, 26)
    halves = ((0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7))
    cells = []
    for i, cube in enumerate(cubes):
        if kind == "wedges" and i % 5 == 0:
            cells += [(VTK_WEDGE, [cube[j] for j in half]) for half in halves]
        else:
            cells.append((VTK_HEXAHEDRON, cube))
    return gallery.make_grid(points, cells)


def describe(grid):
    """Everything about a piece: its points, cells and arrays."""
    cells = grid.GetCells()
    arrays = {"points": grid.GetPoints().GetData(), "types": grid.GetCellTypesArray()}
    arrays.update(offsets=cells.GetOffsetsArray(), nodes=cells.GetConnectivityArray())
    for data in (grid.GetPointData(), grid.GetCellData()):
        for i in range(data.GetNumberOfArrays()):
            arrays[data.GetArrayName(i)] = data.GetArray(i)
    return {name: vtk_to_numpy(array) for name, array in arrays.items()}


#: Reads a mesh on ranks, of which the second has another file, or aborts. Prints cells and errors of each.
FAULTS = """
import sys
from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController
rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
mesh = simple.ANSYSFluentHDF5Reader(FileNames=[sys.argv[2 if rank == 1 else 1]])
reader = mesh.GetClientSideObject()
if rank == 1 and sys.argv[3] == "abort":
    reader = reader.GetReader() if hasattr(reader, "GetReader") else reader
    reader.AddObserver("ProgressEvent", lambda source, event: source.SetAbortExecuteAndUpdateTime()
        if hasattr(source, "SetAbortExecuteAndUpdateTime") else source.SetAbortExecute(1))
mesh.UpdatePipeline()
print("rank", rank, "has", mesh.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells(), flush=True)
"""


class TestFluentHDF5(camaron_testing.FormatTestCase):
    def test_seeds(self):
        """The seeds are the same meshes as those in text, so their counts are known, on any number of ranks."""
        counts = {"cells": 5, "polyhedra": 5, "plane": 4, "hanging": 5, "surface": 21}
        for path in sorted(SEEDS.glob("[!b]*.h5")):
            with self.subTest(path.name):
                mesh = self.open(path)
                self.assertEqual(mesh.GetXMLName(), OURS)
                self.assertEqual(self.cells(mesh), counts[path.name.split(".")[0]])

    def test_real_files(self):
        """Counts, boundaries and volumes are those that were worked out from the files in another way."""
        for path in self.real("fluent_h5/*.h5"):
            cells, points, zones, measure = REAL[path.name]
            with self.subTest(path.name):
                mesh = self.open(path)
                self.assertEqual(mesh.GetXMLName(), OURS)
                self.assertEqual(self.cells(mesh), cells)
                if "2D" not in path.name:
                    quality = simple.ElementQuality(Input=mesh, Criteria=["Volume"])
                    quality.UpdatePipeline()
                    information = quality.GetDataInformation().GetCellDataInformation()
                    volumes = information.GetArrayInformation("Volume").GetComponentRange(0)
                    self.assertGreater(volumes[0], 0)
                if camaron_testing.rank_count() > 1:
                    continue  # they share points
                self.assertEqual(mesh.GetDataInformation().GetNumberOfPoints(), points)
                blocks = blocks_of(mesh)
                for zone, faces in zones.items():
                    self.assertEqual(blocks[zone].GetNumberOfCells(), faces)
                self.assertAlmostEqual(enclosed(blocks) / measure, 1, 12)

    def test_large(self):
        """Ranks, which load parts of the faces and points and exchange them, have the same pieces as of a mesh in text."""
        for kind in ("hexahedra", "wedges"):
            grid = large(kind)
            sources = [self.open(self.save(f"{kind}{end}", grid)) for end in (".msh.h5", ".msh")]
            pieces, others = map(camaron_testing.pieces, sources)
            self.assertEqual(len(pieces), camaron_testing.rank_count())
            for piece, other in zip(map(describe, pieces), map(describe, others)):
                self.assertEqual(piece.keys(), other.keys())
                for name, values in piece.items():
                    self.assertTrue(numpy.array_equal(values, other[name]), (kind, name))

    @unittest.skipIf(camaron_testing.rank_count() > 1, "starts ranks")
    def test_fault_of_one_rank(self):
        """If one rank has a damaged file, has another one or is aborted, no rank waits for it, and none has a mesh."""
        script = self.make("faults.py", FAULTS)
        good = self.save("good.msh.h5", large("hexahedra"))
        content = good.read_bytes()
        files = {"good": content, "cut": content[: len(content) // 2], "none": b"other"}
        files["small"] = (SEEDS / "cells.msh.h5").read_bytes()
        half = len(content) // 2  # within the compressed faces
        files["damaged"] = content[:half] + bytes(64) + content[half + 64 :]
        for name, data in files.items():
            other = self.folder / f"{name}.other.msh.h5"
            other.write_bytes(data)
            how = "abort" if name == "good" else "read"
            run = camaron_testing.run_ranks(
                3,
                *("pvbatch", "--symmetric", script, good, other, how),
                env=camaron_testing.environment_alone(),
                timeout=60,
            )
            found = sorted(re.findall(r"rank (\d) has (\d+)", run.stdout))
            self.assertEqual(found, [("0", "0"), ("1", "0"), ("2", "0")], (name, run.stderr))
            self.assertEqual(name == "good", "ERR" not in run.stderr, run.stderr)

    def test_choice(self):
        """Ours comes first, by content, and ParaView's reader remains; also under a name of text."""
        factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
        factory.UpdateAvailableReaders()
        path = self.folder / "mesh.cas.h5"
        shutil.copy(SEEDS / "polyhedra.cas.h5", path)
        session = servermanager.ActiveConnection.Session
        found = factory.GetReaders(str(path), session)
        names = [found.GetString(i) for i in range(1, found.GetNumberOfStrings(), 3)]
        self.assertIn(OURS, names)
        if hasattr(simple, "FluentCFFCaseReader"):
            self.assertIn("FLUENTCFFReader", names)
            self.assertLess(names.index(OURS), names.index("FLUENTCFFReader"))
        notes = []
        self.assertEqual(reader_choice.make_reader(path, notes).GetXMLName(), OURS)
        self.assertEqual(notes, [])
        shutil.copy(path, self.folder / "mesh.cas")
        source = reader_choice.make_reader(self.folder / "mesh.cas", notes)
        self.assertEqual(source.GetXMLName(), OURS)
        self.assertEqual(notes, [f"This is a Fluent mesh in HDF5; {OURS} reads it."])

    def test_other_content(self):
        """HDF5 of another program, and what is not HDF5, are not taken."""
        path = self.folder / "other.cas.h5"
        for content in (
            b"",
            b"(0 text)",
            b"\x89HDF\r\n\x1a\n",
            b"\x89HDF\r\n\x1a\n" + 3000 * b"\0",
        ):
            path.write_bytes(content)
            session = servermanager.ActiveConnection.Session
            can = servermanager.vtkSMReaderFactory.CanReadFile(str(path), "sources", OURS, session)
            self.assertFalse(can)

    @unittest.skipIf(camaron_testing.rank_count() > 1, "ParaView's reader does not divide meshes")
    def test_paraview_reads_it(self):
        """ParaView's own reader finds the cells in what is written, named as a case."""
        if not hasattr(simple, "FluentCFFCaseReader"):
            self.skipTest("this ParaView has none")
        for seed in ("cells.msh.h5", "polyhedra.cas.h5"):
            mesh = self.open(SEEDS / seed)
            both = simple.GroupDatasets(Input=[mesh, simple.OutputPort(mesh, 1)])
            simple.SaveData(str(self.folder / "case.h5"), both)
            (self.folder / "case.h5").rename(self.folder / "mesh.cas.h5")
            peer = simple.FluentCFFCaseReader(FileName=str(self.folder / "mesh.cas.h5"))
            peer.UpdatePipeline()
            self.assertEqual(peer.GetDataInformation().GetNumberOfCells(), 5)
            simple.Delete(peer)

    def test_series(self):
        """Several files are time steps, of both outputs."""
        paths = []
        for i in range(2):
            paths.append(str(self.folder / f"step{i}.msh.h5"))
            shutil.copy(SEEDS / ("cells.msh.h5" if i == 0 else "hanging.msh.h5"), paths[-1])
        mesh = simple.ANSYSFluentHDF5Reader(FileNames=paths)
        self.assertEqual(list(mesh.TimestepValues), [0, 1])
        mesh.UpdatePipeline(1)
        points = mesh.GetDataInformation().GetNumberOfPoints()
        mesh.UpdatePipeline(0)
        self.assertNotEqual(points, mesh.GetDataInformation().GetNumberOfPoints())

    def test_fields(self):
        """Fields of the data file are listed and off; chosen ones have the values of their cells on any number of ranks."""
        names = ["SV_P", "SV_T", "SV_VOF-phase_1", "SV_Y"]
        shutil.copy(SEEDS / "polyhedra.cas.h5", self.folder / "mesh.cas.h5")
        shutil.copy(SEEDS.parent / "polyhedra.dat.h5", self.folder / "mesh.dat.h5")
        mesh = self.open(self.folder / "mesh.cas.h5")
        self.assertEqual(list(mesh.CellArrays.Available), names)
        self.assertEqual(list(mesh.CellArrays), [])
        self.assertEqual(set(map(len, values_of(mesh).values())), {0})
        mesh.CellArrays = names
        mesh.UpdatePipeline()
        found = values_of(mesh)
        self.assertEqual(sorted(found), [1, 2, 3, 4, 5])
        for cell, values in found.items():
            self.assertEqual(values["SV_P"], (100 + cell,))
            self.assertEqual(values["SV_VOF-phase_1"], (-cell,))
            self.assertEqual(values["SV_Y"], (100 + cell, 0.5 + cell))
            expected = 0.5 + cell if 2 <= cell <= 4 else numpy.nan
            numpy.testing.assert_equal(values["SV_T"], (expected,))
        mesh.CellArrays = []
        mesh.UpdatePipeline()
        self.assertEqual(set(map(len, values_of(mesh).values())), {0})

    def test_compressed_fields(self):
        """A compressed data file beside a case, compressed or not, is found; one that is not compressed comes first."""
        names = ["SV_P", "SV_T", "SV_VOF-phase_1", "SV_Y"]
        data = SEEDS.parent / "polyhedra.dat.h5"
        for name in ("a.cas.h5", "b.cas.h5.gz"):
            case = self.folder / name
            content = (SEEDS / "polyhedra.cas.h5").read_bytes()
            case.write_bytes(gzip.compress(content) if case.suffix == ".gz" else content)
            beside = self.folder / f"{name[0]}.dat.h5.gz"
            beside.write_bytes(gzip.compress(data.read_bytes()))
            mesh = self.open(case)
            self.assertEqual(list(mesh.CellArrays.Available), names)
            self.assertEqual(list(mesh.CellArrays), [])
            mesh.CellArrays = ["SV_P"]
            mesh.UpdatePipeline()
            self.assertEqual(values_of(mesh)[3], {"SV_P": (103,)})
            beside.write_bytes(b"damaged")
            shutil.copy(data, beside.with_suffix(""))
            mesh = self.open(case)
            self.assertEqual(list(mesh.CellArrays.Available), names)

    def test_options(self):
        """A data file that is chosen by the options of a command is listed, and its fields are off unless some are chosen."""
        shutil.copy(SEEDS / "polyhedra.cas.h5", self.folder / "mesh.cas.h5")
        data = str(SEEDS.parent / "polyhedra.dat.h5")
        for chosen, found in (
            ({}, set()),
            ({"CellArrays": "SV_P,SV_T"}, {"SV_P", "SV_T"}),
            ({"CellArrays": "all"}, {"SV_P", "SV_T", "SV_VOF-phase_1", "SV_Y"}),
            ({"CellArrays": "none"}, set()),
        ):
            options = {"DataFile": data, **chosen}
            mesh = pipeline.open_mesh(self.folder / "mesh.cas.h5", reader=options).source
            self.assertEqual(len(mesh.CellArrays.Available), 4)
            self.assertEqual(set(mesh.CellArrays), found, chosen)
            self.assertEqual(set(values_of(mesh)[3]), found, chosen)

    def test_fields_of_steps(self):
        """Each time step has its own data file, unless one is chosen for all; a step without one has a warning."""
        paths = []
        for i in range(2):
            paths.append(str(self.folder / f"step{i}.cas.h5"))
            shutil.copy(SEEDS / "polyhedra.cas.h5", paths[-1])
        data = SEEDS.parent / "polyhedra.dat.h5"
        shutil.copy(data, self.folder / "step0.dat.h5")
        mesh = simple.ANSYSFluentHDF5Reader(FileNames=paths, CellArrays=["SV_P"])
        for time, warned in ((0, 0), (1, 1)):
            with pipeline.Messages() as messages:
                mesh.UpdatePipeline(time)
            self.assertEqual(messages.errors, [])
            first = pipeline.is_first_rank()
            self.assertEqual(len(messages.warnings), warned if first else 0)
            self.assertEqual({len(values) for values in values_of(mesh).values()}, {1 - warned})
        mesh.DataFile = str(data)
        mesh.UpdatePipeline(1)
        self.assertEqual(values_of(mesh)[3], {"SV_P": (103,)})

    def test_zones(self):
        """Cells of zones that are switched off are left out, with the points that only they have; the others are as before."""
        two = large("wedges")
        number = two.GetNumberOfCells()
        zones = numpy_to_vtk(numpy.where(numpy.arange(number) % 1000 < 300, 2, 5), deep=True)
        zones.SetName("Zone")
        two.GetCellData().AddArray(zones)
        files = [SEEDS / "cells.msh.h5", SEEDS / "polyhedra.cas.h5", self.save("two.msh.h5", two)]
        for path in files:
            mesh = self.open(path)
            names = list(mesh.Zones.Available)
            self.assertEqual(len(names), 3)
            self.assertEqual(list(mesh.Zones), names)
            whole = cells_of(mesh)
            for off, left in ((names[0], 5), (names[1], 2)):
                with self.subTest(path.name, off=off):
                    mesh.Zones = [name for name in names if name != off]
                    mesh.UpdatePipeline()
                    self.assertEqual(cells_of(mesh), [cell for cell in whole if cell[1] == left])
                    for piece in filter(vtkUnstructuredGrid.GetCells, camaron_testing.pieces(mesh)):
                        ids = vtk_to_numpy(piece.GetCells().GetConnectivityArray())
                        self.assertEqual(len(set(ids)), piece.GetNumberOfPoints())
            mesh.Zones = names
            mesh.UpdatePipeline()
            self.assertEqual(cells_of(mesh), whole)

    def test_zones_of_steps(self):
        """Zones that are chosen are so in all time steps; one that a step does not have is named in a warning."""
        paths = []
        for i, name in enumerate(("cells", "hanging", "plane")):
            paths.append(str(self.folder / f"step{i}.msh.h5"))
            shutil.copy(next(SEEDS.glob(f"{name}.*")), paths[-1])
        mesh = simple.ANSYSFluentHDF5Reader(FileNames=paths)
        mesh.UpdatePipeline(0)
        for zones, time, cells, words in (
            (["zone-5"], 0, 3, ""),
            (["zone-5"], 1, 0, "step1.msh.h5: expected at least one chosen zone"),
            (["water", "zone-5"], 1, 5, "step1.msh.h5: there is no zone 'zone-5'"),
        ):
            mesh.Zones = zones
            with pipeline.Messages() as messages:
                mesh.UpdatePipeline(time)
            self.assertEqual(self.cells(mesh), cells)
            if pipeline.is_first_rank():
                self.assertIn(words, "\n".join(messages.warnings + messages.errors))
        mesh.Zones = ["water"]
        for time, cells in ((0, 2), (1, 5), (2, 4)):
            mesh.UpdatePipeline(time)
            mesh.UpdatePipelineInformation()
            self.assertEqual(self.cells(mesh), cells)
            self.assertIn("water", mesh.Zones.Available)

    def test_no_zone(self):
        """Without a zone of cells nothing is read, with an error; without boundaries there are all cells."""
        mesh = self.open(SEEDS / "cells.msh.h5")
        self.assertEqual(list(mesh.Zones), ["water", "zone-5", "skin"])
        boundaries = mesh.SMProxy.GetOutputPort(1)
        self.assertGreater(boundaries.GetDataInformation().GetNumberOfCells(), 0)
        mesh.Zones = ["water", "zone-5"]
        mesh.UpdatePipeline()
        self.assertEqual(self.cells(mesh), 5)
        self.assertEqual(boundaries.GetDataInformation().GetNumberOfCells(), 0)
        mesh.Zones = ["skin"]
        with pipeline.Messages() as messages:
            mesh.UpdatePipeline()
        self.assertEqual(self.cells(mesh), 0)
        if pipeline.is_first_rank():
            self.assertEqual(len(messages.errors), 1)
            expected = "cells.msh.h5: expected at least one chosen zone of cells, found none"
            self.assertIn(expected, messages.errors[0])

    def test_zones_and_fields(self):
        """Cells keep the values of their fields if zones before them are left out; the choice is in a state."""
        shutil.copy(SEEDS / "polyhedra.cas.h5", self.folder / "mesh.cas.h5")
        shutil.copy(SEEDS.parent / "polyhedra.dat.h5", self.folder / "mesh.dat.h5")
        mesh = pipeline.open_mesh(
            self.folder / "mesh.cas.h5", reader={"Zones": "zone-5,skin", "CellArrays": "SV_P"}
        ).source
        for grid in camaron_testing.pieces(mesh):
            values = grid.GetCellData().GetArray("SV_P")
            ids = grid.GetCellData().GetArray("OriginalCellId")
            for cell in range(grid.GetNumberOfCells()):
                self.assertEqual(values.GetValue(cell), 100 + ids.GetValue(cell))
        self.assertEqual(self.cells(mesh), 3)
        state = str(self.folder / "state.pvsm")
        simple.SaveState(state)
        simple.ResetSession()
        simple.LoadState(state)
        (mesh,) = [s for s in simple.GetSources().values() if s.GetXMLName() == OURS]
        self.assertEqual(list(mesh.Zones), ["zone-5", "skin"])
        self.assertEqual(self.cells(mesh), 3)


if __name__ == "__main__":
    camaron_testing.main()
