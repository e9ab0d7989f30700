# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a mesh and its worst cells.

Only boundary polygons are drawn, which Mesh Surface extracts from the mesh topology: ParaView's own
surface extraction takes minutes for polyhedral meshes. Mesh Inspection draws them, because
ParaView's Surface fills the holes of polygons and takes minutes for polygons with many vertices.
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import sys
from pathlib import Path
from typing import Any, Optional

from paraview import servermanager, simple
from paraview.modules.vtkRemotingViews import vtkPVRenderingCapabilitiesInformation, vtkPVView
from vtkmodules.vtkIOImage import vtkPNGWriter

from ..common import console, pipeline, text
from ..common.assessment import (
    has_not_judged,
    is_limited,
    picture_criterion,
    range_to_select,
    undefined_count,
)
from ..common.stages import Stages
from .camera import SIZE, Camera
from .report import Picture

LINE_COLOR = [0.18, 0.40, 0.56]
SHELL_COLOR = [0.55, 0.63, 0.70]
FEW_CURVED_CELLS = 20_000  # so that it takes seconds to subdivide their faces
NO_LIMIT = sys.float_info.max  # of QualityColors


def can_render() -> bool:
    """Whether there is a display or ParaView needs none; otherwise rendering would crash."""
    information = vtkPVRenderingCapabilitiesInformation()
    with pipeline.Messages():  # VTK 9.6 warns about a missing X server before it renders without one
        return information.Supports(information.GetLocalCapabilities(), information.OPENGL)


def end_with_display() -> None:
    """Ends the program with an error message if the display disappears; Xlib itself would exit with
    1."""
    global _without_display
    try:
        xlib = ctypes.CDLL("libX11.so.6")
    except OSError:
        return  # this ParaView needs no display
    _without_display = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p)(_end)
    xlib.XSetIOErrorHandler(_without_display)


def _end(_display: Any) -> int:
    name = os.environ.get("DISPLAY", "")
    console.complain(f"the display {name} disappeared while pictures were rendered")
    os._exit(2)


#: Must exist as long as Xlib may call it.
_without_display: Any = None


def _make_proxy(group: str, name: str) -> Any:
    """A proxy that is not registered: ParaView's window shows nothing of it."""
    proxy = servermanager.ProxyManager().NewProxy(group, name)
    controller = servermanager.ParaViewPipelineController()
    controller.PreInitializeProxy(proxy)
    controller.PostInitializeProxy(proxy)
    proxy.UpdateVTKObjects()
    return servermanager._getPyProxy(proxy)


def _make_view() -> Any:
    """A view with a window of its own, which nobody sees. ParaView's window would not draw one that
    it does not show."""
    before = vtkPVView.GetUseGenericOpenGLRenderWindow()
    vtkPVView.SetUseGenericOpenGLRenderWindow(False)
    try:
        view = _make_proxy("views", "RenderView")
        view.GetRenderWindow().SetOffScreenRendering(True)
        return view
    finally:
        vtkPVView.SetUseGenericOpenGLRenderWindow(before)


