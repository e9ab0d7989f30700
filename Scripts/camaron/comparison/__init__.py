# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the quality of two meshes."""

from __future__ import annotations

import datetime
import math
import os
from pathlib import Path
from typing import Any, Callable, Iterable, Mapping, Optional

from paraview import simple

from ..common import mesh_facts, pipeline, tables, text
from ..common.evaluation import (
    ALL,
    NOT_REPORTED,
    Evaluation,
    choose_criteria,
    list_names,
    set_groups,
)
from ..common.files import Staging
from ..common.formats import UnknownOption
from ..common.inputs import Inputs
from ..common.json_text import to_json
from . import comparison_report

#: Label of the group of all cells.
WHOLE = "All"
#: Columns of Compare Quality for each of the meshes, by their keys in summary.json.
OF_BOTH = {
    "count": "Count",
    "undefined": "UndefinedCount",
    "infinite": "InfiniteCount",
    "min": "Min",
    "p1": "P1",
    "p5": "P5",
    "median": "P50",
    "p95": "P95",
    "p99": "P99",
    "max": "Max",
    "mean": "Mean",
    "std_dev": "StdDev",
    "judged": "JudgedCount",
    "out_of_range": "OutOfRangeCount",
    "out_of_range_percent": "OutOfRangePercent",
}


def compare(
    a: os.PathLike | str,
    b: os.PathLike | str,
    directory: Optional[os.PathLike | str] = None,
    *,
    preset: Optional[str] = None,
    criteria: Optional[Iterable[str]] = None,
    ranges: Optional[os.PathLike | str] = None,
    bins: int = 50,
    group_by: str = "none",
    time: str = "last",
    reader: Optional[Mapping[str, Any]] = None,
    strict: bool = False,
    say: Callable[[str], None] = lambda words: None,
) -> dict[str, Any]:
    """Compares the quality of two meshes; writes report.html and summary.json.

    The meshes are any files that ParaView can open; A is the mesh before a change, B the mesh after
    it. `directory` is created if needed; by default it is A-B-comparison in the current folder,
    with the names of the meshes. The other arguments are those of `inspect`; by default there are
    no groups.

    Returns the contents of summary.json (Documentation/compare.md). Raises ValueError for an
    unknown name, and RuntimeError for a file that cannot be read or written.

    >>> summary = camaron.compare("before.visf", "after.visf", criteria=["MinDihedralAngle"])
    >>> summary["criteria"][0]["improved"], summary["criteria"][0]["worsened"]
    (1204, 31)
    """
    paths = [Path(a), Path(b)]
    if directory is None:
        directory = "-".join([*(path.stem for path in paths), "comparison"])
    directory = Path(directory)
    if preset is not None and criteria is not None:
        raise ValueError("a preset and criteria exclude each other")
    criteria = list_names(criteria)
    pipeline.load_plugin()
    limits = tables.known_ranges(ranges) if ranges is not None else {}
    inputs = Inputs(*paths, ranges)
    # The meshes may have different readers, one of which knows an option.
    unknown: list[dict[str, UnknownOption]] = [{}, {}]
    with Evaluation(
        paths[0], time, inputs=inputs, reader=reader, strict=strict, unknown=unknown[0]
    ) as first, Evaluation(
        paths[1], time, inputs=inputs, reader=reader, strict=strict, unknown=unknown[1]
    ) as second:
        for name, error in unknown[0].items():
            if name in unknown[1]:
                raise UnknownOption(f"{paths[0]}: {error}")
        meshes = [first, second]
        surfaces = [mesh.make(simple.MeshSurface) for mesh in meshes]
        for mesh in meshes:
            chosen = choose_criteria(mesh.quality, preset, criteria, limits)
            mesh.announce(lambda words, name=mesh.mesh: say(f"{name}: {words}"))
        comparison = first.make(simple.CompareQuality, Other=second.quality, NumberOfBins=bins)
        if chosen:
            comparison.Preset = chosen
        if ranges is not None:
            comparison.RangesFile = str(ranges)
        set_groups(comparison, group_by, first.opened, second.opened)
        for mesh in meshes:
            mesh.evaluate()
        with pipeline.Messages() as messages:
            rows = _read(comparison, chosen, ranges)
            described = [
                mesh_facts.describe(path, mesh, surface)
                for path, mesh, surface in zip(paths, meshes, surfaces)
            ]
        messages.refuse(f"{a}, {b}")
        if chosen is None and (criteria is None or criteria == [ALL]):
            rows = [row for row in rows if _has_values(row) and row["name"] not in NOT_REPORTED]
        if group_by == "type":
            for group in (group for row in rows for group in row["groups"]):
                group["group"] = text.cell_type(group["group"])
        notes = messages.warnings
        for path, mesh in zip(paths, meshes):
            more = mesh.opened.warnings + mesh_facts.notes(mesh.opened)
            notes = notes + [f"{path.name}: {note}" for note in more]
        summary = {
            "version": 1,
            "generated": {
                "date": datetime.datetime.now().astimezone().isoformat(" ", "minutes"),
                "by": mesh_facts.program(),
            },
            "a": described[0],
            "b": described[1],
            "preset": chosen,
            "ranges": None if ranges is None else str(ranges),
            "group_by": group_by,
            "same_cells": any(row["same_cells"] for row in rows),
            "worse": [row["name"] for row in rows if is_worse(row)],
            "criteria": rows,
            "notes": notes,
            "files": {"report": "report.html", "summary": "summary.json"},
        }
        _write(summary, directory, inputs)
        return summary


