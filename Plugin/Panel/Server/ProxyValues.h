// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ProxyValues.h
 * @brief Properties of proxies from and to Qt's variants.
 */
#ifndef camaron_ProxyValues_h
#define camaron_ProxyValues_h

#include "InspectedMeshTypes.h"

#include <QMap>
#include <QString>
#include <QVariant>

#include <functional> // for changes of no property

class vtkSMProperty;
class vtkSMProxy;
class vtkSMSession;

namespace camaron
{
/// Sets a property to a number, a text, or a list of either, without UpdateVTKObjects().
void SetProperty(vtkSMProxy* proxy, const QString& name, const QVariant& value);

/// A number, a text, or a list of them; invalid if there is no such property.
QVariant GetProperty(vtkSMProxy* proxy, const QString& name);

/// All numbers and texts that a user can set.
QMap<QString, QVariant> GetProperties(vtkSMProxy* proxy);

/// Sets properties and updates the proxy.
void SetProperties(vtkSMProxy* proxy, const QMap<QString, QVariant>& properties);

/// The same, and records the change in a trace.
void SetTracedProperties(vtkSMProxy* proxy, const QMap<QString, QVariant>& properties);

/// Adds the properties Range, LowerLimit and UpperLimit of Select Elements and Quality Regions.
void AddLimits(QMap<QString, QVariant>& properties, const Limits& limits);

/// Properties of Select Elements with the strategy Connected to ids that grow an element to its bad
/// place, as Quality Regions finds it.
QMap<QString, QVariant> GrowToPlace(const QString& array, const Limits& limits);

/// Sets properties that the user has not changed: all of them or, if one was changed, none;
/// recorded in a trace.
void SetUnchangedProperties(vtkSMProxy* proxy, const QMap<QString, QVariant>& properties);

/// A property of the look that the window shares with reports, see QualityColors.xml; the proxy is
/// any of the server.
QVariant GetLook(vtkSMProxy* proxy, const char* name);

/// Gives edges the color and opacity that they have in reports, unless the user has chosen one:
/// ParaView's blue would be taken for a color of the map.
void SetLookOfEdges(vtkSMProxy* display);

/// Gives a mesh the edges, light and color that it has in reports, as far as the user has chosen no
/// others.
void SetLookOfInspection(vtkSMProxy* display);

///@{
/// Gives a mesh the light of reports, or takes that away, unless the user has chosen another one.
/// Returns whether it was taken away.
void SetLightOfLegends(vtkSMProxy* display);
bool ResetLightOfLegends(vtkSMProxy* display);
///@}

/// Shows the legend of what colors a representation, at the place of legends that nothing in the
/// view needs.
void ShowLegend(vtkSMProxy* display, vtkSMProxy* view);

/// Makes a representation look like another one; it keeps its colors if the other has a solid
/// color.
void CopyDisplay(vtkSMProxy* from, vtkSMProxy* to);

/// Chooses one of the proxies of a property's list, such as "CuttingSphere" for CutShape, and
/// returns it; nullptr if there is none of that name.
vtkSMProxy* ChooseProxy(vtkSMProxy* proxy, const char* property, const QString& name);

/// Chooses a shape of the cut of a representation, and sets its properties; recorded in a trace.
void SetCut(vtkSMProxy* display, const QString& shape, const QMap<QString, QVariant>& values);

/// Adds a change of no property to the present step of undo. Both functions run later, when all
/// else of the step has been undone or redone.
void AddToUndo(
  vtkSMSession* session, const std::function<void()>& undo, const std::function<void()>& redo);

/// @name Questions to a server that may have ended
/// ParaView notices the end of a server when it next handles events, or waits for an answer. If the
/// answer is an information property, it aborts then.
///@{
/// Whether the server of the session still runs; without a server, or on Windows, always.
bool IsConnected(vtkSMSession* session);

/// Updates an information property, or all of them, if the server still runs; else returns false.
bool UpdateInformation(vtkSMProxy* proxy, vtkSMProperty* property = nullptr);
///@}
}

#endif
