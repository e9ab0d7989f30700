# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that appear whole or not at all."""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path
from typing import Iterator, Optional


class Staging:
    """Collects files in a hidden folder inside their destination; `publish` moves them in place.

    What is no regular file, like a pipe or a device, gets the bytes of the file instead.

    >>> with Staging("report") as staging:
    ...     (staging.path / "worst.csv").write_text("...")
    ...     staging.publish()
    """

    def __init__(self, destination: os.PathLike | str):
        self.destination = Path(destination)
        self.path = Path()
        #: Folders that were made for the destination, the innermost first.
        self.created: list[Path] = []

    def __enter__(self) -> "Staging":
        folder = self.destination
        try:
            while not folder.exists():
                self.created.append(folder)
                folder = folder.parent
            self.destination.mkdir(parents=True, exist_ok=True)
            self.path = Path(tempfile.mkdtemp(prefix=".camaron-", dir=self.destination))
        except OSError as error:
            self._remove_created()
            reason = f"{self.destination}: cannot write into this folder: {error.strerror}"
            raise type(error)(reason) from None
        return self

    def names(self) -> list[str]:
        """Names of what is to be moved, folders included."""
        return sorted(entry.name for entry in self.path.iterdir())

    def publish(self) -> None:
        """Moves everything; files of the same names are replaced, others in a folder stay.

        A file that is replaced keeps its permissions, and a link stays one. Raises OSError, with
        nothing moved, where a file and a folder have the same name or a file is write-protected; also
        where a pipe or device does not take the bytes.
        """
        moves = list(_moves(self.path, self.destination))
        for source, target in moves:
            target.parent.mkdir(exist_ok=True)
            if target.exists() and not target.is_file():
                _feed(source, target)
                continue
            if target.exists():
                shutil.copymode(target, source)
            if target.is_symlink():
                target = target.resolve()
                beside = target.with_name(self.path.name + ".part")
                shutil.move(source, beside)  # which may be on another disk
                source = beside
            os.replace(source, target)

    def __exit__(self, kind, error, trace) -> None:
        shutil.rmtree(self.path, ignore_errors=True)
        if kind is not None:
            self._remove_created()

    def _remove_created(self) -> None:
        for folder in self.created:
            try:
                folder.rmdir()
            except FileNotFoundError:
                continue
            except OSError:
                break


def _feed(source: Path, target: Path) -> None:
    """Gives the bytes of a file to a pipe or device."""
    try:
        with open(source, "rb") as file, open(target, "wb") as special:
            shutil.copyfileobj(file, special)
    except OSError as error:
        raise type(error)(error.errno, error.strerror, str(target)) from None


def _moves(source: Path, target: Path) -> Iterator[tuple[Path, Path]]:
    """Old and new path of every file in a folder."""
    for entry in sorted(source.iterdir()):
        place = target / entry.name
        if place.exists() and place.is_dir() != entry.is_dir():
            kind = "folder" if place.is_dir() else "file"
            raise FileExistsError(f"{place}: there is a {kind} of this name")
        if place.is_file() and not os.access(place, os.W_OK):
            raise PermissionError(f"{place}: the file is write-protected")
        if entry.is_dir():
            yield from _moves(entry, place)
        else:
            yield entry, place


def same_file(a: os.PathLike | str, b: os.PathLike | str) -> bool:
    """Whether both name the same existing file."""
    try:
        return os.path.samefile(a, b)
    except OSError:
        return False


def size(path: os.PathLike | str) -> Optional[int]:
    """Bytes of a file, of all files of a folder, or None."""
    path = Path(path)
    try:
        if path.is_dir():
            return sum(entry.stat().st_size for entry in path.rglob("*") if entry.is_file())
        return path.stat().st_size
    except OSError:
        return None
