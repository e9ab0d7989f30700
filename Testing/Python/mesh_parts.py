# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes with difficult cell arrays, whole or split over the ranks.

Sources have every rank import this module: it does without paraview.simple, which takes seconds to load, but where a
source is made.
"""

from pathlib import Path

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkIdTypeArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_TETRA,
    VTK_WEDGE,
    vtkCellArray,
    vtkPartitionedDataSetCollection,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkExtractCells

SIDE = 9  # cubes along an edge


def make_mesh():
    """Cubes, some of them cut into two wedges, some with a tetrahedron instead."""
    axis = range(SIDE + 1)
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for z in axis:
        for y in axis:
            for x in axis:
                points.InsertNextPoint(x, y, z)
    cells, types = vtkCellArray(), []
    for z in range(SIDE):
        for y in range(SIDE):
            for x in range(SIDE):
                corners = [
                    i + (SIDE + 1) * (j + (SIDE + 1) * k)
                    for k in (z, z + 1)
                    for i, j in ((x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1))
                ]
                kind = (x + y * z) % 5
                shapes = [(VTK_HEXAHEDRON, range(8))]
                if kind == 1:
                    shapes = [(VTK_WEDGE, (0, 1, 2, 4, 5, 6)), (VTK_WEDGE, (0, 2, 3, 4, 6, 7))]
                elif kind == 2:
                    shapes = [(VTK_TETRA, (0, 1, 3, 4))]
                for shape, local in shapes:
                    cells.InsertNextCell(len(local), [corners[i] for i in local])
                    types.append(shape)
    grid = vtkUnstructuredGrid()
    grid.SetPoints(points)
    grid.SetCells(numpy_to_vtk(numpy.array(types, numpy.uint8), deep=True), cells)
    return grid


def are_of_type(kind):
    """Which cells of the mesh are of a VTK type."""
    grid = make_mesh()
    return numpy.array([grid.GetCellType(i) == kind for i in range(grid.GetNumberOfCells())])


def make_values(count):
    """Values by array name: ties, undefined, infinite, negative zeros, denormals, all magnitudes."""
    random = numpy.random.default_rng(20)
    values = {
        "EdgeLengthRatio": numpy.round(random.random(count), 3),
        "EquiangleSkewness": random.random(count),
        "FaceCount": random.integers(4, 9, count).astype(float),
        "Volume": numpy.exp(20 * random.standard_normal(count)),
        "AnyBits": random.integers(0, 2**64, count, numpy.uint64).view(float),
        "Constant": numpy.full(count, 0.1),
        "AllUndefined": numpy.full(count, numpy.nan),
        "Material": random.integers(-3, 4, count).astype(numpy.int32),
        "Huge": random.choice([-1.7e308, 1.7e308, 1.0], count),
        "Single": random.standard_normal(count).astype(numpy.float32),
    }
    values["EdgeLengthRatio"][random.random(count) < 0.1] = numpy.nan
    values["EquiangleSkewness"][random.random(count) < 0.05] = numpy.inf
    values["EquiangleSkewness"][random.random(count) < 0.05] = -0.0
    return values


def add_arrays(grid, values, global_ids=False):
    """Adds cell arrays and, if wanted, global ids 100, 103, 106 ... in a shuffled order."""
    for name, data in values.items():
        array = numpy_to_vtk(data, deep=True)
        array.SetName(name)
        grid.GetCellData().AddArray(array)
    if global_ids:
        ids = vtkIdTypeArray()
        ids.SetName("Ids")
        shuffled = 100 + 3 * numpy.random.default_rng(7).permutation(grid.GetNumberOfCells())
        ids.SetNumberOfValues(len(shuffled))
        vtk_to_numpy(ids)[:] = shuffled
        grid.GetCellData().SetGlobalIds(ids)
    return grid


def make_full_mesh(global_ids=False):
    """All cells with all arrays, and their numbers as the array "Number"."""
    grid = make_mesh()
    values = make_values(grid.GetNumberOfCells())
    values["Number"] = numpy.arange(grid.GetNumberOfCells())
    return add_arrays(grid, values, global_ids)


def extract(grid, begin, end, ghost_layer=0):
    """Cells [begin, end), and after them some neighbors as ghost cells."""
    total = grid.GetNumberOfCells()
    wanted = list(range(begin, end))
    ghosts = [
        *range(max(0, begin - ghost_layer), begin),
        *range(end, min(total, end + ghost_layer)),
    ]
    part = None
    for chunk in (wanted, ghosts):
        ids = vtkIdList()
        for cell in chunk:
            ids.InsertNextId(cell)
        cells = vtkExtractCells()
        cells.SetInputData(grid)
        cells.SetCellList(ids)
        cells.Update()
        piece = cells.GetOutput()
        piece.GetCellData().RemoveArray("vtkOriginalCellIds")
        flags = numpy_to_vtk(
            numpy.full(piece.GetNumberOfCells(), chunk is ghosts, numpy.uint8), deep=True
        )
        if ghost_layer:
            flags.SetName("vtkGhostType")
            piece.GetCellData().AddArray(flags)
        if part is None:
            part = piece
        elif piece.GetNumberOfCells():
            append = vtkAppendFilter()
            append.AddInputData(part)
            append.AddInputData(piece)
            append.Update()
            part = append.GetOutput()
    result = vtkUnstructuredGrid()
    result.ShallowCopy(part)
    return result


def make_part(rank, ranks, global_ids=False, ghost_layer=0, empty_rank=False):
    """The part of the mesh that a rank has; with `empty_rank` the last rank has none."""
    grid = make_full_mesh(global_ids)
    owners = max(1, ranks - 1) if empty_rank else ranks
    total = grid.GetNumberOfCells()
    if rank >= owners:
        return vtkUnstructuredGrid()
    # Unequal parts.
    cuts = [total * i * i // (owners * owners) for i in range(owners + 1)]
    return extract(grid, cuts[rank], cuts[rank + 1], ghost_layer)


def make_named_part(**options):
    """The same with the text array Name: a letter for each Material."""
    part = make_part(**options)
    names = vtkStringArray()
    names.SetName("Name")
    for material in vtk_to_numpy(part.GetCellData().GetArray("Material")):
        names.InsertNextValue("abcdefg"[material + 3])
    part.GetCellData().AddArray(names)
    return part


def rank_source(module, function, kind, options):
    """A source that calls a function of the module with this path on every rank; kind is the type of what it makes."""
    from paraview import simple

    path = Path(module)
    source = simple.ProgrammableSource()
    source.OutputDataSetType = kind
    source.PythonPath = f"'{path.parent}'"
    # Both scripts collect garbage at their end, for which Python would look at everything that there is.
    source.ScriptRequestInformation = (
        "import gc\n"
        "gc.freeze()\n"
        "from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm\n"
        "information = self.GetOutputInformation(0)\n"
        "information.Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)\n"
    )
    source.Script = (
        f"import gc, {path.stem}\n"
        "gc.freeze()\n"
        "from vtkmodules.vtkParallelCore import vtkMultiProcessController\n"
        "controller = vtkMultiProcessController.GetGlobalController()\n"
        f"self.GetOutputDataObject(0).ShallowCopy({path.stem}.{function}(\n"
        "    rank=controller.GetLocalProcessId(), ranks=controller.GetNumberOfProcesses(),\n"
        f"    **{options!r}))\n"
    )
    return source


def split_source(**options):
    """A source that gives every rank its part."""
    return rank_source(__file__, "make_part", "vtkUnstructuredGrid", options)


def named_source():
    """A source that gives every rank its named part."""
    return rank_source(__file__, "make_named_part", "vtkUnstructuredGrid", {})


def make_collection(parts=1):
    """The mesh in three named blocks of a collection, each in so many partitions, one block empty."""
    grid = make_full_mesh()
    total = grid.GetNumberOfCells()
    cuts = [0, total // 3, total // 3, total]
    collection = vtkPartitionedDataSetCollection()
    for block, name in enumerate(("first", "none", "last")):
        begin, end = cuts[block], cuts[block + 1]
        for part in range(parts):
            size = (end - begin) // parts
            last = end if part + 1 == parts else begin + (part + 1) * size
            collection.SetPartition(block, part, extract(grid, begin + part * size, last))
        collection.GetMetaData(block).Set(collection.NAME(), name)
    return collection


def producer(data):
    """A source of data made by the test itself."""
    from paraview import simple

    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    return source
