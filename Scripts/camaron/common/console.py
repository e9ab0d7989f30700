# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""What commands print on the terminal: errors, a status line, colors."""

from __future__ import annotations

import errno
import os
import shutil
import sys
import time

from . import text


def complain(*reasons: str) -> None:
    """Prints each reason on a line of standard error."""
    for line in reasons:
        print(f"camaron: {text.printable(line)}", file=sys.stderr, flush=True)


def is_of_output(error: Exception) -> bool:
    """Whether standard output caused an error: its disk is full, or it is closed."""
    of_files = (errno.EBADF, errno.EDQUOT, errno.EFBIG, errno.EIO, errno.ENOSPC)
    return isinstance(error, OSError) and not error.filename and error.errno in of_files


def reason(error: Exception, *meshes: str) -> str:
    """The reason of an error, after the name of its file; `meshes` are named when memory runs
    out."""
    if isinstance(error, MemoryError) or getattr(error, "errno", None) == errno.ENOMEM:
        return ": ".join(filter(None, (", ".join(meshes), "out of memory")))
    if is_of_output(error):
        return f"standard output: {error.strerror}"
    if isinstance(error, OSError) and error.strerror:
        return f"{error.filename}: {error.strerror}" if error.filename else error.strerror
    # Readers and writers refer to options by their labels in the window.
    reason = str(error).replace("Unsupported Cells", "--unsupported-cells")
    return reason.replace("(Allow Rounding)", "(--allow-rounding on)")


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
