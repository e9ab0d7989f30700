# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a mesh and its worst cells.

Only boundary polygons are drawn, which Mesh Surface takes from the mesh's topology: ParaView's own
surface of polyhedral meshes takes minutes. Mesh Inspection draws them, as ParaView's Surface fills the holes of
polygons and takes minutes for one of many corners.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any, Optional, Sequence

import numpy
from paraview import simple
from paraview.modules.vtkRemotingViews import vtkPVRenderingCapabilitiesInformation
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import pipeline, text
from .ranking import picture_criterion, undefined_count
from .report import Picture
from .stages import Stages
from .svg import ticks

SIZE = (1200, 900)
BAR_SHARE = 0.16  # of the width, kept free for the colour bar
MOST_CELLS_WITH_EDGES = 60_000

INK = [0.13, 0.16, 0.18]
ACCENT = [0.18, 0.40, 0.56]
MESH_COLOR = [0.80, 0.85, 0.88]
NULL_COLOR = [0.70, 0.66, 0.80]
SHELL_COLOR = [0.55, 0.63, 0.70]
MARK_COLOR = [0.76, 0.19, 0.08]
# From good to bad: pale blue-grey, sand, orange, dark red; lightness falls all the way.
COLORS = [
    (0.00, 0.898, 0.925, 0.937),
    (0.30, 0.953, 0.886, 0.733),
    (0.55, 0.945, 0.659, 0.361),
    (0.78, 0.835, 0.325, 0.180),
    (1.00, 0.490, 0.063, 0.125),
]


def can_render() -> bool:
    """Whether there is a display, or a ParaView that needs none; it crashes where neither is."""
    information = vtkPVRenderingCapabilitiesInformation()
    with pipeline.Messages():  # VTK 9.6 warns of the X server that is not there before it does without
        return information.Supports(information.GetLocalCapabilities(), information.OPENGL)


class Scene:
    """A white view with a camera of ours."""

    def __init__(self, camera: Camera):
        self.camera = camera
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize = list(SIZE)
        self.view.UseColorPaletteForBackground = 0
        self.view.BackgroundColorMode = "Single Color"
        self.view.Background = [1.0, 1.0, 1.0]
        self.view.OrientationAxesLabelColor = INK
        self.view.MaximumNumberOfPeels = 6

    def show(self, source: Any, **properties: Any) -> Any:
        display = simple.Show(source, self.view)
        display.SetRepresentationType("Mesh Inspection")
        display.DrawEdges = 0
        display.ColorArrayName = ["POINTS", ""]
        display.Ambient, display.Diffuse = 0.35, 0.7  # so that colours can be compared with the bar
        for name, value in properties.items():
            setattr(display, name, value)
        return display

    def color(self, display: Any, criterion: dict[str, Any]) -> None:
        """Colours by the criterion's cell array, bad values dark, and shows the colour bar."""
        name = criterion["name"]
        simple.ColorBy(display, ("CELLS", name))
        table = simple.GetColorTransferFunction(name)
        table.AutomaticRescaleRangeMode = "Never"
        table.RGBPoints = color_points(criterion)
        table.ColorSpace = "Lab"
        table.NanColor = NULL_COLOR
        table.ScalarRangeInitialized = 1.0
        bar = simple.GetScalarBar(table, self.view)
        unit = criterion["unit"]
        bar.Title = criterion["label"] + (f" ({unit})" if unit else "")
        bar.ComponentTitle = ""
        bar.WindowLocation = "Any Location"
        bar.Orientation = "Vertical"
        bar.Position = [0.875, 0.17]
        bar.ScalarBarLength = 0.66
        bar.ScalarBarThickness = 20
        bar.TitleFontSize, bar.LabelFontSize = 26, 23
        bar.TitleColor = bar.LabelColor = INK
        low, high = color_range(criterion)
        bar.UseCustomLabels = 1
        bar.CustomLabels = ticks(low, high, 7)
        bar.AddRangeLabels = 0
        bar.LabelFormat = "%-g"
        bar.DrawNanAnnotation = 1 if criterion["null"] else 0
        bar.NanAnnotation = (
            "undefined" if undefined_count(criterion) == criterion["null"] else "no value"
        )
        bar.Visibility = 1
        display.SetScalarBarVisibility(self.view, True)

    def save(self, path: Path) -> None:
        self.camera.apply(self.view)
        simple.SaveScreenshot(
            str(path), self.view, ImageResolution=list(SIZE), OverrideColorPalette=""
        )

    def close(self) -> None:
        simple.Delete(self.view)


