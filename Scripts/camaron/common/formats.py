# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The formats of files: who reads and writes them, and with which options.

What ParaView knows is asked of its proxies; which of these are the plugin's own says `formats.json`
beside the plugin, which the build makes of Readers/Formats.cmake.
"""

from __future__ import annotations

import difflib
import json
import os
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Iterator, Optional

from paraview import servermanager
from paraview.modules.vtkRemotingCore import vtkPVPluginTracker


#: The property that lets a writer heed lists of arrays; naming arrays sets it.
CHOOSES_ARRAYS = "ChooseArraysToWrite"
#: Properties of writers that are set otherwise, and lists of arrays that no mesh has.
NOT_OPTIONS = {"input", "filename", "choosearraystowrite"}
NOT_OPTIONS |= {"edgedataarrays", "rowdataarrays", "vertexdataarrays"}
#: Lists of arrays by plain name: what people call it, and where a source has these arrays.
ARRAY_LISTS = {
    "pointdataarrays": ("array of points", "PointData"),
    "celldataarrays": ("array of cells", "CellData"),
    "fielddataarrays": ("array of the mesh", "FieldData"),
}
#: The last extension of a file that names others, one for each time step: part.visf.series.
SERIES = ".series"


@dataclass
class Format:
    """A kind of files. `reader` and `writer` are names of proxies, `own` tells the plugin's."""

    description: str
    extensions: list[str]
    reader: Optional[str] = None
    writers: list[str] = field(default_factory=list)
    own: bool = False


@dataclass
class Option:
    """A property of a writer as people see it: name on the command line, choices or limits, default."""

    key: str
    flag: str
    choices: list[str]
    limits: str
    default: str
    text: str

    def describe(self) -> str:
        """`--data-mode ascii|binary|appended (appended)`"""
        values = "|".join(self.choices) or self.limits or "VALUE"
        return f"--{self.flag} {values}" + (f" ({self.default})" if self.default else "")


def plain(word: Any) -> str:
    """What is left of a name when its spelling does not matter."""
    return re.sub(r"[^a-z0-9]", "", str(word).lower())


def suggestion(word: str, known: Any) -> str:
    """` (did you mean ...?)`, or nothing; `known` may map plain names to real ones."""
    close = difflib.get_close_matches(word, list(known), 1)
    if not close:
        return ""
    best = known[close[0]] if isinstance(known, dict) else close[0]
    return f" (did you mean {best}?)"


def own_formats() -> list[dict[str, Any]]:
    """The table of the plugin's formats as the build made it; empty for a plugin without one."""
    tracker = vtkPVPluginTracker.GetInstance()
    for i in range(tracker.GetNumberOfPlugins()):
        if tracker.GetPluginName(i) == "Camaron" and tracker.GetPluginLoaded(i):
            path = Path(tracker.GetPluginFileName(i)).with_name("formats.json")
            if path.exists():
                return json.loads(path.read_text(encoding="utf-8"))
    return []


def _hints(group: str, tag: str) -> Iterator[tuple[str, str, list[str]]]:
    """Name of the proxy, description and extensions of every reader or writer."""
    manager = servermanager.vtkSMProxyManager.GetProxyManager().GetActiveSessionProxyManager()
    iterator = manager.GetProxyDefinitionManager().NewSingleGroupIterator(group)
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        hints = iterator.GetProxyDefinition().FindNestedElementByName("Hints")
        for i in range(hints.GetNumberOfNestedElements() if hints else 0):
            hint = hints.GetNestedElement(i)
            if hint.GetName() == tag:
                extensions = (hint.GetAttribute("extensions") or "").split()
                patterns = (hint.GetAttribute("filename_patterns") or "").split()
                kinds = ["." + e for e in extensions if not e.endswith(SERIES)] + patterns
                if kinds:  # former names of readers have none
                    yield iterator.GetProxyName(), hint.GetAttribute(
                        "file_description"
                    ) or "", kinds
        iterator.GoToNextItem()


def known_formats() -> list[Format]:
    """All formats, the plugin's own first, the others by name."""
    own = own_formats()
    readers = {f["reader"] for f in own}
    writers = {f["writer"]: f for f in own}
    formats = []
    for name, description, kinds in _hints("sources", "ReaderFactory"):
        formats.append(Format(description, kinds, name, [], name in readers))
    by_reader = {f.reader: f for f in formats if f.own}
    for name, description, kinds in _hints("writers", "WriterFactory"):
        if name in writers:
            match = by_reader.get(writers[name]["reader"])
        else:
            match = max(
                (f for f in formats if not f.own and set(kinds) & set(f.extensions)),
                key=lambda f: len(set(kinds) & set(f.extensions)) / len(f.extensions),
                default=None,
            )
        if match is None:
            match = Format(description, kinds, None, [], name in writers)
            formats.append(match)
        match.writers.append(name)
    return sorted(formats, key=lambda f: (not f.own, f.description.lower()))


