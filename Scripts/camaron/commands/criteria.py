# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command `camaron criteria`."""

from __future__ import annotations

import argparse

from ..common import text


def add_parser(commands: argparse._SubParsersAction) -> None:
    parser = commands.add_parser("criteria", help="list the criteria and presets")
    parser.add_argument(
        "names", nargs="*", metavar="NAME", help="show only these, with their descriptions"
    )


def run(options: argparse.Namespace) -> int:
    from ..common import pipeline, tables

    pipeline.load_plugin()
    known = tables.known_criteria()
    if not options.names:
        rows = [
            [
                c["name"],
                c["unit"],
                text.in_ascii(text.interval(*c["acceptable"])),
                c["applies_to"],
                c["label"],
            ]
            for c in known.values()
        ]
        print("\n".join(text.table(["criterion", "unit", "acceptable", "of", ""], rows, left=5)))
        presets = [[name, ", ".join(p["rules"])] for name, p in tables.known_presets().items()]
        print("\n" + "\n".join(text.table(["preset", "criteria"], presets, left=2)))
        return 0
    notes = tables.known_notes()
    for name in options.names:
        c = known[text.lookup(name, list(known), "criterion")]
        print(f"{c['name']}: {c['label']}, of {c['applies_to']}\n  {c['description']}")
        if c["acceptable_source"]:
            limits = text.in_ascii(text.interval(*c["acceptable"], c["unit"]))
            shapes = "" if c["acceptable_for"] == c["applies_to"] else f" of {c['acceptable_for']}"
            print(f"  acceptable {limits}{shapes} ({c['acceptable_source']})")
        print(
            f"  {notes[c['name']]['formula']}\n  Degenerate cells: {notes[c['name']]['degenerate']}"
        )
    return 0
