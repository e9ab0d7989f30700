# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the lists of faces of polyhedra in VTK's files before ParaView reads them.

A list contains the number of faces and, for each face, the number of its points and these points.
VTK's readers follow these numbers without a look at the end of the list: they crash, or take the
numbers of the next cell, and nothing of that can be seen afterwards. What is not understood here
is left to the reader.
"""

from __future__ import annotations

import base64
import html
import itertools
import lzma
import mmap
import re
import struct
import zlib
from pathlib import Path
from typing import Iterator

import numpy

POLYHEDRON = 42
#: Files that name others, which contain the cells.
LISTS_OF_FILES = (".pvtu", ".vtm", ".vtmb", ".vtpc", ".vtpd")
COMPRESSORS = {b"vtkZLibDataCompressor": zlib.decompress, b"vtkLZMADataCompressor": lzma.decompress}

#: Numbers, cells with lists among them, and where these lists begin and end.
Lists = tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray, numpy.ndarray]


def check(path: Path) -> None:
    """Raises RuntimeError if a list of faces in a file does not end where it should."""
    suffix = path.suffix.lower()
    if suffix not in (".vtk", ".vtu", *LISTS_OF_FILES) or not path.is_file():
        return
    with open(path, "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
        if suffix in LISTS_OF_FILES:
            for name in re.findall(rb'\s(?:Source|file)="([^"]+)"', data):
                check(path.parent / html.unescape(name.decode(errors="replace")))
            return
        try:
            faults = [*(_legacy_faults(data) if suffix == ".vtk" else _xml_faults(data))]
        except (
            ValueError,
            TypeError,
            IndexError,
            KeyError,
            struct.error,
            zlib.error,
            lzma.LZMAError,
        ):
            return  # the reader says what is wrong
    if faults:
        raise RuntimeError(f"{path}: {faults[0]}")


def _faults(numbers: numpy.ndarray, cells, begins, ends, before: int = 0) -> Iterator[str]:
    """What is wrong with the lists `numbers[begins[i]:ends[i]]` of cells, whose file has others
    `before`."""
    inside = (0 <= begins) & (begins < ends) & (ends <= len(numbers))
    declared, found = numpy.zeros(len(cells), int), numpy.zeros(len(cells), int)
    declared[inside] = numbers[begins[inside]]
    at = begins + 1
    active = numpy.flatnonzero(inside & (declared > 0))
    while len(active):  # one face of each cell at a time
        active = active[at[active] < ends[active]]
        sizes = numbers[at[active]]
        fits = (sizes >= 0) & (sizes < ends[active] - at[active])
        active, sizes = active[fits], sizes[fits]
        at[active] += sizes + 1
        found[active] += 1
        active = active[found[active] < declared[active]]
    for i in numpy.flatnonzero(~inside | (found != declared) | (at != ends)):
        cell = f"cell {before + cells[i]} (polyhedron) has"
        if not inside[i]:
            yield f"{cell} no list of faces, expected at least their number"
        elif found[i] != declared[i]:
            yield f"{cell} {found[i]} faces in its list, expected {declared[i]}"
        else:
            length, needed = ends[i] - begins[i], at[i] - begins[i]
            yield f"{cell} a list of faces of {length} numbers, expected {needed}"


def _legacy_faults(data: mmap.mmap) -> Iterator[str]:
    """Of a legacy file, in which the lists are the points of the cells."""
    types_at = data.find(b"CELL_TYPES")
    cells_at = data.rfind(b"CELLS ", 0, max(0, types_at))
    if cells_at < 0:
        return
    is_binary = re.match(rb"[^\n]*\n[^\n]*\n\s*BINARY", data[:1024], re.I)
    types_header = re.compile(rb"CELL_TYPES\s+(\d+)[^\n]*\n").match(data, types_at)
    cells_header = re.compile(rb"CELLS\s+(\d+)\s+(\d+)[^\n]*\n").match(data, cells_at)
    count, size = int(cells_header[1]), int(cells_header[2])

    def read(begin: int, amount: int, kind: str = ">i4", most: int = 24) -> numpy.ndarray:
        if is_binary:
            return numpy.frombuffer(data, kind, amount, begin).astype(int)
        return numpy.fromstring(data[begin : begin + most * amount], int, amount, " ")

    types = read(types_header.end(), int(types_header[1]), most=5)
    cells = numpy.flatnonzero(types == POLYHEDRON)
    if not len(cells):
        return
    arrays = re.compile(rb"\s*OFFSETS\s+(\w+)\s*\n").match(data, cells_header.end())
    if arrays:  # from version 5 on
        kind = ">i8" if arrays[1].lower().endswith(b"64") else ">i4"
        offsets = read(arrays.end(), count, kind)
        after = data.find(b"CONNECTIVITY", arrays.end())
        numbers = read(data.find(b"\n", after) + 1, size, kind)
        begins, ends = offsets[:-1], offsets[1:]
    else:
        numbers = read(cells_header.end(), size)
        begins = numpy.zeros(count, int)
        at = 0
        for cell in range(count):
            begins[cell] = at + 1
            at += numbers[at] + 1
        ends = begins + numbers[begins - 1]
    yield from _faults(numbers, cells, begins[cells], ends[cells])


def _xml_faults(data: mmap.mmap) -> Iterator[str]:
    """Of an XML file, piece by piece."""
    if data.find(b'"faceoffsets"') < 0:
        return
    starts = [found.start() for found in re.finditer(rb"<Piece\s", data)]
    before = 0
    for begin, end in zip(starts, [*starts[1:], len(data)]):
        piece = re.compile(rb'<Piece\s[^>]*NumberOfCells="\s*(\d+)').match(data, begin)
        numbers = _read_array(data, b"faces", begin, end)
        offsets = _read_array(data, b"faceoffsets", begin, end)
        if len(offsets) == int(piece[1]):
            cells = numpy.flatnonzero(offsets >= 0)  # others have no faces
            ends = offsets[cells]
            begins = numpy.concatenate(([0], ends))[:-1]
            yield from _faults(numbers, cells, begins, ends, before)
        before += int(piece[1])


def _read_array(data: mmap.mmap, name: bytes, begin: int, end: int) -> numpy.ndarray:
    """The integers of an array of a piece; none if it does not exist."""
    pattern = rb'<DataArray\s[^>]*Name="' + name + rb'"[^>]*>'
    tag = re.compile(pattern).search(data, begin, end)
    if not tag:
        return numpy.zeros(0, int)
    attributes = _attributes(tag[0])
    if attributes[b"format"] == b"ascii":
        return numpy.fromstring(data[tag.end() : data.find(b"<", tag.end())], int, sep=" ")
    content = _read_binary(data, attributes, tag.end())
    order = "<" if _attributes(_root(data))[b"byte_order"] == b"LittleEndian" else ">"
    kind = attributes[b"type"].decode()  # such as UInt64
    return numpy.frombuffer(content, f"{order}{kind[0].lower()}{int(kind[-2:]) // 8}").astype(int)


def _attributes(tag: bytes) -> dict[bytes, bytes]:
    return dict(re.findall(rb'(\w+)="([^"]*)"', tag))


def _root(data: mmap.mmap) -> bytes:
    return re.compile(rb"<VTKFile\s[^>]*>").search(data)[0]


def _read_binary(data: mmap.mmap, attributes: dict[bytes, bytes], at: int) -> bytes:
    """The bytes of an array that follows its tag, or is in the section of appended data: after
    their number, or, if compressed, after the numbers and sizes of blocks."""
    root = _attributes(_root(data))
    is_raw = False
    if attributes[b"format"] == b"appended":
        section = re.compile(rb"<AppendedData\s[^>]*>").search(data)
        is_raw = _attributes(section[0])[b"encoding"] == b"raw"
        at = data.find(b"_", section.end()) + 1 + int(attributes[b"offset"])
    else:
        at = re.compile(rb"\s*").match(data, at).end()
    letter = ("<" if root[b"byte_order"] == b"LittleEndian" else ">") + "%d"
    letter += "Q" if root.get(b"header_type") == b"UInt64" else "I"
    word = struct.calcsize(letter % 1)

    def read(begin: int, count: int) -> tuple[bytes, int]:
        if is_raw:
            return data[begin : begin + count], begin + count
        after = begin + -(-count // 3) * 4
        return base64.b64decode(data[begin:after])[:count], after

    if b"compressor" not in root:
        (size,) = struct.unpack(letter % 1, read(at, word)[0])
        return read(at, word + size)[0][word:]
    (blocks,) = struct.unpack(letter % 1, read(at, word)[0])
    header, at = read(at, (3 + blocks) * word)
    sizes = struct.unpack(letter % (3 + blocks), header)[3:]
    content, _ = read(at, sum(sizes))
    decompress = COMPRESSORS[root[b"compressor"]]
    ends = itertools.accumulate(sizes)
    return b"".join(decompress(content[end - size : end]) for size, end in zip(sizes, ends))
