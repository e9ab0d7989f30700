# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of Criteria Table and Quality Statistics as Python dictionaries and lists."""

from __future__ import annotations

import math
import os
from typing import Any, Iterable, Optional, Union

from paraview import servermanager, simple

from . import pipeline, text

QUANTILES = (0, 1, 5, 25, 50, 75, 95, 99, 100)
#: Acceptable ranges of the user: a file, or its lines.
Ranges = Union[os.PathLike, str, Iterable[str]]
#: Source of ranges in lines.
BY_USER = "set by the user"


def fetch(source: Any, port: int = 0) -> list[dict[str, Any]]:
    """The rows of a table as dictionaries."""
    table = servermanager.Fetch(source, idx=port)
    columns = [table.GetColumn(c) for c in range(table.GetNumberOfColumns())]
    names = [column.GetName() for column in columns]
    return [
        {name: column.GetValue(r) for name, column in zip(names, columns)}
        for r in range(table.GetNumberOfRows())
    ]


def known_criteria() -> dict[str, dict[str, Any]]:
    """The entries of all criteria in the registry, by name, in its order."""
    table = simple.CriteriaTable()
    try:
        return {
            row["Name"]: {
                "name": row["Name"],
                "label": row["Label"],
                "description": row["Description"],
                "unit": row["Unit"],
                "applies_to": row["AppliesTo"],
                "range": [_finite(row["RangeLow"]), _finite(row["RangeHigh"])],
                "ideal": _finite(row["Ideal"]),
                "better": row["Better"].lower(),
                "acceptable": [_finite(row["AcceptableLow"]), _finite(row["AcceptableHigh"])],
                "acceptable_source": row["AcceptableSource"],
                "acceptable_is_hint": bool(row["AcceptableIsHint"]),
                "acceptable_for": row["AcceptableFor"],
                "is_curved": bool(row["IsCurved"]),
                "consequence": row["Consequence"],
                "is_validity": _is_validity(row),
                "summable": row["Dimension"] in ("Area", "Volume"),
            }
            for row in fetch(table, 0)
        }
    finally:
        simple.Delete(table)


def _is_validity(row: dict[str, Any]) -> bool:
    """Whether cells outside of the acceptable range are invalid."""
    return row["Family"] == "Validity" or 0.0 < row["AcceptableLow"] < text.SMALLEST


def known_notes() -> dict[str, dict[str, str]]:
    """Documentation of every criterion: family, formula, degenerate, curved, agreement."""
    table = simple.CriteriaTable()
    try:
        keys = ("Family", "Formula", "Degenerate", "Curved", "Agreement")
        return {row["Name"]: {key.lower(): row[key] for key in keys} for row in fetch(table, 0)}
    finally:
        simple.Delete(table)


def known_presets() -> dict[str, dict[str, Any]]:
    """Description of every preset, its rules: acceptable [low, high] by the criterion's name, its
    hints: names of criteria whose range is a hint only, and its shapes: the cells that a range is
    for.
    """
    table = simple.CriteriaTable()
    try:
        presets: dict[str, dict[str, Any]] = {}
        for row in fetch(table, 1):
            preset = presets.setdefault(
                row["Preset"],
                {"description": row["Description"], "rules": {}, "hints": [], "shapes": {}},
            )
            limits = [_finite(row["AcceptableLow"]), _finite(row["AcceptableHigh"])]
            preset["rules"][row["Criterion"]] = limits
            presets[row["Preset"]]["shapes"][row["Criterion"]] = row["AcceptableFor"]
            if row["AcceptableIsHint"]:
                preset["hints"].append(row["Criterion"])
        return presets
    finally:
        simple.Delete(table)


def is_file(ranges: Optional[Ranges]) -> bool:
    """Whether ranges are the name of a file."""
    return isinstance(ranges, (str, os.PathLike))


def range_properties(ranges: Optional[Ranges]) -> dict[str, str]:
    """Ranges as properties of Quality Statistics and Criteria Table."""
    if ranges is None:
        return {}
    return {"RangesFile": str(ranges)} if is_file(ranges) else {"Ranges": "\n".join(ranges)}


def known_ranges(ranges: Ranges) -> dict[str, list[Optional[float]]]:
    """Acceptable [low, high] by the criterion's name from ranges of the user.

    RuntimeError has the file and line of an error.
    """
    table = simple.CriteriaTable(**range_properties(ranges))
    try:
        with pipeline.Messages() as messages:
            rows = fetch(table, 2)
        if messages.errors:
            raise RuntimeError(messages.errors[0].rstrip("."))
        return {
            row["Criterion"]: [_finite(row["AcceptableLow"]), _finite(row["AcceptableHigh"])]
            for row in rows
        }
    finally:
        simple.Delete(table)


