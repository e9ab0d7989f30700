# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ten isosurfaces, made on the graphics card, in a mesh of 109 thousand tetrahedra under glass.

./camaron shell pvpython Examples/isosurfaces.py [PICTURE.png [CELLS]]
"""
import sys

from paraview.simple import *

LoadDistributedPlugin("Camaron", ns=globals())
picture = sys.argv[1] if len(sys.argv) > 1 else "isosurfaces.png"
cells = int(sys.argv[2]) if len(sys.argv) > 2 else 109000

n = round((cells / 5) ** (1 / 3) / 2)
block = Tetrahedralize(Input=Wavelet(WholeExtent=[-n, n, -n, n, -n, n]))
x, y, z = (f"(coords{axis}/{n})" for axis in "XYZ")
field = Calculator(
    Input=block,
    ResultArrayName="Field",
    Function=f"cos(3*{x})*cos(3*{y}) + cos(3*{y})*cos(3*{z}) + cos(3*{z})*cos(3*{x})",
)

view = CreateRenderView(ViewSize=[1200, 1000], UseColorPaletteForBackground=0, Background=[1, 1, 1])
view.OrientationAxesVisibility = 0
display = Show(field, view)
display.SetRepresentationType("Mesh Inspection")
ColorBy(display, ("POINTS", "Field"))
display.DrawFaces = display.DrawEdges = 0
display.DrawIsosurfaces = 1
display.IsosurfaceArray = ["POINTS", "Field"]
display.IsosurfaceValues = [-0.9 + 0.4 * i for i in range(10)]
display.GlassShell = 1
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [30, -45, 25], [0, 0, 0], [0, 0, 1]
ResetCamera(view)
SaveScreenshot(picture, view)
