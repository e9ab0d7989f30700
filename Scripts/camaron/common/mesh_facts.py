# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Facts about a mesh other than its quality."""

from __future__ import annotations

import math
import re
import sys
from pathlib import Path
from typing import Any, Optional, Sequence

from paraview import servermanager, simple

from . import pipeline, tables, text
from .evaluation import CELL_TYPE, WAYS_TO_GROUP, Evaluation, evaluated_criteria
from .files import size

#: Cell types that Mesh Surface does not pass on one by one.
NOT_ONE_POLYGON = ("TriangleStrip", "PolyVertex", "PolyLine")
#: Names of cell types of higher order.
HIGHER_ORDER = re.compile("([Qq]uadratic|Cubic|Lagrange|Bezier)(?!.*(Edge|Line|Curve)$)")
#: Types of which some cells are judged by their vertices by all criteria.
MAYBE_BY_VERTICES = re.compile("Lagrange|Bezier")
#: The reason of such values in masks.
OF_VERTICES = "6"
#: Criteria for the totals of a mesh.
TOTALS = [CELL_TYPE, "Volume", "Area"]


def _is_extent(bounds: Sequence[float]) -> bool:
    """Whether the bounds are finite and valid; VTK's bounds of an empty mesh are reversed."""
    return all(-math.inf < low <= high < math.inf for low, high in zip(bounds[0::2], bounds[1::2]))


def _bounds(source: Any, surface: Any) -> Optional[list[float]]:
    """Bounds of the finite points that cells use; None if there are none."""
    with pipeline.threads_for(pipeline.data_information(source)):
        bounds = list(pipeline.data_information(surface).GetBounds())
    if not _is_extent(bounds):
        sized = simple.ElementQuality(
            Input=source, Criteria=["Diameter"]
        )  # NaN beside infinite points
        finite = simple.Threshold(
            Input=sized,
            Scalars=["CELLS", "Diameter"],
            ThresholdMethod="Between",
            LowerThreshold=0,
            UpperThreshold=sys.float_info.max,
        )
        finite.UpdatePipeline()
        bounds = list(pipeline.data_information(finite).GetBounds())
        simple.Delete(finite)
        simple.Delete(sized)
    return bounds if _is_extent(bounds) else None


def describe(
    path: Path, evaluated: Evaluation, surface: Any, statistics: Any = None
) -> dict[str, Any]:
    """Size, extent and cells of the mesh; `surface` is its Mesh Surface, `statistics` a Quality
    Statistics of all its criteria, which provides the totals if it groups by cell type."""
    opened = evaluated.opened
    information = pipeline.data_information(opened.source)
    points, cells = count_points(opened.source), information.GetNumberOfCells()
    facts = {
        "name": path.name,
        "path": str(path) if opened.is_file else None,
        "file_size": size(path) if opened.is_file else None,
        "time": opened.time,
        "points": points,
        "cells": cells,
        "cell_types": [],
        "higher_order": 0,
        "higher_order_by_vertices": 0,
        "blocks": information.GetNumberOfDataSets() if pipeline.is_composite(opened.source) else 1,
        "bounds": None,
        "memory": information.GetMemorySize() * 1024,
        "boundary_faces": 0,
        "volume": None,
        "area": None,
    }
    if not cells:
        return facts
    quality, made = evaluated.quality, []
    has_totals = set(TOTALS) <= set(evaluated_criteria(quality))
    if not has_totals:
        quality = simple.ElementQuality(Input=opened.source, Criteria=TOTALS)
        made.append(quality)
    if not (has_totals and statistics and statistics.GroupBy == WAYS_TO_GROUP["type"]):
        statistics = simple.QualityStatistics(
            Input=quality,
            Arrays=TOTALS,
            GroupBy=WAYS_TO_GROUP["type"],
            NumberOfWorst=0,
            NumberOfBins=1,
            Quantiles=[100],
        )
        made.append(statistics)
    with pipeline.Messages() as messages:
        rows = tables.fetch(statistics)
    for proxy in reversed(made):
        simple.Delete(proxy)
    messages.refuse(path)
    total = {row["Criterion"]: row for row in rows if row["Group"] == "All"}
    types = {
        row["Group"]: row["Count"]
        for row in rows
        if row["Criterion"] == CELL_TYPE and row["Group"] != "All"
    }
    facts["cells"] = total[CELL_TYPE]["Count"]  # without ghost cells
    if cells > facts["cells"]:
        real = pipeline.without_ghosts(opened.source)
        real.UpdatePipeline()
        facts["memory"] = pipeline.data_information(real).GetMemorySize() * 1024
        if real is not opened.source:
            simple.Delete(real)
    facts["cell_types"] = [
        {"name": text.cell_type(label, count), "count": count}
        for label, count in sorted(types.items(), key=lambda item: -item[1])
    ]
    facts["higher_order"] = sum(
        count for label, count in types.items() if HIGHER_ORDER.search(label)
    )
    if any(MAYBE_BY_VERTICES.search(label) for label in types):
        facts["higher_order_by_vertices"] = _count_by_vertices(opened.source)
    for name in ("Volume", "Area"):
        if total[name]["Count"] > total[name]["UndefinedCount"]:
            facts[name.lower()] = total[name]["Sum"]
    surface.UpdatePipeline()
    facts["bounds"] = _bounds(opened.source, surface)
    solid = total["Volume"]["ApplicableCount"]
    if solid and not any(label in types for label in NOT_ONE_POLYGON):
        polygons = pipeline.data_information(surface).GetNumberOfCells()
        others = facts["cells"] - solid - types.get("EmptyCell", 0)
        facts["boundary_faces"] = polygons - others
    return facts


