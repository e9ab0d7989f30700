# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""A scene for each mode of Mesh Inspection and for each combination that matters.

Their pictures are kept in Testing/Baselines, named as the scenes. After a change that is meant to be seen,
`pvpython inspection_scenes.py` writes them anew (on Mesa's llvmpipe): look at each before you keep it.
"""

import os

import gallery
import numpy
from camaron_testing import EXAMPLES, ROOT
from inspection_testing import make_view, picture
from mesh_parts import producer
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

BASELINES = ROOT / "Testing" / "Baselines"
SIZE = [200, 160]

HEIGHT = ("POINTS", "Elevation")
VOLUME = ("CELLS", "Volume")
SPHERE = {"CutShape": "Sphere", "Center": [0.5, 0.4, 0.8], "Radius": 0.9}
PLANE = {"CutShape": "Plane", "Origin": [0.1, 0, 0.2], "Normal": [0.3, 0.2, -1]}
BOX = {"CutShape": "Box", "Position": [0, -0.2, 0], "Length": [2, 2, 2]}
WEDGE = {"CutShape": "HalfSpaces", "Planes": [0.2, 0, 0, -1, 0, 0, 0, 0, 0.1, 0, 0, -1]}
ISOSURFACES = {
    "DrawIsosurfaces": 1,
    "IsosurfaceArray": "Elevation",
    "IsosurfaceValues": [0.3, 0.5, 0.7],
}
ISOLINES = {"DrawIsolines": 1, "IsolineArray": "Elevation", "IsolineSpacing": 0.1}

SHAPE_PROPERTIES = {"Center", "Radius", "Origin", "Normal", "Position", "Length", "Planes"}

#: Name: (mesh, array that colors it or None, properties of the display and of the shape of its cut).
SCENES = {
    "property-of-cells": ("ball", VOLUME, {}),
    "property-of-points": ("ball", HEIGHT, {"DrawEdges": 0}),
    "two-colors": ("ball", VOLUME, {"Coloring": "Two colors"}),
    "height": ("ball", None, {"Coloring": "Height", "HeightDirection": [1, 1, 0]}),
    "depth": ("ball", None, {"Coloring": "Depth"}),
    "emphasis": (
        "ball",
        VOLUME,
        {"Emphasis": "Outside range", "AcceptableRange": [0.12, 0.15], "Dimming": 1},
    ),
    "edges-alone": ("ball", VOLUME, {"DrawFaces": 0}),
    "edges-wide": ("ball", None, {"LineWidth": 4, "EdgeColor": [0.7, 0.1, 0.1]}),
    "edges-of-selected": ("selected", VOLUME, {"EdgesOf": "Selected cells"}),
    "cells-selected": ("selected", VOLUME, {"CellsToDraw": "Selected"}),
    "cells-unselected": ("selected", VOLUME, {"CellsToDraw": "Unselected"}),
    "interior": ("ball", VOLUME, {"FacesToDraw": "Interior", "Opacity": 0.3}),
    "interior-shrunk": ("ball", VOLUME, {"FacesToDraw": "Interior", "ShrinkFactor": 0.7}),
    "complete-shrunk": ("ball", VOLUME, {"FacesToDraw": "Complete", "ShrinkFactor": 0.7}),
    "exploded": ("ball", VOLUME, {"ExplodeFactor": 0.6}),
    "smooth-shading": ("ball", None, {"DrawEdges": 0, "SmoothShading": 1, "Specular": 0.8}),
    "translucent": ("ball", VOLUME, {"Opacity": 0.4}),
    "back-faces": (
        "open",
        None,
        {"BackfaceRepresentation": "Surface", "BackfaceDiffuseColor": [0.9, 0.6, 0.1]},
    ),
    "normals-of-faces": ("ball", None, {"DrawNormals": "Faces"}),
    "normals-of-vertices": ("ball", None, {"DrawNormals": "Vertices", "DrawFaces": 0}),
    "points": ("ball", HEIGHT, {"DrawPoints": 1, "DrawFaces": 0, "DrawEdges": 0, "PointSize": 4}),
    "ids-of-points": ("few", None, {"DrawPointIds": 1}),
    "ids-of-edges": ("few", None, {"DrawEdgeIds": 1}),
    "ids-of-faces": ("few", None, {"DrawFaceIds": 1}),
    "ids-of-cells": ("few", None, {"DrawCellIds": 1}),
    "glass": ("ball", VOLUME, {"GlassShell": 1, "CutBy": "Centroid", **SPHERE}),
    "glass-isosurfaces": (
        "ball",
        HEIGHT,
        {"GlassShell": 1, "DrawFaces": 0, "DrawEdges": 0, **ISOSURFACES},
    ),
    "isosurfaces": ("ball", VOLUME, {"DrawFaces": 0, "DrawEdges": 0, **ISOSURFACES}),
    "isosurfaces-edges": (
        "ball",
        HEIGHT,
        {"DrawFaces": 0, **ISOSURFACES, "CutBy": "Centroid", **PLANE},
    ),
    "isolines": ("ball", HEIGHT, {"DrawEdges": 0, "IsolineWidth": 2, **ISOLINES}),
    "isolines-cut": ("ball", VOLUME, {"CutBy": "Exactly", "DrawEdges": 0, **SPHERE, **ISOLINES}),
    "cut-by-centroid": ("ball", VOLUME, {"CutBy": "Centroid", **SPHERE}),
    "cut-by-any-vertex": ("ball", VOLUME, {"CutBy": "Any vertex", **SPHERE}),
    "cut-by-all-vertices": ("ball", VOLUME, {"CutBy": "All vertices", **SPHERE}),
    "cut-exactly": ("ball", VOLUME, {"CutBy": "Exactly", **SPHERE}),
    "cut-exactly-values": ("ball", HEIGHT, {"CutBy": "Exactly", **PLANE}),
    "cut-keeps-inside": ("ball", VOLUME, {"CutBy": "Any vertex", "CutKeeps": "Inside", **SPHERE}),
    "cut-by-box": ("ball", VOLUME, {"CutBy": "Exactly", **BOX}),
    "cut-by-half-spaces": ("ball", VOLUME, {"CutBy": "Centroid", **WEDGE}),
    "cut-border": ("ball", VOLUME, {"CutBy": "Centroid", "ColorCutFaces": 1, **PLANE}),
    "tetrahedra": ("tetrahedra", HEIGHT, {"CutBy": "Centroid", "GlassShell": 1, **SPHERE}),
    "surface": ("surface", HEIGHT, {"SmoothShading": 1, **ISOLINES}),
    "mixed-shrunk": ("few", VOLUME, {"ShrinkFactor": 0.8}),
}


class Scenes:
    """A view, and the meshes of the scenes in it."""

    def __init__(self):
        self.view = make_view()
        self.view.ViewSize = SIZE
        simple.Render(self.view)  # the first time moves the camera
        self.meshes = self.make_meshes()

    def make_meshes(self):
        """What the scenes show, by name."""
        sphere = simple.Sphere(Radius=1, ThetaResolution=20, PhiResolution=20)
        ball = self.measured(self.inner_cells())
        chosen = simple.SelectElements(Input=ball, Strategy="Shape", Shape="Sphere")
        chosen.Shape.Center, chosen.Shape.Radius = [0.5, 0.4, 0.8], 0.7
        block = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2]))
        return {
            "ball": ball,
            "few": self.measured(producer(gallery.mixed())),
            "open": simple.Clip(Input=sphere, ClipType="Plane"),
            "selected": chosen,
            "surface": self.measured(sphere),
            "tetrahedra": self.measured(self.scaled(block, 0.5)),
        }

    @staticmethod
    def scaled(mesh, factor):
        """With coordinates `factor` times as large."""
        scaled = simple.Transform(Input=mesh, TransformAllInputVectors=0)
        scaled.Transform.Scale = 3 * [factor]
        return scaled

    @staticmethod
    def inner_cells():
        """Some 20 Voronoi cells about a ball of radius 1: few enough for Mesa's softpipe."""
        mesh = simple.OpenDataFile(str(EXAMPLES / "voronoi-ball.visf"))
        inner = simple.SelectElements(Input=mesh, Strategy="Shape", Shape="Sphere")
        inner.Shape.Center, inner.Shape.Radius = [0, 0, 0], 0.28
        cells = simple.Threshold(Input=inner, Scalars=["CELLS", "Selected"])
        cells.LowerThreshold = cells.UpperThreshold = 1
        cells = simple.PassArrays(Input=cells, CellDataArrays=[], PointDataArrays=[])
        return Scenes.scaled(cells, 3.1)

    @staticmethod
    def measured(mesh):
        """With a value of points and a criterion of cells."""
        heights = simple.Elevation(Input=mesh, LowPoint=[-0.6, -0.8, 0], HighPoint=[0.6, 0.8, 0])
        return simple.ElementQuality(Input=heights, Criteria=["Volume"])

    def look_at(self, source):
        """From no special direction, whatever is drawn of the source."""
        source.UpdatePipeline()
        low, high = numpy.array(source.GetDataInformation().GetBounds()).reshape(3, 2).T
        middle, size = (low + high) / 2, numpy.linalg.norm(high - low)
        self.view.CameraFocalPoint, self.view.CameraViewUp = list(middle), [0, 1, 0]
        self.view.CameraPosition = list(middle + size * numpy.array([0.7, 0.5, 1.1]))

    def picture(self, name):
        """What a scene looks like, as an array of (height, width, 3) from 0 to 255."""
        mesh, color, properties = SCENES[name]
        source = self.meshes[mesh]
        display = simple.Show(source, self.view)
        display.SetRepresentationType("Mesh Inspection")
        if color or display.ColorArrayName[1]:
            simple.ColorBy(display, color)
        if color:
            display.LookupTable.ApplyPreset(
                "Cool to Warm", True
            )  # no longer the default in ParaView 6
        display.SetScalarBarVisibility(self.view, False)
        if "CutShape" in properties:
            display.CutShape = properties["CutShape"]
        for key, value in properties.items():
            if key != "CutShape":
                setattr(display.CutShape if key in SHAPE_PROPERTIES else display, key, value)
        self.look_at(source)
        taken = picture(self.view)
        simple.Delete(display)
        return taken


def write(path, colors):
    """Stores a picture."""
    image = vtkImageData()
    image.SetDimensions(colors.shape[1], colors.shape[0], 1)
    rows = numpy.ascontiguousarray(colors.reshape(-1, 3), dtype=numpy.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(rows, deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()


def main():
    scenes = Scenes()
    BASELINES.mkdir(exist_ok=True)
    for name in SCENES:
        write(BASELINES / f"{name}.png", scenes.picture(name))


if __name__ == "__main__":
    main()
    os._exit(0)  # pvpython can hang while it closes
