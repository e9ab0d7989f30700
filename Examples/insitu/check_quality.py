# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
# script-version: 2.0
"""A ParaView Catalyst script that checks the mesh of a running simulation.

At every step it tests the rules below on the channel "input" and prints the verdict. Every
INTERVAL steps, and at the first step that fails, it writes to FOLDER: the table of verdicts, the
worst cells of each rule, and a picture colored by the first criterion; no picture where ParaView
would need a display and there is none. To try it, let ParaView play a series of files as if it were
a simulation:

    mpiexec -n 2 pvbatch --sym -m paraview.demos.filedriver_miniapp \\
        -g "steps/*.vtu" -s Examples/insitu/check_quality.py

The plugin must be found by name, or PV_PLUGIN_PATH be set; CAMARON_INSITU_FOLDER and
CAMARON_INSITU_INTERVAL replace the folder and the interval.
"""

import csv
import os
from pathlib import Path

from paraview import print_info
from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkIntArray
from vtkmodules.vtkRenderingCore import vtkRenderWindow

RULES = """
Volume > 0
MinDihedralAngle >= 10 tolerate 1%
"""
CRITERION = "MinDihedralAngle"
#: Values and colors (red, green, blue) of the picture, from bad to good.
COLORS = [0, 0.49, 0.06, 0.13, 10, 0.84, 0.33, 0.18, 30, 0.95, 0.89, 0.73, 70, 0.9, 0.93, 0.94]
SIZE = [800, 600]
FOLDER = Path(os.environ.get("CAMARON_INSITU_FOLDER", "quality"))
INTERVAL = int(os.environ.get("CAMARON_INSITU_INTERVAL", "10"))

if "CheckQuality" not in globals():
    LoadDistributedPlugin("Camaron", ns=globals())

mesh = TrivialProducer(registrationName="input")
check = CheckQuality(registrationName="check", Input=mesh, Rules=RULES, NumberOfWorst=10)
quality = ElementQuality(Input=mesh, Criteria=[CRITERION])
has_failed = False
#: A ParaView that draws by X ends the simulation if it finds no display.
CAN_DRAW = bool(os.environ.get("DISPLAY")) or not vtkRenderWindow().IsA("vtkXOpenGLRenderWindow")


def make_view():
    """The mesh with edges, colored by the criterion: bad cells are dark."""
    view = CreateView("RenderView")
    view.ViewSize = SIZE
    display = Show(quality, view)
    display.Representation = "Mesh Inspection"
    colors = GetColorTransferFunction(CRITERION)
    colors.AutomaticRescaleRangeMode = "Never"  # pictures of all steps have the same colors
    colors.RGBPoints = COLORS
    # No ColorBy: in ParaView 6.1 it waits forever if a rank has no cells.
    display.ColorArrayName = ["CELLS", CRITERION]
    display.LookupTable = colors
    display.SetScalarBarVisibility(view, True)
    view.ResetActiveCameraToNegativeZ()
    GetActiveCamera().Elevation(-40)
    GetActiveCamera().Azimuth(30)
    return view


def write_table(table, path):
    """A table of process 0 as CSV."""
    columns = [table.GetColumn(c) for c in range(table.GetNumberOfColumns())]
    with open(path, "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file)
        rows.writerow([column.GetName() for column in columns])
        for row in range(table.GetNumberOfRows()):
            rows.writerow([column.GetValue(row) for column in columns])


def share(flag):
    """The flag of process 0, on all ranks."""
    value = vtkIntArray()
    value.InsertNextValue(int(flag))
    controller = servermanager.vtkProcessModule.GetProcessModule().GetGlobalController()
    controller.Broadcast(value, 0)
    return bool(value.GetValue(0))


view = None


def catalyst_execute(info):
    """Called at every step, on all ranks."""
    global view, has_failed
    check.UpdatePipeline(info.time)
    output = check.GetClientSideObject().GetOutputDataObject
    verdicts = output(0)  # complete on process 0
    verdict = verdicts.GetFieldData().GetAbstractArray("Verdict")
    is_first = servermanager.vtkProcessModule.GetProcessModule().GetPartitionId() == 0
    if is_first:
        print_info(f"step {info.cycle}, time {info.time:g}: {verdict.GetValue(0)}")
    fails = share(is_first and verdict.GetValue(0) == "fail")
    fails_now = fails and not has_failed
    has_failed = has_failed or fails
    if info.cycle % INTERVAL and not fails_now:
        return
    if is_first:
        FOLDER.mkdir(parents=True, exist_ok=True)
        write_table(verdicts, FOLDER / f"verdicts_{info.cycle:06}.csv")
        write_table(output(1), FOLDER / f"worst_{info.cycle:06}.csv")
    if not CAN_DRAW:
        return
    view = view or make_view()
    view.ViewTime = info.time
    Render(view)  # else the camera would be set for the mesh of the last picture
    ResetCamera(view)
    SaveScreenshot(str(FOLDER / f"quality_{info.cycle:06}.png"), view, ImageResolution=SIZE)
