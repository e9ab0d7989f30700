# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by ParaView's window as it starts: opens and shows the files that `camaron view` names.

ParaView's own command line would open them too, but leave the first Apply to be pressed."""

import os

from paraview import simple


def show(path):
    if path.endswith(".pvsm"):
        simple.LoadState(path)
        return
    reader = simple.OpenDataFile(path)
    if reader is None:
        raise RuntimeError(f"{path}: no reader knows this file")
    simple.RenameSource(os.path.basename(path), reader)
    simple.Show(reader)
    simple.SetActiveSource(reader)


for path in filter(None, os.environ.pop("CAMARON_VIEW", "").split("\n")):
    show(os.path.abspath(path))
if simple.GetActiveView():
    simple.ResetCamera()
    simple.Render()
