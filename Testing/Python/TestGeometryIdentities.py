# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""What must hold in every mesh: volumes fill the surface, angles the sphere, a cell is its faces.

The cells of the meshes made here are all warped, those at the boundary, too.
"""

import math

import camaron_testing
import gallery
import numpy
from camaron.common import pipeline, tables
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAGONAL_PRISM,
    VTK_HEXAHEDRON,
    VTK_PENTAGONAL_PRISM,
    VTK_POLYHEDRON,
    VTK_PYRAMID,
    VTK_TETRA,
    VTK_VOXEL,
    VTK_WEDGE,
)

#: Of 3D cells only, the same kinds as below.
OWN_MESHES = (
    "Examples/voronoi-ball.visf",
    "Readers/FluentMesh/Testing/Seeds/polyhedra.msh",
    "Readers/M3D/Testing/Seeds/cells.m3d",
)
#: Of 3D cells only; warped hexahedra, polyhedra, hanging nodes, cells that do not meet in whole faces.
REAL_MESHES = (
    "ansys_fluent/fluent_mixer_poly_bin.cas",
    "ansys_fluent/subset_mixer_poly_ascii.msh",
    "ansys_fluent/tgrid_axial_comp_3d_hex_ascii.msh",
    "ansys_fluent/fluent_plate_3d_bin.cas",
    "ansys_fluent/dev_hanging_ascii.msh",
    "ansys_fluent/dev_mixed_bin_single.msh",
    "m3d/mesher_roi_cortex.m3d",
    "m3d/mesher_roi_cyl50.m3d",
    "visf/dev_mixed_v03_little_noneigh.visf",
)
#: Take the nodes of a cell one after the other, so that its type makes a difference.
OF_NODE_ORDER = {"CellTypeId", "VerdictEdgeRatio", "VerdictMinAngle", "VerdictCollapseRatio"}
OF_POLYGONS = {"polygons", "triangles", "quadrilaterals", "triangles and quadrilaterals"}
SIZE = 3  # cubes along an axis
#: Of a cube, by the nodes of a hexahedron.
SIDES = ((0, 3, 2, 1), (4, 5, 6, 7), *((i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4) for i in range(4)))


def warped_lattice():
    """Points of a lattice, moved at random, and its cubes."""
    points, cubes = gallery.lattice(SIZE, SIZE, SIZE)
    noise = numpy.random.default_rng(8).uniform(-0.15, 0.15, (len(points), 3))
    return (numpy.array(points) + noise).tolist(), cubes


def hexahedra():
    points, cubes = warped_lattice()
    return gallery.make_grid(points, [(VTK_HEXAHEDRON, cube) for cube in cubes])


def wedges():
    points, cubes = warped_lattice()
    halves = ((0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7))
    return gallery.make_grid(
        points, [(VTK_WEDGE, [cube[i] for i in half]) for cube in cubes for half in halves]
    )


def pyramids():
    points, cubes = warped_lattice()
    cells = []
    for cube in cubes:
        cells += [(VTK_PYRAMID, [cube[i] for i in side] + [len(points)]) for side in SIDES]
        points.append(numpy.mean([points[i] for i in cube], axis=0))
    return gallery.make_grid(points, cells)


def tetrahedra():
    points, cubes = warped_lattice()
    cuts = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]
    return gallery.make_grid(
        points, [(VTK_TETRA, [cube[i] for i in cut]) for cube in cubes for cut in cuts]
    )


def voxels():
    points, cubes = gallery.lattice(SIZE, SIZE, SIZE, lambda x, y, z: (x, 1.5 * y, 0.7 * z))
    order = (0, 1, 3, 2, 4, 5, 7, 6)
    return gallery.make_grid(points, [(VTK_VOXEL, [cube[i] for i in order]) for cube in cubes])


def prisms(kind, corners):
    """A stack of prisms, of which not even two points lie in a plane with the rest."""
    random = numpy.random.default_rng(corners)
    points = [
        (math.cos(a) + x, math.sin(a) + y, layer + z)
        for layer in range(SIZE + 1)
        for a in numpy.arange(corners) * 2 * math.pi / corners
        for x, y, z in [random.uniform(-0.1, 0.1, 3)]
    ]
    return gallery.make_grid(
        points, [(kind, range(corners * i, corners * (i + 2))) for i in range(SIZE)]
    )


def pentagonal_prisms():
    return prisms(VTK_PENTAGONAL_PRISM, 5)


def hexagonal_prisms():
    return prisms(VTK_HEXAGONAL_PRISM, 6)


STANDARD = (tetrahedra, hexahedra, wedges, pyramids, voxels, pentagonal_prisms, hexagonal_prisms)


def ring_faces(grid, cell):
    """Faces as rings, also those of voxels."""
    faces = gallery.faces(grid, cell)
    if grid.GetCellType(cell) == VTK_VOXEL:
        faces = [(a, b, d, c) for a, b, c, d in faces]
    return faces


def to_polyhedra(grid):
    cells = [(VTK_POLYHEDRON, ring_faces(grid, i)) for i in range(grid.GetNumberOfCells())]
    return gallery.make_grid(gallery.points_of(grid), cells)


def enclosed_volume(rings):
    """By the divergence theorem, over the triangles about the center of every face."""
    origin = rings[0][0]
    total = 0.0
    for ring in rings:
        corner = ring[0]
        ring = ring - corner
        following = numpy.roll(ring, -1, axis=0)
        area = numpy.cross(ring, following).sum(axis=0) / 2
        mean = ring.mean(axis=0)
        weights = numpy.cross(ring - mean, following - mean) @ area
        center = mean
        if weights.sum() > 0:
            center = weights @ (ring + following + mean) / (3 * weights.sum())
        total += area @ (center + corner - origin) / 3
    return total


def boundary(grid):
    """The faces that one cell has, as rings of coordinates."""
    uses = {}
    for cell in range(grid.GetNumberOfCells()):
        for face in ring_faces(grid, cell):
            uses.setdefault(frozenset(face), []).append(face)
    points = gallery.points_of(grid)
    return [points[list(faces[0])] for faces in uses.values() if len(faces) == 1]


def surface_rings(source):
    """The polygons of Mesh Surface as rings of coordinates."""
    surface = servermanager.Fetch(simple.MeshSurface(Input=source))
    if not surface.IsA("vtkPolyData"):
        surface = surface.GetPartition(0, 0)
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    polygons = surface.GetPolys()
    ids = vtk_to_numpy(polygons.GetConnectivityArray())
    offsets = vtk_to_numpy(polygons.GetOffsetsArray())
    return [points[ids[a:b]] for a, b in zip(offsets, offsets[1:])]


def source_of(grid):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(grid)
    return source


def evaluate(source, names):
    quality = simple.ElementQuality(Input=source, Criteria=list(names), WriteUndefinedMask=1)
    with pipeline.Messages() as messages:
        data = servermanager.Fetch(quality)
    assert not messages.errors, messages.errors
    if not data.IsA("vtkDataSet"):
        data = data.GetPartition(0, 0)
    cells = data.GetCellData()
    return {
        name: (
            vtk_to_numpy(cells.GetArray(name)),
            vtk_to_numpy(cells.GetArray(f"{name}_Undefined")),
        )
        for name in names
    }


class TestGeometryIdentities(camaron_testing.TestCase):
    def test_volumes_fill_the_surface(self):
        """Neighbors see the same center of a warped face, so that nothing is counted twice or lost."""
        for make in STANDARD:
            grid = make()
            for mesh in (grid, to_polyhedra(grid)):
                rings = boundary(mesh)
                volumes, _ = evaluate(source_of(mesh), ["Volume"])["Volume"]
                self.assertGreater(volumes.min(), 0, make.__name__)
                expected = enclosed_volume(rings)
                self.assertAlmostEqual(volumes.sum() / expected, 1, delta=1e-13, msg=make.__name__)
                shown = enclosed_volume(surface_rings(source_of(mesh)))
                self.assertAlmostEqual(shown / expected, 1, delta=1e-13, msg=make.__name__)

    def test_volumes_of_files(self):
        """The same for meshes of other programs, with non-matching and warped faces."""
        for path in [camaron_testing.ROOT / name for name in OWN_MESHES] + self.real(*REAL_MESHES):
            name = path.name
            source = pipeline.open_mesh(path).source
            found = evaluate(source, ["Volume", "MaxWarpage"])
            volumes, reasons = found["Volume"]
            self.assertEqual(set(reasons), {0}, name)
            expected = enclosed_volume(surface_rings(source))
            self.assertAlmostEqual(volumes.sum() / expected, 1, delta=1e-10, msg=name)
            if "mixer" in name or "cortex" in name:
                self.assertGreater(found["MaxWarpage"][0].max(), 0.01, name)
            simple.Delete(source)

    def test_angles_fill_the_sphere(self):
        """Around an inner vertex 4 pi also where faces are warped, as neighbors share the edges."""
        for make in (tetrahedra, hexahedra, wedges, pyramids):
            grid = make()
            for mesh in (grid, to_polyhedra(grid)):
                elements = simple.MeshElements(
                    Input=source_of(mesh), VertexArrays=["IsBoundary", "VertexAngleSum"]
                )
                data = self.fetch(elements, 2).GetCellData()
                inner = vtk_to_numpy(data.GetArray("IsBoundary")) == 0
                self.assertGreaterEqual(inner.sum(), (SIZE - 1) ** 3)
                sums = vtk_to_numpy(data.GetArray("VertexAngleSum"))[inner]
                self.assertLess(abs(sums / (4 * math.pi) - 1).max(), 1e-13, make.__name__)

    def test_angles_of_tetrahedra(self):
        """The solid angles of a tetrahedron are twice its dihedral angles less a full sphere."""
        random = numpy.random.default_rng(4)
        points = random.uniform(-1, 1, (200, 3)).tolist()
        cells = [(VTK_TETRA, range(i, i + 4)) for i in range(0, 200, 4)]
        elements = simple.MeshElements(
            Input=source_of(gallery.make_grid(points, cells)),
            EdgeArrays=["EdgeAngleSum"],
            VertexArrays=["VertexAngleSum"],
        )
        edges, vertices = (self.fetch(elements, port) for port in (1, 2))
        dihedral, solid = numpy.zeros(50), numpy.zeros(50)
        sums = vtk_to_numpy(edges.GetCellData().GetArray("EdgeAngleSum"))
        ends = vtk_to_numpy(edges.GetLines().GetConnectivityArray())[::2]
        places = vtk_to_numpy(edges.GetPoints().GetData())[ends]
        of_point = {tuple(point): i // 4 for i, point in enumerate(points)}
        numpy.add.at(dihedral, [of_point[tuple(p)] for p in places], numpy.radians(sums))
        sums = vtk_to_numpy(vertices.GetCellData().GetArray("VertexAngleSum"))
        places = vtk_to_numpy(vertices.GetPoints().GetData())
        numpy.add.at(solid, [of_point[tuple(p)] for p in places], sums)
        numpy.testing.assert_allclose(solid, 2 * dihedral - 4 * math.pi, atol=1e-12)

    def test_standard_cells_are_polyhedra(self):
        """A cell and the polyhedron of its faces have the same value of every criterion there is.

        Here with neighbors; every criterion of 3D cells must have had a value to compare.
        """
        names = set(tables.known_criteria()) - OF_NODE_ORDER
        compared = set()
        for make in STANDARD:
            grid = make()
            standard = evaluate(source_of(grid), names)
            polyhedra = evaluate(source_of(to_polyhedra(grid)), names)
            for name in names:
                what = f"{make.__name__}: {name}"
                (values, reasons), (others, other_reasons) = standard[name], polyhedra[name]
                numpy.testing.assert_array_equal(reasons, other_reasons, what)
                numpy.testing.assert_allclose(values, others, rtol=1e-9, atol=1e-11, err_msg=what)
                if (reasons == 0).any():
                    compared.add(name)
        of_solids = {
            name
            for name, criterion in tables.known_criteria().items()
            if criterion["applies_to"] not in OF_POLYGONS
        }
        self.assertEqual(of_solids - OF_NODE_ORDER - compared, set())


if __name__ == "__main__":
    camaron_testing.main()
