# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""How many cells fail each of some rules, and the worst of them: all from Quality Statistics.

Quality Statistics has one range for each criterion and one way to group, and its numbers are exact
on any number of ranks. So rules are dealt out to rounds, each with one way to group and one range
for a criterion.
"""

from __future__ import annotations

import math
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Iterator, Optional, Sequence

from paraview import simple

from . import tables, text
from .evaluation import CELL_FAMILY, Evaluation
from .rules import FAMILIES, Rule, Scope

ALL_CELLS = "All"


@dataclass
class Counts:
    """What there is to know of the cells that a rule is for."""

    #: Cells of the mesh; of these, cells that the rule is for.
    total: int = 0
    cells: int = 0
    #: For which the criterion has a meaning; of these, without a value.
    checked: int = 0
    null: int = 0
    infinite: int = 0
    below: int = 0
    above: int = 0
    #: Smallest and largest finite value.
    min: Optional[float] = None
    max: Optional[float] = None
    #: Cells that fail, worst first.
    offenders: list[dict[str, Any]] = field(default_factory=list)


class ScopeError(RuntimeError):
    """A rule is for a block or a cell array that the mesh does not have."""


def needed_criteria(rules: Sequence[Rule], known: Sequence[str]) -> list[str]:
    """All that Element Quality has to evaluate for the rules."""
    criteria = [rule.criterion for rule in rules]
    for rule in rules:
        array = _group_array(rule.scope)
        if array in known:
            criteria.append(array)
    return [*dict.fromkeys(criteria)]


def count(evaluated: Evaluation, rules: Sequence[Rule], worst: int) -> list[Counts]:
    """Counts of each of the rules, with up to `worst` offenders.

    Raises ScopeError for rules about a block or an array that there is not.
    """
    _check_arrays(evaluated, rules)
    counts = [Counts() for _ in rules]
    for members in _rounds(rules):
        found = _Round(evaluated, [rules[i] for i in members], worst)
        for i in members:
            counts[i] = found.counts(rules[i])
    return counts


def _rounds(rules: Sequence[Rule]) -> Iterator[list[int]]:
    """Places of the rules that Quality Statistics can count at a time."""
    rounds: list[tuple[tuple, dict[str, tuple], list[int]]] = []
    for i, rule in enumerate(rules):
        grouping, limits = _grouping(rule.scope), rule.limits()
        for other, ranges, members in rounds:
            if other == grouping and ranges.get(rule.criterion, limits) == limits:
                break
        else:
            ranges, members = {}, []
            rounds.append((grouping, ranges, members))
        ranges[rule.criterion] = limits
        members.append(i)
    return (members for _, _, members in rounds)


def _group_array(scope: Optional[Scope]) -> str:
    """The cell array that tells the cells of a scope; empty if none."""
    if scope is None:
        return ""
    return CELL_FAMILY if scope.kind == "family" else scope.array


def _grouping(scope: Optional[Scope]) -> tuple[str, str]:
    """GroupBy and GroupArray."""
    if scope is None:
        return ("None", "")
    ways = {"type": "Cell type", "block": "Block"}
    return (ways.get(scope.kind, "Cell array"), _group_array(scope))


def _group(scope: Optional[Scope]) -> str:
    """Label of the group that is a scope."""
    if scope is None:
        return ALL_CELLS
    return str(FAMILIES[scope.value] if scope.kind == "family" else scope.value)


def _check_arrays(evaluated: Evaluation, rules: Sequence[Rule]) -> None:
    evaluated.quality.UpdatePipeline()
    known = {array.Name: array.GetNumberOfComponents() for array in evaluated.quality.CellData}
    for rule in rules:
        array = _group_array(rule.scope)
        if not array or rule.scope.kind == "family":
            continue
        if array not in known:
            raise ScopeError(_unknown(f"cell array {array}", array, known))
        if known[array] != 1:
            raise ScopeError(f"the cell array {array} has {known[array]} components, not one")


def _unknown(what: str, name: str, known) -> str:
    similar = text.similar(name, list(known))
    there = f"there are {', '.join(known)}" if known else "there is none at all"
    return f"there is no {what}; " + (f"did you mean {similar}?" if similar else there)


class _Round:
    """The tables of Quality Statistics for the rules of a round."""

    def __init__(self, evaluated: Evaluation, rules: Sequence[Rule], worst: int):
        self.evaluated, self.worst = evaluated, worst
        self.grouping = _grouping(rules[0].scope)
        with tempfile.TemporaryDirectory(prefix="camaron-") as folder:
            self.ranges = Path(folder) / "check.ranges"
            limits = {rule.criterion: rule.limits() for rule in rules}
            lines = [f"{name} {low!r} {high!r}\n" for name, (low, high) in limits.items()]
            self.ranges.write_text("".join(lines), encoding="ascii")
            statistics = self._make([*limits], "Smallest")
            self.rows = {(row["Criterion"], row["Group"]): row for row in tables.fetch(statistics)}
            self.lists = {"Smallest": tables.fetch(statistics, 2)}
            self.lists["Largest"] = tables.fetch(self._make([*limits], "Largest"), 2)
            with_null = [rule for rule in rules if rule.null_fails and self.counts(rule).null]
            if with_null:
                names = [*dict.fromkeys(rule.criterion for rule in with_null)]
                self.lists["Null"] = tables.fetch(self._make(names, "Null"), 2)
        if self.grouping[0] == "Block":
            blocks = [*dict.fromkeys(group for _, group in self.rows if group != ALL_CELLS)]
            for rule in rules:
                if rule.scope.value not in blocks:
                    name = rule.scope.value
                    raise ScopeError(_unknown(f"block {name} with cells", name, blocks))

    def _make(self, criteria: list[str], worst_values: str) -> Any:
        by, array = self.grouping
        return self.evaluated.make(
            simple.QualityStatistics,
            Arrays=criteria,
            RangesFile=str(self.ranges),
            GroupBy=by,
            GroupArray=array,
            Quantiles=[50],
            NumberOfBins=1,
            NumberOfWorst=self.worst,
            WorstValues=worst_values,
        )

    def counts(self, rule: Rule) -> Counts:
        whole = self.rows.get((rule.criterion, ALL_CELLS))
        row = self.rows.get((rule.criterion, _group(rule.scope)))
        if row is None:  # no such cells
            return Counts(total=whole["Count"] if whole else 0)
        counts = Counts(
            total=whole["Count"],
            cells=row["Count"],
            checked=row["ApplicableCount"],
            null=row["NullCount"] - (row["Count"] - row["ApplicableCount"]),
            infinite=row["InfCount"],
            below=row["BelowCount"],
            above=row["AboveCount"],
            min=None if math.isnan(row["Min"]) else row["Min"],
            max=None if math.isnan(row["Max"]) else row["Max"],
        )
        counts.offenders = self._offenders(rule)
        return counts

    def _offenders(self, rule: Rule) -> list[dict[str, Any]]:
        """Farthest outside the range first, then cells without a value; equal ones by id.

        Those farthest outside are among the smallest or the largest values.
        """
        low, high = rule.limits()
        outside = []
        for row in self._list("Smallest", rule):
            if row["Value"] < low:
                outside.append((row["Value"] - low, row["Id"], "below", row))
        for row in self._list("Largest", rule):
            if row["Value"] > high:
                outside.append((high - row["Value"], row["Id"], "above", row))
        outside.sort(key=lambda item: item[:2])
        found = [_offender(row, why) for _, _, why, row in outside]
        if rule.null_fails:
            found += [_offender(row, "null") for row in self._list("Null", rule)]
        return found[: self.worst]

    def _list(self, end: str, rule: Rule) -> list[dict[str, Any]]:
        wanted = (rule.criterion, _group(rule.scope))
        rows = self.lists.get(end, [])
        return [row for row in rows if (row["Criterion"], row["Group"]) == wanted]


def _offender(row: dict[str, Any], why: str) -> dict[str, Any]:
    return {
        "id": row["Id"],
        "id_space": row["IdSpace"].lower(),
        "block": row["Block"] or None,
        "type": text.cell_type(row["CellType"], 1),
        "value": None if why == "null" else row["Value"],
        "center": [row["X"], row["Y"], row["Z"]],
        "why": why,
    }