class Scene:
    """A white view for all pictures; the objects of one picture are hidden for the next."""

    def __init__(self, subdivision: int = 1):
        #: Nonlinear Subdivision Level of curved faces.
        self.subdivision = subdivision
        self.shown: list[Any] = []
        self.bar: Optional[Any] = None
        #: Light, edges and marks, as in the window.
        self.look = _make_proxy("misc", "QualityColors")
        self.view = _make_view()
        self.view.ViewSize = list(SIZE)
        self.view.UseColorPaletteForBackground = 0
        self.view.BackgroundColorMode = "Single Color"
        self.view.Background = self.look.Background
        self.view.OrientationAxesLabelColor = self.look.TextColor
        # Translucent objects have (almost) one color here, so depth peeling would not improve them.
        self.view.DepthPeeling = 0

    def show(self, source: Any, **properties: Any) -> Any:
        # simple.Show creates a representation with all types, which takes a second.
        display = _make_proxy("representations", "MeshInspectionRepresentation")
        self.set(display, Input=source, DrawEdges=0, ColorArrayName=["POINTS", ""])
        display.NonlinearSubdivisionLevel = self.subdivision
        for name in ("Ambient", "Diffuse", "EdgeColor", "EdgeOpacity"):
            setattr(display, name, getattr(self.look, name))
        self.set(display, **properties)
        self.view.Representations.append(display)
        self.shown.append(display)
        return display

    def set(self, display: Any, **properties: Any) -> None:
        for name, value in properties.items():
            setattr(display, name, value)

    def clear(self) -> None:
        """Hides all objects."""
        for display in self.shown:
            display.Visibility = 0
        self.shown = []
        if self.bar:
            self.bar.Visibility = 0

    def color(self, display: Any, criterion: dict[str, Any]) -> None:
        """Colors by the criterion's cell array, with dark bad values, and shows the color bar."""
        name = criterion["name"]
        table = _make_proxy("lookup_tables", "PVLookupTable")  # those of the window are the user's
        table.AutomaticRescaleRangeMode = "Never"
        colors = colors_of(criterion)
        table.RGBPoints = colors["Points"]
        table.NanColor = colors["UndefinedColor"]
        table.BelowRangeColor = colors["NotJudgedColor"]
        not_judged = has_not_judged(criterion)
        table.UseBelowRangeColor = not_judged and criterion["undefined"] > 0
        table.ColorSpace = "RGB"
        table.ScalarRangeInitialized = 1.0
        self.set(display, ColorArrayName=["CELLS", name], LookupTable=table)
        display.MarkCellsNotJudged = not_judged
        self.bar = bar = _make_proxy("representations", "ScalarBarWidgetRepresentation")
        bar.LookupTable = table
        self.view.Representations.append(bar)
        bar.Title = text.with_unit(criterion["label"], criterion["unit"])
        bar.ComponentTitle = ""
        bar.WindowLocation = "Any Location"
        bar.Orientation = "Vertical"
        bar.Position = [0.875, 0.17]
        bar.ScalarBarLength = 0.66
        bar.ScalarBarThickness = 20
        bar.TitleFontSize, bar.LabelFontSize = 26, 23
        bar.TitleColor = bar.LabelColor = self.look.TextColor
        bar.UseCustomLabels, bar.AddRangeLabels, bar.AutomaticLabelFormat = 1, 0, 0
        bar.CustomLabels = colors["Labels"]
        number = f".{colors['LabelDigits'][0]}g"
        is_new = "{" in bar.LabelFormat  # the notation depends on the version of ParaView
        bar.LabelFormat = f"{{:{number}}}" if is_new else f"%{number}"
        bar.DrawNanAnnotation = 1 if criterion["undefined"] or not_judged else 0
        bar.NanAnnotation = colors["UndefinedText"][0]
        if undefined_count(criterion) < criterion["undefined"]:  # the criterion is not for all
            bar.NanAnnotation = bar.NanAnnotation.replace("undefined", "no value")
        bar.Visibility = 1

    def fit(self, camera: Camera) -> None:
        """Moves the camera so that the visible objects fill the picture."""
        self.view.OrientationAxesVisibility = 0
        camera.fit(self.view)
        self.view.OrientationAxesVisibility = 1

    def save(self, camera: Camera, path: Path) -> None:
        camera.apply(self.view)
        writer = vtkPNGWriter()
        writer.SetInputData(self.view.CaptureWindow(1))
        writer.SetFileName(str(path))
        # More makes the file a few percent smaller and takes twice the time.
        writer.SetCompressionLevel(2)
        writer.Write()

    def close(self) -> None:
        self.clear()
        self.view.Representations = []
        self.bar = self.view = None


def color_range(criterion: dict[str, Any]) -> tuple[float, float]:
    """Smallest to largest value, or the 1 % to 99 % quantiles if a few values extend the range a
    lot; always past a limit that some cells violate."""
    low, high = criterion["min"], criterion["max"]
    if low is None or high is None:  # perhaps all are infinite: on both sides of the limits
        limits = [limit for limit in criterion["acceptable"] if limit is not None] or [0.5]
        return min(limits) - 0.5, max(limits) + 0.5
    p1, p99 = criterion["quantiles"].get("1"), criterion["quantiles"].get("99")
    if p1 is not None and p99 is not None and p99 > p1 and p99 - p1 < 0.2 * (high - low):
        low, high = p1, p99
    # However few cells violate a limit, they have the colors for that.
    least, most = criterion["acceptable"] if is_limited(criterion) else (None, None)
    room = 0.25
    if least is not None and criterion["below"] and low >= least:
        low = max(criterion["min"], least - room * (high - least))
    if most is not None and criterion["above"] and high <= most:
        high = min(criterion["max"], most + room * (most - low))
    return low, high


