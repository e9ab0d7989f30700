# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of meshes, read and written without ParaView and the plugin."""

import io
import struct
from pathlib import Path

import numpy


def read_visf(path):
    """Points, faces, cells of a little-endian or ASCII Visf 0.3 file, without the plugin."""
    data = Path(path).read_bytes()
    if data[:1] == b"2":
        words = iter(data.split()[2:])
        integer, real = (lambda: int(next(words))), (lambda: float(next(words)))
    else:
        stream = io.BytesIO(data[5:])
        integer = lambda: struct.unpack("<i", stream.read(4))[0]
        real = lambda: struct.unpack("<f", stream.read(4))[0]
    points = numpy.array([[real(), real(), real()] for _ in range(integer())])
    faces = [[integer() for _ in range(integer())] for _ in range(integer())]
    assert integer() == 0, "no lists of neighbors"
    try:
        number = integer()
    except (StopIteration, struct.error):
        return points, faces, []
    return points, faces, [[integer() for _ in range(integer())] for _ in range(number)]


def write_vtk(path, points, cells, name="UNSTRUCTURED_GRID"):
    """Writes a legacy VTK file; cells are (type, ids), for a polyhedron (42, face stream)."""
    size = sum(len(ids) + 1 for _, ids in cells)
    lines = ["# vtk DataFile Version 3.0", "test", "ASCII", f"DATASET {name}"]
    lines.append(f"POINTS {len(points)} double")
    lines += [" ".join(repr(float(x)) for x in point) for point in points]
    lines.append(f"CELLS {len(cells)} {size}")
    lines += [" ".join(map(str, (len(ids), *ids))) for _, ids in cells]
    lines.append(f"CELL_TYPES {len(cells)}")
    lines += [str(kind) for kind, _ in cells]
    Path(path).write_text("\n".join(lines) + "\n")
    return path
