# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ids that Mesh Inspection writes: the right ones, where their elements are, in letters that can be read."""

import camaron_testing
import gallery
import numpy
import vtkmodules.vtkRenderingFreeType  # without it VTK has no text
from inspection_testing import difference, labels, make_view, picture, read_picture, selected, turn
from mesh_parts import producer
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkTextProperty, vtkTextRenderer

POINT, EDGE, FACE, CELL = range(4)
KINDS = ("Point", "Edge", "Face", "Cell")
RED = [1, 0, 0]


def tetrahedra(size=3):
    wavelet = simple.Wavelet(WholeExtent=[-size, size, -size, size, -size, size])
    mesh = simple.Tetrahedralize(Input=wavelet)
    return simple.PassArrays(Input=mesh, PointDataArrays=[], CellDataArrays=[])


def project(view, points):
    """Pixels of points, by the camera of the view."""
    renderer = view.GetRenderer()
    matrix = view.GetActiveCamera().GetCompositeProjectionTransformMatrix(
        renderer.GetTiledAspectRatio(), -1, 1
    )
    rows = numpy.array([[matrix.GetElement(i, k) for k in range(4)] for i in range(4)])
    at = numpy.c_[points, numpy.ones(len(points))] @ rows.T
    return (at[:, :2] / at[:, 3:] + 1) / 2 * view.ViewSize


def centers(data):
    """Means of the points of each cell."""
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    found = []
    for i in range(data.GetNumberOfCells()):
        ids = data.GetCell(i).GetPointIds()
        found.append(points[[ids.GetId(k) for k in range(ids.GetNumberOfIds())]].mean(axis=0))
    return numpy.array(found)


def digit_shapes(size):
    """What VTK writes for each digit, from where it begins: a map of boolean arrays."""
    style = vtkTextProperty()
    style.SetFontFamilyToArial()
    style.BoldOn()
    style.SetFontSize(size)
    style.SetColor(1, 1, 1)
    shapes = {}
    for digit in "0123456789":
        image = vtkImageData()
        vtkTextRenderer.GetInstance().RenderString(style, digit, image, [0, 0], 72)
        width, height, _ = image.GetDimensions()
        alpha = vtk_to_numpy(image.GetPointData().GetScalars())[:, 3].reshape(height, width) > 128
        rows = numpy.flatnonzero(alpha.any(axis=1))
        shapes[digit] = alpha[rows[0] : rows[-1] + 1]
    return shapes


def unlike(shape, cell):
    """Pixels by which a shape differs from what is in a cell, moved by one or two of them."""
    drawn = numpy.zeros_like(cell)
    height, width = min(shape.shape[0], cell.shape[0]), min(shape.shape[1], cell.shape[1])
    drawn[:height, :width] = shape[:height, :width]
    moves = [(y, x) for y in (-1, 0, 1) for x in (-1, 0, 1, 2)]
    return min((numpy.roll(drawn, move, (0, 1)) != cell).sum() for move in moves)


def read(marks, shapes, number):
    """The digits that a rectangle of marked pixels, `number` digits wide, is most like."""
    width = marks.shape[1] // number
    text = ""
    for i in range(number):
        cell = marks[:, i * width : (i + 1) * width]
        text += min(shapes, key=lambda digit: unlike(shapes[digit], cell))
    return text


