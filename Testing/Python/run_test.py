# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a test: run_test.py SCRIPT ARGUMENTS. It starts in half of the time that the script alone would need."""

import os
import runpy
import sys
from pathlib import Path

runpy.run_path(str(Path(__file__).parents[2] / "Scripts" / "camaron" / "quick_start.py"))
os.environ.pop("CAMARON_LIBRARIES", None)  # not for programs that the test starts
del sys.argv[0]
sys.path.insert(0, str(Path(sys.argv[0]).parent))
runpy.run_path(sys.argv[0], run_name="__main__")
