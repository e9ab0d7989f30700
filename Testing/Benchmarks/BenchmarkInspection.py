# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of Mesh Inspection, beside those of the ParaView pipelines that show the same, in one run.

Usage: BenchmarkInspection [millions of tetrahedra] [millions of polyhedra]

Times are medians of whole frames, from the change of a property to the picture in the window, which is then read back.
On a software renderer they say little about a graphics card: the renderer is printed.
"""

import os
import statistics
import subprocess
import sys
import tempfile
import time

from paraview import servermanager, simple

from camaron.common import pipeline

pipeline.load_plugin()

SIZE = [800, 600]
FRAMES = 7


def memory():
    """Bytes of this process in memory."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4096


def seconds(work):
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


class Bench:
    """One mesh in a view."""

    def __init__(self, name, path):
        self.name = name
        self.view = simple.CreateRenderView(ViewSize=SIZE, OrientationAxesVisibility=0)
        # Times of what is asked for, not of what stands in for it.
        self.view.EnableRenderOnInteraction = 1
        self.view.LODThreshold = 1e9
        self.path = path
        simple.SetActiveView(self.view)

    def frame(self):
        """Draws once, and waits until it is drawn. simple.Render() would draw twice before the picture is asked for."""
        self.view.SMProxy.CaptureWindow(1)

    def print(self, what, by, times):
        print(
            f"  {what:<40s} {by:<24s} {1000 * statistics.median(times):9.1f} ms"
            f" {1e9 * statistics.median(times) / self.cells:9.1f} ns/cell",
            flush=True,
        )

    def frames(self, what, by, change):
        """Prints what a frame takes after each call of change(part), from 0 to 1; the first is not counted."""

        def one(part):
            change(part)
            self.frame()

        one(0)
        self.print(what, by, [seconds(lambda: one((i + 1) / FRAMES)) for i in range(FRAMES)])

    def open(self, representation):
        """The first picture of the file."""
        before = memory()

        def first():
            source = simple.OpenDataFile(self.path)
            source.UpdatePipeline()
            self.read = memory() - before
            self.cells = source.GetDataInformation().GetNumberOfCells()
            self.display = simple.Show(source, self.view)
            self.display.SetRepresentationType(representation)
            self.view.ResetCamera()
            self.frame()
            self.source = source

        self.print_first(representation, seconds(first), memory() - before)

    def print_first(self, representation, time_of_first, used):
        if not hasattr(self, "announced"):
            information = self.view.SMProxy.GetRenderWindow().ReportCapabilities()
            renderer = next(
                line for line in information.splitlines() if line.startswith("OpenGL renderer")
            )
            print(f"{self.name}: {self.cells} cells, {SIZE[0]} x {SIZE[1]} pixels, {renderer}")
            self.announced = True
        self.print("first picture, reading included", representation, [time_of_first])
        print(
            f"  {'memory beside the mesh':<40s} {representation:<24s} {(used - self.read) / 1e6:9.1f} MB"
            f" {(used - self.read) / self.cells:9.1f} bytes/cell",
            flush=True,
        )

    def close(self):
        simple.Delete(self.source)

    def turn(self, by):
        self.frames("camera moves", by, lambda part: self.view.GetActiveCamera().Azimuth(5))

    def hide(self):
        simple.HideAll(self.view)

    def run(self, surface):
        """Everything; Surface and what builds on it only if it can be waited for."""
        if surface:
            self.open("Surface With Edges")
            self.turn("Surface With Edges")
            self.close()
        self.open("Mesh Inspection")
        display = self.display
        self.turn("Mesh Inspection")
        bounds = self.source.GetDataInformation().GetBounds()
        low = [bounds[0], bounds[2], bounds[4]]
        size = [bounds[2 * i + 1] - bounds[2 * i] for i in range(3)]
        radius = 0.4 * max(size)
        center = lambda part: [low[i] + part * size[i] for i in range(3)]

        display.CutShape = "Sphere"
        display.CutShape.Radius = radius
        for cut in ("Centroid", "Any vertex", "Exactly"):
            display.CutBy = cut
            move = lambda part: setattr(display.CutShape, "Center", center(part))
            self.frames(f"sphere moves, by {cut.lower()}", "Mesh Inspection", move)
        self.turn("Mesh Inspection, exact cut")
        display.CutBy = "Centroid"
        display.GlassShell = 1
        self.turn("Mesh Inspection, glass")
        display.GlassShell = 0
        display.CutBy = "No cut"

        if surface:
            self.hide()
            clip = simple.Clip(Input=self.source, ClipType="Sphere", Invert=0, Crinkleclip=1)
            clip.ClipType.Radius = radius
            clip.ClipType.Center = center(0)
            simple.Show(clip, self.view)
            move = lambda part: setattr(clip.ClipType, "Center", center(part))
            self.frames("sphere moves", "Clip, crinkle", move)
            simple.Delete(clip)

        field = simple.Calculator(
            Input=self.source, Function="sin(coordsX*9)+coordsY*coordsZ", ResultArrayName="Field"
        )
        field.UpdatePipeline()
        values = lambda part: [-0.8 + 0.1 * part, 0.1 + 0.1 * part, 0.6 + 0.1 * part]
        self.hide()
        display = simple.Show(field, self.view)
        display.SetRepresentationType("Mesh Inspection")
        display.DrawFaces = display.DrawEdges = 0
        display.DrawIsosurfaces = 1
        display.IsosurfaceArray = ["POINTS", "Field"]
        change = lambda part: setattr(display, "IsosurfaceValues", values(part))
        self.frames("3 isosurfaces, other values", "Mesh Inspection", change)
        self.turn("Mesh Inspection, isosurfaces")
        self.hide()
        contour = simple.Contour(Input=field, ContourBy=["POINTS", "Field"], ComputeNormals=0)
        contour.Isosurfaces = values(0)
        simple.Show(contour, self.view).SetRepresentationType("Surface")
        self.frames(
            "3 isosurfaces, other values",
            "Contour",
            lambda part: setattr(contour, "Isosurfaces", values(part)),
        )
        simple.Delete(contour)
        simple.Delete(field)
        self.close()
        simple.Delete(self.view)


def main():
    make, *numbers = sys.argv[1:]
    tetrahedra, polyhedra = [float(number) for number in numbers] + [1, 0.05][len(numbers) :]
    with tempfile.TemporaryDirectory() as folder:
        for kind, millions, surface in (
            ("tetrahedra", tetrahedra, True),
            # ParaView takes minutes to draw the surface of a million, and more to contour them.
            ("polyhedra", polyhedra, polyhedra <= 0.1),
        ):
            path = os.path.join(folder, f"{kind}.visf")
            subprocess.run([make, kind, str(int(1e6 * millions)), path], check=True)
            Bench(kind, path).run(surface)


main()
sys.stdout.flush()
os._exit(0)  # pvpython can hang while it closes
