# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cuts through cells of any shape, and isosurfaces in them: as many pixels as the section has area."""

import math

import camaron_testing
import numpy
from inspection_testing import make_view, picture
from paraview import simple
from touching_shapes import BLOCKS, POLYGONS, make_prisms


def star(size):
    return [
        (
            3 + (3 if i % 2 == 0 else 1.2) * math.cos(math.pi * i / size + 0.1),
            3 + (3 if i % 2 == 0 else 1.2) * math.sin(math.pi * i / size + 0.1),
        )
        for i in range(2 * size)
    ]


OUTLINES = {
    **{name: POLYGONS[name][0] for name in ("keyhole", "two-holes", "vertex", "edge")},
    "angle": BLOCKS["angle"][0],
    "comb": [(0, 0), (7, 0), (7, 4), (6, 4), (6, 1), (5, 1), (5, 4), (4, 4), (4, 1), (3, 1), (3, 4)]
    + [(2, 4), (2, 1), (1, 1), (1, 4), (0, 4)],
    "star": star(7),
    "spiral": [(0, 0), (6, 0), (6, 6), (1, 6), (1, 2), (4, 2), (4, 4), (3, 4), (3, 3), (2, 3)]
    + [(2, 5), (5, 5), (5, 1), (0, 1)],
}

#: Degrees by which they are turned: the first point by coordinates is another one each time, and no edge is along pixels.
TURNS = (20, 110, 200, 290)


def turn(outline, degrees):
    angle = math.radians(degrees)
    x, y = numpy.array(outline, float).T
    return numpy.stack(
        [math.cos(angle) * x - math.sin(angle) * y, math.sin(angle) * x + math.cos(angle) * y],
        axis=1,
    )


def edges(outline):
    return list(zip(outline, [*outline[1:], *outline[:1]]))


def shoelace(outline):
    return 0.5 * sum(a[0] * b[1] - a[1] * b[0] for a, b in edges(outline))


def clip(outline, low, high):
    """The part of a polygon in a rectangle, with edges along its sides that have no area between them."""
    for axis, bound, sign in ((0, low[0], 1), (1, low[1], 1), (0, high[0], -1), (1, high[1], -1)):
        clipped = []
        for a, b in edges(outline):
            depths = [sign * (corner[axis] - bound) for corner in (a, b)]
            if depths[0] >= 0:
                clipped.append(a)
            if (depths[0] >= 0) != (depths[1] >= 0):
                t = depths[0] / (depths[0] - depths[1])
                clipped.append(tuple(p + t * (q - p) for p, q in zip(a, b)))
        outline = clipped
    return outline


#: Side of the square around each prism.
TILE = 9


def tiles():
    """Name, outline and middle of prisms in rows, one for each turn."""
    for row, degrees in enumerate(TURNS):
        for column, (name, outline) in enumerate(OUTLINES.items()):
            turned = turn(outline, degrees)
            middle = TILE * (numpy.array([column, row]) + 0.5)
            turned += middle - 0.5 * (numpy.min(turned, axis=0) + numpy.max(turned, axis=0))
            yield f"{name} {degrees}", [tuple(map(float, corner)) for corner in turned], middle


