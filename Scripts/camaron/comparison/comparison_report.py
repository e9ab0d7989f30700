# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The report of `compare`: one self-contained HTML file."""

from __future__ import annotations

from typing import Any, Optional

from ..common import svg, text
from ..common.markup import Markup, html
from ..common.text import THIN
from ..inspection.report import link, page, table_of
from . import comparison_table

BETTER = {"bigger": "Larger is better", "smaller": "Smaller is better", "neither": ""}
#: Headings of columns about each of the meshes.
A, B = html('<span class="a">A</span>'), html('<span class="b">B</span>')


def render(summary: dict[str, Any]) -> str:
    """The report as HTML; `summary` has the contents of summary.json (see
    Documentation/compare.md)."""
    mark = html('<i title="larger percentage of cells outside the acceptable range"></i>')
    navigation = html(
        '<a class="top" href="#top">Summary</a><a href="#overview">Overview</a><p>Criteria</p>{}',
        [link(c, mark if _is_worse(summary, c) else None) for c in summary["criteria"]],
    )
    names = [summary[mesh]["name"] for mesh in "ab"]
    sentences = [html("<li>{}</li>", s) for s in comparison_table.findings(summary)]
    sentences += [html('<li class="note">{}</li>', note) for note in summary["notes"]]
    criteria = [_criterion(summary, c) for c in summary["criteria"]]
    body = [
        _header(summary, names),
        html('<div class="findings"><ul>{}</ul></div>', sentences),
        html('<section id="overview">{}{}</section>', _meshes(summary), _overview(summary)),
        (
            html('<section id="criteria"><h2>Criterion by criterion</h2>{}</section>', criteria)
            if criteria
            else None
        ),
        _footer(),
    ]
    title = f"{names[0]} and {names[1]}: mesh quality"
    return page(title, navigation, html("<main>"), body, html(""))


def _header(summary, names) -> Markup:
    made = summary["generated"]
    paths = [
        html('<p class="meta">{}: {}</p>', mesh.upper(), summary[mesh]["path"]) for mesh in "ab"
    ]
    return html(
        '<header id="top"><p class="eyebrow">Mesh comparison</p>'
        '<h1><span class="a">{}</span> and <span class="b">{}</span></h1>{}'
        '<p class="meta">{} · {}</p></header>',
        *names,
        paths,
        made["date"][:16],
        made["by"],
    )


def _is_worse(summary, c) -> bool:
    return c["name"] in summary["worse"]


def _row(label: str, values) -> Markup:
    return html("<tr><td>{}</td>{}</tr>", label, [html("<td>{}</td>", value) for value in values])


def _meshes(summary) -> Markup:
    rows = []
    for key, label in (
        ("cells", "cells"),
        ("points", "points"),
        ("boundary_faces", "boundary faces"),
    ):
        rows.append(_row(label, (text.count(summary[mesh][key], THIN) for mesh in "ab")))
    for key in ("volume", "area"):
        if any(summary[mesh][key] is not None for mesh in "ab"):
            rows.append(_row(f"total {key}", (text.number(summary[mesh][key], 6) for mesh in "ab")))
    counts = {mesh: {t["name"]: t["count"] for t in summary[mesh]["cell_types"]} for mesh in "ab"}
    for name in {**counts["a"], **counts["b"]}:
        rows.append(_row(name, (text.count(counts[mesh].get(name, 0), THIN) for mesh in "ab")))
    return html("<h2>Meshes</h2>{}", table_of("overview", ["", A, B], rows))


def _overview(summary) -> Optional[Markup]:
    if not summary["criteria"]:
        return None
    head = ["Criterion"]
    for label in ("Minimum", "Median", "Mean", "Maximum", "Outside, %"):
        head += [f"{label} A", "B"]
    head.append("Distance")
    if summary["same_cells"]:
        head += ["Better", "Worse", "Same"]
    rows = []
    for c in summary["criteria"]:
        cells = [html("<td>{}</td>", link(c))]
        for key in ("min", "median", "mean", "max"):
            cells += [html("<td>{}</td>", text.number(c[mesh][key])) for mesh in "ab"]
        for mesh in "ab":
            bad = mesh == "b" and _is_worse(summary, c)
            value = text.number(c[mesh]["out_of_range_percent"], 3)
            cells.append(html('<td class="{}">{}</td>', "bad" if bad else "", value))
        cells.append(html("<td>{}</td>", text.number(c["distance"], 3)))
        if summary["same_cells"]:
            keys = ("improved", "worsened", "unchanged")
            cells += [html("<td>{}</td>", text.count(c[key], THIN)) for key in keys]
        rows.append(html("<tr>{}</tr>", cells))
    return html("<h2>Overview</h2>{}", table_of("overview", head, rows))


