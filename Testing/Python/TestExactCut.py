# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cuts through cells: pictures and selections are those of ParaView's Clip, and of the shape itself."""

import re

import camaron_testing
import numpy
from inspection_testing import PictureTestCase, difference, selected
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_OBJECT

ORIGIN, NORMAL = [0.3, -0.2, 0.15], [-0.5, -0.3, -0.8]


def hexahedra():
    mesh = simple.AppendDatasets(Input=[simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5])])
    return simple.PointAndCellIds(Input=mesh)


def polyhedra():
    mesh = simple.OpenDataFile(str(camaron_testing.EXAMPLES / "voronoi-ball.visf"))
    return simple.PointAndCellIds(Input=mesh)


def places(source, words):
    """Where main() of a shader has one of the words, or calls a function that has."""
    source = re.sub("//.*", "", source)
    found = re.findall(r"^\w+ (\w+)\([^;{}]*\)\s*(\{[^\n]+\}$|\{\n.*?^\})", source, re.M | re.S)
    while True:
        pattern = rf"\b({'|'.join(words)})\b"
        names = {name for name, body in found if name != "main" and re.search(pattern, body)}
        if names <= words:
            return [match.start() for match in re.finditer(pattern, dict(found)["main"])]
        words = words | names


@camaron_testing.require_display()
class TestExactCut(PictureTestCase):
    color_range = (-1.0, 1.0)

    def heights(self, mesh, scale):
        """A linear array from -1 to 1."""
        end = numpy.array([3.0, 4.0, 5.0]) / 50**0.5 * scale
        return simple.Elevation(
            Input=mesh, LowPoint=list(-end), HighPoint=list(end), ScalarRange=[-1.0, 1.0]
        )

    def test_plane(self):
        """As Clip does it, with whatever colors, on either side, through hexahedra and polyhedra."""
        for name, mesh, scale in (("hexahedra", hexahedra(), 8), ("polyhedra", polyhedra(), 1)):
            mesh = self.heights(mesh, scale)
            frame = simple.Outline(Input=mesh)
            origin = [scale / 4 * x for x in ORIGIN]
            for keeps in ("Outside", "Inside"):
                clip = simple.Clip(Input=mesh, ClipType="Plane", Invert=int(keeps == "Inside"))
                clip.ClipType.Origin, clip.ClipType.Normal = origin, NORMAL
                for color in (None, ("POINTS", "Elevation"), ("CELLS", "CellIds")):
                    with self.subTest(mesh=name, keeps=keeps, color=color):
                        self.show(clip, "Surface", color)
                        expected = self.take(frame)
                        display = self.show(mesh, color=color, CutBy="Exactly", CutShape="Plane")
                        display.CutShape.Origin, display.CutShape.Normal = origin, NORMAL
                        display.CutKeeps = keeps
                        self.same(expected, self.take(frame))

    def test_box(self):
        mesh = self.heights(polyhedra(), 1)
        frame = simple.Outline(Input=mesh)
        display = self.show(mesh, color=("POINTS", "Elevation"), CutBy="Exactly", CutShape="Box")
        shape = {"Position": [-0.3, -0.35, -0.2], "Length": [0.9, 1, 1.2], "Rotation": [20, 30, 10]}
        for name, value in shape.items():
            setattr(display.CutShape, name, value)
        for keeps in ("Inside", "Outside"):
            with self.subTest(keeps=keeps):
                display = self.show(mesh, color=("POINTS", "Elevation"), CutKeeps=keeps)
                made = self.take(frame)
                clip = simple.Clip(
                    Input=mesh, ClipType="Box", Invert=int(keeps == "Inside"), Exact=1
                )
                for name, value in shape.items():
                    setattr(clip.ClipType, name, value)
                self.show(clip, "Surface", ("POINTS", "Elevation"))
                # Clip's box is not exact at its edges.
                self.same(self.take(frame), made, 0.012)

    def test_sphere(self):
        """Round, however coarse the mesh: the rest of the inside is a sphere; with both projections, and scaled."""
        mesh = self.heights(hexahedra(), 8)
        frame = simple.Outline(Input=mesh)
        sphere = simple.Sphere(
            Center=[0.5, -0.4, 0.6], Radius=3.5, ThetaResolution=200, PhiResolution=200
        )
        ball = self.heights(sphere, 8)
        color = ("POINTS", "Elevation")
        for parallel in (0, 1):
            for scale in ([1, 1, 1], [0.5, 1, 0.8]):
                with self.subTest(parallel=parallel, scale=scale):
                    self.view.CameraParallelProjection = parallel
                    self.show(ball, "Surface", color, Interpolation="Gouraud", Scale=scale)
                    expected = self.take(frame)
                    display = self.show(
                        mesh, color=color, CutBy="Exactly", CutShape="Sphere", Scale=scale
                    )
                    display.CutShape.Center, display.CutShape.Radius = [0.5, -0.4, 0.6], 3.5
                    display.CutKeeps = "Inside"
                    self.same(expected, self.take(frame), 0.006)
        self.view.CameraParallelProjection = 0

    def test_edges(self):
        """Lines on the cut are where one cell ends and the next begins, and nowhere else."""
        mesh = simple.ProgrammableFilter(Input=hexahedra())
        mesh.Script = (
            "import numpy\nsize = inputs[0].GetNumberOfCells()\n"
            "output.CellData.append(numpy.random.default_rng(1).random(size), 'Random')"
        )
        frame = simple.Outline(Input=mesh)
        display = self.show(mesh, color=("CELLS", "Random"), CutBy="Exactly", CutShape="Plane")
        display.CutShape.Origin, display.CutShape.Normal = ORIGIN, NORMAL
        cells = self.take(frame)
        display.DrawEdges, display.EdgeColor = 1, [0, 0, 0]
        lines = numpy.abs(self.take(frame) - cells).max(axis=2) > 12
        jumps = numpy.zeros_like(lines)
        for axis in (0, 1):
            jumps |= numpy.abs(cells - numpy.roll(cells, 1, axis)).max(axis=2) > 8
        # Not the sum of Python, over which the script of a filter puts that of VTK 9.6.
        near = lambda marks: numpy.sum(
            [numpy.roll(marks, (i, k), (0, 1)) for i in (-1, 0, 1) for k in (-1, 0, 1)], axis=0
        )
        self.assertGreater(jumps.sum(), 4000)
        # The rim of the cut is no edge.
        self.assertLess((jumps & (near(lines) == 0)).sum(), 0.05 * jumps.sum())
        self.assertLess((lines & (near(near(jumps)) == 0)).sum(), 0.05 * lines.sum())

    def test_unit(self):
        """The same in any unit: products of three lengths would not fit float."""
        shapes = {
            "Plane": lambda unit: {"Origin": [0.3 * unit] * 3, "Normal": [1, 2, 3]},
            "Sphere": lambda unit: {"Center": [0.5 * unit, 0, 0], "Radius": 3.5 * unit},
            "Box": lambda unit: {"Position": [-3.3 * unit] * 3, "Length": [6.1 * unit] * 3},
        }
        wavelet = simple.AppendDatasets(Input=[simple.Wavelet(WholeExtent=[-5, 5] * 3)])
        for shape, values in shapes.items():
            pictures = []
            for unit in (1, 1e-14, 1e14):
                mesh = simple.Transform(Input=wavelet)
                mesh.Transform.Scale = [unit] * 3
                display = self.show(
                    mesh, color=("POINTS", "RTData"), CutBy="Exactly", CutShape=shape
                )
                display.CutKeeps, display.DrawEdges = "Inside", 1
                for name, value in values(unit).items():
                    setattr(display.CutShape, name, value)
                pictures.append(self.take())
            with self.subTest(shape):
                self.same(pictures[0], pictures[1])
                self.same(pictures[0], pictures[2])

    def test_offset(self):
        """A plane with an offset, in lengths of its normal, cuts where the offset puts it."""
        mesh = hexahedra()
        frame = simple.Outline(Input=mesh)
        plane = self.show(mesh, CutBy="Exactly", CutShape="Plane").CutShape
        pictures = []
        for origin, offset in (([0.9, 1.2, 0], 0), ([0, 0, 0], 0.3), ([0, 0, 0], 0)):
            plane.Origin, plane.Normal, plane.Offset = origin, [3, 4, 0], offset
            pictures.append(self.take(frame))
        self.same(*pictures[:2])
        self.assertGreater(difference(*pictures[1:]), 0.01)

    def test_in_faces(self):
        """A shape that lies in faces of cells shows these, with their edges, as if whole cells were cut away."""
        wavelet = simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5])
        blocks = simple.AppendDatasets(Input=[wavelet])
        straight = {"hexahedra": blocks, "tetrahedra": simple.Tetrahedralize(Input=wavelet)}
        meshes = {name: (mesh, [1, 0, 0]) for name, mesh in straight.items()}
        # Points that are rounded: no plane goes through four of them.
        turned = simple.Transform(Input=blocks, Transform="Transform")
        turned.Transform.Rotate, turned.Transform.Scale = [0, 0, 30], [0.1, 0.1, 0.1]
        meshes["turned"] = (turned, [0.75**0.5, 0.5, 0])
        box = {"Position": [-3, -2, -5], "Length": [5, 7, 8]}
        for name, (mesh, normal) in meshes.items():
            mesh = simple.PointAndCellIds(Input=mesh)
            frame = simple.Outline(Input=mesh)
            for shape in ("Plane",) if name == "turned" else ("Plane", "Box"):
                for keeps in ("Outside", "Inside"):
                    for color, edges in ((("CELLS", "CellIds"), 0), (None, 1)):
                        pictures = []
                        for way in ("Centroid", "Exactly"):
                            display = self.show(mesh, color=color, CutBy=way, CutShape=shape)
                            if shape == "Plane":
                                display.CutShape.Origin = [0, 0, 0]
                                # The camera looks at the cut.
                                display.CutShape.Normal = (
                                    normal if keeps == "Inside" else [-x for x in normal]
                                )
                            else:
                                for key, value in box.items():
                                    setattr(display.CutShape, key, value)
                            display.CutKeeps, display.DrawEdges = keeps, edges
                            pictures.append(self.take(frame))
                        with self.subTest(mesh=name, shape=shape, keeps=keeps, edges=edges):
                            # Lines at the edges of a box are of the two faces beside, or of one.
                            self.same(*pictures, 0.008 if edges else 0.002)

    def test_around_all(self):
        """A box equal to the bounds of the mesh removes nothing, not even points."""
        mesh = hexahedra()
        frame = simple.Outline(Input=mesh)
        found = []
        for cut in ("No cut", "Exactly"):
            display = self.show(mesh, CutBy=cut, CutShape="Box", CutKeeps="Inside")
            display.CutShape.Position, display.CutShape.Length = [-5, -5, -5], [10, 10, 10]
            self.take(frame)
            found.append(selected(self.view, mesh, "points"))
        self.assertGreater(len(found[0]), 300)
        self.assertEqual(*found)

    def test_selection(self):
        """Cells are picked on the cut; what is cut away hides nothing and is not picked."""
        mesh = polyhedra()
        frame = simple.Outline(Input=mesh)
        clip = simple.Clip(Input=mesh, ClipType="Plane", Invert=0)
        clip.ClipType.Origin, clip.ClipType.Normal = [x / 4 for x in ORIGIN], NORMAL
        self.show(clip, "Surface")
        self.take(frame)
        pieces = [index for _, _, index in selected(self.view, clip, "cells")]
        ids = vtk_to_numpy(servermanager.Fetch(clip).GetCellData().GetArray("CellIds"))
        expected = {int(ids[index]) for index in pieces}
        display = self.show(mesh, CutBy="Exactly", CutShape="Plane")
        display.CutShape.Origin, display.CutShape.Normal = [x / 4 for x in ORIGIN], NORMAL
        self.take(frame)
        found = {index for _, _, index in selected(self.view, mesh, "cells")}
        self.assertGreater(len(found), 100)
        self.assertLess(len(found ^ expected), 0.03 * len(found))  # slivers of a pixel or less

    def test_translucent(self):
        """Both sides of what stays are seen through it, as of Clip's surface."""
        mesh = hexahedra()
        frame = simple.Outline(Input=mesh)
        clip = simple.Clip(Input=mesh, ClipType="Plane", Invert=0)
        clip.ClipType.Origin, clip.ClipType.Normal = ORIGIN, NORMAL
        surface = simple.ExtractSurface(Input=clip)
        self.show(surface, "Surface", Opacity=0.5)
        expected = self.take(frame)
        display = self.show(mesh, CutBy="Exactly", CutShape="Plane", Opacity=0.5)
        display.CutShape.Origin, display.CutShape.Normal = ORIGIN, NORMAL
        self.same(expected, self.take(frame), 0.01)

    def test_choice_of_cells(self):
        """The cut shows the insides of cells that are drawn only, in its own color if it has one."""
        mesh = hexahedra()
        frame = simple.Outline(Input=mesh)
        chosen = simple.ProgrammableFilter(Input=mesh)
        chosen.Script = (
            "ids = inputs[0].CellData['CellIds']\n"
            "output.CellData.append((ids % 3 > 0).astype('uint8'), 'Selected')"
        )
        some = simple.Threshold(
            Input=chosen, Scalars=["CELLS", "Selected"], LowerThreshold=1, UpperThreshold=1
        )
        pictures = []
        for source, cells in ((some, "All"), (chosen, "Selected")):
            display = self.show(source, CellsToDraw=cells, CutBy="Exactly", CutShape="Plane")
            display.CutShape.Origin, display.CutShape.Normal = ORIGIN, NORMAL
            pictures.append(self.take(frame))
        self.same(*pictures)
        self.show(some, ColorCutFaces=1, CutColor=[0, 1, 0])
        colored = self.take(frame)
        green = colored[:, :, 1] > colored[:, :, 0] + 20
        self.assertGreater(green.sum(), 5000)
        self.assertLess(difference(colored[~green], pictures[0][~green]), 0.001)

    def test_moved_cells(self):
        """Cells are cut where they are drawn."""
        mesh = hexahedra()
        frame = simple.Outline(Input=mesh)
        shrunk = simple.Shrink(Input=mesh, ShrinkFactor=0.7)
        clip = simple.Clip(Input=shrunk, ClipType="Plane", Invert=0)
        clip.ClipType.Origin, clip.ClipType.Normal = ORIGIN, NORMAL
        self.show(clip, "Surface")
        expected = self.take(frame)
        display = self.show(mesh, ShrinkFactor=0.7, CutBy="Exactly", CutShape="Plane")
        display.CutShape.Origin, display.CutShape.Normal = ORIGIN, NORMAL
        self.same(expected, self.take(frame), 0.01)

    def test_rates_of_change(self):
        """How much something changes to the next pixel is asked for before pixels are discarded.

        Afterwards it is undefined: right in Mesa, 0 on cards of NVIDIA.
        """
        sources = set()

        def note(_mapper, _event, program):
            sources.add(program.GetFragmentShader().GetSource())

        note.CallDataType = VTK_OBJECT
        mesh = self.heights(polyhedra(), 1)
        display = self.show(mesh, CutShape="Sphere", DrawEdges=1)
        self.take()
        actors = self.view.GetRenderer().GetActors()
        actors.InitTraversal()
        for _ in range(actors.GetNumberOfItems()):
            mapper = actors.GetNextActor().GetMapper()
            if mapper:
                mapper.AddObserver("UpdateShaderEvent", note)
        display.DrawIsolines, display.IsolineArray, display.CutBy = 1, "Elevation", "Exactly"
        self.take()
        cuts = [source for source in sources if "HAS_ISOLINES" in source and "discard" in source]
        self.assertEqual(len(cuts), 2)  # of faces, and of what is inside
        for source in cuts:
            rates, discards = places(source, {"dFdx", "dFdy", "fwidth"}), places(
                source, {"discard"}
            )
            self.assertTrue(rates and discards)
            self.assertLess(max(rates), min(discards))


if __name__ == "__main__":
    camaron_testing.main()
