// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqSelectElementsBehavior.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqSelectionManager.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"

#include "vtkCommand.h"
#include "vtkEventQtSlotConnect.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSelectionHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSelectionNode.h"
#include "vtkSmartPointer.h"

#include <QPointer>
#include <QTimer>

#include <string>
#include <vector>

//------------------------------------------------------------------------------
pqSelectElementsBehavior::pqSelectElementsBehavior(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
pqSelectElementsBehavior::~pqSelectElementsBehavior() = default;

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
}

//------------------------------------------------------------------------------
void pqSelectElementsBehavior::onSourceAdded(pqPipelineSource* source)
{
  vtkSMProxy* proxy = source->getProxy();
  if (qstrcmp(proxy->GetXMLName(), "SelectElements") == 0)
  {
    this->ChangedProxies.insert(proxy);
    this->Connector->Connect(
      proxy, vtkCommand::UpdatePropertyEvent, this, SLOT(onPropertyUpdated(vtkObject*)));
    QObject::connect(source, QOverload<pqPipelineSource*>::of(&pqPipelineSource::dataUpdated), this,
      &pqSelectElementsBehavior::onDataUpdated);
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
  if (this->ChangedProxies.remove(source->getProxy()))
  {
    // Delayed, because the pipeline is in the middle of an update.
    QTimer::singleShot(0, this,
      [this, pointer = QPointer<pqPipelineSource>(source)]
      {
        if (pointer)
        {
          this->select(pointer);
        }
      });
  }
}

//------------------------------------------------------------------------------
void pqSelectElementsBehavior::select(pqPipelineSource* source)
{
  auto* manager =
    qobject_cast<pqSelectionManager*>(pqApplicationCore::instance()->manager("SelectionManager"));
  const auto description = vtkSmartPointer<vtkSMSourceProxy>::Take(vtkSMSourceProxy::SafeDownCast(
    source->proxyManager()->NewProxy("sources", "ThresholdSelectionSource")));
  if (!manager || !description)
  {
    return;
  }
  BEGIN_UNDO_EXCLUDE();
  const std::string elements = vtkSMPropertyHelper(source->getProxy(), "ElementType").GetAsString();
  const bool isOfPoints = elements == "Points";
  const std::vector<double> range = { 1, 1 };
  constexpr const char* array = "Selected"; // see vtkSelectElements
  vtkSMPropertyHelper(description, "ArrayName").Set(array);
  vtkSMPropertyHelper(description, "Thresholds").Set(range.data(), 2);
  vtkSMPropertyHelper(description, "FieldType")
    .Set(isOfPoints ? vtkSelectionNode::POINT : vtkSelectionNode::CELL);
  description->UpdateVTKObjects();
  const auto selection = vtkSmartPointer<vtkSMSourceProxy>::Take(vtkSMSourceProxy::SafeDownCast(
    vtkSMSelectionHelper::NewAppendSelectionsFromSelectionSource(description)));
  // The first call clears selections of all other outputs. Both calls change the active source,
  // which a script may have set to something else.
  const QPointer<pqOutputPort> active = pqActiveObjects::instance().activePort();
  pqOutputPort* port = source->getOutputPort(0);
  manager->select(port);
  port->setSelectionInput(selection, 0);
  manager->select(port);
  if (active && active->getSource() != source)
  {
    pqActiveObjects::instance().setActivePort(active);
  }
  END_UNDO_EXCLUDE();

  SM_SCOPED_TRACE(CallFunction)
    .arg("SelectThresholds")
    .arg("Thresholds", range)
    .arg("ArrayName", array)
    .arg("FieldType", isOfPoints ? "POINT" : "CELL")
    .arg("Source", source->getProxy())
    .arg("comment", "make what Select Elements selects the active selection");
}
