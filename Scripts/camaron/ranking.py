# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which criterion shows best what is wrong with a mesh."""

from __future__ import annotations

from typing import Any, Optional

from . import text
from .text import THIN


def distance_from_ideal(criterion: dict[str, Any]) -> Optional[float]:
    """How far the median is from the ideal, 0 at the ideal and 1 at the bad end of the range.

    None for a criterion without an ideal, a direction or a finite value. Where the range has no bad
    end, the distance d from the ideal i counts as d / (d + max(|i|, 1)).
    """
    ideal, median = criterion["ideal"], criterion["quantiles"].get("50")
    if ideal is None or median is None or criterion["better"] == "neither":
        return None
    bad_end = criterion["range"][0 if criterion["better"] == "bigger" else 1]
    distance = abs(median - ideal)
    if bad_end is None:
        return distance / (distance + max(abs(ideal), 1.0))
    return min(distance / abs(bad_end - ideal), 1.0) if bad_end != ideal else None


def is_limited(criterion: dict[str, Any]) -> bool:
    """Whether an acceptable range is known."""
    return criterion["acceptable"] != [None, None]


def weight(criterion: dict[str, Any]) -> tuple[int, int]:
    """Cells outside of a range that somebody stands for come before those outside of a hint."""
    outside = criterion["out_of_range"]
    return (0 if criterion.get("acceptable_is_hint") else outside, outside)


def worst_criterion(criteria: list[dict[str, Any]]) -> Optional[dict[str, Any]]:
    """The criterion to look at first; None when there is no value at all.

    Where cells with a volume have values, criteria of polygons alone do not take part: polygons of
    such a mesh lie on or between its cells. Of the others

    1. the one with the most cells outside the acceptable range, where a range that is a hint only
       counts after those with a source;
    2. on a tie, and when nothing is outside: the largest distance of the median from the ideal,
       criteria with an acceptable range before those without.
    3. Without any ideal either, the first criterion that has a direction, then the first.
    """

    def rank(criterion):
        distance = distance_from_ideal(criterion)
        return (
            weight(criterion),
            distance is not None and is_limited(criterion),
            -1.0 if distance is None else distance,
            criterion["better"] != "neither",
        )

    valued = [criterion for criterion in criteria if criterion["count"] > criterion["null"]]
    solid = [c for c in valued if c["applies_to"] in ("polyhedra", "tetrahedra")]
    if solid:
        valued = [c for c in valued if c["applies_to"] not in ("polygons", "triangles")]
    # max() keeps the first of equals, so ties that remain follow the order of the table.
    return max(valued, key=rank, default=None)


def undefined_count(criterion: dict[str, Any]) -> int:
    """Cells for which the criterion has a meaning but no value."""
    return criterion["null"] - (criterion["count"] - criterion["applicable"])


def findings(summary: dict[str, Any], most: int = 4) -> list[dict[str, Any]]:
    """What to say first about a mesh: facts, no verdict.

    Each is a `text` in which `{}` stands for the `criteria` (a list of their dictionaries), and
    whether it `matters`, that is, tells of cells outside a range or without a value.
    """
    criteria = summary["criteria"]
    if not summary["mesh"]["cells"]:
        return [_finding("The mesh has no cells.", matters=True)]
    if not criteria:
        return [_finding("None of the criteria has a meaning for the cells of this mesh.")]
    limited = [c for c in criteria if is_limited(c)]
    outside = sorted((c for c in limited if c["out_of_range"]), key=weight, reverse=True)
    facts = []
    for c in outside[:most]:
        verb = "is" if c["out_of_range"] == 1 else "are"
        limits = text.interval(*c["acceptable"], c["unit"])
        part, whole = c["out_of_range"], c["applicable"]
        sentence = (
            f"{text.count(part, THIN)} of {text.plural(whole, 'cell', THIN)} "
            f"({text.percent(part, whole)} %) {verb} outside the acceptable range of {{}} ({limits})."
        )
        facts.append(_finding(sentence, [c], True))
    if len(outside) > most:
        sentence = "Cells are also outside the acceptable ranges of {}."
        facts.append(_finding(sentence, outside[most:], True))
    if limited and not outside:
        ranges = f"ranges of the {len(limited)} criteria that have one"
        ranges = ranges if len(limited) > 1 else "range"
        facts.append(_finding(f"No cell is outside the acceptable {ranges}."))
    if not limited:
        facts.append(_finding("None of the criteria evaluated has an acceptable range."))
    for amount in sorted({undefined_count(c) for c in criteria} - {0}, reverse=True):
        verb = "has" if amount == 1 else "have"
        sentence = f"{text.plural(amount, 'cell', THIN)} {verb} no value of {{}}."
        those = [c for c in criteria if undefined_count(c) == amount]
        facts.append(_finding(sentence, those, True))
    return facts


def _finding(sentence, criteria=(), matters=False):
    return {"text": sentence, "criteria": list(criteria), "matters": matters}
