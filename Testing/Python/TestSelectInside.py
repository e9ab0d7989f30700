# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Select Elements in shapes, between planes and in surfaces, against distances of convex hulls."""

import math

import camaron_testing
import mesh_parts
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform

PLACEMENTS = (
    "Any vertex inside",
    "All vertices inside",
    "Centroid inside",
    "Intersects",
    "Cut by boundary",
)


def nearest_point(points):
    """The point of the convex hull of points that is next to the origin (Wolfe 1976)."""
    corral = [int(numpy.argmin((points**2).sum(1)))]
    weights = numpy.ones(1)
    for _ in range(1000):
        x = weights @ points[corral]
        products = points @ x
        candidate = int(numpy.argmin(products))
        if products[candidate] >= x @ x - 1e-13 * (points**2).sum(1).max() or candidate in corral:
            return x
        corral.append(candidate)
        weights = numpy.append(weights, 0.0)
        while True:
            chosen = points[corral]
            size = len(corral)
            matrix = numpy.ones((size + 1, size + 1))
            matrix[0, 0] = 0
            matrix[1:, 1:] = chosen @ chosen.T
            right = numpy.zeros(size + 1)
            right[0] = 1
            affine = numpy.linalg.lstsq(matrix, right, rcond=None)[0][1:]
            if (affine > 1e-14).all():
                weights = affine
                break
            falling = affine <= 1e-14
            step = (weights[falling] / (weights[falling] - affine[falling])).min()
            weights = weights + min(1, step) * (affine - weights)
            keep = weights > 1e-14
            corral = [c for c, k in zip(corral, keep) if k]
            weights = weights[keep] / weights[keep].sum()
    return x


def hull_distance(points, center):
    return numpy.linalg.norm(nearest_point(points - center))


def hull_gap(a, b):
    """Distance of two convex hulls; 0 where they meet."""
    return numpy.linalg.norm(nearest_point((a[:, None, :] - b[None, :, :]).reshape(-1, 3)))


