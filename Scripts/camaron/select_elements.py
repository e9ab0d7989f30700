# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Selects elements of a mesh in steps, and writes them as ids, tables or meshes."""

from __future__ import annotations

import gzip
import os
import re
from pathlib import Path
from typing import Any, Callable, Iterable, Mapping, Optional

from paraview import simple

from . import conversion, export
from .common import mesh_facts, pipeline, tables, text
from .common.evaluation import Evaluation
from .common.formats import plain
from .common.inputs import Inputs

#: Property of SelectElements that opens the file of a closed surface.
SURFACE = "Surface"
#: Files with zones in the mesh of an OpenFOAM case, beside its sets.
ZONES = ("cellZones", "faceZones", "pointZones")
#: Properties that steps cannot set.
NO_STEP = {"Input", "Selection", "Elements", "Strategy"}
YES, NO = ("yes", "on", "true", "1"), ("no", "off", "false", "0")


def select(
    mesh: os.PathLike | str,
    steps: Iterable[str],
    outputs: Iterable[os.PathLike | str] = (),
    *,
    time: str = "last",
    reader: Optional[Mapping[str, Any]] = None,
    strict: bool = False,
    say: Callable[[str], None] = lambda words: None,
) -> dict[str, Any]:
    """Selects elements of a mesh in steps and writes them to files.

    A step is a strategy of SelectElements with properties, such as "Worst N: Array=Volume;
    NumberOfWorst=5" or "Shape: Shape=Sphere; Center=0,0,1; Radius=0.2; Combination=Subtract"; the
    next step starts from its selection. Criteria named as Array or in Rules are evaluated. `reader` has
    options of the reader by name; with `strict`, arrays that cannot be read are an error instead of a
    note. Documentation/selection.md describes the formats of the outputs: tables (.csv), ids (.txt),
    OpenFOAM's sets (any name in a folder "sets"), and meshes of the cells.

    Returns the output of `camaron select --json`. Raises ValueError for invalid steps and names,
    and for outputs that are inputs, before the mesh is read if possible, and RuntimeError for a
    mesh that cannot be read or a step that fails. Then no output is written.

    >>> camaron.select("part.visf", ["By criterion: Array=MinDihedralAngle"], ["bad.csv"])["selected"]
    12
    """
    parsed = [_with_set(Path(mesh), *_parse(step)) for step in steps]
    if not parsed:
        raise ValueError("expected at least one selection step")
    targets = [Path(output) for output in outputs]
    pipeline.load_plugin()
    for target in targets:
        if targets.count(target) > 1:
            raise ValueError(f"{target}: expected other names for the other outputs")
        if not export.is_list(target):
            conversion.check_target(target)
    values = (value for _, properties in parsed for value in properties.values())
    inputs = Inputs(mesh, *filter(os.path.isfile, values))
    inputs.refuse(*targets)
    surfaces: list[Any] = []
    with Evaluation(mesh, time, inputs=inputs, reader=reader, strict=strict) as evaluated:
        try:
            evaluated.quality.Criteria = _criteria(evaluated, parsed)
            evaluated.announce(say)
            rows, notes = [], list(evaluated.opened.warnings)
            chain = evaluated.quality
            for strategy, properties in parsed:
                chain = evaluated.make_of(chain, simple.SelectElements)
                _set(chain, strategy, properties, surfaces)
                rows.append(_run(evaluated, chain, notes))
            inputs.add(chain)  # with the surfaces
            inputs.refuse(*targets)
            _check_meshes(chain, rows[-1]["selected"], targets)
            for target in targets:
                _write(evaluated, chain, target, notes)
        finally:
            for surface in surfaces:
                simple.Delete(surface)
        return {
            "mesh": str(mesh),
            "time": evaluated.opened.time,
            "elements": chain.GetProperty("ElementType").GetData(),
            "selected": rows[-1]["selected"],
            "steps": rows,
            "outputs": [str(target) for target in targets],
            "notes": notes + mesh_facts.notes(evaluated.opened),
        }


