# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The report of `inspect`: one self-contained HTML file."""

from __future__ import annotations

import base64
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional, Sequence

from ..checking.verdict_table import WORDS
from ..common import assessment, svg, text
from ..common.markup import Markup, html, raw
from ..common.text import THIN

BETTER = {"bigger": "larger is better", "smaller": "smaller is better", "neither": ""}

#: Filled in after a click on a bar, see report.js.
PICK = html(
    '<div class="pick" hidden><p><b class="bar"></b></p>'
    "<p>Query for ParaView's Find Data, for the mesh of this report:</p>"
    '<code class="query"></code><div class="select">'
    "<p>Command that writes these cells as a table with their ids:</p>"
    '<code class="command"></code></div><p class="ids"></p></div>'
)


@dataclass
class Picture:
    """A PNG file with its title and caption."""

    path: Path
    title: str
    caption: str


def render(summary: dict[str, Any], pictures: Sequence[Picture] = ()) -> str:
    """The report as HTML; `summary` has the contents of summary.json (see
    Documentation/inspect.md)."""
    criteria = summary["criteria"]
    body = [
        _header(summary),
        _checks(summary),
        _findings(summary),
        _facts(summary["mesh"]),
        _pictures(pictures),
        _overview(summary),
        html('<section id="criteria"><h2>Criterion by criterion</h2>') if criteria else None,
        *(_criterion(c, number) for number, c in enumerate(criteria)),
        html("</section>") if criteria else None,
        _footer(summary),
    ]
    return page(
        f"{summary['mesh']['name']}: mesh quality",
        _navigation(summary, pictures),
        html('<main data-mesh="{}">', text.shell_word(summary["mesh"]["path"] or "")),
        body,
        html("<script>\n{}</script>\n", raw(Path(__file__).parent / "report.js")),
    )


def page(
    title: str, navigation: Markup, main: Markup, body: Sequence[Optional[Markup]], script: Markup
) -> str:
    """A complete page; `main` is the opening tag of the element around `body`."""
    return html(
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n"
        '<nav aria-label="Contents">{}</nav>\n{}\n{}</main>\n{}</body>\n</html>\n',
        title,
        raw(Path(__file__).parent / "report.css"),
        navigation,
        main,
        [html("{}\n", part) for part in body if part],
        script,
    )


def link(c: dict[str, Any], more: Any = None) -> Markup:
    """A link to the section of a criterion."""
    return html('<a href="#criterion-{}">{}{}</a>', c["name"], c["label"], more)


def table_of(kind: str, head: Sequence[Any], rows: Sequence[Markup]) -> Markup:
    """A table that scrolls if it is too wide; `rows` are complete rows."""
    return html(
        '<div class="scroll"><table class="{}"><thead><tr>{}</tr></thead><tbody>{}</tbody></table></div>',
        kind,
        [html("<th>{}</th>", words) for words in head],
        rows,
    )


def _navigation(summary, pictures) -> Markup:
    items = [html('<a class="top" href="#top">Summary</a>')]
    if summary["checks"]:
        items.append(html('<a href="#rules">Rules</a>'))
    if pictures:
        items.append(html('<a href="#pictures">Pictures</a>'))
    if summary["criteria"]:
        items.append(html('<a href="#overview">Overview</a><p>Criteria</p>'))
    mark = html('<i title="cells outside the acceptable range"></i>')
    items += [link(c, mark if assessment.is_serious(c) else None) for c in summary["criteria"]]
    return html("{}", items)


def _header(summary) -> Markup:
    mesh, made = summary["mesh"], summary["generated"]
    details = [mesh["path"], text.memory(mesh["file_size"])]
    if mesh["time"] is not None:
        details.append(
            f"time {text.number(mesh['time']['value'])}"
            f" (step {mesh['time']['step'] + 1} of {mesh['time']['steps']})"
        )
    return html(
        '<header id="top"><p class="eyebrow">Mesh quality</p><h1>{}</h1>'
        '<p class="meta">{}</p><p class="meta">{} · {}</p></header>',
        mesh["name"],
        " · ".join(d for d in details if d),
        made["date"][:16],
        made["by"],
    )


