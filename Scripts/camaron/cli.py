# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line: runs the command that its arguments name, and reports errors on one line."""

from __future__ import annotations

import argparse
import os
import sys
from importlib import import_module
from typing import Optional, Sequence, TextIO

from .commands import ERROR
from .common import console, text

#: The commands by name, in the order of the help; each is a file in the folder commands.
COMMANDS = {
    name: import_module(f".commands.{name}", __package__)
    for name in (
        "inspect",
        "check",
        "compare",
        "convert",
        "select",
        "criteria",
    )
}


class _Parser(argparse.ArgumentParser):
    def print_help(self, file: Optional[TextIO] = None) -> None:
        """Prints the help, or raises OSError, which argparse would ignore."""
        (file or sys.stdout).write(self.format_help())


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="camaron", description="Quality of polygonal and polyhedral meshes.")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for command in COMMANDS.values():
        command.add_parser(commands)
    return parser


def main(arguments: Sequence[str]) -> int:
    """Runs the command and returns its exit status: 0 done, 1 failed check, 2 error."""
    options = argparse.Namespace(writer_options=[])
    try:
        status = _run(arguments, options)
        sys.stdout.flush()
        return status
    except BrokenPipeError:  # of `camaron ... | head`
        _close_output()
        return 0
    except (ValueError, RuntimeError, OSError, MemoryError) as error:
        if console.is_of_output(error):
            _close_output()
        # All problems of rules, one per line, or a single reason.
        reason = console.reason(error, *_meshes(options))
        console.complain(*getattr(error, "problems", [reason]))
        return ERROR


def _run(arguments: Sequence[str], options: argparse.Namespace) -> int:
    if list(arguments[:1]) == ["convert"]:
        convert = COMMANDS["convert"]
        arguments, options.writer_options = convert.split_writer_options(arguments)
    try:
        _parser().parse_args(arguments, options)
    except SystemExit as end:  # argparse has printed its help or an error
        return end.code or 0
    _check_ranks(options)
    _check_streams(options)
    return COMMANDS[options.command].run(options)


def _check_ranks(options: argparse.Namespace) -> None:
    """Raises RuntimeError if the program runs on another number of ranks than --ranks."""
    from .common import pipeline

    wanted, running = getattr(options, "ranks", None), pipeline.rank_count()
    if wanted and wanted != running:
        raise RuntimeError(
            f"--ranks {wanted}, but this program runs on {text.plural(running, 'rank')}: "
            f"start it with the command camaron, or with mpiexec -n {wanted} pvbatch"
        )


def _check_streams(options: argparse.Namespace) -> None:
    """Raises ValueError if standard output or standard error goes to a file of a mesh, as with >>."""
    from .common.inputs import Inputs, stream_files

    if stream_files():
        Inputs(*_meshes(options)).refuse_streams()


def _close_output() -> None:
    """Discards all further output, which has no reader or no space left."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _meshes(options: argparse.Namespace) -> list[str]:
    """The meshes in the arguments of a command."""
    found = [
        getattr(options, name) for name in ("mesh", "a", "b", "source") if hasattr(options, name)
    ]
    return found + getattr(options, "meshes", [])
