# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command `camaron convert`."""

from __future__ import annotations

import argparse
from typing import Sequence

from ..common import arguments, text

HELP = """\
Writes a mesh in another format, given by the extension of OUT. Each format has further options,
which are listed below with their defaults; on/off options need no value. File names that begin with
a dash must follow --.

  camaron convert part.visf part.vtu --compressor-type lz4
  camaron convert part.vtu part.visf --encoding binary-little-endian
  camaron convert part.cas part.tri --unsupported-cells convert
  camaron convert part.cas case/ --encoding binary --scale 0.001
"""


def add_parser(commands: argparse._SubParsersAction) -> None:
    parser = commands.add_parser(
        "convert",
        help="convert a mesh to another format",
        usage="camaron convert [OPTION...] IN OUT",
        description=HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        add_help=False,
    )
    parser.add_argument(
        "-h",
        "--help",
        action=_FormatsHelp,
        help="show this help with all formats and their options",
    )
    parser.add_argument("source", metavar="IN", help="file that ParaView can open")
    parser.add_argument("target", metavar="OUT", help="file to write")
    arguments.add_common(parser)


class _FormatsHelp(argparse.Action):
    """Prints the help of a command and the formats, which are only known once ParaView runs."""

    def __init__(self, option_strings, dest, help=None):
        super().__init__(option_strings, argparse.SUPPRESS, nargs=0, help=help)

    def __call__(self, parser, namespace, values, option_string=None):
        from ..common import formats, pipeline

        pipeline.load_plugin()
        with pipeline.Messages():  # of writers that need MPI
            described = formats.describe_formats()
        print(f"{parser.format_help()}\n{described}")
        parser.exit()


def run(options: argparse.Namespace) -> int:
    from ..conversion import convert

    writer_options = _parse(options.writer_options)
    for note in convert(
        options.source,
        options.target,
        time=options.time,
        reader=dict(options.reader),
        strict=options.strict,
        **writer_options,
    ):
        print(text.printable(note))
    return 0


def split_writer_options(words: Sequence[str]) -> tuple[list[str], list[str]]:
    """Splits the arguments into those for argparse and the options of the writer, which argparse
    does not know.

    >>> split_writer_options(["convert", "a.visf", "--file-type", "ascii", "b.vtu"])
    (['convert', 'a.visf', 'b.vtu'], ['--file-type', 'ascii'])
    """
    ours, writers = [], []
    words = list(words)
    while words:
        word = words.pop(0)
        name = word.partition("=")[0]
        if word == "--":
            return ours + [word] + words, writers
        if not word.startswith("--") or name in ("--help", "--strict"):
            ours.append(word)
            continue
        target = ours if name in ("--time", "--reader", "--ranks") else writers
        target.append(word)
        if "=" not in word and words and not words[0].startswith("--"):
            target.append(words.pop(0))
    return ours, writers


def _parse(words: list[str]) -> dict[str, str]:
    """Parses `--name value`, `--name=value`, `--name` for on, and `--option NAME=VALUE`.

    >>> _parse(["--file-type", "ASCII", "--compression-level=3", "--write-time-steps"])
    {'file-type': 'ASCII', 'compression-level': '3', 'write-time-steps': 'on'}
    """
    options = {}
    rest = list(words)
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
