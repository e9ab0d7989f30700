# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Findings of reports: none for valid meshes of any type, and the worst first for bad ones."""

import math
import sys

import camaron_testing
import numpy
from camaron import check, inspect
from camaron.common import assessment
from gallery import make_grid
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_POLYHEDRON,
    VTK_QUAD,
    VTK_TETRA,
    VTK_TRIANGLE,
    VTK_WEDGE,
)
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

sys.path.insert(0, str(camaron_testing.EXAMPLES))
import make_examples

#: Corners of the tetrahedra of a cube around its diagonal, as bits of x, y and z.
KUHN = [(0, a, a | b, 7) for a, b in ((1, 2), (2, 1), (1, 4), (4, 1), (2, 4), (4, 2))]


class Lattice:
    """Points of a box of cells by their places, made as they are needed."""

    def __init__(self, place):
        self.place, self.ids, self.points = place, {}, []

    def __call__(self, *index):
        if index not in self.ids:
            self.ids[index] = len(self.points)
            self.points.append(self.place(*index))
        return self.ids[index]


def cubes(place, size):
    """The vertices of each cube, bits of x, y and z, and the points."""
    lattice = Lattice(place)
    found = [
        [lattice(i + (k & 1), j + (k >> 1 & 1), m + (k >> 2)) for k in range(8)]
        for m in range(size[2])
        for j in range(size[1])
        for i in range(size[0])
    ]
    return lattice.points, found


def hexahedron(corners):
    return (VTK_HEXAHEDRON, [corners[k] for k in (0, 1, 3, 2, 4, 5, 7, 6)])


def wedges(corners):
    """Both halves of a cube over the diagonal of its floor."""
    halves = ((0, 1, 3), (0, 3, 2))
    return [(VTK_WEDGE, [corners[k] for k in (*t, *(c + 4 for c in t))]) for t in halves]


def tetrahedra(corners):
    return [(VTK_TETRA, [corners[k] for k in t]) for t in KUHN]


def layers(m, first=1e-3, growth=1.2, count=40):
    """Height of the top of layer m: the first is a thousandth of a cell wide; at last as high as wide."""
    return sum(min(first * growth**k, 1.0) for k in range(m))


def bent(x, y, z):
    """Layers on a cylinder of radius 20 for a wall, along its normals."""
    angle = x / 20
    return ((20 + z) * math.sin(angle), y, (20 + z) * math.cos(angle))


def boundary_layer(make):
    points, found = cubes(lambda i, j, m: bent(i, j, layers(m)), (6, 3, 42))
    cells = [make(corners) for corners in found]
    return make_grid(points, sum((c if isinstance(c, list) else [c] for c in cells), []))


def anisotropic_tetrahedra():
    points, found = cubes(lambda i, j, m: (i + 0.1 * math.sin(j), j, 0.01 * m), (4, 4, 4))
    return make_grid(points, [cell for corners in found for cell in tetrahedra(corners)])


def octree():
    """Eight cubes of which one is refined: its neighbors have faces divided into four, and hanging nodes."""
    lattice = Lattice(lambda *p: tuple(x / 2 for x in p))
    boxes = [
        (tuple(o), 2)
        for o in numpy.ndindex(4, 4, 4)
        if not any(x % 2 for x in o) and o != (0, 0, 0)
    ]
    boxes += [(tuple(o), 1) for o in numpy.ndindex(2, 2, 2)]
    for (x, y, z), size in boxes:
        for i, j, k in numpy.ndindex(2, 2, 2):
            lattice(x + size * i, y + size * j, z + size * k)

    def loop(corners):
        """The vertices with the hanging nodes of the edges between them."""
        ids = []
        for a, b in zip(corners, corners[1:] + corners[:1]):
            ids.append(lattice.ids[a])
            middle = tuple((p + q) / 2 for p, q in zip(a, b))
            if all(x == int(x) for x in middle) and middle in lattice.ids:
                ids.append(lattice.ids[middle])
        return ids

    cells = []
    for origin, size in boxes:
        faces = []
        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            for side in (0, size):
                start = list(origin)
                start[axis] += side

                def square(low, width):
                    corners = []
                    for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        corner = list(low)
                        corner[u] += width * a
                        corner[v] += width * b
                        corners.append(tuple(corner))
                    return corners if side else corners[::-1]

                center = list(start)
                center[u] += 1
                center[v] += 1
                if size == 2 and tuple(center) in lattice.ids:
                    for a, b in numpy.ndindex(2, 2):
                        low = list(start)
                        low[u] += a
                        low[v] += b
                        faces.append(loop(square(low, 1)))
                else:
                    faces.append(loop(square(start, size)))
        cells.append((VTK_POLYHEDRON, faces))
    return make_grid(lattice.points, cells)


