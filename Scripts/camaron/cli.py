# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line: parses arguments, prints tables and one-line errors."""

from __future__ import annotations

import argparse
import os
import shutil
import sys
import time
from datetime import datetime
from pathlib import Path
from typing import Any, Sequence

from .common import assessment, text

ERROR = 2
#: Exit status of `check`, by the verdict on all meshes.
EXIT_STATUS = {"pass": 0, "warn": 0, "fail": 1, "error": ERROR}

INSPECT_HELP = """\
Reads meshes, evaluates their quality and writes a report for each: report.html (one file with
histograms, worst cells and pictures), summary.json (all numbers), worst.csv, and the mesh with one
cell array per criterion.

  camaron inspect part.visf
  camaron inspect part.visf --preset 'FEM tetrahedra' -o part-quality
  camaron inspect part.visf --criteria Volume,MinDihedralAngle --ranks 4
  camaron inspect part.visf --ranges solver.txt"""

CHECK_HELP = """\
Checks meshes against rules and lists violations with the failing cells; use it in meshing scripts
and continuous integration. The exit status is 0 if no mesh violates a rule (rules that are only
hints warn), 1 if a mesh does, and 2 if a mesh cannot be read or a rule is invalid.

  camaron check part.visf --rules fem.rules
  camaron check part.visf --preset 'Finite volume' --tolerate 0.1%
  camaron check *.vtu --rules fem.rules --junit check.xml --json > check.json

A rule is a line such as

  MinDihedralAngle >= 10 of tetrahedra tolerate 0.1%   # at most one in a thousand

Documentation/check.md describes rules in full."""

COMPARE_HELP = """\
Compares the quality of two meshes, A before and B after a change: prints a table and writes a
report with histograms over the same bins (report.html, summary.json). If both meshes have the same
cells, improved and worsened cells are counted. The exit status is 0, or 2 if a mesh cannot be read
or an option is invalid; with --fail-if-worse, it is 1 if B has a larger percentage of cells outside
an acceptable range than A.

  camaron compare before.visf after.visf
  camaron compare before.visf after.visf --preset 'Finite volume' --fail-if-worse"""

SELECT_HELP = """\
Selects elements of a mesh in steps, each a strategy of the filter Select Elements with its
properties, and writes the selection: a table (.csv), ids (.txt), a set for OpenFOAM (a name in a
folder "sets"), or a mesh of the cells in any format. Criteria named in a step are evaluated.

  camaron select part.visf --by 'By criterion: Array=MinDihedralAngle' -o bad.csv -o bad.vtu
  camaron select part.visf --by 'Worst N: Array=Volume' --by Expand -o case/constant/polyMesh/sets/bad
  camaron select part.visf --by 'Shape: Shape=Sphere; Center=0,0,1; Radius=0.3; Placement=Intersects'

Each step changes the selection of the previous step as its Combination specifies (Replace, Add,
Subtract, Intersect, Toggle, Refine). Documentation/selection.md lists the strategies and their
properties."""

