# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""From any mesh that can be read to any format that can be written."""

from __future__ import annotations

import difflib
import os
import re
from pathlib import Path
from typing import Any

from paraview import servermanager, simple

from . import pipeline
from .files import Staging, same_file

#: Extensions of formats that hold blocks; a mesh of blocks is merged for any other.
FORMATS_WITH_BLOCKS = {".vtm", ".vtmb", ".vtpc", ".vtpd", ".vtkhdf", ".cgns", ".ex2", ".exo", ".e"}


def convert(
    source: os.PathLike | str, target: os.PathLike | str, *, time: str = "last", **options: Any
) -> list[str]:
    """Writes the mesh of one file to another; the format follows from the name of the target.

    `options` are properties of the writer, in any spelling: `file_type="Ascii"` sets FileType. If
    the format cannot hold the mesh as it is, blocks are merged, surfaces become unstructured grids,
    and for formats that know surfaces only, the boundary is written. Returns what was done besides
    writing, one sentence each.

    >>> convert("part.visf", "part.vtu", compressor_type="LZ4")
    []
    >>> convert("part.visf", "part.stl")
    ['The boundary surface was written, as triangles.']
    """
    target = Path(target)
    if not target.suffix:
        raise ValueError(
            f"{target}: the name of the target needs an extension, it tells the format"
        )
    if same_file(source, target):
        raise ValueError(f"{target}: source and target are the same file")
    pipeline.load_plugin()
    opened = pipeline.open_mesh(source, time)
    made = [opened.source]
    try:
        notes = list(opened.warnings)
        if opened.time and opened.time["steps"] > 1:
            notes.append(
                f"Of {opened.time['steps']} time steps number {opened.time['step']}, counted from 0, was taken"
                f" (time {opened.time['value']:g})."
            )
        proxy = _suitable(made, target, notes)
        write(proxy, target, options)
        return notes
    finally:
        for proxy in reversed(made):
            simple.Delete(proxy)


def _suitable(made: list[Any], target: Path, notes: list[str]) -> Any:
    """What of the mesh the format can hold; adds the filters it takes to `made`."""
    suffix = target.suffix.lower()

    def fits(proxy) -> bool:
        return suffix in writable_extensions(proxy)

    def append(proxy) -> Any:
        proxy.UpdatePipeline()
        made.append(proxy)
        return proxy

    proxy = made[0]
    if pipeline.is_composite(proxy) and suffix not in FORMATS_WITH_BLOCKS:
        proxy = append(simple.MergeBlocks(Input=proxy))
        notes.append("The blocks were merged.")
    if fits(proxy) and not (suffix == ".stl" and _is_volume(proxy)):
        return append(simple.Triangulate(Input=proxy)) if suffix == ".stl" else proxy
    grid = append(simple.AppendDatasets(Input=proxy))
    if fits(grid) and suffix != ".stl":
        return grid
    surface = append(simple.MeshSurface(Input=proxy))
    if fits(surface):
        if suffix == ".stl":
            notes.append("The boundary surface was written, as triangles.")
            return append(simple.Triangulate(Input=surface))
        notes.append("The boundary surface was written.")
        return surface
    known = writable_extensions(made[0]) | writable_extensions(grid) | writable_extensions(surface)
    raise ValueError(
        f"{target}: no writer for {suffix}{_suggestion(suffix, known)}; "
        f"known are {' '.join(sorted(known))}"
    )


def _is_volume(proxy: Any) -> bool:
    return not pipeline.data_information(proxy).DataSetTypeIsA("vtkPolyData")


def writable_extensions(proxy: Any) -> set[str]:
    """Extensions of the formats that can hold the output of the source, like ".vtu"."""
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
    if not factory.GetNumberOfRegisteredPrototypes():
        factory.UpdateAvailableWriters()
    types = factory.GetSupportedFileTypes(proxy.SMProxy, 0)
    return {"." + extension.lower() for extension in re.findall(r"\*\.([\w.]+)", types)}


def write(proxy: Any, target: os.PathLike | str, options: dict[str, Any]) -> list[str]:
    """Writes to a temporary name, then renames; returns the names of the files and folders made.

    Formats of several files (.vtm, .pvtu) have a folder named like the target without extension.
    """
    target = Path(target)
    with Staging(target.parent) as staging, pipeline.Messages() as messages:
        writer = simple.CreateWriter(str(staging.path / target.name), proxy)
        for name, value in options.items():
            set_option(writer, name, value)
        try:
            writer.UpdatePipeline()
        except RuntimeError as error:
            messages.errors.append(str(error))
        finally:
            simple.Delete(writer)
        names = staging.names()
        if messages.errors or not names:
            reason = messages.errors[0] if messages.errors else "nothing was written"
            raise RuntimeError(f"{target}: {reason}")
        staging.publish()
    return names


def set_option(proxy: Any, name: str, value: Any) -> None:
    """Sets a property by a name in any spelling; texts become what the property holds.

    Raises ValueError for a name or a value that the proxy does not know.
    """
    plain = lambda text: re.sub(r"[^a-z0-9]", "", str(text).lower())
    hidden = {"input", "filename"}
    known = {plain(p): p for p in proxy.ListProperties() if plain(p) not in hidden}
    if plain(name) not in known:
        raise ValueError(
            f"unknown option {name}{_suggestion(plain(name), known)}; "
            f"options are {' '.join(sorted(known.values()))}"
        )
    key = known[plain(name)]
    choices = getattr(proxy.GetProperty(key), "Available", None)
    if choices:
        by_text = {plain(choice): choice for choice in choices}
        if plain(value) not in by_text:
            raise ValueError(f"{name} is one of {', '.join(map(str, choices))}, not {value}")
        setattr(proxy, key, by_text[plain(value)])
        return
    try:
        setattr(proxy, key, _number(value))
    except (ValueError, TypeError, RuntimeError):
        raise ValueError(f"{name} cannot be {value!r}") from None


def _number(value: Any) -> Any:
    """The number a text says, else the text; words for yes and no become 1 and 0."""
    if not isinstance(value, str):
        return int(value) if isinstance(value, bool) else value
    words = {"true": 1, "yes": 1, "on": 1, "false": 0, "no": 0, "off": 0}
    if value.lower() in words:
        return words[value.lower()]
    for kind in (int, float):
        try:
            return kind(value)
        except ValueError:
            pass
    return value


def _suggestion(word: str, known: Any) -> str:
    close = difflib.get_close_matches(word, list(known), 1)
    if not close:
        return ""
    best = known[close[0]] if isinstance(known, dict) else close[0]
    return f" (did you mean {best}?)"
