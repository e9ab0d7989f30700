# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page that `inspect` writes: one HTML file that needs nothing from elsewhere."""

from __future__ import annotations

import base64
import shlex
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any, Optional, Sequence

from . import ranking, svg, text
from .text import THIN

BETTER = {"bigger": "larger is better", "smaller": "smaller is better", "neither": ""}

#: What a click on a bar fills in, see report.js.
PICK = (
    '<div class="pick" hidden><p><b class="bar"></b></p>'
    "<p>In ParaView's Find Data, on the mesh of this report:</p>"
    '<code class="query"></code><p>On the command line, as a table with their ids:</p>'
    '<code class="command"></code><p class="ids"></p></div>'
)


@dataclass
class Picture:
    """A PNG file with what to write below it."""

    path: Path
    title: str
    caption: str


def render(summary: dict[str, Any], pictures: Sequence[Picture] = ()) -> str:
    """The report as HTML. `summary` is what summary.json holds (see Documentation/inspect.md)."""
    style = (Path(__file__).parent / "report.css").read_text(encoding="utf-8")
    script = (Path(__file__).parent / "report.js").read_text(encoding="utf-8")
    path = escape(shlex.quote(summary["mesh"]["path"]), quote=True)
    name = escape(summary["mesh"]["name"])
    criteria = summary["criteria"]
    body = [
        _header(summary),
        _findings(summary),
        _facts(summary["mesh"]),
        _pictures(pictures),
        _overview(summary),
        '<section id="criteria"><h2>Criterion by criterion</h2>' if criteria else "",
        *(_criterion(c, number) for number, c in enumerate(criteria)),
        "</section>" if criteria else "",
        _footer(summary),
    ]
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{name}: mesh quality</title>\n<style>\n{style}</style>\n</head>\n<body>\n"
        f'<nav aria-label="Contents">{_navigation(summary, pictures)}</nav>\n<main data-mesh="{path}">\n'
        + "\n".join(part for part in body if part)
        + f"\n</main>\n<script>\n{script}</script>\n</body>\n</html>\n"
    )


def _anchor(name: str) -> str:
    return f"criterion-{escape(name)}"


def _navigation(summary, pictures) -> str:
    items = ['<a class="top" href="#top">Summary</a>']
    if pictures:
        items.append('<a href="#pictures">Pictures</a>')
    if summary["criteria"]:
        items.append('<a href="#overview">Overview</a><p>Criteria</p>')
    for c in summary["criteria"]:
        mark = '<i title="cells outside the acceptable range"></i>' if c["out_of_range"] else ""
        items.append(f'<a href="#{_anchor(c["name"])}">{escape(c["label"])}{mark}</a>')
    return "".join(items)


def _header(summary) -> str:
    mesh, made = summary["mesh"], summary["generated"]
    details = [escape(mesh["path"]), text.memory(mesh["file_size"])]
    if mesh["time"] is not None:
        details.append(
            f"time {text.number(mesh['time']['value'])}"
            f" (step {mesh['time']['step'] + 1} of {mesh['time']['steps']})"
        )
    return (
        '<header id="top"><p class="eyebrow">Mesh quality</p>'
        f"<h1>{escape(mesh['name'])}</h1>"
        f'<p class="meta">{" · ".join(d for d in details if d)}</p>'
        f'<p class="meta">{escape(made["date"][:16])} · {escape(made["by"])}</p></header>'
    )


def _findings(summary) -> str:
    items = []
    for finding in ranking.findings(summary):
        links = [
            f'<a href="#{_anchor(c["name"])}">{escape(c["label"])}</a>' for c in finding["criteria"]
        ]
        sentence = escape(finding["text"]).replace("{}", ", ".join(links))
        items.append(f'<li class="{"matters" if finding["matters"] else ""}">{sentence}</li>')
    items += [f'<li class="note">{escape(note)}</li>' for note in summary["notes"]]
    return f'<ul class="findings">{"".join(items)}</ul>'


def _tile(value: str, label: str, more: str = "") -> str:
    return (
        f"<div><b>{value}</b><span>{label}</span>{f'<small>{more}</small>' if more else ''}</div>"
    )


def _facts(mesh) -> str:
    types = ", ".join(
        f"{text.count(t['count'], THIN)}{THIN}{escape(t['name'])}" for t in mesh["cell_types"]
    )
    tiles = [
        _tile(text.count(mesh["cells"], THIN), "cells", types if len(mesh["cell_types"]) else ""),
        _tile(text.count(mesh["points"], THIN), "points"),
    ]
    if mesh["boundary_faces"]:
        tiles.append(_tile(text.count(mesh["boundary_faces"], THIN), "boundary faces"))
    for key, label in (("volume", "total volume"), ("area", "total area")):
        if mesh[key] is not None:
            tiles.append(_tile(text.number(mesh[key]), label))
    if mesh["bounds"]:
        low, high = mesh["bounds"][0::2], mesh["bounds"][1::2]
        size = " × ".join(text.number(b - a) for a, b in zip(low, high))
        corner = lambda p: "(" + ", ".join(text.number(x) for x in p) + ")"
        tiles.append(_tile(size, "bounding box", f"{corner(low)} to {corner(high)}"))
    tiles.append(_tile(text.memory(mesh["memory"]), "in memory"))
    if mesh["blocks"] > 1:
        tiles.append(_tile(str(mesh["blocks"]), "blocks"))
    return f'<section class="tiles">{"".join(tiles)}</section>'


