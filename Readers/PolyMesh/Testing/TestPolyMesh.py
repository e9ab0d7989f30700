# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""OpenFOAM meshes as ParaView's reader and OpenFOAM's checkMesh see them, on any number of ranks."""

import re
import shutil
import subprocess
import unittest

import camaron_testing
import gallery
import numpy
import openfoam_case
from camaron import convert
from camaron.common import pipeline
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

#: All ways to write the files.
ENCODINGS = (
    {"Encoding": "ASCII"},
    {"Encoding": "ASCII", "Compress": 1},
    {"Encoding": "Binary"},
    {"Encoding": "Binary", "LabelSize": "64 bit"},
    {"Encoding": "Binary", "Compress": 1},
)
MESHES = {
    "mixed": lambda: gallery.mixed(3),
    "polyhedra": gallery.polyhedra,
    "tetrahedra": gallery.tetrahedra,
}
#: Cells and faces at the boundary of files of other programs, by zone.
REAL = {
    "fluent_mixer_poly_bin.cas": (
        13935,
        {"outlet": 241, "inlet-hot": 241, "inlet-cold": 243, "wall": 1378},
    ),
    "foam_rotateSphere_3d_hex_ascii.msh": (1664, {"surface": 384}),
    "prime_hex_bin.msh": (216, {"WALL_SOLID": 216}),
}
#: Two tetrahedra with a zone each, and a boundary of three zones.
FLUENT = """(2 3)
(10 (0 1 5 0 3))(12 (0 1 2 0))(13 (0 1 7 0))
(10 (1 1 5 1 3)(
0 0 0 1 0 0 0 1 0 0 0 1 1 1 1
))
(12 (2 1 1 1 2))(12 (3 2 2 1 2))
(13 (4 1 1 2 3)(
2 4 3 1 2
))
(13 (5 2 4 3 3)(
1 2 3 1 0
1 3 4 1 0
1 4 2 1 0
))
(13 (6 5 6 7 3)(
2 4 5 2 0
2 5 3 2 0
))
(13 (7 7 7 c 3)(
3 5 4 2 0
))
(45 (2 fluid water)())(45 (3 solid steel)())(45 (4 interior inside)())
(45 (5 wall side)())(45 (6 symmetry middle)())(45 (7 periodic turn)())
"""

#: The same in double precision far from the origin, with zones of faces between three cells and all that OpenFOAM has no type for.
ZONES = """(2 3)
(10 (0 1 6 0 3))(12 (0 1 3 0))(13 (0 1 a 0))
(10 (1 1 6 1 3)(
1000000.1 0 0 1000001.2 0 0 1000000.1 1.3 0
1000000.1 0 1.7 1000001.3 1.1 1.9 1000002.123456789 1.1 3.3
))
(12 (2 1 1 1 2))(12 (3 2 3 1 2))
(13 (4 1 1 2 3)(
2 4 3 1 2
))
(13 (8 2 2 2 3)(
3 4 5 2 3
))
(13 (5 3 5 a 3)(
1 2 3 1 0
1 3 4 1 0
1 4 2 1 0
))
(13 (6 6 7 14 3)(
2 4 5 2 0
2 5 3 2 0
))
(13 (7 8 a 24 3)(
3 6 5 3 0
3 4 6 3 0
4 5 6 3 0
))
(45 (2 fluid water)())(45 (3 solid steel)())(45 (4 interior inside)())(45 (8 interior between)())
(45 (5 velocity-inlet inflow)())(45 (6 mass-flow-inlet more)())(45 (7 outflow outflow)())
"""


def read_list(path):
    """The numbers of each line of a list in text."""
    body = path.read_text().split("}\n", 1)[1]
    rows = body[body.index("(") + 1 : body.rindex(")")].strip().splitlines()
    return [[float(n) for n in re.findall(r"[-+.e0-9]+", row)] for row in rows]


