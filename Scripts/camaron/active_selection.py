# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's active selection from Python."""

from __future__ import annotations

from typing import Any

from paraview import selection as paraview_selection
from paraview import simple
from paraview.modules.vtkRemotingViews import vtkSMSelectionHelper


def set_active_selection(source: Any, port: int = 0) -> None:
    """Makes the cells or points that a SelectElements filter selects ParaView's active selection.

    The selection is defined by "Selected is 1 on this output", so it follows updates of the filter.
    Find Data, Extract Selection and the views use it as the selection of the source; in the window,
    Select Elements does the same when it is applied. ParaView before 6 does not save active
    selections in states: call this again after loading a state.

    >>> worst = simple.SelectElements(Input=quality, Strategy="Worst N", Array="EdgeLengthRatio")
    >>> worst.UpdatePipeline()
    >>> set_active_selection(worst)
    >>> cells = simple.ExtractSelection(Input=worst)
    """
    information = source.GetDataInformation(port)
    element_type = source.GetProperty("ElementType")
    is_of_points = bool(element_type) and element_type.GetData() == "Points"
    arrays = (
        information.GetPointDataInformation()
        if is_of_points
        else information.GetCellDataInformation()
    )
    if arrays.GetArrayInformation("Selected") is None:
        raise ValueError(
            'the output has no array "Selected": expected an updated SelectElements filter'
        )
    selected = paraview_selection._createSelection(
        "ThresholdSelectionSource",
        Thresholds=[1, 1],
        ArrayName="Selected",
        FieldType="POINT" if is_of_points else "CELL",
    )
    selected.UpdateVTKObjects()
    append = vtkSMSelectionHelper.NewAppendSelectionsFromSelectionSource(selected.SMProxy)
    source.SMProxy.SetSelectionInput(port, append, 0)
    append.UnRegister(None)
    simple.SetActiveSource(source)
