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

    def replaced_by(self, target: os.PathLike | str) -> Optional[str]:
        """The input that an output would replace, or to which the file belongs that it would
        replace; None if there is none. A folder stands for all files in it."""
        target = Path(target)
        if target.is_dir() and not target.is_symlink():
            found = map(self.replaced_by, (entry for entry in target.rglob("*") if entry.is_file()))
            return next(filter(None, found), None)
        if not target.is_file():
            return None
        for file in self._files:
            self._ask("File", file)
        self._files.clear()
        self._ask("Target", str(target))
        pipeline.update_information(self._known)
        return self._known.GetProperty("Replaced").GetElement(0) or None

    def refuse_streams(self) -> None:
        """Raises ValueError if standard output or standard error goes to an input, as with >>."""
        for name, path in stream_files().items():
            replaced = self.replaced_by(path)
            if replaced is not None:
                raise ValueError(f"standard {name} goes to a file of {replaced}, which is read")

    def refuse(self, *targets: os.PathLike | str) -> None:
        """Raises ValueError if one of the outputs would replace an input."""
        for target in targets:
            replaced = self.replaced_by(target)
            if replaced is None:
                continue
            what = "is" if _same(target, replaced) else f"belongs to {replaced}, which is"
            raise ValueError(f"{target}: this file {what} read: choose another name")

    def _ask(self, name: str, value: Any) -> None:
        """Sets a property of the server's object that knows the files."""
        if self._known is None:
            pipeline.load_plugin()
            self._known = servermanager.ProxyManager().NewProxy("misc", "InputFiles")
        prop = self._known.GetProperty(name)
        if name == "Source":
            prop.RemoveAllProxies()
            prop.AddProxy(value)
        else:
            prop.SetElement(0, value)
        self._known.UpdateVTKObjects()
        if name == "Source":
            prop.RemoveAllProxies()  # which would keep the mesh in memory


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