def is_worse(row: dict[str, Any]) -> bool:
    """Whether B has a larger percentage of cells outside of the acceptable range."""
    a, b = row["a"]["out_of_range_percent"], row["b"]["out_of_range_percent"]
    return a is not None and b is not None and b > a


def _has_values(row: dict[str, Any]) -> bool:
    return any(row[mesh]["count"] > row[mesh]["undefined"] for mesh in "ab")


def _write(summary: dict[str, Any], directory: Path, inputs: Inputs) -> None:
    with Staging(directory, inputs) as staging:
        page = comparison_report.render(summary)
        (staging.path / "report.html").write_text(page, encoding="utf-8")
        (staging.path / "summary.json").write_text(to_json(summary) + "\n", encoding="utf-8")
        staging.publish()


def _number(value: Any) -> Any:
    return None if isinstance(value, float) and math.isnan(value) else value


def _finite(value: float) -> Optional[float]:
    return value if math.isfinite(value) else None


def _numbers(row: dict[str, Any]) -> dict[str, Any]:
    """The numbers of both meshes, for all cells or for a group."""
    return {
        **{
            mesh: {key: _number(row[column + mesh.upper()]) for key, column in OF_BOTH.items()}
            for mesh in "ab"
        },
        "distance": _number(row["Distance"]),
        "distance_value": _number(row["DistanceValue"]),
        "same_cells": bool(row["SameCells"]),
        "compared": row["ComparedCount"],
        "improved": row["ImprovedCount"],
        "worsened": row["WorsenedCount"],
        "unchanged": row["UnchangedCount"],
    }


def _read(comparison: Any, preset: Optional[str], ranges: Any) -> list[dict[str, Any]]:
    """The tables of Compare Quality as one dictionary per criterion."""
    known = tables.known_criteria()
    sources = tables.range_sources(preset, ranges)
    criteria: dict[str, dict[str, Any]] = {}
    for row in tables.fetch(comparison):
        if row["Group"] != WHOLE:
            criteria[row["Criterion"]]["groups"].append({"group": row["Group"], **_numbers(row)})
            continue
        about = {**known[row["Criterion"]], **sources.get(row["Criterion"], {})}
        numbers = _numbers(row)
        limits = [_finite(row["AcceptableLow"]), _finite(row["AcceptableHigh"])]
        criteria[row["Criterion"]] = {
            **{key: about[key] for key in ("name", "label", "description", "better", "ideal")},
            "unit": row["Unit"],
            "acceptable": limits,
            "acceptable_source": about["acceptable_source"] if limits != [None, None] else "",
            **numbers,
            "histogram": {"edges": [], "a": [], "b": []},
            "groups": [],
        }
    for row in tables.fetch(comparison, 1):
        if row["Group"] != WHOLE:
            continue
        histogram = criteria[row["Criterion"]]["histogram"]
        if row["Bin"] == 0:
            histogram["edges"].append(row["LowerEdge"])
        histogram["edges"].append(row["UpperEdge"])
        for mesh in "ab":
            histogram[mesh].append(_number(row["Fraction" + mesh.upper()]) or 0.0)
    return [criteria[name] for name in known if name in criteria]