def _pictures(pictures) -> str:
    if not pictures:
        return ""
    figures = []
    for picture in pictures:
        data = base64.b64encode(picture.path.read_bytes()).decode("ascii")
        figures.append(
            f'<figure><img src="data:image/png;base64,{data}" alt="{escape(picture.title)}">'
            f"<figcaption><b>{escape(picture.title)}</b> {escape(picture.caption)}</figcaption>"
            "</figure>"
        )
    return f'<section id="pictures" class="pictures">{"".join(figures)}</section>'


def _unit(unit: str) -> str:
    return escape(text.UNIT_SYMBOLS.get(unit, unit))


def _outside(c) -> str:
    """How many cells are outside the acceptable range, as a cell of the overview."""
    if not ranking.is_limited(c):
        return '<td class="none">–</td><td></td>'
    kind = "bad" if c["out_of_range"] else "fine"
    return (
        f'<td class="{kind}">{text.count(c["out_of_range"], THIN)}</td>'
        f'<td class="{kind}">{text.percent(c["out_of_range"], c["applicable"])}{THIN}%</td>'
    )


def _amount(amount: int) -> str:
    return f'<td class="{"bad" if amount else "none"}">{text.count(amount, THIN)}</td>'


def _overview(summary) -> str:
    criteria = summary["criteria"]
    if not criteria:
        return ""
    undefined = any(ranking.undefined_count(c) for c in criteria)
    infinite = any(c["inf"] for c in criteria)
    head = ["Criterion", "", "Minimum", "Median", "Mean", "Maximum", "Acceptable", "Outside", ""]
    if infinite:
        head.insert(2, "Infinite")
    if undefined:
        head.insert(2, "Null")
    rows = []
    for c in criteria:
        unit = f"<small>{_unit(c['unit'])}</small>" if c["unit"] else ""
        cells = [
            f'<td><a href="#{_anchor(c["name"])}">{escape(c["label"])}</a>{unit}</td>',
            f"<td>{svg.sparkline(c)}</td>",
        ]
        if undefined:
            cells.append(_amount(ranking.undefined_count(c)))
        if infinite:
            cells.append(_amount(c["inf"]))
        values = c["min"], c["quantiles"].get("50"), c["mean"], c["max"]
        cells += [f"<td>{text.number(value)}</td>" for value in values]
        cells.append(f'<td>{escape(text.interval(*c["acceptable"], c["unit"]))}</td>')
        cells.append(_outside(c))
        rows.append(f"<tr>{''.join(cells)}</tr>")
    headings = "".join(f"<th>{h}</th>" for h in head)
    return (
        '<section id="overview"><h2>Overview</h2><div class="scroll"><table class="overview">'
        f'<thead><tr>{headings}</tr></thead><tbody>{"".join(rows)}</tbody></table></div></section>'
    )


def _criterion(c, number) -> str:
    badge = ""
    if ranking.is_limited(c):
        badge = (
            f'<span class="badge bad">{text.plural(c["out_of_range"], "cell", THIN)} outside, '
            f'{text.percent(c["out_of_range"], c["applicable"])}{THIN}%</span>'
            if c["out_of_range"]
            else '<span class="badge">no cell outside</span>'
        )
    return (
        f'<article id="{_anchor(c["name"])}" data-criterion="{escape(c["name"])}"><div class="title"><h3>{escape(c["label"])}</h3>'
        f'<code>{escape(c["name"])}</code>{badge}</div>'
        f'<p class="description">{escape(c["description"])}</p>'
        f'<div class="columns"><div>{svg.histogram(c, f"inside-{number}")}{_legend(c)}{PICK}</div>'
        f"{_statistics(c)}</div>{_groups(c)}{_worst(c)}</article>"
    )


