# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Polygons that touch themselves, and the polyhedra over them."""

from mesh_parts import producer
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkUnstructuredGrid

#: Name, corners in the plane, area by the shoelace formula.
POLYGONS = {
    "first-again": ([(0, 0), (2, 0), (0.5, 0.5), (0, 2), (0, 0)], 1.0),
    "keyhole": (
        [(0, 0), (3, 0), (3, 3), (0, 3), (0, 0), (1, 1), (1, 2), (2, 2), (2, 1), (1, 1)],
        8.0,
    ),
    "two-holes": (
        [(0, 0), (7, 0), (7, 3), (0, 3), (0, 0), (1, 1), (1, 2), (2, 2), (4, 2), (5, 2)]
        + [(5, 1), (4, 1), (4, 2), (2, 2), (2, 1), (1, 1)],
        19.0,
    ),
    "vertex": ([(0, 0), (1, 0), (1, 1), (2, 1), (2, 2), (1, 2), (1, 1), (0, 1)], 2.0),
    "edge": (
        [(0, 0), (3, 0), (3, 3), (0, 3), (0, 1), (1, 1), (1, 2), (2, 2), (2, 1), (0, 1)],
        8.0,
    ),
}

#: A block with a hole through it, from z = 0 to 1, whose top and bottom are keyholes: its outline, volume and area.
HOLE = [(1, 1), (1, 2), (2, 2), (2, 1), (1, 1)]
BLOCKS = {
    "block": ([(0, 0), (3, 0), (3, 3), (0, 3), (0, 0), *HOLE], 8.0, 32.0),
    "angle": ([(0, 0), (5, 0), (5, 3), (3, 3), (3, 5), (0, 5), (0, 0), *HOLE], 20.0, 64.0),
}


def make_prisms(*outlines):
    """A source of the polyhedra over polygons, from z = 0 to 1, with a face at each edge that is not a bridge.

    Of every third one, every third face runs inward.
    """
    points, grid = vtkPoints(), vtkUnstructuredGrid()
    points.SetDataTypeToDouble()
    for cell, outline in enumerate(outlines):
        first = points.GetNumberOfPoints()
        numbers = {corner: first + i for i, corner in enumerate(dict.fromkeys(outline))}
        top = [numbers[corner] for corner in outline]
        size = len(numbers)
        edges = dict.fromkeys(zip(top, [*top[1:], top[0]]))
        faces = [top[::-1], [i + size for i in top]]
        faces += [[a, b, b + size, a + size] for a, b in edges if a != b and (b, a) not in edges]
        if cell % 3 == 2:
            faces = [face if i % 3 else face[::-1] for i, face in enumerate(faces)]
        for z in (0.0, 1.0):
            for x, y in numbers:
                points.InsertNextPoint(x, y, z)
        stream = vtkIdList()
        for number in (len(faces), *(number for face in faces for number in (len(face), *face))):
            stream.InsertNextId(number)
        grid.InsertNextCell(VTK_POLYHEDRON, stream)
    grid.SetPoints(points)
    return producer(grid)
