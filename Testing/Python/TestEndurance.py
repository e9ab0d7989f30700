# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes opened, evaluated, shown and closed again and again, after which ParaView is as large as before.

CAMARON_CYCLES is the number of cycles, by default 50:

    CAMARON_CYCLES=1000 ./camaron test -R TestEndurance
"""

import gc
import os
import resource
import sys
import unittest

import camaron_testing
from paraview import simple

CYCLES = int(os.environ.get("CAMARON_CYCLES", "50"))
#: Kilobytes that a cycle may leave behind. Cycles of ParaView's own Sphere, Cell Size and Surface leave some 20, and the mesh
#: of a cycle takes more than 1000.
MOST = 200
MESHES = [camaron_testing.EXAMPLES / name for name in ("voronoi-ball.visf", "flange.visf")]


def kilobytes():
    """Memory of this process."""
    gc.collect()
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * resource.getpagesize() // 1024


@unittest.skipUnless(sys.platform == "linux", "memory and descriptors are read as on Linux")
@camaron_testing.require_display()
class TestEndurance(camaron_testing.TestCase):
    def cycle(self, path):
        mesh = self.open(path)
        quality = simple.ElementQuality(Input=mesh)
        tables = [
            simple.QualityStatistics(Input=quality),
            simple.CheckQuality(Input=mesh, Rules="Volume > 0"),
            simple.SelectElements(Input=quality, Strategy="Worst N"),
        ]
        for table in tables:
            table.UpdatePipeline()
        display = simple.Show(quality, self.view)
        display.SetRepresentationType("Mesh Inspection")
        display.GlassShell = 1
        simple.ResetCamera(self.view)
        simple.Render(self.view)
        self.assertGreater(display.SMProxy.GetRepresentedDataInformation().GetNumberOfCells(), 0)
        simple.Hide(quality, self.view)
        for proxy in (*tables, quality, mesh):
            simple.Delete(proxy)

    def test_cycles(self):
        self.view = simple.CreateRenderView(ViewSize=[200, 150])
        for i in range(10):  # what is made once
            self.cycle(MESHES[i % 2])
        size, files = kilobytes(), len(os.listdir("/proc/self/fd"))
        for i in range(CYCLES):
            self.cycle(MESHES[i % 2])
        growth = (kilobytes() - size) / CYCLES
        print(f"{CYCLES} cycles, {growth:.1f} kB each", file=sys.stderr)
        self.assertLess(growth, MOST)
        self.assertEqual(len(os.listdir("/proc/self/fd")), files)


if __name__ == "__main__":
    camaron_testing.main()
