# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ranks criteria, and states the findings about a mesh."""

from __future__ import annotations

from typing import Any, Optional

from . import text
from .tables import BY_USER, is_file
from .text import THIN


#: Smaller distances from the ideal are ignored, as in Element Quality.
NOTICEABLE = 1 / 256


def distance_from_ideal(criterion: dict[str, Any]) -> Optional[float]:
    """How far the median is from the ideal, 0 at the ideal and 1 at the bad end of the range.

    None for a criterion without an ideal, a direction or a finite value. If the range has no bad
    end, the result is d / (d + max(|i|, 1)) for a distance d from the ideal i.
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
    """Whether there is an acceptable range that covers some of the cells."""
    return criterion["acceptable"] != [None, None] and criterion["judged"] > 0


def has_not_judged(criterion: dict[str, Any]) -> bool:
    """Whether there is an acceptable range, but not for all cells that the criterion applies to."""
    return is_limited(criterion) and criterion["judged"] < criterion["applicable"]


def range_to_select(criterion: dict[str, Any], summary: dict[str, Any]) -> dict[str, str]:
    """The properties of Select Elements for the acceptable range of a criterion of a summary."""
    if criterion["acceptable_source"] == BY_USER:
        limits = zip(("LowerLimit", "UpperLimit"), criterion["acceptable"])
        ends = {name: repr(limit) for name, limit in limits if limit is not None}
        return {"Range": "Custom", **ends}
    ranges = summary["ranges"]
    found = {"Preset": summary["preset"], "RangesFile": ranges if is_file(ranges) else None}
    return {name: value for name, value in found.items() if value}


def drawn_limits(criterion: dict[str, Any]) -> list[Optional[float]]:
    """The acceptable range if it covers all cells, so that the value alone decides whether a cell
    is outside."""
    is_for_all = criterion["judged"] == criterion["applicable"]
    return criterion["acceptable"] if is_for_all else [None, None]


def is_serious(criterion: dict[str, Any]) -> bool:
    """Whether cells are outside of a range that is more than a hint."""
    return criterion["out_of_range"] > 0 and not criterion["acceptable_is_hint"]


def weight(criterion: dict[str, Any]) -> tuple[int, int]:
    """Sort key: cells outside of a range with a source come before cells outside of a hint."""
    outside = criterion["out_of_range"]
    return (outside if is_serious(criterion) else 0, outside)


def worst_criterion(criteria: list[dict[str, Any]]) -> Optional[dict[str, Any]]:
    """The criterion to inspect first; None if there are no values.

    If cells with a volume have values, criteria of polygons alone are ignored: the polygons of such
    a mesh lie on or between its cells. Of the other criteria:

    1. the criterion with the most cells outside the acceptable range; ranges that are only hints
       come after ranges with a source;
    2. on a tie, or if no cell is outside, the criterion with the largest distance of the median
       from the ideal; criteria with an acceptable range come first, unless the median is the ideal;
    3. without an ideal, the first criterion that has a direction, then the first criterion.
    """

    def rank(criterion):
        distance = distance_from_ideal(criterion)
        return (
            weight(criterion),
            distance is not None and distance >= NOTICEABLE and is_limited(criterion),
            -1.0 if distance is None else distance,
            criterion["better"] != "neither",
        )

    valued = [criterion for criterion in criteria if criterion["count"] > criterion["undefined"]]
    solid = [c for c in valued if c["applies_to"] in ("polyhedra", "tetrahedra")]
    if solid:
        valued = [c for c in valued if c["applies_to"] not in ("polygons", "triangles")]
    # max() returns the first of equal items, so remaining ties follow the order of the table.
    return max(valued, key=rank, default=None)


def picture_criterion(criteria: list[dict[str, Any]]) -> Optional[dict[str, Any]]:
    """The worst criterion with values for most cells, else the worst criterion."""
    most = [c for c in criteria if 2 * (c["count"] - c["undefined"]) > c["count"]]
    return worst_criterion(most) or worst_criterion(criteria)


def undefined_count(criterion: dict[str, Any]) -> int:
    """Number of cells to which the criterion applies but whose value is undefined."""
    return criterion["undefined"] - (criterion["count"] - criterion["applicable"])


def findings(summary: dict[str, Any], most: int = 6) -> list[dict[str, Any]]:
    """The findings about a mesh, worst first: facts, no verdict.

    Each finding has a `text` in which `{}` stands for the `criteria` (a list of their
    dictionaries), whether it `matters`, that is, reports cells outside a range or with undefined
    values, whether it is only a `hint`, and the strategy of Select Elements that `selects` these
    cells, empty if there is none. Invalid cells come first, then the largest fractions of
    cells outside a range.
    """
    criteria = summary["criteria"]
    if not summary["mesh"]["cells"]:
        return [_finding("The mesh has no cells.", matters=True)]
    if not criteria:
        return [_finding("None of the criteria applies to the cells of this mesh.")]
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
            _finding("None of the evaluated criteria has an acceptable range for these cells.")
        )
    # If all cells are valid, values are undefined because of the definition of the criterion.
    validity = next((c for c in criteria if c["name"] == "IsValid"), None)
    is_valid = validity is not None and not validity["out_of_range"]
    for amount in sorted({undefined_count(c) for c in criteria} - {0}, reverse=True):
        those = [c for c in criteria if undefined_count(c) == amount]
        sentence = f"{{}}: undefined for {text.plural(amount, 'cell', THIN)}."
        selects = "Undefined" if len(those) == 1 else ""
        facts.append(_finding(sentence, those, True, is_valid, selects))
    return facts + [_outside(c, hint=True) for c in hints]


def _urgency(criterion: dict[str, Any]) -> tuple[bool, float]:
    """Sort key: criteria of validity first, for which every cell counts, then the fraction of cells
    outside."""
    return (criterion["is_validity"], criterion["out_of_range"] / criterion["judged"])


def _outside(c: dict[str, Any], hint: bool = False) -> dict[str, Any]:
    """The number of cells outside of an acceptable range, and its meaning."""
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
    return _finding(f"{sentence}{meaning}.", [c], True, hint, "By criterion")


def _finding(sentence, criteria=(), matters=False, hint=False, selects=""):
    return {
        "text": sentence,
        "criteria": list(criteria),
        "matters": matters,
        "hint": hint,
        "selects": selects,
    }
