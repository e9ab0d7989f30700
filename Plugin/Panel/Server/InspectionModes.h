// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InspectionModes.h
 * @brief The switches of Mesh Inspection, as its definition on the server declares them.
 *
 * A property of MeshInspectionRepresentation is a switch by a hint:
 *
 *     <Switch name="Interior" text="Interior faces only" value="1" plain="0"/>
 *
 * `name` is that of the icon, `value` that of the property if the switch is on (else 0), `plain`
 * its value in a plain picture; with `needs="point array"` it is of use only with a point array.
 */
#ifndef camaron_InspectionModes_h
#define camaron_InspectionModes_h

#include <QList>
#include <QString>
#include <QStringList>

namespace camaron
{
struct InspectionMode
{
  QString Name;
  QString Property;
  QString Text;
  int On = 1;
  int Plain = 0;
  bool NeedsPoints = false; ///< an array of them
};

/// All switches, in the order of the definition; none if the active server has no definition.
QList<InspectionMode> FindInspectionModes();

/// The texts of the values 0, 1, ... of a property of Mesh Inspection.
QStringList FindInspectionChoices(const char* property);
}

#endif