CONVERT_HELP = """\
Writes a mesh in another format, given by the extension of OUT. Each format has further options,
which are listed below with their defaults; on/off options need no value. File names that begin with
a dash must follow --.

  camaron convert part.visf part.vtu --compressor-type lz4
  camaron convert part.vtu part.visf --encoding binary-little-endian
  camaron convert part.cas part.tri --unsupported-cells convert"""


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="camaron", description="Quality of polygonal and polyhedral meshes."
    )
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    style = argparse.RawDescriptionHelpFormatter

    inspect = commands.add_parser(
        "inspect",
        help="evaluate the quality of meshes and write reports",
        description=INSPECT_HELP,
        formatter_class=style,
    )
    inspect.add_argument("meshes", nargs="+", metavar="MESH", help="file that ParaView can open")
    inspect.add_argument(
        "-o", "--output", metavar="DIR", help="folder of the report; default: NAME-report"
    )
    _add_criteria(inspect)
    inspect.add_argument(
        "--worst",
        type=_positive,
        default=10,
        metavar="N",
        help="number of worst cells to list (%(default)s)",
    )
    _add_groups(inspect, "type")
    _add_common(inspect)
    inspect.add_argument(
        "--json", action="store_true", help="print the summary as JSON instead of the table"
    )
    inspect.add_argument("--no-pictures", action="store_true", help="omit the pictures")
    inspect.add_argument(
        "--pictures",
        type=int,
        choices=range(4),
        default=3,
        metavar="N",
        help="only the first N of the three pictures: the mesh, its worst cells, the worst cell",
    )
    inspect.add_argument(
        "--no-mesh", action="store_true", help="omit the mesh with the arrays of the criteria"
    )
    inspect.add_argument("--verbose", action="store_true", help="report the time of each stage")

    check = commands.add_parser(
        "check",
        help="check meshes against rules",
        description=CHECK_HELP,
        formatter_class=style,
    )
    check.add_argument("meshes", nargs="+", metavar="MESH", help="file that ParaView can open")
    which = check.add_mutually_exclusive_group(required=True)
    which.add_argument("--rules", metavar="FILE", help="file of rules")
    which.add_argument("--preset", metavar="P", help="the acceptable ranges of a preset")
    check.add_argument(
        "--tolerate",
        metavar="AMOUNT",
        help="tolerance of rules that specify none: 0.1%%, or a number of cells (0)",
    )
    check.add_argument(
        "--worst",
        type=_positive,
        default=5,
        metavar="N",
        help="number of failing cells to list (%(default)s)",
    )
    _add_common(check)
    check.add_argument("--json", action="store_true", help="print JSON instead of tables")
    check.add_argument("--junit", metavar="FILE", help="also write a report for CI servers")

    compare = commands.add_parser(
        "compare",
        help="compare the quality of two meshes",
        description=COMPARE_HELP,
        formatter_class=style,
    )
    compare.add_argument("a", metavar="A", help="file that ParaView can open")
    compare.add_argument("b", metavar="B", help="file that ParaView can open")
    compare.add_argument(
        "-o", "--output", metavar="DIR", help="folder of the report; default: A-B-comparison"
    )
    _add_criteria(compare)
    _add_groups(compare, "none")
    _add_common(compare)
    compare.add_argument(
        "--json", action="store_true", help="print the summary as JSON instead of the table"
    )
    compare.add_argument(
        "--fail-if-worse",
        action="store_true",
        help="exit with 1 if B has a larger percentage of cells outside an acceptable range",
    )

    convert = commands.add_parser(
        "convert",
        help="convert a mesh to another format",
        usage="camaron convert [OPTION...] IN OUT",
        description=CONVERT_HELP,
        formatter_class=style,
        add_help=False,
    )
    convert.add_argument(
        "-h",
        "--help",
        action=_FormatsHelp,
        help="show this help with all formats and their options",
    )
    convert.add_argument("source", metavar="IN", help="file that ParaView can open")
    convert.add_argument("target", metavar="OUT", help="file to write")
    _add_common(convert)

    select = commands.add_parser(
        "select",
        help="select elements and write lists, tables or meshes",
        description=SELECT_HELP,
        formatter_class=style,
    )
    select.add_argument("mesh", metavar="MESH", help="file that ParaView can open")
    select.add_argument(
        "--by",
        action="append",
        required=True,
        metavar="STEP",
        help="strategy and properties: 'STRATEGY: NAME=VALUE; NAME=VALUE'; may be repeated",
    )
    select.add_argument(
        "-o",
        "--output",
        action="append",
        default=[],
        metavar="FILE",
        help="file to write; may be repeated",
    )
    _add_common(select)
    select.add_argument("--json", action="store_true", help="print JSON instead of lines")

    criteria = commands.add_parser("criteria", help="list the criteria and presets")
    criteria.add_argument(
        "names", nargs="*", metavar="NAME", help="show only these, with their descriptions"
    )
    return parser


class _FormatsHelp(argparse.Action):
    """Prints the help of a command and the formats, which are only known once ParaView runs."""

    def __init__(self, option_strings, dest, help=None):
        super().__init__(option_strings, argparse.SUPPRESS, nargs=0, help=help)

    def __call__(self, parser, namespace, values, option_string=None):
        from .common import formats, pipeline

        pipeline.load_plugin()
        print(f"{parser.format_help()}\n{formats.describe_formats()}")
        parser.exit()


def _add_criteria(parser: argparse.ArgumentParser) -> None:
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--preset", metavar="P", help="criteria and acceptable ranges of a preset")
    which.add_argument(
        "--criteria",
        metavar="A,B",
        help="names of criteria, or all; default: those of the preset General",
    )
    parser.add_argument(
        "--ranges",
        metavar="FILE",
        help="file of acceptable ranges, with lines of: criterion lowest highest",
    )
    parser.add_argument(
        "--bins",
        type=_positive,
        default=50,
        metavar="N",
        help="number of histogram bins (%(default)s)",
    )


def _add_groups(parser: argparse.ArgumentParser, default: str) -> None:
    parser.add_argument(
        "--group-by",
        default=default,
        metavar="WHAT",
        help="also evaluate groups of cells by type, block, none or a cell array (%(default)s)",
    )


