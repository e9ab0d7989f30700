# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays that readers of ParaView lose without an error: of legacy VTK files (.vtk) with too few values, of which they
only warn, and of OpenFOAM cases with files that are empty or end early."""

from __future__ import annotations

import mmap
import os
import re
from pathlib import Path
from typing import Any, Collection, Iterator, Optional
from urllib.parse import unquote

from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes

from . import text, vtk_lists

#: Warnings of VTK's readers of legacy files about values that are not there.
LOST = re.compile(r"^Error reading (ascii|binary) data")
#: Starts of the data of points and cells, and of arrays.
HEADERS = re.compile(
    rb"(?mi)^\s*(POINT|CELL)_DATA\s+\d+\s*$"
    rb"|^\s*(?:(?:COLOR_)?SCALARS|VECTORS|NORMALS|TENSORS6?|TEXTURE_COORDINATES|GLOBAL_IDS|PEDIGREE_IDS)\s+(\S+).*$"
    rb"|^\s*(\S+)\s+\d+\s+\d+\s+"
    rb"(?:bit|string|float|double|vtk\w+|(?:unsigned_|signed_)?(?:char|short|int|long|long_long))\s*$"
)
#: Files in a time step of OpenFOAM that its readers pass over.
NO_FIELD = re.compile(r"^\..*|.*(~|_0|\.bak|\.BAK|\.old|\.save)$")
#: The dictionary of boundaries in a field of OpenFOAM, up to its brace or to the end of a cut file.
BOUNDARY = re.compile(rb"(?s)boundaryField(?:\s|//[^\n]*|/\*.*?\*/)*(?:(\{)|\Z)")
#: Code, comments, texts, beginnings of lists, and braces of OpenFOAM's dictionaries.
FOAM_TOKENS = re.compile(
    rb'(?s)#\{.*?#\}|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"|List<(\w+)>\s*(\d+)\s*\(|[{}]'
)
#: Numbers in the values of lists.
COMPONENTS = {b"vector": 3, b"symmTensor": 6, b"tensor": 9}


def without_lost(
    source: Any, path: Path, time: float, warnings: list[str]
) -> tuple[Any, list[str]]:
    """The output of a reader without arrays that it could not read to their end, and words about each of them; the
    source itself unless it reads a legacy file with too few values. Removes its warnings about that. Raises
    RuntimeError if the mesh itself may lack values.
    """
    reason = next(filter(LOST.match, warnings), "").rstrip(".!")
    if source.GetXMLName() != "LegacyVTKFileReader" or not reason:
        return source, []
    warnings[:] = [warning for warning in warnings if not LOST.match(warning)]
    kept = {"POINT": list(source.PointData.keys()), "CELL": list(source.CellData.keys())}
    declared, kind = [], ""
    for section, attribute, field in HEADERS.findall(
        next(vtk_lists.files_with_cells(path, time), path).read_bytes()
    ):
        kind = section.decode().upper() or kind
        if kind and not section:
            declared.append((kind, unquote(os.fsdecode(attribute or field))))
    there = [entry for entry in declared if entry[1] in kept[entry[0]]]
    # VTK reads nothing after what lacks values, and keeps it with what its memory had: here the last array.
    if not there or there[-1][1] == vtkDataSetAttributes.GhostArrayName():
        raise RuntimeError(reason)
    kind, name = there[-1]
    kept[kind].remove(name)
    nothing = [""]  # of an empty list, all arrays would pass
    passed = simple.PassArrays(
        Input=source,
        PointDataArrays=kept["POINT"] or nothing,
        CellDataArrays=kept["CELL"] or nothing,
    )
    passed.UpdatePipeline(time)
    simple.Delete(source)  # the filter keeps it
    lost = [entry[1] for entry in declared if entry not in there] + [name]
    return passed, [f"the array {text.printable(name)} cannot be read ({reason})" for name in lost]


def empty_fields(fields: Collection[tuple[str, Path]]) -> list[str]:
    """Words about those of an OpenFOAM case's `fields` whose files a solver created and never wrote."""
    names = {name for name, file in fields if _is_empty(file)}
    return [
        f"the array {text.printable(name)} cannot be read (its file is empty)"
        for name in sorted(names)
    ]