@camaron_testing.require_display()
class TestInspectionIds(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        self.view = make_view()
        self.addCleanup(simple.ResetSession)

    def show(self, source, *kinds, **properties):
        simple.HideAll(self.view)
        display = simple.Show(source, self.view)
        display.SetRepresentationType("Mesh Inspection")
        if display.ColorArrayName[1]:
            simple.ColorBy(display, None)
        self.write(display, *kinds)
        for name, value in properties.items():
            setattr(display, name, value)
        turn(self.view)
        return display

    def write(self, display, *kinds):
        for kind, name in enumerate(KINDS):
            setattr(display, f"Draw{name}Ids", 1 if kind in kinds else 0)

    def labels(self):
        """Of a new picture."""
        simple.Render(self.view)
        found = labels(self.view)
        self.assertIsNotNone(found)
        return found

    def elements(self, source):
        """Where Mesh Elements has points, edges, faces, and where cells are."""
        elements = simple.MeshElements(Input=source)
        data = self.fetch(source)
        points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
        return [
            points,
            centers(self.fetch(elements, 1)),
            centers(self.fetch(elements, 0)),
            centers(data),
        ]

    def inputs(self):
        yield "tetrahedra", tetrahedra()
        yield "polyhedra", producer(gallery.polyhedra())
        yield "mixed", producer(gallery.mixed())
        yield "surface", simple.Sphere(ThetaResolution=12, PhiResolution=12)

    def test_large_picture(self):
        """Of several parts that are drawn one by one: ids are as large in it as in the view."""
        self.show(tetrahedra(), CELL, CellIdColor=RED)
        parts = []
        for scale in (1, 3):
            path = str(self.folder / f"ids{scale}.png")
            resolution = [scale * size for size in self.view.ViewSize]
            simple.SaveScreenshot(path, self.view, ImageResolution=resolution)
            image = read_picture(path)
            parts.append(((image[:, :, 0] > 180) & (image[:, :, 1:].max(axis=2) < 90)).mean())
        self.assertGreater(parts[0], 0.005)
        self.assertGreater(parts[1] / parts[0], 0.6)
        self.assertLess(parts[1] / parts[0], 2)  # smooth rims are another color

    def test_ids_are_where_elements_are(self):
        """A number that is another element's, or stands elsewhere, would mislead."""
        for name, source in self.inputs():
            source.UpdatePipeline()
            places = self.elements(source)
            for kind in (POINT, EDGE, FACE, CELL):
                with self.subTest(name, kind=KINDS[kind]):
                    display = self.show(source, kind)
                    kinds, ids, at, pixels = self.labels()
                    self.assertGreater(len(ids), 3)
                    self.assertTrue((kinds == kind).all())
                    self.assertEqual(len(set(ids.tolist())), len(ids))
                    tolerance = 1e-5 * numpy.ptp(places[POINT], axis=0).max()
                    middle = project(self.view, at)
                    corner = pixels[:, :2] if kind == POINT else pixels[:, :2] + pixels[:, 2:] / 2
                    self.assertLess(numpy.abs(corner - middle).max(), 6)
                    if kind == CELL:
                        # On a face of the cell; in the cell where one sees through.
                        gaps = numpy.linalg.norm(places[FACE][None] - at[:, None], axis=2).min(
                            axis=1
                        )
                        self.assertLess(gaps.max(), tolerance)
                        display.DrawFaces = 0
                        kinds, ids, at, pixels = self.labels()
                    self.assertLess(numpy.abs(places[kind][ids] - at).max(), tolerance)

    def test_letters(self):
        """Every number can be read where it should stand."""
        for size in (12, 17):
            shapes = digit_shapes(size)
            for kind in (POINT, EDGE, FACE, CELL):
                with self.subTest(size=size, kind=KINDS[kind]):
                    display = self.show(tetrahedra(2), kind, IdSize=size, DrawEdges=0)
                    setattr(display, f"{KINDS[kind]}IdColor", RED)
                    display.AmbientColor = display.DiffuseColor = [0.5, 0.5, 0.5]
                    image = picture(self.view)
                    marks = (image[:, :, 0] > 190) & (image[:, :, 1] < 110) & (image[:, :, 2] < 110)
                    _, ids, _, pixels = labels(self.view)
                    self.assertGreater(len(ids), 10)
                    for number, (left, bottom, width, height) in zip(ids, pixels):
                        text = str(number)
                        rectangle = marks[bottom : bottom + height, left : left + width]
                        self.assertEqual(read(rectangle, shapes, len(text)), text)

    def test_colors_of_element_types(self):
        """Each element type has its own color; no label covers another."""
        colors = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0]]
        display = self.show(tetrahedra(2), *range(4), IdSize=8, DrawEdges=0)
        for name, color in zip(KINDS, colors):
            setattr(display, f"{name}IdColor", color)
        image = picture(self.view)
        kinds, _, _, pixels = labels(self.view)
        for kind, color in enumerate(colors):
            mine = pixels[kinds == kind]
            self.assertGreater(len(mine), 5, KINDS[kind])
            for left, bottom, width, height in mine:
                part = image[bottom : bottom + height, left : left + width].reshape(-1, 3)
                self.assertLess(numpy.abs(part - numpy.array(color) * 255).max(axis=1).min(), 100)
        low, high = pixels[:, :2], pixels[:, :2] + pixels[:, 2:]
        apart = ((low[:, None] >= high[None]) | (low[None] >= high[:, None])).any(axis=2)
        self.assertTrue((apart | numpy.eye(len(pixels), dtype=bool)).all())
        self.assertTrue((low >= 0).all() and (high <= self.view.ViewSize).all())

    def test_nearest_first(self):
        """A smaller number takes away those farther away, and nothing else changes."""
        display = self.show(tetrahedra(), *range(4))
        eye = numpy.array(self.view.CameraPosition)
        for parallel in (0, 1):
            self.view.CameraParallelProjection = parallel
            display.NumberOfIds = 300
            everything = self.labels()
            look = numpy.array(self.view.CameraFocalPoint) - eye
            gaps = everything[2] - eye
            distances = gaps @ look if parallel else numpy.linalg.norm(gaps, axis=1)
            self.assertGreater(len(distances), 50)
            self.assertGreaterEqual(numpy.diff(distances).min(), -1e-4 * distances.max())
            display.NumberOfIds = 20
            few = self.labels()
            for all_rows, rows in zip(everything, few):
                self.assertEqual(rows.tolist(), all_rows[:20].tolist())
        display.NumberOfIds = 0
        simple.Render(self.view)
        self.assertIsNone(labels(self.view))

    def test_hidden_elements_have_none(self):
        """What a rectangle does not select is behind something."""
        mesh = tetrahedra()
        display = self.show(mesh, CELL, DrawEdges=0)
        cells = {cell for _, _, cell in selected(self.view, mesh, "cells")}
        self.assertLessEqual(set(self.labels()[1].tolist()), cells)
        self.write(display, POINT)
        points = {point for _, _, point in selected(self.view, mesh, "points")}
        found = set(self.labels()[1].tolist())
        self.assertGreater(len(found), 30)
        self.assertLessEqual(len(found - points), 2)  # corners of which no pixel is left
        display.IdSize = 5
        for changes in ({"DrawFaces": 0, "DrawEdges": 1}, {"DrawFaces": 1, "Opacity": 0.4}):
            for name, value in changes.items():
                setattr(display, name, value)
            self.assertGreater(len(set(self.labels()[1].tolist()) - points), 10)

    def test_what_is_not_drawn_has_none(self):
        """Cells that are cut away or not chosen; without anything drawn there is nothing at all."""
        mesh = tetrahedra()
        display = self.show(mesh, *range(4))
        display.CutBy, display.CutShape = "Any vertex", "Sphere"
        display.CutShape.Center, display.CutShape.Radius = [0, 0, 3], 2.5
        kinds, _, places, _ = self.labels()
        inside = numpy.linalg.norm(places - [0, 0, 3], axis=1) < 2.5
        self.assertFalse(inside[kinds == POINT].any())
        display.CutBy = "No cut"
        chosen = simple.SelectElements(Input=mesh, Strategy="Shape", Shape="Sphere")
        chosen.Shape.Center, chosen.Shape.Radius = [0, 0, 3], 2.5
        marks = vtk_to_numpy(self.fetch(chosen).GetCellData().GetArray("Selected"))
        for which, value in (("Selected", 1), ("Unselected", 0)):
            self.show(chosen, CELL, CellsToDraw=which)
            ids = self.labels()[1]
            self.assertGreater(len(ids), 10)
            self.assertTrue((marks[ids] == value).all())
        display = self.show(mesh, *range(4), DrawFaces=0, DrawEdges=0)
        simple.Render(self.view)
        self.assertFalse((picture(self.view) < 250).any())

    def test_interior_faces(self):
        """Of interior faces, those in front."""
        mesh = tetrahedra()
        faces = self.elements(mesh)[FACE]
        self.show(mesh, FACE, FacesToDraw="Interior")
        _, ids, places, _ = self.labels()
        self.assertGreater(len(ids), 10)
        self.assertLess(numpy.abs(faces[ids] - places).max(), 1e-4)
        self.assertTrue((numpy.abs(places) < 2.99).all())

    def test_moved_cells(self):
        """The label goes with the cell; a point that is in several places has one label."""
        mesh = tetrahedra()
        cells = self.elements(mesh)[CELL]
        self.show(mesh, CELL, POINT, ShrinkFactor=0.5, ExplodeFactor=1, DrawFaces=0, DrawEdges=1)
        kinds, ids, places, _ = self.labels()
        of_cells = kinds == CELL
        self.assertGreater(of_cells.sum(), 10)
        self.assertLess(numpy.abs(2 * cells[ids[of_cells]] - places[of_cells]).max(), 1e-4)
        points = ids[~of_cells].tolist()
        self.assertGreater(len(points), 10)
        self.assertEqual(len(points), len(set(points)))

    def test_global_ids(self):
        """Where there are any, they are written."""
        mesh = tetrahedra(1)
        data = self.fetch(mesh)
        for attributes, size in (
            (data.GetPointData(), data.GetNumberOfPoints()),
            (data.GetCellData(), data.GetNumberOfCells()),
        ):
            ids = numpy_to_vtk(1000 + numpy.arange(size), deep=True)
            ids.SetName("Ids")
            attributes.SetGlobalIds(ids)
        points = vtk_to_numpy(data.GetPoints().GetData())
        self.show(producer(data), POINT, CELL)
        kinds, ids, places, _ = self.labels()
        self.assertTrue((ids >= 1000).all())
        numbers = ids[kinds == POINT] - 1000
        self.assertGreater(len(numbers), 3)
        self.assertLess(numpy.abs(points[numbers] - places[kinds == POINT]).max(), 1e-5)

    def test_blocks(self):
        """Ids are those of the data set of the block."""
        sources = [tetrahedra(2), simple.Sphere(Center=[7, 0, 0], Radius=2), tetrahedra(1)]
        sources[2] = simple.Transform(Input=sources[2])
        sources[2].Transform.Translate = [12, 0, 0]
        places = [self.elements(source) for source in sources]
        self.show(simple.GroupDatasets(Input=sources), *range(3), IdSize=6)
        kinds, ids, at, _ = self.labels()
        block = numpy.digitize(at[:, 0], [4, 10])
        for i, of_block in enumerate(places):
            for kind in range(3):
                mine = (block == i) & (kinds == kind)
                self.assertGreater(mine.sum(), 1, (i, KINDS[kind]))
                self.assertLess(numpy.abs(of_block[kind][ids[mine]] - at[mine]).max(), 1e-4)

    def test_far_from_the_origin(self):
        """Places keep the digits that the coordinates have."""
        mesh = simple.Transform(Input=tetrahedra(2))
        mesh.Transform.Translate = [1e7, -1e7, 2e7]
        points = vtk_to_numpy(self.fetch(mesh).GetPoints().GetData())
        self.show(mesh, POINT)
        self.view.CameraFocalPoint = [1e7, -1e7, 2e7]
        self.view.CameraPosition = [1e7 + 5, -1e7 + 3, 2e7 + 8]
        simple.ResetCamera(self.view)
        _, ids, places, pixels = self.labels()
        self.assertGreater(len(ids), 20)
        self.assertEqual(numpy.abs(points[ids] - places).max(), 0)
        self.assertLess(numpy.abs(pixels[:, :2] - project(self.view, places)).max(), 7)

    def test_off_costs_nothing(self):
        """Off again, the picture is as before; labels are not selected, and do not change what is."""
        mesh = tetrahedra()
        display = self.show(mesh)
        plain = picture(self.view)
        cells = selected(self.view, mesh, "cells")
        self.assertIsNone(labels(self.view))
        self.write(display, *range(4))
        self.assertGreater(difference(plain, picture(self.view)), 0.02)
        self.assertEqual(selected(self.view, mesh, "cells"), cells)
        bounds = self.view.GetRenderer().ComputeVisiblePropBounds()
        self.assertLess(max(map(abs, bounds)), 3.1)
        simple.Hide(mesh, self.view)
        simple.Render(self.view)
        self.assertIsNone(labels(self.view))
        simple.Show(mesh, self.view)
        self.write(display)
        self.assertEqual(difference(plain, picture(self.view)), 0)

    def test_screenshots_of_odd_sizes(self):
        """Rows of pixels whose bytes are no multiple of four are where they belong, also after the ids."""
        mesh = tetrahedra()
        display = self.show(mesh)
        shot = str(self.folder / "shot.png")
        simple.SaveScreenshot(shot, self.view, ImageResolution=[301, 199])
        plain = read_picture(shot)
        self.write(display, CELL)
        simple.Render(self.view)
        self.write(display)
        simple.SaveScreenshot(shot, self.view, ImageResolution=[301, 199])
        self.assertEqual(difference(plain, read_picture(shot)), 0)

    def test_what_is_in_front_covers_them(self):
        """A label behind another mesh is not seen."""
        mesh = tetrahedra(2)
        self.show(mesh, FACE, FaceIdColor=RED)
        self.assertGreater((picture(self.view)[:, :, 1] < 60).sum(), 50)
        look = numpy.array(self.view.CameraFocalPoint) - self.view.CameraPosition
        screen = simple.Plane(Origin=[-9, -9, 0], Point1=[9, -9, 0], Point2=[-9, 9, 0])
        placed = simple.Transform(Input=screen)
        placed.Transform.Translate = list(-4.2 * look / numpy.linalg.norm(look))
        simple.Show(placed, self.view).DiffuseColor = [1, 1, 1]
        image = picture(self.view)
        red = (image[:, :, 0] > 150) & (image[:, :, 1] < 60)
        self.assertEqual(red.sum(), 0)

    def test_empty_mesh_and_time(self):
        """Nothing in an empty mesh, and in other time steps the labels of what is there then."""
        wavelet = simple.Wavelet(WholeExtent=[-1, 1, -1, 1, -1, 1])
        empty = simple.Threshold(Input=wavelet, Scalars=["POINTS", "RTData"], LowerThreshold=1e9)
        empty.UpperThreshold = 2e9
        self.show(empty, *range(4))
        self.assertFalse((picture(self.view) < 250).any())
        source = simple.TimeSource(XAmplitude=1.0, Growing=1)
        scene = simple.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        self.show(source, CELL)
        for time in (0.0, 0.5):
            scene.AnimationTime = time
            simple.ResetCamera(self.view)
            ids = self.labels()[1]
            self.assertGreater(len(ids), 0)
            self.assertLess(max(ids), source.GetDataInformation().GetNumberOfCells())


if __name__ == "__main__":
    camaron_testing.main()