def color_range(criterion: dict[str, Any]) -> tuple[float, float]:
    """Smallest to largest value, or 1 % to 99 % where few values stretch the range a lot."""
    low, high = criterion["min"], criterion["max"]
    if low is None or high is None:
        return 0.0, 1.0
    p1, p99 = criterion["quantiles"].get("1"), criterion["quantiles"].get("99")
    if p1 is not None and p99 is not None and p99 > p1 and p99 - p1 < 0.2 * (high - low):
        low, high = p1, p99
    if not high > low:
        # One colour for all: the good end, unless the value is not acceptable.
        room = max(abs(low), 1.0) * 0.1
        is_low_end = (criterion["better"] == "bigger") == (criterion["out_of_range"] > 0)
        low, high = (low, high + room) if is_low_end else (low - room, high)
    return low, high


def color_points(criterion: dict[str, Any]) -> list[float]:
    """The control points of the colour map over the criterion's range."""
    low, high = color_range(criterion)
    colors = COLORS
    if criterion["better"] == "bigger":
        colors = [(1.0 - x, *rgb) for x, *rgb in reversed(COLORS)]
    return [value for x, *rgb in colors for value in (low + x * (high - low), *rgb)]


class Camera:
    """Parallel projection that shows all of a mesh and leaves a strip at the right free."""

    def __init__(self, bounds: Sequence[float]):
        low, high = bounds[0::2], bounds[1::2]
        extent = [b - a for a, b in zip(low, high)]
        self.middle = self.center = [0.5 * (a + b) for a, b in zip(low, high)]
        self.diagonal = math.hypot(*extent) or 1.0
        self.towards, up = direction(extent)
        self.right = _cross(up, self.towards)
        self.up = _cross(self.towards, self.right)
        # The box fills the view; `fit` does the same for what is drawn.
        half = (
            lambda axis: 0.5 * sum(abs(e * x) for e, x in zip(extent, axis)) or 0.5 * self.diagonal
        )
        self.scale = max(half(self.up), half(self.right) * SIZE[1] / SIZE[0])

    def fit(self, view: Any) -> None:
        """Moves so that what the view shows fills it, measured on a small picture."""
        width, height = 400, 300
        view.ViewSize = [width, height]
        self.apply(view)
        image = view.CaptureWindow(1)
        rgb = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
        drawn = numpy.any(rgb[..., :3] < 250, axis=2)
        view.ViewSize = list(SIZE)
        columns, rows = numpy.flatnonzero(drawn.any(axis=0)), numpy.flatnonzero(drawn.any(axis=1))
        if max(len(columns), len(rows)) < 8:
            return  # nothing, or next to nothing, to see
        pixel = 2.0 * self.scale / height
        middle = lambda found, size: pixel * (0.5 * (found[0] + found[-1] + 1) - 0.5 * size)
        half = lambda found: 0.5 * pixel * (found[-1] - found[0] + 1)
        step = middle(columns, width), middle(rows, height)
        self.center = [
            c + step[0] * r + step[1] * u for c, r, u in zip(self.center, self.right, self.up)
        ]
        aspect = SIZE[0] / SIZE[1]
        self.scale = 1.07 * max(half(rows), half(columns) / (aspect * (1.0 - BAR_SHARE)))
        shift = self.scale * aspect * BAR_SHARE
        self.center = [c + shift * r for c, r in zip(self.center, self.right)]

    def apply(self, view: Any) -> None:
        view.CameraParallelProjection = 1
        view.CameraFocalPoint = self.center
        view.CameraPosition = [
            c + 2.0 * self.diagonal * t for c, t in zip(self.center, self.towards)
        ]
        view.CameraViewUp = self.up
        view.CameraParallelScale = self.scale


