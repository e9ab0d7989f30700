# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks meshes against rules."""

from __future__ import annotations

import datetime
import math
import os
import re
import time as clock
from dataclasses import dataclass
from typing import Any, Callable, Iterable, Mapping, Optional, Sequence, Union

from paraview import servermanager, simple

from ..common import mesh_facts, pipeline, tables, text
from ..common.evaluation import Evaluation
from ..common.inputs import Inputs

PASS, WARN, FAIL, EMPTY, ERROR = "pass", "warn", "fail", "empty", "error"

#: Properties of Element Quality, Check Quality and Select Elements: how criteria are evaluated.
OPTIONS = (
    "TrustFaceOrientation",
    "DegeneracyTolerance",
    "ConvexityTolerance",
    "PlanarityTolerance",
    "ConnectBlocks",
)


class RulesError(ValueError):
    """All problems of rules; the text has one line per problem."""

    def __init__(self, problems: Sequence[str]):
        super().__init__("\n".join(problems))
        self.problems = list(problems)


@dataclass(frozen=True)
class ValidRules:
    """Rules without problems, as properties of Check Quality, and the name of their preset."""

    properties: dict[str, str | list[str]]
    preset: Optional[str]


#: A file of rules, or their lines, or what `read_rules` returns.
Rules = Union[os.PathLike, str, Iterable[str], ValidRules]


def check(
    mesh: os.PathLike | str,
    rules: Optional[Rules] = None,
    *,
    preset: Optional[str] = None,
    tolerate: Optional[str] = None,
    worst: int = 10,
    time: str = "last",
    reader: Optional[Mapping[str, Any]] = None,
    strict: bool = False,
    say: Callable[[str], None] = lambda words: None,
    inputs: Optional[Inputs] = None,
) -> dict[str, Any]:
    """Checks a mesh against rules and the ranges of a preset; see Documentation/check.md for both.

    `mesh` is any file that ParaView can open; `rules` is the path of a file of rules, or a list of
    their lines; `tolerate` is the tolerance of rules that specify none, such as "0.1%" or "5"
    cells; `worst` is the maximum number of failing cells to list; `time` is the time step: "first",
    "last" or its number; `reader` has options of the reader by name; with
    `strict`, arrays that cannot be read are an error instead of a note. `say` is called with an estimate of the time if the evaluation takes long; the files of the
    mesh are added to `inputs`.

    Returns the entry of the mesh in the output of `camaron check --json`. Raises ValueError for
    invalid rules, before the mesh is read, and RuntimeError if the mesh cannot be read, if a rule
    refers to a missing block or array, or if no rule has a cell to check.

    >>> result = camaron.check("part.visf", ["MinDihedralAngle >= 10 tolerate 0.1%", "Volume > 0"])
    >>> result["verdict"], result["checks"][0]["failing"]
    ('fail', 12)
    """
    valid = read_rules(rules, preset, tolerate)
    started = clock.monotonic()
    with Evaluation(mesh, time, inputs=inputs, reader=reader, strict=strict) as evaluated:
        checked = make_filter(evaluated, valid, worst)
        evaluated.announce(say, checked)
        with pipeline.Messages() as messages:
            checks = read_checks(checked)
            rows = tables.fetch(checked)
        messages.refuse(mesh)
        verdict = verdict_of(checks)
        if verdict == EMPTY:
            raise RuntimeError(f"{mesh}: none of the rules has a cell to check")
        return {
            "mesh": str(mesh),
            "verdict": verdict,
            "time": evaluated.opened.time,
            "cells": rows[0]["Total"],
            "checks": checks,
            "notes": pipeline.once(
                evaluated.opened.warnings, messages.warnings, mesh_facts.notes(evaluated.opened)
            ),
            "seconds": round(clock.monotonic() - started, 3),
        }


def make_filter(evaluated: Evaluation, rules: ValidRules, worst: int) -> servermanager.Proxy:
    """Check Quality for the rules, which lists up to `worst` failing cells of each. It evaluates criteria as the Element
    Quality does."""
    source, quality = evaluated.opened.source, evaluated.quality
    options = {name: quality.GetPropertyValue(name) for name in OPTIONS}
    return evaluated.make_of(
        source, simple.CheckQuality, NumberOfWorst=worst, **options, **rules.properties
    )


