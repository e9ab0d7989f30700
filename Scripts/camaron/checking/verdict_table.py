# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The verdicts of `camaron check` as text."""

from __future__ import annotations

from typing import Any

from ..common import text

WORDS = {"pass": "pass", "warn": "WARN", "fail": "FAIL", "empty": "none"}
COLORS = {"warn": "1;33", "fail": "1;31"}


def describe(result: dict[str, Any], color: bool = False) -> str:
    """The verdicts on a mesh: a table of the rules, then the worst cells of rules that fail or
    warn."""
    result = text.all_printable(result)
    checks = result["checks"]
    lines = [f"{result['mesh']}: {text.plural(result['cells'], 'cell')}"]
    header, *rows = _table(checks)
    lines.append(header)
    for line, entry in zip(rows, checks):
        code = COLORS.get(entry["verdict"]) if color else None
        lines.append(f"\x1b[{code}m{line}\x1b[0m" if code else line)
    for entry in checks:
        if entry["verdict"] in COLORS:
            lines += ["", sentence(entry), *offenders(entry)]
    lines += ["", *(f"Note: {note}" for note in notes(result))]
    number = text.plural(len(checks), "rule")
    verdict = result["verdict"]
    count = sum(entry["verdict"] == verdict for entry in checks)
    lines.append(
        f"{WORDS[verdict]}: {count} of {number}" if verdict in COLORS else f"pass: {number}"
    )
    warnings = sum(entry["verdict"] == "warn" for entry in checks)
    if verdict == "fail" and warnings:
        lines[-1] += f"; WARN: {warnings}"
    return "\n".join(lines)


def _table(checks: list[dict[str, Any]]) -> list[str]:
    """The table of rules; it has columns of scopes, undefined and infinite values only if there are
    any."""
    columns = [
        ("", lambda c: WORDS[c["verdict"]]),
        ("criterion", lambda c: c["criterion"]),
        ("acceptable", lambda c: c["range_text"]),
        ("cells", lambda c: c["scope_text"]),
        ("checked", lambda c: str(c["checked"])),
        ("failing", lambda c: str(c["failing"])),
        ("%", lambda c: text.percent(c["failing"], c["checked"])),
        ("tolerated", lambda c: c["tolerance"]),
        ("undefined", lambda c: str(c["undefined"])),
        ("inf", lambda c: str(c["infinite"])),
        ("worst", lambda c: text.number(c["worst_value"])),
    ]
    for name in ("scope_text", "undefined", "infinite"):
        if not any(entry[name] for entry in checks):
            header = {"scope_text": "cells", "infinite": "inf"}.get(name, name)
            columns = [column for column in columns if column[0] != header]
    rows = [[value(entry) for _, value in columns] for entry in checks]
    left = 4 if any(entry["scope_text"] for entry in checks) else 3
    return text.table([name for name, _ in columns], rows, left=left)


def noun(entry: dict[str, Any], count: int = 1) -> str:
    """What a rule judges, for a number of them: "cell", "faces", "vertices"."""
    plural = entry["elements"]
    return plural if count != 1 else {"vertices": "vertex"}.get(plural, plural[:-1])


def sentence(entry: dict[str, Any]) -> str:
    """The result of a rule as a sentence.

    >>> sentence(entry)
    'MinDihedralAngle >= 10: 3 of 2000 cells (0.15 %) fail; tolerated: 2 (0.1%)'
    """
    share = text.percent(entry["failing"], entry["checked"])
    verb = "fails" if entry["failing"] == 1 else "fail"
    checked = f"{text.count(entry['checked'])} {noun(entry, entry['checked'])}"
    words = f"{entry['rule']}: {entry['failing']} of {checked} ({share} %) {verb}"
    if entry["undefined_fails"] and entry["undefined"]:
        words += f", {entry['undefined']} with undefined values"
    if entry["tolerance"] != "0":
        words += f"; tolerated: {entry['tolerated']}"
        words += f" ({entry['tolerance']})" if entry["tolerance"].endswith("%") else ""
    return words


def offenders(entry: dict[str, Any]) -> list[str]:
    """A table of the worst cells, or other elements."""
    worst = entry["worst"]
    has_blocks = any(cell["block"] for cell in worst)
    header = [noun(entry), *(["block"] if has_blocks else []), "type", "value", "center"]
    rows = []
    for cell in worst:
        center = "(" + ", ".join(text.number(x) or "nan" for x in cell["center"]) + ")"
        value = "undefined" if cell["value"] is None else text.number(cell["value"])
        block = [cell["block"] or ""] if has_blocks else []
        rows.append([str(cell["id"]), *block, cell["type"], value, center])
    lines = ["  " + line for line in text.table(header, rows, left=len(header) - 2)]
    more = entry["failing"] - len(worst)
    return lines + ([f"  and {more} more"] if more else [])


def notes(result: dict[str, Any]) -> list[str]:
    """Notes on the mesh and on the verdicts."""
    return [*result["notes"], *notes_on(result["checks"])]


def notes_on(checks: list[dict[str, Any]]) -> list[str]:
    """Notes on the verdicts."""
    found = []
    empty = [entry["rule"] for entry in checks if entry["verdict"] == "empty"]
    if empty:
        found.append(f"There are no cells to check for {', '.join(empty)}.")
    if any(entry["verdict"] == "warn" for entry in checks):
        found.append(
            "Hints of a preset only warn: they are common practice, and some meshes violate them on purpose."
        )
    for entry in checks:
        if entry["undefined"] and not entry["undefined_fails"]:
            cells = f"{text.count(entry['undefined'])} {noun(entry, entry['undefined'])}"
            found.append(f"{cells} with an undefined value passed {entry['rule']}.")
    return found
