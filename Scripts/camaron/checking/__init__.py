# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks meshes against rules."""

from __future__ import annotations

import datetime
import os
import time as clock
from typing import Any, Callable, Iterable, Optional, Sequence, Union

from vtkmodules import vtkCommonDataModel

from ..common import mesh_facts, pipeline, tables
from ..common.evaluation import Evaluation
from . import failures
from . import rules as language
from .rules import Parser, Rule

PASS, WARN, FAIL, EMPTY, ERROR = "pass", "warn", "fail", "empty", "error"

#: A file of rules, or their lines, or what `read_rules` returns.
Rules = Union[os.PathLike, str, Iterable[str], Sequence[Rule]]


def check(
    mesh: os.PathLike | str,
    rules: Optional[Rules] = None,
    *,
    preset: Optional[str] = None,
    tolerate: Optional[str] = None,
    worst: int = 10,
    time: str = "last",
    say: Callable[[str], None] = lambda words: None,
) -> dict[str, Any]:
    """Checks a mesh against rules or the ranges of a preset; see Documentation/check.md for both.

    `mesh` is any file that ParaView can open; `rules` is the path of a file of rules, or a list of
    their lines; `tolerate` is the tolerance of rules that specify none, such as "0.1%" or "5"
    cells; `worst` is the maximum number of failing cells to list; `time` is the time step: "first",
    "last" or its number. `say` is called with an estimate of the time if the evaluation takes long.

    Returns the entry of the mesh in the output of `camaron check --json`. Raises ValueError for
    invalid rules, before the mesh is read, and RuntimeError if the mesh cannot be read, if a rule
    refers to a missing block or array, or if no rule has a cell to check.

    >>> result = camaron.check("part.visf", ["MinDihedralAngle >= 10 tolerate 0.1%", "Volume > 0"])
    >>> result["verdict"], result["checks"][0]["failing"]
    ('fail', 12)
    """
    parsed = read_rules(rules, preset, tolerate)
    started = clock.monotonic()
    with Evaluation(mesh, time) as evaluated:
        known = list(evaluated.quality.GetProperty("Criteria").Available)
        evaluated.quality.Criteria = failures.needed_criteria(parsed, known)
        evaluated.announce(say)
        evaluated.evaluate()
        with pipeline.Messages() as messages:
            try:
                counts = failures.count(evaluated, parsed, max(worst, 1))
            except failures.ScopeError as error:
                raise RuntimeError(f"{mesh}: {error}") from None
        messages.refuse(mesh)
        checks = [_judge(rule, found) for rule, found in zip(parsed, counts)]
        verdicts = {entry["verdict"] for entry in checks}
        if verdicts == {EMPTY}:
            raise RuntimeError(f"{mesh}: none of the rules has a cell to check")
        return {
            "mesh": str(mesh),
            "verdict": next((v for v in (FAIL, WARN) if v in verdicts), PASS),
            "time": evaluated.opened.time,
            "cells": max(found.total for found in counts),
            "checks": checks,
            "notes": pipeline.once(
                evaluated.opened.warnings, messages.warnings, mesh_facts.notes(evaluated.opened)
            ),
            "seconds": round(clock.monotonic() - started, 3),
        }


def failed_to_check(mesh: os.PathLike | str, reason: str) -> dict[str, Any]:
    """The entry of a mesh that could not be checked, with the keys of the others."""
    return {
        "mesh": str(mesh),
        "verdict": ERROR,
        "error": reason,
        "time": None,
        "cells": 0,
        "checks": [],
        "notes": [],
        "seconds": 0.0,
    }


def worst_verdict(results: Iterable[dict[str, Any]]) -> str:
    """The verdict on several meshes."""
    order = (PASS, WARN, FAIL, ERROR)
    return max((result["verdict"] for result in results), key=order.index, default=PASS)


def summary(
    results: Sequence[dict[str, Any]], rules: Optional[str], preset: Optional[str]
) -> dict[str, Any]:
    """What `camaron check --json` prints."""
    return {
        "version": 1,
        "generated": {
            "date": datetime.datetime.now().astimezone().isoformat(" ", "minutes"),
            "by": mesh_facts.program(),
        },
        "rules": rules,
        "preset": preset,
        "verdict": worst_verdict(results),
        "meshes": list(results),
    }


def read_rules(
    rules: Optional[Rules], preset: Optional[str] = None, tolerate: Optional[str] = None
) -> list[Rule]:
    """Parses rules in any form that `check` accepts; ValueError lists all of their problems."""
    if (rules is None) == (preset is None):
        raise ValueError("either rules or a preset is needed")
    tolerance = language.NONE if tolerate is None else language.tolerance(str(tolerate))
    if rules is not None and not isinstance(rules, (str, os.PathLike)):
        if not isinstance(rules, Iterable):
            raise ValueError(f"rules are the name of a file or a list of lines, not {rules!r}")
        rules = list(rules)
        if rules and all(isinstance(rule, Rule) for rule in rules):
            return rules
    pipeline.load_plugin()
    parser = Parser(tables.known_criteria(), tables.known_presets(), _cell_types(), tolerance)
    if preset is not None:
        return parser.preset(preset)
    return parser.read(rules) if isinstance(rules, (str, os.PathLike)) else parser.parse(rules)


def _cell_types() -> list[str]:
    """VTK's names of cell types without "vtk", as in the tables of statistics."""
    # Newer versions of VTK have the function in another class.
    owner = getattr(vtkCommonDataModel, "vtkCellTypeUtilities", vtkCommonDataModel.vtkCellTypes)
    numbers = range(vtkCommonDataModel.VTK_NUMBER_OF_CELL_TYPES)
    names = map(owner.GetClassNameFromTypeId, numbers)
    return [name.removeprefix("vtk") for name in names if name.startswith("vtk")]


def _judge(rule: Rule, found: failures.Counts) -> dict[str, Any]:
    """The verdict on one rule, as documented."""
    failing = found.below + found.above + (found.null if rule.null_fails else 0)
    passed = failing <= rule.tolerance.cells(found.checked)
    verdict = PASS if passed else WARN if rule.hint else FAIL
    scope = rule.scope
    return {
        "rule": str(rule),
        "criterion": rule.criterion,
        "scope": scope and {"kind": scope.kind, "value": scope.value, "array": scope.array or None},
        "range": [rule.low, rule.high],
        "closed": list(rule.closed),
        "range_text": rule.range_text(),
        "scope_text": str(scope or ""),
        "line": rule.line,
        "preset": rule.preset,
        "null_fails": rule.null_fails,
        "hint": rule.hint,
        "cells": found.cells,
        "checked": found.checked,
        "failing": failing,
        "share": failing / found.checked if found.checked else None,
        "below": found.below,
        "above": found.above,
        "null": found.null,
        "infinite": found.infinite,
        "tolerance": str(rule.tolerance),
        "tolerated": rule.tolerance.cells(found.checked),
        "verdict": verdict if found.checked else EMPTY,
        "worst_value": _worst_value(rule, found),
        "worst": found.offenders,
    }


def _worst_value(rule: Rule, found: failures.Counts) -> Optional[float]:
    """The value farthest outside the range, else the value nearest to a limit; None without
    values."""
    outside = [o["value"] for o in found.offenders if o["value"] is not None]
    if outside or found.min is None:
        return outside[0] if outside else None
    low, high = rule.low, rule.high
    if low is None or high is None:
        return found.max if low is None else found.min
    return found.min if found.min - low <= high - found.max else found.max
