# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mesh quality from Python; runs in pvpython and pvbatch with the plugin Camaron.

>>> import camaron
>>> summary = camaron.inspect("part.visf", "part-report")
>>> summary["worst_criterion"]
'MinDihedralAngle'
>>> camaron.check("part.visf", "fem.rules")["verdict"]
'fail'
>>> camaron.compare("before.visf", "after.visf")["worse"]
['MaxNonOrthogonality']
>>> camaron.convert("part.visf", "part.vtu")
[]
"""

from .checking import check
from .common.pipeline import load_plugin
from .comparison import compare
from .conversion import convert
from .inspection import inspect
from .select_elements import select

__all__ = ["check", "compare", "convert", "inspect", "load_plugin", "select"]
