# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""What commands print on the terminal: errors, a status line, colors."""

from __future__ import annotations

import os
import shutil
import sys
import time

from . import text


def complain(*reasons: str) -> None:
    """Prints each reason on a line of standard error."""
    for line in reasons:
        print(f"camaron: {text.printable(line)}", file=sys.stderr, flush=True)


def reason(error: Exception, *meshes: str) -> str:
    """The reason of an error, after the name of its file; `meshes` are named when memory runs
    out."""
    if isinstance(error, MemoryError):
        return f"{', '.join(meshes) or 'camaron'}: out of memory"
    if isinstance(error, OSError) and error.strerror:
        return f"{error.filename or 'standard output'}: {error.strerror}"
    # Readers and writers refer to options by their labels in the window.
    return str(error).replace("Unsupported Cells", "--unsupported-cells")


class StatusLine:
    """A line at the bottom of a terminal that is replaced by the next one; no output without a
    terminal."""

    #: Seconds before the line is shown.
    WAIT = 3.0

    def __init__(self):
        self.began, self.is_there = time.monotonic(), False

    def __enter__(self) -> StatusLine:
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


def wants_color() -> bool:
    """Whether to print lines in red; under mpiexec, every program seems to have a terminal."""
    from . import pipeline

    return sys.stdout.isatty() and "NO_COLOR" not in os.environ and pipeline.rank_count() == 1
