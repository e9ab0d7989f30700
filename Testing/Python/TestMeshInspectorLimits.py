# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""In ParaView's window: limits that are typed, and meshes of more cells than the Mesh Inspector reads by itself."""

import html
import json
import re
import shlex
import shutil
import sys
import unittest

import camaron_testing

from inspection_testing import read_picture
from window_testing import (
    PROPERTIES,
    WINDOW,
    WindowTestCase,
    add_filter,
    apply,
    check,
    choose,
    edit,
    event,
    open_file,
)

from TestMeshInspector import PLOT, card, drag, open_card, start

LOWER = card("Histogram", "Limits/Lower")
RETURN = "16777220"

SET_LIMIT = """
from paraview import simple
simple.GetSettingsProxy("MeshInspectorSettings").AutomaticLimit = 100
"""


#: Writes the applied range of Select Elements.
RANGE = """
from paraview import simple
proxy = simple.GetActiveSource().SMProxy
names = ("Range", "LowerLimit", "UpperLimit")
with open(PATH, "w") as file:
    file.write(" ".join(proxy.GetProperty(name).GetElement(0) or "-" for name in names))
"""

#: Evaluates a preset by its own name, as in the Properties panel.
PRESET = """
from paraview import simple
quality = next(s for s in simple.GetSources().values() if s.GetXMLName() == "ElementQuality")
quality.Preset = "General"
quality.UpdatePipeline()
"""

#: Writes the color map of the mesh.
POINTS = """
import json
from paraview import simple
display = simple.GetDisplayProperties(simple.GetActiveSource())
with open(PATH, "w") as file:
    json.dump(list(display.LookupTable.RGBPoints), file)
"""

#: Press of Alt+Up, which moves the upper handle wherever the width of the panel puts it: type of the
#: event, key, modifiers, text, repetition, count.
ALT_UP = f"6,{0x01000013},{0x08000000},,0,1"


