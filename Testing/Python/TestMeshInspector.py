# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""In ParaView's window: the cards of the Mesh Inspector. What is brushed, selected, exported, saved and replayed are the
same cells."""

import csv
import json
import shutil
import unittest

import camaron
import camaron_testing
import numpy
from inspection_testing import report_pictures
from paraview import simple
from window_testing import (
    WINDOW,
    WindowTestCase,
    apply,
    check,
    edit,
    event,
    open_file,
    save_state,
    show_inspector,
)

DOCK = f"{WINDOW}/pqMeshInspectorPanel"
CARDS = f"{DOCK}/Scroll/qt_scrollarea_viewport/Cards"
PLOT = f"{CARDS}/Histogram/Content/Plot"

#: Qt's key modifiers, as in events of the mouse.
SHIFT, CTRL = 0x02000000, 0x04000000

#: Writes the number of selected cells of the active source, by a filter of which the window knows nothing.
COUNT = """
from paraview import servermanager, simple
source = simple.GetActiveSource()
extraction = servermanager.filters.ExtractSelection(Input=source)
extraction.Selection = servermanager._getPyProxy(source.GetSelectionInput(0))
extraction.UpdatePipeline()
with open(PATH, "w") as file:
    file.write(str(extraction.GetDataInformation().GetNumberOfCells()))
del extraction
"""

#: Selects a cell as a click in the view does.
PICK = """
from paraview import simple
simple.SelectIDs(IDs=[-1, 5], FieldType="CELL", Source=simple.GetActiveSource())
"""

#: Writes what a session has.
LEFT = """
from paraview import simple
with open(PATH, "w") as file:
    file.write(f"{len(simple.GetSources())} sources, {len(simple.GetRenderViews())} views, "
               f"{simple.GetActiveSource().GetXMLName()} active")
"""

#: A filter that changes the cells after an evaluation.
DEFORM = """
from paraview import simple
quality = simple.ElementQuality(Input=simple.GetActiveSource(), Criteria=["Volume"])
deformed = simple.Transform(Input=quality)
deformed.Transform.Scale = [1, 1, 3]
simple.Show(deformed)
simple.Render()
"""

#: Evaluates the mesh before the step of selection again, with other options.
OPTIONS = """
from paraview import simple
source = simple.GetActiveSource()
while source.GetXMLName() != "ElementQuality":
    source = source.Input
simple.SetActiveSource(source)
for name, value in DICT.items():
    setattr(source, name, value)
source.UpdatePipeline()
simple.Render()
"""

#: Writes the criteria of the first Element Quality, and whether there is another one.
EVALUATED = """
from paraview import simple
filters = [s for s in simple.GetSources().values() if s.GetXMLName() == "ElementQuality"]
first = min(filters, key=lambda s: s.GetGlobalID())
with open(PATH, "w") as file:
    file.write(f"{len(first.Criteria)} {len(filters) == 2}")
"""

#: Writes where the camera is, and how the mesh is cut and drawn.
SCENE = """
from paraview import simple
view = simple.GetActiveView()
display = simple.GetDisplayProperties(simple.GetActiveSource(), view)
hidden = view.SMProxy.GetProperty("HiddenRepresentations")
with open(PATH, "w") as file:
    file.write(json.dumps({
        "camera": [round(x, 6) for x in [*view.CameraPosition, *view.CameraFocalPoint]],
        "drawn": [str(display.CutBy), int(display.GlassShell), str(display.Representation)],
        "marked": sum(hidden.GetProxy(i).GetXMLName() == "GeometryRepresentation"
                      for i in range(hidden.GetNumberOfProxies())),
    }))
"""

#: Writes how many elements the steps of selection of a state select.
STEPS = """
from paraview import servermanager, simple
steps = [s for s in simple.GetSources().values() if s.GetXMLName() == "SelectElements"]
step = max(steps, key=lambda s: s.GetGlobalID())
step.UpdatePipeline()
simple.SetActiveSource(step)
step.UpdatePropertyInformation()
with open(PATH, "w") as file:
    file.write(str(step.GetPropertyValue("NumberOfSelectedElements")))
"""

#: Writes the memory of the window and of the mesh with its criteria in MB. From the first call on, servers render.
MEMORY = """
from paraview import simple
simple.GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = 0
source = simple.GetActiveSource()
with open("/proc/self/status") as file:
    sizes = dict(line.split(":") for line in file)
