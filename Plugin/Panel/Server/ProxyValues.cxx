// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ProxyValues.h"

#include "NumberText.h"

#include "pqSMAdaptor.h"
#include "pqUndoStack.h"

#include "vtkClientSocket.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMColorMapEditorHelper.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyListDomain.h"
#include "vtkSMProxyProperty.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkSMTrace.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMUndoElement.h"
#include "vtkSMVectorProperty.h"
#include "vtkSmartPointer.h"
#include "vtkSocket.h"
#include "vtkSocketCommunicator.h"

#include <QStringList>
#include <QTimer>

#include <algorithm>
#include <cmath>

#ifndef _WIN32
#include <cerrno>
#include <sys/socket.h>
#endif

namespace
{
//------------------------------------------------------------------------------
QMap<QString, QVariant> GetLightOfLegends(vtkSMProxy* display)
{
  return { { "Ambient", camaron::GetLook(display, "Ambient") },
    { "Diffuse", camaron::GetLook(display, "Diffuse") } };
}

//------------------------------------------------------------------------------
class OtherChange : public vtkSMUndoElement
{
public:
  static OtherChange* New();
  vtkTypeMacro(OtherChange, vtkSMUndoElement);

  std::function<void()> Back, Forth;

  int Undo() override
  {
    QTimer::singleShot(0, this->Back);
    return 1;
  }
  int Redo() override
  {
    QTimer::singleShot(0, this->Forth);
    return 1;
  }
};
vtkStandardNewMacro(OtherChange);
}

