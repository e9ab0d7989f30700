# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts the cells that violate rules, and lists the worst of them, with Quality Statistics.

Its numbers are exact on any number of ranks. It groups cells in one way only, so rules are
evaluated in rounds, each with one way to group. The cumulative curve at the limits of all rules of
a round counts the cells below and above.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, Iterator, Optional, Sequence

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from ..common import tables, text
from ..common.evaluation import CELL_FAMILY, Evaluation
from .rules import FAMILIES, Rule, Scope

ALL_CELLS = "All"
#: Maximum of criteria times rules per round; the curve has twice this number of rows per group.
MOST_PRODUCTS = 4096

#: GroupBy and GroupArray of Quality Statistics.
Grouping = tuple[str, str]


@dataclass
class Counts:
    """The numbers of cells that a rule applies to."""

    #: Cells of the mesh; of these, cells in the scope of the rule.
    total: int = 0
    cells: int = 0
    #: Of these, cells to which the criterion applies; of these, cells with an undefined value.
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
    """A rule refers to a block or a cell array that the mesh does not have."""


def needed_criteria(rules: Sequence[Rule], known: Sequence[str]) -> list[str]:
    """The criteria that Element Quality has to evaluate for the rules."""
    criteria = [rule.criterion for rule in rules]
    for rule in rules:
        array = _group_array(rule.scope)
        if array in known:
            criteria.append(array)
    return [*dict.fromkeys(criteria)]


def count(evaluated: Evaluation, rules: Sequence[Rule], worst: int) -> list[Counts]:
    """Counts of each of the rules, with up to `worst` offenders.

    Raises ScopeError if a rule refers to a missing block or array.
    """
    _check_arrays(evaluated, rules)
    counts = [Counts() for _ in rules]
    counter = _Counter(evaluated, worst)
    for grouping, members in _rounds(rules):
        found = counter.count(grouping, [rules[i] for i in members])
        for i, each in zip(members, found):
            counts[i] = each
    return counts


def _rounds(rules: Sequence[Rule]) -> Iterator[tuple[Grouping, list[int]]]:
    """Indices of the rules to count in each round: with the same grouping, and a limited number of
    criteria times limits."""
    by_criterion: dict[Grouping, dict[str, list[int]]] = {}
    for i, rule in enumerate(rules):
        by_criterion.setdefault(_grouping(rule.scope), {}).setdefault(rule.criterion, []).append(i)
    for grouping, criteria in by_criterion.items():
        members: list[int] = []
        for number, places in enumerate(criteria.values(), 1):
            if members and number * (len(members) + len(places)) > MOST_PRODUCTS:
                yield grouping, members
                members = []
            members = members + places
        yield grouping, members


def _group_array(scope: Optional[Scope]) -> str:
    """The cell array that defines the cells of a scope; empty if none."""
    if scope is None:
        return ""
    return CELL_FAMILY if scope.kind == "family" else scope.array


def _grouping(scope: Optional[Scope]) -> Grouping:
    if scope is None:
        return ("None", "")
    ways = {"type": "Cell type", "block": "Block"}
    return (ways.get(scope.kind, "Cell array"), _group_array(scope))


def _groups(scope: Optional[Scope]) -> list[str]:
    """Labels of the groups in a scope."""
    if scope is None:
        return [ALL_CELLS]
    if scope.kind == "family":
        return [str(FAMILIES[family]) for family in scope.families()]
    return [str(scope.value)]


def _check_arrays(evaluated: Evaluation, rules: Sequence[Rule]) -> None:
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
    there = f"the mesh has {', '.join(known)}" if known else "the mesh has none"
    return f"there is no {what}; " + (f"did you mean {similar}?" if similar else there)