def hill(i, j):
    return (i, j, 0.5 * math.sin(0.5 * i) * math.cos(0.4 * j))


def surface(is_triangle):
    """Quadrilaterals of a hilly sheet, or both their halves where is_triangle(i, j)."""
    lattice = Lattice(hill)
    cells = []
    for i, j in numpy.ndindex(12, 12):
        a, b, c, d = (lattice(i + x, j + y) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)))
        if is_triangle(i, j):
            cells += [(VTK_TRIANGLE, (a, b, c)), (VTK_TRIANGLE, (a, c, d))]
        else:
            cells.append((VTK_QUAD, (a, b, c, d)))
    return make_grid(lattice.points, cells)


def stretched_triangles():
    """A tube of triangles a hundred times as long as wide, as along a leading edge."""
    lattice = Lattice(
        lambda i, j: (math.cos(i * math.pi / 16), math.sin(i * math.pi / 16), 20.0 * j)
    )
    cells = []
    for i, j in numpy.ndindex(32, 4):
        a, b = lattice(i, j), lattice((i + 1) % 32, j)
        c, d = lattice((i + 1) % 32, j + 1), lattice(i, j + 1)
        cells += [(VTK_TRIANGLE, (a, b, c)), (VTK_TRIANGLE, (a, c, d))]
    return make_grid(lattice.points, cells)


def box(change=lambda i, j, m: (i, j, m), make=hexahedron, size=(4, 4, 4), turns=False):
    points, found = cubes(change, size)
    cells = [make(corners) for corners in found]
    return make_grid(points, sum((c if isinstance(c, list) else [c] for c in cells), []), turns)


def as_polyhedra(grid):
    """The same cells, as polyhedra."""
    from gallery import faces

    points = [grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())]
    cells = [
        (VTK_POLYHEDRON, [list(face) for face in faces(grid, c)])
        for c in range(grid.GetNumberOfCells())
    ]
    return make_grid(points, cells)