namespace camaron
{
//------------------------------------------------------------------------------
void SetProperty(vtkSMProxy* proxy, const QString& name, const QVariant& value)
{
  vtkSMProperty* property = proxy->GetProperty(name.toUtf8().constData());
  if (!property)
  {
    return;
  }
  const QVariantList values =
    value.userType() == QMetaType::QVariantList ? value.toList() : QVariantList{ value };
  vtkSMPropertyHelper helper(property);
  helper.SetNumberOfElements(static_cast<unsigned>(values.size()));
  const bool isText = vtkSMStringVectorProperty::SafeDownCast(property) != nullptr;
  const bool isReal = vtkSMDoubleVectorProperty::SafeDownCast(property) != nullptr;
  for (int i = 0; i < values.size(); ++i)
  {
    const auto place = static_cast<unsigned>(i);
    if (isText || values[i].userType() == QMetaType::QString)
    {
      helper.Set(place, values[i].toString().toUtf8().constData());
    }
    else if (isReal)
    {
      helper.Set(place, values[i].toDouble());
    }
    else
    {
      helper.Set(place, values[i].toInt());
    }
  }
}

//------------------------------------------------------------------------------
QVariant GetProperty(vtkSMProxy* proxy, const QString& name)
{
  auto* property = proxy
    ? vtkSMVectorProperty::SafeDownCast(proxy->GetProperty(name.toUtf8().constData()))
    : nullptr;
  if (!property)
  {
    return QVariant();
  }
  const QVariantList values = pqSMAdaptor::getMultipleElementProperty(property);
  return values.size() == 1 ? values.front() : QVariant(values);
}

//------------------------------------------------------------------------------
QMap<QString, QVariant> GetProperties(vtkSMProxy* proxy)
{
  QMap<QString, QVariant> properties;
  const auto iterator = vtkSmartPointer<vtkSMPropertyIterator>::Take(proxy->NewPropertyIterator());
  for (iterator->Begin(); !iterator->IsAtEnd(); iterator->Next())
  {
    vtkSMProperty* property = iterator->GetProperty();
    const QVariant value = GetProperty(proxy, iterator->GetKey());
    if (value.isValid() && !property->GetInformationOnly() && !property->GetIsInternal())
    {
      properties[iterator->GetKey()] = value;
    }
  }
  return properties;
}

//------------------------------------------------------------------------------
void SetProperties(vtkSMProxy* proxy, const QMap<QString, QVariant>& properties)
{
  for (auto item = properties.cbegin(); item != properties.cend(); ++item)
  {
    SetProperty(proxy, item.key(), item.value());
  }
  proxy->UpdateVTKObjects();
}

//------------------------------------------------------------------------------
void SetTracedProperties(vtkSMProxy* proxy, const QMap<QString, QVariant>& properties)
{
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", proxy);
  SetProperties(proxy, properties);
}

//------------------------------------------------------------------------------
void SetUnchangedProperties(vtkSMProxy* proxy, const QMap<QString, QVariant>& properties)
{
  const QStringList names = properties.keys();
  const bool isFree = std::all_of(names.begin(), names.end(),
    [&](const QString& name)
    {
      vtkSMProperty* property = proxy->GetProperty(name.toUtf8().constData());
      return properties[name].isValid() && property && property->IsValueDefault();
    });
  if (isFree)
  {
    SetTracedProperties(proxy, properties);
  }
}

//------------------------------------------------------------------------------
QVariant GetLook(vtkSMProxy* proxy, const char* name)
{
  return GetProperty(
    proxy->GetSessionProxyManager()->GetPrototypeProxy("misc", "QualityColors"), name);
}

//------------------------------------------------------------------------------
void SetLookOfEdges(vtkSMProxy* display)
{
  SetUnchangedProperties(display,
    { { "EdgeColor", GetLook(display, "EdgeColor") },
      { "EdgeOpacity", GetLook(display, "EdgeOpacity") } });
}

//------------------------------------------------------------------------------
void SetLightOfLegends(vtkSMProxy* display)
{
  SetUnchangedProperties(display, GetLightOfLegends(display));
}

//------------------------------------------------------------------------------
// Meshes have the color of ParaView's palette unless somebody chooses another one.
void SetLookOfInspection(vtkSMProxy* display)
{
  SetLookOfEdges(display);
  SetLightOfLegends(display);
  vtkSMProxy* palette = display->GetSessionProxyManager()->GetProxy("settings", "ColorPalette");
  const QVariant usual = GetProperty(palette, "SurfaceColor");
  const QVariant color = GetLook(display, "MeshColor");
  const auto isUsual = [&](const char* name)
  { return display->GetProperty(name)->IsValueDefault() || GetProperty(display, name) == usual; };
  if (isUsual("AmbientColor") && isUsual("DiffuseColor"))
  {
    SetTracedProperties(display, { { "AmbientColor", color }, { "DiffuseColor", color } });
  }
}

//------------------------------------------------------------------------------
bool ResetLightOfLegends(vtkSMProxy* display)
{
  const QMap<QString, QVariant> light = GetLightOfLegends(display);
  for (auto item = light.cbegin(); item != light.cend(); ++item)
  {
    if (GetProperty(display, item.key()) != item.value())
    {
      return false;
    }
  }
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", display);
  for (const QString& name : light.keys())
  {
    display->GetProperty(name.toUtf8().constData())->ResetToXMLDefaults();
  }
  display->UpdateVTKObjects();
  return true;
}

//------------------------------------------------------------------------------
void ShowLegend(vtkSMProxy* display, vtkSMProxy* view)
{
  vtkNew<vtkSMTransferFunctionManager> legends;
  legends->UpdateScalarBars(view, vtkSMTransferFunctionManager::HIDE_UNUSED_SCALAR_BARS);
  vtkSMColorMapEditorHelper::SetScalarBarVisibility(display, view, true);
}

//------------------------------------------------------------------------------
void AddLimits(QMap<QString, QVariant>& properties, const Limits& limits)
{
  properties["Range"] = QString(limits ? "Custom" : "Acceptable");
  if (limits)
  {
    properties["LowerLimit"] = ExactLimit(limits->first);
    properties["UpperLimit"] = ExactLimit(limits->second);
  }
}

//------------------------------------------------------------------------------
QMap<QString, QVariant> GrowToPlace(const QString& array, const Limits& limits)
{
  QMap<QString, QVariant> properties = { { "Adjacency", "Vertex" }, { "OnlyInRange", 1 },
    { "Array", array }, { "Side", "Outside" } };
  AddLimits(properties, limits);
  return properties;
}

//------------------------------------------------------------------------------
void CopyDisplay(vtkSMProxy* from, vtkSMProxy* to)
{
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", to);
  const bool copiesColors = vtkSMColorMapEditorHelper::GetUsingScalarColoring(from);
  const QStringList colors = { "ColorArrayName", "LookupTable", "ScalarOpacityFunction" };
  const auto properties = vtkSmartPointer<vtkSMPropertyIterator>::Take(from->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    vtkSMProperty* target = to->GetProperty(properties->GetKey());
    const bool isOfColors = colors.contains(properties->GetKey());
    // Proxies such as the shape of the cut belong to one representation, color maps to all.
    if (target && !target->GetInformationOnly() &&
      (isOfColors ? copiesColors : !vtkSMProxyProperty::SafeDownCast(target)))
    {
      target->Copy(properties->GetProperty());
    }
  }
  if (vtkSMProperty* shape = from->GetProperty("CutShape"))
  {
    vtkSMProxy* source = vtkSMPropertyHelper(shape).GetAsProxy();
    vtkSMProxy* target = source ? ChooseProxy(to, "CutShape", source->GetXMLName()) : nullptr;
    if (target)
    {
      target->Copy(source, "vtkSMProxyProperty"); // all but its input
      target->UpdateVTKObjects();
    }
  }
  to->UpdateVTKObjects();
}

//------------------------------------------------------------------------------
vtkSMProxy* ChooseProxy(vtkSMProxy* proxy, const char* property, const QString& name)
{
  vtkSMProperty* list = proxy->GetProperty(property);
  auto* domain = list ? list->FindDomain<vtkSMProxyListDomain>() : nullptr;
  for (unsigned i = 0; domain && i < domain->GetNumberOfProxies(); ++i)
  {
    vtkSMProxy* candidate = domain->GetProxy(i);
    if (name == candidate->GetXMLName())
    {
      vtkSMPropertyHelper(list).Set(candidate);
      return candidate;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
void SetCut(vtkSMProxy* display, const QString& shape, const QMap<QString, QVariant>& values)
{
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", display);
  if (vtkSMProxy* cut = ChooseProxy(display, "CutShape", shape))
  {
    display->UpdateVTKObjects();
    SetTracedProperties(cut, values);
  }
}

//------------------------------------------------------------------------------
void AddToUndo(
  vtkSMSession* session, const std::function<void()>& undo, const std::function<void()>& redo)
{
  vtkNew<OtherChange> change;
  change->SetSession(session);
  change->Back = undo;
  change->Forth = redo;
  ADD_UNDO_ELEM(change);
}

//------------------------------------------------------------------------------
bool IsConnected(vtkSMSession* session)
{
  vtkMultiProcessController* controller =
    session ? session->GetController(vtkPVSession::DATA_SERVER_ROOT) : nullptr;
  auto* communicator =
    controller ? vtkSocketCommunicator::SafeDownCast(controller->GetCommunicator()) : nullptr;
  if (!communicator)
  {
    return true;
  }
  vtkSocket* server = communicator->GetSocket();
  if (!server || !server->GetConnected())
  {
    return false;
  }
#ifndef _WIN32
  char byte = 0;
  const auto read =
    recv(server->GetSocketDescriptor(), &byte, sizeof(byte), MSG_PEEK | MSG_DONTWAIT);
  return read > 0 || (read < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR));
#else
  return true;
#endif
}

//------------------------------------------------------------------------------
bool UpdateInformation(vtkSMProxy* proxy, vtkSMProperty* property)
{
  if (!IsConnected(proxy->GetSession()))
  {
    return false;
  }
  if (property)
  {
    proxy->UpdatePropertyInformation(property);
  }
  else
  {
    proxy->UpdatePropertyInformation();
  }
  return true;
}
}
