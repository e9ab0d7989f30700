# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""camaron.check: verdicts and counts, compared with independent numbers."""

import contextlib
import io
import json
import math

import camaron_testing
import mesh_parts
import numpy
from camaron import check, cli, inspect, select
from camaron.checking import verdict_table
from camaron.common import json_text, tables
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

BALL = camaron_testing.EXAMPLES / "voronoi-ball.visf"
FLANGE = camaron_testing.EXAMPLES / "flange.visf"
FEM = camaron_testing.EXAMPLES / "fem.rules"
HEXAHEDRON, WEDGE, TETRA = 12, 13, 10
#: Surfaces of the cubes of side 1 of mesh_parts, their halves, and their corners.
AREAS = {HEXAHEDRON: 6.0, WEDGE: 3 + math.sqrt(2), TETRA: (3 + math.sqrt(3)) / 2}
CUBE = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]


class TestCheck(camaron_testing.TestCase):
    def save(self, data, name):
        """A file of data."""
        path = self.folder / name
        simple.SaveData(str(path), mesh_parts.producer(data))
        return path

    def cubes(self):
        """The cubes, wedges and tetrahedra of mesh_parts, with a material; types and materials."""
        grid = mesh_parts.make_full_mesh()
        types = numpy.array([grid.GetCellType(i) for i in range(grid.GetNumberOfCells())])
        material = mesh_parts.make_values(len(types))["Material"]
        return self.save(grid, "cubes.vtu"), types, material

    def expect(self, entry, failing, checked, **others):
        """Counts of a check, and ids of its list, for `failing` and `checked` cells as masks."""
        ids = numpy.flatnonzero(failing)
        self.assertEqual((entry["failing"], entry["checked"]), (len(ids), int(checked.sum())))
        self.assertEqual([cell["id"] for cell in entry["worst"]], ids[:10].tolist())
        for key, value in others.items():
            self.assertEqual(entry[key], value, key)

    def test_scopes(self):
        """Cells of a shape, a type, a value of an array; equal values are listed by id."""
        path, types, material = self.cubes()
        steel = material == 3
        everything = types > 0
        result = check(
            path,
            [
                "SurfaceArea > 3",
                "SurfaceArea >= 4.4 of wedges",
                "SurfaceArea > 4.5 of wedges",
                "SurfaceArea < 3 of type Tetra",
                "MinDihedralAngle >= 50 where Material = 3",
                "MinDihedralAngle >= 50 where Material = -3",
                "SurfaceArea > 3 where Material = 99",
                "FaceCount = 6 where FaceCount = 5",
            ],
        )
        self.assertEqual((result["verdict"], result["cells"]), ("fail", len(types)))
        small, wedges, large, tetrahedra, angle, minus, nothing, faces = result["checks"]
        self.expect(small, types == TETRA, everything, verdict="fail")
        self.expect(small, types == TETRA, everything, below=small["failing"], above=0, undefined=0)
        self.assertAlmostEqual(small["worst_value"], AREAS[TETRA], 12)
        self.expect(wedges, types < 0, types == WEDGE, verdict="pass")
        self.assertAlmostEqual(wedges["worst_value"], AREAS[WEDGE], 12)
        self.expect(large, types == WEDGE, types == WEDGE, verdict="fail")
        self.expect(tetrahedra, types < 0, types == TETRA, verdict="pass")
        self.expect(angle, steel & (types == WEDGE), steel, verdict="fail")
        self.assertAlmostEqual(angle["worst_value"], 45, 9)
        self.expect(minus, (material == -3) & (types == WEDGE), material == -3, verdict="fail")
        self.expect(nothing, types < 0, types < 0, verdict="empty", cells=0, fraction=None)
        self.expect(faces, types == WEDGE, types == WEDGE, verdict="fail", worst_value=5)
        self.assertEqual(angle["scope"], {"by": "array", "value": 3, "array": "Material"})
        self.assertEqual(wedges["scope"], {"by": "shape", "value": "wedges", "array": None})

    def test_offenders(self):
        """What is reported about a cell: id, type, value, below or above, and the mean of its points."""
        path, types, _ = self.cubes()
        (entry,) = check(path, ["SurfaceArea 3 5"], worst=1000)["checks"]
        # Cubes are 1 above, tetrahedra 0.63 below: all cubes come first.
        cubes, corners = numpy.flatnonzero(types == HEXAHEDRON), numpy.flatnonzero(types == TETRA)
        self.assertEqual([cell["id"] for cell in entry["worst"]], [*cubes, *corners])
        self.assertEqual((entry["above"], entry["below"]), (len(cubes), len(corners)))
        for cell in entry["worst"]:
            kind = types[cell["id"]]
            self.assertAlmostEqual(cell["value"], AREAS[kind], 12)
            self.assertEqual(cell["why"], "below" if kind == TETRA else "above")
        first = entry["worst"][0]
        grid = mesh_parts.make_mesh()
        bounds = grid.GetCell(first["id"]).GetBounds()
        middle = [(a + b) / 2 for a, b in zip(bounds[::2], bounds[1::2])]
        numpy.testing.assert_allclose(first["center"], middle, atol=1e-12)
        place = (first["type"], first["block"], first["id_space"])
        self.assertEqual(place, ("hexahedron", None, "index"))

    def test_blocks(self):
        path = self.save(mesh_parts.make_collection(), "blocks.vtpc")
        _, types, _ = self.cubes()
        third = len(types) // 3
        last = numpy.arange(len(types)) >= third
        rules = ["SurfaceArea > 3 in first", "SurfaceArea > 3 in last"]
        first, second = check(path, rules)["checks"]
        self.expect(first, (types == TETRA) & ~last, ~last)
        self.expect(second, (types == TETRA) & last, last)
        self.assertEqual({cell["block"] for cell in second["worst"]}, {"last"})
        message = r"blocks\.vtpc: rules:1: there is no block lost with cells; did you mean last\?"
        with self.assertRaisesRegex(RuntimeError, message):
            check(path, ["Volume > 0 in lost"])
        with self.assertRaisesRegex(RuntimeError, "the mesh has first, last"):
            check(path, ["Volume > 0 in qqq"])

    def test_families(self):
        """The shape of a polyhedron is that of its topology; its type is not."""
        tetrahedron = (4, 3, 0, 1, 3, 3, 1, 2, 3, 3, 2, 0, 3, 3, 0, 2, 1)
        path = camaron_testing.write_vtk(
            self.folder / "tets.vtk",
            [*CUBE, (5, 5, 5)],
            [
                (42, tetrahedron),
                (10, (0, 1, 2, 4)),
                (12, range(8)),
                (5, (0, 1, 2)),
                (7, (0, 1, 2, 3)),
                (10, (0, 1, 1, 1)),  # remains what its type says
            ],
        )
        shapes = {
            "tetrahedra": 3,
            "hexahedra": 1,
            "polyhedra": 0,
            "triangles": 1,
            "quadrangles": 1,
            "polygons": 0,
            "type Polyhedron": 1,
            "type Polygon": 1,
        }
        checks = check(path, [f"VertexCount > 0 of {shape}" for shape in shapes])["checks"]
        self.assertEqual([entry["checked"] for entry in checks], [*shapes.values()])

    def test_voronoi_cells(self):
        """Edges of the example, computed here; the worst ones in their order."""
        points, faces, cells = camaron_testing.read_visf(BALL)
        ratios, counts = [], numpy.array([len(cell) for cell in cells])
        for cell in cells:
            loops = [faces[f] for f in cell]
            edges = {frozenset(e) for loop in loops for e in zip(loop, loop[1:] + loop[:1])}
            lengths = [numpy.linalg.norm(numpy.subtract(*points[list(edge)])) for edge in edges]
            ratios.append(min(lengths) / max(lengths))
        ratios = numpy.array(ratios)
        rule = "EdgeLengthRatio >= 0.01"
        whole, some = check(BALL, [rule, f"{rule} where FaceCount = 15"])["checks"]
        bad = ratios < 0.01
        order = numpy.argsort(ratios)
        self.assertEqual([cell["id"] for cell in whole["worst"]], order[:10].tolist())
        self.assertAlmostEqual(whole["worst_value"], ratios.min(), 9)
        self.assertEqual((whole["failing"], whole["checked"]), (bad.sum(), len(cells)))
        self.assertAlmostEqual(whole["fraction"], bad.mean())
        here = counts == 15
        self.assertEqual((some["failing"], some["checked"]), ((bad & here).sum(), here.sum()))

    def test_other_elements(self):
        """Each face, edge and vertex once, with the values that Mesh Elements has for it."""
        source = simple.OpenDataFile(str(FLANGE))
        elements = simple.MeshElements(
            Input=source, FaceArrays=["FaceSkewness", "NonOrthogonality"], EdgeArrays=["EdgeLength"]
        )
        rules = [
            "NonOrthogonality <= 40 of faces",
            "FaceSkewness <= 0.5 of faces tolerate 99%",
            "EdgeLength 0.05 0.3 of edges",
            "VertexCellCount <= 8 of vertices",
            "Volume > 0",
        ]
        result = check(FLANGE, rules)
        arrays = [(0, "NonOrthogonality", None, 40), (0, "FaceSkewness", None, 0.5)]
        arrays += [(1, "EdgeLength", 0.05, 0.3), (2, "VertexCellCount", None, 8)]
        for entry, (port, name, low, high) in zip(result["checks"], arrays):
            data = self.fetch(elements, port).GetCellData()
            values = vtk_to_numpy(data.GetArray(name)).astype(float)
            known = values[~numpy.isnan(values)]
            bad = (known > high) | (known < (-math.inf if low is None else low))
            self.assertGreater(bad.sum(), 0, name)
            self.assertEqual(entry["elements"], ("faces", "edges", "vertices")[port])
            self.assertEqual((entry["cells"], entry["checked"]), (len(values), len(known)), name)
            self.assertEqual(
                (entry["failing"], entry["verdict"] == "fail"), (bad.sum(), port != 0 or high == 40)
            )
            worst = entry["worst"][0]
            self.assertEqual(values[worst["id"]], worst["value"])
        self.assertLess(result["checks"][0]["checked"], result["checks"][0]["cells"], "boundary")
        self.assertEqual(result["checks"][4]["elements"], "cells")
        self.assertEqual(result["cells"], 4080)
        words = verdict_table.describe(result)
        self.assertRegex(words, r"NonOrthogonality <= 40 of faces: \d+ of \d+ faces \(")
        self.assertRegex(words, r"\n +edge +type +value")
        junit_file = self.folder / "check.xml"
        cli.main(["check", str(FLANGE), "--rule", rules[2], "--junit", str(junit_file)])
        self.assertRegex(junit_file.read_text(), r"edge \d+ ")
        with self.assertRaisesRegex(
            RuntimeError, "rules of faces, edges and vertices select no cells"
        ):
            select(FLANGE, [f"Failed rules: Rules={rules[0]}"])

    def test_same_counts_as_inspect(self):
        """A preset fails the cells that the report counts as outside, and those without a value."""
        for mesh, preset in ((FLANGE, "Finite volume"), (BALL, "General")):
            summary = inspect(mesh, self.folder / "report", preset=preset, with_pictures=False)
            by_name = {c["name"]: c for c in summary["criteria"]}
            for entry in check(mesh, preset=preset)["checks"]:
                reported = by_name[entry["criterion"]]
                self.assertEqual(entry["range"], reported["acceptable"])
                self.assertEqual(entry["below"] + entry["above"], reported["out_of_range"])
                self.assertEqual(entry["checked"], reported["judged"])

    def test_undefined_and_infinite(self):
        """Tetrahedra of one point have no ratio of edges, and an infinite aspect ratio."""
        path = camaron_testing.write_vtk(
            self.folder / "points.vtk",
            [*CUBE, *[(0, 0, 0)] * 4],
            [(10, range(8, 12)), (10, (0, 1, 3, 4)), (10, range(8, 12)), (12, range(8))],
        )
        rules = [
            "EdgeLengthRatio >= 0.1",
            "EdgeLengthRatio >= 0.1 undefined passes of tetrahedra",
            "EdgeLengthRatio >= 0.8 tolerate 2",
            "CellAspectRatio >= 0",
            "TetRadiusRatio >= 0",
        ]
        failing, passing, both, infinite, tetrahedra = check(path, rules)["checks"]
        self.assertEqual((failing["failing"], failing["undefined"], failing["checked"]), (2, 2, 4))
        self.assertEqual(
            [(c["id"], c["value"], c["why"]) for c in failing["worst"]],
            [(0, None, "undefined"), (2, None, "undefined")],
        )
        self.assertEqual(
            (passing["failing"], passing["undefined"], passing["verdict"]), (0, 2, "pass")
        )
        # The ratio of the corner is 1 / sqrt(2); values come before null.
        self.assertEqual([c["id"] for c in both["worst"]], [1, 0, 2])
        self.assertEqual((both["failing"], both["tolerated"], both["verdict"]), (3, 2, "fail"))
        self.assertEqual((infinite["failing"], infinite["above"], infinite["infinite"]), (2, 2, 2))
        self.assertEqual([c["value"] for c in infinite["worst"]], [math.inf, math.inf])
        self.assertEqual(infinite["worst_value"], math.inf)
        self.assertEqual((tetrahedra["checked"], tetrahedra["cells"]), (3, 4), "no hexahedron")
        (again,) = check(path, ["CellAspectRatio 0 *"])["checks"]
        self.assertEqual(again["failing"], 2, "however the range is written")

    def test_tolerance(self):
        """One of eight cells is 12.5 %: this tolerance passes, a slightly smaller one does not."""
        flat = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, 1)]
        cells = [(10, (0, 1, 2, 4))] * 7 + [(10, (0, 1, 2, 3))]
        path = camaron_testing.write_vtk(self.folder / "eight.vtk", flat, cells)
        for tolerated, verdict in (
            ("12.5%", "pass"),
            ("12.499999999%", "fail"),
            ("1", "pass"),
            ("0", "fail"),
            ("0%", "fail"),
            ("100%", "pass"),
            (None, "fail"),
        ):
            words = "" if tolerated is None else f" tolerate {tolerated}"
            for result in (
                check(path, ["Volume > 0" + words]),
                check(path, ["Volume > 0"], tolerate=tolerated),
                check(path, ["Volume > 0" + (words or " tolerate 0")], tolerate="100%"),
            ):
                self.assertEqual(result["verdict"], verdict, tolerated)
                self.assertEqual(result["checks"][0]["failing"], 1)

    def test_limits(self):
        """Whether a limit itself is acceptable; the volume of the cube is 1 exactly."""
        path = camaron_testing.write_vtk(self.folder / "cube.vtk", CUBE, [(12, range(8))])
        for words, verdict in (
            (">= 1", "pass"),
            ("> 1", "fail"),
            ("<= 1", "pass"),
            ("< 1", "fail"),
            ("= 1", "pass"),
            ("1 2", "pass"),
            ("0 1", "pass"),
            ("> 0.9999999999999999 < 1.0000000000000002", "pass"),
            ("= 1.0000000000000002", "fail"),
        ):
            self.assertEqual(check(path, [f"Volume {words}"])["verdict"], verdict, words)
        points = [(0, 0, 0)] * 4
        zero = camaron_testing.write_vtk(self.folder / "flat.vtk", points, [(10, range(4))])
        for words, verdict in (("> 0", "fail"), (">= 0", "pass"), ("< 0", "fail")):
            self.assertEqual(check(zero, [f"Volume {words}"])["verdict"], verdict, words)

    def test_steps_and_presets(self):
        """Rules of one criterion with different limits are all counted."""
        path, types, _ = self.cubes()
        rules = ["SurfaceArea > 5", "SurfaceArea > 3", "SurfaceArea < 7", "preset 'FEM hexahedra'"]
        checks = check(path, rules)["checks"]
        areas = [c["failing"] for c in checks if c["criterion"] == "SurfaceArea"]
        self.assertEqual(areas, [(types != HEXAHEDRON).sum(), (types == TETRA).sum(), 0])
        self.assertIn("CornerScaledJacobian", {c["criterion"] for c in checks})

    def test_many_rules(self):
        """Many rules of one criterion, whose values are counted once for each shape of cells."""
        path, types, _ = self.cubes()
        lines = [
            f"SurfaceArea > {limit / 10} {of}"
            for limit in range(50)
            for of in ("", "of tetrahedra", "of wedges", "of type Hexahedron")
        ]
        checks = check(path, lines)["checks"]
        self.assertEqual(len(checks), len(lines))
        for entry, limit in zip(checks[1::4], range(50)):
            corners = types == TETRA
            self.expect(entry, corners & (AREAS[TETRA] <= limit / 10), corners)

    def test_nothing_to_check(self):
        """One rule without cells passes with the others; none with cells at all is an error."""
        path, _, _ = self.cubes()
        result = check(path, ["Volume > 0 of pyramids", "SurfaceArea > 0"])
        self.assertEqual(result["verdict"], "pass")
        self.assertEqual([c["verdict"] for c in result["checks"]], ["empty", "pass"])
        empty = camaron_testing.write_vtk(self.folder / "empty.vtk", [], [])
        for mesh, rules in ((path, ["Volume > 0 of pyramids", "Area > 0"]), (empty, ["Area > 0"])):
            with self.assertRaisesRegex(RuntimeError, "none of the rules has a cell to check"):
                check(mesh, rules)

    def test_errors(self):
        """Wrong rules come before the mesh is read; arrays and blocks are looked for in it."""
        with self.assertRaisesRegex(ValueError, "rules:1: .*\nrules:2: "):
            check("no.visf", ["Volume", "Area"])
        with self.assertRaisesRegex(
            ValueError, "^rules:1: expected a line of text, found 5\nrules:3: .*found None$"
        ):
            check("no.visf", [5, "Volume > 0", None])
        with self.assertRaisesRegex(ValueError, "name of a file or a list of lines, not 5"):
            check("no.visf", 5)
        with self.assertRaisesRegex(ValueError, "preset finite: did you mean Finite volume"):
            check("no.visf", preset="finite")
        with self.assertRaisesRegex(ValueError, "expected rules or a preset"):
            check("no.visf")
        with self.assertRaisesRegex(ValueError, "no.rules: No such file"):
            check("no.visf", "no.rules")
        with self.assertRaisesRegex(RuntimeError, "no.visf: there is no such file"):
            check("no.visf", ["Volume > 0"])
        path, _, _ = self.cubes()
        for scope, message in (
            ("where Materail = 1", "no cell array Materail; did you mean Material"),
            ("in rotor", "no block rotor with cells; the mesh has Block 0"),
        ):
            with self.assertRaisesRegex(RuntimeError, rf"cubes\.vtu: .*{message}"):
                check(path, [f"Volume > 0 {scope}"])

    def test_documented_rules(self):
        """The filter, the command and Python agree on the rules of the manual, alone and together."""
        page = (camaron_testing.ROOT / "Documentation" / "check.md").read_text("utf-8")
        examples = page.split("## Rules")[1].split("```")[1].strip().split("\n")
        self.assertGreater(len(examples), 7)
        path = self.save(self.make_rotor(), "rotor.vtm")
        for lines in (*([line, "SurfaceArea >= 0"] for line in examples), examples):
            rules = self.folder / "documented.rules"
            rules.write_text("\n".join(lines), encoding="utf-8")
            filtered = simple.CheckQuality(
                Input=simple.OpenDataFile(str(path)), Rules="\n".join(lines)
            )
            rows = tables.fetch(filtered)
            checks = [check(path, lines)["checks"], check(path, rules)["checks"]]
            out = io.StringIO()
            with contextlib.redirect_stdout(out):
                cli.main(["check", str(path), "--rules", str(rules), "--worst", "10", "--json"])
            printed = json.loads(out.getvalue())["meshes"][0]["checks"]
            self.assertEqual(json.loads(json_text.to_json(checks[0])), printed)
            self.assertEqual(checks[0], checks[1])
            self.assertEqual(len(rows), len(printed))
            for row, entry in zip(rows, printed):
                for column, key in (
                    ("Rule", "rule"),
                    ("Verdict", "verdict"),
                    ("Cells", "cells"),
                    ("Checked", "checked"),
                    ("Failing", "failing"),
                    ("Undefined", "undefined"),
                    ("Tolerated", "tolerated"),
                    ("Line", "line"),
                ):
                    self.assertEqual(row[column], entry[key], (row["Rule"], column))
                again = simple.CheckQuality(Input=filtered.Input, Rules=row["Text"])
                (same,) = tables.fetch(again)
                self.assertEqual(same["Failing"], row["Failing"], row["Text"])

    def make_rotor(self):
        """Two blocks of mesh_parts with a material, one of them inside another: rotor/blades."""
        grid = mesh_parts.make_full_mesh()
        half = grid.GetNumberOfCells() // 2
        rotor, whole = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
        rotor.SetBlock(0, mesh_parts.extract(grid, 0, half))
        rotor.GetMetaData(0).Set(rotor.NAME(), "blades")
        whole.SetBlock(0, rotor)
        whole.GetMetaData(0).Set(rotor.NAME(), "rotor")
        whole.SetBlock(1, mesh_parts.extract(grid, half, grid.GetNumberOfCells()))
        whole.GetMetaData(1).Set(rotor.NAME(), "stator")
        return whole

    def test_no_sources_are_left(self):
        before = len(simple.GetSources())
        check(BALL, ["Volume > 0", "Volume > 0 of wedges"])
        with self.assertRaises(RuntimeError):
            check(BALL, ["Volume > 0 in nothing"])
        self.assertEqual(len(simple.GetSources()), before)

    def test_example(self):
        """The mesh satisfies the example rules, except for its intentionally flat tetrahedra."""
        result = check(FLANGE, FEM)
        failed = [entry for entry in result["checks"] if entry["verdict"] == "fail"]
        (entry,) = failed
        self.assertEqual(entry["rule"], "MinDihedralAngle >= 2 of tetrahedra")
        lines = FEM.read_text(encoding="utf-8").split("\n")
        self.assertIn("MinDihedralAngle   >= 2 ", lines[entry["line"] - 1])
        self.assertTrue(all(each["checked"] for each in result["checks"]))
        self.assertTrue(all(cell["type"] == "tetrahedron" for cell in entry["worst"]))


if __name__ == "__main__":
    camaron_testing.main()
