# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Decks of Mechanical APDL in ParaView: opening, options, saving, on any number of ranks."""

import unittest
from collections import Counter

import camaron_testing
import gallery
import numpy
from camaron.common import pipeline
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

#: Nodes, points that stand for missing nodes, elements and components, as other programs count them.
COLLECTED = {
    "acp_minimal_plate.cdb": (18, 0, 27, 9),
    "acp_solid_mesh.cdb": (567, 0, 384, 24),
    "archive_ErnoRadiation.cdb": (65, 0, 36, 3),
    "archive_HexBeam.cdb": (321, 0, 40, 4),
    "archive_Panel_Transient.dat": (1265, 0, 336 + 2, 5),  # 2 by commands with parameters
    "archive_TetBeam.cdb": (1041, 0, 3913, 0),
    "archive_all_solid_cells.cdb": (52, 0, 4, 0),
    "archive_etblock.cdb": (4, 0, 1, 0),
    "archive_hypermesh.cdb": (105, 0, 80, 0),
    "archive_mixed_missing_midside.cdb": (584, 23, 287, 0),
    "archive_sector.cdb": (655, 0, 105, 1),
    "archive_workbench_193.cdb": (3, 0, 0, 0),
    "dev_mixed_blocked_Dexp.cdb": (331, 0, 240, 1),
    "dev_mixed_unblocked.cdb": (331, 0, 240, 1),
    "prime_hex.cdb": (343, 0, 216, 0),
}
#: Of these, some whose nodes are all there.
WHOLE = ("acp_minimal_plate.cdb", "archive_sector.cdb", "archive_HexBeam.cdb")
#: Types of cells with a volume.
SOLID = [10, 12, 13, 14, 24, 25, 26, 27]
#: Corners, and between which of them the mid-side nodes are, by the documentation of VTK.
QUADRATIC = {
    22: (3, "01 12 20"),
    23: (4, "01 12 23 30"),
    24: (4, "01 12 20 03 13 23"),
    25: (8, "01 12 23 30 45 56 67 74 04 15 26 37"),
    26: (6, "01 12 20 34 45 53 03 14 25"),
    27: (5, "01 12 23 30 04 14 24 34"),
}

DECK = """/prep7
et,1,185
et,2,154
et,3,matrix27
n,1 $ n,2,1 $ n,3,1,1 $ n,4,,1
n,5,,,1 $ n,6,1,,1 $ n,7,1,1,1 $ n,8,,1,1
e,1,2,3,4,5,6,7,8
type,2
e,1,2,3,4
type,3
e,7,8
cmblock,bottom,node,2
(8i10)
         1        -4
"""


