# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes lists of selected elements: ids, tables, OpenFOAM's sets."""

from __future__ import annotations

import csv
import io
import os
from pathlib import Path
from typing import Any

from paraview import servermanager, simple

from .common import pipeline
from .common.files import Staging
from .common.inputs import Inputs
from .common.text import no_formula

#: Folder of OpenFOAM's sets: constant/polyMesh/sets/NAME.
SETS = "sets"

FOAM_SET = """\
FoamFile
{{
    version     2.0;
    format      ascii;
    class       {kind};
    location    "constant/polyMesh/sets";
    object      {name};
}}

{count}
(
{ids}
)
"""


def is_list(path: os.PathLike | str) -> bool:
    """Whether `write_list` accepts the name: .csv, .txt, or no extension in a folder named
    "sets"."""
    path = Path(path)
    return path.suffix.lower() in (".csv", ".txt") or _is_set(path)


def _is_set(path: Path) -> bool:
    return not path.suffix and path.resolve().parent.name == SETS


def write_list(select: Any, path: os.PathLike | str) -> int:
    """Writes the elements selected by a SelectElements filter, sorted by id, and returns their
    number.

    A .csv file contains the table of SelectionTable. A .txt file contains one id per line: global
    ids if all elements have one, else indices. A name without an extension in a folder named "sets"
    becomes OpenFOAM's cellSet or pointSet of the indices, which are OpenFOAM's labels if the mesh
    has OpenFOAM's order of cells and points, as from OpenFOAMReader without decomposed polyhedra.

    Raises ValueError for other names, for files from which the mesh was read, and for a set of
    elements of several blocks.
    """
    path = Path(path)
    if not is_list(path):
        raise ValueError(
            f"{path}: expected a name that ends in .csv or .txt, or a set in a folder named 'sets'"
        )
    table = simple.SelectionTable(Input=select)
    try:
        rows = sorted(_rows(table), key=lambda row: row["Id"])
    finally:
        simple.Delete(table)
    if _is_set(path) and pipeline.is_composite(select):
        _check_block(path, rows, _block_sizes(select))
    with Staging(path.parent, Inputs(select)) as staging:
        (staging.path / path.name).write_text(
            _content(select, rows, path), encoding="utf-8", newline=""
        )
        staging.publish()
    return len(rows)


#: Ends of the labels of cells that a cellSet of OpenFOAM cannot have: of "TriangleStrip", "BiquadraticQuad", ...
FLAT = ("Vertex", "Line", "Edge", "Curve", "Triangle", "Strip", "Polygon", "Pixel", "Quad")
FLAT += ("Quadrilateral",)


def _check_block(path: Path, rows: list[dict[str, Any]], sizes: list[tuple[int, int]]) -> None:
    """Raises ValueError if the elements are not of one block, or, where several blocks have some, are those of a
    boundary, or not of the first, where ids begin. `sizes`: numbers of cells and points of all blocks.
    """
    blocks = list(dict.fromkeys(row["Block"] for row in rows))
    if len(blocks) > 1:
        listed = ", ".join(blocks)
        raise ValueError(f"{path}: a set contains elements of one block, these are of {listed}")
    is_of_points = bool(rows) and rows[0]["CellType"] == "Point"
    counts = [size[is_of_points] for size in sizes if size[is_of_points] > 0]
    if len(counts) < 2 or not rows:
        return
    if any(row["CellType"].endswith(FLAT) for row in rows):
        raise ValueError(f"{path}: a set contains cells of the volume, these are of {blocks[0]}")
    if rows[-1]["Id"] >= counts[0]:
        raise ValueError(
            f"{path}: a set contains elements of the first mesh, these are of {blocks[0]}"
        )


def _block_sizes(source: Any) -> list[tuple[int, int]]:
    """Numbers of cells and points of each block."""
    hierarchy = pipeline.data_information(source).GetHierarchy()
    leaves = [n for n in hierarchy.GetChildNodes(0, True) if not hierarchy.GetNumberOfChildren(n)]
    ids = [hierarchy.GetAttributeOrDefault(leaf, "cid", 0) for leaf in leaves]
    parts = [source.SMProxy.GetSubsetDataInformation(0, i) for i in ids]
    return [(part.GetNumberOfCells(), part.GetNumberOfPoints()) for part in parts]


def _rows(table: Any) -> list[dict[str, Any]]:
    """The rows of all processes; each component of an array has a column."""
    rows = []
    for rank in range(servermanager.ActiveConnection.GetNumberOfDataPartitions()):
        part = servermanager.Fetch(table, rank)
        columns = {}
        for c in range(part.GetNumberOfColumns()):
            column = part.GetColumn(c)
            size = column.GetNumberOfComponents()
            for k in range(size):
                name = column.GetName() if size == 1 else f"{column.GetName()}:{k}"
                columns[name] = [
                    column.GetValue(i * size + k) for i in range(part.GetNumberOfRows())
                ]
        rows += [dict(zip(columns, values)) for values in zip(*columns.values())]
    return rows


def _content(select: Any, rows: list[dict[str, Any]], path: Path) -> str:
    if path.suffix.lower() == ".csv":
        return _csv(rows)
    ids = [str(row["Id"]) for row in rows]
    if not _is_set(path):
        return "".join(f"{i}\n" for i in ids)
    kind = "pointSet" if select.GetProperty("ElementType").GetData() == "Points" else "cellSet"
    return FOAM_SET.format(kind=kind, name=path.name, count=len(ids), ids="\n".join(ids))


def _csv(rows: list[dict[str, Any]]) -> str:
    """The table as CSV, with all digits of numbers."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    header = list(rows[0]) if rows else ["Id", "Block", "CellType", "X", "Y", "Z"]
    writer.writerow(map(no_formula, header))
    writer.writerows([no_formula(row[name]) for name in header] for row in rows)
    return stream.getvalue()