def _parse(step: str) -> tuple[str, dict[str, str]]:
    """Splits a step into the strategy and its properties.

    >>> _parse("Worst N: Array=Volume; NumberOfWorst=5")
    ('Worst N', {'Array': 'Volume', 'NumberOfWorst': '5'})
    """
    strategy, _, rest = step.partition(":")
    properties = {}
    for item in filter(None, (part.strip() for part in rest.split(";"))):
        name, equals, value = (part.strip() for part in item.partition("="))
        if not equals:
            raise ValueError(f"step '{step}': expected NAME=VALUE, found '{item}'")
        properties[name] = value
    return strategy.strip(), properties


def _with_set(mesh: Path, strategy: str, properties: dict[str, str]) -> tuple[str, dict[str, str]]:
    """Replaces the name of a set or zone of an OpenFOAM case by the file that has it."""
    name = next((p for p in properties if plain(p) in ("name", "setname")), None)
    if plain(strategy) != "set" or not name or any(plain(p) == "setfile" for p in properties):
        return strategy, properties
    wanted = properties[name]
    folder = mesh.parent / "constant" / "polyMesh"
    others = {p: value for p, value in properties.items() if p != name}
    for kind in ("", ".gz"):
        if (folder / "sets" / (wanted + kind)).is_file():
            return strategy, {**others, "SetFile": str(folder / "sets" / wanted)}
    known = [p.name.removesuffix(".gz") for p in sorted(folder.glob("sets/*"))]
    for zones in ZONES:
        for path in (folder / zones, folder / f"{zones}.gz"):
            names = _zones(path) if path.is_file() else []
            if wanted in names:
                return strategy, {**others, "SetFile": str(folder / zones), "SetName": wanted}
            known += names
    raise ValueError(
        f"{mesh}: there is no set or zone named {wanted} in {folder}"
        + (f"; there are {', '.join(known)}" if known else "")
    )


def _zones(path: Path) -> list[str]:
    """Names of the zones in a file of OpenFOAM."""
    opened = gzip.open if path.suffix == ".gz" else open
    with opened(path, "rb") as file:
        content = file.read()
    pattern = rb"([^\s(){};]+)\s*\{\s*type\s+(?:cell|face|point)Zone\s*;"
    return [name.decode(errors="replace") for name in re.findall(pattern, content)]


def _criteria(evaluated: Evaluation, steps: Iterable[tuple[str, dict[str, str]]]) -> list[str]:
    """Names of criteria that the steps need and the mesh lacks."""
    known = list(evaluated.quality.GetProperty("Criteria").Available)
    there = set(evaluated.opened.source.CellData.keys())
    wanted = []
    for strategy, properties in steps:
        by_name = {plain(name): value for name, value in properties.items()}
        if "array" in by_name:
            wanted.append(by_name["array"])
        # The step evaluates those of its rules itself; these are columns of the table.
        wanted += re.findall(r"\w+", by_name.get("rules", ""))
        if plain(strategy) == "status":
            wanted.append("CellStatus")
        if plain(strategy) == "failedcriteria":
            presets = tables.known_presets()
            preset = by_name.get("preset", "General")
            wanted += presets[text.lookup(preset, list(presets), "preset")]["rules"]
    return [*dict.fromkeys(name for name in wanted if name in known and name not in there)]


def _lookup(name: str, known: Iterable[str], kind: str) -> str:
    names = {plain(k): k for k in known}
    return names.get(plain(name)) or text.lookup(name, list(names.values()), kind)


def _set(chain: Any, strategy: str, properties: dict[str, str], surfaces: list[Any]) -> None:
    strategies = chain.GetProperty("Strategy").Available
    chain.Strategy = name = _lookup(strategy, strategies, "strategy")
    if name == "Failed criteria" and not any(plain(p) == "preset" for p in properties):
        chain.Preset = "General"
    own = [name for name in chain.ListProperties() if name not in NO_STEP]
    properties = _complete(properties)
    for name, value in sorted(properties.items(), key=lambda item: plain(item[0]) != "shape"):
        of_shape = {plain(p): p for p in chain.Shape.ListProperties()}
        if plain(name) in of_shape and plain(name) not in map(plain, own):
            _set_property(chain.Shape, of_shape[plain(name)], value)
            continue
        name = _lookup(name, own, "property")
        if name == SURFACE:
            surfaces.append(pipeline.open_mesh(value).source)
            chain.Surface = surfaces[-1]
        else:
            _set_property(chain, name, value)


