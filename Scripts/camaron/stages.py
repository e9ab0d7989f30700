# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""What each stage of a command takes."""

from __future__ import annotations

import contextlib
import os
import time
from typing import Callable, Iterator


class Stages:
    """Says of each stage how long it took, and how much of the processor's time, or nothing at all.

    >>> stage = Stages(print)
    >>> with stage("statistics"):
    ...     pass
    statistics took 0.00 s (0.00 s of processor time)
    """

    def __init__(self, say: Callable[[str], None], is_verbose: bool = True):
        self.say = say if is_verbose else lambda words: None

    @contextlib.contextmanager
    def __call__(self, name: str) -> Iterator[None]:
        started = time.monotonic(), time.process_time()
        yield
        wall, processor = time.monotonic() - started[0], time.process_time() - started[1]
        self.say(f"{name} took {wall:.2f} s ({processor:.2f} s of processor time)")

    def started(self) -> None:
        """Of the start of the program, if the launcher says when that was."""
        begin = os.environ.get("CAMARON_STARTED")
        if begin:
            self.say(f"start took {time.time() - float(begin):.2f} s ({time.process_time():.2f} s of processor time)")