def _add_common(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--time",
        default="last",
        metavar="STEP",
        help="time step: first, last or its number (%(default)s)",
    )
    parser.add_argument("--ranks", type=_positive, metavar="N", help="number of MPI ranks")


def _positive(argument: str) -> int:
    number = int(argument)
    if number < 1:
        raise ValueError
    return number


_positive.__name__ = "positive number"  # argparse says "invalid positive number value"


def main(arguments: Sequence[str]) -> int:
    """Runs the command and returns its exit status: 0 done, 1 failed check, 2 error, 130
    interrupted."""
    parser = _parser()
    rest: list[str] = []
    if list(arguments[:1]) == ["convert"]:
        arguments, rest = _split_writer_options(arguments)
    options = argparse.Namespace()
    try:
        options = parser.parse_args(arguments)
        status = COMMANDS[options.command](options, rest)
        sys.stdout.flush()
        return status
    except KeyboardInterrupt:
        return 130
    except BrokenPipeError:  # of `camaron ... | head`
        _close_output()
        return 0
    except (ValueError, RuntimeError, OSError, MemoryError) as error:
        if isinstance(error, OSError) and error.strerror and not error.filename:
            _close_output()  # its disk is full
        # All problems of rules, one per line, or a single reason.
        _complain(*getattr(error, "problems", [_reason(error, *_meshes(options))]))
        return ERROR


