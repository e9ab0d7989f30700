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

The plugin must be found by name, or PV_PLUGIN_PATH be set.

The first error on any rank, such as a folder that cannot be created, ends the check on all ranks: it
is printed once, and the filter "check" is deleted, so that nobody reads an old verdict. The
simulation goes on, or ends with status 2 if ON_ERROR is "stop". CAMARON_INSITU_FOLDER,
CAMARON_INSITU_INTERVAL and CAMARON_INSITU_ON_ERROR replace these settings; those of the first rank
count.
"""

import contextlib
import csv
import ctypes
import os
import re
from pathlib import Path

from paraview import print_error, print_info
from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkIntArray, vtkLogger, vtkOutputWindow, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController
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
INTERVAL = os.environ.get("CAMARON_INSITU_INTERVAL", "10")
ON_ERROR = os.environ.get("CAMARON_INSITU_ON_ERROR", "go on")

controller = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()


def least(number):
    """The least number of all ranks."""
    numbers = vtkIntArray(), vtkIntArray()
    for array in numbers:
        array.InsertNextValue(number)
    controller.AllReduce(*numbers, vtkCommunicator.MIN_OP)
    return numbers[1].GetValue(0)


def share(number):
    """The number of the first rank, on all ranks."""
    return least(number if RANK == 0 else 2**31 - 1)


def broadcast(text, rank):
    """The text of a rank, on all ranks."""
    table, column = vtkTable(), vtkStringArray()
    column.InsertNextValue(text)
    table.AddColumn(column)
    controller.Broadcast(table, rank)
    return table.GetColumn(0).GetValue(0)


#: Parts of errors that follow from another one, on this rank or another.
FOLLOWING = "another process failed|returned failure for request|error on a server process"


class CheckError(Exception):
    """Why the check ends; all ranks raise it at the same place."""


def together(work, *arguments):
    """Calls a function on all ranks, and returns its result; if it fails on any, all raise CheckError.

    What VTK reports meanwhile is an error, too, and not printed. All that a rank does between two
    steps for which ranks need each other is such a call: otherwise, if it failed on one, the others
    would wait forever.
    """
    result, problem, errors = None, "", []

    def note(_window, _event, text=""):
        text = re.sub(r"^ERROR: In .*?, line \d+\s*", "", text.strip())
        errors.append(" ".join(re.sub(r"^\S+ \(\w+\): ", "", text).split()))

    note.CallDataType = "string0"
    window, verbosity = vtkOutputWindow.GetInstance(), vtkLogger.GetCurrentVerbosityCutoff()
    observer, mode = window.AddObserver("ErrorEvent", note), window.GetDisplayMode()
    window.SetDisplayModeToNever()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    try:
        result = work(*arguments)
    except OSError as error:
        problem = f"{error.filename}: {error.strerror}" if error.filename else str(error)
    except Exception as error:
        problem = str(error) or type(error).__name__
    vtkLogger.SetStderrVerbosity(verbosity)
    window.SetDisplayMode(mode)
    window.RemoveObserver(observer)

    # The first rank that knows why, else the first that has failed.
    problems = [text for text in (problem, *errors) if text]
    reasons = [text for text in problems if not re.search(FOLLOWING, text)]
    reason = ": ".join(reasons[: 2 if problem in reasons else 1])
    place = least(RANK if reason else RANKS + RANK if problems else 2 * RANKS)
    if place < 2 * RANKS:
        raise CheckError(broadcast(reason or " ".join(problems), place % RANKS))
    return result


def prepare():
    """Creates the filters and looks at the settings."""
    global mesh, check, quality
    mesh = TrivialProducer(registrationName="input")
    require_mesh()
    if RANK == 0 and not re.fullmatch("0*[1-9][0-9]{0,8}", INTERVAL):
        raise ValueError(f"CAMARON_INSITU_INTERVAL: expected a number of steps, found '{INTERVAL}'")
    if RANK == 0 and ON_ERROR not in ("go on", "stop"):
        raise ValueError(f"CAMARON_INSITU_ON_ERROR: expected 'go on' or 'stop', found '{ON_ERROR}'")
    if "CheckQuality" not in globals():
        LoadDistributedPlugin("Camaron", ns=globals())
    quality = ElementQuality(Input=mesh)
    if CRITERION not in quality.GetProperty("Criteria").Available:
        raise ValueError(f"CRITERION: expected the name of a criterion, found '{CRITERION}'")
    quality.Criteria = [CRITERION]
    check = CheckQuality(registrationName="check", Input=mesh, Rules=RULES, NumberOfWorst=10)


def require_mesh(time=0):
    """Raises ValueError if the simulation passes no mesh."""
    mesh.UpdatePipeline(time)
    data = mesh.GetClientSideObject().GetOutputDataObject(0)
    if not data or not data.IsA("vtkDataSet") and not data.IsA("vtkCompositeDataSet"):
        found = data.GetClassName() if data else "none"
        raise ValueError(f'channel "input": expected a mesh, found {found}')


def evaluate(time):
    """The verdict on the mesh, on the first rank."""
    check.UpdatePipeline(time)
    if RANK > 0:
        return None
    verdicts = check.GetClientSideObject().GetOutputDataObject(0)  # complete on this rank only
    verdict = verdicts.GetFieldData().GetAbstractArray("Verdict")
    if not verdict:
        raise RuntimeError("another process failed")
    return verdict.GetValue(0)


@contextlib.contextmanager
def whole(path):
    """The name of a part of a file of the first rank, which becomes the file only if all goes well."""
    part = path.with_name(f".{path.name}")
    try:
        yield part
        if RANK == 0:
            part.replace(path)
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path))
    finally:
        if RANK == 0:
            part.unlink(missing_ok=True)


def write_table(port, path):
    """An output of the check as CSV."""
    table = check.GetClientSideObject().GetOutputDataObject(port)
    columns = [table.GetColumn(c) for c in range(table.GetNumberOfColumns())]
    with whole(path) as part, open(part, "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file)
        rows.writerow([column.GetName() for column in columns])
        for row in range(table.GetNumberOfRows()):
            rows.writerow([column.GetValue(row) for column in columns])


def write_tables(cycle):
    """The tables of the check, which the first rank has."""
    if RANK == 0:
        FOLDER.mkdir(parents=True, exist_ok=True)
        write_table(0, FOLDER / f"verdicts_{cycle:06}.csv")
        write_table(1, FOLDER / f"worst_{cycle:06}.csv")


def can_draw():
    """Whether ParaView finds a display; one that draws by X would end the simulation without."""
    return bool(os.environ.get("DISPLAY")) or not vtkRenderWindow().IsA("vtkXOpenGLRenderWindow")


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


def draw(info):
    """A picture of the mesh."""
    global view
    view = view or make_view()
    view.ViewTime = info.time
    Render(view)  # else the camera would be set for the mesh of the last picture
    ResetCamera(view)
    path = FOLDER / f"quality_{info.cycle:06}.png"
    with whole(path) as part:
        SaveScreenshot(str(part), view, ImageResolution=SIZE)
        if RANK == 0 and not part.exists():  # SaveScreenshot returns True then, too
            raise RuntimeError(f"{path}: cannot write this picture")


def end_check(when, reason):
    """Prints why the check ends, deletes its filter, and may end the simulation."""
    global is_checking
    is_checking = False
    stops = share(ON_ERROR == "stop")
    if RANK == 0:
        print_error(f"the {'simulation' if stops else 'check'} ends {when}: {reason}")
    if stops:
        ctypes.CDLL(None).fflush(None)  # what the simulation has printed
        os._exit(2)
    if "check" in globals():
        Delete(check)


has_failed, view = False, None
try:
    together(prepare)
    interval = share(int(INTERVAL) if RANK == 0 else 0)
    draws = least(can_draw())
    is_checking = True
except CheckError as error:
    end_check("before the first step", error)


def catalyst_execute(info):
    """Called at every step, on all ranks."""
    global has_failed
    if not is_checking:
        return
    try:
        together(require_mesh, info.time)
        verdict = together(evaluate, info.time)
        if RANK == 0:
            print_info(f"step {info.cycle}, time {info.time:g}: {verdict}")
        fails = share(verdict == "fail")
        fails_now = fails and not has_failed
        has_failed = has_failed or fails
        if info.cycle % interval and not fails_now:
            return
        together(write_tables, info.cycle)
        if draws:
            together(draw, info)
    except CheckError as error:
        end_check(f"at step {info.cycle}", error)
