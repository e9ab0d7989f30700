# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reports the time of each stage of a command, and estimates the remaining time."""

from __future__ import annotations

import contextlib
import os
import time
from typing import Callable, Iterator, Optional

from paraview import servermanager

from . import text

#: Seconds of stages other than evaluating: minimum, per cell, and per value of a criterion. They
#: estimate the remaining time, corrected by the time of the previous stages.
SECONDS = {
    "statistics": (0.1, 0.0, 3e-8),
    "boundary and totals": (0.1, 3e-7, 0.0),
    "picture of the mesh": (0.6, 0.0, 0.0),
    "picture of the worst cells": (0.4, 2e-7, 0.0),
    "picture of the worst cell": (0.3, 4e-7, 0.0),
    "writing the mesh": (0.1, 1e-7, 1.5e-8),
    "writing the report": (0.1, 0.0, 0.0),
}


class Progress:
    """Shows the current stage of a command and the remaining time.

    >>> with Progress(print) as progress:
    ...     camaron.inspect("part.visf", progress=progress)
    evaluating, about 12 seconds left
    """

    def __init__(self, show: Callable[[str], None]):
        self.show = show
        self.stage, self.began, self.share = "", time.monotonic(), 0.0
        #: Expected seconds of the remaining stages; expected and actual seconds of the completed
        #: ones.
        self.expected: dict[str, float] = {}
        self.done = self.taken = 0.0

    def __enter__(self) -> Progress:
        self.handler = servermanager.ActiveConnection.Session.GetProgressHandler()
        self.observer = self.handler.AddObserver("ProgressEvent", self._hear)
        return self

    def __exit__(self, kind, error, trace) -> None:
        self.handler.RemoveObserver(self.observer)

    def expect(self, evaluating: float, cells: int, criteria: int) -> None:
        """Sets the expected times after reading, from the time of evaluating and the size of the
        mesh."""
        self.expected = {"evaluating": evaluating}
        for stage, (least, of_cell, of_value) in SECONDS.items():
            self.expected[stage] = least + of_cell * cells + of_value * cells * criteria

    def begin(self, stage: str) -> None:
        self.stage, self.began, self.share = stage, time.monotonic(), 0.0
        stages = list(self.expected)
        for earlier in stages[: stages.index(stage)] if stage in stages else []:
            del self.expected[earlier]  # the stage was skipped
        self._tell()

    def end(self) -> None:
        self.done += self.expected.pop(self.stage, 0.0)
        self.taken += time.monotonic() - self.began if self.expected else 0.0

    def _hear(self, handler, _event) -> None:
        """Receives the progress of a filter; the largest progress in a stage counts."""
        self.share = max(self.share, handler.GetLastProgress() / 100)
        self._tell()

    def seconds_left(self) -> float:
        """Estimated from the expected times and the pace so far."""
        elapsed = time.monotonic() - self.began
        of_stage = self.expected.get(self.stage, 0.0)
        done = self.done + self.share * of_stage
        pace = (self.taken + elapsed) / done if done > 0.5 else 1.0
        share = self.share or min(elapsed / (pace * of_stage), 1.0) if of_stage else 0.0
        return pace * (sum(self.expected.values()) - share * of_stage)

    def _tell(self) -> None:
        words = self.stage
        if self.expected:
            words += f", about {text.duration(self.seconds_left())} left"
        self.show(words)


class Stages:
    """Reports the wall-clock and processor time of each stage, or nothing.

    >>> stage = Stages(print)
    >>> with stage("statistics"):
    ...     pass
    statistics took 0.00 s (0.00 s of processor time)
    """

    def __init__(
        self,
        say: Callable[[str], None],
        is_verbose: bool = True,
        progress: Optional[Progress] = None,
    ):
        self.say = say if is_verbose else lambda words: None
        self.progress = progress

    @contextlib.contextmanager
    def __call__(self, name: str) -> Iterator[None]:
        started = time.monotonic(), time.process_time()
        if self.progress:
            self.progress.begin(name)
        yield
        if self.progress:
            self.progress.end()
        wall, processor = time.monotonic() - started[0], time.process_time() - started[1]
        self.say(f"{name} took {wall:.2f} s ({processor:.2f} s of processor time)")

    def started(self) -> None:
        """Reports the time of the start of the program, if the launcher passes its beginning."""
        begin = os.environ.get("CAMARON_STARTED")
        if begin:
            self.say(
                f"start took {time.time() - float(begin):.2f} s ({time.process_time():.2f} s of processor time)"
            )
