# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads and evaluates a mesh: the first step of all commands that evaluate quality."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Callable, Iterable, Mapping, Optional

from paraview import servermanager, simple

from . import pipeline, tables, text
from .formats import UnknownOption
from .inputs import Inputs

#: Criteria that are evaluated for groups and facts about the mesh, but do not measure quality.
CELL_TYPE, CELL_FAMILY = NOT_REPORTED = ("CellTypeId", "CellFamilyId")
#: Preset whose criteria are evaluated by default, and the word for all criteria.
GENERAL, ALL = "General", "all"
#: Choices of `group_by` besides cell arrays.
WAYS_TO_GROUP = {"type": "Cell type", "block": "Block", "none": "None"}
#: Minimum seconds of evaluations whose time is announced.
LONG = 10.0


class Evaluation:
    """A mesh, its Element Quality, and further filters; all are deleted at the end.

    >>> with Evaluation("part.visf") as evaluated:
    ...     evaluated.quality.Criteria = ["Volume"]
    ...     statistics = evaluated.make(simple.QualityStatistics, NumberOfWorst=0)
    """

    def __init__(
        self,
        mesh: os.PathLike | str | servermanager.Proxy,
        time: str = "last",
        keeps_criteria: bool = False,
        inputs: Optional[Inputs] = None,
        reader: Optional[Mapping[str, Any]] = None,
        strict: bool = False,
        unknown: Optional[dict[str, UnknownOption]] = None,
    ):
        """Reads the mesh and adds its files to `inputs`; raises what `pipeline.open_mesh` does.

        A source of the pipeline is used as it is, at its current time. With `keeps_criteria`, an
        Element Quality evaluates its own criteria; otherwise only its input is used.
        """
        pipeline.load_plugin()
        request_ghosts(0)  # until the end; no filter here needs ghost cells
        self._made = []
        #: Whether the criteria are those of an Element Quality of the pipeline.
        self.has_own_criteria = False
        try:
            if isinstance(mesh, servermanager.Proxy):
                if reader:
                    raise ValueError("options of the reader need the name of a file")
                is_evaluation = mesh.GetXMLName() == "ElementQuality"
                self.has_own_criteria = is_evaluation and keeps_criteria
                self.opened = pipeline.adopt(mesh.Input if is_evaluation else mesh)
                if inputs is not None:
                    inputs.add(self.opened.source)
            else:
                self.opened = pipeline.open_mesh(mesh, time, inputs, reader, strict, unknown)
                self._made.append(self.opened.source)
        except BaseException:
            request_ghosts(1)
            raise
        self.mesh = self.opened.path
        if self.has_own_criteria:
            self.quality = mesh
        else:
            self.quality = simple.ElementQuality(Input=self.opened.source)
            self._made.append(self.quality)

    def make(self, create: Callable[..., Any], **properties: Any) -> Any:
        """Creates a filter of the Element Quality that exists as long as this object."""
        return self.make_of(self.quality, create, **properties)

    def make_of(self, source: Any, create: Callable[..., Any], **properties: Any) -> Any:
        """Creates a filter of another filter created here."""
        self._made.append(create(Input=source, **properties))
        return self._made[-1]

    def __enter__(self) -> "Evaluation":
        return self

    def __exit__(self, kind, error, trace) -> None:
        for proxy in reversed(self._made):
            simple.Delete(proxy)
        request_ghosts(1)

    def evaluate(self) -> None:
        """Evaluates the criteria and adds to the warnings about the mesh; raises RuntimeError after
        an error."""
        with pipeline.Messages() as messages:
            self.quality.UpdatePipeline()
        messages.refuse(self.mesh)
        self.opened.warnings += messages.warnings

    def estimated_seconds(self, evaluator: Any = None) -> float:
        """Estimated time of the evaluation by the Element Quality or another filter."""
        evaluator = evaluator or self.quality
        pipeline.update_information(evaluator)
        return evaluator.SMProxy.GetProperty("EstimatedSeconds").GetElement(0)

    def announce(self, say: Callable[[str], None], evaluator: Any = None) -> None:
        """Announces the estimated time if the evaluation takes long."""
        seconds = self.estimated_seconds(evaluator)
        if seconds >= LONG:
            cells = pipeline.data_information(self.opened.source).GetNumberOfCells()
            say(
                f"the criteria take about {text.duration(seconds)}"
                f" for {text.plural(cells, 'cell', ',')}"
            )


def request_ghosts(layers: int) -> None:
    """Sets the number of layers of ghost cells that ParaView requests on all ranks; its default is
    1."""
    if pipeline.rank_count() > 1:
        requests = servermanager.ProxyManager().NewProxy("misc", "GhostRequests")
        requests.GetProperty("Layers").SetElement(0, layers)
        requests.UpdateVTKObjects()


def list_names(criteria: Iterable[str] | str | None) -> Optional[list[str]]:
    """Names from a list or from a text such as "Volume,Diameter"; None stays None.

    >>> list_names("all")
    ['all']
    """
    if criteria is None:
        return None
    return criteria.split(",") if isinstance(criteria, str) else list(criteria)


def choose_criteria(
    quality: Any,
    preset: Optional[str],
    criteria: Optional[Iterable[str]],
    more: Iterable[str] = (),
) -> Optional[str]:
    """Sets the criteria to evaluate, and returns the name of the preset in its usual spelling.

    `more` criteria are evaluated in addition to those of a preset, but not to explicit `criteria`.
    For an unknown name, ValueError suggests the closest one.
    """
    known = list(quality.GetProperty("Criteria").Available)
    if preset is not None:
        presets = list(quality.GetProperty("Preset").Available)[1:]
        quality.Preset = preset = text.lookup(preset, presets, "preset")
        if more:  # a preset evaluates its own criteria only
            quality.Preset = quality.GetProperty("Preset").Available[0]
            quality.Criteria = [*dict.fromkeys([*tables.known_presets()[preset]["rules"], *more])]
    elif criteria == [ALL]:
        quality.Criteria = known
    elif criteria is not None:
        quality.Criteria = [text.lookup(name.strip(), known, "criterion") for name in criteria]
    else:
        general = tables.known_presets()[GENERAL]["rules"]
        quality.Criteria = [*dict.fromkeys([*general, *more, CELL_TYPE])]
    return preset


def chosen_preset(quality: Any) -> Optional[str]:
    """Name of the preset that an Element Quality evaluates, if it evaluates one."""
    preset = quality.GetProperty("Preset").GetData()
    return preset if preset in tables.known_presets() else None


def evaluated_criteria(quality: Any) -> Iterable[str]:
    """Names of the criteria that an Element Quality evaluates."""
    preset = chosen_preset(quality)
    return tables.known_presets()[preset]["rules"] if preset else quality.Criteria


def set_groups(tables_of: Any, group_by: str, *meshes: pipeline.Opened) -> None:
    """Sets the groups of cells: one of WAYS_TO_GROUP, or a cell array that one of the meshes
    has."""
    arrays = [
        array.Name
        for mesh in meshes
        for array in mesh.source.CellData
        if array.GetNumberOfComponents() == 1
    ]
    if group_by not in arrays:
        known = [*WAYS_TO_GROUP, *dict.fromkeys(arrays)]
        group_by = text.lookup(group_by, known, "group or cell array", lists_all=True)
    if group_by in WAYS_TO_GROUP:
        tables_of.GroupBy = WAYS_TO_GROUP[group_by]
        return
    tables_of.GroupBy = "Cell array"
    tables_of.GroupArray = group_by
