# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by ParaView's window as it starts: opens and shows the files that `camaron view` names.

    PYTHONPATH=Scripts CAMARON_VIEW=mesh.visf paraview --script Scripts/camaron/view.py

CAMARON_VIEW holds one file name a line; a script of the window has no arguments.
"""

import os
import sys

from camaron import pipeline
from paraview import simple

VTK_POLYHEDRON = 42


def has_polyhedra(source) -> bool:
    """Whether there may be cells of which ParaView's own surface takes minutes to make."""
    quality = simple.ElementQuality(Input=source, Preset="Ticked criteria", Criteria=["CellTypeId"])
    quality.UpdatePipeline()
    types = quality.CellData["CellTypeId"]
    low, high = types.GetRange() if types else (0.0, 0.0)
    simple.Delete(quality)
    return low <= VTK_POLYHEDRON <= high


def show(path: str, view) -> None:
    """Opens a mesh and shows it; of polyhedra only the boundary, by Mesh Surface."""
    if path.endswith(".pvsm"):
        simple.LoadState(path)
        return
    source = pipeline.open_mesh(path, "first").source
    name = os.path.basename(path)
    simple.RenameSource(name, source)
    if has_polyhedra(source):
        simple.Hide(source, view)
        surface = simple.MeshSurface(registrationName=f"Surface of {name}", Input=source)
        display = simple.Show(surface, view)
    else:
        display = simple.Show(source, view)
    display.SetRepresentationType("Surface With Edges")
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
