# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Isolines of constant width on a surface of 870 thousand triangles; no geometry is made for them.

./camaron shell pvpython Examples/isolines.py [PICTURE.png [TRIANGLES]]
"""
import sys

from paraview.simple import *

LoadDistributedPlugin("Camaron", ns=globals())
picture = sys.argv[1] if len(sys.argv) > 1 else "isolines.png"
triangles = int(sys.argv[2]) if len(sys.argv) > 2 else 870000

n = round((triangles / 2) ** 0.5)
sphere = Sphere(Radius=1, ThetaResolution=n, PhiResolution=n)
hills = "(0.15*sin(5*coordsX)*cos(4*coordsY) + 0.1*sin(7*coordsZ + 2*coordsX))"
surface = Calculator(Input=sphere, CoordinateResults=1, Function=f"(1 + {hills})*coords")
height = Calculator(Input=surface, ResultArrayName="Radius", Function="mag(coords)")

view = CreateRenderView(ViewSize=[1200, 1000], UseColorPaletteForBackground=0, Background=[1, 1, 1])
view.OrientationAxesVisibility = 0
display = Show(height, view)
display.SetRepresentationType("Mesh Inspection")
ColorBy(display, ("POINTS", "Radius"))
display.DrawEdges = 0
display.DrawIsolines = 1
display.IsolineArray = ["POINTS", "Radius"]
display.IsolineFirst = 1
display.IsolineSpacing = 0.025
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [3, -4, 2], [0, 0, 0], [0, 0, 1]
ResetCamera(view)
SaveScreenshot(picture, view)
