# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page that `compare` writes: one HTML file that needs nothing from elsewhere."""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import Any

from . import comparison_table, svg, text
from .text import THIN

BETTER = {"bigger": "Larger is better", "smaller": "Smaller is better", "neither": ""}


def render(summary: dict[str, Any]) -> str:
    """The report as HTML. `summary` is what summary.json holds (see Documentation/compare.md)."""
    style = (Path(__file__).parent / "report.css").read_text(encoding="utf-8")
    names = [escape(summary[mesh]["name"]) for mesh in "ab"]
    items = "".join(
        f'<a href="#criterion-{escape(c["name"])}">{escape(c["label"])}'
        + ('<i title="more cells outside the acceptable range"></i>' if _is_worse(summary, c) else "")
        + "</a>"
        for c in summary["criteria"]
    )
    made = summary["generated"]
    sentences = [f"<li>{escape(s)}</li>" for s in comparison_table.findings(summary)]
    sentences += [f'<li class="note">{escape(note)}</li>' for note in summary["notes"]]
    body = [
        '<header id="top"><p class="eyebrow">Mesh comparison</p>'
        f'<h1><span class="a">{names[0]}</span> and <span class="b">{names[1]}</span></h1>'
        + "".join(
            f'<p class="meta">{mesh.upper()}: {escape(summary[mesh]["path"])}</p>' for mesh in "ab"
        )
        + f'<p class="meta">{escape(made["date"][:16])} · {escape(made["by"])}</p></header>',
        f'<ul class="findings">{"".join(sentences)}</ul>',
        _meshes(summary),
        _overview(summary),
        '<section id="criteria"><h2>Criterion by criterion</h2>' if summary["criteria"] else "",
        *(_criterion(summary, c) for c in summary["criteria"]),
        "</section>" if summary["criteria"] else "",
        _footer(),
    ]
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{names[0]} and {names[1]}: mesh quality</title>\n<style>\n{style}</style>\n"
        '</head>\n<body>\n<nav aria-label="Contents"><a class="top" href="#top">Summary</a>'
        f'<a href="#overview">Overview</a><p>Criteria</p>{items}</nav>\n<main>\n'
        + "\n".join(part for part in body if part)
        + "\n</main>\n</body>\n</html>\n"
    )


def _is_worse(summary, c) -> bool:
    return c["name"] in summary["worse"]


def _meshes(summary) -> str:
    rows = []
    for key, label in (("cells", "cells"), ("points", "points"), ("boundary_faces", "boundary faces")):
        cells = "".join(f"<td>{text.count(summary[mesh][key], THIN)}</td>" for mesh in "ab")
        rows.append(f"<tr><td>{label}</td>{cells}</tr>")
    for key in ("volume", "area"):
        if any(summary[mesh][key] is not None for mesh in "ab"):
            cells = "".join(f"<td>{text.number(summary[mesh][key], 6)}</td>" for mesh in "ab")
            rows.append(f"<tr><td>total {key}</td>{cells}</tr>")
    types = {t["name"]: None for mesh in "ab" for t in summary[mesh]["cell_types"]}
    for name in types:
        counts = [
            {t["name"]: t["count"] for t in summary[mesh]["cell_types"]}.get(name, 0) for mesh in "ab"
        ]
        cells = "".join(f"<td>{text.count(n, THIN)}</td>" for n in counts)
        rows.append(f"<tr><td>{escape(name)}</td>{cells}</tr>")
    return (
        '<section id="overview"><h2>Meshes</h2><div class="scroll"><table class="overview"><thead>'
        '<tr><th></th><th><span class="a">A</span></th><th><span class="b">B</span></th></tr>'
        f'</thead><tbody>{"".join(rows)}</tbody></table></div>'
    )


def _overview(summary) -> str:
    if not summary["criteria"]:
        return "</section>"
    head = ["Criterion"]
    for label in ("Minimum", "Median", "Mean", "Maximum", "Outside, %"):
        head += [f"{label} A", "B"]
    head.append("Distance")
    if summary["same_cells"]:
        head += ["Better", "Worse", "Same"]
    rows = []
    for c in summary["criteria"]:
        cells = [f'<td><a href="#criterion-{escape(c["name"])}">{escape(c["label"])}</a></td>']
        for key in ("min", "median", "mean", "max"):
            cells += [f"<td>{text.number(c[mesh][key])}</td>" for mesh in "ab"]
        for mesh in "ab":
            bad = mesh == "b" and _is_worse(summary, c)
            value = text.number(c[mesh]["out_of_range_percent"], 3)
            cells.append(f'<td class="{"bad" if bad else ""}">{value}</td>')
        cells.append(f"<td>{text.number(c['distance'], 3)}</td>")
        if summary["same_cells"]:
            cells += [
                f"<td>{text.count(c[key], THIN)}</td>" for key in ("improved", "worsened", "unchanged")
            ]
        rows.append(f"<tr>{''.join(cells)}</tr>")
    return (
        '<h2>Overview</h2><div class="scroll"><table class="overview"><thead><tr>'
        + "".join(f"<th>{name}</th>" for name in head)
        + f'</tr></thead><tbody>{"".join(rows)}</tbody></table></div></section>'
    )


