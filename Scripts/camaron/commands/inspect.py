# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command `camaron inspect`."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path
from typing import Sequence

from ..common import arguments, console, text
from . import ERROR

HELP = """\
Reads meshes, evaluates their quality and writes a report for each: report.html (one file with
histograms, worst cells and pictures), summary.json (all numbers), worst.csv, and the mesh with one
cell array per criterion.

  camaron inspect part.visf
  camaron inspect part.visf --preset 'FEM tetrahedra' -o part-quality
  camaron inspect part.visf --criteria Volume,MinDihedralAngle --ranks 4
  camaron inspect part.visf --ranges solver.txt"""


def add_parser(commands: argparse._SubParsersAction) -> None:
    parser = commands.add_parser(
        "inspect",
        help="evaluate the quality of meshes and write reports",
        description=HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("meshes", nargs="+", metavar="MESH", help="file that ParaView can open")
    parser.add_argument(
        "-o", "--output", metavar="DIR", help="folder of the report; default: NAME-report"
    )
    arguments.add_criteria(parser)
    parser.add_argument(
        "--worst",
        type=arguments.positive,
        default=10,
        metavar="N",
        help="number of worst cells to list (%(default)s)",
    )
    arguments.add_groups(parser, "type")
    arguments.add_common(parser)
    parser.add_argument(
        "--json", action="store_true", help="print the summary as JSON instead of the table"
    )
    parser.add_argument("--no-pictures", action="store_true", help="omit the pictures")
    parser.add_argument(
        "--pictures",
        type=int,
        choices=range(4),
        default=3,
        metavar="N",
        help="only the first N of the three pictures: the mesh, its worst cells, the worst cell",
    )
    parser.add_argument(
        "--no-mesh", action="store_true", help="omit the mesh with the arrays of the criteria"
    )
    parser.add_argument("--verbose", action="store_true", help="report the time of each stage")


def run(options: argparse.Namespace) -> int:
    from ..common.inputs import Inputs
    from ..common.json_text import to_json
    from ..common.stages import Progress, Stages
    from ..inspection import inspect, summary_table

    inputs = Inputs(*options.meshes)
    folders = _report_folders(options.meshes, options.output)
    Stages(console.complain, options.verbose).started()
    status = 0
    for number, (mesh, folder) in enumerate(zip(options.meshes, folders)):
        try:
            with console.StatusLine() as line, Progress(
                lambda words: line.show(f"{mesh}: {words}")
            ) as progress:
                summary = inspect(
                    mesh,
                    folder,
                    preset=options.preset,
                    criteria=options.criteria or None,
                    ranges=options.ranges,
                    worst=options.worst,
                    bins=options.bins,
                    group_by=options.group_by,
                    time=options.time,
                    reader=dict(options.reader),
                    strict=options.strict,
                    with_pictures=not options.no_pictures,
                    most_pictures=options.pictures,
                    with_mesh=not options.no_mesh,
                    verbose=options.verbose,
                    say=lambda words: (line.clear(), console.complain(f"{mesh}: {words}")),
                    progress=progress,
                    inputs=inputs,
                )
        except (RuntimeError, OSError, MemoryError) as error:
            console.complain(console.reason(error, mesh))
            status = ERROR  # the other meshes still get their reports
            continue
        if options.json:
            print(to_json(summary))
        else:
            print(("\n" if number else "") + summary_table.describe(summary, console.wants_color()))
            print("\n" + text.printable(f"Report: {Path(folder) / 'report.html'}"))
        sys.stdout.flush()
    return status


def _report_folders(meshes: Sequence[str], output: str | None) -> list[Path]:
    """One folder per mesh: NAME-report in the current folder, DIR, or DIR/NAME for several
    meshes."""
    stems = [Path(mesh).stem for mesh in meshes]
    names = [
        stem if stems.count(stem) == 1 else str(Path(mesh)).strip("/").replace(os.sep, "-")
        for stem, mesh in zip(stems, meshes)
    ]
    if output is None:
        return [Path(f"{name}-report") for name in names]
    return [Path(output)] if len(names) == 1 else [Path(output) / name for name in names]
