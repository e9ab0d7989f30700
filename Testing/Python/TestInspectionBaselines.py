# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scenes of Mesh Inspection look as their stored pictures, also on other drivers (TestInspectionDrivers)."""

import itertools
import os
import unittest
from pathlib import Path

import camaron_testing
import inspection_scenes
from inspection_testing import difference, read_picture

#: Drivers round differently, and decide otherwise about pixels whose middle the edge of a face just touches.
TOLERANCE = 0.01
#: Each mode once, for Mesa's softpipe, which is slow, loses lines beyond the first few thousand vertices, and has points of
#: another shape.
OF_SOFTPIPE = {
    "back-faces",
    "cells-selected",
    "cut-border",
    "cut-by-half-spaces",
    "cut-exactly-values",
    "depth",
    "edges-wide",
    "emphasis",
    "exploded",
    "glass",
    "glass-isosurfaces",
    "height",
    "ids-of-cells",
    "interior-shrunk",
    "isolines-cut",
    "mixed-shrunk",
    "normals-of-faces",
    "smooth-shading",
    "surface",
    "tetrahedra",
    "translucent",
    "two-colors",
}
IS_SOFTPIPE = os.environ.get("GALLIUM_DRIVER") == "softpipe"


@camaron_testing.require_display()
class TestInspectionBaselines(camaron_testing.TestCase):
    def test_scenes(self):
        """A picture that differs is left in the working folder, to be looked at."""
        scenes = inspection_scenes.Scenes()
        for name in sorted(OF_SOFTPIPE if IS_SOFTPIPE else inspection_scenes.SCENES):
            with self.subTest(name):
                expected = read_picture(inspection_scenes.BASELINES / f"{name}.png")
                found = scenes.picture(name)
                part = difference(found, expected)
                if part >= TOLERANCE:
                    inspection_scenes.write(Path.cwd() / f"{name}-found.png", found)
                self.assertLess(part, TOLERANCE)
                self.assertGreater(
                    difference(expected, expected * 0 + 255), 0.03
                )  # there is something

    @unittest.skipIf(IS_SOFTPIPE, "the stored pictures are the same for all drivers")
    def test_each_scene_shows_something_else(self):
        stored = {
            path.stem: read_picture(path) for path in inspection_scenes.BASELINES.glob("*.png")
        }
        self.assertEqual(set(stored), set(inspection_scenes.SCENES))
        for name, other in itertools.combinations(sorted(stored), 2):
            with self.subTest(name, other=other):
                self.assertGreater(difference(stored[name], stored[other]), 2 * TOLERANCE)


if __name__ == "__main__":
    camaron_testing.main()
