# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays that readers of ParaView lose without an error: of legacy VTK files (.vtk) with too few values, of which they
only warn, and of OpenFOAM cases with empty files."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from paraview import simple

from . import text

#: Warnings of VTK's readers of legacy files about values that are not there.
LOST = re.compile(r"^Error reading (ascii|binary) data")
VERSION = re.compile(rb"# vtk DataFile Version (\d+)")
CELLS = re.compile(rb"(?m)^(?:CELLS|VERTICES|LINES|POLYGONS|TRIANGLE_STRIPS)\s+(\d+)\s+\d+\s*$")
POINTS = re.compile(rb"(?m)^POINTS\s+(\d+)\s+\w+\s*$")
#: Starts of the data of points and cells, and of arrays.
HEADERS = re.compile(
    rb"(?m)^(POINT|CELL)_DATA\s+\d+\s*$"
    rb"|^(?:(?:COLOR_)?SCALARS|VECTORS|NORMALS|TENSORS6?|TEXTURE_COORDINATES|GLOBAL_IDS|PEDIGREE_IDS)\s+(\S+).*$"
    rb"|^(\S+)\s+\d+\s+\d+\s+(?:bit|string|float|double|vtk\w+|(?:unsigned_|signed_)?(?:char|short|int|long|long_long))\s*$"
)


def without_lost(source: Any, path: Path, warnings: list[str]) -> tuple[Any, list[str]]:
    """The output of a reader without arrays that it could not read to their end, and words about each of them; the
    source itself unless it reads a legacy file with too few values. Removes its warnings about that. Raises
    RuntimeError if points or cells are lost, too.
    """
    reason = next(filter(LOST.match, warnings), "").rstrip(".!")
    if source.GetXMLName() != "LegacyVTKFileReader" or not reason:
        return source, []
    warnings[:] = [warning for warning in warnings if not LOST.match(warning)]
    data = Path(path).read_bytes()
    _check_sizes(source, data, reason)
    kept = {"POINT": list(source.PointData.keys()), "CELL": list(source.CellData.keys())}
    declared, kind = [], ""
    for section, attribute, field in HEADERS.findall(data):
        kind = section.decode() or kind
        if kind and not section:
            declared.append((kind, (attribute or field).decode(errors="replace")))
    there = [entry for entry in declared if entry[1] in kept[entry[0]]]
    # VTK reads nothing after the array that lacks values, and keeps that one with what its memory had.
    lost = [entry for entry in declared if entry not in there] + there[-1:]
    for kind, name in there[-1:]:
        kept[kind].remove(name)
    nothing = [""]  # of an empty list, all arrays would pass
    passed = simple.PassArrays(
        Input=source,
        PointDataArrays=kept["POINT"] or nothing,
        CellDataArrays=kept["CELL"] or nothing,
    )
    passed.UpdatePipeline()
    words = [f"the array {text.printable(name)} cannot be read ({reason})" for _, name in lost]
    return passed, words or [f"a part of the file cannot be read ({reason})"]


def empty_fields(source: Any, path: Path, time: float) -> list[str]:
    """Words about the files of a time step of an OpenFOAM case that a solver created and never wrote."""
    if source.GetXMLName() != "OpenFOAMReader":
        return []
    names = set()
    for part in (path.parent, *path.parent.glob("processor[0-9]*")):
        for step in part.iterdir():
            if step.is_dir() and _is_time(step.name, time):
                names |= {file.name for file in step.iterdir() if _is_empty(file)}
    return [
        f"the array {text.printable(name)} cannot be read (its file is empty)"
        for name in sorted(names)
    ]


def _is_time(name: str, time: float) -> bool:
    try:
        return float(name) == time
    except ValueError:
        return False


def _is_empty(file: Path) -> bool:
    """Whether a file begins with nothing but zero bytes and white space."""
    if not file.is_file():
        return False
    with open(file, "rb") as opened:
        return not opened.read(4096).strip(b"\0 \t\r\n")


def _check_sizes(source: Any, data: bytes, reason: str) -> None:
    """Raises RuntimeError if an output does not have all points and cells of the file."""
    version = VERSION.match(data)
    cells = [int(number) for number in CELLS.findall(data)]
    starts = len(cells) if version and int(version[1]) >= 5 else 0  # lists of starts have one more
    information = source.GetDataInformation()
    for noun, expected, found in (
        (
            "points",
            sum(int(number) for number in POINTS.findall(data)),
            information.GetNumberOfPoints(),
        ),
        ("cells", sum(cells) - starts, information.GetNumberOfCells()),
    ):
        if expected and found != expected:
            raise RuntimeError(f"expected {expected} {noun}, found {found} ({reason})")
