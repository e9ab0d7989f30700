# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of Mesh Inspection whose cells and points at the border of two processes depend on both: the pictures of a
server of three processes are those of one."""

import camaron_testing
import inspection_scenes
import TestClientServer
from inspection_testing import difference
from paraview import simple

SCENES = (
    "complete-shrunk",
    "exploded",
    "interior",
    "interior-shrunk",
    "normals-of-vertices",
    "smooth-shading",
)


class ScenesOfFile(inspection_scenes.Scenes):
    """The ball alone, from a file, distributed over the processes."""

    def __init__(self, path):
        self.path = path
        super().__init__()
        self.view.RemoteRenderThreshold = 0

    def make_meshes(self):
        shared = simple.RedistributeDataSet(Input=simple.OpenDataFile(str(self.path)))
        return {"ball": simple.GhostCells(Input=shared)}


@camaron_testing.require_display()
class TestInspectionRanks(camaron_testing.TestCase):
    serve = TestClientServer.TestClientServer.serve

    def test_scenes(self):
        path = self.folder / "ball.vtu"
        alone = inspection_scenes.Scenes()
        simple.SaveData(str(path), alone.meshes["ball"])
        expected = {name: alone.picture(name) for name in SCENES}
        self.serve(3)
        scenes = ScenesOfFile(path)
        for name in SCENES:
            with self.subTest(name):
                self.assertLess(difference(scenes.picture(name), expected[name]), 0.002)
                self.assertGreater(difference(expected[name], expected[name] * 0 + 255), 0.03)
        simple.Disconnect()


if __name__ == "__main__":
    camaron_testing.main()