def _criterion(summary, c) -> Markup:
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
        "undefined": "Undefined",
        "infinite": "Infinite",
    }
    for key, label in labels.items():
        values = [c[mesh][key] for mesh in "ab"]
        if key in ("undefined", "infinite") and not any(values) or values == [None, None]:
            continue
        rows.append(_row(label, map(text.number, values)))
    remarks = ". ".join(_remarks(c))
    head = html("<th></th><th>{}</th><th>{}</th>", A, B)
    return html(
        '<article id="criterion-{name}"><div class="title"><h3>{}</h3><code>{name}</code>{}</div>'
        '<p class="description">{}</p><div class="columns">{}<div class="statistics">'
        "<table><thead><tr>{}</tr></thead><tbody>{}</tbody></table>{}</div></div>{}</article>",
        c["label"],
        html('<span class="badge bad">worse</span>') if _is_worse(summary, c) else None,
        c["description"],
        svg.comparison(c),
        head,
        rows,
        html("<p>{}.</p>", remarks) if remarks else None,
        _groups(c),
        name=c["name"],
    )


def _remarks(c) -> list[str]:
    unit = text.UNIT_SYMBOLS.get(c["unit"], c["unit"])
    remarks = [BETTER[c["better"]]] if BETTER[c["better"]] else []
    if comparison_table.is_limited(c):
        source = f" ({c['acceptable_source']})" if c["acceptable_source"] else ""
        remarks.append(f"Acceptable {text.interval(*c['acceptable'], c['unit'])}{source}")
    if c["distance"]:
        remarks.append(
            f"Distance {text.number(c['distance'], 3)}, at {text.number(c['distance_value'])}{unit}"
        )
    if c["same_cells"]:
        remarks.append(
            f"Of {text.plural(c['compared'], 'cell', THIN)} {text.count(c['improved'], THIN)} better, "
            f"{text.count(c['worsened'], THIN)} worse, {text.count(c['unchanged'], THIN)} the same"
        )
    return remarks


def _groups(c) -> Optional[Markup]:
    """A table of the groups, if there are any."""
    if not c["groups"]:
        return None
    head = [""]
    for label in ("Cells", "Minimum", "Median", "Maximum", "Outside"):
        head += [f"{label} A", "B"]
    head.append("Distance")
    rows = []
    for group in c["groups"]:
        values = [text.count(group[mesh]["count"], THIN) for mesh in "ab"]
        for key in ("min", "median", "max"):
            values += [text.number(group[mesh][key]) for mesh in "ab"]
        for mesh in "ab":
            is_limited = group[mesh]["out_of_range_percent"] is not None
            values.append(text.count(group[mesh]["out_of_range"], THIN) if is_limited else "")
        rows.append(_row(group["group"], [*values, text.number(group["distance"], 3)]))
    return html(
        "<details><summary>Groups</summary>{}</details>", table_of("worst groups", head, rows)
    )


def _footer() -> Markup:
    return html(
        "<footer><p>Histograms have the same bins for both meshes and show percentages of the cells with a "
        "value: B as bars, A as a line. <b>Distance</b>: the largest difference, over all x, between the "
        "fractions of cells with values up to x (Kolmogorov-Smirnov distance); 0 for equal distributions, 1 "
        "for disjoint ones. <b>Outside</b>: cells outside the acceptable range, in percent of the cells "
        "that the range covers. Cells are compared one by one if both meshes have the same cells; a "
        "defined value is better than an undefined one.</p><p>In the same folder: <code>summary.json</code> "
        "(all numbers).</p></footer>"
    )