class TestMeshInspectorLimits(WindowTestCase):
    def test_fields(self):
        """Handle and verdict follow while a limit is typed; the range of the criterion comes back. Invalid limits revert
        to the previous ones. Elements that await evaluation have none."""
        upper = card("Histogram", "Limits/Upper")
        self.play(
            *start(),
            check(PLOT, "acceptableLow", "20"),
            check(LOWER, "text", "20"),
            event(LOWER, "set_string", "1e400"),
            check(PLOT, "acceptableLow", "20"),
            event(LOWER, "set_string", "30,5"),
            check(PLOT, "acceptableLow", "30.5"),
            event(LOWER, "set_string", "30"),
            check(PLOT, "acceptableLow", "30"),
            event(LOWER, "key", RETURN),
            event(card("Histogram", "Criterion"), "set_string", "Maximum dihedral angle"),
            check(PLOT, "acceptableHigh", "165"),
            event(card("Histogram", "Criterion"), "set_string", "Minimum dihedral angle"),
            check(PLOT, "acceptableLow", "30"),
            check(card("Histogram", "Limits/ResetLimits"), "enabled", "true"),
            event(LOWER, "set_string", ""),
            event(LOWER, "key", RETURN),
            event(card("Histogram", "Criterion"), "set_string", "Maximum dihedral angle"),
            event(card("Histogram", "Criterion"), "set_string", "Minimum dihedral angle"),
            check(PLOT, "acceptableLow", "-inf"),
            event(card("Histogram", "Limits/ResetLimits"), "activate"),
            check(PLOT, "acceptableLow", "20"),
            check(LOWER, "text", "20"),
            check(card("Histogram", "Limits/ResetLimits"), "enabled", "false"),
            event(card("Histogram", "Criterion"), "set_string", "Maximum dihedral angle"),
            event(LOWER, "set_string", "20"),
            event(LOWER, "set_string", "200"),
            check(PLOT, "acceptableLow", "20"),
            event(LOWER, "key", RETURN),
            check(LOWER, "text", ""),
            check(PLOT, "acceptableLow", "-inf"),
            event(upper, "set_string", "-"),
            check(PLOT, "acceptableHigh", "165"),
            event(upper, "key", RETURN),
            check(upper, "text", "165"),
            check(card("Histogram", "Limits/ResetLimits"), "enabled", "false"),
            event(card("Criteria", "Elements"), "set_string", "Faces"),
            check(upper, "enabled", "false"),
            check(upper, "text", ""),
            event(card("Criteria", "Elements"), "set_string", "Cells"),
            check(upper, "text", "165"),
        )

    def test_colors(self):
        """Colors and legend of the mesh have their step at the limits that the user sets, until they are undone or reset, and
        again when the criterion is chosen again. A handle that is dragged does the same."""
        self.require_events()
        points = self.folder / "points.json"
        pictures = [self.folder / f"{i}.png" for i in range(6)]
        take = [event(f"{WINDOW}/centralwidget", "picture", path) for path in pictures]
        choose_criterion = lambda name: event(card("Histogram", "Criterion"), "set_string", name)
        self.play(
            *start(),
            take[0],
            event(LOWER, "set_string", "30"),
            event(LOWER, "key", RETURN),
            take[1],
            edit("Undo"),
            check(PLOT, "acceptableLow", "20"),
            check(LOWER, "text", "20"),
            take[2],
            edit("Redo"),
            check(PLOT, "acceptableLow", "30"),
            take[3],
            choose_criterion("Maximum dihedral angle"),
            choose_criterion("Minimum dihedral angle"),
            take[4],
            event(card("Histogram", "Limits/ResetLimits"), "activate"),
            take[5],
            event(PLOT, "drag", "20,40,handles,0"),
            check(PLOT, "acceptableLow", "40"),
            *self.script("points", POINTS.replace("PATH", repr(str(points)))),
        )
        first, moved, *others = map(read_picture, pictures)
        changed = (first != moved).any(axis=2)
        self.assertGreater(changed.sum(), 1000)
        for expected, found in zip((first, moved, moved, first), others):
            self.assertTrue((expected == found).all())
        values = json.loads(points.read_text())[::4]
        step = values.index(40)
        self.assertLess(values[step] - values[step - 1], 1e-3)

    def test_report(self):
        """A report has one set of ranges, those of the panel: the findings, tables and groups, and the command
        of a finding selects as many cells. The range of faces is a rule only. A preset of Element Quality does not judge. The
        trace writes the same report."""
        report, trace = self.folder / "report", self.folder / "trace.py"
        elements = card("Criteria", "Elements")
        upper = card("Histogram", "Limits/Upper")
        save = [
            event(card("Report", "ReportFolder"), "set_string", str(report)),
            event(card("Report", "SaveReport"), "activate"),
        ]
        events = [
            *start(),
            event(LOWER, "set_string", "30"),
            event(LOWER, "key", RETURN),
            event(card("Histogram", "Criterion"), "set_string", "Volume"),
            event(upper, "set_string", "0.001"),
            event(upper, "key", RETURN),
            event(elements, "set_string", "Faces"),
            event(card("Criteria", "Tree"), "setTreeItemCheckState", "4,0,2"),
            event(card("Criteria", "Evaluate"), "activate"),
            event(card("Histogram", "Criterion"), "set_string", "Non-orthogonality"),
            event(upper, "set_string", "20"),
            event(upper, "key", RETURN),
            *open_card("Report"),
            check(card("Report", "SaveReport"), "enabled", "false"),
            event(elements, "set_string", "Cells"),
            check(card("Report", "SaveReport"), "enabled", "true"),
        ]
        preset = self.script("preset", PRESET)
        self.play(*self.traced(trace, *events, *preset, *save))
        summary = json.loads((report / "summary.json").read_text("utf-8"))
        criteria = {c["name"]: c for c in summary["criteria"]}
        checks = {c["criterion"]: c for c in summary["checks"]}
        self.assertEqual(checks.keys(), {"MinDihedralAngle", "Volume", "NonOrthogonality"})
        self.assertEqual(
            summary["ranges"], ["MinDihedralAngle 30 *", f"Volume {sys.float_info.min!r} 0.001"]
        )
        self.assertIsNone(summary["preset"])
        self.assertEqual(criteria["MinDihedralAngle"]["acceptable"], [30, None])
        self.assertEqual(criteria["MaxDihedralAngle"]["acceptable"], [None, 165])
        page = (report / "report.html").read_text("utf-8")
        commands = re.findall(r"<code>(camaron select .*? -o cells.csv)</code>", page)
        for name in ("MinDihedralAngle", "Volume"):
            failing = checks[name]["failing"]
            self.assertGreater(failing, 0)
            self.assertEqual(criteria[name]["out_of_range"], failing)
            self.assertEqual(sum(g["out_of_range"] for g in criteria[name]["groups"]), failing)
            (command,) = (c for c in commands if f"Array={name}" in c)
            words = shlex.split(html.unescape(command))
            done = camaron_testing.run_command(*words[1:-2], cwd=report)
            self.assertIn(f"By criterion: {failing} cells", done.stdout)
        # As many as the column Bad counts, by the same ranges.
        bad = [f"{c['name']} {c['out_of_range']}" for c in criteria.values() if c["out_of_range"]]
        failing = checks["NonOrthogonality"]["failing"]
        self.assertGreater(failing, 0)
        counts = card("Criteria", "Tree")
        self.play(
            *events,
            check(counts, "badCounts", ", ".join(bad)),
            event(elements, "set_string", "Faces"),
            check(counts, "badCounts", f"NonOrthogonality {failing}"),
        )
        shutil.rmtree(report)
        self.replay(trace, "")
        again = json.loads((report / "summary.json").read_text("utf-8"))
        self.assertEqual(again["criteria"], summary["criteria"])

    def test_large_mesh(self):
        """Cards ask before they read all cells, once for these cells and all steps of selection."""
        compute = [card(name, "Compute") for name in ("Criteria", "Histogram", "Worst")]
        self.play(
            *self.script("limit", SET_LIMIT),
            *start(),
            check(PLOT, "binCounts", ""),
            *(check(button, "text", "Compute for 4080 cells") for button in compute),
            event(card("Mesh", "Validate"), "activate"),
            event(compute[1], "activate"),
            *(check(button, "visible", "false") for button in compute),
            *drag(5, 2000),
            check(PLOT, "brushedCount", "4080"),
            *open_card("Selection"),
            event(card("Selection", "SelectWorst"), "activate"),
            *(check(button, "visible", "false") for button in compute),
            check(card("Mesh", "Validity"), "visible", "true"),
            check(card("Mesh", "Validate"), "visible", "false"),
        )

    def test_select_elements(self):
        """The histogram in the panel of Select Elements: a moved handle is a change that awaits Apply."""
        before, after = self.folder / "before.txt", self.folder / "after.txt"
        widget = f"{PROPERTIES}/criterion_range"
        self.play(
            *open_file("flange.visf"),
            apply(),
            *add_filter("ElementQuality"),
            apply(),
            *add_filter("SelectElements"),
            check(f"{widget}/Plot", "acceptableHigh", "0.9"),
            event(f"{widget}/Plot", "keyEvent", ALT_UP),
            check(f"{widget}/Range", "currentText", "Custom"),
            *self.script("before", RANGE.replace("PATH", repr(str(before)))),
            apply(),
            *self.script("after", RANGE.replace("PATH", repr(str(after)))),
            choose("criterion_range/UpperLimit", "1.5"),
            check(f"{widget}/Plot", "acceptableHigh", "1.5"),
            choose("criterion_range/Range", "Acceptable"),
            check(f"{widget}/Plot", "acceptableHigh", "0.9"),
        )
        self.assertEqual(before.read_text(), "Acceptable - -")
        choice, low, high = after.read_text().split()
        self.assertEqual((choice, low), ("Custom", "-"))
        self.assertGreater(float(high), 0.9)


if __name__ == "__main__":
    unittest.main()
