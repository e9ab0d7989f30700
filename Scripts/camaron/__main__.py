# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the command: pvpython Scripts/camaron ARGUMENTS, or mpiexec -n N pvbatch the same.

The launcher sets CAMARON_STATUS, the file for the exit status, CAMARON_LOG, the file for what libraries print, and
CAMARON_ERRORS, the stream for messages; Scripts/launcher/with-ranks sets CAMARON_MARK.
"""

import io
import os
import re
import runpy
import signal
import sys
import traceback

if not __package__:  # run by path
    sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


class Messages(io.TextIOWrapper):
    """Standard error for messages of the command, whole lines with a mark before each. What cannot be
    written is lost, since nobody is there to be told."""

    def __init__(self, descriptor: int, mark: str):
        raw = io.FileIO(descriptor, "w", closefd=False)
        super().__init__(raw, encoding="utf-8", errors="backslashreplace", write_through=True)
        self.mark = mark
        self.rest = ""

    def write(self, words: str) -> int:
        lines, end, self.rest = (self.rest + words).rpartition("\n")
        if end:
            self.put(lines + end)
        return len(words)

    def put(self, words: str) -> None:
        """Writes words at once, a mark before each line."""
        try:
            super().write(re.sub("^(?=.)", self.mark, words, flags=re.MULTILINE))
        except OSError:
            pass

    def flush(self) -> None:
        rest, self.rest = self.rest, ""
        self.put(rest)
        try:
            super().flush()
        except OSError:
            pass


def open_streams() -> None:
    """Separates messages of the command from what libraries print, which goes to file descriptor 2,
    as do the errors of callbacks."""
    # pvpython redirects Python's output to VTK's output window, which is not a terminal.
    sys.stdout = sys.__stdout__ or open(os.devnull, "w", encoding="utf-8")
    mark = os.environ.get("CAMARON_MARK", "")
    if mark:
        errors, path = os.dup(2), os.environ.get("CAMARON_LOG", "")
        if os.path.exists(path):
            # Open MPI 5 puts unfinished lines of standard error into the output (openpmix issue 3858).
            os.dup2(os.open(path, os.O_WRONLY | os.O_APPEND), 2)
    else:
        errors = int(os.environ.get("CAMARON_ERRORS", 2))
    sys.stderr = Messages(errors, mark)
    if sys.stderr.mark or sys.stderr.fileno() != 2:
        log = sys.__stderr__
        sys.excepthook = lambda *error: traceback.print_exception(*error, file=log)
        sys.unraisablehook = lambda all_: traceback.print_exception(all_.exc_value, file=log)


def has_limited_memory() -> bool:
    """Whether `ulimit -v` is set."""
    try:
        import resource
    except ImportError:
        return False
    return resource.getrlimit(resource.RLIMIT_AS)[0] != resource.RLIM_INFINITY


def reason(error: BaseException) -> str:
    """A sentence about an error that the command does not expect."""
    causes = [error]
    while causes[-1].__cause__ or causes[-1].__context__:
        causes.append(causes[-1].__cause__ or causes[-1].__context__)
    for cause in causes:
        if isinstance(cause, MemoryError) or re.search(
            "failed to map segment|annot allocate memory", str(cause)
        ):
            return "out of memory"
    if isinstance(error, ImportError) and has_limited_memory():  # Python does not tell why
        return f"out of memory: {error}"
    return " ".join(f"{type(error).__name__}: {error}".split())


if hasattr(signal, "SIGXFSZ"):  # writing above a limit is an error, as on a full disk
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
# Python would end the program after the running filter, or, in a callback of VTK, with a traceback.
signal.signal(signal.SIGINT, signal.SIG_DFL)
open_streams()
report = (
    os.open(os.environ["CAMARON_STATUS"], os.O_WRONLY) if "CAMARON_STATUS" in os.environ else None
)
try:
    runpy.run_path(os.path.join(os.path.dirname(os.path.abspath(__file__)), "quick_start.py"))
    from camaron import cli

    status = cli.main(sys.argv[1:])
except BaseException as error:
    # Never exit with 1, which means that a mesh violates rules.
    print(f"camaron: {reason(error)}", file=sys.stderr)
    status = 2
if status:
    # When the program ends, HDF5 reports a file again that it could not write.
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
# No sys.exit here: it would keep pvbatch from finalizing MPI.
if report is not None:
    os.write(report, b"%d\n" % status)
elif status:
    sys.exit(status)