def own_readers(path: os.PathLike | str) -> list[str]:
    """Proxies of the plugin that read files of such a name, or a series of them."""
    name = Path(path).name.lower().removesuffix(SERIES)
    return [
        f["reader"]
        for f in own_formats()
        if f["reader"] and any(name.endswith("." + e.lower()) for e in f["extensions"])
    ]


def own_writer(path: os.PathLike | str) -> Optional[str]:
    """The proxy of the plugin that writes files of such a name, or None."""
    suffix = Path(path).suffix.lower()
    names = {f["writer"] for f in own_formats()} - {None, ""}
    for name, _, kinds in _hints("writers", "WriterFactory"):
        if name in names and suffix in [kind.lower() for kind in kinds]:
            return name
    return None


def written_extensions() -> set[str]:
    """Extensions of the files that somebody writes, whatever the mesh: {".ele", ".vtu", ...}."""
    return {kind.lower() for _, _, kinds in _hints("writers", "WriterFactory") for kind in kinds}


def written_instead(path: os.PathLike | str) -> Optional[str]:
    """The name of the file to write for one of an extension that the plugin reads, but nobody writes."""
    path, suffix = Path(path), Path(path).suffix.lower()
    if suffix in written_extensions():
        return None
    kinds = {name: kinds for name, _, kinds in _hints("writers", "WriterFactory")}
    for f in own_formats():
        if suffix[1:] in f["extensions"] and kinds.get(f["writer"]):
            return path.stem + kinds[f["writer"]][0]
    return None


def own_extensions(writer: Optional[str]) -> list[str]:
    """Extensions of the files of the plugin's format with that writer: [".ele", ".node", ...]."""
    return [
        "." + e.lower()
        for f in own_formats()
        if writer and f["writer"] == writer
        for e in f["extensions"]
    ]


def own_counterpart(reader: str) -> Optional[str]:
    """The proxy of the plugin that writes what a proxy of it reads, or None."""
    return next((f["writer"] for f in own_formats() if f["reader"] == reader), None)


def make_writer(name: str) -> Any:
    """A writer of its own, with nothing to write yet."""
    manager = servermanager.vtkSMProxyManager.GetProxyManager()
    return servermanager._getPyProxy(manager.NewProxy("writers", name))


def options(writer: Any) -> dict[str, Option]:
    """What can be chosen of a writer, by plain name."""
    found = {}
    for key in writer.ListProperties():
        prop = writer.GetProperty(key)
        smproperty = prop.SMProperty
        if plain(key) in NOT_OPTIONS or smproperty.GetIsInternal():
            continue
        choices = [_word(choice) for choice in getattr(prop, "Available", None) or [] if choice]
        value = prop.GetData() if choices else writer.GetPropertyValue(key)
        if _is_array_list(writer, key):
            flag = _word(smproperty.GetXMLLabel() or key)
            text = f"Which are written, by the name of every {ARRAY_LISTS[plain(key)][0]}."
            found[plain(key)] = Option(key, flag, [], "NAME,NAME|none", "all", text)
            continue
        if smproperty.FindDomain("vtkSMArrayListDomain"):
            choices, value = [], "none"  # which there are depends on the mesh
        if not isinstance(value, (str, int, float)):
            continue  # lists of arrays, other proxies
        if smproperty.FindDomain("vtkSMBooleanDomain"):
            choices, value = ["on", "off"], "on" if value else "off"
        documentation = smproperty.GetDocumentation()
        text = " ".join((documentation.GetDescription() or "").split()) if documentation else ""
        flag = _word(smproperty.GetXMLLabel() or key)
        default = _word(value) if choices else str(value)
        low, high = _limits(smproperty)
        limits = "" if low is None or high is None else f"{low}..{high}"
        found[plain(key)] = Option(key, flag, choices, limits, default, text)
    return found


def _limits(smproperty: Any) -> tuple[Optional[float], Optional[float]]:
    """The smallest and the largest number that a property takes; None where there is no limit."""
    for kind in ("vtkSMIntRangeDomain", "vtkSMDoubleRangeDomain"):
        domain = smproperty.FindDomain(kind)
        if domain:
            low = domain.GetMinimum(0) if domain.GetMinimumExists(0) else None
            high = domain.GetMaximum(0) if domain.GetMaximumExists(0) else None
            return low, high
    return None, None


def _word(text: Any) -> str:
    """`Binary Little Endian` as people type it: `binary-little-endian`."""
    return re.sub(r"[^a-z0-9.]+", "-", str(text).lower()).strip("-")


def describe_options(writer: Any, indent: str = "  ") -> list[str]:
    """One line for each option of a writer."""
    return [indent + option.describe() for option in options(writer).values()]