def cut_fields(source: Any, fields: Collection[tuple[str, Path]]) -> list[str]:
    """Words about the arrays of an OpenFOAM case that its reader kept although their files, of `fields`, end within or
    before the values of the boundary: the cells have all values. Compressed files are not examined.
    """
    kept = {*source.CellArrays, *source.CellData.keys()} if fields else {}
    names = {name for name, file in fields if name in kept and _is_cut(file)}
    return [
        f"the file of the array {text.printable(name)} ends before the end of its boundaryField"
        for name in sorted(names)
    ]


def fields(source: Any, path: Path, time: float) -> Iterator[tuple[str, Path]]:
    """Names and files of the fields of a time step of an OpenFOAM case, those of all regions that are read; nothing for
    other formats."""
    if source.GetXMLName() != "OpenFOAMReader":
        return
    is_decomposed = "Decomposed" in str(source.CaseType)
    parts = path.parent.glob("processor[0-9]*") if is_decomposed else [path.parent]
    regions = {
        name.rpartition("/")[0].split("/")[1] for name in source.MeshRegions if name[0] == "/"
    }
    for step in (step for part in parts for step in _entries(part)):
        if _is_time(step.name, time):
            for folder in (step, *(step / region for region in regions)):
                for file in _entries(folder):
                    if not NO_FIELD.match(file.name):
                        yield file.name.removesuffix(".gz"), file


def _is_time(name: str, time: float) -> bool:
    try:
        return float(name) == time
    except ValueError:
        return False


def _entries(folder: Path) -> list[Path]:
    """What is in a folder; nothing if it cannot be read."""
    try:
        return list(folder.iterdir())
    except OSError:
        return []


def _is_empty(file: Path) -> bool:
    """Whether a file of a field begins with nothing but zero bytes and white space."""
    try:
        if not file.is_file():
            return False
        with open(file, "rb") as opened:
            return not opened.read(4096).strip(b"\0 \t\r\n")
    except OSError:
        return False


def _is_cut(file: Path) -> bool:
    """Whether the dictionary boundaryField of a field of cells is not there or not closed."""
    if file.suffix == ".gz":
        return False
    try:
        with open(file, "rb") as opened:
            head = opened.read(4096)
            if not re.search(rb"\bclass\s+vol\w+Field\s*;", head):
                return False
            data = mmap.mmap(opened.fileno(), 0, access=mmap.ACCESS_READ)
    except OSError:
        return False  # the reader says what is wrong
    begin = _boundary(data)
    if not begin or not begin[1]:
        return True
    is_binary = re.search(rb"\bformat\s+binary\s*;", head)
    at, depth = begin.end(), 1
    while token := FOAM_TOKENS.search(data, at):
        at = token.end()
        depth += (token[0] == b"{") - (token[0] == b"}")
        if is_binary and token[1]:
            count = int(token[2]) * COMPONENTS.get(token[1], 1)
            ends = [at + count * size for size in _sizes(token[1], head)]
            if min(ends) >= len(data):
                return True
            at = next((end for end in ends if data[end : end + 1] == b")"), at)
    return depth > 0


def _boundary(data: mmap.mmap) -> Optional[re.Match[bytes]]:
    """Where the dictionary boundaryField begins, searched from the end as the values before it may be many: not what
    code (`.boundaryField()`), macros (`$:boundaryField`) and lines of comments say of it."""
    at = len(data)
    while (at := data.rfind(b"boundaryField", 0, at)) >= 0:
        line = data[data.rfind(b"\n", 0, at) + 1 : at]
        found = BOUNDARY.match(data, at)
        if found and b"//" not in line and (not line or line[-1:] in b" \t;}"):
            return found
    return None


def _sizes(kind: bytes, head: bytes) -> list[int]:
    """How many bytes a number in binary lists of a type may have: as the header says, or else 8 or 4."""
    number = b"label" if kind == b"label" else b"scalar"
    bits = re.search(rb'\barch\s+"[^"]*\b' + number + rb"=(\d+)", head)
    return [int(bits[1]) // 8] if bits else [8, 4]
