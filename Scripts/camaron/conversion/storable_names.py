# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Replaces names of arrays and blocks, and integers, that the files of ParaView's writers cannot
store."""

from __future__ import annotations

import functools
import os
import re
from pathlib import Path
from typing import Any, BinaryIO, Iterable, Iterator, Optional, Union

from paraview import servermanager
from vtkmodules import vtkCommonCore
from vtkmodules.vtkCommonCore import vtkIntArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from ..common import formats, pipeline, text

#: Formats of VTK's XML writers, and all XML formats, whose names must not contain control
#: characters.
OF_VTK = {f".{parallel}vt{kind}" for parallel in ("", "p") for kind in ("u", "p", "s", "r", "i")}
OF_VTK |= {".pvd", ".vtm", ".vtmb", ".vtpc", ".vtpd"}
XML = OF_VTK | {".xmf", ".xdmf"}
#: HDF5 formats, in which a slash separates the parts of a path.
HDF5 = {".vtkhdf"}
#: Tables, whose writer does not quote marks within names and texts.
TABLES = {".csv", ".tsv", ".txt"}
#: Special characters of XML, and white space, which attributes preserve as references only.
REFERENCES = {
    "&": "&amp;",
    "<": "&lt;",
    ">": "&gt;",
    '"': "&quot;",
    "\t": "&#9;",
    "\n": "&#10;",
    "\r": "&#13;",
}
#: Characters that XML cannot contain, and names in HDF5.
NOT_XML = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffd-\uffff]")
NOT_HDF5 = re.compile("/")

#: Formats whose writers truncate integers to 32 bits, or omit arrays of 64-bit integers, and the
#: replacement types.
OF_IOSS = {".exo", ".gen", ".par", ".exii", ".exoii"}
EXODUS = OF_IOSS | {".e", ".g", ".ex2", ".ex2v2"}  # those of IOSS, too, since ParaView 6
LONG_INTEGERS = {".vtk": "Int64", ".xmf": "Double", **dict.fromkeys(EXODUS, "Double")}
#: Formats of real numbers, with the number of bits of integers that they store exactly.
LARGEST_INTEGERS = {
    **dict.fromkeys((".case", ".encas"), 24),
    **dict.fromkeys((*EXODUS, ".xmf"), 53),
}

#: VTK's numbers of integer types that may have 64 bits.
INTEGERS = [
    getattr(vtkCommonCore, f"VTK_{name}")
    for name in ("LONG", "UNSIGNED_LONG", "LONG_LONG", "UNSIGNED_LONG_LONG", "ID_TYPE")
]

#: VTK returns names that are not valid UTF-8 as bytes.
Name = Union[str, bytes]


def writable(proxy: Any, target: Path, notes: list[str]) -> tuple[Any, dict[str, str]]:
    """The source, or a filter with names and integers that the file can store; and new names of
    arrays by old ones.

    VTK's writers do not escape names of arrays in XML; with special characters as references, they
    can be read again. Names with characters that XML cannot contain are changed. Changed names and
    rounded integers are added to `notes`.
    """
    suffix = target.suffix.lower()
    bits = LARGEST_INTEGERS.get(suffix, 0)
    rounded = _integers_beyond(proxy, 2**bits) if bits else []
    if rounded:
        names = text.printable(", ".join(map(_text, rounded)))
        notes.append(
            f"*{suffix} files store real numbers: integers beyond 2^{bits} are rounded in {names}."
        )
    arrays, blocks = _new_names_of(proxy, suffix, notes) if suffix in XML | HDF5 else ({}, {})
    if suffix in TABLES:
        arrays = {name: _quoted(name) for name in _names(proxy)[0] if name != _quoted(name)}
    integers = LONG_INTEGERS.get(suffix, "Keep") if _integers_beyond(proxy, 2**31 - 1) else "Keep"
    if not arrays and not blocks and integers == "Keep" and suffix not in TABLES:
        return proxy, {}
    manager = servermanager.vtkSMProxyManager.GetProxyManager()
    renamed = servermanager._getPyProxy(manager.NewProxy("internal_filters", "RenameData"))
    renamed.Input = proxy
    renamed.LongIntegers = integers
    renamed.QuotesTexts = int(suffix in TABLES)
    for key, names in (("ArrayNames", arrays), ("BlockNames", blocks)):
        prop = renamed.SMProxy.GetProperty(key)
        for i, word in enumerate(word for pair in names.items() for word in pair):
            prop.SetElement(i, word)
    renamed.SMProxy.UpdateVTKObjects()
    renamed.UpdatePipeline()
    return renamed, arrays


def _new_names_of(
    proxy: Any, suffix: str, notes: list[str]
) -> tuple[dict[Name, str], dict[Name, str]]:
    """New names of arrays and of blocks that change, by their old names."""
    forbidden = NOT_XML if suffix in XML else NOT_HDF5
    escapes = suffix in OF_VTK and not _vtk_escapes()
    arrays, blocks = _names(proxy)
    changed: dict[Name, str] = {}
    white = "\t\n\r" if suffix in XML else ""
    array_names = _new_names(arrays, forbidden, "" if escapes else white, changed)
    block_names = _new_names(blocks, forbidden, white, changed)
    if escapes:
        array_names = {
            old: new.translate(str.maketrans(REFERENCES)) for old, new in array_names.items()
        }
    array_names, block_names = (
        {old: new for old, new in names.items() if old != new}
        for names in (array_names, block_names)
    )
    if changed:
        pairs = (f"'{text.printable(_text(old))}' to '{new}'" for old, new in changed.items())
        notes.append(f"Names that *{suffix} files cannot store are changed: {', '.join(pairs)}.")
    return array_names, block_names


def _quoted(name: Name) -> str:
    """A name in the header of a table."""
    return text.no_formula(_text(name)).replace('"', '""')


def usual_mark(writer: Any) -> Optional[str]:
    """Makes a writer of tables enclose texts in the usual quotation marks, which names and values double. Returns the
    mark that the options chose instead, for `set_mark`; None if they chose none."""
    mark = writer.StringDelimiter if writer.UseStringDelimiter else ""
    if mark and mark == writer.FieldDelimiter:
        raise RuntimeError("string-delimiter and field-delimiter must be different")
    if writer.FieldDelimiter == '"':
        raise RuntimeError("field-delimiter cannot be the quotation mark")
    writer.StringDelimiter, writer.UseStringDelimiter = '"', 1
    return None if mark == '"' else mark


def set_mark(folder: Path, mark: str) -> None:
    """Encloses the texts of all tables in a folder by another mark, which is doubled in them; or by none."""
    new = os.fsencode(mark)

    def other(text: re.Match[bytes]) -> bytes:
        return new + text[1].replace(b'""', b'"').replace(new, new + new) + new

    for table in list(folder.iterdir()):
        changed = table.with_name(table.name + ".changed")
        with open(table, "rb") as old, open(changed, "wb") as file:
            for lines in _whole_lines(old):
                file.write(re.sub(rb'"((?:[^"]|"")*)"', other, lines))
        changed.replace(table)


def _whole_lines(table: BinaryIO) -> Iterator[bytes]:
    """A table, about a megabyte at a time, in parts that do not end within a text."""
    while lines := table.readlines(1 << 20):
        marks = sum(line.count(b'"') for line in lines)
        while marks % 2 and (line := table.readline()):
            lines.append(line)
            marks += line.count(b'"')
        yield b"".join(lines)


def choose_renamed(writer: Any, names: dict[str, str]) -> None:
    """Makes a writer with a choice of arrays use their new names."""
    for key in writer.ListProperties() if names else ():
        if formats.plain(key) in formats.ARRAY_LISTS:
            chosen = list(getattr(writer, key))
            setattr(writer, key, [names.get(name, name) for name in chosen])


def _integers_beyond(proxy: Any, limit: int) -> list[Name]:
    """Names of arrays, on all ranks, with integers whose magnitude is (or, as a double, may be)
    larger than the limit."""
    limit -= limit >= 2**53
    found = {}
    for array in _arrays(proxy):
        if array.GetDataType() in INTEGERS:
            ranges = [array.GetComponentRange(c) for c in range(array.GetNumberOfComponents())]
            if any(low <= high and max(-low, high) > limit for low, high in ranges):
                found[array.GetName()] = None
    return list(found)


def _arrays(proxy: Any) -> Iterator[Any]:
    """Information about the arrays of points, cells, the mesh, tables and graphs, on all ranks."""
    information = pipeline.data_information(proxy)
    for kind in range(7):
        data = information.GetAttributeInformation(kind)
        for i in range(data.GetNumberOfArrays() if data else 0):
            yield data.GetArrayInformation(i)


def _names(proxy: Any) -> tuple[list[Name], list[Name]]:
    """Names of arrays and their components, and of blocks, on all ranks."""
    information = pipeline.data_information(proxy)
    arrays: list[Optional[Name]] = []
    for array in _arrays(proxy):
        components = range(
            array.GetNumberOfComponents() if array.GetNumberOfComponents() > 1 else 0
        )
        arrays += [array.GetName(), *map(array.GetComponentName, components)]
    hierarchy = information.GetHierarchy() if pipeline.is_composite(proxy) else None
    nodes = hierarchy.GetChildNodes(hierarchy.GetRootNode(), True) if hierarchy else []
    blocks = [hierarchy.GetAttributeOrDefault(node, "label", "") for node in nodes]
    return [name for name in arrays if name], [name for name in blocks if name]


def _text(name: Name) -> str:
    return name if isinstance(name, str) else name.decode("utf-8", "surrogateescape")


def _new_names(
    names: Iterable[Name], forbidden: re.Pattern[str], also: str, changed: dict[Name, str]
) -> dict[Name, str]:
    """Maps names to names without forbidden characters and those in `also`; different names are
    added to `changed`."""
    names = list(dict.fromkeys(names))
    new: dict[Name, str] = {}
    for name in names:
        good = "".join("_" if c in also or forbidden.match(c) else c for c in _text(name))
        while good != name and (good in names or good in new.values()):
            good += "_"
        new[name] = good
        if good != name:
            changed[name] = good
    return new


@functools.lru_cache(maxsize=None)
def _vtk_escapes() -> bool:
    """Whether VTK's writers escape names of arrays."""
    array = vtkIntArray()
    array.SetName("a&b")
    data = vtkPolyData()
    data.GetFieldData().AddArray(array)
    writer = vtkXMLPolyDataWriter()
    writer.WriteToOutputStringOn()
    writer.SetInputData(data)
    writer.Write()
    return "a&amp;b" in writer.GetOutputString()
