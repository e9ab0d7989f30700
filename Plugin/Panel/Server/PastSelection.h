// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PastSelection.h
 * @brief An entry of the history of selections.
 */
#ifndef camaron_PastSelection_h
#define camaron_PastSelection_h

#include "ThresholdSelection.h" // for brushes
#include "pqOutputPort.h"       // for pointers to it
#include "pqPipelineSource.h"   // for pointers to it

#include "vtkSMSourceProxy.h" // for selections
#include "vtkSmartPointer.h"  // for selections

#include <QMap>
#include <QPointer>
#include <QString>
#include <QVariant>
#include <QVector>

namespace camaron
{
/// A filter of a chain of Select Elements, and its former properties.
struct SelectionStep
{
  QPointer<pqPipelineSource> Filter;
  QMap<QString, QVariant> Properties;

  bool operator==(const SelectionStep& other) const
  {
    return this->Filter == other.Filter && this->Properties == other.Properties;
  }
};

struct PastSelection
{
  QString Text;
  QPointer<pqOutputPort> Port; ///< whose elements were selected
  vtkSmartPointer<vtkSMSourceProxy> Selection;
  QVector<SelectionStep> Steps;   ///< that end at the port
  QVector<BrushedValues> Brushes; ///< that made it one after another; none otherwise
};
}

#endif
