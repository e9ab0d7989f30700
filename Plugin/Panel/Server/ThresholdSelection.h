// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ThresholdSelection.h
 * @brief ParaView's selections by values of an array, and the steps of Select Elements that make
 * them.
 */
#ifndef camaron_ThresholdSelection_h
#define camaron_ThresholdSelection_h

#include "HistogramBrush.h" // for combinations

#include "vtkSmartPointer.h" // for selections

#include <QString>

#include <vector> // for thresholds

class pqOutputPort;
class pqPipelineSource;
class pqSelectionManager;
class vtkSMSourceProxy;

namespace camaron
{
/// A brush over closed ranges of the values of an array: pairs of lower and upper limits.
struct BrushedValues
{
  QString Array;
  std::vector<double> Thresholds;
  Combination How = Combination::Replace; ///< Intersect cannot be expressed
};

/// ParaView's selection manager.
pqSelectionManager* GetSelectionManager();

/// Returns whether a source has this XML name, such as "SelectElements".
bool IsFilter(pqPipelineSource* source, const QString& name);

/// The first connection of the input property; nullptr if there is none.
pqOutputPort* GetInput(pqPipelineSource* source);

/**
 * A selection of the elements whose value is in one of the closed ranges, as ParaView's
 * SelectThresholds creates it.
 */
vtkSmartPointer<vtkSMSourceProxy> MakeThresholdSelection(pqPipelineSource* source,
  const QString& array, const std::vector<double>& thresholds, bool isOfPoints);

/// Records a selection of MakeThresholdSelection in a trace.
void TraceThresholds(
  pqOutputPort* port, const BrushedValues& brush, bool isOfPoints, const char* comment);

/// Makes the result of a Select Elements filter the active selection, and records it in a trace.
void ActivateResult(pqPipelineSource* selectElements);

/// The values of what a Select Elements filter selects.
BrushedValues GetResultValues();

/// Whether a selection is one of ActivateResult.
bool IsResult(vtkSMSourceProxy* selection);

/// Whether a selection is one of points; of nothing or cells otherwise.
bool IsOfPoints(vtkSMSourceProxy* selection);
}

#endif
