// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DisplayState.h
 * @brief The state that a flight to an element changes, to restore it.
 */
#ifndef camaron_DisplayState_h
#define camaron_DisplayState_h

#include "pqDataRepresentation.h" // for pointers to it
#include "pqOutputPort.h"         // for pointers to it
#include "pqRenderView.h"         // for pointers to it

#include <QMap>
#include <QPointer>
#include <QString>
#include <QVariant>
#include <QVector>

namespace camaron
{
struct DisplayState
{
  QPointer<pqRenderView> View;
  QVector<double> Camera; ///< position, focal point, view up, parallel scale
  QPointer<pqOutputPort> Cells;
  QPointer<pqDataRepresentation> Drawn; ///< whose display was changed
  QMap<QString, QVariant> Properties;   ///< of it; empty if it was not changed
  QString CutShape;
};
}

#endif
