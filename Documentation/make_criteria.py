# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes Documentation/criteria.md from the registry: ./camaron shell pvpython Documentation/make_criteria.py"""

from pathlib import Path

from camaron import pipeline, tables, text

pipeline.load_plugin()

HEAD = """# Quality criteria

Made from the registry by `Documentation/make_criteria.py`; do not edit. Lengths, areas and volumes are in the
units of the mesh, angles in degrees unless chosen otherwise, solid angles in steradian. A value is null (NaN)
where the criterion has no meaning for the shape or is undefined, and infinite where it grows without bound.
*Better* says which end is good. An acceptable range marked *hint* is common practice, not a verdict.

| name | applies to | unit | range | ideal | better | acceptable | meaning |
| --- | --- | --- | --- | --- | --- | --- | --- |
"""


def number(value):
    return "" if value is None else text.number(value)


def row(c):
    low, high = c["range"]
    bounds = f"{number(low) or '-∞'} to {number(high) or '∞'}"
    acceptable = ""
    if c["acceptable"] != [None, None]:
        source = ("hint: " if c["acceptable_is_hint"] else "") + c["acceptable_source"]
        acceptable = f"{text.interval(*c['acceptable'], '')} ({source})"
    better = "" if c["better"] == "neither" else c["better"]
    return (
        f"| `{c['name']}` | {c['applies_to']} | {c['unit'] or '-'} | {bounds} | {number(c['ideal'])} "
        f"| {better} | {acceptable} | {c['description']} |"
    )


criteria = tables.known_criteria().values()
lines = [HEAD + "\n".join(map(row, criteria)), "", "## Presets", ""]
lines += ["A preset names criteria and their acceptable ranges.", ""]
for name, preset in tables.known_presets().items():
    lines += [f"**{name}**: {preset['description']}", ""]
    for criterion, limits in preset["rules"].items():
        limited = list(limits) != [None, None]
        lines.append(f"- `{criterion}`" + (f" {text.interval(*limits, '')}" if limited else ""))
    lines.append("")
Path(__file__).with_name("criteria.md").write_text("\n".join(lines).rstrip() + "\n")
