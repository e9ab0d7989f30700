# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments that several commands have."""

from __future__ import annotations

import argparse


def add_criteria(parser: argparse.ArgumentParser) -> None:
    """Adds the criteria, their acceptable ranges and the bins of their histograms."""
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
        type=positive,
        default=50,
        metavar="N",
        help="number of histogram bins (%(default)s)",
    )


def add_groups(parser: argparse.ArgumentParser, default: str) -> None:
    """Adds the groups of cells."""
    parser.add_argument(
        "--group-by",
        default=default,
        metavar="WHAT",
        help="also evaluate groups of cells by type, block, none or a cell array (%(default)s)",
    )


def add_common(parser: argparse.ArgumentParser) -> None:
    """Adds the time step, how the file is read, and the number of ranks."""
    parser.add_argument(
        "--time",
        default="last",
        metavar="STEP",
        help="time step: first, last or its number (%(default)s)",
    )
    parser.add_argument(
        "--reader",
        action="append",
        default=[],
        type=named_value,
        metavar="NAME=VALUE",
        help="option of the reader, a property of its panel; may be repeated",
    )
    parser.add_argument(
        "--strict",
        action="store_true",
        help="refuse a file with arrays that cannot be read, instead of leaving them out",
    )
    parser.add_argument("--ranks", type=positive, metavar="N", help="number of MPI ranks")


def positive(argument: str) -> int:
    """The type of arguments that are integers above 0."""
    number = int(argument)
    if number < 1:
        raise ValueError
    return number


def named_value(argument: str) -> tuple[str, str]:
    """The type of arguments that are NAME=VALUE."""
    name, equals, value = argument.partition("=")
    if not name or not equals:
        raise ValueError
    return name, value


named_value.__name__ = "NAME=VALUE"
positive.__name__ = "positive number"  # argparse says "invalid positive number value"
