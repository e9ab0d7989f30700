# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cells that use a point twice or whose faces cross themselves, and inputs that are rounded, split or changed in place."""

import camaron_testing
import gallery
import mesh_parts
import numpy
from paraview import simple
from paraview.servermanager import OutputPort
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_CONVEX_POINT_SET,
    VTK_HEXAHEDRON,
    VTK_POLYHEDRON,
    VTK_PYRAMID,
    VTK_QUAD,
    VTK_QUADRATIC_HEXAHEDRON,
    VTK_QUADRATIC_TETRA,
    VTK_TETRA,
    VTK_TRIANGLE,
    VTK_TRIANGLE_STRIP,
    VTK_WEDGE,
    vtkDataSetAttributes,
    vtkImageData,
    vtkPartitionedDataSetCollection,
    vtkPolyData,
    vtkPolygon,
    vtkStructuredGrid,
    vtkUnstructuredGrid,
)

CUBE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
OF_SOLIDS = ["Volume", "MinSolidAngle", "MaxDihedralAngle", "KernelRatio", "FaceOrientationStatus"]
OF_TETRAHEDRA = ["TetRadiusEdgeRatio", "TetMeanRatio", "TetRadiusRatio", "TetQualityFoam"]
OF_NEIGHBORS = ["MaxNonOrthogonality", "MaxFaceSkewness", "MinFaceWeight", "OrthogonalQuality"]


