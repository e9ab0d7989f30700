// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HelperFilters.h"

#include "ProxyValues.h"

#include "pqActiveObjects.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServer.h"
#include "pqTimeKeeper.h"

#include "vtkPVDataMover.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkTable.h"

namespace camaron
{
//------------------------------------------------------------------------------
Helper HelperFilters::get(const char* group, const char* name, const char* key)
{
  const pqScopedUndoExclude pause;
  pqServer* server = pqActiveObjects::instance().activeServer();
  if (!server || !IsConnected(server->session()))
  {
    return nullptr;
  }
  auto& found = this->Known[QString(name) + key];
  if (!found && server->proxyManager()->HasDefinition(group, name)) // it may lack the plugin
  {
    found.TakeReference(
      vtkSMSourceProxy::SafeDownCast(server->proxyManager()->NewProxy(group, name)));
  }
  return found.Get();
}

//------------------------------------------------------------------------------
Helper HelperFilters::filter(
  const char* name, pqOutputPort* input, const char* key, const Properties& properties)
{
  return input
    ? this->filter(name, input->getSourceProxy(), key, properties, input->getPortNumber())
    : nullptr;
}

//------------------------------------------------------------------------------
Helper HelperFilters::filter(const char* name, vtkSMSourceProxy* input, const char* key,
  const Properties& properties, int port)
{
  const Helper filter = input ? this->get("filters", name, key) : nullptr;
  if (filter)
  {
    vtkSMPropertyHelper(filter, "Input").Set(input, port);
    SetProperties(filter, properties);
  }
  return filter;
}

//------------------------------------------------------------------------------
void HelperFilters::clear()
{
  this->Known.clear();
  this->DataMover = nullptr;
}

//------------------------------------------------------------------------------
void HelperFilters::forget(pqPipelineSource* removed, pqPipelineSource* other)
{
  for (auto helper = this->Known.begin(); helper != this->Known.end();)
  {
    vtkSMProperty* input = helper.value() ? helper.value()->GetProperty("Input") : nullptr;
    const bool isOfOther = other && other != removed && input &&
      vtkSMPropertyHelper(input).GetAsProxy() == other->getProxy();
    helper = isOfOther ? std::next(helper) : this->Known.erase(helper);
  }
}

//------------------------------------------------------------------------------
double HelperFilters::time()
{
  return pqActiveObjects::instance().activeServer()->getTimeKeeper()->getTime();
}

//------------------------------------------------------------------------------
bool HelperFilters::update(vtkSMSourceProxy* source)
{
  if (!source)
  {
    return false;
  }
  if (this->isBusy())
  {
    this->Refused();
    return false;
  }
  const Question question = this->ask();
  source->UpdateVTKObjects();
  source->UpdatePipeline(HelperFilters::time());
  return IsConnected(source->GetSession());
}

//------------------------------------------------------------------------------
PanelTable HelperFilters::fetch(vtkSMSourceProxy* source, int port, bool isDistributed)
{
  if (!this->update(source))
  {
    return {};
  }
  const Question question = this->ask();
  auto& mover = this->DataMover;
  if (!mover)
  {
    mover.TakeReference(source->GetSessionProxyManager()->NewProxy("misc", "DataMover"));
  }
  vtkSMPropertyHelper(mover, "Producer").Set(source);
  vtkSMPropertyHelper(mover, "PortNumber").Set(port);
  vtkSMPropertyHelper ranks(mover, "SourceRanks");
  ranks.SetNumberOfElements(0);
  if (!isDistributed)
  {
    ranks.Set(0u, 0); // complete on process 0
  }
  vtkSMPropertyHelper(mover, "SkipEmptyDataSets").Set(isDistributed ? 1 : 0);
  mover->UpdateVTKObjects();
  mover->InvokeCommand("Execute");
  auto* moved = vtkPVDataMover::SafeDownCast(mover->GetClientSideObject());
  PanelTable table;
  for (unsigned i = 0; moved && i < moved->GetNumberOfDataSets(); ++i)
  {
    table.append(ToPanelTable(vtkTable::SafeDownCast(moved->GetDataSetAtIndex(i))));
  }
  return table;
}
}
