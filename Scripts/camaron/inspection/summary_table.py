# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The output of `camaron inspect`."""

from __future__ import annotations

from typing import Any

from ..common import assessment, text


def describe(summary: dict[str, Any], color: bool = False) -> str:
    """The summary as text: facts about the mesh, one line per criterion, and the findings."""
    summary = text.all_printable(summary)
    mesh, criteria = summary["mesh"], summary["criteria"]
    types = ", ".join(f"{t['count']} {t['name']}" for t in mesh["cell_types"])
    lines = [mesh["path"] or mesh["name"]]
    lines.append(
        f"  {text.plural(mesh['points'], 'point')}, {text.plural(mesh['cells'], 'cell')}"
        + (f": {types}" if types else "")
    )
    if mesh["bounds"]:
        low, high = mesh["bounds"][0::2], mesh["bounds"][1::2]
        place = lambda p: "(" + ", ".join(map(text.number, p)) + ")"
        lines.append(
            f"  from {place(low)} to {place(high)}, {text.memory(mesh['memory'])} in memory"
        )
    totals = [
        f"{label} {text.number(mesh[key])}"
        for key, label in (("volume", "volume"), ("area", "area"))
        if mesh[key] is not None
    ]
    if mesh["boundary_faces"]:
        totals.append(text.plural(mesh["boundary_faces"], "boundary face"))
    if totals:
        lines.append("  " + ", ".join(totals))
    if criteria:
        lines += ["", *_table(criteria, color)]
    lines.append("")
    for finding in assessment.findings(summary):
        names = ", ".join(c["name"] for c in finding["criteria"])
        sentence = finding["text"].replace("{}", names)
        lines.append(text.in_ascii(("Hint: " if finding["hint"] else "") + sentence))
    lines += [f"Note: {note}" for note in summary["notes"]]
    return "\n".join(lines)


def _table(criteria: list[dict[str, Any]], color: bool) -> list[str]:
    """The table of criteria; it has columns of undefined and infinite values only if there are
    any."""
    columns = [
        ("criterion", lambda c: c["name"]),
        ("unit", lambda c: c["unit"]),
        ("cells", lambda c: str(c["applicable"])),
        ("undefined", lambda c: str(assessment.undefined_count(c))),
        ("inf", lambda c: str(c["infinite"])),
        ("min", lambda c: text.number(c["min"])),
        ("p1", lambda c: text.number(c["quantiles"].get("1"))),
        ("median", lambda c: text.number(c["quantiles"].get("50"))),
        ("p99", lambda c: text.number(c["quantiles"].get("99"))),
        ("max", lambda c: text.number(c["max"])),
        ("mean", lambda c: text.number(c["mean"])),
        (
            "acceptable",
            lambda c: (
                text.in_ascii(text.interval(*c["acceptable"])) if assessment.is_limited(c) else ""
            ),
        ),
        ("outside", lambda c: str(c["out_of_range"]) if assessment.is_limited(c) else ""),
        (
            "%",
            lambda c: (
                text.percent(c["out_of_range"], c["judged"]) if assessment.is_limited(c) else ""
            ),
        ),
    ]
    unneeded = set()
    if not any(assessment.undefined_count(c) for c in criteria):
        unneeded.add("undefined")
    if not any(c["infinite"] for c in criteria):
        unneeded.add("inf")
    columns = [column for column in columns if column[0] not in unneeded]
    rows = [[value(c) for _, value in columns] for c in criteria]
    lines = text.table([name for name, _ in columns], rows, left=2)
    marked = [lines[0]]
    for line, c in zip(lines[1:], criteria):
        bad = assessment.is_serious(c)
        mark = "! " if bad else "  "
        marked.append(f"\x1b[1;31m{mark}{line}\x1b[0m" if color and bad else mark + line)
    return ["  " + marked[0], *marked[1:]]
