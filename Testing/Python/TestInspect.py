# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""camaron.inspect on the example meshes: numbers against numpy, files, errors, pictures."""

import csv
import html
import json
import os
import re
import shlex
import unittest.mock
from html.parser import HTMLParser

import camaron_testing
import numpy
from camaron import convert, inspect, select
from camaron.common import evaluation
from camaron.common.assessment import picture_criterion
from camaron.common.stages import Progress
from inspection_testing import report_pictures
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

BALL = camaron_testing.EXAMPLES / "voronoi-ball.visf"
FLANGE = camaron_testing.EXAMPLES / "flange.visf"
RING = camaron_testing.EXAMPLES / "polygon-ring.visf"


def convex_cell(points, faces):
    """Volume and surface of a convex cell by the divergence theorem; lengths of its edges."""
    middle = points[sorted({p for face in faces for p in face})].mean(axis=0)
    volume = area = 0.0
    edges = {}
    for face in faces:
        corners = points[face] - middle
        vector = 0.5 * numpy.cross(corners, numpy.roll(corners, -1, axis=0)).sum(axis=0)
        volume += abs(vector @ corners.mean(axis=0)) / 3.0
        area += numpy.linalg.norm(vector)
        for a, b in zip(face, face[1:] + face[:1]):
            edges[frozenset((a, b))] = numpy.linalg.norm(points[a] - points[b])
    return volume, area, list(edges.values())


class Page(HTMLParser):
    """What a page refers to, and whether its elements are closed."""

    Void = {"meta", "img", "br", "link", "input", "hr"}

    def __init__(self, text):
        super().__init__()
        self.open, self.ids, self.links, self.sources = [], set(), [], []
        self.feed(text)
        self.close()
        assert not self.open, f"not closed: {self.open}"

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if "id" in attributes:
            assert attributes["id"] not in self.ids, f"twice: {attributes['id']}"
            self.ids.add(attributes["id"])
        if "href" in attributes:
            self.links.append(attributes["href"])
        if "src" in attributes:
            self.sources.append(attributes["src"])
        if tag not in self.Void:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in self.Void:
            self.open.pop()

    def handle_endtag(self, tag):
        assert self.open and self.open[-1] == tag, f"</{tag}> closes {self.open[-1:]}"
        self.open.pop()