def describe_formats() -> str:
    """All formats as text, with the options of their writers."""
    lines = []
    formats, written = known_formats(), written_extensions()
    for own, title in ((True, "Formats of the plugin"), (False, "Formats of ParaView")):
        lines += ["", f"{title} (r: read, w: written):"]
        for f in formats:
            if f.own != own:
                continue
            mode = ("r" if f.reader else "-") + ("w" if f.writers else "-")
            without = [e for e in f.extensions if f.writers and e.lower() not in written]
            remark = f" (not for OUT: {' '.join(without)})" if without else ""
            lines.append(f"  {mode}  {f.description}: {' '.join(f.extensions)}{remark}")
            seen: set[str] = set()
            for name in f.writers:
                for line in describe_options(make_writer(name), "        "):
                    if line not in seen:
                        lines.append(line)
                    seen.add(line)
    return "\n".join(lines[1:])


def set_option(writer: Any, name: str, value: Any) -> None:
    """Sets a property by a name in any spelling; texts become what the property holds.

    Raises ValueError with a list of what there is for a name or a value that the writer does not
    know.

    >>> set_option(writer, "data-mode", "ascii")
    """
    known = options(writer)
    hidden = {plain(key): key for key in writer.ListProperties()}
    key = plain(name)
    if key not in known and (key not in hidden or key in ("input", "filename")):
        lines = "\n".join(describe_options(writer))
        names = {k: option.flag for k, option in known.items()}
        raise ValueError(
            f"unknown option {name}{suggestion(key, names)}; "
            + (f"options of this format are\n{lines}" if known else "this format has none")
        )
    prop = hidden[key]
    if _is_array_list(writer, prop):
        _choose_arrays(writer, prop, name, value)
        return
    choices = getattr(writer.GetProperty(prop), "Available", None)
    if choices:
        by_text = {plain(choice): choice for choice in choices}
        if plain(value) not in by_text:
            words = ", ".join(map(_word, choices))
            raise ValueError(f"{name} is one of {words}, not {value}")
        setattr(writer, prop, by_text[plain(value)])
        return
    smproperty = writer.GetProperty(prop).SMProperty
    if smproperty.FindDomain("vtkSMBooleanDomain"):
        words = {"true": 1, "yes": 1, "on": 1, "1": 1, "false": 0, "no": 0, "off": 0, "0": 0}
        if str(value).lower() not in words:
            raise ValueError(f"{name} is on or off, not {value}")
        value = words[str(value).lower()]
    number = _number(value)
    low, high = _limits(smproperty)
    if (low, high) != (None, None):
        whole = smproperty.IsA("vtkSMIntVectorProperty")
        if (
            not isinstance(number, int if whole else (int, float))
            or (low is not None and not low <= number)
            or (high is not None and not number <= high)
        ):
            kind = "whole number" if whole else "number"
            limits = f"from {low} to {high}" if high is not None else f"of at least {low}"
            raise ValueError(f"{name} is a {kind} {limits}, not {value}")
    try:
        setattr(writer, prop, number)
    except (ValueError, TypeError, RuntimeError):
        raise ValueError(f"{name} cannot be {value!r}") from None


def _is_array_list(writer: Any, key: str) -> bool:
    return plain(key) in ARRAY_LISTS and CHOOSES_ARRAYS in writer.ListProperties()


def _choose_arrays(writer: Any, key: str, name: str, value: Any) -> None:
    """Lets a writer write only these arrays of points, of cells or of the mesh, and all of the others."""
    there = {k: _arrays(writer, k) for k in writer.ListProperties() if _is_array_list(writer, k)}
    known = there[key]
    if not isinstance(value, str):
        wanted = list(value)
    elif value in known:  # its name may have commas
        wanted = [value]
    elif value.lower() in ("all", "none", ""):
        wanted = known if value.lower() == "all" else []
    else:
        wanted = [word.strip() for word in value.split(",")]
    for word in wanted:
        if word not in known:
            what = ARRAY_LISTS[plain(key)][0]
            listed = f"there are {', '.join(known)}" if known else "there are none"
            raise ValueError(
                f"{name}: no {what} is named {word}{suggestion(word, known)}; {listed}"
            )
    if not writer.GetPropertyValue(CHOOSES_ARRAYS):
        setattr(writer, CHOOSES_ARRAYS, 1)
        for other in there:  # for the plugin's own writers none is the default then
            setattr(writer, other, there[other])
    setattr(writer, key, wanted)


def _arrays(writer: Any, key: str) -> list[str]:
    """Names of the arrays that a list of arrays may hold; none for a writer with nothing to write."""
    source = writer.Input
    return list(getattr(source, ARRAY_LISTS[plain(key)][1]).keys()) if source else []


def _number(value: Any) -> Any:
    """The number a text says, else the text."""
    if not isinstance(value, str):
        return value
    for kind in (int, float):
        try:
            return kind(value)
        except ValueError:
            pass
    return value
