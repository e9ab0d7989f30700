# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The output of `camaron compare`."""

from __future__ import annotations

from typing import Any

from ..common import text


def describe(summary: dict[str, Any], color: bool = False) -> str:
    """Both meshes, one line per criterion, and the findings."""
    summary = text.all_printable(summary)
    lines = []
    for name in "ab":
        mesh = summary[name]
        types = ", ".join(f"{t['count']} {t['name']}" for t in mesh["cell_types"])
        cells = text.plural(mesh["cells"], "cell") + (f": {types}" if types else "")
        lines.append(
            f"{name.upper()}: {mesh['path']}, {text.plural(mesh['points'], 'point')}, {cells}"
        )
    rows = summary["criteria"]
    if rows:
        lines.append("")
        for line, row in zip(_table(summary), [None, *_lines(rows)]):
            worse = row is not None and row["name"] in summary["worse"]
            mark = "! " if worse else "  "
            lines.append(f"\x1b[1;31m{mark}{line}\x1b[0m" if color and worse else mark + line)
    lines += ["", *findings(summary), *(f"Note: {note}" for note in summary["notes"])]
    return "\n".join(lines)


def _lines(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The criteria, each followed by its groups with their own numbers and names."""
    return [
        line
        for row in rows
        for line in [
            row,
            *({**row, **group, "name": f"  {group['group']}"} for group in row["groups"]),
        ]
    ]


def _table(summary: dict[str, Any]) -> list[str]:
    """Pairs of columns; columns about single cells exist only if the cells can be compared one by
    one."""
    columns = [("criterion", lambda c: c["name"]), ("unit", lambda c: c["unit"])]
    if any(c["groups"] for c in summary["criteria"]):
        columns += [
            (f"cells {mesh.upper()}", lambda c, mesh=mesh: str(c[mesh]["count"])) for mesh in "ab"
        ]
    for label, key in (("min", "min"), ("median", "median"), ("max", "max"), ("outside", "")):
        for mesh in "ab":
            columns.append((f"{label} {mesh.upper()}", _cell(key, mesh)))
    columns.append(("distance", lambda c: text.number(c["distance"], 3)))
    if summary["same_cells"]:
        for key, label in (("improved", "better"), ("worsened", "worse")):
            # Without a better direction, cells are neither better nor worse.
            columns.append(
                (label, lambda c, key=key: "" if c["better"] == "neither" else str(c[key]))
            )
        columns.append(("same", lambda c: str(c["unchanged"])))
    rows = [[value(c) for _, value in columns] for c in _lines(summary["criteria"])]
    return text.table([name for name, _ in columns], rows, left=2)


def _cell(key: str, mesh: str):
    if key:
        return lambda c: text.number(c[mesh][key])
    return lambda c: "" if c[mesh]["out_of_range_percent"] is None else str(c[mesh]["out_of_range"])


def findings(summary: dict[str, Any]) -> list[str]:
    """Findings as sentences: facts, no verdict."""
    rows = summary["criteria"]
    if not rows:
        return ["None of the criteria applies to the cells of these meshes."]
    limited = [c for c in rows if is_limited(c)]
    better = [c["name"] for c in limited if _share(c, "b") < _share(c, "a")]
    sentences = []
    if summary["worse"]:
        sentences.append(
            f"B has a larger percentage of cells outside the acceptable range of {', '.join(summary['worse'])}."
        )
    if better:
        sentences.append(
            f"B has a smaller percentage of cells outside the acceptable range of {', '.join(better)}."
        )
    if limited and not better and not summary["worse"]:
        sentences.append("The percentages of cells outside the acceptable ranges are the same.")
    far = max(rows, key=lambda c: c["distance"] or 0.0)
    if not far["distance"]:
        sentences.append("The distributions of all criteria are the same.")
    else:
        sentences.append(
            f"The distributions differ most in {far['name']}: the percentages of cells with values up to "
            f"{text.number(far['distance_value'])} differ by {text.number(100 * far['distance'], 3)} %."
        )
    if not summary["same_cells"]:
        sentences.append("The meshes have different cells, so cells are not compared one by one.")
    return sentences


def is_limited(row: dict[str, Any]) -> bool:
    """Whether there is an acceptable range that covers cells of one of the meshes."""
    return any(row[mesh]["out_of_range_percent"] is not None for mesh in "ab")


def _share(row: dict[str, Any], mesh: str) -> float:
    return row[mesh]["out_of_range_percent"] or 0.0
