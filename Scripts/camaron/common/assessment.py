# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which criterion shows best what is wrong with a mesh."""

from __future__ import annotations

from typing import Any, Optional

from . import text
from .text import THIN


#: Smaller distances from the ideal are none, as for the bins of Element Quality.
NOTICEABLE = 1 / 256


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
    """Whether an acceptable range is known that is for some of the cells."""
    return criterion["acceptable"] != [None, None] and criterion["judged"] > 0


def drawn_limits(criterion: dict[str, Any]) -> list[Optional[float]]:
    """The acceptable range where it is for all cells, so that their values alone tell who is outside."""
    is_for_all = criterion["judged"] == criterion["applicable"]
    return criterion["acceptable"] if is_for_all else [None, None]


def is_serious(criterion: dict[str, Any]) -> bool:
    """Whether cells are outside of a range that somebody stands for."""
    return criterion["out_of_range"] > 0 and not criterion["acceptable_is_hint"]


def weight(criterion: dict[str, Any]) -> tuple[int, int]:
    """Cells outside of a range that somebody stands for come before those outside of a hint."""
    outside = criterion["out_of_range"]
    return (outside if is_serious(criterion) else 0, outside)


def worst_criterion(criteria: list[dict[str, Any]]) -> Optional[dict[str, Any]]:
    """The criterion to look at first; None when there is no value at all.

    Where cells with a volume have values, criteria of polygons alone do not take part: polygons of
    such a mesh lie on or between its cells. Of the others

    1. the one with the most cells outside the acceptable range, where a range that is a hint only
       counts after those with a source;
    2. on a tie, and when nothing is outside: the largest distance of the median from the ideal,
       criteria with an acceptable range before those without, unless the median is the ideal.
    3. Without any ideal either, the first criterion that has a direction, then the first.
    """

    def rank(criterion):
        distance = distance_from_ideal(criterion)
        return (
            weight(criterion),
            distance is not None and distance >= NOTICEABLE and is_limited(criterion),
            -1.0 if distance is None else distance,
            criterion["better"] != "neither",
        )

    valued = [criterion for criterion in criteria if criterion["count"] > criterion["null"]]
    solid = [c for c in valued if c["applies_to"] in ("polyhedra", "tetrahedra")]
    if solid:
        valued = [c for c in valued if c["applies_to"] not in ("polygons", "triangles")]
    # max() keeps the first of equals, so ties that remain follow the order of the table.
    return max(valued, key=rank, default=None)


def picture_criterion(criteria: list[dict[str, Any]]) -> Optional[dict[str, Any]]:
    """The worst criterion of those that have values for most cells, if there are any."""
    most = [c for c in criteria if 2 * (c["count"] - c["null"]) > c["count"]]
    return worst_criterion(most) or worst_criterion(criteria)


def undefined_count(criterion: dict[str, Any]) -> int:
    """Cells for which the criterion has a meaning but no value."""
    return criterion["null"] - (criterion["count"] - criterion["applicable"])


def findings(summary: dict[str, Any], most: int = 6) -> list[dict[str, Any]]:
    """What to say first about a mesh, worst first: facts, no verdict.

    Each is a `text` in which `{}` stands for the `criteria` (a list of their dictionaries),
    whether it `matters`, that is, tells of cells outside a range or without a value, and whether it
    is a `hint` only. Cells that no program can use come first, then what the largest share of cells misses.
    """
    criteria = summary["criteria"]
    if not summary["mesh"]["cells"]:
        return [_finding("The mesh has no cells.", matters=True)]
    if not criteria:
        return [_finding("None of the criteria has a meaning for the cells of this mesh.")]
    limited = [c for c in criteria if is_limited(c)]
    outside = [c for c in limited if c["out_of_range"]]
    serious = sorted(filter(is_serious, outside), key=_urgency, reverse=True)
    hints = sorted((c for c in outside if c not in serious), key=_urgency, reverse=True)
    facts = [_outside(c) for c in serious[:most]]
    if len(serious) > most:
        sentence = "Cells are also outside the acceptable ranges of {}."
        facts.append(_finding(sentence, serious[most:], True))
    if limited and not serious:
        cited = [c for c in limited if not c["acceptable_is_hint"]]
        ranges = f"ranges of the {len(cited)} criteria that have one"
        ranges = ranges if len(cited) > 1 else "range"
        facts.append(_finding(f"No cell is outside the acceptable {ranges}."))
    if not limited:
        facts.append(
            _finding("None of the criteria evaluated has an acceptable range for these cells.")
        )
    # Where all cells are valid, it is the definition that leaves some out.
    validity = next((c for c in criteria if c["name"] == "IsValid"), None)
    is_valid = validity is not None and not validity["out_of_range"]
    for amount in sorted({undefined_count(c) for c in criteria} - {0}, reverse=True):
        those = [c for c in criteria if undefined_count(c) == amount]
        sentence = f"{{}}: undefined for {text.plural(amount, 'cell', THIN)}."
        facts.append(_finding(sentence, those, True, hint=is_valid))
    return facts + [_outside(c, hint=True) for c in hints]


def _urgency(criterion: dict[str, Any]) -> tuple[bool, float]:
    """Validity is a matter of every cell, so that a share says little; all else is a matter of degree."""
    return (criterion["is_validity"], criterion["out_of_range"] / criterion["judged"])


def _outside(c: dict[str, Any], hint: bool = False) -> dict[str, Any]:
    """How many cells are outside of an acceptable range, and what that means."""
    verb = "is" if c["out_of_range"] == 1 else "are"
    limits = text.interval(*c["acceptable"], c["unit"])
    part, whole = c["out_of_range"], c["judged"]
    cells = text.plural(whole, "cell", THIN)
    if whole < c["applicable"]:
        cells = f"{text.count(whole, THIN)} {c['acceptable_for']}"
    sentence = (
        f"{text.count(part, THIN)} of {cells} ({text.percent(part, whole)} %) {verb} outside the "
        f"acceptable range of {{}} ({limits})"
    )
    meaning = f": {c['consequence']}" if c["consequence"] else ""
    return _finding(f"{sentence}{meaning}.", [c], True, hint)


def _finding(sentence, criteria=(), matters=False, hint=False):
    return {"text": sentence, "criteria": list(criteria), "matters": matters, "hint": hint}