def _checks(summary) -> Optional[Markup]:
    """The verdicts on the rules."""
    checks = summary["checks"]
    if not checks:
        return None
    kinds = {"fail": "bad", "warn": "hint", "pass": "fine"}
    rows = []
    for c in checks:
        cells = [
            html('<td class="{}">{}</td>', kinds.get(c["verdict"], "none"), WORDS[c["verdict"]]),
            html("<td><code>{}</code></td>", c["rule"]),
            html("<td>{}</td>", text.count(c["checked"], THIN)),
            html("<td>{}</td>", _share(c, c["failing"], c["checked"])),
            html("<td>{}</td>", c["tolerance"]),
            html("<td>{}</td>", text.number(c["worst_value"])),
            html("<td>{}</td>", c["worst"][0]["id"] if c["worst"] else ""),
        ]
        rows.append(html("<tr>{}</tr>", cells))
    head = ["", "Rule", "Checked", "Failing", "Tolerated", "Worst", "Id"]
    bad = summary["verdict"] == "fail"
    return html(
        '<section id="rules"><h2>Rules <span class="badge {}">{}</span></h2>{}</section>',
        "bad" if bad else "",
        WORDS[summary["verdict"]],
        table_of("rules", head, rows),
    )


def _findings(summary) -> Markup:
    found = assessment.findings(summary)
    first = [_finding(f, summary) for f in found if not f["hint"]]
    first += [html('<li class="note">{}</li>', note) for note in summary["notes"]]
    hints = [_finding(f, summary) for f in found if f["hint"]]
    folded = html(
        '<details class="hints"><summary>{}</summary><ul>{}</ul></details>',
        f"{text.plural(len(hints), 'hint')}: common practice that some meshes violate on purpose",
        hints,
    )
    return html('<div class="findings"><ul>{}</ul>{}</div>', first, folded if hints else None)


def _finding(finding, summary) -> Markup:
    """A sentence with links to its criteria, and the command that selects its cells."""
    before, _, after = finding["text"].partition("{}")
    links: list[Any] = []
    for c in finding["criteria"]:
        links += [", ", link(c)] if links else [link(c)]
    kind = "matters" if finding["matters"] and not finding["hint"] else ""
    selects = _selection(finding, summary)
    return html('<li class="{}">{}{}{}{}</li>', kind, before, links, after, selects)


def _selection(finding, summary) -> Optional[Markup]:
    """The command for the cells of a finding, folded."""
    mesh = summary["mesh"]["path"]
    if not mesh or not finding["selects"]:
        return None
    criterion = finding["criteria"][0]
    properties = {"Array": criterion["name"]}
    if finding["selects"] == "By criterion":
        properties.update(assessment.range_to_select(criterion, summary))
    step = f"{finding['selects']}: " + "; ".join(f"{n}={v}" for n, v in properties.items())
    return html(
        '<details class="select"><summary>Select these cells</summary><code>camaron select {} --by {} -o '
        "cells.csv</code></details>",
        text.shell_word(mesh),
        text.shell_word(step),
    )


def _tile(value: str, label: str, more: str = "") -> Markup:
    small = html("<small>{}</small>", more) if more else None
    return html("<div><b>{}</b><span>{}</span>{}</div>", value, label, small)


