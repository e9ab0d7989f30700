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


def pictures(folder):
    """Events that take the pictures of the cards."""
    return [event(f"{CARDS}/{name}", "picture", str(folder / f"{name}.png")) for name in NAMES]


def texts():
    """Events that fail where a text is cut off."""
    return [
        line
        for width in (320, 700)
        for line in (event(DOCK, "width", width), event(CARDS, "texts"))
    ]


class TestMeshInspectorPictures(WindowTestCase):
    def compare(self, folder, stored):
        """Pictures in a folder with those in a folder of BASELINES."""
        fonts = [font(path / f"{NAMES[0]}.png") for path in (stored, folder)]
        if fonts[0] != fonts[1]:
            self.skipTest(f"the stored pictures have another font: {fonts[0]}, here {fonts[1]}")
        for name in NAMES:
            with self.subTest(f"{stored.name}/{name}"):
                path = folder / f"{name}.png"
                one, other = read_picture(path), read_picture(stored / f"{name}.png")
                if one.shape != other.shape or difference(one, other) > TOLERANCE:
                    shutil.copy(path, Path.cwd() / f"{stored.name}-{name}-found.png")
                self.assertEqual(one.shape, other.shape)
                self.assertLess(difference(one, other), TOLERANCE)

    def test_cards(self):
        """Pictures, and no text cut off. Another palette, chosen while the window is open, reaches icons, links,
        verdicts and histograms."""
        self.require_events()
        light, dark = self.folder / "light", self.folder / "dark"
        light.mkdir()
        dark.mkdir()
        width = event(DOCK, "width", WIDTH)
        self.play(
            *fill(),
            width,
            *pictures(light),
            *texts(),
            width,
            event(DOCK, "palette", "dark"),
            *pictures(dark),
        )
        self.compare(light, BASELINES / "Cards")
        self.compare(dark, BASELINES / "DarkCards")

    def test_scaled(self):
        """No text cut off at a scale of 2."""
        self.require_events()
        self.play(*fill(), *texts(), environment={"QT_SCALE_FACTOR": "2"})


if __name__ == "__main__":
    unittest.main()
