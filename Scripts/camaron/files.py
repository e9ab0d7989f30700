# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that appear whole or not at all."""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path
from typing import Optional


class Staging:
    """Collects files in a hidden folder inside their destination; `publish` moves them in place.

    >>> with Staging("report") as staging:
    ...     (staging.path / "worst.csv").write_text("...")
    ...     staging.publish()
    """

    def __init__(self, destination: os.PathLike | str):
        self.destination = Path(destination)
        self.path = Path()
        self._created: list[Path] = []

    def __enter__(self) -> "Staging":
        folder = self.destination
        while not folder.exists():
            self._created.append(folder)
            folder = folder.parent
        self.destination.mkdir(parents=True, exist_ok=True)
        self.path = Path(tempfile.mkdtemp(prefix=".camaron-", dir=self.destination))
        return self

    def names(self) -> list[str]:
        """Names of what is to be moved, folders included."""
        return sorted(entry.name for entry in self.path.iterdir())

    def publish(self) -> None:
        """Moves everything; files of the same names are replaced."""
        for name in self.names():
            target = self.destination / name
            if target.is_dir() and not target.is_symlink():
                shutil.rmtree(target)
            os.replace(self.path / name, target)

    def __exit__(self, kind, error, trace) -> None:
        shutil.rmtree(self.path, ignore_errors=True)
        if kind is not None:
            for folder in self._created:
                try:
                    folder.rmdir()
                except OSError:
                    break


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
