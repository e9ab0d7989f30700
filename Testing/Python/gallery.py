# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small meshes of every type that formats store, and the comparison of two meshes.

Neighbors fit, 3D cells have positive volume, and coordinates are no round numbers, so that every
lost digit shows.
"""

import itertools
import math

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_POLYGON,
    VTK_POLYHEDRON,
    VTK_PYRAMID,
    VTK_QUAD,
    VTK_QUADRATIC_HEXAHEDRON,
    VTK_QUADRATIC_PYRAMID,
    VTK_QUADRATIC_TETRA,
    VTK_QUADRATIC_WEDGE,
    VTK_TETRA,
    VTK_TRIANGLE,
    VTK_VERTEX,
    VTK_WEDGE,
    vtkUnstructuredGrid,
)

QUADRATIC = {
    VTK_TETRA: VTK_QUADRATIC_TETRA,
    VTK_HEXAHEDRON: VTK_QUADRATIC_HEXAHEDRON,
    VTK_WEDGE: VTK_QUADRATIC_WEDGE,
    VTK_PYRAMID: VTK_QUADRATIC_PYRAMID,
}
#: Nodes of the mirror image of a cell.
MIRRORS = {
    VTK_TETRA: (0, 2, 1, 3),
    VTK_PYRAMID: (0, 3, 2, 1, 4),
    VTK_WEDGE: (0, 2, 1, 3, 5, 4),
    VTK_HEXAHEDRON: (0, 3, 2, 1, 4, 7, 6, 5),
}


def warp(x, y, z):
    """No round numbers, but close to where it was; planes z = 0 stay."""
    return (
        x + 0.05 * math.sin(3 * y + 1) + 1 / 3,
        y + 0.05 * math.cos(2 * x) - 1 / 7,
        z * (1 + 0.1 * math.sin(x + y + 2)),
    )


def make_grid(points, cells, turns=True):
    """A grid of cells (type, ids), ids of a polyhedron being its faces.

    Inverted cells are mirrored unless `turns` is false.
    """
    grid = vtkUnstructuredGrid()
    array = vtkPoints()
    array.SetDataTypeToDouble()
    for point in points:
        array.InsertNextPoint(*point)
    grid.SetPoints(array)
    for kind, ids in cells:
        if kind == VTK_POLYHEDRON:
            stream = vtkIdList()
            for number in [len(ids), *(n for face in ids for n in (len(face), *face))]:
                stream.InsertNextId(number)
            grid.InsertNextCell(kind, stream)
            continue
        grid.InsertNextCell(kind, len(ids), ids)
        # The order of VTK's wedge depends on its version.
        if turns and kind in MIRRORS and volume(grid, grid.GetNumberOfCells() - 1) < 0:
            turned = vtkIdList()
            for node in MIRRORS[kind]:
                turned.InsertNextId(ids[node])
            grid.GetCells().ReplaceCellAtId(grid.GetNumberOfCells() - 1, turned)
    return grid


def faces(grid, cell):
    """The vertices of the faces of a 3D cell, or of a 2D cell itself, in VTK's order."""
    item = grid.GetCell(cell)
    found = []
    for i in range(max(1, item.GetNumberOfFaces())):
        part = item.GetFace(i) if item.GetNumberOfFaces() else item  # the same object each time
        ids = [part.GetPointId(i) for i in range(part.GetNumberOfPoints())]
        found.append(tuple(ids if item.IsLinear() else ids[: part.GetNumberOfEdges()]))
    return found


def volume(grid, cell):
    """By the divergence theorem, for faces that run outward."""
    total = 0.0
    for face in faces(grid, cell):
        (x, y, z), *others = map(grid.GetPoint, face)
        for (ax, ay, az), (bx, by, bz) in zip(others, others[1:]):
            total += x * (ay * bz - az * by) + y * (az * bx - ax * bz) + z * (ax * by - ay * bx)
    return total / 6