def box_surface(corners):
    """The six faces of a box with vertices 000, 001, 010, 011, 100, ..."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for corner in corners:
        points.InsertNextPoint(corner)
    polygons = vtkCellArray()
    for side in (
        (0, 1, 3, 2),
        (4, 5, 7, 6),
        (0, 1, 5, 4),
        (2, 3, 7, 6),
        (0, 2, 6, 4),
        (1, 3, 7, 5),
    ):
        polygons.InsertNextCell(4, side)
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(polygons)
    return surface


class TestSelectInside(camaron_testing.TestCase):
    def select(self, source, **properties):
        return self.marked(simple.SelectElements(Input=source, **properties))

    def select_in(self, shape, source, **properties):
        """Shape by name and its properties as "Radius" and the like."""
        select = simple.SelectElements(Input=source, Strategy="Shape", Shape=shape)
        names = set(properties) - {"Placement", "InsideOut"}
        for name in names:
            setattr(select.Shape, name, properties.pop(name))
        for name, value in properties.items():
            setattr(select, name, value)
        return self.marked(select)

    def marked(self, select):
        """The cells that a filter has selected; deletes it, as many filters make ParaView slow."""
        with camaron_testing.pipeline.Messages() as messages:
            select.UpdatePipeline()
        self.assertEqual(messages.errors, [])
        marks = self.fetch(select).GetCellData().GetArray("Selected")
        simple.Delete(select)
        return set(numpy.flatnonzero(vtk_to_numpy(marks)).tolist())

    def all_placements(self, shape, source, **properties):
        return {
            placement: self.select_in(shape, source, Placement=placement, **properties)
            for placement in PLACEMENTS
        }

    def cells(self, source):
        """Points of every cell."""
        source.UpdatePipeline()
        data = self.fetch(source)
        ids, cells = vtkIdList(), []
        for cell in range(data.GetNumberOfCells()):
            data.GetCellPoints(cell, ids)
            cells.append(
                numpy.array([data.GetPoint(ids.GetId(i)) for i in range(ids.GetNumberOfIds())])
            )
        return cells

    def meshes(self):
        """Convex cells of every shape: hexahedra, tetrahedra, polyhedra, triangles, segments."""
        wavelet = simple.Wavelet(WholeExtent=[-3, 3] * 3)
        yield "hexahedra", wavelet
        yield "tetrahedra", simple.Tetrahedralize(Input=wavelet)
        yield "polyhedra", simple.OpenDataFile(str(camaron_testing.EXAMPLES / "voronoi-ball.visf"))
        yield "triangles", simple.Sphere(Radius=3, ThetaResolution=12, PhiResolution=9)
        yield "segments", simple.Line(Point1=[-3, -2, -1], Point2=[3, 1, 2], Resolution=7)

    def assert_hierarchy(self, found, message):
        self.assertLessEqual(found["All vertices inside"], found["Any vertex inside"], message)
        self.assertLessEqual(found["Any vertex inside"], found["Intersects"], message)
        self.assertEqual(
            found["Cut by boundary"], found["Intersects"] - found["All vertices inside"], message
        )

    def assert_same(self, found, distances, limit, message):
        """What is found is what is near enough; rounding decides in between."""
        scale = max(1.0, float(numpy.max(distances)))
        sure = {i for i, d in enumerate(distances) if d < limit - 1e-7 * scale}
        maybe = {i for i, d in enumerate(distances) if d <= limit + 1e-7 * scale}
        self.assertLessEqual(sure, found, message)
        self.assertLessEqual(found, maybe, message)

    def test_ball(self):
        for name, source in self.meshes():
            cells = self.cells(source)
            low, high = (f([f(c, axis=0) for c in cells], axis=0) for f in (numpy.min, numpy.max))
            for place, share in ((0.5, 0.3), (0.31, 0.07), (0.9, 0.2)):
                center = low + place * (high - low)
                radius = share * numpy.linalg.norm(high - low)
                found = self.all_placements("Sphere", source, Center=list(center), Radius=radius)
                message = f"{name} {place} {share}"
                self.assert_hierarchy(found, message)
                corners = [numpy.linalg.norm(c - center, axis=1) for c in cells]
                self.assert_same(
                    found["Any vertex inside"], [c.min() for c in corners], radius, message
                )
                self.assert_same(
                    found["All vertices inside"], [c.max() for c in corners], radius, message
                )
                self.assert_same(
                    found["Intersects"], [hull_distance(c, center) for c in cells], radius, message
                )

    def test_box(self):
        """Rotated, so that it is not aligned with the cells."""
        corners = numpy.array(
            [(x, y, z, 1) for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)]
        )
        for name, source in self.meshes():
            cells = self.cells(source)
            low, high = (f([f(c, axis=0) for c in cells], axis=0) for f in (numpy.min, numpy.max))
            size = numpy.linalg.norm(high - low)
            for share in (0.4, 0.02):
                position, rotation = low + 0.4 * (high - low), [20.0, 35.0, 50.0]
                scale = [share * size, 0.7 * share * size, 0.5 * share * size]
                transform = vtkTransform()
                transform.Translate(position)
                transform.RotateZ(rotation[2])
                transform.RotateX(rotation[0])
                transform.RotateY(rotation[1])
                transform.Scale(scale)
                matrix = numpy.array(
                    [[transform.GetMatrix().GetElement(i, j) for j in range(4)] for i in range(4)]
                )
                box = (corners @ matrix.T)[:, :3]
                properties = {"UseReferenceBounds": 0, "Position": list(position)}
                properties |= {"Rotation": rotation, "Length": scale}
                found = self.all_placements("Box", source, **properties)
                message = f"{name} {share}"
                self.assert_hierarchy(found, message)
                gaps = [hull_gap(c, box) for c in cells]
                self.assert_same(found["Intersects"], gaps, 0, message)
                if share > 0.1 and name != "segments":
                    self.assertTrue(found["Intersects"], message)

                # The same as planes, and as a surface.
                planes = []
                for axis in range(3):
                    row = numpy.linalg.inv(matrix)[axis, :3]
                    planes += [*box[0], *-row, *box[7], *row]
                surface = mesh_parts.producer(box_surface(box))
                for placement in PLACEMENTS:
                    for properties in (
                        {"Strategy": "Half-spaces", "Planes": planes},
                        {"Strategy": "Surface", "Surface": surface},
                    ):
                        cells_found = self.select(source, Placement=placement, **properties)
                        self.assertEqual(
                            cells_found, found[placement], f"{message} {placement} {properties}"
                        )

    def test_plane_and_cylinder(self):
        for name, source in self.meshes():
            cells = self.cells(source)
            origin, normal = numpy.array([0.3, 0.1, 0.2]), numpy.array([0.48, 0.6, 0.64])
            found = self.all_placements("Plane", source, Origin=list(origin), Normal=list(normal))
            self.assert_hierarchy(found, name)
            heights = [(c - origin) @ normal for c in cells]
            self.assert_same(found["Intersects"], [h.min() for h in heights], 0, name)
            self.assert_same(found["All vertices inside"], [h.max() for h in heights], 0, name)
            found = self.all_placements(
                "Cylinder", source, Center=list(origin), Axis=list(normal), Radius=0.7
            )
            self.assert_hierarchy(found, name)
            flat = [c - numpy.outer((c - origin) @ normal, normal) for c in cells]
            distances = [hull_distance(c, origin) for c in flat]
            self.assert_same(found["Intersects"], distances, 0.7, name)
            self.assertTrue(found["Intersects"], name)

    def test_centroid_and_inside_out(self):
        for name, source in self.meshes():
            if name == "polyhedra":
                continue  # their centroid is not the mean of their points
            cells = self.cells(source)
            centers = [numpy.linalg.norm(c.mean(axis=0) - 0.3) for c in cells]
            properties = {"Center": [0.3] * 3, "Radius": 1.3, "Placement": "Centroid inside"}
            found = self.select_in("Sphere", source, **properties)
            self.assert_same(found, centers, 1.3, name)
            other = self.select_in("Sphere", source, InsideOut=True, **properties)
            self.assertEqual(other, set(range(len(cells))) - found)

    def test_surface_that_is_not_convex(self):
        """A hollow cube with a notch: two surfaces, one within the other."""
        outer = numpy.array([(x, y, z) for x in (0, 6) for y in (0, 6) for z in (0, 6)], float)
        inner = numpy.array([(x, y, z) for x in (2, 4) for y in (2, 4) for z in (2, 4)], float)
        surface = simple.AppendDatasets(
            Input=[mesh_parts.producer(box_surface(c)) for c in (outer, inner)]
        )
        source = simple.Wavelet(WholeExtent=[-2, 8] * 3)
        places = numpy.array([c.mean(axis=0) for c in self.cells(source)])
        solid = ((places > 0) & (places < 6)).all(1) & ~((places > 2) & (places < 4)).all(1)
        found = self.select(
            source, Strategy="Surface", Surface=surface, Placement="Centroid inside"
        )
        self.assertEqual(found, set(numpy.flatnonzero(solid).tolist()))
        # A cell around the hole has all vertices in the solid; the hole cuts it.
        big = simple.Wavelet(WholeExtent=[1, 5, 1, 5, 1, 5], SubsampleRate=1)
        big = simple.ExtractSubset(
            Input=big, VOI=[1, 5] * 3, SampleRateI=4, SampleRateJ=4, SampleRateK=4
        )
        sizes = [
            len(self.select(big, Strategy="Surface", Surface=surface, Placement=placement))
            for placement in PLACEMENTS
        ]
        self.assertEqual(sizes, [1, 1, 0, 1, 1])

    def test_points(self):
        source = simple.Wavelet(WholeExtent=[-3, 3] * 3)
        select = simple.SelectElements(Input=source, Strategy="Shape", ElementType="Points")
        select.Shape.Center, select.Shape.Radius = [0, 0, 0], 2
        select.UpdatePipeline()
        marks = vtk_to_numpy(self.fetch(select).GetPointData().GetArray("Selected"))
        lattice = numpy.array(
            [(x, y, z) for z in range(-3, 4) for y in range(-3, 4) for x in range(-3, 4)]
        )
        self.assertEqual(marks.tolist(), ((lattice**2).sum(1) <= 4).tolist())

    def test_errors(self):
        source = simple.Wavelet(WholeExtent=[0, 2] * 3)
        for properties, reason in (
            ({"Strategy": "Half-spaces"}, "Planes is empty"),
            ({"Strategy": "Half-spaces", "Planes": [0] * 6}, "a plane has a zero normal"),
            ({"Strategy": "Half-spaces", "Planes": [0] * 5}, "a multiple of 6 numbers, found 5"),
            ({"Strategy": "Half-spaces", "Planes": [1] * 13}, "a multiple of 6 numbers, found 13"),
            ({"Strategy": "Surface"}, "no Surface is chosen"),
            ({"Strategy": "Surface", "Surface": simple.Plane()}, "not closed: 4 edges belong"),
            ({"Strategy": "Surface", "Surface": source}, "has 3D cells"),
        ):
            select = simple.SelectElements(Input=source, **properties)
            with camaron_testing.pipeline.Messages() as messages:
                select.UpdatePipeline()
            self.assertIn(reason, messages.errors[0])
        for shape in ("Sphere", "Cylinder"):
            for radius in (-1, math.nan):
                if (
                    shape == "Cylinder"
                    and radius == -1
                    and camaron_testing.paraview_version() >= (6, 1)
                ):
                    continue  # whose vtkCylinder takes 0 for it
                select = simple.SelectElements(Input=source, Strategy="Shape", Shape=shape)
                select.Shape.Radius = radius
                with camaron_testing.pipeline.Messages() as messages:
                    select.UpdatePipeline()
                self.assertIn(f"Radius must be 0 or more, not {radius}", messages.errors[0])

    def shape_file(self, text):
        path = self.folder / "shape.txt"
        path.write_text(text)
        return {"Strategy": "Shape file", "ShapeFile": str(path)}

    def test_shape_files(self):
        """Shapes as text select what the same shapes select otherwise, by any placement."""
        mesh = self.open(camaron_testing.EXAMPLES / "voronoi-ball.visf")
        low, high = [-0.41, -0.3, -0.5], [0.39, 0.62, 0.33]
        planes, normals, polygons = [], ["Normals"], ["POLYGONS  # of a box"]
        for axis in range(3):
            for sign, place in ((1, high), (-1, low)):
                normal = [sign * float(axis == i) for i in range(3)]
                planes += [*place, *normal]
                normals.append("normal: ({}, {}, {}) point: ({}, {}, {})".format(*normal, *place))
                u, v = (axis + 1) % 3, (axis + 2) % 3
                corners = []
                for a, b in ((low, low), (high, low), (high, high), (low, high)):
                    corner = [0.0] * 3
                    corner[axis], corner[u], corner[v] = place[axis], a[u], b[v]
                    corners.append("{} {} {}".format(*corner))
                polygons.append(", ".join(corners))
        for placement in PLACEMENTS:
            ball = simple.SelectElements(
                Input=mesh, Strategy="Shape", Shape="Sphere", Placement=placement
            )
            ball.Shape.Center, ball.Shape.Radius = [0.1, -0.2, 0.3], 0.4
            ball.UpdatePipeline()
            marks = vtk_to_numpy(self.fetch(ball).GetCellData().GetArray("Selected"))
            expected = set(numpy.flatnonzero(marks).tolist())
            self.assertTrue(0 < len(expected) < 800)
            for text in (
                "sphere 0.1 -0.2 0.3 0.4",
                "Sphere\nCenter = [0.1, -0.2, 0.3]\nRadius = 0.4\nVertices = 1000",
            ):
                found = self.select(mesh, Placement=placement, **self.shape_file(text))
                self.assertEqual(found, expected, placement)
            expected = self.select(mesh, Strategy="Half-spaces", Planes=planes, Placement=placement)
            self.assertTrue(0 < len(expected) < 800)
            for lines in (normals, polygons):
                found = self.select(mesh, Placement=placement, **self.shape_file("\n".join(lines)))
                self.assertEqual(found, expected, placement)

    def test_wrong_shape_files(self):
        source = simple.Wavelet(WholeExtent=[0, 2] * 3)
        for text, reason in (
            ("", "shape.txt: expected sphere, normals or polygons, found end of file"),
            (
                "# nothing\ncube 1",
                "shape.txt:2: expected sphere, normals or polygons, found 'cube'",
            ),
            ("sphere", "shape.txt: expected numbers, found end of file"),
            (
                "sphere 1 2 3",
                "shape.txt:1: expected 4 numbers, the center of the sphere and its radius, found 3",
            ),
            ("sphere 1 2 3 x", "shape.txt:1: expected a number, found 'x'"),
            ("sphere 1 2 nan 1", "shape.txt:1: expected a number, found 'nan'"),
            ("sphere 1 2 3 -4", "Radius must be 0 or more, not -4"),
            (
                "normals\n1 0 0 0 0 0\n1 0 0 0 0",
                "shape.txt:3: expected 6 numbers, a normal and a point",
            ),
            ("normals\n0 0 0 1 1 1", "a plane has a zero normal"),
            (
                "polygons\n0 0 0 1 0 0",
                "shape.txt:2: expected 3 numbers for each of 3 or more points",
            ),
            (
                "polygons\n0 0 0 1 0 0 0 1 0",
                "shape.txt: the polygons are not closed: 3 edges belong",
            ),
        ):
            select = simple.SelectElements(Input=source, **self.shape_file(text))
            with camaron_testing.pipeline.Messages() as messages:
                select.UpdatePipeline()
            self.assertIn(reason, messages.errors[0])
        for path, reason in (
            ("", "no Shape File is chosen"),
            (str(self.folder / "none.txt"), "none.txt"),
        ):
            select = simple.SelectElements(Input=source, Strategy="Shape file", ShapeFile=path)
            with camaron_testing.pipeline.Messages() as messages:
                select.UpdatePipeline()
            self.assertIn(reason, messages.errors[0])

    def test_normals_of_any_length(self):
        """Only the direction of a normal counts, also where its square is out of range."""
        source = simple.Wavelet(WholeExtent=[0, 9] * 3)
        expected = self.select(source, Strategy="Half-spaces", Planes=[4, 4, 4, 1, 2, -1])
        self.assertTrue(0 < len(expected) < 9**3)
        for length in (1e-320, 1e-200, 1e200, 0.5e308):
            normal = [length, 2 * length, -length]
            planes = self.select(source, Strategy="Half-spaces", Planes=[4, 4, 4, *normal])
            self.assertEqual(planes, expected, length)
            found = self.select_in("Plane", source, Origin=[4, 4, 4], Normal=normal)
            self.assertEqual(found, expected, length)

    def test_extreme_sizes(self):
        """If this fails, squares of lengths are 0 or infinite, and everything lies inside."""
        cells = [(10, [0, 1, 2, 3])]
        for exponent in (600, -600):
            points = 2.0**exponent * numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
            path = camaron_testing.write_vtk(self.folder / f"{exponent}.vtk", points, cells)
            source = simple.LegacyVTKReader(FileNames=[str(path)])
            select = simple.SelectElements(
                Input=source, Strategy="Half-spaces", Planes=[0, 0, 0, 1, 0, 0]
            )
            with camaron_testing.pipeline.Messages() as messages:
                select.UpdatePipeline()
            self.assertIn(
                "The largest coordinate of the mesh must be 1e-30 to 1e+30", messages.errors[0]
            )

    def test_case_of_specification(self):
        """A ball within a cell, without touching its vertices."""
        cube = simple.Wavelet(WholeExtent=[0, 1, 0, 1, 0, 1])
        found = self.all_placements("Sphere", cube, Center=[0.5] * 3, Radius=0.4)
        sizes = {placement: len(cells) for placement, cells in found.items()}
        self.assertEqual(sizes, dict(zip(PLACEMENTS, (0, 0, 1, 1, 1))))


if __name__ == "__main__":
    camaron_testing.main()