def _facts(mesh) -> Markup:
    types = ", ".join(
        f"{text.count(t['count'], THIN)}{THIN}{t['name']}" for t in mesh["cell_types"]
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
    return html('<section class="tiles">{}</section>', tiles)


def _pictures(pictures) -> Optional[Markup]:
    if not pictures:
        return None
    figures = [
        html(
            '<figure><img src="data:image/png;base64,{}" alt="{}">'
            "<figcaption><b>{}</b> {}</figcaption></figure>",
            base64.b64encode(picture.path.read_bytes()).decode("ascii"),
            picture.title,
            picture.title,
            picture.caption,
        )
        for picture in pictures
    ]
    return html('<section id="pictures" class="pictures">{}</section>', figures)


def _unit(unit: str) -> str:
    return text.UNIT_SYMBOLS.get(unit, unit)


def _share(c, part: int, whole: int) -> str:
    return f"{text.count(part, THIN)} ({text.percent(part, whole)}{THIN}%)" if part else "0"


def _outside(c) -> Markup:
    """The number of cells outside the acceptable range, as a cell of the overview."""
    if not assessment.is_limited(c):
        return html('<td class="none">–</td>')
    kind = "bad" if assessment.is_serious(c) else "hint" if c["out_of_range"] else "fine"
    return html('<td class="{}">{}</td>', kind, _share(c, c["out_of_range"], c["judged"]))


def _amount(amount: int) -> Markup:
    return html('<td class="{}">{}</td>', "" if amount else "none", text.count(amount, THIN))


def _overview(summary) -> Optional[Markup]:
    criteria = summary["criteria"]
    if not criteria:
        return None
    undefined = any(assessment.undefined_count(c) for c in criteria)
    infinite = any(c["infinite"] for c in criteria)
    head = ["Criterion", "", "Minimum", "Median", "Mean", "Maximum", "Acceptable", "Outside"]
    if infinite:
        head.insert(2, "Infinite")
    if undefined:
        head.insert(2, "Undefined")
    rows = []
    for c in criteria:
        unit = html("<small>{}</small>", _unit(c["unit"])) if c["unit"] else None
        cells = [html("<td>{}{}</td><td>{}</td>", link(c), unit, svg.sparkline(c))]
        if undefined:
            cells.append(_amount(assessment.undefined_count(c)))
        if infinite:
            cells.append(_amount(c["infinite"]))
        values = c["min"], c["quantiles"].get("50"), c["mean"], c["max"]
        cells += [html("<td>{}</td>", text.number(value)) for value in values]
        limits = text.interval(*c["acceptable"], c["unit"]) if assessment.is_limited(c) else ""
        cells += [html("<td>{}</td>", limits), _outside(c)]
        rows.append(html("<tr>{}</tr>", cells))
    return html(
        '<section id="overview"><h2>Overview</h2>{}</section>', table_of("overview", head, rows)
    )


def _badge(c) -> Optional[Markup]:
    if not assessment.is_limited(c):
        return None
    if not c["out_of_range"]:
        return html('<span class="badge">no cell outside</span>')
    return html(
        '<span class="badge {}">{} outside, {}{}%</span>',
        "bad" if assessment.is_serious(c) else "",
        text.plural(c["out_of_range"], "cell", THIN),
        text.percent(c["out_of_range"], c["judged"]),
        THIN,
    )


def _criterion(c, number) -> Markup:
    return html(
        '<article id="criterion-{name}" data-criterion="{name}"><div class="title"><h3>{}</h3>'
        '<code>{name}</code>{}</div><p class="description">{}</p>'
        '<div class="columns"><div>{}{}{}</div>{}</div>{}{}</article>',
        c["label"],
        _badge(c),
        c["description"],
        svg.histogram(c, f"inside-{number}"),
        _legend(c),
        PICK,
        _statistics(c),
        _groups(c),
        _worst(c),
        name=c["name"],
    )


def _statistics(c) -> Markup:
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
    if assessment.undefined_count(c):
        rows.append(("Undefined", text.count(assessment.undefined_count(c), THIN)))
    if c["infinite"]:
        rows.append(("Infinite", text.count(c["infinite"], THIN)))
    items = [html("<dt>{}</dt><dd>{}</dd>", label, words) for label, words in rows if words]
    sentence = "; ".join(_remarks(c, value))
    closing = html("<p>{}{}.</p>", sentence[0].upper(), sentence[1:]) if sentence else None
    return html('<div class="statistics"><dl>{}</dl>{}</div>', items, closing)


def _remarks(c, value) -> list[str]:
    """Remarks on the better direction, the acceptable range and its source, and the covered
    cells."""
    remarks = []
    if BETTER[c["better"]]:
        remarks.append(BETTER[c["better"]])
    if c["ideal"] is not None:
        remarks.append(f"ideal {value(c['ideal'])}")
    if c.get("of_vertices"):
        which = f"{c['of_vertices']} " if c["is_curved"] else ""
        remarks.append(f"of the vertices of {which}higher-order cells")
    limits = text.interval(*c["acceptable"], c["unit"])
    if limits and not assessment.is_limited(c):
        remarks.append(
            f"the range of {c['acceptable_source']} applies to {c['acceptable_for']} only"
        )
    elif limits:
        source = ("a hint: " if c["acceptable_is_hint"] else "") + c["acceptable_source"]
        remarks.append(f"acceptable {limits}" + (f" ({source})" if source else ""))
        if c["judged"] < c["applicable"]:
            judged = text.count(c["judged"], THIN)
            remarks.append(f"for {c['acceptable_for']}: {judged} of the cells")
        if c["below"] and c["above"]:
            remarks.append(
                f"{text.count(c['below'], THIN)} below, {text.count(c['above'], THIN)} above"
            )
    return remarks


def _legend(c) -> Optional[Markup]:
    if not c["histogram"]["counts"]:
        return None
    words = ["Click a bar to list its cells."]
    curve = c.get("curve") or {"values": []}
    if len(curve["values"]) >= 3:
        volume = " (dashed: of the volume)" if curve["weight_percent"] else ""
        words.append(
            f"The line shows the percentage of cells{volume} up to each value, from 0 to 100 %."
        )
    return html('<p class="legend">{}</p>', " ".join(words))


def _groups(c) -> Optional[Markup]:
    """A table of the groups, if more than one has values."""
    groups = [g for g in c.get("groups", []) if g["applicable"]]
    if len(groups) < 2:
        return None
    limited = assessment.is_limited(c)
    rows = []
    for g in groups:
        cells = [html("<td>{}</td><td>{}</td>", g["group"], text.count(g["applicable"], THIN))]
        values = (g[key] for key in ("min", "median", "mean", "max"))
        cells += [html("<td>{}</td>", text.number(value)) for value in values]
        if limited and g["judged"]:
            kind = "bad" if g["out_of_range"] and assessment.is_serious(c) else "none"
            outside = _share(c, g["out_of_range"], g["judged"])
            cells.append(html('<td class="{}">{}</td>', kind, outside))
        elif limited:
            cells.append(html('<td class="none">–</td>'))
        rows.append(html("<tr>{}</tr>", cells))
    head = ["", "Cells", "Minimum", "Median", "Mean", "Maximum", *(["Outside"] if limited else [])]
    return html(
        "<details><summary>Groups</summary>{}</details>", table_of("worst groups", head, rows)
    )


def _worst(c) -> Optional[Markup]:
    if not c["worst"]:
        return None
    blocks = any(w["block"] is not None for w in c["worst"])
    low, high = assessment.drawn_limits(c)
    rows = []
    for w in c["worst"]:
        x = w["value"]
        out = (low is not None and x < low) or (high is not None and x > high)
        rows.append(
            html(
                '<tr data-cell="{id}" data-value="{!r}"><td>{}</td>{}<td>{id}</td><td>{}</td>'
                '<td class="{}">{}</td>{}</tr>',
                x,
                w["rank"],
                html("<td>{}</td>", w["block"]) if blocks else None,
                w["type"],
                "bad" if out and assessment.is_serious(c) else "",
                text.number(x, 6),
                [html("<td>{}</td>", text.number(p)) for p in w["center"]],
                id=w["id"],
            )
        )
    head = [
        "",
        *(["Block"] if blocks else []),
        "Cell",
        "Type",
        text.with_unit("Value", c["unit"]),
        "Center x",
        "y",
        "z",
    ]
    is_open = html(" open") if assessment.is_serious(c) else None
    return html(
        "<details{}><summary>Worst cells</summary>{}</details>",
        is_open,
        table_of("worst", head, rows),
    )


def _footer(summary) -> Markup:
    mesh = summary["files"].get("mesh")
    return html(
        "<footer><p><b>Acceptable</b> ranges are taken from the source given with each criterion and apply "
        "to the cell shapes that the source covers; they are not a verdict, because the requirements on a "
        "mesh depend on its use. <b>Undefined</b>: the criterion has no value for the cell, for example 0/0. "
        "<b>Infinite</b>: the criterion is unbounded and the cell is degenerate. "
        "Undefined and infinite values do not contribute to means, quantiles and bins; infinite values are "
        "outside of a range. Cell numbers start at 0. Lengths, areas and volumes are in the units of the mesh."
        "</p><p>In the same folder: <code>summary.json</code> (all numbers), <code>worst.csv</code> "
        "(worst cells){}.</p></footer>",
        (
            html(", <code>{}</code> (the mesh with one cell array per criterion)", mesh)
            if mesh
            else None
        ),
    )
