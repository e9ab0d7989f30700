# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Keeps outputs from replacing the files that a command reads."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any, Optional

from paraview import servermanager

from . import pipeline


class Inputs:
    """The files that a command reads, which its outputs must not replace: meshes with all files
    that belong to them, rules and ranges.

    >>> inputs = Inputs("part.ele", "fem.rules")
    >>> inputs.add(opened.source)
    >>> inputs.refuse("part.node")
    ValueError: part.node: this file belongs to part.ele, which is read: choose another name
    """

    def __init__(self, *inputs: Any):
        """Each input is the name of a file, a source of the pipeline, or None."""
        self._files: list[str] = []
        self._known: Optional[Any] = None
        for one in inputs:
            self.add(one)

    def add(self, one: Any) -> None:
        """Adds the name of a file, or all files that the readers of a source have opened so far."""
        if isinstance(one, (str, os.PathLike)):
            self._files.append(os.fspath(one))
        elif one is not None:
            self._ask("Source", getattr(one, "SMProxy", one))

    def replaced_by(self, *targets: os.PathLike | str) -> list[Optional[str]]:
        """For each output, the input that it would replace, or to which the file belongs that it would
        replace; None if there is none. A folder stands for all files in it."""
        files = [_files_at(Path(target)) for target in targets]
        if not any(files):
            return [None] * len(targets)
        for file in self._files:
            self._ask("File", file)
        self._files.clear()
        self._ask("Targets", *(str(file) for group in files for file in group))
        pipeline.update_information(self._known)
        answers = iter(self._known.GetProperty("Replaced").GetElement(0).split("\x1f"))
        replaced = [[next(answers) for _ in group] for group in files]
        return [next(filter(None, group), None) for group in replaced]

    def refuse_streams(self) -> None:
        """Raises ValueError if standard output or standard error goes to an input, as with >>."""
        streams = stream_files()
        for name, replaced in zip(streams, self.replaced_by(*streams.values())):
            if replaced is not None:
                raise ValueError(f"standard {name} goes to a file of {replaced}, which is read")

    def refuse(self, *targets: os.PathLike | str) -> None:
        """Raises ValueError if one of the outputs would replace an input."""
        for target, replaced in zip(targets, self.replaced_by(*targets)):
            if replaced is None:
                continue
            what = "is" if _same(target, replaced) else f"belongs to {replaced}, which is"
            raise ValueError(f"{target}: this file {what} read: choose another name")

    def _ask(self, name: str, *values: Any) -> None:
        """Sets a property of the server's object that knows the files."""
        if self._known is None:
            pipeline.load_plugin()
            self._known = servermanager.ProxyManager().NewProxy("misc", "InputFiles")
        prop = self._known.GetProperty(name)
        if name == "Source":
            prop.RemoveAllProxies()
            prop.AddProxy(*values)
        else:
            prop.SetNumberOfElements(len(values))
            for i, value in enumerate(values):
                prop.SetElement(i, value)
        self._known.UpdateVTKObjects()
        if name == "Source":
            prop.RemoveAllProxies()  # which would keep the mesh in memory


def _files_at(path: Path) -> list[Path]:
    """The file, or all in a folder, but not in one that a link names; none if there is nothing."""
    if path.is_dir() and not path.is_symlink():
        return [entry for entry in path.rglob("*") if entry.is_file()]
    return [path] if path.is_file() else []


def stream_files() -> dict[str, str]:
    """Paths of standard output and standard error, those of them that go to files."""
    found = {}
    for name, stream in (("output", sys.stdout), ("error", sys.stderr)):
        try:
            path = f"/dev/fd/{stream.fileno()}"
        except OSError:  # a stream in memory
            continue
        if os.path.isfile(path):
            found[name] = path
    return found


def _same(a: os.PathLike | str, b: os.PathLike | str) -> bool:
    try:
        return os.path.samefile(a, b)
    except OSError:
        return False