def range_sources(preset: Optional[str], ranges: Optional[Ranges]) -> dict[str, dict[str, Any]]:
    """Entries of `known_criteria` about ranges that do not come from the table of criteria."""
    sources = {}
    if preset:
        described = known_presets()[preset]
        for name in described["rules"]:
            sources[name] = {
                "acceptable_source": described["description"],
                "acceptable_is_hint": name in described["hints"],
                "acceptable_for": described["shapes"][name],
            }
    if ranges:
        source = os.path.basename(ranges) if is_file(ranges) else BY_USER
        own = {"acceptable_source": source, "acceptable_is_hint": False}
        sources.update(dict.fromkeys(known_ranges(ranges), {**own, "acceptable_for": "any cell"}))
    return sources


def _finite(value: float) -> Optional[float]:
    """The number, or None for NaN and infinite numbers, which mean unknown or no limit."""
    return float(value) if math.isfinite(value) else None


def _number(value: float) -> Optional[float]:
    """The number, or None for NaN."""
    return None if math.isnan(value) else float(value)


def read(
    statistics: Any, preset: Optional[str] = None, ranges: Optional[Ranges] = None
) -> list[dict[str, Any]]:
    """All tables of Quality Statistics, which judges by the preset and the ranges, as one dictionary
    per criterion, in the order of the registry."""
    known = known_criteria()
    sources = range_sources(preset, ranges)
    criteria = {}
    for row in fetch(statistics, 0):
        if row["Criterion"] not in known:
            continue
        if row["Group"] == "All":
            criteria[row["Criterion"]] = _criterion(row, known[row["Criterion"]], sources)
        else:
            criteria[row["Criterion"]]["groups"].append(_group(row))
    for row in _of_all(statistics, 1):
        histogram = criteria[row["Criterion"]]["histogram"]
        histogram["underflow"], histogram["overflow"] = row["Underflow"], row["Overflow"]
        if row["Bin"] < 0:
            continue  # there are no bins
        if row["Bin"] == 0:
            histogram["edges"].append(row["LowerEdge"])
        histogram["edges"].append(row["UpperEdge"])
        histogram["counts"].append(row["Count"])
    for row in _of_all(statistics, 2):
        criteria[row["Criterion"]]["worst"].append(
            {
                "rank": row["Rank"],
                "id": row["Id"],
                "block": row["Block"] or None,
                "type": text.cell_type(row["CellType"], 1),
                "value": row["Value"],
                "center": [row["X"], row["Y"], row["Z"]],
                "vertices": [int(point) for point in row["Vertices"].split()],
            }
        )
    for row in _of_all(statistics, 3):
        curve = criteria[row["Criterion"]]["curve"]
        curve["values"].append(row["Value"])
        curve["percent"].append(row["Percent"])
        if (share := _number(row.get("WeightPercent", math.nan))) is not None:
            curve["weight_percent"].append(share)
    return [criteria[name] for name in known if name in criteria]


def _of_all(statistics: Any, port: int) -> list[dict[str, Any]]:
    """The rows of the group of all cells."""
    return [row for row in fetch(statistics, port) if row["Group"] == "All"]


def _group(row: dict[str, Any]) -> dict[str, Any]:
    """The entry of a group from its row."""
    return {
        "group": row["Group"],
        "count": row["Count"],
        "applicable": row["ApplicableCount"],
        "undefined": row["UndefinedCount"],
        "infinite": row["InfiniteCount"],
        "min": _number(row["Min"]),
        "median": _number(row["P50"]),
        "mean": _number(row["Mean"]),
        "max": _number(row["Max"]),
        "judged": row["JudgedCount"],
        "out_of_range": row["BelowCount"] + row["AboveCount"],
    }


def _criterion(
    row: dict[str, Any], known: dict[str, Any], sources: dict[str, dict[str, Any]]
) -> dict[str, Any]:
    """A row of the statistics, joined with the entry of the registry."""
    known = {**known, **sources.get(known["name"], {})}
    limits = [_finite(row["AcceptableLow"]), _finite(row["AcceptableHigh"])]
    return {
        **known,
        "unit": row["Unit"],
        "acceptable": limits,
        "acceptable_source": known["acceptable_source"] if limits != [None, None] else "",
        "count": row["Count"],
        "applicable": row["ApplicableCount"],
        "undefined": row["UndefinedCount"],
        "infinite": row["InfiniteCount"],
        "min": _number(row["Min"]),
        "max": _number(row["Max"]),
        "mean": _number(row["Mean"]),
        "std_dev": _number(row["StdDev"]),
        "sum": _number(row["Sum"]),
        "quantiles": {
            f"{q}": value for q in QUANTILES if (value := _number(row[f"P{q}"])) is not None
        },
        "judged": row["JudgedCount"],
        "below": row["BelowCount"],
        "above": row["AboveCount"],
        "out_of_range": row["BelowCount"] + row["AboveCount"],
        "histogram": {
            "edges": [],
            "counts": [],
            "underflow": 0,
            "overflow": 0,
            "undefined": row["UndefinedCount"],
            "infinite": row["InfiniteCount"],
        },
        "worst": [],
        "groups": [],
        "curve": {"values": [], "percent": [], "weight_percent": []},
    }