class _Counter:
    """One Quality Statistics that counts all rounds.

    With one filter per round, the time would grow with the square of the number of rounds: the more
    filters a source has, the longer ParaView takes to create, update and delete another one.
    """

    def __init__(self, evaluated: Evaluation, worst: int):
        self.worst = worst
        self.statistics = evaluated.make(simple.QualityStatistics, Quantiles=[50], NumberOfBins=1)
        #: Rows of worst cells by grouping, WorstValues and criterion, then by group. They do not
        #: depend on ranges, so rounds share them.
        self.lists: dict[tuple[Grouping, str, str], dict[str, list[dict[str, Any]]]] = {}

    def count(self, grouping: Grouping, rules: Sequence[Rule]) -> list[Counts]:
        """Counts of the rules of a round."""
        by, array = grouping
        limits = sorted({limit for rule in rules for limit in _limits(rule)})
        self._set(
            Arrays=[*dict.fromkeys(rule.criterion for rule in rules)],
            CurveValues=limits,
            GroupBy=by,
            GroupArray=array,
            NumberOfWorst=0,
        )
        rows = {(row["Criterion"], row["Group"]): row for row in tables.fetch(self.statistics)}
        curves = vtk_to_numpy(servermanager.Fetch(self.statistics, idx=3).GetColumnByName("Count"))
        for row, curve in zip(rows.values(), curves.reshape(len(rows), len(limits))):
            row["CountUpTo"] = dict(zip(limits, curve.tolist()))
        if by == "Block":
            _check_blocks(rules, [*dict.fromkeys(group for _, group in rows if group != ALL_CELLS)])
        counts = [_counts(rule, rows) for rule in rules]
        ends = [_failing_ends(rule, found) for rule, found in zip(rules, counts)]
        for end in ("Smallest", "Largest", "Null"):
            failing = [rule.criterion for rule, of_rule in zip(rules, ends) if end in of_rule]
            self._list_worst(grouping, end, failing)
        for rule, found, of_rule in zip(rules, counts, ends):
            lists = {
                end: [
                    row
                    for group in _groups(rule.scope)
                    for row in self.lists[grouping, end, rule.criterion].get(group, [])
                ]
                for end in of_rule
            }
            found.offenders = _offenders(rule, lists)[: self.worst]
        return counts

    def _set(self, **properties: Any) -> None:
        for name, value in properties.items():
            setattr(self.statistics, name, value)

    def _list_worst(self, grouping: Grouping, end: str, criteria: Sequence[str]) -> None:
        """Lists the worst cells of the criteria, unless an earlier round has listed them."""
        names = dict.fromkeys(criteria)
        lacking = [name for name in names if (grouping, end, name) not in self.lists]
        if not lacking:
            return
        self._set(Arrays=lacking, WorstValues=end, NumberOfWorst=self.worst, CurveValues=[])
        self.lists.update(((grouping, end, name), {}) for name in lacking)
        for row in tables.fetch(self.statistics, 2):
            self.lists[grouping, end, row["Criterion"]].setdefault(row["Group"], []).append(row)


def _check_blocks(rules: Sequence[Rule], blocks: Sequence[str]) -> None:
    for rule in rules:
        if rule.scope.value not in blocks:
            name = rule.scope.value
            raise ScopeError(_unknown(f"block {name} with cells", name, blocks))


def _limits(rule: Rule) -> tuple[float, float]:
    """The largest value below the range, and the largest value not above it."""
    low, high = rule.limits()
    return math.nextafter(low, -math.inf), high


def _counts(rule: Rule, rows: dict[tuple[str, str], dict[str, Any]]) -> Counts:
    """The counts of a rule from the rows by criterion and group, without the offenders."""
    whole = rows.get((rule.criterion, ALL_CELLS))
    total = whole["Count"] if whole else 0
    found = [rows.get((rule.criterion, group)) for group in _groups(rule.scope)]
    found = [row for row in found if row is not None]  # groups without cells have no row
    add = lambda column: sum(row[column] for row in found)
    low, high = _limits(rule)
    up_to = lambda limit: sum(row["CountUpTo"][limit] for row in found)
    finite = lambda column: [row[column] for row in found if not math.isnan(row[column])]
    return Counts(
        total=total,
        cells=add("Count"),
        checked=add("ApplicableCount"),
        null=add("NullCount") - (add("Count") - add("ApplicableCount")),
        infinite=add("InfCount"),
        below=up_to(low),
        above=add("Count") - add("NullCount") - up_to(high),
        min=min(finite("Min"), default=None),
        max=max(finite("Max"), default=None),
    )


def _failing_ends(rule: Rule, found: Counts) -> list[str]:
    """The WorstValues whose lists contain the failing cells."""
    failing = {
        "Smallest": found.below,
        "Largest": found.above,
        "Null": rule.null_fails and found.null,
    }
    return [end for end, count in failing.items() if count]


def _offenders(rule: Rule, lists: dict[str, list[dict[str, Any]]]) -> list[dict[str, Any]]:
    """Failing cells: farthest outside the range first, then undefined values; ties by id.

    The cells farthest outside are among the smallest or the largest values.
    """
    low, high = rule.limits()
    outside = []
    for row in lists.get("Smallest", []):
        if row["Value"] < low:
            outside.append((row["Value"] - low, row["Id"], "below", row))
    for row in lists.get("Largest", []):
        if row["Value"] > high:
            outside.append((high - row["Value"], row["Id"], "above", row))
    outside.sort(key=lambda item: item[:2])
    found = [_offender(row, why) for _, _, why, row in outside]
    null = sorted(lists.get("Null", []), key=lambda row: row["Id"])
    return found + [_offender(row, "null") for row in null]


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
