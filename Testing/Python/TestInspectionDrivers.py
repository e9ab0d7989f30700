# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mesh Inspection with no more than OpenGL 3.2, as on some computers.

Mesa does as it is told; other drivers do not know its variables, and run the same tests once more. Mesa's
softpipe is of no use here: it loses what a geometry shader writes, beyond the first few thousand rows.
"""

import os
from pathlib import Path
from unittest import mock

import camaron_testing

OPENGL_3_2 = {"MESA_GL_VERSION_OVERRIDE": "3.2", "MESA_GLSL_VERSION_OVERRIDE": "150"}


@camaron_testing.require_display()
class TestInspectionDrivers(camaron_testing.TestCase):
    def test_opengl_3_2(self):
        for script in ("TestMeshInspection.py", "TestIsosurfaces.py"):
            with self.subTest(script), mock.patch.dict(os.environ, OPENGL_3_2):
                camaron_testing.run_alone(Path(__file__).with_name(script), timeout=200)


if __name__ == "__main__":
    camaron_testing.main()