with open(PATH, "w") as file:
    json.dump({
        "window": int(sizes["VmHWM"].split()[0]) / 1000,
        "mesh": source.GetDataInformation().GetMemorySize() / 1000 if source else 0,
    }, file)
"""


def card(name, widget):
    return f"{CARDS}/{name}/Content/{widget}"


def open_card(name):
    """Opens a folded card."""
    title = f"{CARDS}/{name}/Title"
    return [
        event(title, "mousePress", "1,1,0,5,5"),
        event(title, "mouseRelease", "1,0,0,5,5"),
    ]


def start(example="flange.visf"):
    """The window with an example, the inspector in front, and the criteria of a preset evaluated."""
    return [
        *open_file(example),
        apply(),
        show_inspector(),
        event(card("Criteria", "Preset"), "set_string", "General"),
        event(card("Criteria", "Evaluate"), "activate"),
        event(card("Histogram", "Criterion"), "set_string", "Minimum dihedral angle"),
    ]


def drag(first, last, modifiers=0):
    """A drag of the mouse over the histogram, in pixels."""
    return [
        event(PLOT, "mousePress", f"1,1,{modifiers},{first},80"),
        event(PLOT, "mouseMove", f"0,1,{modifiers},{(first + last) // 2},80"),
        event(PLOT, "mouseMove", f"0,1,{modifiers},{last},80"),
        event(PLOT, "mouseRelease", f"1,0,{modifiers},{last},80"),
    ]


def double_click(view, row):
    """A double-click on an item of a list."""
    commands = (("mousePress", 1), ("mouseRelease", 0), ("mouseDblClick", 1), ("mouseRelease", 0))
    return [event(view, command, f"1,{held},0,10,10,/{row}:0") for command, held in commands]


class TestMeshInspector(WindowTestCase):
    def count(self, path):
        return self.script(f"count_{path.name}", COUNT.replace("PATH", repr(str(path))))

    def test_brush(self):
        """All bars are all cells: in the label, in the selection, in the exported lists. The dialog of ids, for a file
        of this computer, writes no table, which would be one of the server."""
        ids, table, other = (self.folder / name for name in ("ids.txt", "cells.csv", "ids.csv"))
        self.play(
            *start(),
            *drag(5, 2000),
            check(PLOT, "brushedCount", "4080"),
            check(card("Histogram", "Brush"), "text", "4080 of 4080 cells selected (100\u00a0%)"),
            *open_card("Selection"),
            event(card("Selection", "ExportIds"), "activate"),
            event(f"{CARDS}/Selection/ExportSelection", "filesSelected", str(ids)),
            event(card("Selection", "ExportTable"), "activate"),
            event(f"{CARDS}/Selection/ExportSelection", "filesSelected", str(table)),
            *drag(80, 160),
            event(card("Selection", "ExportIds"), "activate"),
            event(f"{CARDS}/Selection/ExportSelection", "filesSelected", str(other)),
            check(card("Selection", "Message"), "text", f"{other}: lists of ids are .txt files"),
        )
        self.assertFalse(other.exists())
        self.assertEqual([int(line) for line in ids.read_text().split()], list(range(4080)))
        with open(table, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(sorted(int(row["Id"]) for row in rows), list(range(4080)))
        angles = [float(row["MinDihedralAngle"]) for row in rows]
        self.assertEqual(angles, sorted(angles), "worst first")
        self.assertNotIn("Block", rows[0])

    def test_trace(self):
        """The report about the evaluated criteria, with pictures; nothing is left of it. Then brushes with all
        modifiers. In an empty window, their trace writes the report and selects as many cells."""
        names = ("report", "left", "selected", "replayed", "trace.py")
        report, left, selected, replayed, trace = (self.folder / name for name in names)
        report.mkdir()
        save = [
            *open_card("Check"),
            event(card("Check", "Rules"), "set_string", "Volume > 0\nMinDihedralAngle >= 20"),
            event(card("Check", "Tolerance"), "set_string", "1%"),
            event(card("Check", "Check"), "activate"),
            *open_card("Report"),
            event(card("Report", "ReportFolder"), "set_string", str(report)),
            event(card("Report", "SaveReport"), "activate"),
            *self.script("left", LEFT.replace("PATH", repr(str(left)))),
        ]
        brushes = [
            *drag(80, 160),
            *drag(180, 220, SHIFT),
            *drag(100, 110, CTRL),
            *drag(5, 200, SHIFT | CTRL),
        ]
        self.play(
            *self.traced(trace, *start(), *save, *brushes),
            *self.count(selected),
        )
        summary = json.loads((report / "summary.json").read_text("utf-8"))
        self.assertEqual(summary["mesh"]["cells"], 4080)
        self.assertIn("MinDihedralAngle", [c["name"] for c in summary["criteria"]])
        self.assertEqual([c["verdict"] for c in summary["checks"]], ["pass", "pass"])
        self.assertEqual(summary["checks"][1]["tolerance"], "1%")
        self.assertGreater(summary["checks"][1]["failing"], 0)
        pictures = report_pictures(report / "report.html")
        self.assertEqual(len(pictures), 3)
        for picture in pictures:
            drawn = numpy.any(picture < 250, axis=2).mean()
            self.assertGreater(drawn, 0.1)
            self.assertLess(drawn, 0.9)
        self.assertEqual(left.read_text(), "2 sources, 1 views, ElementQuality active")
        self.assertGreater(int(selected.read_text()), 0)
        shutil.rmtree(report)
        self.replay(trace, COUNT.replace("PATH", repr(str(replayed))))
        again = json.loads((report / "summary.json").read_text("utf-8"))
        self.assertEqual(again["criteria"], summary["criteria"])
        self.assertEqual(again["checks"], summary["checks"])
        self.assertEqual(replayed.read_text(), selected.read_text())

    def test_failing_and_picked(self):
        """A click on the verdict selects the cells that fail. A cell that is picked in the view, here after that step,
        is shown in Element, and is in the history before the step and the brush."""
        self.require_events()
        failing, picked, brushed, again = (self.folder / name for name in "abcd")
        quality = simple.ElementQuality(
            Input=self.open(camaron_testing.EXAMPLES / "flange.visf"), Criteria=["MinDihedralAngle"]
        )
        outside = simple.SelectElements(Input=quality, Array="MinDihedralAngle", Side="Failing")
        outside.UpdatePipeline()
        outside.UpdatePropertyInformation()
        verdict = card("Histogram", "Verdict")
        self.play(
            *start(),
            *drag(80, 160),
            *self.count(brushed),
            event(verdict, "mousePress", "1,1,0,180,8"),
            event(verdict, "mouseRelease", "1,0,0,180,8"),
            *self.count(failing),
            *self.script("pick", PICK),
            *self.count(picked),
            check(card("Element", "Id"), "text", "5"),
            check(card("Element", "CopyIds"), "enabled", "true"),
            *open_card("Selection"),
            event(card("Selection", "History"), "menu", "2"),
            *self.count(again),
        )
        expected = outside.GetPropertyValue("NumberOfSelectedElements")
        self.assertGreater(expected, 0)
        self.assertEqual(int(failing.read_text()), expected)
        self.assertEqual(picked.read_text(), "1")
        self.assertEqual(again.read_text(), brushed.read_text())

    def test_undo_of_steps(self):
        """A brush, a step and its undo: the brush is back; the same for a step taken back in the list."""
        brushed, undone = self.folder / "brushed", self.folder / "undone"
        taken = self.folder / "taken"
        self.require_events()
        self.play(
            *start(),
            *drag(80, 160),
            *self.count(brushed),
            *open_card("Selection"),
            event(card("Selection", "Grow"), "activate"),
            check(card("Selection", "Steps"), "count", "2"),
            edit("Undo"),
            *self.count(undone),
            check(card("Selection", "Steps"), "count", "1"),
            event(card("Selection", "Grow"), "activate"),
            event(card("Selection", "Invert"), "activate"),
            check(card("Selection", "Steps"), "count", "3"),
            event(card("Selection", "History"), "menu", "2"),
            *self.count(taken),
            check(card("Selection", "Steps"), "count", "1"),
            display=True,
        )
        self.assertGreater(int(brushed.read_text()), 0)
        self.assertEqual(undone.read_text(), brushed.read_text())
        self.assertEqual(taken.read_text(), brushed.read_text())

    def test_steps(self):
        """The list begins with the cell that was picked, also after it has grown twice. A double-click goes back to a step
        after something else was selected in the view, and to the picked cell."""
        counts = [self.folder / str(i) for i in range(4)]
        steps = card("Selection", "Steps")
        pick = self.script("pick", PICK)
        self.play(
            *start(),
            *open_card("Selection"),
            *pick,
            check(steps, "count", "1"),
            event(card("Selection", "Grow"), "activate"),
            event(card("Selection", "Grow"), "activate"),
            *self.count(counts[0]),
            check(steps, "count", "2"),
            *pick,
            *self.count(counts[1]),
            check(steps, "count", "3"),
            *double_click(steps, 1),
            *self.count(counts[2]),
            check(steps, "count", "2"),
            *double_click(steps, 0),
            *self.count(counts[3]),
            check(steps, "count", "1"),
        )
        grown, picked, again, first = (int(path.read_text()) for path in counts)
        self.assertGreater(grown, 4)
        self.assertEqual((picked, again, first), (1, grown, 1))

    def test_deformed(self):
        """Evaluate leaves the Element Quality before a filter that changes the cells as it is."""
        left = self.folder / "left"
        self.play(
            *open_file("flange.visf"),
            *self.script("deform", DEFORM),
            show_inspector(),
            event(card("Criteria", "Preset"), "set_string", "General"),
            event(card("Criteria", "Evaluate"), "activate"),
            *self.script("left", EVALUATED.replace("PATH", repr(str(left)))),
        )
        self.assertEqual(left.read_text(), "1 True")

    def test_worst(self):
        """A flight moves the camera and opens the mesh; Back restores both."""
        before, there, after = (self.folder / f"{name}.json" for name in "abc")
        write = lambda path: self.script(
            f"scene_{path.stem}", "import json\n" + SCENE.replace("PATH", repr(str(path)))
        )
        worst = lambda name: event(card("Worst", name), "activate")
        self.play(
            *start(),
            *write(before),
            worst("Next"),
            *write(there),
            worst("Next"),
            worst("Previous"),
            worst("Back"),
            *write(after),
            display=True,
        )
        before, there, after = (json.loads(path.read_text()) for path in (before, there, after))
        self.assertNotEqual(there["camera"], before["camera"])
        self.assertNotEqual(there["drawn"][0], before["drawn"][0])
        self.assertTrue(there["drawn"][1])
        self.assertEqual((before["marked"], there["marked"]), (0, 1))
        self.assertEqual(after, before)

    def test_state(self):
        """A state keeps the criteria and the steps of selection."""
        state, selected, loaded = (self.folder / n for n in ("s.pvsm", "selected", "loaded"))
        self.play(
            *start(),
            *open_card("Selection"),
            event(card("Selection", "SelectWorst"), "activate"),
            event(card("Selection", "Grow"), "activate"),
            *self.count(selected),
            *save_state(str(state)),
        )
        self.assertGreater(int(selected.read_text()), 41)  # a percent and its neighbors
        self.replay_state(state, STEPS.replace("PATH", repr(str(loaded))))
        self.assertEqual(loaded.read_text(), selected.read_text())

    def test_check(self):
        """Verdicts, errors at their line, and the selection of what fails; also of a mesh that was evaluated with other
        options, in the window and in a report."""
        failing, others = self.folder / "failing", self.folder / "others"
        options = {"DegeneracyTolerance": 0.3}
        rules = card("Check", "Rules")
        run = event(card("Check", "Check"), "activate")
        self.play(
            *start(),
            *open_card("Check"),
            event(rules, "set_string", "MinDihedralAngle >= 10\nMinDihedralAngel > 3"),
            run,
            check(
                f"{CARDS}/Check",
                "verdict",
                "Line 2: expected the name of a criterion, found 'MinDihedralAngel'; did you mean MinDihedralAngle?",
            ),
            event(rules, "set_string", "Volume > 0 of triangles"),
            run,
            check(f"{CARDS}/Check", "verdict", "empty"),
            event(rules, "set_string", "MinDihedralAngle >= 20\nVolume > 0"),
            run,
            check(f"{CARDS}/Check", "verdict", "fail"),
            event(card("Check", "Verdicts"), "mousePress", "1,1,0,10,10,/0:0"),
            event(card("Check", "Verdicts"), "mouseRelease", "1,0,0,10,10,/0:0"),
            *self.count(failing),
            *self.script("options", OPTIONS.replace("DICT", repr(options))),
            check(f"{CARDS}/Check", "verdict", ""),
            run,
            event(card("Check", "Verdicts"), "mousePress", "1,1,0,10,10,/0:0"),
            event(card("Check", "Verdicts"), "mouseRelease", "1,0,0,10,10,/0:0"),
            *self.count(others),
        )
        mesh = camaron_testing.EXAMPLES / "flange.visf"
        rules = ["MinDihedralAngle >= 20"]
        checked = camaron.check(mesh, rules)["checks"]
        self.assertEqual(int(failing.read_text()), checked[0]["failing"])
        quality = simple.ElementQuality(
            Input=self.open(mesh), Criteria=["MinDihedralAngle"], **options
        )
        report = camaron.inspect(
            quality, self.folder / "report", rules=rules, with_pictures=False, with_mesh=False
        )
        self.assertEqual(int(others.read_text()), report["checks"][0]["failing"])
        self.assertGreater(int(others.read_text()), int(failing.read_text()))

    def test_rules(self):
        """Names are completed while one types; the rules of a preset can be changed, and give the same verdicts."""
        rules, preset = card("Check", "Rules"), card("Check", "Preset")
        run = event(card("Check", "Check"), "activate")
        accept = event(rules, "key", "16777220")
        counts = "0/4080 2183/3264 4/3264 12/3264 514/3264 7/3264 0/3264"

        def typed(text):
            return [event(rules, "keyEvent", f"6,0,{ord(c.upper())},{c},0,1") for c in text]

        self.play(
            *start(),
            *open_card("Check"),
            check(card("Check", "EditPreset"), "enabled", "false"),
            *typed("m"),
            *typed("axdi"),
            check(rules, "offered", "MaxDihedralAngle, EdgeMaxDihedralAngle"),
            accept,
            check(rules, "plainText", "MaxDihedralAngle "),
            check(rules, "offered", ""),
            *typed(">0 of wed"),
            check(rules, "offered", "wedges"),
            accept,
            check(rules, "plainText", "MaxDihedralAngle >0 of wedges "),
            event(rules, "set_string", ""),
            event(preset, "set_string", "FEM tetrahedra"),
            run,
            check(f"{CARDS}/Check", "counts", counts),
            event(card("Check", "EditPreset"), "activate"),
            check(preset, "currentIndex", "0"),
            check(f"{CARDS}/Check", "counts", ""),
            run,
            check(f"{CARDS}/Check", "counts", counts),
        )

    def test_server(self):
        """The same on a server of two ranks: all bars are all cells."""
        options = self.serve()
        ids, table = self.folder / "ids.txt", self.folder / "cells.csv"
        self.play(
            *start(str(camaron_testing.EXAMPLES / "flange.visf")),
            *drag(5, 2000),
            check(PLOT, "brushedCount", "4080"),
            check(card("Histogram", "Brush"), "text", "4080 of 4080 cells selected (100\u00a0%)"),
            check(card("Criteria", "Tree"), "selectedCounts", "4080"),
            event(card("Worst", "Next"), "activate"),
            *open_card("Selection"),
            event(card("Selection", "ExportIds"), "activate"),
            event(f"{CARDS}/Selection/ExportSelection", "filesSelected", str(ids)),
            event(card("Selection", "ExportTable"), "activate"),
            event(f"{CARDS}/Selection/ExportSelection", "filesSelected", str(table)),
            options=options,
        )
        self.assertEqual([int(line) for line in ids.read_text().split()], list(range(4080)))
        with open(table, newline="", encoding="utf-8") as file:
            self.assertEqual(
                sorted(int(row["Id"]) for row in csv.DictReader(file)), list(range(4080))
            )

    def test_client_memory(self):
        """The mesh stays on the server, which also draws it: the window needs no memory for it."""
        options = self.serve()
        mesh = self.folder / "mesh.visf"
        wavelet = simple.Wavelet(WholeExtent=[0, 40] * 3)
        simple.SaveData(str(mesh), simple.Tetrahedralize(Input=wavelet))
        memory = lambda path: self.script(
            path.name, "import json\n" + MEMORY.replace("PATH", repr(str(path)))
        )
        before, after = self.folder / "before", self.folder / "after"
        steps = [*drag(5, 2000), event(card("Worst", "Next"), "activate")]
        self.play(
            *memory(self.folder / "first"),
            *start(str(camaron_testing.EXAMPLES / "flange.visf")),
            *steps,
            *memory(before),
            *start(str(mesh)),
            *steps,
            check(PLOT, "brushedCount", "320000"),
            *memory(after),
            options=options,
        )
        before, after = (json.loads(path.read_text()) for path in (before, after))
        self.assertGreater(after["mesh"], 100)
        self.assertLess(after["window"] - before["window"], after["mesh"] / 2)


if __name__ == "__main__":
    unittest.main()
