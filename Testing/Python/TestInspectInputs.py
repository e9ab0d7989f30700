# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""camaron.inspect on ParaView's formats, blocks, time steps, odd and bad meshes."""

import json

import camaron_testing
from camaron import inspect
from paraview import simple

CUBE = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]


class TestInspectInputs(camaron_testing.TestCase):
    def inspect(self, mesh, **options):
        summary = inspect(mesh, self.folder / "report", with_pictures=False, **options)
        text = (self.folder / "report" / "summary.json").read_text("utf-8")
        json.loads(text, parse_constant=self.fail)
        return summary, {c["name"]: c for c in summary["criteria"]}

    def vtk(self, points, cells):
        return camaron_testing.write_vtk(self.folder / "mesh-in.vtk", points, cells)

    def test_formats_of_paraview(self):
        """The surface of a cube, 12 triangles of area 6, in ParaView's formats."""
        box = simple.Triangulate(Input=simple.Box())
        for name in ("box.stl", "box.vtp", "box.vtk"):
            simple.SaveData(str(self.folder / name), box)
            summary, by_name = self.inspect(self.folder / name)
            self.assertEqual(
                summary["mesh"]["cell_types"], [{"name": "triangles", "count": 12}], name
            )
            self.assertAlmostEqual(summary["mesh"]["area"], 6.0, places=6)
            self.assertAlmostEqual(by_name["MinInteriorAngle"]["min"], 45.0, places=5)
            self.assertEqual(summary["files"]["mesh"], "mesh.vtp")
            self.assertTrue((self.folder / "report" / "mesh.vtp").exists())

    def test_image(self):
        """A regular grid is a mesh of voxels."""
        path = self.folder / "grid.vti"
        simple.SaveData(str(path), simple.Wavelet(WholeExtent=[0, 3, 0, 2, 0, 4]))
        summary, by_name = self.inspect(path)
        self.assertEqual(summary["mesh"]["cell_types"], [{"name": "voxels", "count": 24}])
        self.assertAlmostEqual(summary["mesh"]["volume"], 24.0)
        self.assertAlmostEqual(by_name["MinDihedralAngle"]["min"], 90.0)

    def test_blocks(self):
        """Statistics are over all blocks; the worst cells tell theirs."""
        path = self.folder / "blocks.vtm"
        cone, sphere = simple.Cone(), simple.Sphere()
        simple.SaveData(
            str(path), simple.GroupDatasets(Input=[cone, sphere], BlockNames=["cone", "sphere"])
        )
        summary, by_name = self.inspect(path)
        cells = [self.fetch(source).GetNumberOfCells() for source in (cone, sphere)]
        self.assertEqual(summary["mesh"]["blocks"], 2)
        self.assertEqual(summary["mesh"]["cells"], sum(cells))
        self.assertEqual(by_name["Area"]["count"], sum(cells))
        blocks = {w["block"] for c in summary["criteria"] for w in c["worst"]}
        self.assertTrue(blocks and all(blocks), blocks)
        written = self.folder / "report" / summary["files"]["mesh"]
        self.assertEqual(self.open(written).CellData["Area"].GetNumberOfComponents(), 1)

    def test_time_steps(self):
        """The last step of a series is evaluated unless another one is requested; the report names it."""
        path = self.folder / "series.pvd"
        entries = []
        for step, size in enumerate((1.0, 2.0, 3.0)):
            name = f"step{step}.vtp"
            simple.SaveData(
                str(self.folder / name),
                simple.Plane(Point1=[size, 0, 0], Origin=[0, 0, 0], Point2=[0, 1, 0]),
            )
            entries.append(f'<DataSet timestep="{0.5 * step}" file="{name}"/>')
        path.write_text(
            '<?xml version="1.0"?><VTKFile type="Collection"><Collection>'
            + "".join(entries)
            + "</Collection></VTKFile>"
        )
        for time, area, step in (("last", 3.0, 2), ("first", 1.0, 0), ("1", 2.0, 1)):
            summary, _ = self.inspect(path, time=time)
            self.assertAlmostEqual(summary["mesh"]["area"], area)
            self.assertEqual(
                summary["mesh"]["time"], {"step": step, "steps": 3, "value": 0.5 * step}
            )
            self.assertTrue(any("time steps" in note for note in summary["notes"]))
        with self.assertRaisesRegex(ValueError, "no time step 3"):
            self.inspect(path, time="3")

    def test_empty(self):
        summary, by_name = self.inspect(self.vtk([], []))
        self.assertEqual((summary["mesh"]["cells"], by_name), (0, {}))
        self.assertIsNone(summary["worst_criterion"])
        self.assertEqual(summary["notes"], [])

    def test_points_only(self):
        summary, by_name = self.inspect(self.vtk(CUBE, []))
        self.assertEqual((summary["mesh"]["points"], summary["mesh"]["cells"], by_name), (8, 0, {}))
        summary, by_name = self.inspect(self.vtk(CUBE, [(1, (i,)) for i in range(8)]))
        self.assertEqual((summary["mesh"]["cells"], by_name), (8, {}))

    def test_one_cell(self):
        """A cube: statistics of one value, and the standard deviation that does not exist."""
        summary, by_name = self.inspect(self.vtk(CUBE, [(12, range(8))]))
        volume = by_name["Volume"]
        self.assertAlmostEqual(volume["mean"], 1.0)
        self.assertIsNone(volume["std_dev"])
        self.assertEqual(volume["histogram"]["counts"], [1])
        self.assertEqual(summary["mesh"]["boundary_faces"], 6)

    def test_mixed_dimensions(self):
        """A hexahedron, a tetrahedron on its side, a triangle, a line and a vertex."""
        points = [*CUBE, (2, 0, 0)]
        cells = [(12, range(8)), (5, (1, 2, 8)), (3, (0, 8)), (1, (8,)), (10, (1, 2, 5, 8))]
        summary, by_name = self.inspect(self.vtk(points, cells))
        self.assertEqual(
            {t["name"]: t["count"] for t in summary["mesh"]["cell_types"]},
            {"hexahedron": 1, "triangle": 1, "line": 1, "vertex": 1, "tetrahedron": 1},
        )
        self.assertEqual((by_name["Volume"]["applicable"], by_name["Area"]["applicable"]), (2, 1))
        self.assertAlmostEqual(summary["mesh"]["volume"], 1.0 + 1.0 / 6.0)
        self.assertAlmostEqual(summary["mesh"]["area"], 0.5)

    def test_all_undefined_and_infinite(self):
        """Tetrahedra of one point: undefined and infinite values are counted separately, and are in the JSON."""
        summary, by_name = self.inspect(self.vtk([(0, 0, 0)] * 4, [(10, range(4))] * 3))
        ratio, aspect = by_name["EdgeLengthRatio"], by_name["CellAspectRatio"]
        self.assertEqual((ratio["undefined"], ratio["infinite"], ratio["min"]), (3, 0, None))
        self.assertEqual((ratio["worst"], ratio["histogram"]["counts"]), ([], []))
        self.assertEqual((aspect["infinite"], aspect["out_of_range"], aspect["max"]), (3, 3, None))
        text = (self.folder / "report" / "summary.json").read_text("utf-8")
        worst = {c["name"]: c["worst"] for c in json.loads(text)["criteria"]}
        self.assertEqual(worst["CellAspectRatio"][0]["value"], "Infinity")
        printed = camaron_testing.run_command(
            *("inspect", "--no-pictures", "--json", "-o", self.folder / "again"),
            self.folder / "mesh-in.vtk",
        )
        json.loads(printed.stdout, parse_constant=self.fail)
        self.assertEqual(summary["worst_criterion"], "IsValid", "of those that all cells fail")

    def test_bounds(self):
        """Bounds, and so pictures, are those of the finite points that cells use."""
        lines = (camaron_testing.EXAMPLES / "flange.visf").read_text().splitlines()
        points = int(lines[1])
        expected = self.inspect(camaron_testing.EXAMPLES / "flange.visf")[0]["mesh"]["bounds"]
        for point in ("1e9 0 0", "inf 0 0", "0 nan 0"):
            unused = [
                lines[0],
                str(points + 1),
                *lines[2 : 2 + points],
                point,
                *lines[2 + points :],
            ]
            used = [*lines[:52], point.replace("1e9", "inf"), *lines[53:]]  # an inner point
            for changed in (unused, used):
                path = self.folder / "changed.visf"
                path.write_text("\n".join(changed) + "\n")
                summary, _ = self.inspect(path)
                self.assertEqual(summary["mesh"]["bounds"], expected, point)

    def test_inverted(self):
        """A hexahedron inside out has a negative volume, which is not acceptable."""
        _, by_name = self.inspect(self.vtk(CUBE, [(12, (4, 5, 6, 7, 0, 1, 2, 3))]))
        self.assertAlmostEqual(by_name["Volume"]["min"], -1.0)
        self.assertEqual(by_name["Volume"]["out_of_range"], 1)

    def test_dialects(self):
        """Visf files of every dialect give a report."""
        seeds = sorted((camaron_testing.ROOT / "Readers/Visf/Testing/Seeds").glob("*.visf"))
        self.assertGreater(len(seeds), 5)
        for path in seeds + self.real("visf/*.visf"):
            with self.subTest(path.name):
                summary, _ = self.inspect(path)
                self.assertEqual(summary["mesh"]["points"] == 0, path.stem == "several-headers-fit")

    def test_hr3(self):
        """256 cells with six faces, 68 with five, 32 with four, as the collection says."""
        _, by_name = self.inspect(self.data("visf/camaron_hr3.visf"))
        faces = by_name["FaceCount"]["histogram"]
        self.assertEqual(faces["counts"], [32, 68, 256])
        self.assertEqual(faces["edges"], [3.5, 4.5, 5.5, 6.5])


if __name__ == "__main__":
    camaron_testing.main()
