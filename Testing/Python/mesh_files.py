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


def write_exodus(path, points, cells):
    """Writes polyhedra, lists of faces of points from 0, as Exodus in classic NetCDF."""
    faces, rows = {}, []  # every face once
    for cell in cells:
        rows.append([faces.setdefault(frozenset(face), (len(faces), face))[0] + 1 for face in cell])
    lists = [[point + 1 for point in face] for _, face in faces.values()]
    sizes = {"time_step": 0, "len_name": 33, "four": 4, "num_dim": 3, "num_nodes": len(points)}
    sizes |= {"num_elem": len(rows), "num_el_blk": 1, "num_el_in_blk1": len(rows)}
    sizes |= {"num_face": len(lists), "num_fa_blk": 1, "num_fa_in_blk1": len(lists)}
    sizes |= {"num_fac_per_el1": sum(map(len, rows)), "num_nod_per_fa1": sum(map(len, lists))}
    types = {"c": 2, "i": 4, "f": 5, "d": 6}  # of NetCDF

    def padded(data):
        return data + bytes(-len(data) % 4)

    def name(word):
        return struct.pack(">i", len(word)) + padded(word.encode())

    def data(kind, values):
        return padded(
            values.encode() if kind == "c" else struct.pack(f">{len(values)}{kind}", *values)
        )

    def attributes(given):
        head = struct.pack(">2i", 12 if given else 0, len(given))
        return head + b"".join(
            name(key) + struct.pack(">2i", types[kind], len(values)) + data(kind, values)
            for key, (kind, values) in given.items()
        )

    variables = [
        ("fa_status", "num_fa_blk", "i", [1], {}),
        ("fa_prop1", "num_fa_blk", "i", [1], {"name": ("c", "ID")}),
        ("eb_status", "num_el_blk", "i", [1], {}),
        ("eb_prop1", "num_el_blk", "i", [1], {"name": ("c", "ID")}),
        *((f"coord{x}", "num_nodes", "d", [p[i] for p in points], {}) for i, x in enumerate("xyz")),
        ("fbconn1", "num_nod_per_fa1", "i", sum(lists, []), {"elem_type": ("c", "nsided")}),
        ("fbepecnt1", "num_fa_in_blk1", "i", list(map(len, lists)), {}),
        ("facconn1", "num_fac_per_el1", "i", sum(rows, []), {"elem_type": ("c", "nfaced")}),
        ("ebepecnt1", "num_el_in_blk1", "i", list(map(len, rows)), {}),
        ("time_whole", "time_step", "d", [], {}),
    ]
    given = {"api_version": ("f", [8.11]), "version": ("f", [8.11]), "title": ("c", "polyhedra")}
    given |= {"floating_point_word_size": ("i", [8]), "file_size": ("i", [1])}
    head = b"CDF\x01" + struct.pack(">3i", 0, 10, len(sizes))
    head += b"".join(name(key) + struct.pack(">i", size) for key, size in sizes.items())
    head += attributes(given)

    def describe(begin):
        """All variables, whose data begin there."""
        described = struct.pack(">2i", 11, len(variables))
        for word, size, kind, values, more in variables:
            length = len(data(kind, values))
            described += name(word) + struct.pack(">2i", 1, list(sizes).index(size))
            described += attributes(more) + struct.pack(">3i", types[kind], length or 8, begin)
            begin += length
        return described

    content = b"".join(data(kind, values) for _, _, kind, values, _ in variables)
    Path(path).write_bytes(head + describe(len(head) + len(describe(0))) + content)
