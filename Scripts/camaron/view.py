# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Startup script of ParaView's window that opens and shows the files of `camaron view`.

    PYTHONPATH=Scripts CAMARON_VIEW=mesh.visf paraview --script Scripts/camaron/view.py

CAMARON_VIEW contains one file name per line, because a startup script has no arguments; CAMARON_READER contains options of
their readers, NAME=VALUE.
"""

import os
import sys

from camaron.common import pipeline
from paraview import simple


def show(path: str, reader: dict, view) -> None:
    """Opens a mesh with options of its reader, and shows it."""
    if path.endswith(".pvsm"):
        simple.LoadState(path)
        return
    source = pipeline.open_mesh(path, "first", reader=reader).source
    simple.RenameSource(os.path.basename(path), source)
    is_first = not view.Representations
    simple.Show(source, view).SetRepresentationType("Mesh Inspection")
    simple.SetActiveSource(source)
    bounds = source.GetDataInformation().GetBounds()
    if is_first and all(low < high for low, high in zip(bounds[::2], bounds[1::2])):
        view.ApplyIsometricView()  # as the window does for a solid


def main() -> None:
    pipeline.load_plugin()
    view = simple.GetActiveViewOrCreate("RenderView")
    lines = os.environ.pop("CAMARON_READER", "").splitlines()
    reader = dict(line.split("=", 1) for line in lines)
    for path in os.environ.pop("CAMARON_VIEW", "").splitlines():
        try:
            show(os.path.abspath(path), reader, view)
        except (RuntimeError, ValueError) as error:
            print(f"camaron: {error}", file=sys.stderr)
    simple.ResetCamera(view)
    simple.Render(view)


main()
