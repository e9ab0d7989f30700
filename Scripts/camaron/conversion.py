# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""From any mesh that can be read to any format that can be written."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any, Optional

from paraview import servermanager, simple

from . import formats, pipeline
from .files import Staging, same_file

#: Extensions of formats that hold blocks; a mesh of blocks is merged for any other.
FORMATS_WITH_BLOCKS = {".vtm", ".vtmb", ".vtpc", ".vtpd", ".vtkhdf", ".cgns", ".ex2", ".exo", ".e"}


def convert(
    source: os.PathLike | str, target: os.PathLike | str, *, time: str = "last", **options: Any
) -> list[str]:
    """Writes the mesh of one file to another; the format follows from the name of the target.

    Formats of the plugin are written by its own writers, others by ParaView's. `options` are
    properties of the writer, in any spelling: `file_type="Ascii"` sets FileType. If a format of
    ParaView cannot hold the mesh as it is, blocks are merged, surfaces become unstructured grids,
    and for formats that know surfaces only, the boundary is written; those of the plugin do as
    their options say. What a reader has in further outputs, like boundaries by zone, goes along if
    the format stays the same. Returns what was done besides writing, and what the reader and the
    writer warn of, one sentence each.

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
        if opened.time and opened.time["steps"] > 1 and not _writes_all_steps(options):
            notes.append(
                f"Of {opened.time['steps']} time steps number {opened.time['step']}, counted from 0,"
                f" was taken (time {opened.time['value']:g})."
            )
        proxy = _suitable(made, target, notes)
        write(proxy, target, options, notes)
        return notes
    finally:
        for proxy in reversed(made):
            simple.Delete(proxy)


def _writes_all_steps(options: dict[str, Any]) -> bool:
    names = {"writetimesteps", "writealltimesteps", "writetimestepsasfileseries"}
    return any(
        formats.plain(name) in names and str(value).lower() not in ("0", "off", "no", "false")
        for name, value in options.items()
    )


def _suitable(made: list[Any], target: Path, notes: list[str]) -> Any:
    """What of the mesh the format can hold; adds the filters it takes to `made`."""
    suffix = target.suffix.lower()
    writer = formats.own_writer(target)
    others = _further_outputs(made[0])
    if others and writer == formats.own_counterpart(made[0].GetXMLName()):
        made.append(simple.GroupDatasets(Input=[made[0], *others]))
        return made[-1]
    for output in others:
        notes.append(f"The output {_describe_output(output)} of the reader was not written.")
    if writer:
        return made[0]  # takes any mesh, blocks too

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
    if suffix in {kind for f in formats.known_formats() for kind in f.extensions if f.writers}:
        raise ValueError(f"{target}: files named *{suffix} cannot hold a mesh like this")
    raise ValueError(
        f"{target}: no writer for {suffix}{formats.suggestion(suffix, known)}; "
        f"known are {' '.join(sorted(known))}"
    )


def _further_outputs(source: Any) -> list[Any]:
    """What a reader has beside the mesh, like boundaries by zone, as far as there is any."""
    ports = range(1, source.SMProxy.GetNumberOfOutputPorts())
    return [
        simple.OutputPort(source, port)
        for port in ports
        if pipeline.data_information(source, port).GetNumberOfCells() > 0
    ]


def _describe_output(output: Any) -> str:
    """`Boundaries (inlet, outlet)`"""
    name = output.SMProxy.GetOutputPortName(output.Port)
    hierarchy = output.GetDataInformation().GetHierarchy()
    if hierarchy is None:
        return name
    blocks = [hierarchy.GetNodeName(i) for i in hierarchy.GetChildNodes(hierarchy.GetRootNode())]
    return f"{name} ({', '.join(blocks)})"


def _is_volume(proxy: Any) -> bool:
    return not pipeline.data_information(proxy).DataSetTypeIsA("vtkPolyData")


def writable_extensions(proxy: Any) -> set[str]:
    """Extensions of the formats that can hold the output of the source, like ".vtu"."""
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
    if not factory.GetNumberOfRegisteredPrototypes():
        factory.UpdateAvailableWriters()
    types = factory.GetSupportedFileTypes(proxy.SMProxy, 0)
    return {"." + extension.lower() for extension in re.findall(r"\*\.([\w.]+)", types)}


def write(
    proxy: Any,
    target: os.PathLike | str,
    options: dict[str, Any],
    notes: Optional[list[str]] = None,
) -> list[str]:
    """Writes to a temporary name, then renames; returns the names of the files and folders made.

    Formats of several files (.vtm, .node and .ele) have further names. What the writer warns of is
    added to `notes`.
    """
    target = Path(target)
    with Staging(target.parent) as staging, pipeline.Messages() as messages:
        writer = _make_writer(proxy, staging.path / target.name)
        try:
            for name, value in options.items():
                formats.set_option(writer, name, value)
            writer.UpdatePipeline()
        except RuntimeError as error:
            messages.errors.append(str(error))
        finally:
            simple.Delete(writer)
        names = staging.names()
        if messages.errors or not names:
            reason = messages.errors[0] if messages.errors else "nothing was written"
            raise RuntimeError(_with_path(target, reason))
        staging.publish()
        if notes is not None:
            notes += messages.warnings
    return names


def _make_writer(proxy: Any, path: Path) -> Any:
    """The plugin's own writer for such a name, else ParaView's."""
    name = formats.own_writer(path)
    if name is None:
        return simple.CreateWriter(str(path), proxy)
    writer = formats.make_writer(name)
    writer.Input = proxy
    writer.FileName = str(path)
    return writer


def _with_path(target: Path, reason: str) -> str:
    """The reason with the path once; the plugin's writers begin with the name."""
    if reason.startswith(target.name + ": "):
        reason = reason[len(target.name) + 2 :]
    return f"{target}: {reason}"