def _criterion(summary, c) -> str:
    unit = escape(text.UNIT_SYMBOLS.get(c["unit"], c["unit"]))
    rows = []
    labels = {
        "min": "Minimum",
        "p1": "1 % below",
        "median": "Median",
        "p99": "99 % below",
        "max": "Maximum",
        "mean": "Mean",
        "std_dev": "Standard deviation",
        "out_of_range_percent": "Outside, %",
        "null": "Null",
        "inf": "Infinite",
    }
    for key, label in labels.items():
        values = [c[mesh][key] for mesh in "ab"]
        if key in ("null", "inf") and not any(values) or values == [None, None]:
            continue
        cells = "".join(f"<td>{text.number(value)}</td>" for value in values)
        rows.append(f"<tr><td>{label}</td>{cells}</tr>")
    remarks = [BETTER[c["better"]]] if BETTER[c["better"]] else []
    if c["acceptable"] != [None, None]:
        source = f" ({escape(c['acceptable_source'])})" if c["acceptable_source"] else ""
        remarks.append(f"Acceptable {escape(text.interval(*c['acceptable'], c['unit']))}{source}")
    if c["distance"]:
        remarks.append(
            f"Distance {text.number(c['distance'], 3)}, at {text.number(c['distance_value'])}{unit}"
        )
    if c["same_cells"]:
        remarks.append(
            f"Of {text.plural(c['compared'], 'cell', THIN)} {text.count(c['improved'], THIN)} better, "
            f"{text.count(c['worsened'], THIN)} worse, {text.count(c['unchanged'], THIN)} the same"
        )
    badge = '<span class="badge bad">worse</span>' if _is_worse(summary, c) else ""
    return (
        f'<article id="criterion-{escape(c["name"])}"><div class="title"><h3>{escape(c["label"])}</h3>'
        f'<code>{escape(c["name"])}</code>{badge}</div>'
        f'<p class="description">{escape(c["description"])}</p>'
        f'<div class="columns">{svg.comparison(c)}<div class="statistics"><table><thead><tr><th></th>'
        '<th><span class="a">A</span></th><th><span class="b">B</span></th></tr></thead>'
        f'<tbody>{"".join(rows)}</tbody></table>'
        + (f"<p>{'. '.join(remarks)}.</p>" if remarks else "")
        + f"</div></div>{_groups(c)}</article>"
    )


def _groups(c) -> str:
    """A table of the groups, where there are any."""
    if not c["groups"]:
        return ""
    head = [""]
    for label in ("Cells", "Minimum", "Median", "Maximum", "Outside"):
        head += [f"{label} A", "B"]
    head.append("Distance")
    rows = []
    for group in c["groups"]:
        cells = [f"<td>{escape(group['group'])}</td>"]
        cells += [f"<td>{text.count(group[mesh]['count'], THIN)}</td>" for mesh in "ab"]
        for key in ("min", "median", "max"):
            cells += [f"<td>{text.number(group[mesh][key])}</td>" for mesh in "ab"]
        for mesh in "ab":
            is_limited = group[mesh]["out_of_range_percent"] is not None
            cells.append(f"<td>{text.count(group[mesh]['out_of_range'], THIN) if is_limited else ''}</td>")
        cells.append(f"<td>{text.number(group['distance'], 3)}</td>")
        rows.append(f"<tr>{''.join(cells)}</tr>")
    return (
        '<details><summary>Groups</summary><div class="scroll"><table class="worst groups"><thead><tr>'
        + "".join(f"<th>{name}</th>" for name in head)
        + f'</tr></thead><tbody>{"".join(rows)}</tbody></table></div></details>'
    )


def _footer() -> str:
    return (
        "<footer><p>Histograms have the same bins for both meshes and show shares of the cells with a "
        "value: B as bars, A as a line. <b>Distance</b>: the largest difference, over all x, of the shares "
        "of cells with values up to x (Kolmogorov and Smirnov); 0 for equal distributions, 1 for separate "
        "ones. <b>Outside</b>: of the acceptable range, in percent of the cells for which the criterion has "
        "a meaning. Cells are compared one by one where both meshes have the same cells; a value is "
        "better than none.</p><p>Beside this page: <code>summary.json</code> (all numbers).</p></footer>"
    )