def colors_of(criterion: dict[str, Any]) -> dict[str, list]:
    """What Quality Colors, which the Mesh Inspector uses as well, finds for the range of the
    criterion: the control points of the color map, the labels of its legend, and colors and text
    for cells without values and cells that are not judged."""
    colors = servermanager.ProxyManager().NewProxy("misc", "QualityColors")
    limits = criterion["acceptable"] if is_limited(criterion) else [None, None]
    acceptable = [-NO_LIMIT if limits[0] is None else limits[0]]
    acceptable.append(NO_LIMIT if limits[1] is None else limits[1])
    better = {"bigger": 1, "smaller": -1}.get(criterion["better"], 0)
    for name, values in (
        ("Range", color_range(criterion)),
        ("Acceptable", acceptable),
        ("Better", [better]),
        ("HasUndefined", [int(criterion["undefined"] > 0)]),
        ("HasNotJudged", [int(has_not_judged(criterion))]),
    ):
        for i, value in enumerate(values):
            colors.GetProperty(name).SetElement(i, value)
    colors.UpdateVTKObjects()
    found = {}
    names = ("Points", "Labels", "LabelDigits", "UndefinedColor", "NotJudgedColor", "UndefinedText")
    for name in names:
        values = colors.GetProperty(name)
        pipeline.update_information(colors, values)
        found[name] = [values.GetElement(i) for i in range(values.GetNumberOfElements())]
    return found


def take(
    summary: dict[str, Any], quality: Any, surface: Any, folder: Path, most: int, stage: Stages
) -> list[Picture]:
    """Renders up to `most` pictures into the folder: the mesh, its worst cells, and the worst cell,
    colored by the worst criterion."""
    if not summary["mesh"]["bounds"]:
        return []
    end_with_display()
    criterion = picture_criterion(summary["criteria"])
    with contextlib.closing(_Pictures(summary, quality, surface, folder, criterion)) as pictures:
        with stage("picture of the mesh"):
            taken = [pictures.take_mesh()]
        if most > 1 and criterion and (criterion["worst"] or criterion["out_of_range"]):
            with stage("picture of the worst cells"):
                taken.append(pictures.take_worst())
        if most > 2 and criterion and criterion["worst"]:
            with stage("picture of the worst cell"):
                taken.append(pictures.take_the_worst())
        return taken


