// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqSelectElementsBehavior.h"

#include "InspectedMeshTypes.h"
#include "ThresholdSelection.h"

#include "pqApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"

#include "vtkCommand.h"
#include "vtkSMProperty.h"
#include "vtkSMSourceProxy.h"
#include "vtkSmartPointer.h"

#include <QPointer>
#include <QTimer>

#include <algorithm>

//------------------------------------------------------------------------------
void pqSelectElementsBehavior::startup()
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(
    model, &pqServerManagerModel::sourceAdded, this, &pqSelectElementsBehavior::onSourceAdded);
  QObject::connect(
    model, &pqServerManagerModel::sourceRemoved, this, &pqSelectElementsBehavior::onSourceRemoved);
}

//------------------------------------------------------------------------------
void pqSelectElementsBehavior::shutdown()
{
  this->Connector->Disconnect();
  this->ChangedProxies.clear();
  this->Updated.clear();
}

//------------------------------------------------------------------------------
void pqSelectElementsBehavior::onSourceAdded(pqPipelineSource* source)
{
  vtkSMProxy* proxy = source->getProxy();
  if (camaron::IsFilter(source, camaron::SelectName))
  {
    this->ChangedProxies.insert(proxy);
    this->Connector->Connect(
      proxy, vtkCommand::UpdatePropertyEvent, this, SLOT(onPropertyUpdated(vtkObject*)));
    QObject::connect(source, QOverload<pqPipelineSource*>::of(&pqPipelineSource::dataUpdated), this,
      &pqSelectElementsBehavior::onDataUpdated);
    // See vtkSMSelectElementsInitializationHelper: hidden only while the creation is traced.
    QTimer::singleShot(
      0, source, [proxy] { proxy->GetProperty("Selection")->SetPanelVisibility("default"); });
  }
}

//------------------------------------------------------------------------------
void pqSelectElementsBehavior::onSourceRemoved(pqPipelineSource* source)
{
  this->Connector->Disconnect(source->getProxy());
  this->ChangedProxies.remove(source->getProxy());
}

//------------------------------------------------------------------------------
void pqSelectElementsBehavior::onPropertyUpdated(vtkObject* proxy)
{
  this->ChangedProxies.insert(proxy);
}

//------------------------------------------------------------------------------
void pqSelectElementsBehavior::onDataUpdated(pqPipelineSource* source)
{
  if (!this->ChangedProxies.remove(source->getProxy()))
  {
    return;
  }
  // Delayed, because the pipeline is in the middle of an update.
  this->Updated << source;
  QTimer::singleShot(0, this,
    [this, pointer = QPointer<pqPipelineSource>(source)]
    {
      // Of steps that were made together, the last one selects.
      const auto next = pointer ? pointer->getAllConsumers() : QList<pqPipelineSource*>();
      this->Updated.removeAll(pointer);
      const bool isLast = std::none_of(next.begin(), next.end(),
        [this](pqPipelineSource* consumer) { return this->Updated.contains(consumer); });
      if (pointer && isLast)
      {
        camaron::ActivateResult(pointer);
      }
    });
}
