# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of, and selections in, a view with one representation."""

import base64
import re

import camaron_testing
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

SIZE = (400, 300)


def make_view():
    """A new view of SIZE without anything but what is shown in it."""
    view = simple.CreateRenderView()
    view.ViewSize = list(SIZE)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    simple.SetActiveView(view)
    return view


def turn(view):
    """A camera that looks at everything from no special direction."""
    view.CameraFocalPoint, view.CameraViewUp = [0, 0, 0], [0, 1, 0]
    view.CameraPosition, view.CameraViewAngle = [0.5, 0.3, 0.8], 30
    simple.ResetCamera(view)


def picture(view):
    """What the view shows as an array of (height, width, 3) from 0 to 255."""
    simple.Render(view)
    image = view.SMProxy.CaptureWindow(1)
    width, height, _ = image.GetDimensions()
    colors = vtk_to_numpy(image.GetPointData().GetScalars())[:, :3]
    return colors.reshape(height, width, 3).astype(int)


def read_picture(path):
    """A PNG file, as picture() gives what a view shows."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    colors = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3]
    return colors.reshape(height, width, 3).astype(int)


def report_pictures(path):
    """The pictures of a report.html, as picture() gives them."""
    found = re.findall(r'"data:image/png;base64,([^"]*)"', path.read_text("utf-8"))
    pictures = []
    for data in found:
        file = path.with_name("picture.png")
        file.write_bytes(base64.b64decode(data))
        pictures.append(read_picture(file))
        file.unlink()
    return pictures


def difference(one, other, tolerance=24):
    """Part of the pixels where two pictures differ by more than `tolerance` of 255."""
    return float(numpy.mean(numpy.abs(one - other).max(axis=-1) > tolerance))


def selected(view, source, kind):
    """What a rectangle over the whole view selects: a set of (block or -1, process, id)."""
    simple.Render(view)
    simple.ClearSelection(source)
    select = simple.SelectSurfacePoints if kind == "points" else simple.SelectSurfaceCells
    select(Rectangle=[0, 0, SIZE[0] - 1, SIZE[1] - 1], View=view)
    selection = source.SMProxy.GetSelectionInput(source.Port)
    found = set()
    if not selection:
        return found
    appended = selection.GetProperty("Input")
    for i in range(appended.GetNumberOfProxies()):
        ids = appended.GetProxy(i).GetProperty("IDs")
        values = [ids.GetElement(k) for k in range(ids.GetNumberOfElements())]
        width = 3 if "Composite" in appended.GetProxy(i).GetXMLName() else 2
        for k in range(0, len(values), width):
            found.add((-1, *values[k : k + 2]) if width == 2 else tuple(values[k : k + 3]))
    simple.ClearSelection(source)
    return found


def labels(view):
    """The ids that the last picture of a view has: a list of kinds, ids, places and rectangles of pixels, or None.

    Kinds are those of camaron::LabelKind.
    """
    actors = view.GetRenderer().GetActors()
    actors.InitTraversal()
    for _ in range(actors.GetNumberOfItems()):
        actor = actors.GetNextActor()
        data = actor.GetMapper().GetInput() if actor.GetVisibility() and actor.GetMapper() else None
        if data and data.GetFieldData().HasArray("LabelIds"):
            names = ("LabelKinds", "LabelIds", "LabelPlaces", "LabelPixels")
            return [vtk_to_numpy(data.GetFieldData().GetArray(name)).copy() for name in names]
    return None


class PictureTestCase(camaron_testing.TestCase):
    """Compares pictures of one source after the other in one view."""

    #: The range of the transfer function of what is colored; None: as ParaView chooses it.
    color_range = None

    def setUp(self):
        super().setUp()
        self.view = make_view()
        self.addCleanup(simple.ResetSession)

    def show(self, source, representation="Mesh Inspection", color=None, **properties):
        """Shows a source alone, without edges unless they are asked for; its display."""
        simple.HideAll(self.view)
        display = simple.Show(source, self.view)
        display.SetRepresentationType(representation)
        if color or display.ColorArrayName[1]:
            simple.ColorBy(display, color)
        if color:
            display.SetScalarBarVisibility(self.view, False)
        if color and self.color_range:
            table = display.LookupTable
            table.AutomaticRescaleRangeMode, table.NumberOfTableValues = "Never", 1024
            table.RescaleTransferFunction(*self.color_range)
        display.DrawEdges = 0
        for name, value in properties.items():
            setattr(display, name, value)
        return display

    def take(self, of=None):
        """The picture of what is shown, with a camera that sees all of it, and of another source."""
        if not of:
            turn(self.view)
            return picture(self.view)
        simple.Show(of, self.view)
        turn(self.view)
        camera = [list(self.view.CameraPosition), list(self.view.CameraFocalPoint)]
        simple.Hide(of, self.view)
        self.view.CameraPosition, self.view.CameraFocalPoint = camera
        return picture(self.view)

    def same(self, one, other, tolerance=0.004):
        self.assertLess(difference(one, other), tolerance)
        self.assertGreater(difference(one, one * 0 + 255), 0.05)  # there is a mesh