class _Pictures:
    """The pictures of a mesh, which share a scene and filters."""

    def __init__(
        self, summary, quality, surface, folder: Path, criterion: Optional[dict[str, Any]]
    ):
        self.summary, self.folder, self.criterion = summary, folder, criterion
        self.camera = Camera(summary["mesh"]["bounds"])
        self.made: list[Any] = []
        shown = [criterion["name"]] if criterion else []
        own = {*quality.CellData.keys()} - {*quality.GetProperty("Criteria").Available}
        self.quality = self.with_arrays(quality, [*own, *shown], quality.PointData.keys())
        surface.UpdatePipeline()
        polygons = pipeline.data_information(surface).GetNumberOfCells()
        #: Curved faces are drawn from the cells, as polygons of Mesh Surface have straight edges.
        self.curved = summary["mesh"]["higher_order"]
        if polygons and self.curved:
            self.outside = self.with_arrays(self.quality, [*shown, pipeline.GHOSTS], [])
        elif polygons:
            self.outside = self.with_arrays(surface, [*shown, "CellShapes", pipeline.GHOSTS], [])
        else:
            self.outside = self.make(simple.ConvertToPointCloud, self.quality)
        self.scene = Scene(3 if self.curved < FEW_CURVED_CELLS else 1)

    def make(self, create: Any, source: Any, **properties: Any) -> Any:
        """Creates a filter that exists until the last picture is rendered."""
        self.made.append(create(Input=source, **properties))
        return self.made[-1]

    def close(self) -> None:
        self.scene.close()
        for proxy in reversed(self.made):
            simple.Delete(proxy)

    def with_arrays(self, source: Any, cells: list[str], points: list[str]) -> Any:
        """The source with these arrays only: ParaView computes the ranges of all arrays of every
        filter, which takes longer than rendering."""
        return self.make(simple.PassArrays, source, CellDataArrays=cells, PointDataArrays=points)

    def select(self, source: Any, **properties: Any) -> Any:
        return self.make(simple.SelectElements, source, **properties)

    def surface_of(self, selected: Any) -> Any:
        """The boundary of the selected cells."""
        cells = self.make(
            simple.Threshold,
            selected,
            Scalars=["CELLS", "Selected"],
            ThresholdMethod="Above Upper Threshold",
            UpperThreshold=0.5,
        )
        return cells if self.curved else self.make(simple.MeshSurface, cells, PassThroughShapes=1)

    def take_mesh(self) -> Picture:
        """The mesh colored by the criterion. Fits the camera."""
        mesh, scene, criterion = self.summary["mesh"], self.scene, self.criterion
        has_polygons = mesh["volume"] is not None or mesh["area"] is not None
        color = scene.look.MeshColor if has_polygons else LINE_COLOR
        display = scene.show(
            self.outside, DiffuseColor=color, AmbientColor=color, PointSize=6.0, LineWidth=2.0
        )
        scene.fit(self.camera)
        if has_polygons:
            scene.set(display, DrawEdges=1, LineWidth=1.0)
        if criterion:
            scene.color(display, criterion)
        path = self.folder / "mesh.png"
        scene.save(self.camera, path)
        if not criterion:
            return Picture(path, "The mesh.", "")
        caption = ""
        if is_limited(criterion):
            caption = "Values outside the acceptable range are orange to dark red."
        elif criterion["better"] != "neither":
            caption = "Cells with bad values are dark."
        caption = f"{caption}{_caption_of_colors(criterion)}".strip()
        if criterion["undefined"]:
            caption += " Mauve cells have an undefined value."
        if has_not_judged(criterion):
            caption += " Cells in warm gray are not judged: the range is not for them."
        return Picture(path, f"{criterion['label']}.", caption)

    def take_worst(self) -> Picture:
        """The worst cells inside a translucent shell, each with a halo."""
        summary, scene, criterion = self.summary, self.scene, self.criterion
        worst = criterion["worst"]
        if worst:
            how = {"Strategy": "Worst N", "NumberOfWorst": len(worst)}
            title = f"The {len(worst)} worst cells." if len(worst) > 1 else "The worst cell."
        else:
            how = {"Strategy": "By criterion", **range_to_select(criterion, summary)}
            title = "Cells outside the acceptable range."
        selected = self.select(self.quality, Array=criterion["name"], **how)
        scene.clear()
        # Slightly larger than the mesh, so that it does not coincide with faces of the worst cells.
        scene.show(
            self.outside,
            Opacity=0.14,
            DiffuseColor=SHELL_COLOR,
            AmbientColor=SHELL_COLOR,
            Origin=self.camera.middle,
            Scale=[1.003] * 3,
        )
        display = scene.show(self.surface_of(selected), DrawEdges=1)
        scene.color(display, criterion)
        if worst:
            halos = self.halos([w["center"] for w in worst])
            mark = scene.look.MarkColor
            scene.show(halos, Opacity=0.3, AmbientColor=mark, Ambient=1, Diffuse=0)
        path = self.folder / "worst.png"
        scene.save(self.camera, path)
        name = criterion["label"][0].lower() + criterion["label"][1:]
        caption = f"By {name}, inside the boundary of the mesh."
        if worst:
            caption += " Halos mark their locations."
        return Picture(path, title, caption)

    def halos(self, centers: list[list[float]]) -> Any:
        """A sphere around each of the points."""
        self.made.append(simple.PolyLineSource(Points=[x for center in centers for x in center]))
        halos = self.make(
            simple.Glyph,
            self.made[-1],
            GlyphType="Sphere",
            GlyphMode="All Points",
            ScaleArray=["POINTS", "No scale array"],
            ScaleFactor=0.036 * self.camera.diagonal,
        )
        halos.GlyphType.ThetaResolution, halos.GlyphType.PhiResolution = 24, 16
        return halos

    def take_the_worst(self) -> Picture:
        """A close-up of the worst cell inside its neighbors."""
        scene, criterion = self.scene, self.criterion
        worst = criterion["worst"][0]
        cell = self.select(
            self.quality, Array=criterion["name"], Strategy="Worst N", NumberOfWorst=1
        )
        around = self.surface_of(self.select(cell, Strategy="Expand", Adjacency="Vertex"))
        around.UpdatePipeline()
        camera = Camera(pipeline.data_information(around).GetBounds())
        scene.clear()
        scene.show(
            around,
            DrawEdges=1,
            EdgeColor=SHELL_COLOR,
            Opacity=0.12,
            DiffuseColor=SHELL_COLOR,
            AmbientColor=SHELL_COLOR,
        )
        display = scene.show(self.surface_of(cell), DrawEdges=1)
        scene.fit(camera)
        scene.color(display, criterion)
        path = self.folder / "close.png"
        scene.save(camera, path)
        block = f" of block {worst['block']}" if worst["block"] else ""
        caption = (
            f"Cell {worst['id']}{block}, {worst['type']}, value {text.number(worst['value'])}"
            f"{text.UNIT_SYMBOLS.get(criterion['unit'], '')}, inside the cells that share a point with it."
        )
        return Picture(path, "The worst cell.", caption)


def _caption_of_colors(criterion: dict[str, Any]) -> str:
    """The caption about the range of colors if they do not span all values."""
    low, high = color_range(criterion)
    if criterion["min"] is None or (low <= criterion["min"] and high >= criterion["max"]):
        return ""
    return (
        f" Colors span {text.number(low)} to {text.number(high)} (at least 98 % of the cells); "
        "values beyond have the colors of the ends."
    )
