# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that ParaView's writers have written files completely, since some of them do not report
failures."""

from __future__ import annotations

import os
import re
import tempfile
from pathlib import Path
from typing import Any

from paraview import simple

from ..common import files, pipeline, text, vtk_lists
from .storable_names import OF_IOSS

#: ParaView's formats with one file per rank and a file that lists them. To its other formats,
#: several ranks write duplicate points at the borders of pieces, ghost cells as ordinary cells, or
#: nothing, except for .stl, whose triangles share no points.
FORMATS_IN_PIECES = {".pvtu", ".pvtp", ".pvts", ".pvtr", ".pvti", ".pvd", ".vtm", ".vtpc", ".vtpd"}
#: Formats whose writers do not report a full disk, and that ParaView can read again, with the
#: minimum size of files relative to the mesh in memory (ids are shorter in files).
UNSURE = {
    ".vtkhdf": 0.4,
    ".xmf": 0.4,
    ".case": 0.4,
    ".encas": 0.4,
    ".e": 0.4,
    ".g": 0.4,
    ".ex2": 0.4,
}
#: Formats whose writer terminates the program if the disk is full. It adds ids to the mesh: the
#: measured relative size for tetrahedra is 1.15.
UNSURE |= dict.fromkeys(OF_IOSS, 1.3)
#: Formats whose library prints errors instead of reporting them to ParaView.
WITH_HDF5 = {".vtkhdf", ".xmf"}
#: Text formats whose writers do not report a full disk either, with the last line of a complete
#: file.
UNSURE_TEXTS = {".obj": b"\n", ".geo": b"endExtra\n", ".csv": b"\n", ".tsv": b"\n", ".txt": b"\n"}
#: Bytes that a file system may report as free but cannot allocate, and what is said then.
LAST_BLOCK = 4096
FULL = "cannot write the file: the disk is full"


def check_space(proxy: Any, target: Path, folder: Path) -> None:
    """Raises RuntimeError if a mesh does not fit on the disk and its writer would not report
    that."""
    free = files.free_space(folder)
    if free is None or target.suffix.lower() not in UNSURE:
        return
    needed = pipeline.data_information(proxy).GetMemorySize() * 1024 * UNSURE[target.suffix.lower()]
    if free < needed:
        raise RuntimeError(
            f"the disk has {text.memory(free)} free, and the mesh needs about {text.memory(needed)}"
        )


def check_written(proxy: Any, path: Path, all_steps: bool) -> None:
    """Raises RuntimeError if a writer of ParaView has written an incomplete file without reporting
    it."""
    free = files.free_space(path.parent)
    if free is not None and free < LAST_BLOCK:
        raise RuntimeError(FULL)
    suffix = path.suffix.lower()
    if suffix in FORMATS_IN_PIECES and path.is_file():
        _check_pieces(path)
    if suffix in UNSURE_TEXTS and path.is_file():
        if not _ends_with(path, UNSURE_TEXTS[suffix]):
            raise RuntimeError("cannot write the file: it is incomplete")
    if suffix in UNSURE and path.is_file() and not all_steps and pipeline.rank_count() == 1:
        _read_again(proxy, path)


def _check_pieces(path: Path) -> None:
    """Raises RuntimeError if a file that is in a list is not there: another rank may have written
    it to a folder of the same name on its own disk, which its writer creates."""
    for piece in vtk_lists.files_in_list(path):
        if not piece.is_file():
            raise RuntimeError(
                f"cannot write the file: {piece.name}, the piece of a rank, is not in this folder: "
                "all ranks need the same"
            )
        if piece.suffix.lower() in FORMATS_IN_PIECES:
            _check_pieces(piece)


def _ends_with(path: Path, end: bytes) -> bool:
    with open(path, "rb") as file:
        file.seek(max(0, path.stat().st_size - len(end)))
        return file.read() == end


def _read_again(proxy: Any, path: Path) -> None:
    try:
        with StandardError():
            again = pipeline.open_mesh(path).source
    except RuntimeError as error:
        reason = str(error).removeprefix(f"{path}: ")
        raise RuntimeError(f"the file that was written cannot be read: {reason}") from None
    try:  # some readers skip points that no cell uses
        wanted, there = (pipeline.data_information(p).GetNumberOfCells() for p in (proxy, again))
        if wanted != there:
            raise RuntimeError(f"only {there} of the {wanted} cells that were written can be read")
    finally:
        simple.Delete(again)


class StandardError:
    """Captures the output of libraries such as HDF5 to standard error in `text`."""

    def __init__(self):
        self.text = ""

    def __enter__(self) -> "StandardError":
        self._file = tempfile.TemporaryFile() if not hasattr(os, "memfd_create") else None
        caught = self._file.fileno() if self._file else os.memfd_create("camaron")
        self._caught, self._before = caught, os.dup(2)
        os.dup2(caught, 2)
        return self

    def __exit__(self, kind, error, trace) -> None:
        os.dup2(self._before, 2)
        os.close(self._before)
        with os.fdopen(os.dup(self._caught), "rb") as file:
            file.seek(0)
            self.text = file.read().decode("utf-8", "replace")
        if self._file:
            self._file.close()
        else:
            os.close(self._caught)

    def reason(self) -> str:
        """The reason of a failure of HDF5 in a few words, or an empty text."""
        if "HDF5-DIAG" not in self.text:
            return ""
        number = re.search(r"errno = (\d+)", self.text)
        return (
            f"cannot write the file: {os.strerror(int(number[1]))}"
            if number
            else "HDF5 failed to write"
        )


def plain_reason(errors: list[str], folder: Path) -> str:
    """VTK's message about a failed writer without the details of the pipeline."""
    reason = errors[0] if errors else "nothing was written"
    if reason.startswith("Only vtkMPIController supported"):
        return "the writer of this format needs MPI: run it in pvpython or pvbatch, not in python3"
    if reason.startswith("the disk has "):  # of check_space
        return reason
    free = files.free_space(folder)
    if free is not None and free < LAST_BLOCK or any("out of disk space" in e for e in errors):
        return FULL
    found = re.match(r"Algorithm (\w+) ?\(.*returned failure for request", reason)
    if found:
        room = f"; the disk has {text.memory(free)} free" if free is not None else ""
        return f"cannot write the file ({found[1]} reports no reason){room}"
    return re.sub(r"; deleting file: .*| while processing .*", "", reason, flags=re.DOTALL)
