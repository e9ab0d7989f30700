# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command `camaron check`."""

from __future__ import annotations

import argparse
import os
import sys
from datetime import datetime

from ..common import arguments, console
from . import ERROR

HELP = """\
Checks meshes against rules and lists violations with the failing cells; use it in meshing scripts
and continuous integration. The exit status is 0 if no mesh violates a rule (rules that are only
hints warn), 1 if a mesh does, and 2 if a mesh cannot be read or a rule is invalid.

  camaron check part.visf --rules fem.rules
  camaron check part.visf --rule 'Volume > 0' --preset 'Finite volume' --tolerate 0.1%
  camaron check *.vtu --rules fem.rules --junit check.xml --json > check.json

A rule is a line such as

  MinDihedralAngle >= 10 of tetrahedra tolerate 0.1%   # at most one in a thousand

Documentation/check.md describes rules in full."""

#: Exit status, by the verdict on all meshes.
EXIT_STATUS = {"pass": 0, "warn": 0, "fail": 1, "error": ERROR}


def add_parser(commands: argparse._SubParsersAction) -> None:
    parser = commands.add_parser(
        "check",
        help="check meshes against rules",
        description=HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("meshes", nargs="+", metavar="MESH", help="file that ParaView can open")
    parser.add_argument(
        "--rules",
        action="append",
        default=[],
        metavar="FILE",
        help="file of rules, or - for standard input; may be repeated",
    )
    parser.add_argument(
        "--rule",
        action="append",
        default=[],
        metavar="RULE",
        help="rule such as 'Volume > 0'; may be repeated",
    )
    parser.add_argument("--preset", metavar="P", help="also the acceptable ranges of a preset")
    parser.add_argument(
        "--tolerate",
        metavar="AMOUNT",
        help="tolerance of rules that specify none: 0.1%%, or a number of cells (0)",
    )
    parser.add_argument(
        "--worst",
        type=arguments.positive,
        default=5,
        metavar="N",
        help="number of failing cells to list (%(default)s)",
    )
    arguments.add_common(parser)
    parser.add_argument("--json", action="store_true", help="print JSON instead of tables")
    parser.add_argument("--junit", metavar="FILE", help="also write a report for CI servers")


def run(options: argparse.Namespace) -> int:
    from .. import checking
    from ..checking import junit, verdict_table
    from ..common.inputs import Inputs
    from ..common.json_text import to_json

    inputs = Inputs(*options.meshes, *filter(os.path.isfile, options.rules))
    if options.junit:
        inputs.refuse(options.junit)
    file, more = checking.named_rules(options.rules, options.rule)
    if file is None and not more and options.preset is None:
        raise ValueError("expected --rules FILE, --rule RULE or --preset P")
    rules = checking.read_rules(file, options.preset, options.tolerate, more)
    started = datetime.now()
    results = []
    for mesh in options.meshes:
        try:
            result = checking.check(
                mesh,
                rules,
                worst=options.worst,
                time=options.time,
                reader=dict(options.reader),
                strict=options.strict,
                say=lambda words: console.complain(f"{mesh}: {words}"),
                inputs=inputs,
            )
        except (ValueError, RuntimeError, OSError, MemoryError) as error:
            console.complain(console.reason(error, mesh))
            result = checking.failed_to_check(mesh, console.reason(error, mesh))
        else:
            if not options.json:
                print(
                    ("\n" if results else "")
                    + verdict_table.describe(result, console.wants_color())
                )
                sys.stdout.flush()
        results.append(result)
    verdict = checking.worst_verdict(results)
    if options.json:
        print(to_json(checking.summary(results, options.rules, options.rule, rules.preset)))
    if options.junit:
        junit.write(options.junit, results, started, inputs)
    return EXIT_STATUS[verdict]
