# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the table of formats in README.md from Readers/Formats.cmake, which the plugin contains:

./camaron shell pvpython Documentation/make_formats.py
"""

from pathlib import Path

from camaron.common import formats, pipeline

README = Path(__file__).resolve().parents[1] / "README.md"
BEGIN = "<!-- Made by Documentation/make_formats.py of Readers/Formats.cmake -->\n"
END = "<!-- end of the formats -->\n"


def table():
    lines = ["| format | files | reads | writes |", "| --- | --- | --- | --- |"]
    for f in formats.own_formats():
        cells = [
            f"[{f['description']}](Readers/{f['name']}/README.md)",
            " ".join(f"`.{extension}`" for extension in f["extensions"]),
            f["reads"] or "yes" if f["reader"] else "no",
            f["writes"] or "yes" if f["writer"] else "no",
        ]
        lines.append(f"| {' | '.join(cells)} |")
    lines.append("| everything ParaView reads and writes | | yes | yes |")
    return "\n".join(lines) + "\n"


def updated(page):
    """The page with the current table."""
    before, rest = page.split(BEGIN)
    _, after = rest.split(END)
    return before + BEGIN + table() + END + after


if __name__ == "__main__":
    pipeline.load_plugin()
    README.write_text(updated(README.read_text(encoding="utf-8")), encoding="utf-8")