class TestInspect(camaron_testing.TestCase):
    def inspect(self, mesh, **options):
        options.setdefault("with_pictures", False)
        return inspect(mesh, self.folder / "report", **options)

    def strict_json(self):
        """summary.json, read by somebody who knows no NaN and Infinity."""

        def refuse(word):
            raise ValueError(f"{word} is not JSON")

        return json.loads(
            (self.folder / "report" / "summary.json").read_text("utf-8"), parse_constant=refuse
        )

    def check_numbers(self, criterion, values):
        """All statistics of a criterion against numpy; values are in the order of the cells."""
        values = numpy.asarray(values, dtype=float)
        near = lambda got, want: self.assertAlmostEqual(
            got, want, delta=1e-6 * max(abs(want), 1e-9)
        )
        self.assertEqual(
            (criterion["count"], criterion["undefined"], criterion["infinite"]), (len(values), 0, 0)
        )
        near(criterion["min"], values.min())
        near(criterion["max"], values.max())
        near(criterion["mean"], values.mean())
        near(criterion["std_dev"], values.std(ddof=1))
        near(criterion["sum"], values.sum())
        for percent, quantile in criterion["quantiles"].items():
            near(quantile, numpy.percentile(values, float(percent)))
        low, high = criterion["acceptable"]
        outside = (values < (-numpy.inf if low is None else low)) | (
            values > (numpy.inf if high is None else high)
        )
        judged = (
            criterion["judged"] == criterion["applicable"]
        )  # else the range is for other shapes
        self.assertEqual(criterion["out_of_range"], int(outside.sum()) if judged else 0)
        if criterion["better"] != "neither":
            order = numpy.argsort(
                values if criterion["better"] == "bigger" else -values, kind="stable"
            )
            self.assertEqual(
                [w["id"] for w in criterion["worst"]], order[: len(criterion["worst"])].tolist()
            )
            for worst in criterion["worst"]:
                near(worst["value"], values[worst["id"]])

    def test_voronoi_cells(self):
        """Sizes, ratios and counts of the Voronoi cells are those of an independent computation."""
        points, faces, cells = camaron_testing.read_visf(BALL)
        loops = [[faces[f] for f in cell] for cell in cells]
        computed = [convex_cell(points, loop) for loop in loops]
        summary = self.inspect(BALL)
        by_name = {c["name"]: c for c in summary["criteria"]}
        self.check_numbers(by_name["Volume"], [v for v, _, _ in computed])
        self.check_numbers(by_name["SurfaceArea"], [a for _, a, _ in computed])
        self.check_numbers(by_name["FaceCount"], [len(cell) for cell in cells])
        self.check_numbers(by_name["EdgeLengthRatio"], [min(e) / max(e) for _, _, e in computed])
        self.check_numbers(
            by_name["IsoperimetricQuotient"],
            [36.0 * numpy.pi * v * v / a**3 for v, a, _ in computed],
        )
        mesh = summary["mesh"]
        self.assertEqual((mesh["points"], mesh["cells"]), (len(points), len(cells)))
        self.assertAlmostEqual(mesh["volume"], sum(v for v, _, _ in computed), places=6)
        uses = numpy.bincount([f for cell in cells for f in cell])
        self.assertEqual(mesh["boundary_faces"], int((uses == 1).sum()))
        numpy.testing.assert_allclose(mesh["bounds"][0::2], points.min(axis=0), rtol=1e-6)
        numpy.testing.assert_allclose(mesh["bounds"][1::2], points.max(axis=0), rtol=1e-6)
        self.assertEqual(mesh["cell_types"], [{"name": "polyhedra", "count": 800}])

    def test_mixed_cells(self):
        """Criteria are of the cells that they have a meaning for; types are recognized."""
        _, _, cells = camaron_testing.read_visf(FLANGE)
        summary = self.inspect(FLANGE)
        types = {t["name"]: t["count"] for t in summary["mesh"]["cell_types"]}
        self.assertEqual(types["tetrahedra"], sum(len(cell) == 4 for cell in cells))
        self.assertEqual(types["hexahedra"], sum(len(cell) == 6 for cell in cells))
        self.assertEqual(sum(types.values()), len(cells))
        by_name = {c["name"]: c for c in summary["criteria"]}
        self.assertNotIn("TriangleRadiusRatio", by_name)
        self.assertNotIn("CellTypeId", by_name)
        self.assertEqual(by_name["TetMeanRatio"]["applicable"], types["tetrahedra"])
        self.assertEqual(by_name["TetMeanRatio"]["count"], len(cells))
        self.assertEqual(by_name["TetMeanRatio"]["undefined"], len(cells) - types["tetrahedra"])
        self.assertGreater(by_name["TetMeanRatio"]["out_of_range"], 0, "the slivers")

    def test_surface(self):
        points, faces, _ = camaron_testing.read_visf(RING)
        summary = self.inspect(RING)
        area = 0.0
        for face in faces:
            corners = points[face] - points[face[0]]
            area += 0.5 * numpy.linalg.norm(
                numpy.cross(corners, numpy.roll(corners, -1, axis=0)).sum(axis=0)
            )
        self.assertAlmostEqual(summary["mesh"]["area"], area, places=5)
        self.assertIsNone(summary["mesh"]["volume"])
        by_name = {c["name"]: c for c in summary["criteria"]}
        self.check_numbers(by_name["VertexCount"], [len(face) for face in faces])
        self.assertNotIn("Volume", by_name)

    def test_histograms_add_up(self):
        """No cell gets lost between the bins, and the bins span the values."""
        for mesh in (BALL, FLANGE, RING):
            for c in self.inspect(mesh, bins=7)["criteria"]:
                h = c["histogram"]
                total = (
                    sum(h["counts"])
                    + h["underflow"]
                    + h["overflow"]
                    + h["undefined"]
                    + h["infinite"]
                )
                self.assertEqual(total, c["count"], c["name"])
                if h["undefined"] == c["count"]:
                    self.assertEqual((h["edges"], h["counts"]), ([], []), c["name"])
                    continue
                self.assertEqual(len(h["edges"]), len(h["counts"]) + 1)
                self.assertEqual(h["edges"], sorted(h["edges"]))
                self.assertLessEqual(h["edges"][0], c["min"])
                self.assertGreaterEqual(h["edges"][-1], c["max"])
                if c["min"] < c["max"] and not c["name"].endswith(("Count", "Status", "IsValid")):
                    self.assertEqual(len(h["counts"]), 7, c["name"])

    def test_files(self):
        """summary.json is what inspect returns, worst.csv its lists; the mesh has the arrays."""
        summary = self.inspect(FLANGE, worst=4)
        self.assertEqual(self.strict_json(), json.loads(json.dumps(summary)))
        names = [c["name"] for c in summary["criteria"]]
        with open(self.folder / "report" / "worst.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(
            [(r["criterion"], int(r["rank"]), int(r["cell"]), float(r["value"])) for r in rows],
            [
                (c["name"], w["rank"], w["id"], w["value"])
                for c in summary["criteria"]
                for w in c["worst"]
            ],
        )
        for c in summary["criteria"]:
            values = [float(r["value"]) for r in rows if r["criterion"] == c["name"]]
            self.assertEqual(values, sorted(values, reverse=c["better"] == "smaller"))
            # A volume has no better end, but must be above zero: that makes the small ones worse.
            one_limit = c["acceptable"].count(None) == 1
            has_worst = c["better"] != "neither" or one_limit
            self.assertEqual(len(values), 4 if has_worst else 0)
        mesh = self.fetch(self.open(self.folder / "report" / "mesh.vtu"))
        self.assertEqual(mesh.GetNumberOfCells(), 4080)
        arrays = {
            mesh.GetCellData().GetArrayName(k)
            for k in range(mesh.GetCellData().GetNumberOfArrays())
        }
        self.assertEqual(arrays & set(names), set(names))
        self.assertNotIn(
            "TriangleRadiusRatio", arrays, "criteria without a meaning are not written"
        )
        by_name = {c["name"]: c for c in summary["criteria"]}
        values = vtk_to_numpy(mesh.GetCellData().GetArray("MinDihedralAngle"))
        self.assertEqual(values.min(), by_name["MinDihedralAngle"]["min"])
        self.assertEqual(
            sorted(path.name for path in (self.folder / "report").iterdir()),
            ["mesh.vtu", "report.html", "summary.json", "worst.csv"],
        )

    def test_page(self):
        """The page is well formed, refers to nothing outside itself, and names every criterion."""
        summary = self.inspect(FLANGE)
        text = (self.folder / "report" / "report.html").read_text("utf-8")
        page = Page(text)
        self.assertEqual(page.sources, [])
        for link in page.links:
            self.assertTrue(link.startswith("#") and link[1:] in page.ids, link)
        self.assertNotRegex(text, r"https?:|//[a-z]|@import|url\((?!#)")
        for c in summary["criteria"]:
            self.assertIn(f"criterion-{c['name']}", page.ids)
        self.assertIn("outside the acceptable range", text)
        self.assertNotRegex(text, r">\s*(nan|None)\s*<")

    def test_groups(self):
        """Types, blocks and arrays divide the cells; the numbers of a group are those of its cells."""
        _, _, cells = camaron_testing.read_visf(FLANGE)
        sizes = numpy.array([len(cell) for cell in cells])
        summary = self.inspect(FLANGE, criteria="FaceCount,Volume")
        groups = {g["group"]: g for g in summary["criteria"][1]["groups"]}
        self.assertEqual(groups["tetrahedra"]["count"], (sizes == 4).sum())
        self.assertEqual(sum(g["count"] for g in groups.values()), len(cells))
        self.assertEqual((groups["hexahedra"]["min"], groups["hexahedra"]["max"]), (6, 6))
        page = (self.folder / "report" / "report.html").read_text("utf-8")
        self.assertRegex(page, r"<td>hexahedra</td><td>528</td>")
        mesh = self.folder / "report" / "mesh.vtu"
        summary = inspect(
            mesh,
            self.folder / "other",
            criteria=["Volume"],
            group_by="facecount",
            with_pictures=False,
        )
        counts = {g["group"]: g["count"] for g in summary["criteria"][0]["groups"]}
        self.assertEqual(counts, {str(n): (sizes == n).sum() for n in numpy.unique(sizes)})
        summary = self.inspect(FLANGE, criteria=["Volume"], group_by="none")
        self.assertEqual(summary["criteria"][0]["groups"], [])
        with self.assertRaisesRegex(
            ValueError, "unknown group or cell array Material: expected one of type, block, none"
        ):
            self.inspect(FLANGE, group_by="Material")
        with self.assertRaisesRegex(ValueError, "mean type. There are type, block, none"):
            self.inspect(FLANGE, group_by="typ")

    def test_curves(self):
        """Fractions of cells and of volume up to a value, as counted from the cells themselves."""
        summary = self.inspect(BALL)
        mesh = self.fetch(self.open(self.folder / "report" / "mesh.vtu"))
        volumes = vtk_to_numpy(mesh.GetCellData().GetArray("Volume"))
        for c in summary["criteria"]:
            values = vtk_to_numpy(mesh.GetCellData().GetArray(c["name"]))
            curve = c["curve"]
            self.assertEqual(len(curve["values"]), len(curve["percent"]))
            self.assertEqual(curve["values"][-1], c["max"])
            for x, percent, weight in zip(*curve.values()):
                self.assertAlmostEqual(percent, 100 * (values <= x).mean(), delta=1e-9)
                share = 100 * volumes[values <= x].sum() / volumes.sum()
                self.assertAlmostEqual(weight, share, delta=1e-6)
        page = (self.folder / "report" / "report.html").read_text("utf-8")
        self.assertGreater(page.count('class="curve volume"'), 10)
        self.assertEqual(page.count('class="curve volume"'), page.count('class="curve"'))

    def test_bars_lead_to_cells(self):
        """The query of a bar selects as many cells as the bar counts, and no cell is in two bars."""
        summary = self.inspect(FLANGE, criteria=["MinDihedralAngle", "FaceCount"])
        page = (self.folder / "report" / "report.html").read_text("utf-8")
        quality = simple.OpenDataFile(str(self.folder / "report" / "mesh.vtu"))
        marked = simple.SelectElements(
            Input=quality, Strategy="By criterion", Range="Custom", Side="Inside"
        )
        for c in summary["criteria"]:
            article = page[page.index(f'data-criterion="{c["name"]}"') :]
            article = article[: article.index("</article>")]
            bars = re.findall(
                r'data-low="([^"]+)" data-high="([^"]+)"[^>]*><title>[^:]*: (\d+) cell', article
            )
            bars = [*dict.fromkeys(bars)]  # a bar across a limit is there twice
            self.assertEqual(sum(int(count) for _, _, count in bars), c["count"])
            for low, high, count in bars[:: max(1, len(bars) // 6)]:
                marked.Array, marked.LowerLimit, marked.UpperLimit = c["name"], low, high
                marked.UpdatePipeline()
                marked.UpdatePropertyInformation()
                self.assertEqual(marked.GetPropertyValue("NumberOfSelectedElements"), int(count))
        self.assertIn(f'data-mesh="{FLANGE}"', page)

    def test_findings_lead_to_cells(self):
        """The command of a finding selects as many cells as it counts."""
        for preset in (None, "FEM tetrahedra"):
            summary = self.inspect(FLANGE, preset=preset)
            outside = {c["name"]: c["out_of_range"] for c in summary["criteria"]}
            page = (self.folder / "report" / "report.html").read_text("utf-8")
            commands = re.findall("<code>(camaron select [^<]*)</code>", page)
            self.assertGreater(len(commands), 2)
            for command in commands:
                _, _, mesh, _, step, _, _ = shlex.split(html.unescape(command))
                name = re.search("Array=([A-Za-z]+)", step)[1]
                found = select(mesh, [step])
                self.assertEqual(found["selected"], outside[name])

    def test_choices(self):
        names = lambda summary: [c["name"] for c in summary["criteria"]]
        chosen = self.inspect(BALL, criteria=["edgelengthratio", "Volume"], worst=3, bins=5)
        self.assertEqual(sorted(names(chosen)), ["EdgeLengthRatio", "Volume"])
        ratio = next(c for c in chosen["criteria"] if c["name"] == "EdgeLengthRatio")
        self.assertEqual((len(ratio["worst"]), len(ratio["histogram"]["counts"])), (3, 5))
        self.assertEqual(chosen["worst_criterion"], "EdgeLengthRatio")
        preset = self.inspect(BALL, preset="finite volume")
        self.assertEqual(preset["preset"], "Finite volume")
        self.assertTrue(all(c["curve"]["weight_percent"] for c in preset["criteria"]))
        limits = {c["name"]: c["acceptable"] for c in preset["criteria"]}
        self.assertEqual(limits["MaxNonOrthogonality"], [None, 70.0])
        of_preset = self.inspect(FLANGE, preset="FEM tetrahedra")["criteria"]
        angle = next(c for c in of_preset if c["name"] == "MinDihedralAngle")
        self.assertEqual(
            angle["acceptable"], [40.0, None], "the preset's limit, not the default of 20"
        )

    def test_ranges(self):
        """Ranges of a file come before those of the preset; its criteria are evaluated, too."""
        path = self.folder / "solver.txt"
        path.write_text("# ours\nMinSolidAngle 1.5 *\nMaxNonOrthogonality - 33\nVolume * *\n")
        for preset in (None, "Finite volume"):
            summary = self.inspect(BALL, preset=preset, ranges=path)
            criteria = {c["name"]: c for c in summary["criteria"]}
            self.assertEqual(summary["ranges"], str(path))
            self.assertEqual(criteria["MaxNonOrthogonality"]["acceptable"], [None, 33])
            self.assertEqual(criteria["MaxNonOrthogonality"]["acceptable_source"], "solver.txt")
            angle = criteria["MinSolidAngle"]
            self.assertEqual(
                (angle["acceptable"], angle["acceptable_is_hint"]), ([1.5, None], False)
            )
            quality = simple.ElementQuality(Input=self.open(BALL), Criteria=["MinSolidAngle"])
            angles = vtk_to_numpy(self.fetch(quality).GetCellData().GetArray("MinSolidAngle"))
            self.assertEqual(angle["below"], int((angles < 1.5).sum()))
            self.assertGreater(angle["below"], 0)
            self.assertEqual(criteria["Volume"]["acceptable"], [None, None])
            self.assertEqual(criteria["MinVolumeRatio"]["acceptable"], [0.01, None])
        in_lines = self.inspect(BALL, preset=preset, ranges=path.read_text().splitlines())
        self.assertEqual(in_lines["ranges"], path.read_text().splitlines())
        for entry in in_lines["criteria"]:
            known = criteria[entry["name"]]
            if known["acceptable_source"] == "solver.txt":
                known["acceptable_source"] = "set by the user"
            self.assertEqual(entry, known)
        named = self.inspect(BALL, criteria=["Volume"], ranges=path)
        self.assertEqual([c["name"] for c in named["criteria"]], ["Volume"])

    def test_long_work_is_announced(self):
        """A line says how long it takes where that is long, and nothing where it is not."""
        said = []
        self.inspect(BALL, criteria=["Volume"], say=said.append)
        self.assertEqual(said, [])
        quality = simple.ElementQuality(Input=self.open(BALL))
        estimates = []
        for criteria in (["Volume"], ["Volume", "MinSolidAngle"], ["all"]):
            evaluation.choose_criteria(quality, None, criteria)
            quality.UpdatePropertyInformation()
            estimates.append(quality.SMProxy.GetProperty("EstimatedSeconds").GetElement(0))
        self.assertGreater(estimates[0], 0)
        self.assertLess(estimates[0], estimates[1])
        self.assertLess(estimates[1], estimates[2])
        with unittest.mock.patch.object(evaluation, "LONG", estimates[0] / 2):
            self.inspect(BALL, criteria=["Volume"], say=said.append)
        self.assertEqual(said, ["the criteria take about 1 s for 800 cells"])

    def test_wrong_ranges(self):
        """The error gives file, line and the most similar name; nothing is written."""
        path = self.folder / "solver.txt"
        path.write_text("Volume 0 *\nMinSolidAngel 0.5 *\n")
        folder = self.folder / "none"
        run = camaron_testing.run_command("inspect", BALL, "--ranges", path, "-o", folder)
        self.assertEqual(run.returncode, 2)
        self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
        self.assertRegex(run.stderr, r"solver\.txt:2: .*MinSolidAngel.*did you mean MinSolidAngle")
        self.assertFalse(folder.exists())
        with self.assertRaisesRegex(RuntimeError, "nowhere"):
            self.inspect(BALL, ranges=self.folder / "nowhere")
        with self.assertRaisesRegex(RuntimeError, "Ranges:2: .*expected the upper limit"):
            self.inspect(BALL, ranges=["Volume 0 *", "MinSolidAngle 0.5"])
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        for special in (pipe, "/dev/zero"):
            with self.assertRaisesRegex(
                RuntimeError, "expected a file of ranges, found a pipe or a device"
            ):
                self.inspect(BALL, ranges=special)

    def test_errors(self):
        with self.assertRaisesRegex(ValueError, "MinDihedral: did you mean MinDihedralAngle"):
            self.inspect(BALL, criteria=["MinDihedral"])
        with self.assertRaisesRegex(ValueError, "did you mean Finite volume"):
            self.inspect(BALL, preset="finite volumes")
        with self.assertRaisesRegex(ValueError, "exclude each other"):
            self.inspect(BALL, preset="VEM", criteria=["Volume"])
        with self.assertRaisesRegex(RuntimeError, "no such file"):
            self.inspect(self.folder / "none.visf")
        truncated = self.folder / "truncated.visf"
        truncated.write_bytes(BALL.read_bytes()[:5000])
        with self.assertRaisesRegex(RuntimeError, r"truncated\.visf:\d*"):
            self.inspect(truncated)
        table = self.folder / "table.csv"
        table.write_text("a,b\n1,2\n")
        with self.assertRaisesRegex(RuntimeError, "not a mesh"):
            self.inspect(table)
        self.assertFalse((self.folder / "report").exists(), "nothing is left behind")

    def test_the_mesh_is_not_replaced(self):
        mesh = camaron_testing.write_vtk(
            self.folder / "a.vtk", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(5, (0, 1, 2))]
        )
        inspect(mesh, self.folder / "report", with_pictures=False)
        inside = self.folder / "report" / "mesh.vtu"
        before = inside.read_bytes()
        with self.assertRaisesRegex(ValueError, "this file is read"):
            inspect(inside, self.folder / "report", with_pictures=False)
        self.assertEqual(inside.read_bytes(), before)

    def test_earlier_report(self):
        """A report replaces the one before it, its mesh of another format included."""
        self.inspect(BALL)
        (self.folder / "report" / "mine.txt").write_text("stays")
        single = camaron_testing.write_vtk(
            self.folder / "a.vtk", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(5, (0, 1, 2))]
        )
        surface = self.folder / "a.stl"
        convert(single, surface)
        self.inspect(surface)
        self.assertEqual(
            sorted(path.name for path in (self.folder / "report").iterdir()),
            ["mesh.vtp", "mine.txt", "report.html", "summary.json", "worst.csv"],
        )

    def test_stages(self):
        """Each stage reports its time; omitted stages take none."""
        said = []
        summary = self.inspect(BALL, verbose=True, with_mesh=False, say=said.append)
        names = [
            re.fullmatch(r"(.+) took \d+\.\d\d s \(\d+\.\d\d s of processor time\)", line)[1]
            for line in said
        ]
        self.assertEqual(
            names,
            "loading the plugin,reading,evaluating,statistics,boundary and totals,writing the report".split(
                ","
            ),
        )
        self.assertNotIn("mesh", summary["files"])
        self.assertFalse((self.folder / "report" / "mesh.vtu").exists())
        said.clear()
        self.inspect(BALL, verbose=True, say=said.append)
        self.assertIn(
            "writing the mesh", said[-2]
        )  # before the report, which notes names that are changed
        self.assertIn("writing the report", said[-1])
        said.clear()
        self.inspect(BALL, say=said.append)
        self.assertEqual(said, [])

    def test_progress(self):
        """Each stage is shown while it lasts; after reading, with an estimate of the remaining time that reaches zero."""
        said = []
        with Progress(said.append) as progress:
            self.inspect(BALL, progress=progress)
        stages = [*dict.fromkeys(words.split(",")[0] for words in said)]
        expected = (
            "loading the plugin,reading,evaluating,statistics,boundary and totals,writing the mesh"
        )
        self.assertEqual(stages, [*expected.split(","), "writing the report"])
        for words in said[said.index(next(w for w in said if w.startswith("evaluating"))) :]:
            self.assertRegex(words, r"^[a-z ]+, about \d+ s left$")
        self.assertLess(progress.seconds_left(), 1)
        with Progress(said.append) as progress:
            progress.expect(evaluating=100.0, cells=10, criteria=1)
            progress.begin("evaluating")
            progress.share = 0.25
            progress.began -= 50  # half as fast as expected
            self.assertAlmostEqual(
                progress.seconds_left(), 150 + 2 * (sum(progress.expected.values()) - 100), -1
            )

    def test_without_display(self):
        """The report is written anyway, and gives the reason for missing pictures."""
        done = camaron_testing.run_command(
            "inspect", RING, "-o", "r", cwd=self.folder, without=["DISPLAY"]
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        has_pictures = bool(Page((self.folder / "r" / "report.html").read_text("utf-8")).sources)
        self.assertEqual(has_pictures, "There are no pictures" not in done.stdout)

    def test_no_sources_are_left(self):
        """A session that inspects many meshes does not fill up."""
        before = len(simple.GetSources())
        self.inspect(BALL)
        with self.assertRaises(ValueError):
            self.inspect(BALL, criteria=["Nothing"])
        self.assertEqual(len(simple.GetSources()), before)

    def test_source_of_the_pipeline(self):
        """An Element Quality has the numbers of its file, another source those of its cells."""
        reader = simple.OpenDataFile(str(FLANGE))
        quality = simple.ElementQuality(Input=reader, Criteria=["Volume", "MinDihedralAngle"])
        half = simple.Clip(Input=reader)
        try:
            ours = self.inspect(quality)
            theirs = self.inspect(FLANGE, criteria=["Volume", "MinDihedralAngle"])
            ours.pop("generated"), theirs.pop("generated")
            theirs["files"].pop("mesh", None), ours["files"].pop("mesh", None)
            self.assertEqual(ours, theirs)
            self.inspect(quality, criteria=["Area"])
            self.assertEqual(list(quality.Criteria), ["Volume", "MinDihedralAngle"])
            clipped = self.inspect(half, criteria=["Volume"], with_mesh=False)
            self.assertEqual(clipped["mesh"]["path"], None)
            self.assertTrue(clipped["mesh"]["name"].startswith("Clip"))
            half.UpdatePipeline()
            cells = half.GetDataInformation().GetNumberOfCells()
            self.assertEqual(clipped["criteria"][0]["count"], cells)
        finally:
            for source in (half, quality, reader):
                simple.Delete(source)

    def test_color_maps_of_the_session(self):
        """A report leaves them as they are."""
        table = simple.GetColorTransferFunction("MinDihedralAngle")
        before = list(table.RGBPoints)
        self.inspect(FLANGE, with_pictures=True, criteria=["MinDihedralAngle"])
        self.assertEqual(list(table.RGBPoints), before)

    def test_command(self):
        """Table, exit status, JSON, several meshes of which one is bad."""
        run = lambda *a: camaron_testing.run_command(
            "inspect", "--no-pictures", *a, cwd=self.folder
        )
        table = run(BALL, "--criteria", "Volume,EdgeLengthRatio")
        self.assertEqual((table.returncode, table.stderr), (0, ""))
        self.assertRegex(
            table.stdout, r"(?m)^  EdgeLengthRatio +800 [^>]*$", "no range for polyhedra"
        )
        self.assertRegex(table.stdout, r"(?m)^  Volume +800 ")
        self.assertIn("No cell is outside the acceptable range.", table.stdout)
        (self.folder / "own.txt").write_text("EdgeLengthRatio 0.9 *")
        table = run(BALL, "--criteria", "EdgeLengthRatio", "--ranges", "own.txt", "-o", "there")
        self.assertRegex(table.stdout, r"(?m)^! EdgeLengthRatio +800 .* 800 +100$")
        self.assertIn(
            "800 of 800 cells (100 %) are outside the acceptable range of EdgeLengthRatio",
            table.stdout,
        )
        self.assertTrue((self.folder / "voronoi-ball-report" / "report.html").exists())
        printed = run(BALL, "--criteria", "Volume", "--json", "-o", "there")
        self.assertEqual(json.loads(printed.stdout)["criteria"][0]["name"], "Volume")
        several = run(RING, "none.visf", FLANGE, "-o", "all")
        self.assertEqual(several.returncode, 2)
        self.assertEqual(several.stderr, "camaron: none.visf: there is no such file\n")
        self.assertEqual(
            sorted(p.name for p in (self.folder / "all").iterdir()), ["flange", "polygon-ring"]
        )
        wrong = run(BALL, "--criteria", "Volum")
        self.assertEqual((wrong.returncode, wrong.stdout), (2, ""))
        self.assertEqual(wrong.stderr, "camaron: unknown criterion Volum: did you mean Volume?\n")


@camaron_testing.require_display()
class TestPictures(camaron_testing.TestCase):
    def pictures(self, mesh, **options):
        """The pictures of a report, as arrays of pixels."""
        self.summary = inspect(mesh, self.folder / "report", **options)
        return report_pictures(self.folder / "report" / "report.html")

    def test_pictures(self):
        """Pictures filled by the mesh or a part of it, in the colors of the map."""
        for mesh in (BALL, FLANGE, RING):
            colored, worst, close = self.pictures(mesh)
            for picture in (colored, worst, close):
                self.assertEqual(picture.shape, (900, 1200, 3))
                drawn = numpy.any(picture < 250, axis=2)
                columns, rows = numpy.flatnonzero(drawn.any(axis=0)), numpy.flatnonzero(
                    drawn.any(axis=1)
                )
                if picture is not close:  # a cell and its neighbors may stand upright
                    self.assertLess(columns[0], 100, mesh)
                self.assertGreater(drawn.mean(), 0.2, mesh)
                self.assertGreater(
                    max(numpy.ptp(rows) / 900, numpy.ptp(columns[columns < 1000]) / 1000), 0.85
                )
            # Red, as only cells outside the range are: some in the first, few in the second.
            shown = picture_criterion(self.summary["criteria"])
            red = [
                ((p[..., 0] > 90) & (p[..., 1] < 70) & (p[..., 2] < 70)).mean()
                for p in (colored, worst, close)
            ]
            self.assertEqual(min(red) > 0.001, shown["out_of_range"] > 0, (mesh, red))
            self.assertLess(max(red[1:]), 0.2, mesh)

    def test_fewer_pictures(self):
        """The first ones are those of before, whatever else is taken."""
        every = self.pictures(FLANGE)
        self.assertEqual(len(every), 3)
        for most in (1, 2):
            fewer = self.pictures(FLANGE, most_pictures=most)
            self.assertEqual(len(fewer), most)
            for a, b in zip(fewer, every):
                numpy.testing.assert_array_equal(a, b)

    def test_without_values(self):
        """A mesh without a criterion that applies is shown plainly."""
        path = camaron_testing.write_vtk(
            self.folder / "line.vtk", [(0, 0, 0), (1, 1, 0)], [(3, (0, 1))]
        )
        (picture,) = self.pictures(path)
        self.assertGreater(int(numpy.any(picture < 250, axis=2).sum()), 500)


if __name__ == "__main__":
    camaron_testing.main()
