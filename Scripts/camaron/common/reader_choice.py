# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Chooses the reader of a file."""

from __future__ import annotations

import json
from math import isfinite
from pathlib import Path
from typing import Any, Optional

import paraview
from paraview import servermanager, simple

from . import formats, pipeline


#: What a series of files looks like.
A_SERIES = '{"file-series-version": "1.0", "files": [{"name": "NAME", "time": 0}, ...]}'
#: Extensions of files that may be empty.
EMPTY_FILES = {".foam"}


class NotReadable(RuntimeError):
    """No reader accepts the file; the message has the reason, without the file name."""


def make_reader(path: Path, notes: list[str]) -> Any:
    """A reader for the file, not updated yet.

    If both the plugin and ParaView have a reader for the extension, the plugin's reader is used if
    it accepts the content, else ParaView's. If no reader accepts the file, the plugin's reader is
    used, so its error explains the problem. If the content has a different format than the
    extension suggests, this is added to `notes`.
    """
    if path.exists() and not path.is_file() and not path.is_dir():
        # Readers inspect the beginning of a file before they read it, which is impossible for
        # pipes.
        raise NotReadable("this is a pipe or a device: copy its content to a file")
    if path.is_file() and path.stat().st_size == 0 and path.suffix not in EMPTY_FILES:
        raise NotReadable("the file is empty")
    first = _first_file(path) if path.is_file() and path.suffix == formats.SERIES else None
    if first and not first.exists():
        raise NotReadable(f"the first file of the series, {first}, does not exist")
    own = formats.own_readers(path)
    for name in own:
        if _can_read(path, name):
            return _make(name, path)
    if own and _is_compressed(path):  # of which ParaView's readers may never end
        return _make(own[0], path)
    other = _other_format(path)
    if other is not None:
        return _hand_over(path, *other, notes)
    if path.is_file() and path.suffix.lower() in TAKEN_BLINDLY:
        return _make(own[0], path)
    if "IOSSReader" in formats.readers(path) and _has_polyhedra_of_exodus(path):
        return _hand_over(path, *POLYHEDRA_OF_EXODUS, notes)
    # A server may run in another folder; and some readers add the folder of the file again to the names of other files
    # in it.
    absolute = path.absolute()
    # ParaView would choose its reader of Exodus for part.exo.vtu.
    by_name = formats.readers(path) if path.is_file() and path.name.count(".") > 1 else []
    for name in by_name:
        if _can_read(absolute, name):
            return _make(name, absolute)
    if not by_name:
        try:
            source = simple.OpenDataFile(str(absolute))
        except RuntimeError:
            source = None
        if source is not None:
            return source
    if path.is_dir():
        raise NotReadable("this is a folder, not a mesh")
    if own:
        return _make(own[0], path)
    kind = Path(path.name.removesuffix(formats.SERIES)).suffix or path.suffix
    if path.is_file() and _is_compressed(path):
        raise NotReadable(
            "the file is compressed (gzip), which ParaView's readers do not read: decompress it"
        )
    if formats.readers(path):
        raise NotReadable(f"no reader of *{kind} files accepts its content")
    raise NotReadable(
        f"there is no reader for {f'*{kind} files' if kind else 'files without an extension'}; "
        "camaron convert --help lists the formats"
    )


def own_reason(path: Path, source: Any) -> str:
    """What the plugin's reader for the extension expects and finds, where another reader, `source`, was used and
    found no mesh; empty if there is none, or if the content has the other reader's format."""
    own = formats.own_readers(path)
    if not own or source.GetXMLName() in own or _other_format(path):
        return ""
    with pipeline.Messages() as messages:
        reader = _make(own[0], path)
        reader.UpdatePipeline()
        simple.Delete(reader)
    return messages.errors[0] if messages.errors else ""


def _is_compressed(path: Path) -> bool:
    """Whether this is a file of gzip, or has the name of one."""
    if path.suffix.lower() == ".gz":
        return True
    if not path.is_file():
        return False
    with open(path, "rb") as file:
        return file.read(2) == b"\x1f\x8b"


def _can_read(path: Path, reader: str) -> bool:
    session = servermanager.ActiveConnection.Session
    return path.is_file() and servermanager.vtkSMReaderFactory.CanReadFile(
        str(path), "sources", reader, session
    )


def _prototype(reader: str) -> Optional[Any]:
    return servermanager.ProxyManager().GetPrototypeProxy("sources", reader)