def direction(extent: Sequence[float]) -> tuple[list[float], list[float]]:
    """Where the camera stands, seen from the mesh, and what is up."""
    diagonal = math.hypot(*extent)
    flat = [axis for axis in range(3) if extent[axis] <= 1e-6 * diagonal]
    if len(flat) == 1:
        towards, up = {
            0: ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
            1: ([0.0, -1.0, 0.0], [0.0, 0.0, 1.0]),
            2: ([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]),
        }[flat[0]]
        return towards, up
    slanted = [0.62, -1.0, 0.72]
    length = math.hypot(*slanted)
    return [x / length for x in slanted], [0.0, 0.0, 1.0]


def _cross(a: Sequence[float], b: Sequence[float]) -> list[float]:
    c = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    length = math.hypot(*c)
    return [x / length for x in c]


def _dot(a: Sequence[float], b: Sequence[float]) -> float:
    return sum(x * y for x, y in zip(a, b))


def take(
    summary: dict[str, Any], quality: Any, surface: Any, folder: Path, most: int, stage: Stages
) -> list[Picture]:
    """The mesh, its worst cells and the worst cell, coloured by the worst criterion: `most` of these; files go to
    the folder."""
    mesh = summary["mesh"]
    if not mesh["bounds"]:
        return []
    criterion = picture_criterion(summary["criteria"])
    camera = Camera(mesh["bounds"])
    path = folder / "mesh.png"
    surface.UpdatePipeline()
    cells = pipeline.data_information(surface).GetNumberOfCells()
    has_polygons = mesh["volume"] is not None or mesh["area"] is not None
    made = [] if cells else [simple.ConvertToPointCloud(Input=quality)]
    with stage("picture of the mesh"):
        _take_mesh(made[0] if made else surface, camera, has_polygons, cells, criterion, path)
    for proxy in made:
        simple.Delete(proxy)
    if not criterion:
        return [Picture(path, "The mesh.", "")]
    caption = f"Cells with bad values are dark.{_caption_of_colors(criterion)}"
    if criterion["better"] == "neither":
        caption = _caption_of_colors(criterion).strip()
    if criterion["null"]:
        caption += " Violet cells have no value."
    taken = [Picture(path, f"{criterion['label']}.", caption)]
    colored = _with_one_criterion(quality, criterion["name"])
    if most > 1 and (criterion["worst"] or criterion["out_of_range"]):
        path = folder / "worst.png"
        with stage("picture of the worst cells"):
            taken.append(_take_worst(summary, colored, surface, camera, criterion, path))
    if most > 2 and criterion["worst"]:
        with stage("picture of the worst cell"):
            taken.append(_take_the_worst(colored, criterion, folder / "close.png"))
    simple.Delete(colored)
    return taken


def _with_one_criterion(quality: Any, name: str) -> Any:
    """The mesh without the other criteria: ParaView asks of every filter for the ranges of all arrays."""
    others = {*quality.GetProperty("Criteria").Available} - {name}
    return simple.PassArrays(
        Input=quality,
        CellDataArrays=[array for array in quality.CellData.keys() if array not in others],
        PointDataArrays=quality.PointData.keys(),
    )


def _take_mesh(
    source: Any,
    camera: Camera,
    has_polygons: bool,
    cells: int,
    criterion: Optional[dict[str, Any]],
    path: Path,
) -> None:
    """The source coloured by the criterion; with few cells, with their edges. Fits the camera."""
    scene = Scene(camera)
    color = MESH_COLOR if has_polygons else ACCENT
    display = scene.show(
        source, DiffuseColor=color, AmbientColor=color, PointSize=6.0, LineWidth=2.0
    )
    scene.view.OrientationAxesVisibility = 0
    camera.fit(scene.view)
    scene.view.OrientationAxesVisibility = 1
    if has_polygons and cells <= MOST_CELLS_WITH_EDGES:
        display.DrawEdges = 1
        display.EdgeColor = INK
        display.EdgeOpacity = 0.55 if cells < 8000 else 0.3
        display.LineWidth = 1.0
    if criterion:
        scene.color(display, criterion)
    scene.save(path)
    scene.close()


