# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks lists of points and faces in VTK's files, and numbers of triangles, before ParaView reads them.

The list of a polyhedron contains the number of faces and, for each face, the number of its points and these points;
the lists of legacy files begin with a number, too. VTK's readers follow these numbers without a look at the end of the
list: they crash, or take the numbers of the next cell. Nothing of that can be seen afterwards. The same is true of a
binary STL file that was cut. What is not understood here is left to the reader.
"""

from __future__ import annotations

import base64
import html
import itertools
import json
import lzma
import mmap
import re
import struct
import zlib
from pathlib import Path
from typing import Iterator, Optional

import numpy
from vtkmodules.vtkCommonDataModel import vtkCellTypes, vtkGenericCell

from . import text

POLYHEDRON = 42
#: Types whose cells have any number of points, and whose VTK cells have some to begin with.
OF_ANY_SIZE = {0, 2, 4, 6, 7, 36, *range(41, 256)}
#: Files that name others, which contain the cells.
LISTS_OF_FILES = (".pvtu", ".vtm", ".vtmb", ".vtpc", ".vtpd", ".pvd", ".series")
#: Formats of VTK in XML.
XML = {f".{parallel}vt{kind}" for parallel in ("", "p") for kind in "uprsi"}
XML |= {".vtm", ".vtmb", ".vtpc", ".vtpd", ".pvd"}
#: The first two lines of legacy files, their encoding and their type.
LEGACY_HEADER = re.compile(rb"(?i)[^\n]*\n[^\n]*\n\s*(ASCII|BINARY)\s+DATASET\s+(\w+)")
#: Words of these types before one or two numbers, each of what has some bytes.
DECLARED = {
    b"unstructured_grid": (b"POINTS", b"CELLS"),
    b"structured_grid": (b"POINTS",),
    b"polydata": (b"POINTS",),
}
#: Bytes of a binary STL file before the number of triangles, and of a triangle.
STL_HEADER, STL_TRIANGLE = 80, 50
#: Larger numbers of triangles in files that do not end within a triangle stand for an unknown number. This one does so,
#: too, but VTK would allocate memory for it, and end the program.
MOST_STL_TRIANGLES = 2**31 - 1
#: Bytes of text. VTK takes an STL file for binary if 5 % of its first bytes are others.
TEXT = bytes([9, 10, 13, *range(0x20, 0x80)])
STL_SAMPLE = 256
#: Errors of files that are left to the reader.
NOT_UNDERSTOOD = (
    OSError,
    ValueError,
    OverflowError,
    TypeError,
    IndexError,
    KeyError,
    AttributeError,
    struct.error,
    zlib.error,
    lzma.LZMAError,
)
COMPRESSORS = {b"vtkZLibDataCompressor": zlib.decompress, b"vtkLZMADataCompressor": lzma.decompress}


def check(path: Path, time: Optional[float] = None) -> None:
    """Raises RuntimeError if a list in a file, or in one that it names for this time, does not end
    where it should."""
    for file in files_with_cells(path, time):
        fault = _first_fault(file)
        if fault:
            raise RuntimeError(fault if file == path else f"{file.name}: {fault}")


def files_with_cells(
    path: Path, time: Optional[float] = None, seen: Optional[set[Path]] = None
) -> Iterator[Path]:
    """The file itself, or those that it names for this time, also in lists of lists, each once: files that may not
    exist, and lists that are not understood."""
    seen, real = set() if seen is None else seen, path.resolve()
    if real in seen:
        return
    seen.add(real)
    try:
        named = files_in_list(path, time) if path.suffix.lower() in LISTS_OF_FILES else [path]
        named = list(named)
    except NOT_UNDERSTOOD:
        named = [path]
    for file in named:
        if file == path:
            yield path
        else:
            yield from files_with_cells(file, time, seen)


def files_in_list(path: Path, time: Optional[float] = None) -> Iterator[Path]:
    """The files that a list such as .pvtu, .vtm, .pvd or .series names; of a series with a time,
    only those of it. Raises ValueError or KeyError for a list that is not understood."""
    data = path.read_bytes()
    if path.suffix.lower() == ".series":
        files = json.loads(data)["files"]
        if not isinstance(files, list):
            raise ValueError("no list of files")
        names = [one if isinstance(one, str) else one["name"] for one in files]
        times = [one["time"] for one in files if not isinstance(one, str)]
        times = [0.0 if at is None else at + 0.0 for at in times]
        if len(times) < len(names):  # ParaView numbers them then
            times = range(len(names))
        if time not in times:  # the files have their own
            time = None
        found = zip(names, times)
    else:
        found = []
        data = re.sub(rb"<!--.*?-->", b"", data, flags=re.DOTALL)
        for attributes in map(_attributes, re.findall(rb"<\w+\s[^>]*>", data)):
            name = attributes.get(b"Source") or attributes.get(b"file")
            at = attributes.get(b"timestep", 0) if path.suffix.lower() == ".pvd" else None
            if name:
                name = html.unescape(name.decode(errors="replace"))
                found.append((name, None if at is None else float(at)))
    for name, at in found:
        if None in (time, at) or at == time:
            yield path.parent / name


def fault_at_ends(path: Path) -> str:
    """What is wrong with a file that is missing or empty, or, in XML, does not begin or end as it should; else
    nothing."""
    try:
        size = path.stat().st_size
        if not size:
            return "the file is empty"
        if path.suffix.lower() not in XML:
            return ""
        with open(path, "rb") as file:
            head = file.read(1 << 16)
            file.seek(max(0, size - 4096))
            tail = file.read()
    except FileNotFoundError:
        return "there is no such file"
    except OSError as error:
        return f"cannot read the file: {error.strerror}"
    if b"<VTKFile" not in head:
        return "expected a file of VTK in XML, but there is no <VTKFile at its beginning"
    return "" if b"</VTKFile" in tail else "the file is cut: expected </VTKFile> at its end"


def _first_fault(path: Path) -> Optional[str]:
    """What is wrong in a file."""
    find = {".vtk": _legacy_faults, ".vtu": _xml_faults, ".stl": _stl_faults}.get(
        path.suffix.lower()
    )
    if not find:
        return None
    try:
        with open(path, "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
            return next(find(data), None)
    except NOT_UNDERSTOOD:
        return None  # the reader says what is wrong


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
        elif declared[i] < 0:
            yield f"{cell} {declared[i]} faces in its list, expected 0 or more"
        elif found[i] != declared[i]:
            yield f"{cell} {found[i]} faces in its list, expected {declared[i]}"
        else:
            length, needed = ends[i] - begins[i], at[i] - begins[i]
            yield f"{cell} a list of faces of {length} numbers, expected {needed}"


def _legacy_faults(data: mmap.mmap) -> Iterator[str]:
    """Of a legacy file, in which the lists are the points of the cells. VTK allocates what the headers declare."""
    header = LEGACY_HEADER.match(data[:4096])
    words = DECLARED.get(header[2].lower(), ()) if header else ()
    for word in words:
        numbers = _numbers_after(data, word, header.end())
        if any(int(number) > len(data) for number in numbers):
            declared = b" ".join([word, *numbers]).decode()
            yield f"expected {declared}, but the file has only {len(data)} bytes"
            return
    types_at = data.find(b"CELL_TYPES") if b"CELLS" in words else -1
    cells_at = data.rfind(b"CELLS ", 0, max(0, types_at))
    if cells_at < 0:
        return
    is_binary = header[1].lower() == b"binary"
    types_header = re.compile(rb"CELL_TYPES\s+(\d+)[^\n]*\n").match(data, types_at)
    cells_header = re.compile(rb"CELLS\s+(\d+)\s+(\d+)[^\n]*\n").match(data, cells_at)
    count, size = int(cells_header[1]), int(cells_header[2])

    def read(begin: int, amount: int, kind: str = ">i4", most: int = 24) -> numpy.ndarray:
        if is_binary:
            return numpy.frombuffer(data, kind, amount, begin).astype(int)
        words = data[begin : begin + most * amount]
        return numpy.fromstring(words, int, min(amount, len(words)), " ")

    types = read(types_header.end(), int(types_header[1]), most=5)
    unknown = numpy.flatnonzero((types < 0) | (types > 255))
    if len(unknown):
        yield f"cell {unknown[0]} has the type {types[unknown[0]]}, which does not exist"
        return
    cells = numpy.flatnonzero(types == POLYHEDRON)
    arrays = re.compile(rb"\s*OFFSETS\s+(\w+)\s*\n").match(data, cells_header.end())
    if not arrays:
        numbers = read(cells_header.end(), size)
        if len(types) != count or len(numbers) != size:
            return
        begins, wrong = _begins(numbers, types)
        if wrong is not None:
            at = begins[wrong]
            yield _wrong_size(wrong, int(types[wrong]), numbers[at - 1], size - at)
            return
        ends = begins + numbers[begins - 1]
    elif len(cells):  # from version 5 on
        kind = ">i8" if arrays[1].lower().endswith(b"64") else ">i4"
        offsets = read(arrays.end(), count, kind)
        after = data.find(b"CONNECTIVITY", arrays.end())
        numbers = read(data.find(b"\n", after) + 1, size, kind)
        begins, ends = offsets[:-1], offsets[1:]
    if len(cells):
        yield from _faults(numbers, cells, begins[cells], ends[cells])


def _numbers_after(data: mmap.mmap, word: bytes, begin: int) -> list[bytes]:
    """One or two numbers after the first header of this word, in capitals or in small letters."""
    numbers = re.compile(rb"\s+(\d+)(?:\s+(\d+))?")
    for spelling in (word, word.lower()):
        at = begin
        while (at := data.find(spelling, at)) >= 0:
            found = numbers.match(data, at + len(word))
            if found and data[at - 1 : at].isspace():
                return [number for number in found.groups() if number]
            at += len(word)
    return []


def _begins(numbers: numpy.ndarray, types: numpy.ndarray) -> tuple[numpy.ndarray, Optional[int]]:
    """Where the points of each cell begin, after their number; if these numbers do not lead to the
    end, those before, and the cell that is wrong."""
    sizes = numpy.array([_size(kind) for kind in range(256)])[types]
    begins = numpy.cumsum(sizes + 1) - sizes
    if begins[-1] + sizes[-1] == len(numbers) and (numbers[begins - 1] == sizes).all():
        return begins, None  # as in most files
    found, at, wrong = [], 0, None
    for cell, size in enumerate(sizes.tolist()):
        if at >= len(numbers):
            return numpy.array(found), cell - 1 if wrong is None else wrong
        found.append(at + 1)
        if wrong is None and size and numbers[at] != size:
            wrong = cell
        if not 0 <= numbers[at] < len(numbers) - at:
            return numpy.array(found), cell if wrong is None else wrong
        at += int(numbers[at]) + 1
    return numpy.array(found), None


def _size(kind: int) -> int:
    """How many points cells of a type have; 0 if that depends on the cell."""
    cell = vtkGenericCell.InstantiateCell(kind) if kind not in OF_ANY_SIZE else None
    return cell.GetNumberOfPoints() if cell else 0


def _wrong_size(cell: int, kind: int, found: int, rest: int) -> str:
    name = text.cell_type(vtkCellTypes.GetClassNameFromTypeId(kind).removeprefix("vtk"), 1)
    expected = _size(kind) or f"at most {rest}, after which the list ends"
    return f"cell {cell} ({name}) has {found} points, expected {expected}"


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


def _stl_faults(data: mmap.mmap) -> Iterator[str]:
    """Of a binary STL file, of which VTK reads the triangles that are there, as some programs write no number of
    them."""
    sample = data[:STL_SAMPLE]
    if len(sample.translate(None, TEXT)) < 0.05 * len(sample):
        return  # in ASCII
    (declared,) = struct.unpack_from("<I", data, STL_HEADER)
    found, rest = divmod(len(data) - STL_HEADER - 4, STL_TRIANGLE)
    if found < declared and (rest or declared <= MOST_STL_TRIANGLES):
        yield f"expected {declared} triangles, but the file ends after {found}"


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
    pattern = rb"""(\w+)\s*=\s*(?:"([^"]*)"|'([^']*)')"""
    return {name: double or single for name, double, single in re.findall(pattern, tag)}


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
