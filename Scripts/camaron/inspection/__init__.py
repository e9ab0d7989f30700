# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads a mesh, evaluates its quality and writes a report."""

from __future__ import annotations

import csv
import datetime
import json
import os
import shutil
from pathlib import Path
from typing import Any, Callable, Iterable, Mapping, Optional

from paraview import servermanager, simple

from .. import checking, conversion
from ..checking import verdict_table
from ..common import assessment, mesh_facts, pipeline, tables, text
from ..common.evaluation import (
    ALL,
    NOT_REPORTED,
    Evaluation,
    choose_criteria,
    chosen_preset,
    evaluated_criteria,
    list_names,
    set_groups,
)
from ..common.files import Staging
from ..common.inputs import Inputs
from ..common.json_text import to_json
from ..common.stages import Progress, Stages
from . import pictures, report

#: Points of the cumulative curves, and the criterion that weights the cells.
CURVE_POINTS = 51
VOLUME = "Volume"


def inspect(
    mesh: os.PathLike | str | servermanager.Proxy,
    directory: Optional[os.PathLike | str] = None,
    *,
    preset: Optional[str] = None,
    criteria: Optional[Iterable[str]] = None,
    ranges: Optional[tables.Ranges] = None,
    rules: Optional[checking.Rules] = None,
    tolerate: Optional[str] = None,
    worst: int = 10,
    bins: int = 50,
    group_by: str = "type",
    time: str = "last",
    reader: Optional[Mapping[str, Any]] = None,
    strict: bool = False,
    with_pictures: bool = True,
    most_pictures: int = 3,
    with_mesh: bool = True,
    verbose: bool = False,
    say: Callable[[str], None] = lambda words: None,
    progress: Optional[Progress] = None,
    inputs: Optional[Inputs] = None,
) -> dict[str, Any]:
    """Evaluates the quality of a mesh; writes report.html, summary.json, worst.csv and the mesh.

    The mesh is any file that ParaView can open, or a source of the pipeline at the current time; if
    that is an Element Quality, the report is about its criteria unless others are given; it judges by its preset only if
    no criteria are given. `directory` is created if needed; by default it is
    NAME-report in the current folder. The criteria are those of the preset, or the given ones, or
    those of the preset General; of the latter, and of ["all"], only criteria that apply to the
    mesh. `ranges` is a file of acceptable ranges (Documentation/inspect.md) or a list of its lines, whose criteria are
    evaluated in addition to those of a preset. `rules` are a file of rules or a list of their lines (Documentation/check.md);
    the report then begins with the verdict on each, and `tolerate` is the tolerance of those that specify none. `worst` is the number of worst cells to list, `bins`
    the number of bins of the histograms. `group_by` divides the cells into groups with their own
    statistics: "type", "block", "none" or the name of a cell array. `time` is the time step:
    "first", "last" or its number; `reader` has options of the reader by name; with
    `strict`, arrays that cannot be read are an error instead of a note. `most_pictures` is the maximum number of pictures, at most 3; if
    `with_mesh` is false, the mesh with the arrays is not written. With `verbose`, the time of each
    stage is reported; `progress` shows the current stage and the remaining time. `say` is called
    with an estimate of the time if the evaluation takes long. `inputs` are other files that the
    report must not replace.

    Returns the contents of summary.json (Documentation/inspect.md). Raises ValueError for an
    unknown name, and RuntimeError for a file that cannot be read or written.

    >>> summary = camaron.inspect("part.visf", "report", criteria=["Volume", "MinDihedralAngle"])
    >>> summary["criteria"][1]["min"]
    12.7
    """
    if preset is not None and criteria is not None:
        raise ValueError("a preset and criteria exclude each other")
    criteria = list_names(criteria)
    for name, number, least in (
        ("worst", worst, 0),
        ("bins", bins, 1),
        ("most_pictures", most_pictures, 0),
    ):
        if not isinstance(number, int) or number < least:
            raise ValueError(f"{name}: expected a number of at least {least}, found {number!r}")
    if rules is None and tolerate is not None:
        raise ValueError("tolerate is for rules, but there are none")
    valid = None if rules is None else checking.read_rules(rules, None, tolerate)
    stage = Stages(say, verbose, progress)
    with stage("loading the plugin"):
        pipeline.load_plugin()
    if ranges is not None and not tables.is_file(ranges):
        ranges = list(ranges)
    limits = tables.known_ranges(ranges) if ranges is not None else {}
    with stage("reading"):
        keeps_criteria = preset is None and (criteria is None or _evaluates(mesh, criteria))
        inputs = inputs or Inputs()
        inputs.add(ranges if tables.is_file(ranges) else None)
        evaluated = Evaluation(mesh, time, keeps_criteria, inputs, reader, strict)
    with evaluated:
        opened, quality, mesh = evaluated.opened, evaluated.quality, evaluated.mesh
        directory = Path(f"{mesh.stem}-report") if directory is None else Path(directory)
        surface = evaluated.make(simple.MeshSurface, PassThroughShapes=1)
        statistics = evaluated.make(
            simple.QualityStatistics,
            NumberOfWorst=worst,
            NumberOfBins=bins,
            **tables.range_properties(ranges),
        )
        if evaluated.has_own_criteria:
            preset = chosen_preset(quality) if criteria is None else None
        else:
            preset = choose_criteria(quality, preset, criteria, limits)
        statistics.CurvePoints = CURVE_POINTS
        if VOLUME in evaluated_criteria(quality):
            statistics.WeightArray = VOLUME
        set_groups(statistics, group_by, opened)
        if preset:
            statistics.Preset = preset
        evaluated.announce(say)
        if progress:
            cells = pipeline.data_information(opened.source).GetNumberOfCells()
            progress.expect(evaluated.estimated_seconds(), cells, len(evaluated_criteria(quality)))
        with stage("evaluating"):
            evaluated.evaluate()
        with pipeline.Messages() as messages:
            with stage("statistics"):
                rows = tables.read(statistics, preset, ranges)
            with stage("boundary and totals"):
                described = mesh_facts.describe(mesh, evaluated, surface, statistics)
            if valid:
                with stage("rules"):
                    checks = checking.read_checks(checking.make_filter(evaluated, valid, worst))
        messages.refuse(mesh)
        if preset is None and (criteria is None or criteria == [ALL]):
            rows = [row for row in rows if row["applicable"] and row["name"] not in NOT_REPORTED]
        if group_by == "type":
            for group in (group for row in rows for group in row["groups"]):
                group["group"] = text.cell_type(group["group"])
        for row in rows:
            which = "higher_order_by_vertices" if row["is_curved"] else "higher_order"
            row["of_vertices"] = described[which]
        first = assessment.worst_criterion(rows)
        summary = {
            "version": 1,
            "generated": {
                "date": datetime.datetime.now().astimezone().isoformat(" ", "minutes"),
                "by": mesh_facts.program(),
            },
            "mesh": described,
            "preset": preset,
            "ranges": os.fspath(ranges) if tables.is_file(ranges) else ranges,
            "group_by": group_by,
            "verdict": checking.verdict_of(checks) if valid else None,
            "checks": checks if valid else None,
            "criteria": rows,
            "worst_criterion": first and first["name"],
            "notes": pipeline.once(
                opened.warnings,
                messages.warnings,
                mesh_facts.notes(opened),
                _notes_on_order(described, rows),
                verdict_table.notes_on(checks) if valid else [],
            ),
            "files": {},
        }
        if not with_pictures:
            most_pictures = 0
        if most_pictures and not pictures.can_render():
            most_pictures = 0
            summary["notes"].append("There are no pictures because there is no display.")
        with Staging(directory, inputs) as staging, pipeline.Messages():
            _write(summary, quality, surface, staging.path, most_pictures, with_mesh, stage)
            earlier = _earlier_mesh(directory)
            published = staging.names()
            staging.publish()
            for path, is_input in zip(earlier, inputs.replaced_by(*earlier)):
                if path.name not in published and not is_input:
                    shutil.rmtree(path) if path.is_dir() else path.unlink()
        return summary


