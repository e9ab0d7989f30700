// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TextFit.h
 * @brief Finds texts of widgets that are cut off.
 */
#ifndef camaron_TextFit_h
#define camaron_TextFit_h

#include <QStringList>

class QWidget;

namespace camaron
{
/// One line for each visible descendant of a widget whose text does not fit into it, or that the
/// right edge of the widget cuts off.
QStringList FindCutTexts(const QWidget* widget);
}

#endif
