# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command `camaron compare`."""

from __future__ import annotations

import argparse
from pathlib import Path

from ..common import arguments, console, text

HELP = """\
Compares the quality of two meshes, A before and B after a change: prints a table and writes a
report with histograms over the same bins (report.html, summary.json). If both meshes have the same
cells, improved and worsened cells are counted. The exit status is 0, or 2 if a mesh cannot be read
or an option is invalid; with --fail-if-worse, it is 1 if B has a larger percentage of cells outside
an acceptable range than A.

  camaron compare before.visf after.visf
  camaron compare before.visf after.visf --preset 'Finite volume' --fail-if-worse"""


def add_parser(commands: argparse._SubParsersAction) -> None:
    parser = commands.add_parser(
        "compare",
        help="compare the quality of two meshes",
        description=HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("a", metavar="A", help="file that ParaView can open")
    parser.add_argument("b", metavar="B", help="file that ParaView can open")
    parser.add_argument(
        "-o", "--output", metavar="DIR", help="folder of the report; default: A-B-comparison"
    )
    arguments.add_criteria(parser)
    arguments.add_groups(parser, "none")
    arguments.add_common(parser)
    parser.add_argument(
        "--json", action="store_true", help="print the summary as JSON instead of the table"
    )
    parser.add_argument(
        "--fail-if-worse",
        action="store_true",
        help="exit with 1 if B has a larger percentage of cells outside an acceptable range",
    )


def run(options: argparse.Namespace) -> int:
    from .. import comparison
    from ..comparison import comparison_table
    from ..common.json_text import to_json

    stems = [Path(mesh).stem for mesh in (options.a, options.b)]
    folder = Path(options.output or "-".join([*stems, "comparison"]))
    summary = comparison.compare(
        options.a,
        options.b,
        folder,
        preset=options.preset,
        criteria=options.criteria or None,
        ranges=options.ranges,
        bins=options.bins,
        group_by=options.group_by,
        time=options.time,
        reader=dict(options.reader),
        strict=options.strict,
        say=console.complain,
    )
    if options.json:
        print(to_json(summary))
    else:
        print(comparison_table.describe(summary, console.wants_color()))
        print("\n" + text.printable(f"Report: {folder / 'report.html'}"))
    return 1 if options.fail_if_worse and summary["worse"] else 0
