# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of Mesh Inspection, beside those of the ParaView pipelines that show the same, in one run.

Usage: BenchmarkInspection [millions of tetrahedra] [millions of polyhedra]

Times are medians of whole frames, from the change of a property to the picture in the window, which is then read back.
On a software renderer they say little about a graphics card: the renderer is printed. What takes ParaView minutes with a
million polyhedra it does with fewer. Of 0 millions there are no pictures.
"""

import os
import subprocess
import sys
import tempfile
import time

from benchmark_records import CELLS_FOR_SLOW_PEERS, OURS, median, record, repeat
from paraview import simple

from camaron.common import pipeline

pipeline.load_plugin()

SIZE = [800, 600]


def memory():
    """Bytes of this process in memory."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4096


class Bench:
    """One mesh in a view."""

    def __init__(self, name, path):
        self.name = name
        self.view = simple.CreateRenderView(ViewSize=SIZE, OrientationAxesVisibility=0)
        # Times of what is asked for, not of what stands in for it.
        self.view.EnableRenderOnInteraction = 1
        self.view.LODThreshold = 1e9
        self.path = path
        self.renderer = self.driver = None
        simple.SetActiveView(self.view)

    def frame(self):
        """Draws once, and waits until it is drawn. simple.Render() would draw twice before the picture is asked for."""
        self.view.SMProxy.CaptureWindow(1)

    def print(self, work, by, times, memory=0):
        by = by or OURS
        record(work, self.name, by, self.cells, times, peak=memory, **self.card())
        time_of_one = median(times)
        print(
            f"  {work:<40s} {by:<24s} {1000 * time_of_one:9.1f} ms"
            f" {1e9 * time_of_one / self.cells:9.1f} ns/cell",
            flush=True,
        )

    def card(self):
        return {"renderer": self.renderer, "driver": self.driver}

    def frames(self, work, change, by=None):
        """Prints what a frame takes after each call of change(part), from 0 to 1; the first is not counted."""

        def one(part):
            change(part)
            self.frame()

        one(0)
        self.print(work, by, repeat(one))

    def open(self, representation):
        """The first picture of the file, again and again; what it adds to memory is that of the first time."""
        used, shown = None, []

        def first(_):
            nonlocal used
            if used is not None:
                self.close()
            self.source = simple.OpenDataFile(self.path)
            self.source.UpdatePipeline()
            read = memory()
            self.cells = self.source.GetDataInformation().GetNumberOfCells()
            wall, processor = time.perf_counter(), time.process_time()
            self.display = simple.Show(self.source, self.view)
            self.display.SetRepresentationType(representation)
            self.view.ResetCamera()
            self.frame()
            shown.append((time.perf_counter() - wall, time.process_time() - processor))
            used = memory() - read if used is None else used

        times = repeat(first)
        if not self.renderer:
            information = self.view.SMProxy.GetRenderWindow().ReportCapabilities()
            lines = dict(line.partition(":")[::2] for line in information.splitlines())
            self.renderer = lines["OpenGL renderer string"].strip()
            self.driver = lines["OpenGL version string"].strip()
            print(f"{self.name}: {self.cells} cells, {SIZE[0]} x {SIZE[1]} pixels")
            print(f"  {self.renderer}, OpenGL {self.driver}")
        by = None if representation == "Mesh Inspection" else representation
        self.print("first picture, with reading", by, times, used)
        self.print("first picture, without reading", by, sorted(shown))
        print(f"  memory beside the mesh {used / 1e6:9.1f} MB {used / self.cells:9.1f} bytes/cell")

    def close(self):
        simple.Delete(self.source)
        del self.source

    def turn(self, work, by=None):
        self.frames(work, lambda part: self.view.GetActiveCamera().Azimuth(5), by)

    def pick(self, by=None):
        """Finds the cells that are seen in a quarter of a view that has changed."""
        corners = [n * size // 4 for n in (1, 3) for size in SIZE]

        def one(_):
            self.view.GetActiveCamera().Azimuth(5)
            simple.SelectSurfaceCells(Rectangle=corners, View=self.view)

        one(0)
        times = repeat(one)
        simple.ClearSelection(self.source)
        self.print("cells in a rectangle are picked", by, times)

    def hide(self):
        simple.HideAll(self.view)

    def center(self, part):
        """A point on the diagonal of the mesh."""
        bounds = self.source.GetDataInformation().GetBounds()
        return [low + part * (high - low) for low, high in zip(bounds[::2], bounds[1::2])]

    def radius(self):
        bounds = self.source.GetDataInformation().GetBounds()
        return 0.4 * max(high - low for low, high in zip(bounds[::2], bounds[1::2]))

    def field(self):
        field = simple.Calculator(
            Input=self.source, Function="sin(coordsX*9)+coordsY*coordsZ", ResultArrayName="Field"
        )
        field.UpdatePipeline()
        return field

    def ours(self):
        self.open("Mesh Inspection")
        display = self.display
        self.turn("camera moves")
        self.pick()
        display.DrawEdges = 0
        self.turn("camera moves, without edges")
        display.DrawEdges = 1
        display.DrawPointIds = display.DrawCellIds = 1
        self.turn("camera moves, ids of points and cells")
        display.DrawPointIds = display.DrawCellIds = 0
        display.CutShape = "Sphere"
        display.CutShape.Radius = self.radius()
        for cut, what in (
            ("Centroid", "sphere moves, whole cells by centroid"),
            ("Any vertex", "sphere moves, whole cells by vertex"),
            ("Exactly", "sphere moves, exact cut"),
        ):
            display.CutBy = cut
            self.frames(what, lambda part: setattr(display.CutShape, "Center", self.center(part)))
        self.turn("camera moves, exact cut")
        display.CutBy = "Centroid"
        display.GlassShell = 1
        self.turn("camera moves, glass")
        display.GlassShell = 0
        display.CutBy = "No cut"
        self.hide()
        field = self.field()
        display = simple.Show(field, self.view)
        display.SetRepresentationType("Mesh Inspection")
        display.DrawFaces = display.DrawEdges = 0
        display.DrawIsosurfaces = 1
        display.IsosurfaceArray = ["POINTS", "Field"]
        self.frames(
            "3 isosurfaces, other values",
            lambda part: setattr(display, "IsosurfaceValues", isovalues(part)),
        )
        self.turn("camera moves, isosurfaces")
        simple.Delete(field)
        self.close()

    def peers(self):
        """What ParaView shows the same with."""
        self.open("Surface With Edges")
        self.turn("camera moves", "Surface With Edges")
        self.display.SetRepresentationType("Surface")
        self.turn("camera moves, without edges", "Surface")
        self.pick("Surface")
        self.hide()
        for what, shape, whole in (
            ("sphere moves, whole cells by vertex", "Clip, crinkle", 1),
            ("sphere moves, exact cut", "Clip", 0),
        ):
            clip = simple.Clip(Input=self.source, ClipType="Sphere", Invert=0, Crinkleclip=whole)
            clip.ClipType.Radius = self.radius()
            clip.ClipType.Center = self.center(0)
            simple.Show(clip, self.view)
            self.frames(
                what, lambda part: setattr(clip.ClipType, "Center", self.center(part)), shape
            )
            simple.Delete(clip)
        field = self.field()
        contour = simple.Contour(Input=field, ContourBy=["POINTS", "Field"], ComputeNormals=0)
        contour.Isosurfaces = isovalues(0)
        simple.Show(contour, self.view).SetRepresentationType("Surface")
        self.frames(
            "3 isosurfaces, other values",
            lambda part: setattr(contour, "Isosurfaces", isovalues(part)),
            "Contour",
        )
        simple.Delete(contour)
        simple.Delete(field)
        self.close()


def isovalues(part):
    return [-0.8 + 0.1 * part, 0.1 + 0.1 * part, 0.6 + 0.1 * part]


def main():
    make, *numbers = sys.argv[1:]
    tetrahedra, polyhedra = [float(number) for number in numbers] + [1, 0.05][len(numbers) :]
    with tempfile.TemporaryDirectory() as folder:
        for kind, millions, most in (
            ("tetrahedra", tetrahedra, tetrahedra),
            ("polyhedra", polyhedra, 1e-6 * CELLS_FOR_SLOW_PEERS),
        ):
            if not millions:
                continue

            def bench(cells):
                path = os.path.join(folder, f"{kind}.visf")
                subprocess.run([make, kind, str(int(1e6 * cells)), path], check=True)
                return Bench(kind, path)

            ours = bench(millions)
            ours.ours()
            peers = ours if millions <= most else bench(most)
            peers.peers()
            for view in {ours.view, peers.view}:
                simple.Delete(view)


main()
sys.stdout.flush()
os._exit(0)  # pvpython can hang while it closes
