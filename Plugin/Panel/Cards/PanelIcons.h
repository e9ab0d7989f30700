// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PanelIcons.h
 * @brief Icons of the Mesh Inspector, Icons/NAME.svg.
 */
#ifndef camaron_PanelIcons_h
#define camaron_PanelIcons_h

#include <QIcon>
#include <QString>

namespace camaron
{
/// The icon of a name, always in the color of texts, so that it is visible on light and dark
/// backgrounds.
QIcon PanelIcon(const QString& name);
}

#endif