def _statistics(c) -> str:
    unit = _unit(c["unit"])
    suffix = unit if unit in ("", "°") else THIN + unit
    value = lambda x: text.number(x) + suffix if x is not None else ""
    quantile = lambda q: value(c["quantiles"].get(q))
    rows = [
        ("Minimum", value(c["min"])),
        ("1 % below", quantile("1")),
        ("25 % below", quantile("25")),
        ("Median", quantile("50")),
        ("75 % below", quantile("75")),
        ("99 % below", quantile("99")),
        ("Maximum", value(c["max"])),
        ("Mean", value(c["mean"])),
        ("Standard deviation", value(c["std_dev"])),
    ]
    if c["summable"]:
        rows.append(("Sum", value(c["sum"])))
    rows.append(("Cells", text.count(c["applicable"], THIN)))
    others = c["count"] - c["applicable"]
    if others:
        rows.append(("Of other shapes", text.count(others, THIN)))
    if ranking.undefined_count(c):
        rows.append(("Null", text.count(ranking.undefined_count(c), THIN)))
    if c["inf"]:
        rows.append(("Infinite", text.count(c["inf"], THIN)))
    remarks = []
    if BETTER[c["better"]]:
        remarks.append(BETTER[c["better"]])
    if c["ideal"] is not None:
        remarks.append(f"ideal {value(c['ideal'])}")
    if ranking.is_limited(c):
        source = ("a hint: " if c.get("acceptable_is_hint") else "") + escape(c["acceptable_source"])
        remarks.append(
            f"acceptable {escape(text.interval(*c['acceptable'], c['unit']))}"
            + (f" ({source})" if source else "")
        )
        if c["below"] and c["above"]:
            remarks.append(
                f"{text.count(c['below'], THIN)} below, {text.count(c['above'], THIN)} above"
            )
    items = "".join(f"<dt>{k}</dt><dd>{v}</dd>" for k, v in rows if v)
    sentence = "; ".join(remarks)
    return (
        f'<div class="statistics"><dl>{items}</dl>'
        + (f"<p>{sentence[0].upper()}{sentence[1:]}.</p>" if sentence else "")
        + "</div>"
    )


def _legend(c) -> str:
    if not c["histogram"]["counts"]:
        return ""
    words = ["Click a bar for the cells behind it."]
    curve = c.get("curve") or {"values": []}
    if len(curve["values"]) >= 3:
        volume = " (dashed: of the volume)" if curve["weight_percent"] else ""
        words.append(f"The line goes from 0 to 100 %: share of the cells{volume} up to a value.")
    return f'<p class="legend">{" ".join(words)}</p>'


def _groups(c) -> str:
    """A table of the groups, where there is more than one with values."""
    groups = [g for g in c.get("groups", []) if g["applicable"]]
    if len(groups) < 2:
        return ""
    rows = []
    for g in groups:
        values = "".join(f"<td>{text.number(g[k])}</td>" for k in ("min", "median", "mean", "max"))
        outside = ""
        if ranking.is_limited(c):
            kind = "bad" if g["out_of_range"] else "none"
            outside = (
                f'<td class="{kind}">{text.count(g["out_of_range"], THIN)}</td>'
                f'<td class="{kind}">{text.percent(g["out_of_range"], g["applicable"])}{THIN}%</td>'
            )
        rows.append(
            f"<tr><td>{escape(g['group'])}</td><td>{text.count(g['applicable'], THIN)}</td>"
            f"{values}{outside}</tr>"
        )
    head = "<th></th><th>Cells</th><th>Minimum</th><th>Median</th><th>Mean</th><th>Maximum</th>"
    head += "<th>Outside</th><th></th>" if ranking.is_limited(c) else ""
    return (
        '<details><summary>Groups</summary><div class="scroll"><table class="worst groups"><thead>'
        f'<tr>{head}</tr></thead><tbody>{"".join(rows)}</tbody></table></div></details>'
    )


def _worst(c) -> str:
    if not c["worst"]:
        return ""
    blocks = any(w["block"] is not None for w in c["worst"])
    low, high = c["acceptable"]
    rows = []
    for w in c["worst"]:
        x = w["value"]
        out = (low is not None and x < low) or (high is not None and x > high)
        place = "".join(f"<td>{text.number(p)}</td>" for p in w["center"])
        rows.append(
            f'<tr data-cell="{w["id"]}" data-value="{x!r}"><td>{w["rank"]}</td>'
            + (f"<td>{'' if w['block'] is None else w['block']}</td>" if blocks else "")
            + f"<td>{w['id']}</td><td>{escape(w['type'])}</td>"
            f'<td class="{"bad" if out else ""}">{text.number(x, 6)}</td>{place}</tr>'
        )
    head = "<th></th>" + ("<th>Block</th>" if blocks else "") + "<th>Cell</th><th>Type</th>"
    unit = f" ({_unit(c['unit'])})" if c["unit"] else ""
    return (
        f"<details{' open' if c['out_of_range'] else ''}><summary>Worst cells</summary>"
        f'<div class="scroll"><table class="worst"><thead><tr>{head}<th>Value{unit}</th>'
        f'<th>Centre x</th><th>y</th><th>z</th></tr></thead><tbody>{"".join(rows)}</tbody></table>'
        "</div></details>"
    )


def _footer(summary) -> str:
    mesh = summary["files"].get("mesh")
    beside = f", <code>{escape(mesh)}</code> (the mesh with one cell array for each criterion)" if mesh else ""
    return (
        "<footer><p><b>Acceptable</b> ranges are those of the sources named with each criterion; "
        "they are no verdict, what a mesh must satisfy depends on its use. "
        "<b>Null</b>: the value is undefined for the cell, for example 0/0. "
        "<b>Infinite</b>: the criterion has no bound and the cell is degenerate. "
        "Null and infinite values are in no mean, quantile or bin; infinite ones are outside a "
        "range. Cell numbers start at 0. Lengths, areas and volumes are in the units of the mesh."
        "</p><p>Beside this page: <code>summary.json</code> (all numbers), <code>worst.csv</code> "
        f"(worst cells){beside}.</p></footer>"
    )
