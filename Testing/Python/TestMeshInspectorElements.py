# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""In ParaView's window: faces, edges and vertices in the Mesh Inspector, as cells are."""

import unittest

from inspection_testing import read_picture

from window_testing import (
    WINDOW,
    WindowTestCase,
    apply,
    check,
    edit,
    event,
    open_file,
    show_inspector,
)

from TestMeshInspector import CARDS, PLOT, card, drag, open_card
from TestMeshInspector import start as start_cells

#: Writes what the active view shows: the label of the active source's port, what colors it, and whether small values are
#: darker.
SHOWN = """
from paraview import simple
display = simple.GetDisplayProperties(simple.GetActiveSource())
colors = display.LookupTable
with open(PATH, "w") as file:
    name = simple.GetActiveSource().SMProxy.GetXMLName()
    points = list(colors.RGBPoints)
    file.write(" ".join([name, display.ColorArrayName[1], str(sum(points[1:4]) < sum(points[-3:]))]))
"""


def start(elements, ticks, criterion):
    """A flange with criteria of some elements evaluated, by their rows in the list."""
    return [
        *open_file("flange.visf"),
        apply(),
        show_inspector(),
        event(card("Criteria", "Elements"), "set_string", elements),
        *(event(card("Criteria", "Tree"), "setTreeItemCheckState", f"{row},0,2") for row in ticks),
        event(card("Criteria", "Evaluate"), "activate"),
        event(card("Histogram", "Criterion"), "set_string", criterion),
    ]


def worst(elements):
    return check(card("Worst", "Rows"), "currentText", f"Worst {elements}")


class TestMeshInspectorElements(WindowTestCase):
    def shown(self, path):
        return self.script("shown", SHOWN.replace("PATH", repr(str(path))))

    def play_elements(self, nouns, events, summary, ids, options=()):
        """Flies to the worst, selects all by their bars, and exports their ids."""
        self.play(
            *events,
            worst(nouns),
            *open_card("Element"),
            event(card("Worst", "Next"), "activate"),
            check(card("Element", "Summary"), "text", summary),
            check(card("Worst", "Back"), "enabled", "true"),
            event(card("Worst", "Back"), "activate"),
            *open_card("Selection"),
            *drag(5, 2000),
            event(card("Selection", "ExportIds"), "activate"),
            event(f"{CARDS}/Selection/ExportSelection", "filesSelected", str(ids)),
            options=options,
        )

    def test_faces(self, options=()):
        """A range of their own, a worst list to fly along, a brush, and the ids of all faces."""
        ids, shown = self.folder / "ids.txt", self.folder / "shown.txt"
        self.play_elements(
            "faces",
            [
                *start("Faces", [4, 8], "Non-orthogonality"),
                *self.shown(shown),
                check(card("Criteria", "Tree"), "ticks", "NonOrthogonality VolumeRatio"),
                check(PLOT, "acceptableHigh", "70"),
                event(card("Histogram", "CopyRule"), "activate"),
                check(card("Check", "Rules"), "plainText", "NonOrthogonality <= 70 of faces"),
            ],
            "Face 8686: quadrangle at -0.4497, 1.086, 0.245",
            ids,
            options,
        )
        self.assertEqual(shown.read_text(), "MeshElements NonOrthogonality False")
        self.assertEqual([int(line) for line in ids.read_text().split()], list(range(9480)))

    def test_faces_of_server(self):
        """The same on a server of two ranks: the same faces with the same ids."""
        self.test_faces(self.serve())

    def test_edges(self):
        """Small angles are dark; there is no range; the ids of edges."""
        ids, shown = self.folder / "ids.txt", self.folder / "shown.txt"
        self.play_elements(
            "edges",
            [
                *start("Edges", [0, 8], "Minimum dihedral angle"),
                *self.shown(shown),
                check(PLOT, "acceptableLow", "-inf"),
            ],
            "Edge 1429: line at -0.5382, 0.2229, 0.64",
            ids,
        )
        self.assertEqual(shown.read_text(), "MeshElements EdgeMinDihedralAngle True")
        self.assertGreater(len(ids.read_text().split()), 0)

    def test_element_types(self):
        """From cells to vertices, to edges, and back, without another filter. Cells have the criterion and colors again
        that they had before their faces were looked at."""
        faces, cells = self.folder / "faces.txt", self.folder / "cells.txt"
        self.play(
            *start("Vertices", [0], "Cells at the vertex"),
            worst("vertices"),
            event(card("Criteria", "Elements"), "set_string", "Edges"),
            worst("edges"),
            check(
                card("Criteria", "Tree"),
                "ticks",
                "EdgeLength EdgeCellCount EdgeFaceCount IsBoundary",
            ),
            event(card("Criteria", "Elements"), "set_string", "Cells"),
            worst("cells"),
            *start_cells(),
            event(card("Criteria", "Elements"), "set_string", "Faces"),
            event(card("Criteria", "Tree"), "setTreeItemCheckState", "4,0,2"),
            event(card("Criteria", "Evaluate"), "activate"),
            *self.script("faces", SHOWN.replace("PATH", repr(str(faces)))),
            event(card("Criteria", "Elements"), "set_string", "Cells"),
            check(card("Histogram", "Criterion"), "currentText", "Minimum dihedral angle"),
            *self.script("cells", SHOWN.replace("PATH", repr(str(cells)))),
        )
        self.assertEqual(faces.read_text(), "MeshElements NonOrthogonality False")
        self.assertEqual(cells.read_text(), "ElementQuality MinDihedralAngle True")

    def test_legend(self):
        """Undo and redo of Mesh Elements leave colors and legend as they were, and so does going back to the cells."""
        pictures = [self.folder / f"{i}.png" for i in range(6)]
        take = [event(f"{WINDOW}/centralwidget", "picture", path) for path in pictures]
        self.play(
            *start_cells(),
            take[0],
            event(card("Criteria", "Elements"), "set_string", "Faces"),
            event(card("Criteria", "Tree"), "setTreeItemCheckState", "4,0,2"),
            event(card("Criteria", "Evaluate"), "activate"),
            take[1],
            *[edit("Undo")] * 2,  # a tick evaluates, too
            take[2],
            *[edit("Redo")] * 2,
            take[3],
            event(card("Criteria", "Elements"), "set_string", "Cells"),
            take[4],
            edit("Undo"),
            take[5],
        )
        cells, faces, *others = map(read_picture, pictures)
        self.assertTrue((cells != faces).any())
        for i, (expected, found) in enumerate(zip((cells, faces) * 2, others)):
            with self.subTest(i):
                self.assertTrue((found == expected).all())


if __name__ == "__main__":
    unittest.main()