def _close_output() -> None:
    """Discards all further output, which has no reader or no space left."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.__stdout__.fileno())


def _meshes(options: argparse.Namespace) -> list[str]:
    """The meshes in the arguments of a command."""
    found = [
        getattr(options, name) for name in ("mesh", "a", "b", "source") if hasattr(options, name)
    ]
    return found + getattr(options, "meshes", [])


def _complain(*reasons: str) -> None:
    """Prints each reason on a line of standard error."""
    for reason in reasons:
        print(f"camaron: {text.printable(reason)}", file=sys.stderr, flush=True)


def _reason(error: Exception, *meshes: str) -> str:
    """The reason of an error, after the name of its file; `meshes` are named when memory runs
    out."""
    if isinstance(error, MemoryError):
        return f"{', '.join(meshes) or 'camaron'}: out of memory"
    if isinstance(error, OSError) and error.strerror:
        return f"{error.filename or 'standard output'}: {error.strerror}"
    # Readers and writers refer to options by their labels in the window.
    return str(error).replace("Unsupported Cells", "--unsupported-cells")


class _StatusLine:
    """A line at the bottom of a terminal that is replaced by the next one; no output without a
    terminal."""

    #: Seconds before the line is shown.
    WAIT = 3.0

    def __init__(self):
        self.began, self.is_there = time.monotonic(), False

    def __enter__(self) -> _StatusLine:
        return self

    def __exit__(self, kind, error, trace) -> None:
        self.clear()

    def show(self, words: str) -> None:
        if not sys.stderr.isatty() or time.monotonic() - self.began < self.WAIT:
            return
        width = shutil.get_terminal_size().columns - 1
        print(f"\r\x1b[K{text.printable(words)[:width]}", end="", file=sys.stderr, flush=True)
        self.is_there = True

    def clear(self) -> None:
        if self.is_there:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)
        self.is_there = False


def _check_ranks(wanted: int | None) -> None:
    from .common import pipeline

    running = pipeline.rank_count()
    if wanted and wanted != running:
        raise RuntimeError(
            f"--ranks {wanted}, but this program runs on {text.plural(running, 'rank')}: "
            f"start it with the command camaron, or with mpiexec -n {wanted} pvbatch"
        )


def _inspect(options: argparse.Namespace, _rest: list[str]) -> int:
    from .inspection import inspect
    from .common.json_text import to_json
    from .common.stages import Progress, Stages

    _check_ranks(options.ranks)
    folders = _report_folders(options.meshes, options.output)
    Stages(_complain, options.verbose).started()
    status = 0
    for number, (mesh, folder) in enumerate(zip(options.meshes, folders)):
        try:
            with _StatusLine() as line, Progress(
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
                    with_pictures=not options.no_pictures,
                    most_pictures=options.pictures,
                    with_mesh=not options.no_mesh,
                    verbose=options.verbose,
                    say=lambda words: (line.clear(), _complain(f"{mesh}: {words}")),
                    progress=progress,
                )
        except (RuntimeError, OSError, MemoryError) as error:
            _complain(_reason(error, mesh))
            status = ERROR  # the other meshes still get their reports
            continue
        if options.json:
            print(to_json(summary))
        else:
            print(("\n" if number else "") + describe(summary, _wants_color()))
            print("\n" + text.printable(f"Report: {Path(folder) / 'report.html'}"))
        sys.stdout.flush()
    return status


def _check(options: argparse.Namespace, _rest: list[str]) -> int:
    from . import checking
    from .checking import junit, verdict_table
    from .common.json_text import to_json

    _check_ranks(options.ranks)
    rules = checking.read_rules(options.rules, options.preset, options.tolerate)
    started = datetime.now()
    results = []
    for mesh in options.meshes:
        try:
            result = checking.check(
                mesh,
                rules,
                worst=options.worst,
                time=options.time,
                say=lambda words: _complain(f"{mesh}: {words}"),
            )
        except (ValueError, RuntimeError, OSError, MemoryError) as error:
            _complain(_reason(error, mesh))
            result = checking.failed_to_check(mesh, _reason(error, mesh))
        else:
            if not options.json:
                print(("\n" if results else "") + verdict_table.describe(result, _wants_color()))
                sys.stdout.flush()
        results.append(result)
    verdict = checking.worst_verdict(results)
    if options.json:
        preset = options.preset and rules[0].preset
        print(to_json(checking.summary(results, options.rules, preset)))
    if options.junit:
        junit.write(options.junit, results, started)
    return EXIT_STATUS[verdict]


def _compare(options: argparse.Namespace, _rest: list[str]) -> int:
    from . import comparison
    from .comparison import comparison_table
    from .common.json_text import to_json

    _check_ranks(options.ranks)
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
        say=_complain,
    )
    if options.json:
        print(to_json(summary))
    else:
        print(comparison_table.describe(summary, _wants_color()))
        print("\n" + text.printable(f"Report: {folder / 'report.html'}"))
    return 1 if options.fail_if_worse and summary["worse"] else 0


def _wants_color() -> bool:
    """Whether to print lines in red; under mpiexec, every program seems to have a terminal."""
    from .common import pipeline

    return sys.stdout.isatty() and "NO_COLOR" not in os.environ and pipeline.rank_count() == 1


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


def describe(summary: dict[str, Any], color: bool = False) -> str:
    """The summary as text: facts about the mesh, one line per criterion, and the findings."""
    summary = text.all_printable(summary)
    mesh, criteria = summary["mesh"], summary["criteria"]
    types = ", ".join(f"{t['count']} {t['name']}" for t in mesh["cell_types"])
    lines = [f"{mesh['path']}"]
    lines.append(
        f"  {text.plural(mesh['points'], 'point')}, {text.plural(mesh['cells'], 'cell')}"
        + (f": {types}" if types else "")
    )
    if mesh["bounds"]:
        low, high = mesh["bounds"][0::2], mesh["bounds"][1::2]
        place = lambda p: "(" + ", ".join(map(text.number, p)) + ")"
        lines.append(
            f"  from {place(low)} to {place(high)}, {text.memory(mesh['memory'])} in memory"
        )
    totals = [
        f"{label} {text.number(mesh[key])}"
        for key, label in (("volume", "volume"), ("area", "area"))
        if mesh[key] is not None
    ]
    if mesh["boundary_faces"]:
        totals.append(text.plural(mesh["boundary_faces"], "boundary face"))
    if totals:
        lines.append("  " + ", ".join(totals))
    if criteria:
        lines += ["", *_table(criteria, color)]
    lines.append("")
    for finding in assessment.findings(summary):
        names = ", ".join(c["name"] for c in finding["criteria"])
        sentence = finding["text"].replace("{}", names)
        lines.append(_ascii(("Hint: " if finding["hint"] else "") + sentence))
    lines += [f"Note: {note}" for note in summary["notes"]]
    return "\n".join(lines)


def _table(criteria: list[dict[str, Any]], color: bool) -> list[str]:
    """The table of criteria; it has columns of undefined and infinite values only if there are
    any."""
    columns = [
        ("criterion", lambda c: c["name"]),
        ("unit", lambda c: c["unit"]),
        ("cells", lambda c: str(c["applicable"])),
        ("undefined", lambda c: str(assessment.undefined_count(c))),
        ("inf", lambda c: str(c["inf"])),
        ("min", lambda c: text.number(c["min"])),
        ("p1", lambda c: text.number(c["quantiles"].get("1"))),
        ("median", lambda c: text.number(c["quantiles"].get("50"))),
        ("p99", lambda c: text.number(c["quantiles"].get("99"))),
        ("max", lambda c: text.number(c["max"])),
        ("mean", lambda c: text.number(c["mean"])),
        (
            "acceptable",
            lambda c: _ascii(text.interval(*c["acceptable"])) if assessment.is_limited(c) else "",
        ),
        ("outside", lambda c: str(c["out_of_range"]) if assessment.is_limited(c) else ""),
        (
            "%",
            lambda c: (
                text.percent(c["out_of_range"], c["judged"]) if assessment.is_limited(c) else ""
            ),
        ),
    ]
    unneeded = set()
    if not any(assessment.undefined_count(c) for c in criteria):
        unneeded.add("undefined")
    if not any(c["inf"] for c in criteria):
        unneeded.add("inf")
    columns = [column for column in columns if column[0] not in unneeded]
    rows = [[value(c) for _, value in columns] for c in criteria]
    lines = text.table([name for name, _ in columns], rows, left=2)
    marked = [lines[0]]
    for line, c in zip(lines[1:], criteria):
        bad = assessment.is_serious(c)
        mark = "! " if bad else "  "
        marked.append(f"\x1b[1;31m{mark}{line}\x1b[0m" if color and bad else mark + line)
    return ["  " + marked[0], *marked[1:]]


def _ascii(sentence: str) -> str:
    """The sentence for terminals of any encoding."""
    for symbol, plain in (("≥", ">="), ("≤", "<="), ("–", "-"), ("°", " deg"), (text.THIN, "")):
        sentence = sentence.replace(symbol, plain)
    return sentence


def _convert(options: argparse.Namespace, rest: list[str]) -> int:
    from .conversion import convert

    _check_ranks(options.ranks)
    for note in convert(options.source, options.target, time=options.time, **_writer_options(rest)):
        print(text.printable(note))
    return 0


def _split_writer_options(arguments: Sequence[str]) -> tuple[list[str], list[str]]:
    """Splits the arguments into those for argparse and the options of the writer, which argparse
    does not know.

    >>> _split_writer_options(["convert", "a.visf", "--file-type", "ascii", "b.vtu"])
    (['convert', 'a.visf', 'b.vtu'], ['--file-type', 'ascii'])
    """
    ours, writers = [], []
    words = list(arguments)
    while words:
        word = words.pop(0)
        name = word.partition("=")[0]
        if word == "--":
            return ours + [word] + words, writers
        if not word.startswith("--") or name == "--help":
            ours.append(word)
            continue
        target = ours if name in ("--time", "--ranks") else writers
        target.append(word)
        if "=" not in word and words and not words[0].startswith("--"):
            target.append(words.pop(0))
    return ours, writers


def _writer_options(arguments: list[str]) -> dict[str, str]:
    """Parses `--name value`, `--name=value`, `--name` for on, and `--option NAME=VALUE`.

    >>> _writer_options(["--file-type", "ASCII", "--compression-level=3", "--write-time-steps"])
    {'file-type': 'ASCII', 'compression-level': '3', 'write-time-steps': 'on'}
    """
    options = {}
    rest = list(arguments)
    while rest:
        name, equals, value = rest.pop(0)[2:].partition("=")
        if not equals:
            value = rest.pop(0) if rest and not rest[0].startswith("--") else "on"
        if name == "option":
            name, equals, value = value.partition("=")
            if not equals:
                raise ValueError("--option takes NAME=VALUE")
        options[name] = value
    return options


def _criteria(options: argparse.Namespace, _rest: list[str]) -> int:
    from .common import pipeline, tables

    pipeline.load_plugin()
    known = tables.known_criteria()
    if not options.names:
        rows = [
            [
                c["name"],
                c["unit"],
                _ascii(text.interval(*c["acceptable"])),
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
            limits = _ascii(text.interval(*c["acceptable"], c["unit"]))
            shapes = "" if c["acceptable_for"] == c["applies_to"] else f" of {c['acceptable_for']}"
            print(f"  acceptable {limits}{shapes} ({c['acceptable_source']})")
        print(
            f"  {notes[c['name']]['formula']}\n  Degenerate cells: {notes[c['name']]['degenerate']}"
        )
    return 0


def _select(options: argparse.Namespace, _rest: list[str]) -> int:
    from .common.json_text import to_json
    from .selecting import select

    _check_ranks(options.ranks)
    result = select(
        options.mesh,
        options.by,
        options.output,
        time=options.time,
        say=_complain,
    )
    if options.json:
        print(to_json(result))
        return 0
    noun = result["elements"].lower()
    for step in result["steps"]:
        print(f"{step['strategy']}: {step['selected']} {noun}")
    for line in result["notes"]:
        print(_ascii(text.printable(line)))
    return 0


COMMANDS = {
    "inspect": _inspect,
    "check": _check,
    "compare": _compare,
    "select": _select,
    "convert": _convert,
    "criteria": _criteria,
}