def _complete(properties: dict[str, str]) -> dict[str, str]:
    """Adds properties that follow from others: the range, and the array of points.

    >>> _complete({"Array": "B", "element type": "points", "UpperLimit": "2"})
    {'element type': 'points', 'UpperLimit': '2', 'PointArray': 'B', 'Range': 'Custom'}
    """
    names = {plain(name): name for name in properties}
    complete = dict(properties)
    if "array" in names and plain(properties.get(names.get("elementtype", ""), "")) == "points":
        complete["PointArray"] = complete.pop(names["array"])
    if "range" not in names and {"lowerlimit", "upperlimit"} & set(names):
        complete["Range"] = "Custom"
    return complete


def _set_property(proxy: Any, name: str, value: str) -> None:
    """Sets a property from a text: a word, a number, yes or no, or a list of numbers."""
    prop = proxy.GetProperty(name)
    kind = type(prop.SMProperty).__name__
    if "Proxy" in kind:
        setattr(proxy, name, _lookup(value, prop.Available, name))
        return
    if "String" in kind:
        available = getattr(prop, "Available", None)
        setattr(
            proxy, name, _lookup(value, available, name) if available and name != "Array" else value
        )
        return
    whole = "Double" not in kind
    numbers = []
    for word in re.split(r"[,\s]+", value):
        word = "1" if word.lower() in YES else "0" if word.lower() in NO else word
        try:
            numbers.append(int(word) if whole else float(word))
        except ValueError:
            raise ValueError(f"{name}: expected a number, found '{word}'") from None
    per_group = (
        prop.SMProperty.GetNumberOfElementsPerCommand() if prop.SMProperty.GetRepeatable() else 1
    )
    if len(numbers) % per_group:
        raise ValueError(
            f"{name}: expected a multiple of {per_group} numbers, found {len(numbers)}"
        )
    try:
        setattr(proxy, name, numbers if len(numbers) > 1 else numbers[0])
    except OverflowError:
        raise ValueError(f"{name}: expected a smaller number, found '{value}'") from None
    except RuntimeError as error:  # such as two numbers for a point
        raise ValueError(f"{name}: {error}") from None


def _run(evaluated: Evaluation, chain: Any, notes: list[str]) -> dict[str, Any]:
    with pipeline.Messages() as messages:
        chain.UpdatePipeline(evaluated.opened.time["value"] if evaluated.opened.time else 0.0)
    messages.refuse(evaluated.mesh)
    pipeline.update_information(chain)
    notes += [note for note in messages.warnings if note not in notes]
    return {
        "strategy": chain.GetProperty("Strategy").GetData(),
        "selected": int(chain.GetPropertyValue("NumberOfSelectedElements")),
    }


def _check_meshes(chain: Any, selected: int, targets: Iterable[Path]) -> None:
    """Raises an error if a selection cannot be written as a mesh, where that is wanted."""
    for target in targets:
        if export.is_list(target):
            continue
        if chain.GetProperty("ElementType").GetData() != "Cells":
            raise ValueError(
                f"{target}: points cannot be written as a mesh; write .csv or .txt, or convert the selection to cells"
            )
        if selected == 0:
            raise RuntimeError(f"{target}: no cell is selected, so there is nothing to write")


def _write(evaluated: Evaluation, chain: Any, target: Path, notes: list[str]) -> None:
    if export.is_list(target):
        export.write_list(chain, target)
        return
    cells = evaluated.make_of(
        chain,
        simple.Threshold,
        Scalars=["CELLS", "Selected"],
        LowerThreshold=1,
        UpperThreshold=1,
    )
    cells.UpdatePipeline()
    conversion.write_source(cells, target, notes)
