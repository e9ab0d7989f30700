# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts of reports: numbers as text, histograms as SVG, the worst criterion, findings."""

import doctest
import re
import xml.etree.ElementTree as ElementTree

import camaron_testing
from camaron.commands import convert
from camaron.common import assessment, svg, tables, text


def criterion(name, values=(), better="bigger", ideal=1.0, limits=(None, None), **more):
    """A criterion with statistics of some values, as inspect makes it."""
    values = sorted(values)
    low, high = limits
    below = sum(low is not None and x < low for x in values)
    above = sum(high is not None and x > high for x in values)
    entry = {
        "name": name,
        "label": name,
        "applies_to": "polygons and polyhedra",
        "unit": "",
        "better": better,
        "ideal": ideal,
        "range": [0.0, 1.0],
        "acceptable": [low, high],
        "count": len(values),
        "applicable": len(values),
        "undefined": 0,
        "infinite": 0,
        "min": values[0] if values else None,
        "max": values[-1] if values else None,
        "quantiles": {"50": values[len(values) // 2]} if values else {},
        "acceptable_is_hint": False,
        "acceptable_for": "any cell",
        "consequence": "",
        "is_validity": False,
        "judged": len(values),
        "below": below,
        "above": above,
        "out_of_range": below + above,
        "histogram": {
            "edges": [],
            "counts": [],
            "underflow": 0,
            "overflow": 0,
            "undefined": 0,
            "infinite": 0,
        },
    }
    return {**entry, **more}


class TestReport(camaron_testing.TestCase):
    def test_examples_in_the_code(self):
        for module in (text, svg, convert):
            result = doctest.testmod(module)
            self.assertEqual(result.failed, 0, module.__name__)
        self.assertGreater(doctest.testmod(text).attempted, 5)

    def test_worst_criterion(self):
        """The rule of Documentation/inspect.md, step by step."""
        worst = lambda *criteria: (assessment.worst_criterion(list(criteria)) or {"name": None})[
            "name"
        ]
        some = criterion("Some", [0.1, 0.9, 0.9, 0.9], limits=(0.5, None))
        more = criterion("More", [0.4, 0.4, 0.9, 0.9], limits=(0.5, None))
        self.assertEqual(worst(some, more), "More", "the most cells outside")
        far = criterion("Far", [0.6] * 4, limits=(0.5, None))
        near = criterion("Near", [0.9] * 4, limits=(0.5, None))
        free = criterion("Free", [0.1] * 4)
        self.assertEqual(
            worst(near, far, free), "Far", "the farthest from ideal of those with limits"
        )
        self.assertEqual(
            worst(criterion("FreeToo", [0.9] * 4), free), "Free", "else of all with an ideal"
        )
        size = criterion("Size", [3.0], better="neither", ideal=None)
        angle = criterion("Angle", [3.0], better="bigger", ideal=None)
        self.assertEqual(worst(size, angle), "Angle", "else one with a direction")
        self.assertEqual(worst(size), "Size")
        undefined = criterion(
            "Undefined", [0.1] * 4, limits=(0.5, None), undefined=4, out_of_range=0
        )
        self.assertEqual(worst(undefined, size), "Size", "never one without values")
        self.assertEqual(worst(undefined), None)
        flat = criterion("Flat", [0.1] * 9, limits=(0.5, None), applies_to="polygons")
        solid = criterion("Solid", [0.1], limits=(0.5, None), applies_to="polyhedra")
        self.assertEqual(worst(flat, some), "Flat")
        self.assertEqual(worst(flat, solid), "Solid", "polygons do not matter beside polyhedra")

    def test_findings(self):
        summary = {"mesh": {"cells": 4}, "criteria": []}
        say = lambda *criteria: [
            f["text"] for f in assessment.findings({**summary, "criteria": list(criteria)})
        ]
        self.assertEqual(say(), ["None of the criteria applies to the cells of this mesh."])
        good = criterion("Good", [0.9] * 4, limits=(0.5, None))
        self.assertEqual(say(good), ["No cell is outside the acceptable range."])
        bad = criterion("Bad", [0.1, 0.9, 0.9, 0.9], limits=(0.5, None))
        self.assertEqual(
            [sentence.replace(text.THIN, " ") for sentence in say(good, bad)],
            ["1 of 4 cells (25 %) is outside the acceptable range of {} (≥ 0.5)."],
        )
        undefined = criterion("Undefined", [0.9] * 4, undefined=2)
        self.assertIn("{}: undefined for 2 cells.", say(undefined))
        whole = "No cell is outside the acceptable range."
        hint = criterion("Hint", [0.1] * 4, limits=(0.5, None), acceptable_is_hint=True)
        found = assessment.findings({**summary, "criteria": [good, hint]})
        self.assertEqual(
            [(f["text"] == whole, f["hint"]) for f in found], [(True, False), (False, True)]
        )
        other = criterion("Other", [0.1] * 4, limits=(0.5, None), judged=0, out_of_range=0)
        self.assertEqual(say(good, other), [whole], "a range for other shapes")
        few = criterion("Few", [0.1] + [0.9] * 3, limits=(0.5, None), is_validity=True)
        few.update(judged=2, acceptable_for="tetrahedra", consequence="flat")
        most = criterion("Most", [0.1] * 4, limits=(0.5, None))
        self.assertEqual(
            [
                f["criteria"][0]["name"]
                for f in assessment.findings({**summary, "criteria": [most, few]})
            ],
            ["Few", "Most"],
            "what nothing can use comes first",
        )
        self.assertEqual(
            say(few)[0].replace(text.THIN, " "),
            "1 of 2 tetrahedra (50 %) is outside the acceptable range of {} (≥ 0.5): flat.",
        )
        self.assertEqual(
            assessment.findings({"mesh": {"cells": 0}, "criteria": []})[0]["text"],
            "The mesh has no cells.",
        )

    def test_picture_criterion(self):
        """The picture has colors for most cells, if a criterion has values for these."""
        rare = criterion("Rare", [0.1] * 4, limits=(0.5, None), undefined=3, count=4)
        common = criterion("Common", [0.9] * 4, limits=(0.5, None))
        self.assertEqual(assessment.worst_criterion([rare, common])["name"], "Rare")
        self.assertEqual(assessment.picture_criterion([rare, common])["name"], "Common")
        self.assertEqual(assessment.picture_criterion([rare])["name"], "Rare")

    def shapes(self, c):
        """Bars of a histogram by color: list of (x, width, height)."""
        root = ElementTree.fromstring(svg.histogram(c, "clip"))
        bars = {}
        for group in root.iter("g"):
            bars[group.get("class")] = [
                tuple(float(rect.get(key)) for key in ("x", "width", "height"))
                for rect in group.iter("rect")
            ]
        return root, bars

    def test_histogram(self):
        """Heights are in proportion; a bin across the limit has both colors, clipped there."""
        histogram = {
            "edges": [0.0, 1.0, 2.0, 3.0],
            "counts": [10, 20, 5],
            "underflow": 0,
            "overflow": 0,
        }
        c = criterion(
            "C",
            [0.5] * 10 + [1.5] * 20 + [2.5] * 5,
            limits=(1.5, None),
            histogram={**histogram, "undefined": 0, "infinite": 0},
        )
        root, bars = self.shapes(c)
        self.assertEqual([len(bars["outside"]), len(bars["inside"])], [2, 2])
        heights = [h for _, _, h in bars["outside"]] + [bars["inside"][1][2]]
        self.assertAlmostEqual(heights[1] / heights[0], 2.0, places=2)
        self.assertAlmostEqual(heights[1] / heights[2], 4.0, places=2)
        clip = root.find("clipPath/rect")
        middle = bars["inside"][0][0] + 0.5 * bars["inside"][0][1]
        self.assertAlmostEqual(float(clip.get("x")), middle, places=0)
        self.assertIsNone(next((r for r in root.iter("rect") if r.get("class") == "apart"), None))

    def test_histogram_apart(self):
        """Undefined and infinite values have columns of their own, cells of other shapes have none."""
        histogram = {
            "edges": [],
            "counts": [],
            "underflow": 0,
            "overflow": 0,
            "undefined": 7,
            "infinite": 2,
        }
        c = criterion("C", histogram=histogram, count=9, applicable=5, undefined=7, infinite=2)
        root, _ = self.shapes(c)
        labels = [element.text for element in root.iter("text")]
        self.assertEqual(labels[labels.index("inf") + 1], "2")
        self.assertEqual(labels[labels.index("undefined") + 1], "3")
        self.assertIn("no finite value", labels)

    def test_histogram_of_integers(self):
        """Ticks are at the integers, not at the edges between them."""
        histogram = {
            "edges": [3.5, 4.5, 5.5],
            "counts": [3, 4],
            "underflow": 0,
            "overflow": 0,
            "undefined": 0,
            "infinite": 0,
        }
        root, _ = self.shapes(
            criterion("C", [4] * 3 + [5] * 4, better="neither", histogram=histogram)
        )
        labels = [element.text for element in root.iter("text")]
        self.assertIn("4", labels)
        self.assertIn("5", labels)
        self.assertFalse([label for label in labels if re.search(r"\.5", label)])

    def test_criteria_table(self):
        """Criteria and presets known to Python are those of the filter; the command lists them."""
        from paraview import simple

        quality = simple.ElementQuality(Input=simple.Sphere())
        known = tables.known_criteria()
        self.assertEqual(list(known), list(quality.GetProperty("Criteria").Available))
        self.assertEqual(
            list(tables.known_presets()), list(quality.GetProperty("Preset").Available)[1:]
        )
        self.assertEqual(
            (known["MinDihedralAngle"]["unit"], known["MinDihedralAngle"]["better"]),
            ("deg", "bigger"),
        )
        listed = camaron_testing.run_command("criteria")
        self.assertEqual(listed.returncode, 0)
        for name in known:
            self.assertRegex(listed.stdout, rf"(?m)^{name} ")
        one = camaron_testing.run_command("criteria", "volume")
        self.assertIn("acceptable > 0 (neither flat nor inverted)", one.stdout)


if __name__ == "__main__":
    camaron_testing.main()
