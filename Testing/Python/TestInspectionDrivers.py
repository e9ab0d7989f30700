# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mesh Inspection with no more than OpenGL 3.2, as on some computers, and with another driver, Mesa's softpipe.

Mesa does as it is told; other drivers do not know its variables, and run the same tests once more.
"""

import os
from pathlib import Path
from unittest import mock

import camaron_testing

OPENGL_3_2 = {"MESA_GL_VERSION_OVERRIDE": "3.2", "MESA_GLSL_VERSION_OVERRIDE": "150"}


@camaron_testing.require_display()
class TestInspectionDrivers(camaron_testing.TestCase):
    def test_opengl_3_2(self):
        self.run_with(OPENGL_3_2, "TestMeshInspection", "TestInspectionBaselines")

    def test_softpipe(self):
        self.run_with({"GALLIUM_DRIVER": "softpipe"}, "TestInspectionBaselines")

    def run_with(self, environment, *tests):
        for test in tests:
            with self.subTest(test), mock.patch.dict(os.environ, environment):
                camaron_testing.run_alone(Path(__file__).with_name(f"{test}.py"), timeout=400)


if __name__ == "__main__":
    camaron_testing.main()
