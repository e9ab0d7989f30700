# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes whose polyhedra all lack faces are rejected with a reason; a single one is a defective cell."""

import camaron_testing
import gallery
import mesh_parts
from camaron.common import pipeline
from paraview import simple
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_POLYHEDRON

READS_LAYOUT = camaron_testing.paraview_version() >= (6, 0)
LAYOUT = """<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="2.3" byte_order="LittleEndian" header_type="UInt64">
<UnstructuredGrid><Piece NumberOfPoints="12" NumberOfCells="2"><PointData/><CellData/>
<Points><DataArray type="Float64" Name="Points" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 2 0 0 0 1 0 1 1 0 2 1 0 0 0 1 1 0 1 2 0 1 0 1 1 1 1 1 2 1 1</DataArray></Points>
<Cells>
<DataArray type="Int64" Name="connectivity" format="ascii">0 1 3 4 6 7 9 10 1 2 4 5 7 8 10 11</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">8 16</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">42 42</DataArray>
<DataArray type="Int64" Name="face_connectivity" format="ascii">
0 3 4 1 6 7 10 9 0 1 7 6 3 9 10 4 0 6 9 3 1 4 10 7
1 4 5 2 7 8 11 10 1 2 8 7 4 10 11 5 1 7 10 4 2 5 11 8</DataArray>
<DataArray type="Int64" Name="face_offsets" format="ascii">4 8 12 16 20 24 28 32 36 40 44 48</DataArray>
<DataArray type="Int64" Name="polyhedron_to_faces" format="ascii">0 1 2 3 4 5 6 7 8 9 10 11</DataArray>
<DataArray type="Int64" Name="polyhedron_offsets" format="ascii">6 12</DataArray>
</Cells></Piece></UnstructuredGrid></VTKFile>
"""
REASON = "2 cells are polyhedra, but none of them has faces"


def cubes(kinds):
    """Cubes in a row, as polyhedra, or as polyhedra that have lost their faces (None), or as hexahedra."""
    points, corners = gallery.lattice(len(kinds), 1, 1, lambda *p: p)
    whole = gallery.make_grid(points, [(VTK_HEXAHEDRON, cube) for cube in corners])
    cells = []
    for number, (kind, cube) in enumerate(zip(kinds, corners)):
        faces = [list(face) for face in gallery.faces(whole, number)] if kind else []
        cells.append((VTK_POLYHEDRON, faces) if kind != VTK_HEXAHEDRON else (kind, cube))
    return gallery.make_grid(points, cells)


class TestLostFaces(camaron_testing.TestCase):
    def test_commands(self):
        path = self.folder / "layout.vtu"
        path.write_text(LAYOUT)
        other = self.folder / "other.vtk"
        camaron_testing.write_vtk(
            other, [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(10, [0, 1, 2, 3])]
        )
        rules = self.folder / "rules"
        rules.write_text("Volume > 0.5\n")
        written = self.folder / "out.visf"
        for arguments in (
            ["inspect", path, "-o", self.folder / "report", "--no-pictures"],
            ["check", path, "--rules", rules],
            ["convert", path, written],
            ["compare", path, other],
            ["select", path, "--by", "Worst N: Array=Volume; NumberOfWorst=1"],
        ):
            done = camaron_testing.run_command(*arguments)
            if READS_LAYOUT:
                self.assertIn(done.returncode, (0, 1), done.stderr)
                continue
            self.assertEqual(done.returncode, 2, (arguments, done.stdout, done.stderr))
            self.assertIn(REASON, done.stderr, arguments)
            self.assertIn("ParaView 6.0 or newer", done.stderr, arguments)
        self.assertEqual(written.exists(), READS_LAYOUT)

    def test_filters(self):
        """Whoever made them."""
        for make in (
            simple.ElementQuality,
            simple.MeshElements,
            simple.MeshSurface,
            simple.MeshKernel,
        ):
            with pipeline.Messages() as messages:
                make(Input=mesh_parts.producer(cubes([None, None]))).UpdatePipeline()
            self.assertTrue(messages.errors, make)
            self.assertIn(REASON, messages.errors[0])
        path = self.folder / "nothing.visf"
        with pipeline.Messages() as messages:
            simple.SaveData(str(path), proxy=mesh_parts.producer(cubes([None, None])))
        self.assertIn(REASON, "".join(messages.errors))
        self.assertFalse(path.exists())

    def test_some(self):
        """One without faces is a cell without values; the others are what they are."""
        for kinds in ([True, None, True], [VTK_HEXAHEDRON, None, True]):
            grid = cubes(kinds)
            quality = simple.ElementQuality(
                Input=mesh_parts.producer(grid), Criteria=["Volume", "CellStatus"]
            )
            cells = self.fetch(quality).GetCellData()
            self.assertEqual([cells.GetArray("Volume").GetValue(i) for i in (0, 2)], [1.0, 1.0])
            volume = cells.GetArray("Volume").GetValue(1)
            self.assertNotEqual(volume, volume)
            self.assertNotEqual(cells.GetArray("CellStatus").GetTuple1(1), 0)


camaron_testing.main()