def _take_worst(summary, quality, surface, camera, criterion, path: Path) -> Picture:
    """The worst cells inside a translucent shell, with a halo around those too small to be seen."""
    worst = criterion["worst"]
    selected = simple.SelectElements(Input=quality, Array=criterion["name"])
    if worst:
        selected.Strategy = "Worst N"
        selected.NumberOfWorst = len(worst)
        title = f"The {len(worst)} worst cells." if len(worst) > 1 else "The worst cell."
    else:
        selected.Strategy = "By criterion"
        selected.Preset = summary["preset"] or selected.Preset
        selected.RangesFile = summary["ranges"] or ""
        title = "Cells outside the acceptable range."
    cells = simple.Threshold(Input=selected, Scalars=["CELLS", "Selected"])
    cells.ThresholdMethod = "Above Upper Threshold"
    cells.UpperThreshold = 0.5
    outside = simple.MeshSurface(Input=cells)
    halo_radius = 0.018 * camera.diagonal
    halos = [
        simple.Sphere(Center=w["center"], Radius=halo_radius, ThetaResolution=24, PhiResolution=16)
        for w in worst
    ]
    scene = Scene(camera)
    # A little larger than the mesh, to lie apart from faces of the worst cells.
    scene.show(
        surface,
        Opacity=0.14,
        DiffuseColor=SHELL_COLOR,
        AmbientColor=SHELL_COLOR,
        Origin=camera.middle,
        Scale=[1.003] * 3,
    )
    display = scene.show(outside, LineWidth=1.5)
    display.DrawEdges = 1
    display.EdgeColor = INK
    scene.color(display, criterion)
    made = [selected, cells, outside, *halos]
    if halos:
        made.append(simple.AppendGeometry(Input=halos))
        scene.show(made[-1], Opacity=0.22, DiffuseColor=MARK_COLOR, AmbientColor=MARK_COLOR)
    scene.save(path)
    scene.close()
    for proxy in reversed(made):
        simple.Delete(proxy)
    name = criterion["label"][0].lower() + criterion["label"][1:]
    caption = f"By {name}, inside the boundary of the mesh."
    if halos:
        caption += " Halos mark their places."
    return Picture(path, title, caption)


def _take_the_worst(quality, criterion, path: Path) -> Picture:
    """The worst cell close by, inside its neighbours."""
    name, worst = criterion["name"], criterion["worst"][0]
    cell = simple.SelectElements(Input=quality, Array=name, Strategy="Worst N", NumberOfWorst=1)
    around = simple.SelectElements(Input=cell, Strategy="Expand", Adjacency="Vertex")
    made = [cell, around]
    surfaces = []
    for selected in (cell, around):
        made.append(simple.Threshold(Input=selected, Scalars=["CELLS", "Selected"]))
        made[-1].ThresholdMethod = "Above Upper Threshold"
        made[-1].UpperThreshold = 0.5
        made.append(simple.MeshSurface(Input=made[-1]))
        made[-1].UpdatePipeline()
        surfaces.append(made[-1])
    camera = Camera(pipeline.data_information(surfaces[1]).GetBounds())
    scene = Scene(camera)
    shell = scene.show(
        surfaces[1], Opacity=0.12, DiffuseColor=SHELL_COLOR, AmbientColor=SHELL_COLOR, LineWidth=1.0
    )
    shell.DrawEdges = 1
    shell.EdgeColor = SHELL_COLOR
    display = scene.show(surfaces[0], LineWidth=2.0)
    display.DrawEdges = 1
    display.EdgeColor = INK
    scene.view.OrientationAxesVisibility = 0
    camera.fit(scene.view)
    scene.view.OrientationAxesVisibility = 1
    scene.color(display, criterion)
    scene.save(path)
    scene.close()
    for proxy in reversed(made):
        simple.Delete(proxy)
    block = f" of block {worst['block']}" if worst["block"] else ""
    caption = (
        f"Number {worst['id']}{block}, {worst['type']}, with {text.number(worst['value'])}"
        f"{text.UNIT_SYMBOLS.get(criterion['unit'], '')}, inside the cells that share a point with it."
    )
    return Picture(path, "The worst cell.", caption)


def _caption_of_colors(criterion: dict[str, Any]) -> str:
    """What the colours of a picture mean where they do not span all values."""
    low, high = color_range(criterion)
    if criterion["min"] is None or (low <= criterion["min"] and high >= criterion["max"]):
        return ""
    return (
        f" Colours span {text.number(low)} to {text.number(high)} (98 % of the cells); "
        "values beyond have the colours of the ends."
    )