def _count_by_vertices(source: Any) -> int:
    """Number of higher-order cells that no criterion follows: those without a value of their own
    of one that does."""
    status = "CellStatus"
    quality = simple.ElementQuality(Input=source, Criteria=[status], WriteUndefinedMask=1)
    counts = simple.QualityStatistics(
        Input=quality,
        Arrays=[status],
        GroupBy="Cell array",
        GroupArray=f"{status}_Undefined",
        NumberOfWorst=0,
        NumberOfBins=1,
        Quantiles=[100],
    )
    rows = tables.fetch(counts)
    for proxy in (counts, quality):
        simple.Delete(proxy)
    return sum(row["Count"] for row in rows if row["Group"] == OF_VERTICES)


def count_points(source: Any) -> int:
    """Number of points; points shared by several ranks count once in structured data and if they have global ids."""
    information = pipeline.data_information(source)
    if not pipeline.is_composite(source) and pipeline.is_structured(source):
        extent = information.GetExtent()
        return math.prod(extent[i + 1] - extent[i] + 1 for i in (0, 2, 4))
    counted = information.GetNumberOfPoints()
    ids = source.PointData["GlobalPointIds"]
    if pipeline.rank_count() > 1 and ids:
        low, high = ids.GetRange()
        if low == 0 and high < counted:
            return int(high) + 1
    return counted


def notes(opened: pipeline.Opened) -> list[str]:
    """Notes for the report about the data that was read."""
    if opened.time is None or opened.time["steps"] == 1:
        return []
    return [
        f"Of {opened.time['steps']} time steps, step {opened.time['step']}, counted from 0, was used"
        f" (time {opened.time['value']:g})."
    ]


def program() -> str:
    """Names and versions of the programs that generated a report."""
    manager = servermanager.vtkSMProxyManager.GetProxyManager()
    plugins = manager.GetPluginManager().GetLocalInformation()
    versions = [
        plugins.GetPluginVersion(i)
        for i in range(plugins.GetNumberOfPlugins())
        if plugins.GetPluginName(i) == "Camaron"
    ]
    paraview = simple.GetParaViewSourceVersion().split()[-1]
    return f"Camarón for ParaView {''.join(versions)}, ParaView {paraview}"


def extension(source: Any) -> str:
    """Extension of the XML format for the output of the source; with several ranks, of the parallel
    format."""
    information = pipeline.data_information(source)
    if pipeline.is_composite(source):
        return (
            ".vtpc"
            if information.GetCompositeDataClassName().startswith("vtkPartitioned")
            else ".vtm"
        )
    parallel = "p" if pipeline.rank_count() > 1 else ""
    kinds = {
        "vtkUnstructuredGrid": "vtu",
        "vtkPolyData": "vtp",
        "vtkStructuredGrid": "vts",
        "vtkRectilinearGrid": "vtr",
        "vtkImageData": "vti",
    }
    for name, kind in kinds.items():
        if information.DataSetTypeIsA(name):
            return f".{parallel}{kind}"
    return ".vtk"