def read_checks(filter_: servermanager.Proxy) -> list[dict[str, Any]]:
    """The results of Check Quality, one for each rule, as in the output of `camaron check --json`."""
    checks = [_entry(row) for row in tables.fetch(filter_)]
    for row in tables.fetch(filter_, 1):
        checks[row["RuleIndex"]]["worst"].append(_cell(row))
    return checks


def verdict_of(checks: Iterable[dict[str, Any]]) -> str:
    """The verdict on all rules; "empty" if none of them has a cell to check."""
    verdicts = {entry["verdict"] for entry in checks}
    return EMPTY if verdicts == {EMPTY} else next((v for v in (FAIL, WARN) if v in verdicts), PASS)


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
    results: Sequence[dict[str, Any]],
    files: Sequence[str],
    lines: Sequence[str],
    preset: Optional[str],
) -> dict[str, Any]:
    """What `camaron check --json` prints."""
    return {
        "version": 1,
        "generated": {
            "date": datetime.datetime.now().astimezone().isoformat(" ", "minutes"),
            "by": mesh_facts.program(),
        },
        "rules": list(files),
        "rule": list(lines),
        "preset": preset,
        "verdict": worst_verdict(results),
        "meshes": list(results),
    }


def read_rules(
    rules: Optional[Rules],
    preset: Optional[str] = None,
    tolerate: Optional[str] = None,
    more: Iterable[tuple[str, str]] = (),
) -> ValidRules:
    """Parses rules in any form that `check` accepts, and `more` texts with their names, such as
    ("--rule 1", "Volume > 0"); RulesError lists all of their problems."""
    if isinstance(rules, ValidRules):
        return rules
    named = [words for text_ in more for words in text_]
    if rules is None and preset is None and not named:
        raise ValueError("expected rules or a preset")
    pipeline.load_plugin()
    filter_ = servermanager.ProxyManager().NewProxy("filters", "CheckQuality")
    properties = {"Preset": "None", "Tolerate": "" if tolerate is None else str(tolerate)}
    if named:
        properties["NamedRules"] = named
    if preset is not None:
        names = filter_.GetProperty("PresetNames")
        pipeline.update_information(filter_, names)
        choices = [names.GetElement(i) for i in range(2, names.GetNumberOfElements())]
        properties["Preset"] = preset = text.lookup(preset, choices, "preset")
    if isinstance(rules, (str, os.PathLike)):
        properties["RulesFile"] = str(rules)
    elif rules is not None:
        properties["Rules"] = _join(rules)
    for name, value in properties.items():
        for i, words in enumerate([value] if isinstance(value, str) else value):
            filter_.GetProperty(name).SetElement(i, words)
    filter_.UpdateVTKObjects()
    found = filter_.GetProperty("Problems")
    pipeline.update_information(filter_, found)
    texts = [found.GetElement(i) for i in range(found.GetNumberOfElements())]
    problems = [_problem(*texts[i : i + 3]) for i in range(0, len(texts), 3)]
    if problems:
        raise RulesError(problems)
    return ValidRules(properties, preset)


#: Largest text of rules, in bytes, as for a file that Check Quality reads.
MAX_SIZE = 1 << 20


