# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line: runs the command that its arguments name, and reports errors on one line."""

from __future__ import annotations

import argparse
import os
import sys
from importlib import import_module
from typing import Sequence

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


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="camaron", description="Quality of polygonal and polyhedral meshes."
    )
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for command in COMMANDS.values():
        command.add_parser(commands)
    return parser


def main(arguments: Sequence[str]) -> int:
    """Runs the command and returns its exit status: 0 done, 1 failed check, 2 error, 130
    interrupted."""
    parser = _parser()
    options = argparse.Namespace(writer_options=[])
    if list(arguments[:1]) == ["convert"]:
        convert = COMMANDS["convert"]
        arguments, options.writer_options = convert.split_writer_options(arguments)
    try:
        parser.parse_args(arguments, options)
        _check_ranks(options)
        _check_streams(options)
        status = COMMANDS[options.command].run(options)
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
        reason = console.reason(error, *_meshes(options))
        console.complain(*getattr(error, "problems", [reason]))
        return ERROR


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
    from .common.inputs import Inputs

    if any(os.path.isfile(f"/dev/fd/{number}") for number in (1, 2)):
        Inputs(*_meshes(options)).refuse_streams()


def _close_output() -> None:
    """Discards all further output, which has no reader or no space left."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.__stdout__.fileno())


def _meshes(options: argparse.Namespace) -> list[str]:
    """The meshes in the arguments of a command."""
    found = [
        getattr(options, name) for name in ("mesh", "a", "b", "source") if hasattr(options, name)
    ]
    return found + getattr(options, "meshes", [])
