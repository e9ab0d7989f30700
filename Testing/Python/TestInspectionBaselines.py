# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scenes of Mesh Inspection look as their stored pictures, also on other drivers (TestInspectionDrivers)."""

import itertools
import os
from pathlib import Path

import camaron_testing
import inspection_scenes
from inspection_testing import difference, read_picture

#: Drivers round differently, and decide otherwise about pixels whose middle the edge of a face just touches.
TOLERANCE = 0.01
#: Mesa's softpipe loses lines beyond the first few thousand vertices, and has points of another shape.
BEYOND_SOFTPIPE = {"edges-alone", "isosurfaces-edges", "normals-of-vertices", "points"}


@camaron_testing.require_display()
class TestInspectionBaselines(camaron_testing.TestCase):
    def test_scenes(self):
        """A picture that differs is left in the working folder, to be looked at."""
        scenes = inspection_scenes.Scenes()
        is_softpipe = os.environ.get("GALLIUM_DRIVER") == "softpipe"
        for name in sorted(set(inspection_scenes.SCENES) - (BEYOND_SOFTPIPE if is_softpipe else set())):
            with self.subTest(name):
                expected = read_picture(inspection_scenes.BASELINES / f"{name}.png")
                found = scenes.picture(name)
                part = difference(found, expected)
                if part >= TOLERANCE:
                    inspection_scenes.write(Path.cwd() / f"{name}-found.png", found)
                self.assertLess(part, TOLERANCE)
                self.assertGreater(difference(expected, expected * 0 + 255), 0.03)  # there is something

    def test_each_scene_shows_something_else(self):
        stored = {path.stem: read_picture(path) for path in inspection_scenes.BASELINES.glob("*.png")}
        self.assertEqual(set(stored), set(inspection_scenes.SCENES))
        for name, other in itertools.combinations(sorted(stored), 2):
            with self.subTest(name, other=other):
                self.assertGreater(difference(stored[name], stored[other]), 2 * TOLERANCE)


if __name__ == "__main__":
    camaron_testing.main()