def named_rules(files: Sequence[str], lines: Sequence[str]) -> tuple[Optional[str], list]:
    """The arguments --rules and --rule as arguments of `read_rules`: a file, and more texts.

    Standard input and pipes can be read only once; the launcher copies them before ranks start, and names them and
    their copies in CAMARON_PIPES.
    """
    words = os.environ.get("CAMARON_PIPES", "").splitlines()
    copies = dict(zip(words[::2], words[1::2]))
    first, texts = None, []
    if list(files).count("-") > 1:
        raise ValueError("--rules -: standard input is given more than once")
    for file in files:
        is_stream = file == "-" or file in copies
        if first is None and not is_stream and (os.path.isfile(file) or not os.path.exists(file)):
            first = file
            continue
        name = "stdin" if file == "-" else file
        try:
            with open(copies.get(file, "/dev/stdin" if file == "-" else file), "rb") as stream:
                data = stream.read(MAX_SIZE + 1)
        except OSError as error:
            raise RulesError([f"{name}: {error.strerror}"]) from None
        texts.append((name, _decoded(name, data)))
        if not re.search(r"^[ \t\ufeff]*[^\s#]", texts[-1][1], re.MULTILINE):
            raise RulesError([f"{name}: expected at least one rule, found none"])
    rules = (re.sub(r"[\r\n]+", " ", line) for line in lines)
    return first, texts + [(f"--rule {i}", rule) for i, rule in enumerate(rules, 1)]


def _decoded(name: str, data: bytes) -> str:
    try:
        text_ = data.decode("utf-8")
    except UnicodeDecodeError:
        raise RulesError([f"{name}: expected text in UTF-8, found other bytes"]) from None
    if "\0" in text_:
        raise RulesError([f"{name}: expected text, found a zero byte"])
    if len(data) > MAX_SIZE:
        raise RulesError([f"{name}: too large for a file of rules"])
    return text_


def _join(lines: Any) -> str:
    """Lines of rules as one text."""
    if not isinstance(lines, Iterable):
        raise ValueError(f"rules are the name of a file or a list of lines, not {lines!r}")
    lines = list(lines)
    problems = [
        f"rules:{number}: expected a line of text, found {line!r}"
        for number, line in enumerate(lines, 1)
        if not isinstance(line, str)
    ]
    if problems:
        raise RulesError(problems)
    return "\n".join(re.sub(r"[\r\n]+", " ", line) for line in lines)


def _problem(source: str, line: str, reason: str) -> str:
    """A problem as a message."""
    place = "tolerate" if source == "Tolerate" else source  # of the function and of the command
    has_line = line != "0" and not source.startswith("--")
    return f"{place}{':' + line if has_line else ''}: {reason}"


def _entry(row: dict[str, Any]) -> dict[str, Any]:
    """The entry of a rule from its row, without the list of cells."""
    known = lambda value: value if math.isfinite(value) else None
    value = row["ScopeValue"]
    scope = {
        "by": row["ScopeBy"],
        "value": int(value) if row["ScopeBy"] == "array" else value,
        "array": row["ScopeArray"] or None,
    }
    return {
        "rule": row["Rule"],
        "criterion": row["Criterion"],
        "scope": scope if row["ScopeBy"] else None,
        "range": [known(row["Low"]), known(row["High"])],
        "closed": [bool(row["LowIncluded"]), bool(row["HighIncluded"])],
        "range_text": row["Range"],
        "scope_text": row["Scope"],
        "line": row["Line"] or None,
        "preset": row["Preset"] or None,
        "undefined_fails": bool(row["UndefinedFails"]),
        "hint": bool(row["Hint"]),
        "elements": row["ScopeValue"] if row["ScopeBy"] == "elements" else "cells",
        "cells": row["Cells"],
        "checked": row["Checked"],
        "failing": row["Failing"],
        "fraction": row["Failing"] / row["Checked"] if row["Checked"] else None,
        "below": row["Below"],
        "above": row["Above"],
        "undefined": row["Undefined"],
        "infinite": row["Infinite"],
        "tolerance": row["Tolerance"],
        "tolerated": row["Tolerated"],
        "verdict": row["Verdict"],
        "worst_value": None if math.isnan(row["WorstValue"]) else row["WorstValue"],
        "worst": [],
    }


def _cell(row: dict[str, Any]) -> dict[str, Any]:
    """A failing cell from its row."""
    return {
        "id": row["Id"],
        "id_space": row["IdSpace"].lower(),
        "block": row["Block"] or None,
        "type": text.cell_type(row["CellType"], 1),
        "value": None if row["Why"] == "undefined" else row["Value"],
        "center": [row["X"], row["Y"], row["Z"]],
        "why": row["Why"],
    }