class TestMAPDL(camaron_testing.FormatTestCase):
    def deck(self, text=DECK, name="small.cdb"):
        path = self.folder / name
        path.write_text(text)
        return path

    def numbers(self, source):
        """Numbers of points and cells, without ghosts."""
        owned = simple.RemoveGhostInformation(Input=source)
        owned.UpdatePipeline()
        information = owned.GetDataInformation()
        return information.GetNumberOfPoints(), information.GetNumberOfCells()

    def components(self, source):
        field = self.fetch(source).GetFieldData()
        arrays = [field.GetAbstractArray(name) for name in ("NodeComponents", "ElementComponents")]
        return sum(array.GetNumberOfValues() for array in arrays if array)

    def meshes(self):
        """Path, points, elements and components of decks of our own and of the collected ones."""
        found = [(self.deck(), 8, 2, 1)]
        for make in (
            lambda: gallery.mixed(4),
            gallery.tetrahedra,
            gallery.quads,
            gallery.quadratic_mixed,
        ):
            grid = make()
            path = self.save(f"mesh{len(found)}.cdb", grid)
            found.append((path, grid.GetNumberOfPoints(), grid.GetNumberOfCells(), 0))
        for name, (nodes, extra, elements, components) in COLLECTED.items():
            found += [
                (path, nodes + extra, elements, components)
                for path in self.real(f"ansys_cdb/{name}")
            ]
        return found

    def test_counts(self):
        """Counts are those written, or those that other programs find, on any number of ranks."""
        for path, nodes, elements, components in self.meshes():
            source = self.open(path)
            points, cells = self.numbers(source)
            self.assertEqual(cells, elements, path.name)
            self.assertEqual(self.components(source), components, path.name)
            if camaron_testing.rank_count() == 1:  # else ranks share points
                self.assertEqual(points, nodes, path.name)

    def test_cells_are_good(self):
        """No cell is inverted; mid-side nodes are near the middles of their edges."""
        middles = Counter()
        for path, _, elements, _ in self.meshes():
            quality = simple.ElementQuality(Input=self.open(path), Criteria=["Volume"])
            for grid in camaron_testing.pieces(quality) if elements else []:
                if grid.GetNumberOfCells():
                    self.check_cells(grid, middles, path.name)
        solid = {kind for kind in QUADRATIC if kind in SOLID}
        self.assertEqual(set(middles), set(QUADRATIC) if camaron_testing.DATA else solid)
        self.assertGreater(sum(middles.values()), 1000 if camaron_testing.DATA else 50)

    def check_cells(self, grid, middles, name):
        """Adds to the numbers of mid-side nodes by type of cell."""
        types = vtk_to_numpy(grid.GetCellTypesArray())
        volumes = vtk_to_numpy(grid.GetCellData().GetArray("Volume"))[numpy.isin(types, SOLID)]
        self.assertTrue((volumes > 0).all(), name)
        points = vtk_to_numpy(grid.GetPoints().GetData())
        offsets = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
        connectivity = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
        for kind in set(QUADRATIC) & set(types.tolist()):
            corners, edges = QUADRATIC[kind]
            begins = offsets[:-1][types == kind]
            for i, edge in enumerate(edges.split()):
                a, b, middle = (
                    points[connectivity[begins + node]]
                    for node in (int(edge[0]), int(edge[1]), corners + i)
                )
                away = numpy.linalg.norm(middle - (a + b) / 2, axis=1)
                self.assertTrue((away < 0.1 * numpy.linalg.norm(a - b, axis=1)).all(), name)
                middles[kind] += len(begins)

    def test_options(self):
        """Properties of the reader reach the file's reader."""
        source = self.open(self.deck())
        self.assertEqual((source.Linear, source.SurfaceEffects), (0, 1))
        self.assertEqual(self.numbers(source)[1], 2)
        source.SurfaceEffects = 0
        self.assertEqual(self.numbers(source)[1], 1)
        grid = gallery.quadratic_mixed()
        decks = [(self.save("quadratic.cdb", grid), {10, 12, 13, 14}, grid.GetNumberOfPoints())]
        decks += [(path, {12}, 321) for path in self.real("ansys_cdb/archive_HexBeam.cdb")]
        for path, types, points in decks:
            source = self.open(path)
            source.Linear = 1
            parts = camaron_testing.pieces(source)
            found = [
                vtk_to_numpy(part.GetCellTypesArray()) for part in parts if part.GetNumberOfCells()
            ]
            self.assertEqual(set(numpy.concatenate(found).tolist()), types)
            if len(parts) == 1:  # else ranks share points
                self.assertEqual(parts[0].GetNumberOfPoints(), points)

    def test_chosen_by_content(self):
        """Other programs use these extensions, too, and some of ParaView's readers accept any file."""
        for name in ("a.cdb", "b.dat", "c.inp"):
            source = pipeline.open_mesh(self.deck(name=name)).source
            self.assertEqual(self.numbers(source)[1], 2, name)
        abaqus = self.deck("*HEADING\n*NODE\n1, 0., 0., 0.\n*ELEMENT, TYPE=C3D4\n", "abaqus.inp")
        with pipeline.Messages() as messages:
            source = simple.MAPDLReader(FileNames=[str(abaqus)])
            source.UpdatePipeline()
        self.assertEqual(source.GetDataInformation().GetNumberOfCells(), 0)
        self.assertTrue(any("Mechanical APDL" in text for text in messages.errors), messages.errors)

    def test_damaged_file(self):
        """The error gives the position; the output is empty."""
        damaged = self.deck(DECK.replace("        -4", "        x4"), "damaged.cdb")
        line = DECK[: DECK.index("        -4")].count("\n") + 1
        files = [
            (damaged, line),
            *((path, 143) for path in self.real("malformed/cdb_corrupt_a.cdb")),
        ]
        for path, line in files:
            with pipeline.Messages() as messages:
                source = simple.MAPDLReader(FileNames=[str(path)])
                source.UpdatePipeline()
            self.assertEqual(source.GetDataInformation().GetNumberOfPoints(), 0)
            self.assertTrue(
                any(f"{path.name}:{line}" in text for text in messages.errors), messages.errors
            )

    def test_several_files_are_time_steps(self):
        names = [str(self.deck(DECK + "n,9,9\n" * i, f"step{i}.cdb")) for i in range(2)]
        source = simple.MAPDLReader(FileNames=names)
        self.assertEqual(list(source.TimestepValues), [0, 1])
        for time, points in enumerate((8, 9)):
            source.UpdatePipeline(time)
            if camaron_testing.rank_count() == 1:
                self.assertEqual(source.GetDataInformation().GetNumberOfPoints(), points)

    def test_saving_keeps_all(self):
        """One file from all ranks; nodes, elements, attributes and components are those of the deck."""
        for path in [
            path for path, *_ in self.meshes() if path.name in WHOLE or path.parent == self.folder
        ]:
            source = self.open(path)
            saved = self.folder / f"saved-{path.name}"
            simple.SaveData(str(saved), source, Digits=17)
            again = self.open(saved)
            self.assertEqual(self.components(again), self.components(source))
            elements = self.describe(source)
            self.assertEqual(len(elements), self.numbers(source)[1])
            self.assertEqual(self.describe(again), elements, path.name)

    def describe(self, source):
        """Every element by its number: its type, its nodes with their places, all its arrays."""
        elements = {}
        for grid in camaron_testing.pieces(source):
            if grid.GetNumberOfCells():
                elements.update(self.describe_part(grid))
        return elements

    def describe_part(self, grid):
        cells, points = grid.GetCellData(), grid.GetPointData()

        def values(data, i):
            names = sorted(data.GetArrayName(a) for a in range(data.GetNumberOfArrays()))
            return [
                (name, data.GetArray(name).GetTuple1(i))
                for name in names
                if not name.startswith("Global") and name != "vtkGhostType"
            ]

        ghosts = cells.GetArray("vtkGhostType")
        elements = {}
        for cell in range(grid.GetNumberOfCells()):
            if ghosts and ghosts.GetValue(cell):
                continue
            nodes = [
                grid.GetCell(cell).GetPointId(i)
                for i in range(grid.GetCell(cell).GetNumberOfPoints())
            ]
            elements[cells.GetArray("ElementId").GetValue(cell)] = (
                grid.GetCellType(cell),
                [(grid.GetPoint(node), values(points, node)) for node in nodes],
                values(cells, cell),
            )
        return elements

    @unittest.skipIf(camaron_testing.rank_count() > 1, "compares with one rank")
    def test_ids_can_be_counted(self):
        source = self.open(self.deck(DECK + "n,700\nen,900,1,2,3,4\n"))
        for original, expected in ((1, 700), (0, 9)):
            path = self.folder / f"ids{original}.cdb"
            simple.SaveData(str(path), source, OriginalIds=original)
            ids = vtk_to_numpy(self.fetch(self.open(path)).GetPointData().GetArray("NodeId"))
            self.assertEqual(ids.max(), expected)


if __name__ == "__main__":
    camaron_testing.main()