class TestReportFindings(camaron_testing.TestCase):
    def write(self, grid, name="mesh.vtu"):
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetInputData(grid)
        writer.SetFileName(name)
        writer.Write()
        return name

    def write_ball(self):
        """The Voronoi cells of the examples, as exact as they are made."""
        points, faces, cells = make_examples.voronoi_ball()
        solids = [(VTK_POLYHEDRON, [list(map(int, faces[f])) for f in cell]) for cell in cells]
        return self.write(make_grid(points, solids), "ball.vtu")

    def findings(self, mesh, **options):
        summary = inspect(mesh, "report", with_pictures=False, **options)
        return assessment.findings(summary)

    def serious(self, mesh, **options):
        """Names of the criteria that stand first, in their order."""
        found = [f for f in self.findings(mesh, **options) if f["matters"] and not f["hint"]]
        return [c["name"] for f in found for c in f["criteria"]]

    def healthy_solids(self):
        yield "ball", self.write_ball()
        points, faces, cells = make_examples.voronoi_ball(count=90, spacing=0.29, seed=8)
        make_examples.write_visf(camaron_testing.Path("other.visf"), points, faces, cells)
        yield "voronoi", "other.visf"
        yield "octree", self.write(octree())
        yield "layers of hexahedra", self.write(boundary_layer(hexahedron))
        yield "layers of polyhedra", self.write(as_polyhedra(boundary_layer(hexahedron)))
        yield "layers of wedges", self.write(boundary_layer(wedges))
        yield "anisotropic tetrahedra", self.write(anisotropic_tetrahedra())
        yield "cubes", self.write(box())

    def healthy_surfaces(self):
        yield "quadrilaterals", self.write(surface(lambda i, j: False))
        yield "mostly quadrilaterals", self.write(surface(lambda i, j: (i + 3 * j) % 7 == 0))
        yield "triangles", self.write(surface(lambda i, j: True))
        yield "stretched triangles", self.write(stretched_triangles())
        yield "polygons", camaron_testing.EXAMPLES / "polygon-ring.visf"

    def test_healthy_meshes(self):
        """There are no findings, and checks by presets pass."""
        for presets, meshes in (
            ((None, "Finite volume"), self.healthy_solids()),
            ((None, "Surface"), self.healthy_surfaces()),
        ):
            for name, mesh in meshes:
                for preset in presets:
                    with self.subTest(name, preset=preset):
                        # Finite volumes do suffer from flat tetrahedra, finite elements need not.
                        known = ["MaxNonOrthogonality"] if "tetrahedra" in name else []
                        self.assertEqual(self.serious(mesh, preset=preset), known)
                        verdicts = check(mesh, preset=preset or "General")["checks"]
                        failed = [c["criterion"] for c in verdicts if c["verdict"] == "fail"]
                        self.assertEqual(failed, known)

    def test_no_hints_of_other_shapes(self):
        """Ranges that a document gives for triangles or tetrahedra are not applied to polyhedra."""
        for mesh in (self.write_ball(), self.write(octree())):
            found = self.findings(mesh)
            self.assertEqual([f["text"] for f in found if f["matters"]], [])
            summary = inspect(mesh, "report", with_pictures=False)
            by_name = {c["name"]: c for c in summary["criteria"]}
            for name in ("MaxFaceAngle", "EdgeLengthRatio", "MaxDihedralAngle"):
                c = by_name[name]
                self.assertFalse(assessment.is_limited(c) and c["out_of_range"], name)
                self.assertLess(c["judged"], c["applicable"], name)

    def test_shapes_of_polyhedra(self):
        """A polyhedron with the topology of a tetrahedron is evaluated as one, with the same counts."""
        flat = box(lambda i, j, m: (i, j, 0.3 * m + 0.1 * ((i + j) % 2)), tetrahedra, turns=True)
        counts = []
        for grid in (flat, as_polyhedra(flat)):
            summary = inspect(
                self.write(grid), "report", with_pictures=False, preset="FEM tetrahedra"
            )
            counts.append(
                [(c["name"], c["judged"], c["out_of_range"]) for c in summary["criteria"]]
            )
        self.assertEqual(*counts)
        self.assertEqual({judged for _, judged, _ in counts[0]}, {flat.GetNumberOfCells()})
        self.assertTrue(any(outside for _, _, outside in counts[0]))

    def test_bad_meshes(self):
        """The worst comes first, with what it means."""
        center = (2, 2, 2)
        moved = lambda to: lambda *p: to if p == center else p
        inverted = self.serious(self.write(box(moved((2.0, 2.0, 4.6)))))
        self.assertIn(inverted[0], ("Volume", "IsValid", "CornerScaledJacobian", "MinTetMeanRatio"))
        self.assertIn("CornerScaledJacobian", inverted)
        inside_out = box()
        ids = [7, 6, 5, 4, 3, 2, 1, 0]
        points = [inside_out.GetPoint(i) for i in range(inside_out.GetNumberOfPoints())]
        cells = [hexahedron(corners) for corners in cubes(lambda *p: p, (4, 4, 4))[1]]
        cells[5] = (VTK_HEXAHEDRON, [cells[5][1][k] for k in (4, 5, 6, 7, 0, 1, 2, 3)])
        self.assertIn("Volume", self.serious(self.write(make_grid(points, cells, turns=False)))[:3])
        sheared = self.write(box(lambda i, j, m: (i + 4 * m, j, m)))
        self.assertEqual(self.serious(sheared)[0], "MaxNonOrthogonality")
        sliver = [(0, 0, 0), (1, 0, 0), (1, 1, 0.01), (0, 1, 0), (0.5, 0.5, 2), (0.5, 0.5, -2)]
        slivers = make_grid(
            sliver, [(VTK_TETRA, t) for t in ((0, 1, 2, 3), (0, 1, 2, 4), (0, 1, 3, 5))]
        )
        self.assertIn("MaxDihedralAngle", self.serious(self.write(slivers)))
        jump = self.write(box(lambda i, j, m: (i, j, m if m < 3 else m + 300)))
        self.assertIn("MinVolumeRatio", self.serious(jump))
        caps = make_grid(
            [(0, 0, 0), (1, 0, 0), (0.5, 0.01, 0), (0.5, -1, 0)],
            [(VTK_TRIANGLE, (0, 1, 2)), (VTK_TRIANGLE, (1, 0, 3))],
        )
        self.assertEqual(self.serious(self.write(caps)), ["MaxInteriorAngle"])
        first = self.findings(self.write(caps))[0]
        self.assertIn("1 of 2 cells", first["text"].replace("\u202f", " "))
        self.assertIn("gradients", first["text"])


if __name__ == "__main__":
    camaron_testing.main()
