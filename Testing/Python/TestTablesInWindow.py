# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""In ParaView's window: the filters that make tables are changed, undone and redone; their trace and state come back."""

import json
import xml.etree.ElementTree as ElementTree

import camaron_testing
from window_testing import (
    WINDOW,
    WindowTestCase,
    add_filter,
    apply,
    choose,
    edit,
    event,
    open_file,
    save_state,
)

BROWSER = f"{WINDOW}/pipelineBrowserDock/pipelineBrowser"
DIALOG = f"{WINDOW}/SelectInputDialog"
#: Place of Element Quality in the pipeline browser.
QUALITY = "/0:0/0:0/0:0"
FILTERS = ("QualityStatistics", "CorrelateQuality", "CompareQuality")

#: All tables, without columns of text.
LIST = """
import json
from paraview import servermanager, simple
found = {}
for name in ("QualityStatistics1", "CorrelateQuality1", "CompareQuality1"):
    proxy = simple.FindSource(name)
    table = servermanager.Fetch(proxy, idx=0)
    rows = []
    for i in range(table.GetNumberOfRows()):
        rows.append([table.GetRow(i).GetValue(c).ToString() for c in range(table.GetNumberOfColumns())])
    found[name] = rows
with open(PATH, "w") as file:
    json.dump(found, file)
"""


def pick(view, place):
    return [
        event(view, "mousePress", f"1,1,0,5,5,{place}"),
        event(view, "mouseRelease", f"1,0,0,5,5,{place}"),
    ]


def make_tables(*edits):
    """Makes the three filters, and groups the rows of each after it has been applied; then edits that."""
    change = [choose("GroupBy/ComboBox", "Cell type"), apply(), *map(edit, edits)]
    return [
        *open_file("flange.visf"),
        apply(),
        *add_filter("ElementQuality"),
        apply(),
        *add_filter("QualityStatistics"),
        apply(),
        *change,
        *pick(BROWSER, QUALITY),
        *add_filter("CorrelateQuality"),
        apply(),
        *change,
        *pick(BROWSER, QUALITY),
        *add_filter("CompareQuality"),
        event(f"{DIALOG}/buttonFrame/Other", "set_boolean", "true"),
        *pick(f"{DIALOG}/pipelineView", QUALITY),
        event(f"{DIALOG}/buttonBox/1QPushButton0", "activate"),
        apply(),
        *change,
    ]


class TestTablesInWindow(WindowTestCase):
    def group_by(self, state):
        """GroupBy of each filter in a state file."""
        root = ElementTree.parse(state).getroot()
        found = {
            proxy.get("type"): proxy.find("Property[@name='GroupBy']/Element")
            for proxy in root.iter("Proxy")
        }
        return {name: value.get("value") for name, value in found.items() if value is not None}

    def list(self, name):
        return self.script(
            f"list-{name}", LIST.replace("PATH", repr(str(self.folder / f"{name}.json")))
        )

    def found(self, name):
        return json.loads((self.folder / f"{name}.json").read_text())

    def test_undo(self):
        state = (
            self.folder / "undone.pvsm"
        )  # at the end, as saving one forgets what could be undone
        self.play(*make_tables("Undo"), *save_state(state))
        self.assertEqual(self.group_by(state), {name: "None" for name in FILTERS})

    def test_redo_and_replay(self):
        state, trace = self.folder / "redone.pvsm", self.folder / "trace.py"
        self.play(
            *self.traced(trace, *make_tables("Undo", "Redo"), *self.list("first")),
            *save_state(state),
        )
        self.assertEqual(self.group_by(state), {name: "Cell type" for name in FILTERS})
        first = self.found("first")
        for name, rows in first.items():
            self.assertTrue(any("Tetra" in row for row in rows), name)
        self.play(*self.list("second"), options=[f"--state={state}"])
        self.assertEqual(self.found("second"), first)
        self.replay(trace, LIST.replace("PATH", repr(str(self.folder / "third.json"))))
        self.assertEqual(self.found("third"), first)


if __name__ == "__main__":
    camaron_testing.main()
