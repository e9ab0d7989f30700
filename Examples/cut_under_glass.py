# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""A torso-like mesh of a million tetrahedra, cut open under glass and colored by quality.

./camaron shell pvpython Examples/cut_under_glass.py [PICTURE.png [CELLS]]
"""
import sys

from paraview.simple import *

LoadDistributedPlugin("Camaron", ns=globals())
picture = sys.argv[1] if len(sys.argv) > 1 else "cut_under_glass.png"
cells = int(sys.argv[2]) if len(sys.argv) > 2 else 1000000

# A block of tetrahedra, five to a voxel, bent into shape: squares become ellipses, and these a torso.
n = round((cells / 5) ** (1 / 3) / 2)
block = Tetrahedralize(Input=Wavelet(WholeExtent=[-n, n, -n, n, -n, n]))
u, v, w = (f"(coords{axis}/{n})" for axis in "XYZ")
width = f"(1 + 0.25*cos(2.6*{w} - 0.6) - 0.3*{w}^6)"
torso = Calculator(
    Input=block,
    CoordinateResults=1,
    Function=f"1.1*{width}*{u}*sqrt(1 - {v}^2/2)*iHat + 0.7*{width}*{v}*sqrt(1 - {u}^2/2)*jHat + 2*{w}*kHat",
)
quality = ElementQuality(Input=torso, Criteria=["MinDihedralAngle"])

quality.UpdatePipeline()
values = quality.CellData["MinDihedralAngle"].GetRange()
look = servermanager.misc.QualityColors(Range=values, Acceptable=[20, sys.float_info.max], Better=1)
look.UpdatePropertyInformation()
view = CreateRenderView(ViewSize=[1200, 1000], UseColorPaletteForBackground=0)
view.Background, view.OrientationAxesVisibility = look.Background, 0
display = Show(quality, view)  # as Mesh Inspection, as all that Element Quality makes
ColorBy(display, ("CELLS", "MinDihedralAngle"))
colors = GetColorTransferFunction("MinDihedralAngle")
colors.AutomaticRescaleRangeMode, colors.ColorSpace = "Never", "RGB"
colors.RGBPoints = look.GetPropertyValue("Points")
for name in ("Ambient", "Diffuse", "EdgeColor", "EdgeOpacity"):
    setattr(display, name, getattr(look, name))
display.CutBy = "Centroid"
display.CutShape = "Sphere"
display.CutShape.Center = [0.8, -0.9, 0.9]
display.CutShape.Radius = 1.3
display.GlassShell = 1
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [4.5, -7, 2.5], [0, 0, 0], [0, 0, 1]
ResetCamera(view)
GetActiveCamera().Zoom(1.25)
SaveScreenshot(picture, view)
