# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""In ParaView's window: the shapes that cut a Mesh Inspection are dragged, undone and redone; the trace of that, run in
an empty window, gives the same shapes."""

import xml.etree.ElementTree as ElementTree

import camaron_testing
from window_testing import (
    DISPLAY,
    VIEWPORT,
    WINDOW,
    WindowTestCase,
    apply,
    edit,
    event,
    open_file,
    save_state,
)

#: From where to where each shape is dragged: the plane by its arrow.
DRAGS = (
    ("Plane", (0.73, 0.495), (0.72, 0.6)),
    ("Sphere", (0.65, 0.25), (0.6, 0.35)),
    ("Box", (0.65, 0.25), (0.6, 0.35)),
)

#: Properties of shapes that a drag changes.
PLACES = ("Origin", "Normal", "Center", "Radius", "Position", "Rotation", "Length")


def choose(name, value):
    return event(f"{DISPLAY}/{name}", "set_string", value)


def drag(first, last):
    """Left button down at one place of the view, up at another."""
    first, last = ("{:.3f},{:.3f}".format(*place) for place in (first, last))
    return [
        event(VIEWPORT, "mousePress", f"({first},1,1,0)"),
        event(VIEWPORT, "mouseMove", f"({last},1,0,0)"),
        event(VIEWPORT, "mouseRelease", f"({last},1,0,0)"),
    ]


def cut(*edits):
    """Cuts the example by one shape after the other, drags each and edits that."""
    events = [
        *open_file("voronoi-ball.visf"),
        apply(),
        event(f"{WINDOW}/cameraToolbar/actionNegativeZ", "activate"),
        choose("CutBy/ComboBox", "Centroid"),
        event(f"{DISPLAY}/CutHandles/CheckBox", "set_boolean", "true"),
    ]
    for shape, first, last in DRAGS:
        events += [
            choose("CutShape/ProxySelectionWidget/comboBox", shape),
            *drag(first, last),
            *map(edit, edits),
        ]
    return events


def shapes(state):
    """The shapes of the only representation in a state file: the type of the one that cuts, and the numbers of all."""
    proxies = {proxy.get("id"): proxy for proxy in ElementTree.parse(state).iter("Proxy")}
    (display,) = (
        proxy for proxy in proxies.values() if proxy.get("type") == "UnstructuredGridRepresentation"
    )
    chosen = display.find("Property[@name='CutShape']")
    numbers = {}
    for choice in chosen.find("Domain[@name='proxy_list']"):
        shape = proxies[choice.get("value")]
        for name in PLACES:
            elements = shape.findall(f"Property[@name='{name}']/Element")
            if elements:
                numbers[shape.get("type"), name] = [
                    float(element.get("value")) for element in elements
                ]
    return proxies[chosen.find("Proxy").get("value")].get("type"), numbers


class TestInspectInWindow(WindowTestCase):
    def test_undo(self):
        state = (
            self.folder / "undone.pvsm"
        )  # at the end, as saving one forgets what could be undone
        self.play(*cut("Undo"), *save_state(state), display=True)
        last, numbers = shapes(state)
        self.assertEqual(last, "CuttingBox")
        self.assertEqual(numbers["Plane", "Normal"], [1, 0, 0])
        self.assertEqual(numbers["CuttingBox", "Rotation"], [0, 0, 0])
        # Where they begin: the middle of the bounds, and the corner that is as far from it as the box is long.
        middle, corner = numbers["Plane", "Origin"], numbers["CuttingSphere", "Center"]
        self.assertEqual(numbers["CuttingBox", "Position"], middle)
        for i in range(3):
            self.assertAlmostEqual(corner[i], middle[i] + numbers["CuttingBox", "Length"][i] / 2)

    def test_redo_and_replay(self):
        state, trace = self.folder / "redone.pvsm", self.folder / "trace.py"
        self.play(*self.traced(trace, *cut("Undo", "Redo")), *save_state(state), display=True)
        last, numbers = shapes(state)
        self.assertEqual(last, "CuttingBox")
        self.assertNotEqual(numbers["Plane", "Normal"], [1, 0, 0])
        self.assertNotEqual(numbers["CuttingBox", "Rotation"], [0, 0, 0])
        self.assertLess(
            numbers["CuttingSphere", "Center"][1], numbers["CuttingBox", "Length"][1] / 2 - 0.1
        )
        again = self.folder / "replayed.pvsm"
        self.replay(trace, f"SaveState({str(again)!r})\n")
        last, replayed = shapes(again)
        self.assertEqual(last, "CuttingBox")
        self.assertEqual(replayed.keys(), numbers.keys())
        for key, values in numbers.items():
            for i, value in enumerate(values):
                self.assertAlmostEqual(replayed[key][i], value, 12, key)


if __name__ == "__main__":
    camaron_testing.main()
