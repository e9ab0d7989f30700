# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command `camaron select`."""

from __future__ import annotations

import argparse

from ..common import arguments, console, text

HELP = """\
Selects elements of a mesh in steps, each a strategy of the filter Select Elements with its
properties, and writes the selection: a table (.csv), ids (.txt), a set for OpenFOAM (a name in a
folder "sets"), or a mesh of the cells in any format. Criteria named in a step are evaluated.

  camaron select part.visf --by 'By criterion: Array=MinDihedralAngle' -o bad.csv -o bad.vtu
  camaron select part.visf --by 'Worst N: Array=Volume' --by Expand -o case/constant/polyMesh/sets/bad
  camaron select part.visf --by 'Shape: Shape=Sphere; Center=0,0,1; Radius=0.3; Placement=Intersects'

Each step changes the selection of the previous step as its Combination specifies (Replace, Add,
Subtract, Intersect, Toggle, Refine). Documentation/selection.md lists the strategies and their
properties."""


def add_parser(commands: argparse._SubParsersAction) -> None:
    parser = commands.add_parser(
        "select",
        help="select elements and write lists, tables or meshes",
        description=HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("mesh", metavar="MESH", help="file that ParaView can open")
    parser.add_argument(
        "--by",
        action="append",
        required=True,
        metavar="STEP",
        help="strategy and properties: 'STRATEGY: NAME=VALUE; NAME=VALUE'; may be repeated",
    )
    parser.add_argument(
        "-o",
        "--output",
        action="append",
        default=[],
        metavar="FILE",
        help="file to write; may be repeated",
    )
    arguments.add_common(parser)
    parser.add_argument("--json", action="store_true", help="print JSON instead of lines")


def run(options: argparse.Namespace) -> int:
    from ..common.json_text import to_json
    from ..select_elements import select

    result = select(
        options.mesh,
        options.by,
        options.output,
        time=options.time,
        reader=dict(options.reader),
        strict=options.strict,
        say=console.complain,
    )
    if options.json:
        print(to_json(result))
        return 0
    noun = result["elements"].lower()
    for step in result["steps"]:
        print(f"{step['strategy']}: {step['selected']} {noun}")
    for line in result["notes"]:
        print(text.in_ascii(text.printable(line)))
    return 0
