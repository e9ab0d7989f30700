# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes files completely or not at all."""

from __future__ import annotations

import os
import secrets
import shutil
import stat
import subprocess
import tempfile
from pathlib import Path
from typing import Iterator, Optional

from .inputs import Inputs

#: Waits until the process at the other end of its input closes it. Unless that process reported
#: success before, removes the folder $1 and those of the other folders that are empty.
CLEANER = 'read -r word && exit; rm -rf -- "$1"; shift; for f; do rmdir -- "$f" || exit; done'


class Staging:
    """Collects files in a hidden folder inside their destination; `publish` moves them in place,
    unless they would replace `inputs`.

    The folder is always removed, even if the process is killed: signals end pvpython at once, or
    wait until a writer is done where Python handles them, so a small process watches it from
    outside. Targets that are not regular files, such as pipes or devices, receive the bytes of the
    file.

    >>> with Staging("report", Inputs("part.visf")) as staging:
    ...     (staging.path / "worst.csv").write_text("...")
    ...     staging.publish()
    """

    def __init__(self, destination: os.PathLike | str, inputs: Inputs):
        self.destination, self.inputs = Path(destination), inputs
        self.path = Path()
        #: Folders that were created for the destination, innermost first.
        self.created: list[Path] = []
        self._cleaner: Optional[subprocess.Popen] = None

    def __enter__(self) -> "Staging":
        folder = self.destination
        # Relative like the destination: the current folder may have a name that VTK refuses.
        self.path = folder / f".camaron-{secrets.token_hex(8)}"
        try:
            while not folder.exists():
                self.created.append(folder)
                folder = folder.parent
            # Before there is anything to remove, as this process may end at any time.
            self._cleaner = _watch(self.path.absolute(), self.created)
            self.destination.mkdir(parents=True, exist_ok=True)
            self.path.mkdir(0o700)
        except OSError as error:
            self._dismiss_cleaner()
            self._remove_created()
            reason = f"{self.destination}: cannot write to this folder: {error.strerror}"
            raise type(error)(reason) from None
        return self

    def names(self) -> list[str]:
        """Names of the files and folders to be moved."""
        return sorted(entry.name for entry in self.path.iterdir())

    def publish(self) -> None:
        """Moves everything; files of the same names are replaced, others in a folder are kept.

        A replaced file keeps its permissions, and a link remains a link. Raises OSError, with
        nothing moved, if a file and a folder have the same name or a file is write-protected, and
        if a pipe or device does not accept the bytes; ValueError if an input would be replaced.
        """
        moves = list(_moves(self.path, self.destination))
        self.inputs.refuse(*(target for _, target in moves))
        for source, target in moves:
            target.parent.mkdir(exist_ok=True)
            if target.exists() and not target.is_file():
                _feed(source, target)
                continue
            if target.exists():
                shutil.copymode(target, source)
            if target.is_symlink():
                target = target.resolve()
                handle, beside = tempfile.mkstemp(".part", ".camaron-", target.parent)
                os.close(handle)
                try:
                    shutil.move(source, beside)  # which may be on another disk
                except OSError:
                    os.unlink(beside)
                    raise
                source = beside
            os.replace(source, target)

    def __exit__(self, kind, error, trace) -> None:
        if error is not None:
            self._name_place(error)
        shutil.rmtree(self.path, ignore_errors=True)
        if kind is not None:
            self._remove_created()
        self._dismiss_cleaner()

    def _dismiss_cleaner(self) -> None:
        if self._cleaner:
            self._cleaner.communicate(b"done\n")

    def _name_place(self, error: BaseException) -> None:
        """Replaces temporary names in errors by final ones; errors of the disk name the folder if
        there are several files."""
        hidden, shown = (
            f"{os.path.join(folder, '')}".removeprefix("./")
            for folder in (self.path, self.destination)
        )
        if not isinstance(error, OSError) or not error.strerror:  # the error has its own message
            error.args = tuple(
                a.replace(hidden, shown) if isinstance(a, str) else a for a in error.args
            )
        elif error.filename is None:
            names = self.names()
            error.filename = str(
                self.destination / names[0] if len(names) == 1 else self.destination
            )
        elif str(error.filename).startswith(hidden):
            error.filename = str(error.filename).replace(hidden, shown)

    def _remove_created(self) -> None:
        for folder in self.created:
            try:
                folder.rmdir()
            except FileNotFoundError:
                continue
            except OSError:
                break


def _watch(folder: Path, created: list[Path]) -> Optional[subprocess.Popen]:
    """Starts a process that removes the folders if this one ends early; None without a shell."""
    try:
        return subprocess.Popen(
            [
                "/bin/sh",
                "-c",
                CLEANER,
                "camaron",
                str(folder),
                *(str(f.absolute()) for f in created),
            ],
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            cwd="/",
            start_new_session=True,  # so that Ctrl-C does not reach it
        )
    except OSError:
        return None


def free_space(folder: os.PathLike | str) -> Optional[int]:
    """Free bytes for files in a folder, or None if unknown."""
    try:
        disk = os.statvfs(folder)
    except (OSError, AttributeError):
        return None
    blocks = disk.f_bfree if os.geteuid() == 0 else disk.f_bavail
    return blocks * disk.f_frsize if disk.f_blocks else None


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
        if _is_foreign_link(place):
            raise PermissionError(f"{place}: this link belongs to another user")
        try:
            place.stat()  # the system may not allow it
        except FileNotFoundError:
            pass
        if place.exists() and place.is_dir() != entry.is_dir():
            kind = "folder" if place.is_dir() else "file"
            raise FileExistsError(f"{place}: there is a {kind} of this name")
        if place.is_file() and not os.access(place, os.W_OK):
            raise PermissionError(f"{place}: the file is write-protected")
        if entry.is_dir():
            yield from _moves(entry, place)
        else:
            yield entry, place


def _is_foreign_link(path: Path) -> bool:
    """Whether a path is a link that another user left in a folder such as /tmp; many systems do not
    follow it either (fs.protected_symlinks of Linux)."""
    if not path.is_symlink():
        return False
    folder = path.parent.stat()
    is_shared = folder.st_mode & stat.S_ISVTX and folder.st_mode & stat.S_IWOTH
    return bool(is_shared) and path.lstat().st_uid not in (os.geteuid(), folder.st_uid)


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
