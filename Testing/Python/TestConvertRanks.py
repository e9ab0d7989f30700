# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""camaron.convert on several ranks writes the files that one rank writes."""

import re

import camaron_testing
import gallery
from camaron import convert
from camaron.common import pipeline
from paraview import simple
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter


class TestConvertRanks(camaron_testing.TestCase):
    def test_same_files(self):
        """Each rank reads its piece; the file has every point and cell once, in order."""
        for name, target, options in (
            ("voronoi-ball", "m.visf", {}),
            ("flange", "m.tri", {"unsupported-cells": "convert"}),
            ("polygon-ring", "m.tri", {"unsupported-cells": "convert"}),
        ):
            source = camaron_testing.EXAMPLES / f"{name}.visf"
            together, alone = self.folder / f"{name}-{target}", self.folder / f"{name}-1-{target}"
            convert(source, together, **options)
            words = [word for key, value in options.items() for word in (f"--{key}", value)]
            run = camaron_testing.run_command("convert", source, alone, *words)
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertEqual(together.read_bytes(), alone.read_bytes(), name)

    def test_openfoam(self):
        """What only the first rank reads of a case is in the file of all."""
        source = camaron_testing.EXAMPLES / "voronoi-ball.visf"
        case = self.folder / "case" / "case.foam"
        run = camaron_testing.run_command("convert", source, case)
        self.assertEqual(run.returncode, 0, run.stderr)
        together, alone = self.folder / "together.msh.h5", self.folder / "alone.msh.h5"
        self.assertEqual(convert(case, together), [])
        run = camaron_testing.run_command("convert", case, alone)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual(together.read_bytes(), alone.read_bytes())

    def test_pieces_without_ids(self):
        """Pieces that share points but have no global ids are one mesh again in the file."""
        image = simple.Wavelet(WholeExtent=[0, 6, 0, 6, 0, 6])
        path = self.folder / "image.off"
        with pipeline.Messages() as messages:
            simple.SaveData(str(path), image, FacesOfVolumes="Every")
        self.assertEqual(messages.errors, [])
        lines = [line for line in path.read_text().splitlines() if line]
        points, faces, _ = (int(word) for word in lines[1].split())
        self.assertEqual((points, faces), (7**3, 3 * 7 * 6**2))
        self.assertEqual(len({tuple(line.split()) for line in lines[2 : 2 + points]}), points)

    def test_file_of_pieces(self):
        """A file of pieces without ids is one mesh again, however many processes read it."""
        names = [f"piece{i}.vtu" for i in range(5)]
        for i, name in enumerate(names):
            corners = [(i + x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
            writer = vtkXMLUnstructuredGridWriter()
            writer.SetFileName(str(self.folder / name))
            writer.SetInputData(gallery.make_grid(corners, [(VTK_HEXAHEDRON, range(8))]))
            writer.Write()
        pieces = self.folder / "row.pvtu"
        pieces.write_text(
            '<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid GhostLevel="0"><PPoints>'
            '<PDataArray type="Float64" NumberOfComponents="3"/></PPoints>'
            + "".join(f'<Piece Source="{name}"/>' for name in names)
            + "</PUnstructuredGrid></VTKFile>"
        )
        target = self.folder / "row.visf"
        (note,) = convert(pieces, target)
        self.assertIn(
            "16 points of pieces without global ids were merged with points of other", note
        )
        points, faces, cells = camaron_testing.read_visf(target)
        self.assertEqual((len(points), len(faces), len(cells)), (4 * 6, 5 * 5 + 1, 5))
        apart = "Points at the borders of the 5 pieces may be duplicated."
        self.assertEqual(convert(pieces, self.folder / "row-again.pvtu"), [apart])

    def test_formats_of_one_process(self):
        """What several ranks would write wrong is refused, with a way out; nothing is left behind."""
        if camaron_testing.rank_count() == 1:
            self.skipTest("one process may write all")
        source = camaron_testing.EXAMPLES / "voronoi-ball.visf"
        for name, instead in (
            ("m.vtu", ".pvtu"),
            ("m.vtp", ".pvtp"),
            ("m.vtk", ".pvtu"),
            ("m.vtkhdf", ".pvtu"),
            ("m.exo", ".pvtu"),
            ("m.cgns", ".pvtu"),
            ("m.obj", ".pvtu"),
        ):
            reason = (
                f"by one process only: omit --ranks, or choose {instead} or a format of the plugin"
            )
            with self.assertRaisesRegex(ValueError, re.escape(reason)):
                convert(source, self.folder / name)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_pieces(self):
        """Pieces have every cell once, besides what is marked as a ghost."""
        pieces = self.folder / "m.pvtu"
        self.assertEqual(convert(camaron_testing.EXAMPLES / "voronoi-ball.visf", pieces), [])
        marks = []
        for path in (self.folder / "m").glob("*.vtu"):
            reader = vtkXMLUnstructuredGridReader()
            reader.SetFileName(str(path))
            reader.Update()
            grid = reader.GetOutput()
            ghosts = grid.GetCellData().GetArray("vtkGhostType")
            marks += [ghosts.GetValue(i) if ghosts else 0 for i in range(grid.GetNumberOfCells())]
        self.assertEqual(marks.count(0), 800)

    def test_triangles(self):
        """Of every polygon of the boundary each triangle is there once."""
        source, target = camaron_testing.EXAMPLES / "voronoi-ball.visf", self.folder / "m.stl"
        convert(source, target, file_type="Ascii")
        polygons = self.fetch(simple.MeshSurface(Input=self.open(source))).GetPolys()
        triangles = polygons.GetNumberOfConnectivityIds() - 2 * polygons.GetNumberOfCells()
        facets = target.read_text().split("endfacet")[:-1]
        self.assertEqual((len(facets), len(set(facets))), (triangles, triangles))


if __name__ == "__main__":
    camaron_testing.main()
