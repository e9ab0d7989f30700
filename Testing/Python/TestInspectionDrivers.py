# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mesh Inspection with no more than OpenGL 3.2, and with another compiler of shaders.

Mesa makes both; other drivers do not know its variables, and run the same tests once more.
"""

import os
from pathlib import Path
from unittest import mock

import camaron_testing

DRIVERS = {
    "OpenGL 3.2": {"MESA_GL_VERSION_OVERRIDE": "3.2", "MESA_GLSL_VERSION_OVERRIDE": "150"},
    "softpipe": {"GALLIUM_DRIVER": "softpipe"},
}
# Softpipe writes the triangles of one isosurface over those of another.
SCRIPTS = {
    "OpenGL 3.2": ["TestMeshInspection.py", "TestIsosurfaces.py"],
    "softpipe": ["TestMeshInspection.py"],
}


@camaron_testing.require_display()
class TestInspectionDrivers(camaron_testing.TestCase):
    def test_drivers(self):
        for name, variables in DRIVERS.items():
            for script in SCRIPTS[name]:
                with self.subTest(name, script=script), mock.patch.dict(os.environ, variables):
                    camaron_testing.run_alone(Path(__file__).with_name(script), timeout=200)


if __name__ == "__main__":
    camaron_testing.main()