def read_cells(folder):
    """The faces of each cell, as sorted tuples of points, from the files in text."""
    mesh = folder / "constant" / "polyMesh"
    faces = [tuple(sorted(map(int, row[1:]))) for row in read_list(mesh / "faces")]
    owners = [int(row[0]) for row in read_list(mesh / "owner")]
    neighbors = [int(row[0]) for row in read_list(mesh / "neighbour")]
    cells = [[] for _ in range(max(owners) + 1)]
    for cell, face in [*zip(owners, faces), *zip(neighbors, faces)]:
        cells[cell].append(face)
    return [sorted(cell) for cell in cells]


def cells_of(grid):
    """The same of a grid."""
    return [
        sorted(tuple(sorted(face)) for face in gallery.faces(grid, cell))
        for cell in range(grid.GetNumberOfCells())
    ]


class TestPolyMesh(camaron_testing.FormatTestCase):
    def case(self, source, name, **options):
        folder = self.folder / name
        folder.mkdir()
        with pipeline.Messages() as messages:
            simple.SaveData(str(folder / "case.foam"), source, **options)
        self.assertEqual(messages.errors, [])
        return folder

    def read(self, folder):
        """By ParaView's reader, all cells as they are in the files."""
        source = simple.OpenFOAMReader(FileName=str(folder / "case.foam"))
        source.MeshRegions = ["internalMesh"]
        for name in source.ListProperties():
            if "decompose" in name.lower():
                setattr(source, name, 0)
        return source

    def patches(self, folder):
        """Faces and type of every patch."""
        text = (folder / "constant/polyMesh/boundary").read_text()
        found = re.findall(r"(\S+)\s*\{\s*type\s+(\w+);[^}]*nFaces\s+(\d+);", text)
        return {name: (int(count), kind) for name, kind, count in found if name != "FoamFile"}

    def test_ranks(self):
        """The case of any number of ranks has the points and cells of the mesh, in its order."""
        for name, make in MESHES.items():
            grid = make()
            source = self.open(self.save(f"{name}.ply", grid, WriteCells=1))
            folder = self.case(source, name)
            mesh = folder / "constant" / "polyMesh"
            if mesh.exists():  # each rank has its own folder, the first writes
                points = numpy.array(read_list(mesh / "points"))
                self.assertTrue(numpy.array_equal(points, gallery.points_of(grid)), name)
                self.assertEqual(read_cells(folder), cells_of(grid), name)

    @unittest.skipIf(camaron_testing.rank_count() > 1, "compares whole meshes")
    def test_encodings(self):
        """In every encoding, ParaView reads the same points and cells; checkMesh finds no fault."""
        for name, make in MESHES.items():
            grid = make()
            source = self.open(self.save(f"{name}.ply", grid, WriteCells=1))
            for i, options in enumerate(ENCODINGS):
                folder = self.case(source, f"{name}{i}", **options)
                if "64" in options.get("LabelSize", ""):
                    continue  # neither ParaView by default nor Debian's OpenFOAM reads them
                found = self.fetch(simple.MergeBlocks(Input=self.read(folder)))
                numpy.testing.assert_allclose(
                    gallery.points_of(found), gallery.points_of(grid), rtol=1e-6
                )
                self.assertEqual(cells_of(found), cells_of(grid), (name, options))
                self.check_topology(folder)

    def check_topology(self, folder, cells=None):
        """checkMesh finds no error in topology, and no inverted cell, if it is installed."""
        if not openfoam_case.PROGRAM:
            return
        openfoam_case.write_settings(folder)
        run = subprocess.run(
            openfoam_case.check_mesh(folder, "-allTopology"),
            capture_output=True,
            text=True,
            timeout=120,
            env=openfoam_case.environment(),
        )
        for line in (
            "Cell to face addressing OK.",
            "Point usage OK.",
            "Upper triangular ordering OK.",
            "Face vertices OK.",
            "Topological cell zip-up check OK.",
            "Face-face connectivity OK.",
            "Cell volumes OK.",
            "Face pyramids OK.",
        ):
            self.assertIn(line, run.stdout, run.stderr)
        if cells:
            self.assertRegex(run.stdout, rf"cells: +{cells}\n")

    @unittest.skipIf(camaron_testing.rank_count() > 1, "runs the command")
    def test_convert(self):
        """A folder as target becomes a case, with both outputs of the reader; an existing mesh stays."""
        source = self.make("in.msh", FLUENT)
        target = self.folder / "new"
        notes = convert(source, f"{target}/", scale=0.001)
        self.assertTrue(any("periodic zones turn become plain patches" in n for n in notes), notes)
        self.assertEqual(
            self.patches(target),
            {"side": (3, "wall"), "middle": (2, "symmetry"), "turn": (1, "patch")},
        )
        zones = (target / "constant/polyMesh/cellZones").read_text()
        self.assertEqual(re.findall(r"^(\w+)\n\{\n    type", zones, re.M), ["water", "steel"])
        self.assertEqual(read_list(target / "constant/polyMesh/points")[1], [0.001, 0, 0])
        self.check_topology(target, 2)
        before = (target / "constant/polyMesh/faces").read_bytes()
        with self.assertRaisesRegex(RuntimeError, "new/case.foam: expected a case without a mesh"):
            convert(camaron_testing.EXAMPLES / "voronoi-ball.visf", target)
        self.assertEqual((target / "constant/polyMesh/faces").read_bytes(), before)
        convert(camaron_testing.EXAMPLES / "voronoi-ball.visf", target, overwrite=True)
        self.assertNotEqual((target / "constant/polyMesh/faces").read_bytes(), before)
        self.check_topology(target)
        with self.assertRaisesRegex(ValueError, "this file is read: choose another name"):
            convert(target / "case.foam", target, overwrite=True)

    @unittest.skipIf(camaron_testing.rank_count() > 1, "runs the command")
    def test_open_cells(self):
        """Cells that are stored the other way round than their neighbors are reported."""
        notes = convert(camaron_testing.EXAMPLES / "flange.visf", f"{self.folder}/flange/")
        self.assertRegex(" ".join(notes), "12 faces with the same orientation in both cells")
        notes = convert(camaron_testing.EXAMPLES / "voronoi-ball.visf", f"{self.folder}/ball/")
        self.assertNotIn("orientation", " ".join(notes))

    @unittest.skipIf(camaron_testing.rank_count() > 1, "runs the command")
    def test_rest_of_a_mesh(self):
        """What is left of a mesh is not replaced, either."""
        rest = self.folder / "rest/constant/polyMesh/boundary"
        rest.parent.mkdir(parents=True)
        rest.write_text("mine")
        with self.assertRaisesRegex(RuntimeError, "expected a case without a mesh"):
            convert(camaron_testing.EXAMPLES / "voronoi-ball.visf", f"{self.folder}/rest/")
        self.assertEqual(rest.read_text(), "mine")

    @unittest.skipIf(camaron_testing.rank_count() > 1, "runs the command")
    def test_patch_names(self):
        """Patches that ParaView's reader shows as blocks keep their names in every format with zones of faces, also from
        one format to the next, and with text Fluent meshes to HDF5."""
        convert(self.make("in.msh", FLUENT), self.folder / "first/case.foam")
        counts = {"side": 3, "middle": 2, "turn": 1}
        source = self.read(self.folder / "first")
        source.MeshRegions = ["internalMesh", *(f"patch/{name}" for name in counts)]
        folder = self.case(source, "again")  # whose types nobody knows
        self.assertEqual(self.patches(folder), {n: (c, "patch") for n, c in counts.items()})
        self.check_topology(folder, 2)
        for name in ("saved.msh", "saved.msh.h5", "saved.h5.msh"):
            path = self.folder / name
            if name == "saved.h5.msh":
                convert(self.folder / "saved.msh.h5", path)
            else:
                simple.SaveData(str(path), source)
            mesh = self.open(path)
            self.assertEqual(self.sizes(mesh), counts, name)
            folder = self.folder / f"from-{name}"
            convert(path, folder / "case.foam")
            self.assertEqual(self.patches(folder), {n: (c, "wall") for n, c in counts.items()})
        for name in ("by-command.msh", "by-command.msh.h5"):
            convert(self.folder / "first/case.foam", self.folder / name)
            mesh = self.open(self.folder / name)
            self.assertEqual(self.sizes(mesh), counts, name)
        convert(self.folder / "in.msh", self.folder / "zones.msh.h5")
        mesh = self.open(self.folder / "zones.msh.h5")
        self.assertEqual(self.sizes(mesh), counts)

    def sizes(self, mesh):
        """Numbers of faces of the boundaries of a reader, by name."""
        blocks = mesh.GetClientSideObject().GetOutputDataObject(1)  # Fetch adds words to names
        names = [
            blocks.GetMetaData(i).Get(blocks.NAME()) for i in range(blocks.GetNumberOfBlocks())
        ]
        return {name: blocks.GetBlock(i).GetNumberOfCells() for i, name in enumerate(names)}

    def content(self, path):
        """The cells of a Fluent mesh as faces of coordinates, the zone of each cell, and type and faces of each zone."""
        reader = self.open(path).GetClientSideObject()
        grid, blocks = reader.GetOutputDataObject(0), reader.GetOutputDataObject(1)

        def place(mesh, face):
            return tuple(sorted(mesh.GetPoint(point) for point in face))

        cells = [
            sorted(place(grid, face) for face in gallery.faces(grid, cell))
            for cell in range(grid.GetNumberOfCells())
        ]
        fields = (
            grid.GetFieldData().GetAbstractArray(f"Zone{n}") for n in ("Ids", "Names", "Types")
        )
        rows = zip(
            *([array.GetValue(i) for i in range(array.GetNumberOfValues())] for array in fields)
        )
        zones = {id: (name, kind) for id, name, kind in rows}
        own = [zones[id] for id in vtk_to_numpy(grid.GetCellData().GetArray("Zone")).tolist()]
        faces = {}
        for i in range(blocks.GetNumberOfBlocks()):
            block = blocks.GetBlock(i)
            cells_of_block = (block.GetCell(c) for c in range(block.GetNumberOfCells()))
            rings = (
                [c.GetPointId(k) for k in range(c.GetNumberOfPoints())] for c in cells_of_block
            )
            faces[blocks.GetMetaData(i).Get(blocks.NAME())] = sorted(place(block, r) for r in rings)
        return cells, own, sorted(zones.values()), faces

    @unittest.skipIf(camaron_testing.rank_count() > 1, "runs the command")
    def test_round_trip(self):
        """From Fluent to OpenFOAM and back, a mesh keeps all digits, cells, and names, types and faces of zones."""
        paths = [self.make("small.msh", FLUENT), self.make("zones.msh", ZONES)]
        paths += self.real("fluent_h5/simple-duct.msh.h5", "fluent_h5/mixing_elbow.cas.h5")
        paths += self.real("ansys_fluent/tgrid_axial_comp_3d_hex_ascii.msh")
        for path in paths:
            expected = self.content(path)
            for options in ENCODINGS:
                folder = self.folder / f"{path.stem}{ENCODINGS.index(options)}"
                convert(path, f"{folder}/", **options)
                self.assertEqual(convert(folder / "case.foam", folder / "back.msh.h5"), [])
                found = self.content(folder / "back.msh.h5")
                for what, one, other in zip(("cells", "cells' zones", "zones"), expected, found):
                    self.assertTrue(one == other, (path.name, options, what))
                self.assertEqual(expected[3].keys(), found[3].keys())
                self.assertTrue(expected[3] == found[3], (path.name, options))
            self.check_topology(self.folder / f"{path.stem}0", len(expected[0]))

    @unittest.skipIf(camaron_testing.rank_count() > 1, "runs the command")
    def test_files_of_openfoam(self):
        """OpenFOAM writes comments, short lists, and zones of faces that are in patches, too."""
        source = self.make("in.msh", FLUENT)
        convert(source, f"{self.folder}/case/")
        mesh = self.folder / "case/constant/polyMesh"
        for path in mesh.iterdir():
            text = re.sub(r"    arch .*\n", "", path.read_text())
            text = text.replace("}\n", "}\n// * * * * //\n", 1).replace(
                "inGroups        1", "inGroups List<word> 1"
            )
            path.write_text(f"/*---*\\\n| OpenFOAM |\n\\*---*/\n{text}\n// **** //\n")
        (mesh / "neighbour").write_text(
            openfoam_case.HEADER.format("labelList", "neighbour") + "1{1}\n"
        )
        zone = "sheet { type faceZone; faceLabels List<label> 3(1 2 3); flipMap List<bool> 3{0}; }"
        (mesh / "faceZones").write_text(
            openfoam_case.HEADER.format("regIOobject", "faceZones") + f"1({zone})"
        )
        self.assertEqual(convert(self.folder / "case/case.foam", self.folder / "back.msh.h5"), [])
        expected, found = self.content(source), self.content(self.folder / "back.msh.h5")
        self.assertEqual(expected[:2], found[:2])
        self.assertEqual(expected[3], found[3])

    @unittest.skipIf(camaron_testing.rank_count() > 1, "runs the command")
    def test_case_that_moves(self):
        """Of a case whose points move, ParaView's reader knows the present ones."""
        convert(self.make("in.msh", FLUENT), f"{self.folder}/case/")
        moved = self.folder / "case/0.5/polyMesh"
        moved.mkdir(parents=True)
        (moved / "points").write_text((moved / "../../constant/polyMesh/points").read_text())
        notes = convert(self.folder / "case/case.foam", self.folder / "back.msh.h5")
        self.assertIn("because it has several meshes", notes[0])
        self.assertEqual(len(self.content(self.folder / "back.msh.h5")[3]), 3)
        shutil.rmtree(moved)
        zones = self.folder / "case/constant/polyMesh/cellZones"
        zones.write_text(zones.read_text().replace("\n1\n(\n1\n)", "\n1\n(\n7\n)"))
        notes = convert(self.folder / "case/case.foam", self.folder / "again.msh.h5")
        self.assertIn("because index 7 is out of bounds", notes[0])

    @unittest.skipIf(camaron_testing.rank_count() > 1, "runs the command")
    def test_selected(self):
        """Selected cells become a set, of which ParaView and OpenFOAM know the labels."""
        source = self.open(camaron_testing.EXAMPLES / "flange.visf")
        cells = simple.SelectElements(Input=source, Strategy="By id", Ids="3 5-7")
        folder = self.case(cells, "case")
        labels = read_list(folder / "constant/polyMesh/sets/Selected")
        self.assertEqual(labels, [[3], [5], [6], [7]])

    @unittest.skipIf(camaron_testing.rank_count() > 1, "reads whole meshes")
    def test_real(self):
        """Meshes of other programs keep cells, patches and volumes, and checkMesh accepts them."""
        for path in self.real(*(f"ansys_fluent/{name}" for name in REAL)):
            cells, patches = REAL[path.name]
            folder = self.folder / path.stem
            convert(path, folder / "case.foam", encoding="binary")
            found = {name: count for name, (count, _) in self.patches(folder).items()}
            self.assertEqual(found, patches, path.name)
            volumes = []
            for source in (self.open(path), self.read(folder)):
                quality = simple.ElementQuality(Input=source, Criteria=["Volume"])
                data = self.fetch(simple.MergeBlocks(Input=quality)).GetCellData()
                volumes.append(vtk_to_numpy(data.GetArray("Volume")))
            self.assertEqual(len(volumes[0]), cells, path.name)
            # ParaView's reader has coordinates in single precision.
            numpy.testing.assert_allclose(volumes[0], volumes[1], rtol=1e-3, err_msg=path.name)
            self.check_topology(folder, cells)


if __name__ == "__main__":
    camaron_testing.main()
