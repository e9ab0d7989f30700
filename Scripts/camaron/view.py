# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Startup script of ParaView's window that opens and shows the files of `camaron view`.

    PYTHONPATH=Scripts CAMARON_VIEW=mesh.visf paraview --script Scripts/camaron/view.py

CAMARON_VIEW contains one file name per line, because a startup script has no arguments.
"""

import os
import sys

from camaron.common import pipeline
from paraview import simple


def show(path: str, view) -> None:
    """Opens a mesh and shows it."""
    if path.endswith(".pvsm"):
        simple.LoadState(path)
        return
    source = pipeline.open_mesh(path, "first").source
    simple.RenameSource(os.path.basename(path), source)
    simple.Show(source, view).SetRepresentationType("Mesh Inspection")
    simple.SetActiveSource(source)


def main() -> None:
    pipeline.load_plugin()
    view = simple.GetActiveViewOrCreate("RenderView")
    for path in os.environ.pop("CAMARON_VIEW", "").splitlines():
        try:
            show(os.path.abspath(path), view)
        except (RuntimeError, ValueError) as error:
            print(f"camaron: {error}", file=sys.stderr)
    simple.ResetCamera(view)
    simple.Render(view)


main()