def shape(grid, cell):
    """A cell independent of the rotation of its vertices: type, oriented faces, midpoints of edges."""

    def turned(ids):
        first = ids.index(min(ids))
        return ids[first:] + ids[:first]

    item = grid.GetCell(cell)
    if item.GetCellDimension() < 2:
        ids = tuple(item.GetPointId(i) for i in range(item.GetNumberOfPoints()))
        return item.GetCellType(), ids
    middles = []
    if not item.IsLinear():
        for i in range(item.GetNumberOfEdges()):
            ids = item.GetEdge(i).GetPointIds()
            middles.append((*sorted((ids.GetId(0), ids.GetId(1))), ids.GetId(2)))
    return item.GetCellType(), tuple(sorted(map(turned, faces(grid, cell)))), tuple(sorted(middles))


def shapes(grid):
    return [shape(grid, cell) for cell in range(grid.GetNumberOfCells())]


def points_of(grid):
    return vtk_to_numpy(grid.GetPoints().GetData()).astype(float)


def lattice(nx, ny, nz, place=warp):
    """Points and ids of a lattice, and the eight vertices of its cubes in the order of hexahedra."""
    points = [place(x, y, z) for z in range(nz + 1) for y in range(ny + 1) for x in range(nx + 1)]
    number = lambda x, y, z: x + (nx + 1) * (y + (ny + 1) * z)
    cubes = [
        [number(x + i, y + j, z + k) for k in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
        for z in range(nz)
        for y in range(ny)
        for x in range(nx)
    ]
    return points, cubes


def tetrahedra():
    points, cubes = lattice(3, 2, 2)
    at = {(0, 0, 0): 0, (1, 0, 0): 1, (1, 1, 0): 2, (0, 1, 0): 3}
    at.update({(x, y, 1): n + 4 for (x, y, _), n in list(at.items())})
    cells = []
    for cube in cubes:
        for order in itertools.permutations(range(3)):  # the six of a cube along its diagonal
            corner, path = [0, 0, 0], [0]
            for axis in order:
                corner[axis] = 1
                path.append(at[tuple(corner)])
            cells.append((VTK_TETRA, [cube[n] for n in path]))
    return make_grid(points, cells)


def inverted():
    """Some inverted tetrahedra."""
    grid = tetrahedra()
    for cell in range(0, grid.GetNumberOfCells(), 7):
        ids = [grid.GetCell(cell).GetPointId(i) for i in MIRRORS[VTK_TETRA]]
        turned = vtkIdList()
        for i in ids:
            turned.InsertNextId(i)
        grid.GetCells().ReplaceCellAtId(cell, turned)
    return grid


def mixed(size=1):
    """Rows of a cube, wedges, pyramids and a cube, `size` times `size` of them, with a tetrahedron on one."""
    points, cubes = lattice(4, size, size)
    sides = [(i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4) for i in range(4)]
    cells = []
    for row in range(size * size):
        first, c, last = cubes[4 * row], cubes[4 * row + 1], cubes[4 * row + 3]
        cells.append((VTK_HEXAHEDRON, first))
        cells += [
            (VTK_WEDGE, [c[i] for i in ids]) for ids in ((0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7))
        ]
        c = cubes[4 * row + 2]
        points.append(tuple(numpy.mean([points[i] for i in c], axis=0)))
        for quad in ((0, 3, 2, 1), (4, 5, 6, 7), *sides):
            cells.append((VTK_PYRAMID, [c[i] for i in quad] + [len(points) - 1]))
        cells.append((VTK_HEXAHEDRON, last))
    c = cubes[4 * size * (size - 1) + 1]
    points.append(warp(1.6, 0.4, size + 1.1))
    cells.append((VTK_TETRA, [c[4], c[5], c[6], len(points) - 1]))
    return make_grid(points, cells)


def polyhedra():
    """Adjacent hexagonal prisms in several layers."""
    centers = [(0, 0), (1.5, math.sqrt(3) / 2), (0, math.sqrt(3))]
    points, numbers, cells = [], {}, []

    def number(x, y, layer):
        key = (round(x, 6), round(y, 6), layer)
        if key not in numbers:
            numbers[key] = len(points)
            points.append(warp(x, y, layer))
        return numbers[key]

    angles = [math.pi / 3 * i for i in range(6)]
    for layer in range(2):
        for cx, cy in centers:
            low, high = (
                [number(cx + math.cos(a), cy + math.sin(a), k) for a in angles]
                for k in (layer, layer + 1)
            )
            sides = [(low[i], low[(i + 1) % 6], high[(i + 1) % 6], high[i]) for i in range(6)]
            cells.append((VTK_POLYHEDRON, [tuple(reversed(low)), tuple(high), *sides]))
    return make_grid(points, cells)


def _sheet(place, sizes):
    """Polygons of given sizes over a lattice: two triangles, a quad, or hexagons of two squares."""
    points, cubes = lattice(4, 3, 0, place)
    number = lambda x, y: x + 5 * y
    cells = []
    for y in range(3):
        for x in range(0, 4, 2):
            a, b, c = number(x, y), number(x + 1, y), number(x + 2, y)
            d, e, f = number(x + 2, y + 1), number(x + 1, y + 1), number(x, y + 1)
            size = sizes[len(cells) % len(sizes)]
            if size == 3:
                cells += [(VTK_TRIANGLE, t) for t in ((a, b, e), (a, e, f), (b, c, d), (b, d, e))]
            elif size == 4:
                cells += [(VTK_QUAD, (a, b, e, f)), (VTK_QUAD, (b, c, d, e))]
            else:
                cells.append((VTK_POLYGON, (a, b, c, d, e, f)))
    return make_grid(points, cells)


def hills(x, y, z):
    x, y, _ = warp(x, y, z)
    return x, y, 0.3 * math.sin(2 * x + y) + 1 / 9


def triangles():
    return _sheet(hills, [3])


def quads():
    return _sheet(hills, [4])


def polygons():
    return _sheet(hills, [6, 3, 4])


def plane():
    """For formats of two dimensions."""
    return _sheet(warp, [4, 3, 6])


def quadratic(grid):
    """The same cells with midpoints of their edges."""
    points = [grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())]
    middles, cells = {}, []
    for cell in range(grid.GetNumberOfCells()):
        item = grid.GetCell(cell)
        corners = [item.GetPointId(i) for i in range(item.GetNumberOfPoints())]
        kind = QUADRATIC[item.GetCellType()]
        size = {4: 10, 5: 13, 6: 15, 8: 20}[len(corners)]
        # VTK's quadratic wedge runs the other way than the linear one in some versions.
        for order in (range(len(corners)), MIRRORS[item.GetCellType()]):
            ids = [corners[i] for i in order]
            if volume(make_grid(points, [(kind, ids + ids[:1] * (size - len(ids)))]), 0) > 0:
                break
        # Where the nodes of edges belong says a cell whose ids are the places in its list.
        probe = make_grid([(0, 0, 0)] * size, [(kind, list(range(size)))]).GetCell(0)
        nodes = ids + [0] * (size - len(ids))
        for i in range(probe.GetNumberOfEdges()):
            a, b, middle = (probe.GetEdge(i).GetPointId(j) for j in range(3))
            key = frozenset((ids[a], ids[b]))
            nodes[middle] = middles.setdefault(key, len(points) + len(middles))
        cells.append((kind, nodes))
    for key in middles:
        a, b = (numpy.array(points[i]) for i in key)
        points.append(tuple((a + b) / 2))
    return make_grid(points, cells)


def quadratic_tetrahedra():
    return quadratic(tetrahedra())


def quadratic_mixed():
    return quadratic(mixed())


def bent(grid):
    """Moves its points so that edges of quadratic cells are not straight; returns it."""
    points = vtk_to_numpy(grid.GetPoints().GetData())
    points[:, 2] += 0.25 * numpy.sin(2 * points[:, 0])
    points[:, 1] += 0.2 * numpy.sin(3 * points[:, 0])
    return grid


def cloud():
    points, _ = lattice(2, 2, 2)
    return make_grid(points, [(VTK_VERTEX, (i,)) for i in range(len(points))])


MESHES = {
    make.__name__: make
    for make in (
        tetrahedra,
        inverted,
        mixed,
        polyhedra,
        triangles,
        quads,
        polygons,
        plane,
        quadratic_tetrahedra,
        quadratic_mixed,
        cloud,
    )
}