def _make(reader: str, path: Path) -> Any:
    prototype = _prototype(reader)
    create = getattr(simple, paraview.make_name_valid(prototype.GetXMLLabel()))
    file_name = servermanager.vtkSMCoreUtilities.GetFileNameProperty(prototype)
    return create(**{file_name: str(path)})


#: Other formats with the same extensions as the plugin's, by the beginning of the file: name,
#: ParaView's readers, and the ParaView plugin that may have to be loaded first.
OTHER_FORMATS = (
    (
        b"\x89HDF",
        "a Fluent mesh in HDF5",
        ("ANSYSFluentHDF5Reader", "FLUENTCFFReader"),
        None,
    ),
    (b"$MeshFormat", "a Gmsh mesh", ("GmshReader", "GmshIO"), "GmshIO"),
    (b"$NOD", "a Gmsh mesh (version 1)", (), None),
)
OTHER_EXTENSIONS = (".msh", ".cas", ".cas.h5", ".msh.h5")
#: Extensions for which ParaView's reader of Fluent meshes accepts any content.
TAKEN_BLINDLY = (".msh", ".cas")


#: As OTHER_FORMATS: ParaView's default reader of Exodus, IOSS, refuses polyhedra.
POLYHEDRA_OF_EXODUS = ("an Exodus file with polyhedra", ("ExodusIIReader",), "LegacyExodusReader")


def _has_polyhedra_of_exodus(path: Path) -> bool:
    """Whether the header of an Exodus file has a block of cells that list their faces."""
    if not path.is_file():
        return False
    with open(path, "rb") as file:
        return b"nfaced" in file.read(1 << 20)


def _other_format(path: Path) -> Optional[tuple]:
    """The row of OTHER_FORMATS that matches the content of a file, or of the first file of a
    series."""
    if not path.is_file() or not path.name.removesuffix(formats.SERIES).lower().endswith(
        OTHER_EXTENSIONS
    ):
        return None
    if path.suffix == formats.SERIES:
        path = _first_file(path)
        if not path or not path.is_file():
            return None
    with open(path, "rb") as file:
        head = file.read(1 << 16).lstrip()
    while head.startswith(b"$Comments"):  # Gmsh allows comments at the beginning
        head = head.partition(b"$EndComments")[2].lstrip()
    return next((row[1:] for row in OTHER_FORMATS if head.startswith(row[0])), None)


def _first_file(series: Path) -> Optional[Path]:
    """The first file in a series; None if this is JSON that only ParaView may understand, as with comments. Of an entry
    without a name, or whose time is no number, ParaView's parser ends the program."""
    try:
        content = json.loads(series.read_bytes())
    except ValueError:
        return None
    files = content.get("files") if isinstance(content, dict) else None
    if not files or not isinstance(files, list):
        raise NotReadable(f"expected a series of files, {A_SERIES}")
    entries = [{"name": one} if isinstance(one, str) else one for one in files]
    for number, entry in enumerate(entries):
        if not isinstance(entry, dict) or not isinstance(entry.get("name"), str):
            raise NotReadable(f"file {number} of the series has no name: expected {A_SERIES}")
        time = entry.get("time", 0)
        if isinstance(time, (str, list, dict)) or isinstance(time, float) and not isfinite(time):
            raise NotReadable(
                f"file {number} of the series, {entry['name']}, has the time {json.dumps(time)}, expected a number"
            )
    return series.parent / entries[0]["name"]


def _hand_over(
    path: Path, kind: str, readers: tuple, plugin: Optional[str], notes: list[str]
) -> Any:
    if path.suffix == formats.SERIES:
        raise NotReadable(f"the first file of the series is {kind}: convert the files individually")
    if plugin and not any(map(_knows, readers)):
        try:
            simple.LoadDistributedPlugin(plugin, remote=False, ns=vars(simple))
        except RuntimeError:
            pass  # this ParaView was built without it
    for name in filter(_knows, readers):
        is_own = name in [f["reader"] for f in formats.own_formats()]
        whose = "" if is_own else "ParaView's own reader "
        notes.append(f"This is {kind}; {whose}{name} reads it.")
        return _make(name, path)
    help = f" (its plugin {plugin} contains one)" if plugin else ""
    raise NotReadable(f"this is {kind}, for which this ParaView has no reader{help}")


def _knows(reader: str) -> bool:
    names = servermanager.vtkSMProxyManager.GetProxyManager().GetActiveSessionProxyManager()
    return bool(names.GetProxyDefinitionManager().HasDefinition("sources", reader))