@camaron_testing.require_display()
class TestCutTouchingCells(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        self.addCleanup(simple.ResetSession)
        self.columns, self.rows = len(OUTLINES), len(TURNS)
        self.middle = 0.5 * TILE * numpy.array([self.columns, self.rows])
        self.tiles = list(tiles())
        self.view = make_view()
        self.view.ViewSize = [200 * self.columns, 200 * self.rows]
        self.view.CameraParallelProjection = 1
        self.view.CameraParallelScale = 0.5 * TILE * self.rows

    def show(self, source=None, **properties):
        """What the cut opens is black."""
        simple.HideAll(self.view)
        source = source or make_prisms(*(outline for _, outline, _ in self.tiles))
        display = simple.Show(source, self.view)
        display.SetRepresentationType("Mesh Inspection")
        display.Ambient, display.Diffuse, display.Specular = 1, 0, 0
        display.ColorCutFaces, display.CutColor = 1, [0, 0, 0]
        display.DrawEdges = 0
        for name, value in properties.items():
            setattr(display, name, value)
        return display

    def cut(self, shape, keeps="Inside", properties=None, **parameters):
        display = self.show(CutBy="Exactly", CutShape=shape, CutKeeps=keeps, **(properties or {}))
        for name, value in parameters.items():
            setattr(display.CutShape, name, value)

    def check(self, expected, rows=None, along=(0, 0, 1), up=(0, 1, 0), edges=0):
        """The area that is black in the tiles of rows, seen from a direction, but for some pixels at edges.

        `expected`: of an outline; `edges`: how long they are along pixels, at most, in lengths of the mesh.
        """
        view, along, up = self.view, numpy.array(along), numpy.array(up)
        middle, size = numpy.array([*self.middle, 0.5]), 0.5 * TILE
        right = numpy.cross(up, along)
        picture(view)  # the first one moves the camera
        view.CameraFocalPoint, view.CameraViewUp = list(middle), list(up)
        view.CameraPosition = list(middle + 50 * along)
        view.CameraParallelScale = size * self.rows
        black = 1 - picture(view).max(axis=2) / 255
        pixel = TILE * self.rows / black.shape[0]
        for i, (name, outline, place) in enumerate(self.tiles):
            if rows is None or i // self.columns in rows:
                place = numpy.array([*place, 0.5]) - middle
                x, y = (
                    [round(0.5 * n + (place @ axis + side) / pixel) for side in (-size, size)]
                    for n, axis in zip(black.shape[::-1], (right, up))
                )
                area = expected(outline)
                with self.subTest(name):
                    found = pixel**2 * numpy.sum(black[y[0] : y[1], x[0] : x[1]])
                    self.assertAlmostEqual(found, area, delta=0.01 * area + 0.5 * edges * pixel)

    def test_plane(self):
        """Planes between bottom and top, from both sides: the section has the outline of the prism."""
        self.cut("Plane", Origin=[*self.middle, 0.45], Normal=[0, 0, 1])
        self.check(shoelace)
        self.cut("Plane", "Outside", Origin=[*self.middle, 0.45], Normal=[0.005, -0.008, 1])
        self.check(shoelace, along=(0, 0, -1))

    def test_upright_plane(self):
        """As high as the prism, and as long as the line through its outline."""
        for row, share in enumerate((-0.27, 0.21, 0.07, 0.33)):
            y = TILE * (row + 0.5) + share
            thin = 1e-6
            self.cut("Plane", "Outside", Origin=[0, y, 0], Normal=[0, 1, 0])
            strip = (-1, y), (TILE * (self.columns + 1), y + thin)
            self.check(
                lambda outline: shoelace(clip(outline, *strip)) / thin,
                [row],
                (0, -1, 0),
                (0, 0, 1),
                12,
            )

    def test_box(self):
        """Its upper side is seen in what it cuts out, its floor in what is left."""
        end = 2 * self.middle
        for keeps, bottom, top, part in (("Inside", -1, 0.4, 0.45), ("Outside", 0.3, 2, 1.6)):
            low, high = numpy.full(2, part * TILE), end - part * TILE
            size = [*(high - low), top - bottom]
            self.cut("Box", keeps, Position=[*low, bottom], Length=size)
            self.check(lambda outline: shoelace(clip(outline, low, high)), edges=2)

    def test_sphere(self):
        """A large one goes through the prisms between bottom and top."""
        self.cut("Sphere", Center=[*self.middle, 0.9 - 2000], Radius=2000)
        self.check(shoelace)

    def test_moved_cells(self):
        """Where the prisms are drawn smaller."""
        self.cut("Plane", properties={"ShrinkFactor": 0.8}, Origin=[0, 0, 0.45], Normal=[0, 0, 1])
        self.check(lambda outline: 0.8**2 * shoelace(outline))

    def test_isosurface(self):
        """Of a linear array: the section of the prism."""
        elevation = simple.Elevation(Input=make_prisms(*(outline for _, outline, _ in self.tiles)))
        elevation.LowPoint, elevation.HighPoint = [*self.middle, -0.5], [
            *(self.middle + [0.01, 0.02]),
            1.5,
        ]
        display = self.show(elevation, DrawFaces=0, DrawIsosurfaces=1)
        simple.ColorBy(display, None)
        display.AmbientColor = display.DiffuseColor = [0, 0, 0]
        display.IsosurfaceArray, display.IsosurfaceValues = ["POINTS", "Elevation"], [0.5]
        self.check(shoelace)


if __name__ == "__main__":
    camaron_testing.main()