class TestCollapsedCells(camaron_testing.TestCase):
    def evaluate(self, data, names):
        """By criterion the values of the cells."""
        quality = simple.ElementQuality(Input=mesh_parts.producer(data), Criteria=names)
        cells = self.fetch(quality).GetCellData()
        return {name: vtk_to_numpy(cells.GetArray(name)) for name in names}

    def elements(self, data, port, **properties):
        return self.fetch(simple.MeshElements(Input=mesh_parts.producer(data), **properties), port)

    def array(self, data, name):
        return vtk_to_numpy(data.GetCellData().GetArray(name))

    def test_tetrahedra_in_other_types(self):
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0.2, 0.3, 1)]
        cells = [
            (VTK_TETRA, [0, 1, 2, 3]),
            (VTK_WEDGE, [0, 2, 1, 3, 3, 3]),
            (VTK_PYRAMID, [0, 1, 2, 2, 3]),
            (VTK_HEXAHEDRON, [0, 1, 2, 2, 3, 3, 3, 3]),
        ]
        found = self.evaluate(gallery.make_grid(points, cells), OF_SOLIDS + OF_TETRAHEDRA)
        self.assertAlmostEqual(found["Volume"][0], 1 / 6)
        for name, values in found.items():
            for value in values[1:]:
                self.assertAlmostEqual(value, values[0], 12, name)
        # And inverted ones, of which the wedge has its triangles the other way round.
        inverted = [(VTK_TETRA, [0, 2, 1, 3]), (VTK_WEDGE, [0, 1, 2, 3, 3, 3])]
        found = self.evaluate(gallery.make_grid(points, inverted, turns=False), ["Volume"])
        numpy.testing.assert_allclose(found["Volume"], -1 / 6, rtol=1e-14)

    def test_triangle_as_quadrilateral(self):
        """Neighbors of an edge after a point that follows itself, wherever in the list."""
        points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0, 0), (2, 1, 0)]
        others = [(VTK_TRIANGLE, [0, 2, 3]), (VTK_QUAD, [1, 4, 5, 2])]
        expected = None
        for kind, ids in (
            (VTK_TRIANGLE, [0, 1, 2]),
            (VTK_QUAD, [0, 1, 2, 2]),
            (VTK_QUAD, [0, 0, 1, 2]),
            (VTK_QUAD, [0, 1, 2, 0]),
        ):
            grid = gallery.make_grid(points, [(kind, ids), *others])
            edges = self.elements(grid, 1, EdgeArrays=["NonOrthogonality", "IsBoundary"])
            found = self.evaluate(grid, OF_NEIGHBORS)
            found["edges"] = self.array(edges, "NonOrthogonality")
            found["boundary"] = self.array(edges, "IsBoundary")
            expected = expected or found
            for name, values in found.items():
                numpy.testing.assert_allclose(
                    values, expected[name], 1e-14, err_msg=f"{ids} {name}"
                )
        self.assertGreater(expected["MaxNonOrthogonality"][0], 11)

    def test_faces_of_two_points(self):
        """Hexahedra that are used as wedges have no boundary inside the mesh."""
        points, cubes = gallery.lattice(3, 3, 3)
        plain = [(VTK_HEXAHEDRON, list(cube)) for cube in cubes]
        outside = self.evaluate(gallery.make_grid(points, plain), ["IsBoundary"])["IsBoundary"]
        (inner,) = numpy.flatnonzero(outside == 0)
        a, b, c, d, e, f, g, h = plain.pop(inner)[1]
        wedges = [(VTK_WEDGE, [a, c, b, e, g, f]), (VTK_WEDGE, [a, d, c, e, h, g])]
        hexahedra = [
            (VTK_HEXAHEDRON, [a, b, c, c, e, f, g, g]),
            (VTK_HEXAHEDRON, [a, c, d, d, e, g, h, h]),
        ]
        found = []
        for split in (wedges, hexahedra):
            grid = gallery.make_grid(points, plain + split)
            counts = [self.evaluate(grid, ["IsBoundary"])["IsBoundary"].sum()]
            for port in range(3):
                counts.append(self.array(self.elements(grid, port), "IsBoundary").sum())
            faces = self.elements(grid, 0)
            counts.append(self.array(faces, "FaceCellCount").max())
            counts.append(self.array(self.elements(grid, 2), "VertexFaceCount").sum())
            found.append(counts)
        self.assertEqual(found[0], found[1])
        # The triangles of the two wedges do not fit the quadrilaterals above and below.
        self.assertEqual(found[0][:2], [26 + 2, 54 + 2 * 3])

    def test_triangles_of_two_points(self):
        """One on an edge of a closed surface changes nothing for the others."""
        sides = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        names = ["MinSurfaceDihedralAngle", "MaxNonOrthogonality"]
        found = [
            self.evaluate(
                gallery.make_grid(points, [(VTK_TRIANGLE, ids) for ids in [*sides, *more]]), names
            )
            for more in ([], [(0, 1, 1)])
        ]
        for name in names:
            self.assertFalse(numpy.isnan(found[0][name]).any(), name)
            numpy.testing.assert_array_equal(found[1][name][:4], found[0][name])

    def test_faces_run_out_of_their_owners(self):
        """However the faces of polyhedra are stored."""
        sides = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
        for turned in (range(0), range(6), (1, 4)):
            cell = [list(side[::-1] if i in turned else side) for i, side in enumerate(sides)]
            grid = gallery.make_grid(CUBE, [(VTK_POLYHEDRON, cell)], turns=False)
            faces = self.elements(grid, 0)
            self.assertEqual(faces.GetNumberOfCells(), 6)
            for i in range(6):
                normal = [0.0, 0.0, 0.0]
                face = faces.GetCell(i).GetPoints()
                vtkPolygon.ComputeNormal(face, normal)
                center = vtk_to_numpy(face.GetData()).mean(axis=0)
                self.assertAlmostEqual(float(numpy.dot(center - 0.5, normal)), 0.5, msg=str(turned))

    def test_flat_point_sets(self):
        """Convex point sets have hulls of all their points that face outward, also flat ones; too few have none."""
        places = numpy.random.default_rng(4).normal(size=(30, 3))
        places /= numpy.linalg.norm(places, axis=1)[:, None]
        names = ["Volume", "FaceOrientationStatus"]
        volumes = []
        for scale in (1, 0.01, 1e-4):
            points = [tuple(point) for point in places * [1, 1, scale]]
            grid = gallery.make_grid(points, [(VTK_CONVEX_POINT_SET, list(range(30)))])
            found = self.evaluate(grid, names)
            self.assertEqual(found["FaceOrientationStatus"].tolist(), [0])
            volumes.append(found["Volume"][0] / scale)
        self.assertGreater(volumes[0], 2.4)  # of a ball: 4.19
        numpy.testing.assert_allclose(volumes, volumes[0], rtol=0.01)
        few = [(VTK_CONVEX_POINT_SET, list(range(count))) for count in range(4)]
        found = self.evaluate(gallery.make_grid(CUBE, few), ["Volume"])
        self.assertTrue(numpy.isnan(found["Volume"]).all())

    def test_images_far_from_the_origin(self):
        """Their coordinates are computed, with all digits."""
        image = vtkImageData()
        image.SetDimensions(4, 4, 4)
        image.SetSpacing(0.1, 0.1, 0.1)
        image.SetOrigin(1e6, 1e6, 1e6)
        found = self.evaluate(image, ["Volume", "MinDihedralAngle", "CellStatus"])
        numpy.testing.assert_allclose(found["Volume"], 1e-3, rtol=1e-8)
        numpy.testing.assert_allclose(found["MinDihedralAngle"], 90, rtol=1e-8)
        self.assertFalse(found["CellStatus"].any())
        edges = self.elements(image, 1)
        numpy.testing.assert_allclose(self.array(edges, "EdgeLength"), 0.1, rtol=1e-8)

    def test_faces_that_cross_themselves(self):
        """Bow-ties have zero area up to rounding, and rounding decides nothing, whatever their orientation in space."""
        random = numpy.random.default_rng(1)
        turns = [numpy.linalg.qr(random.normal(size=(3, 3)))[0] for _ in range(20)]
        turns = [numpy.eye(3)] + [turn * numpy.sign(numpy.linalg.det(turn)) for turn in turns]
        bow_tie = numpy.array([(0, 0, 0), (2.3, 1, 0), (2, 0, 0), (0.3, 1, 0)])
        points = numpy.concatenate([bow_tie @ turn.T for turn in turns])
        cells = [(VTK_QUAD, list(range(4 * i, 4 * i + 4))) for i in range(len(turns))]
        found = self.evaluate(
            gallery.make_grid(points.tolist(), cells, turns=False),
            [
                "MaxBoundaryNonOrthogonality",
                "MaxFaceSkewness",
                "OrthogonalQuality",
                "PrincipalAspectRatio",
            ],
        )
        self.assertTrue(numpy.isnan(found["MaxBoundaryNonOrthogonality"]).all())
        self.assertTrue(numpy.isnan(found["MaxFaceSkewness"]).all())
        self.assertFalse(found["OrthogonalQuality"].any())
        numpy.testing.assert_allclose(
            found["PrincipalAspectRatio"], found["PrincipalAspectRatio"][0]
        )

        swapped = numpy.array([CUBE[i] for i in (1, 0, 2, 3, 4, 5, 6, 7)])
        points = numpy.concatenate([swapped @ turn.T for turn in turns])
        cells = [(VTK_HEXAHEDRON, list(range(8 * i, 8 * i + 8))) for i in range(len(turns))]
        names = ["Volume", "SurfaceArea", "KernelRatio", "IsStarShaped", "CellStatus"]
        found = self.evaluate(gallery.make_grid(points.tolist(), cells, turns=False), names)
        for name in names:
            numpy.testing.assert_allclose(found[name], found[name][0], rtol=1e-9, err_msg=name)
        self.assertFalse(found["IsStarShaped"].any())

    def test_short_edges_of_float_points(self):
        """What is little of its cell is not flat for that; perfect cubes are good far from the origin."""
        source = simple.OpenDataFile(str(camaron_testing.EXAMPLES / "voronoi-ball.visf"))
        names = ["MinTetVolume", "MinTetMeanRatio", "MinTetQuality", "CellStatus"]
        quality = simple.ElementQuality(Input=source, Criteria=names)
        cells = self.fetch(quality).GetCellData()
        found = {name: vtk_to_numpy(cells.GetArray(name)) for name in names}
        for name in names[:3]:
            self.assertTrue((found[name][found["CellStatus"] == 0] > 0).all(), name)
        points = [tuple(15000.0 + x for x in point) for point in CUBE]
        cube = gallery.make_grid(points, [(VTK_HEXAHEDRON, list(range(8)))])
        self.assertAlmostEqual(self.evaluate(cube, names)["MinTetVolume"][0], 1 / 24)

    def test_nodes_of_higher_order(self):
        """Verdict's measures that depend on the order of vertices are those of the linear cell."""
        random = numpy.random.default_rng(7)
        for kinds, corners, name in (
            ((VTK_QUADRATIC_HEXAHEDRON, VTK_HEXAHEDRON, 20), CUBE, "VerdictEdgeRatio"),
            (
                (VTK_QUADRATIC_TETRA, VTK_TETRA, 10),
                [CUBE[i] for i in (0, 1, 3, 4)],
                "VerdictMinAngle",
            ),
        ):
            points, cells = [], []
            for _ in range(5):
                first, size = len(points), len(corners)
                points += (numpy.array(corners) + 0.12 * random.normal(size=(size, 3))).tolist()
                points += [(0.5, 0.5, 0.5)] * (kinds[2] - size)
                cells.append((kinds[0], list(range(first, first + kinds[2]))))
                cells.append((kinds[1], list(range(first, first + size))))
            values = self.evaluate(gallery.make_grid(points, cells, turns=False), [name])[name]
            numpy.testing.assert_allclose(values[::2], values[1::2], rtol=1e-12, err_msg=name)

    def test_strips(self):
        """Mesh Elements takes the triangles of strips, as Element Quality does."""
        points = [(0, 0, 0), (0, 1, 0.2), (1, 0, 0), (1, 1, 0), (2, 0, 0.1), (2, 1, 0)]
        strip = gallery.make_grid(points, [(VTK_TRIANGLE_STRIP, list(range(6)))], turns=False)
        triangles = [[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 5, 4]]
        same = gallery.make_grid(points, [(VTK_TRIANGLE, ids) for ids in triangles], turns=False)
        for port, name, size in (
            (0, "OwnerCell", 4),
            (1, "EdgeDihedralAngle", 9),
            (2, "VertexCellCount", 6),
        ):
            values = [self.array(self.elements(mesh, port), name) for mesh in (strip, same)]
            self.assertEqual(len(values[0]), size)
            numpy.testing.assert_array_equal(*values, err_msg=name)

    def test_edges_of_polygons_of_other_pieces(self):
        """Of an edge that belongs to a piece with 3D cells only, the polygons of other pieces are known."""
        points = [*CUBE[:6], (1, 1.2, 1), CUBE[7], (2.5, 0.3, 0), (2, 1, 0)]
        cells = [
            (VTK_HEXAHEDRON, list(range(8))),
            (VTK_QUAD, [0, 1, 2, 3]),
            (VTK_QUAD, [1, 8, 9, 2]),
        ]
        names = [
            "BoundaryNonOrthogonality",
            "FaceSkewness",
            "NonOrthogonality",
            "EdgeDihedralAngle",
        ]
        whole = gallery.make_grid(points, cells, turns=False)
        pieces = vtkPartitionedDataSetCollection()
        for i, chosen in enumerate((cells[:1], cells[1:2], cells[2:])):
            pieces.SetPartition(0, i, gallery.make_grid(points, chosen, turns=False))

        def values_of(data):
            found = {}
            elements = simple.MeshElements(Input=mesh_parts.producer(data), EdgeArrays=names)
            elements.UpdatePipeline()
            for edges in camaron_testing.leaves(
                elements.GetClientSideObject().GetOutputDataObject(1)
            ):
                arrays = [self.array(edges, name) for name in names]
                ghosts = edges.GetCellData().GetArray("vtkGhostType")
                for edge in range(edges.GetNumberOfCells()):
                    ends = edges.GetCell(edge).GetPointIds()
                    place = tuple(sorted(edges.GetPoint(ends.GetId(i)) for i in (0, 1)))
                    if not ghosts or not ghosts.GetValue(edge):
                        found[place] = [array[edge] for array in arrays]
            return found

        expected, found = values_of(whole), values_of(pieces)
        self.assertEqual(expected.keys(), found.keys())
        for place, values in expected.items():
            numpy.testing.assert_array_equal(found[place], values, str(place))

    def test_facets_of_three_cells_only(self):
        """All criteria with neighbors report them as a defect of the mesh."""
        cells = [(VTK_QUAD, [0, 1, 2, 3])] * 3
        quality = simple.ElementQuality(
            Input=mesh_parts.producer(gallery.make_grid(CUBE[:4], cells)),
            Criteria=["MaxNonOrthogonality", "MaxFaceSkewness", "MinFaceWeight"],
            WriteUndefinedMask=1,
        )
        found = self.fetch(quality)
        for name in ("MaxNonOrthogonality", "MaxFaceSkewness", "MinFaceWeight"):
            self.assertEqual(self.array(found, name + "_Undefined").tolist(), [3, 3, 3], name)

    def test_hidden_cells(self):
        """They are no neighbors, in grids of any class."""
        structured = vtkStructuredGrid()
        structured.SetDimensions(4, 4, 4)
        points = vtkPoints()
        for k, j, i in numpy.ndindex(4, 4, 4):
            points.InsertNextPoint(i + (0.4 * j if i == 2 else 0), j, k)
        structured.SetPoints(points)
        middle = 13
        structured.BlankCell(middle)
        grid = vtkUnstructuredGrid()
        grid.SetPoints(points)
        grid.Allocate(27)
        ids = vtkIdList()
        for cell in range(27):
            structured.GetCellPoints(cell, ids)
            grid.InsertNextCell(VTK_HEXAHEDRON, ids)
        names = [*OF_NEIGHBORS, "MinVolumeRatio", "CellDeterminant", "RelativeSize"]
        for flag in (vtkDataSetAttributes.HIDDENCELL, vtkDataSetAttributes.REFINEDCELL):
            structured.GetCellGhostArray().SetValue(middle, flag)
            grid.GetCellData().AddArray(structured.GetCellGhostArray())
            expected, found = self.evaluate(structured, names), self.evaluate(grid, names)
            for name in names:
                numpy.testing.assert_allclose(found[name], expected[name], rtol=1e-12, err_msg=name)
                self.assertTrue(numpy.isnan(found[name][middle]), name)
            self.assertEqual(int(self.array(self.elements(grid, 0), "IsBoundary").sum()), 54 + 6)

    def test_hidden_polygons(self):
        """They are no neighbors in surfaces either: the values are those of the surface without them."""
        names = [*OF_NEIGHBORS, "MinVolumeRatio", "MaxNeighborNormalAngle", "RegionId"]
        points = numpy.array([(i + 0.3 * j * j, j, 0.5 * (i == 2)) for j, i in numpy.ndindex(4, 4)])
        quads = [
            [4 * j + i, 4 * j + i + 1, 4 * j + i + 5, 4 * j + i + 4] for j, i in numpy.ndindex(3, 3)
        ]

        def make_surface(quads):
            surface = vtkPolyData()
            surface.SetPoints(vtkPoints())
            surface.GetPoints().SetData(numpy_to_vtk(points, deep=1))
            surface.Allocate(len(quads))
            for quad in quads:
                surface.InsertNextCell(VTK_QUAD, 4, quad)
            return surface

        hidden = 4
        surface = make_surface(quads)
        surface.AllocateCellGhostArray().SetValue(hidden, vtkDataSetAttributes.HIDDENCELL)
        expected = self.evaluate(make_surface(quads[:hidden] + quads[hidden + 1 :]), names)
        found = self.evaluate(surface, names)
        for name in names:
            self.assertTrue(numpy.isnan(found[name][hidden]), name)
            numpy.testing.assert_array_equal(
                numpy.delete(found[name], hidden), expected[name], err_msg=name
            )

    def test_tolerances(self):
        """Numbers that no tolerance can be are errors."""
        source = mesh_parts.producer(gallery.make_grid(CUBE, [(VTK_HEXAHEDRON, list(range(8)))]))
        for name in ("DegeneracyTolerance", "ConvexityTolerance", "PlanarityTolerance"):
            for value in (-1, float("nan")):
                quality = simple.ElementQuality(Input=source, **{name: value})
                with camaron_testing.pipeline.Messages() as messages:
                    quality.UpdatePipeline()
                self.assertTrue(
                    any("Tolerance must be 0 to" in error for error in messages.errors),
                    (name, value),
                )
        for create in (simple.MeshElements, simple.MeshKernel):
            for value in (-1, 2):
                with camaron_testing.pipeline.Messages() as messages:
                    create(Input=source, DegeneracyTolerance=value).UpdatePipeline()
                self.assertTrue(any("Tolerance must be 0 to" in e for e in messages.errors), value)

    def test_cells_added_in_place(self):
        """Scripts that keep a grid do this: the topology computed before is no longer valid."""
        grid = gallery.make_grid(CUBE, [(VTK_HEXAHEDRON, list(range(8)))])
        source = mesh_parts.producer(grid)
        elements = simple.MeshElements(Input=source)
        quality = simple.ElementQuality(Input=source, Criteria=["RegionId", "MinVolumeRatio"])
        elements.UpdatePipeline()
        quality.UpdatePipeline()
        for _ in range(100):
            grid.InsertNextCell(VTK_TETRA, 4, [0, 1, 2, 4])
        grid.Modified()
        source.GetClientSideObject().Modified()
        source.MarkModified(source)
        elements.UpdatePipeline()
        faces = OutputPort(elements, 0).GetDataInformation()
        self.assertEqual(faces.GetNumberOfCells(), 6 + 4)
        regions = self.array(self.fetch(quality), "RegionId")
        self.assertEqual(sorted(set(regions.tolist())), [0, 1])


if __name__ == "__main__":
    camaron_testing.main()
