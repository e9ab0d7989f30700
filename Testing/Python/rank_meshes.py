# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes that are split over the ranks in every way, with the number of each cell in the whole mesh.

A mesh is a list of points and a list of cells (type, ids), ids of a polyhedron being its faces. Sources have every rank
import this module: it does without paraview.simple, which takes seconds to load, but where a source is made.
"""

import functools
import math
from pathlib import Path

import gallery
import mesh_files
import mesh_parts
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_ID_TYPE, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_POLYGON,
    VTK_POLYHEDRON,
    VTK_QUAD,
    VTK_TETRA,
    VTK_TRIANGLE,
    vtkPartitionedDataSetCollection,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersCore import vtkAppendFilter

EXAMPLES = Path(__file__).resolve().parents[2] / "Examples"


def voronoi():
    """Polyhedra and their faces; the pieces of an example."""
    points, faces, cells = mesh_files.read_visf(EXAMPLES / "voronoi-ball.visf")
    return points.tolist(), [(VTK_POLYHEDRON, [faces[f] for f in cell]) for cell in cells]


def tetrahedra():
    """Six tetrahedra in each cube of a warped lattice."""
    points, cubes = gallery.lattice(5, 4, 3)
    cuts = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]
    return points, [(VTK_TETRA, [cube[i] for i in cut]) for cube in cubes for cut in cuts]


def sparse():
    """Some of the tetrahedra, many of which have no more than an edge or a point in common."""
    points, cells = tetrahedra()
    return points, [cell for n, cell in enumerate(cells) if n * 7 % 12 < 5]


def overlapping():
    """Tetrahedra, some of them duplicated: faces with three and four cells."""
    points, cells = tetrahedra()
    return points, cells + [(VTK_TETRA, [ids[i] for i in (0, 2, 1, 3)]) for _, ids in cells[::7]]


def surfaces():
    """A closed surface, one that is inside out, an open one, sheets with common edges, twisted ones."""
    points, cells = [], []

    def add(part_points, part_cells):
        cells.extend((kind, [i + len(points) for i in ids]) for kind, ids in part_cells)
        points.extend(part_points)

    ball = ball_of_triangles(9, 14)
    add(*ball)
    add([(x + 3, y, z) for x, y, z in ball[0]], [(k, ids[::-1]) for k, ids in ball[1]])
    add([(x, y + 3, z) for x, y, z in ball[0]], ball[1][5:])
    twisted = [(k, ids[::-1] if n == 40 else ids) for n, (k, ids) in enumerate(ball[1])]
    add([(x + 3, y + 3, z) for x, y, z in ball[0]], twisted)
    size = 6
    sheet = [
        (x / 3, y / 3 - 4, 0.1 * math.sin(x * y)) for y in range(size + 1) for x in range(size + 1)
    ]
    wall = [
        (x / 3, 3 / 3 - 4, 0.1 * math.sin(3 * x) + z / 4) for z in (1, 2) for x in range(size + 1)
    ]
    at = lambda x, y: x + (size + 1) * y
    quads = [
        (VTK_QUAD, [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)])
        for y in range(size)
        for x in range(size)
    ]
    foot = [at(x, 3) for x in range(size + 1)]
    rows = [foot] + [[len(sheet) + x + (size + 1) * z for x in range(size + 1)] for z in (0, 1)]
    walls = [
        (VTK_POLYGON, [low[x], low[x + 1], high[x + 1], high[x]])
        for low, high in zip(rows, rows[1:])
        for x in range(size)
    ]
    add(sheet + wall, quads + walls)
    return points, cells


def ball_of_triangles(rings, spokes):
    points = [(0.0, 0.0, -1.0)]
    for i in range(1, rings):
        polar = math.pi * i / rings
        for j in range(spokes):
            angle = 2 * math.pi * (j + 0.3 * i) / spokes
            radius = 1 + 0.1 * math.sin(3 * angle) * math.sin(polar)
            points.append(
                (
                    radius * math.sin(polar) * math.cos(angle),
                    radius * math.sin(polar) * math.sin(angle),
                    -math.cos(polar),
                )
            )
    points.append((0.0, 0.0, 1.0))
    ring = lambda i, j: 1 + (i - 1) * spokes + j % spokes
    top = len(points) - 1
    cells = []
    for j in range(spokes):
        cells.append([0, ring(1, j + 1), ring(1, j)])
        for i in range(1, rings - 1):
            a, b, c, d = ring(i, j), ring(i, j + 1), ring(i + 1, j + 1), ring(i + 1, j)
            cells += [[a, b, c], [a, c, d]]
        cells.append([ring(rings - 1, j), ring(rings - 1, j + 1), top])
    return points, [(VTK_TRIANGLE, ids) for ids in cells]


def list_ids(cell):
    ids = cell.GetPointIds()
    return [ids.GetId(i) for i in range(ids.GetNumberOfIds())]


def mixed():
    """Hexahedra, wedges, tetrahedra and some of them as polyhedra, which do not all meet in whole faces."""
    grid = mesh_parts.make_mesh()
    points = [grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())]
    points = [gallery.warp(*(c / 4 for c in point)) for point in points]
    cells = []
    for i in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(i)
        if i % 5 == 0:
            faces = [list_ids(cell.GetFace(f)) for f in range(cell.GetNumberOfFaces())]
            cells.append((VTK_POLYHEDRON, faces))
        else:
            cells.append((grid.GetCellType(i), list_ids(cell)))
    return points, cells


def pair():
    """Two cells, fewer than there may be ranks."""
    points, cells = tetrahedra()
    return points, cells[:2]


def torn(gap=1.2e-6):
    """Hexahedra with points of their own, which lie up to a gap from where those of their neighbors do."""
    places, cubes = gallery.lattice(4, 3, 3)
    shifts = numpy.random.default_rng(5).uniform(-gap, gap, (8 * len(cubes), 3)) / 2
    points = [
        tuple(x + dx for x, dx in zip(places[i], shifts[8 * n + k]))
        for n, cube in enumerate(cubes)
        for k, i in enumerate(cube)
    ]
    return points, [(VTK_HEXAHEDRON, list(range(8 * n, 8 * n + 8))) for n in range(len(cubes))]


def doubled():
    """The same without a gap: only ids tell that the points are different."""
    return torn(0)


MESHES = {
    function.__name__: functools.lru_cache(function)
    for function in (voronoi, tetrahedra, sparse, overlapping, surfaces, mixed, pair)
}
#: For what tells about points that lie in one place.
LOOSE = {function.__name__: functools.lru_cache(function) for function in (torn, doubled)}


def points_of(cell):
    kind, ids = cell
    return set(i for face in ids for i in face) if kind == VTK_POLYHEDRON else set(ids)


def take(points, cells, numbers, copies=(), first_id=None, is_float=False):
    """A grid of the cells with these numbers, then of ghosts, with points in its own order.

    With `first_id`, points and cells have global ids; with `is_float`, points have single precision.
    """
    chosen = [*numbers, *copies]
    places = {}
    for number in reversed(chosen):
        for point in sorted(points_of(cells[number]), key=lambda i: (i * 7919) % 10007):
            places.setdefault(point, len(places))

    def renumber(ids):
        return [renumber(i) if isinstance(i, (list, tuple)) else places[i] for i in ids]

    grid = gallery.make_grid(
        [points[i] for i in places], [(cells[n][0], renumber(cells[n][1])) for n in chosen]
    )
    if is_float:
        rounded = vtkPoints()
        rounded.SetDataTypeToFloat()
        rounded.DeepCopy(grid.GetPoints())
        grid.SetPoints(rounded)
    add_array(grid.GetCellData(), "Number", numpy.array(chosen, numpy.int64))
    if copies:
        flags = numpy.array([0] * len(numbers) + [1] * len(copies), numpy.uint8)
        add_array(grid.GetCellData(), "vtkGhostType", flags)
    if first_id is not None:
        for data, ids in (
            (grid.GetPointData(), [first_id + 3 * i for i in places]),
            (grid.GetCellData(), [50 + 2 * n for n in chosen]),
        ):
            data.SetGlobalIds(add_array(data, "Ids", numpy.array(ids, numpy.int64)))
    return grid


def add_array(data, name, values):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    data.AddArray(array)
    return array


def append(grids):
    """One grid of several, each of which keeps its points, with their arrays and ids."""
    filter = vtkAppendFilter()
    for grid in grids:
        filter.AddInputData(grid)
    filter.Update()
    found = filter.GetOutput()
    for number in (0, 1):  # points and cells
        if grids[0].GetAttributes(number).GetGlobalIds():
            lists = [vtk_to_numpy(grid.GetAttributes(number).GetGlobalIds()) for grid in grids]
            data = found.GetAttributes(number)
            data.SetGlobalIds(add_array(data, "Ids", numpy.concatenate(lists)))
    return found


def owners_of(cells, parts, scattered):
    """To which part each cell belongs: ranges of different sizes, or anyhow."""
    if scattered:
        return numpy.random.default_rng(3).integers(0, parts, len(cells))
    cuts = [len(cells) * (i + 1) ** 2 // parts**2 for i in range(parts)]
    return numpy.searchsorted(cuts, numpy.arange(len(cells)), side="right")


def make_part(
    mesh,
    rank,
    ranks,
    scattered=False,
    ghosts=False,
    global_ids=False,
    broken_ids=False,
    empty_rank=False,
    mixed_precision=False,
    appended=1,
):
    """What a rank has; with `empty_rank` the first of several has no cell.

    With `broken_ids` ranks do not agree on the ids of points, with `mixed_precision` not on their type.
    With `appended`, the rank has so many pieces in one grid, as readers of files of pieces make it; with `ghosts`
    each with its own, so that the grid has cells several times.
    """
    points, cells = {**MESHES, **LOOSE}[mesh]()
    skipped = 1 if empty_rank and ranks > 1 else 0
    owners = owners_of(cells, ranks - skipped, scattered) + skipped
    own = [n for n in range(len(cells)) if owners[n] == rank]

    def copies_around(numbers):
        touched = set().union(*(points_of(cells[n]) for n in numbers))
        others = set(range(len(cells))) - set(numbers) if ghosts else ()
        return [n for n in sorted(others) if points_of(cells[n]) & touched]

    first_id = 1000 + broken_ids * rank if global_ids else None
    is_float = mixed_precision and rank % 2 == 1
    if not own:
        return vtkUnstructuredGrid()
    if appended > 1:
        chunks = [chunk.tolist() for chunk in numpy.array_split(own, appended) if len(chunk)]
        parts = [
            take(points, cells, chunk, copies_around(chunk), first_id, is_float) for chunk in chunks
        ]
        return append(parts)
    return take(points, cells, own, copies_around(own), first_id, is_float)


def make_blocks(mesh, rank, ranks, parts=1, global_ids=False, mixed_precision=False):
    """Two blocks, each with every other cell, of one cell type; rank 1 has nothing of the second.

    With `parts`, each block comes in so many partitions; with `mixed_precision`, the second block has
    points in single precision.
    """
    points, cells = MESHES[mesh]()
    of_block = numpy.array([n * 2 // len(cells) for n in range(len(cells))])
    collection = vtkPartitionedDataSetCollection()
    collection.SetNumberOfPartitionedDataSets(2)
    for block in (0, 1):
        numbers = numpy.flatnonzero(of_block == block)
        having = [r for r in range(ranks) if not (block == 1 and r == 1)]
        if rank not in having:
            continue
        own = numpy.array_split(numbers, len(having))[having.index(rank)]
        for part, chosen in enumerate(numpy.array_split(own, parts)):
            if len(chosen):
                first_id = 1000 if global_ids else None
                is_float = mixed_precision and block == 1
                grid = take(points, cells, chosen.tolist(), (), first_id, is_float)
                collection.SetPartition(block, part, grid)
    return collection


def make_stray(rank, ranks):
    """Of two tetrahedra in turn those of a rank, with the points of both."""
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]
    cells = [(VTK_TETRA, [0, 1, 2, 3]), (VTK_TETRA, [1, 2, 4, 3])]
    if rank >= len(cells):
        return vtkUnstructuredGrid()
    grid = gallery.make_grid(points, cells[rank::ranks])
    ids = numpy_to_vtk(numpy.arange(len(points)), deep=True, array_type=VTK_ID_TYPE)
    ids.SetName("GlobalIds")
    grid.GetPointData().SetGlobalIds(ids)
    return grid


def source(function, kind, **options):
    """A source that calls a function of this module on every rank."""
    return mesh_parts.rank_source(__file__, function, kind, options)


def split_source(mesh, **options):
    return source("make_part", "vtkUnstructuredGrid", mesh=mesh, **options)


def block_source(mesh, **options):
    return source("make_blocks", "vtkPartitionedDataSetCollection", mesh=mesh, **options)