def _evaluates(mesh: Any, criteria: list[str]) -> bool:
    """Whether these are the criteria of an Element Quality."""
    return (
        isinstance(mesh, servermanager.Proxy)
        and mesh.GetXMLName() == "ElementQuality"
        and set(criteria) == set(evaluated_criteria(mesh))
    )


def _earlier_mesh(directory: Path) -> list[Path]:
    """The mesh of an earlier report in the folder, and the folder with its pieces."""
    try:
        summary = json.loads((directory / "summary.json").read_text("utf-8"))
        name = Path(summary["files"]["mesh"])
    except (OSError, ValueError, KeyError, TypeError):
        return []
    if name.stem != "mesh" or name.name != str(name):
        return []
    return [path for path in (directory / name, directory / "mesh") if path.exists()]


def _notes_on_order(mesh, rows) -> list[str]:
    """Which criteria are those of the vertices of higher-order cells."""
    linear = [row["name"] for row in rows if not row["is_curved"]]
    curved = [row["name"] for row in rows if row["is_curved"]]
    notes = []
    if linear and mesh["higher_order"]:
        which = ", ".join(linear)
        if len(linear) > len(curved):
            which = "all criteria" + (f" except {', '.join(curved)}" if curved else "")
        cells = text.plural(mesh["higher_order"], "higher-order cell")
        notes.append(f"Evaluated only for the vertices of {cells}: {which}.")
    if curved and mesh["higher_order_by_vertices"]:
        cells = text.plural(mesh["higher_order_by_vertices"], "Lagrange or Bezier cell")
        notes.append(
            f"All criteria are evaluated only for the vertices of {cells}: pyramids, rational cells, "
            "or cells of a degree above 4."
        )
    return notes


