# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""In ParaView's window: the cards of the Mesh Inspector, filled, look as their stored pictures, and show all of their
texts at any width and scale.

The pictures are in Testing/Baselines/Cards and DarkCards. One that differs is left in the working folder, to be looked at; if the
change is meant, it replaces the stored one.
"""

import shutil
import unittest
from pathlib import Path

import camaron_testing
from inspection_testing import difference, read_picture
from TestMeshInspector import CARDS, DOCK, card, open_card, start
from vtkmodules.vtkIOImage import vtkPNGReader
from window_testing import WindowTestCase, event

BASELINES = camaron_testing.ROOT / "Testing" / "Baselines"
NAMES = (
    "Mesh",
    "Criteria",
    "Histogram",
    "Worst",
    "Element",
    "Selection",
    "Check",
    "View",
    "Report",
)
OPEN = ("Mesh", "Criteria", "Histogram", "Worst")  # at first
WIDTH = 360
#: Part of the pixels that may differ.
TOLERANCE = 0.001

RULES = "MinDihedralAngle >= 20\nCellAspectRatio <= 20\nVolume > 0 tolerate 0.1%"


def fill():
    """A flange, all cards open, and something in each."""
    return [
        *start(),
        *(line for name in NAMES if name not in OPEN for line in open_card(name)),
        event(card("Histogram", "Cumulative"), "activate"),
        event(card("Selection", "SelectWorst"), "activate"),
        event(card("Selection", "Grow"), "activate"),
        event(card("Check", "Rules"), "set_string", RULES),
        event(card("Check", "Check"), "activate"),
        event(card("Worst", "Next"), "activate"),
    ]


def font(path):
    """The font in which a picture was taken."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    first = [0, 0]
    reader.GetTextChunks("Font", first)
    return reader.GetTextValue(first[0]) if first[1] > first[0] else ""


class TestMeshInspectorPictures(WindowTestCase):
    def compare(self, names, folder, *events):
        """Pictures of cards, filled and then after some events, with those in a folder of BASELINES."""
        self.require_events()
        self.play(
            *fill(),
            event(DOCK, "width", WIDTH),
            *events,
            *(
                event(f"{CARDS}/{name}", "picture", str(self.folder / f"{name}.png"))
                for name in names
            ),
        )
        stored, found = (font(path / f"{names[0]}.png") for path in (folder, self.folder))
        if found != stored:
            self.skipTest(f"the stored pictures have another font: {stored}, here {found}")
        for name in names:
            with self.subTest(name):
                path = self.folder / f"{name}.png"
                one, other = read_picture(path), read_picture(folder / f"{name}.png")
                if one.shape != other.shape or difference(one, other) > TOLERANCE:
                    shutil.copy(path, Path.cwd() / f"{folder.name}-{name}-found.png")
                self.assertEqual(one.shape, other.shape)
                self.assertLess(difference(one, other), TOLERANCE)

    def test_pictures(self):
        self.compare(NAMES, BASELINES / "Cards")

    def test_dark(self):
        """Another palette, chosen while the window is open, reaches icons, links, verdicts and histograms."""
        self.compare(NAMES, BASELINES / "DarkCards", event(DOCK, "palette", "dark"))

    def test_texts(self):
        """Nothing is cut off."""
        for scale in (1, 2):
            with self.subTest(scale=scale):
                self.require_events()
                self.play(
                    *fill(),
                    *(
                        line
                        for width in (320, 700)
                        for line in (
                            event(DOCK, "width", width),
                            event(CARDS, "texts"),
                        )
                    ),
                    environment={"QT_SCALE_FACTOR": str(scale)},
                )


if __name__ == "__main__":
    unittest.main()