def _write(summary, quality, surface, folder, most_pictures, with_mesh, stage) -> None:
    """Writes all files of the report to a folder."""
    summary["files"] = {"report": "report.html", "summary": "summary.json", "worst": "worst.csv"}
    if with_mesh:
        summary["files"]["mesh"] = "mesh" + mesh_facts.extension(quality)
    taken = (
        pictures.take(summary, quality, surface, folder, most_pictures, stage)
        if most_pictures
        else []
    )
    if with_mesh:  # before the report, which notes the data that the file cannot store
        with stage("writing the mesh"):
            _write_mesh(summary, quality, folder)
    with stage("writing the report"):
        _write_report(summary, taken, folder)


def _write_mesh(summary, quality, folder) -> None:
    # Every rank writes its own cells, without ghost cells.
    whole = pipeline.without_ghosts(quality) if pipeline.rank_count() > 1 else quality
    whole.UpdatePipeline()
    known = set(quality.GetProperty("Criteria").Available)
    shown = [c["name"] for c in summary["criteria"]]
    options = _arrays_to_write(whole, known, shown)
    target = folder / summary["files"]["mesh"]
    conversion.write(whole, target, options, Inputs(), summary["notes"])
    if whole is not quality:
        simple.Delete(whole)


def _write_report(summary, taken, folder) -> None:
    (folder / "report.html").write_text(report.render(summary, taken), encoding="utf-8")
    for picture in taken:
        picture.path.unlink()
    (folder / "summary.json").write_text(to_json(summary) + "\n", encoding="utf-8")
    with open(folder / "worst.csv", "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file)
        rows.writerow(
            [
                "criterion",
                "unit",
                "rank",
                "block",
                "cell",
                "type",
                "value",
                "x",
                "y",
                "z",
                "vertices",
            ]
        )
        for c in summary["criteria"]:
            for w in c["worst"]:
                place = [repr(x) for x in w["center"]]
                rows.writerow(
                    [
                        text.no_formula(c["name"]),
                        c["unit"],
                        w["rank"],
                        text.no_formula(w["block"]),
                        w["id"],
                        w["type"],
                        repr(w["value"]),
                        *place,
                        " ".join(map(str, w["vertices"])),
                    ]
                )


def _arrays_to_write(mesh, known, criteria) -> dict[str, Any]:
    """Options of a writer that omit the criteria that do not apply to the mesh."""
    names = [array.Name for array in mesh.CellData]
    left_out = [name for name in names if name in known and name not in criteria]
    return {"CellDataArrays": [name for name in names if name not in left_out]} if left_out else {}
