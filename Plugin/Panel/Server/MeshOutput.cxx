// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshOutput.h"

#include "InspectedMeshTypes.h"
#include "ProxyValues.h"
#include "ThresholdSelection.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"

#include "vtkDataSetAttributes.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

namespace camaron
{
namespace
{
constexpr const char* ElementsName = "MeshElements";

//------------------------------------------------------------------------------
// The input of a filter whose output has the same elements; nullptr for other sources.
pqOutputPort* GetSameElements(pqOutputPort* port)
{
  bool isSame = false;
  for (const char* name : { "ElementQuality", SelectName, "ExtractSelection", "Threshold" })
  {
    isSame = isSame || IsFilter(port->getSource(), name);
  }
  return isSame ? GetInput(port->getSource()) : nullptr;
}

//------------------------------------------------------------------------------
// The output of Mesh Elements that a mesh consists of; nullptr if it consists of cells.
pqOutputPort* FindElements(pqOutputPort* port)
{
  while (port && !IsFilter(port->getSource(), ElementsName))
  {
    port = GetSameElements(port);
  }
  return port;
}

//------------------------------------------------------------------------------
// The Mesh Elements of cells, if there is one.
pqPipelineSource* FindElementsFilter(pqOutputPort* cells)
{
  for (pqOutputPort* port = cells; port; port = GetSameElements(port))
  {
    for (pqPipelineSource* consumer : port->getConsumers())
    {
      if (IsFilter(consumer, ElementsName))
      {
        return consumer;
      }
    }
  }
  return nullptr;
}
}

//------------------------------------------------------------------------------
// Faces, edges and vertices, which are cells of outputs of Mesh Elements.
const QStringList MeshOutput::ElementTypes = { "Face", "Edge", "Vertex" };

//------------------------------------------------------------------------------
vtkPVDataInformation* MeshOutput::information() const
{
  return this->Port ? this->Port->getDataInformation() : nullptr;
}

//------------------------------------------------------------------------------
vtkPVArrayInformation* MeshOutput::array(const QString& name, int association) const
{
  vtkPVDataInformation* information = this->information();
  return information ? information->GetArrayInformation(name.toUtf8().constData(), association)
                     : nullptr;
}

//------------------------------------------------------------------------------
QStringList MeshOutput::cellArrays() const
{
  QStringList names;
  if (vtkPVDataInformation* information = this->information())
  {
    auto* arrays = information->GetCellDataInformation();
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      vtkPVArrayInformation* array = arrays->GetArrayInformation(i);
      if (array->GetName() && array->GetNumberOfComponents() == 1)
      {
        names << QString::fromUtf8(array->GetName());
      }
    }
  }
  return names;
}

//------------------------------------------------------------------------------
QString MeshOutput::idSpace() const
{
  vtkPVDataInformation* information = this->information();
  const bool hasIds = information &&
    information->GetCellDataInformation()->GetAttributeInformation(vtkDataSetAttributes::GLOBALIDS);
  return hasIds ? "Global id" : "Index";
}

//------------------------------------------------------------------------------
vtkSMProxy* MeshOutput::settings()
{
  pqServer* server = pqActiveObjects::instance().activeServer();
  return server ? server->proxyManager()->GetProxy("settings", "MeshInspectorSettings") : nullptr;
}

//------------------------------------------------------------------------------
bool MeshOutput::isSmall() const
{
  vtkPVDataInformation* information = this->information();
  return information &&
    information->GetNumberOfCells() <=
    GetProperty(MeshOutput::settings(), "AutomaticLimit").toLongLong();
}

//------------------------------------------------------------------------------
vtkSMSourceProxy* MeshOutput::selection() const
{
  return this->Port ? this->Port->getSelectionInput() : nullptr;
}

//------------------------------------------------------------------------------
QString MeshOutput::elementType() const
{
  const pqOutputPort* port = FindElements(this->Port);
  return port ? ElementTypes.value(port->getPortNumber()) : QString("Cell");
}

//------------------------------------------------------------------------------
QString MeshOutput::elements(qint64 count) const
{
  const QString one[] = { tr("face"), tr("edge"), tr("vertex"), tr("cell") };
  const QString many[] = { tr("faces"), tr("edges"), tr("vertices"), tr("cells") };
  const pqOutputPort* port = FindElements(this->Port);
  return (count == 1 ? one : many)[port ? port->getPortNumber() : ElementTypes.size()];
}

//------------------------------------------------------------------------------
pqOutputPort* MeshOutput::elementsPort(const QString& type) const
{
  const pqOutputPort* present = FindElements(this->Port);
  pqPipelineSource* filter = present ? present->getSource() : FindElementsFilter(this->Port);
  return !filter     ? nullptr
    : type == "Cell" ? GetInput(filter)
                     : filter->getOutputPort(static_cast<int>(ElementTypes.indexOf(type)));
}

//------------------------------------------------------------------------------
pqRenderView* MeshOutput::view() const
{
  auto* active = qobject_cast<pqRenderView*>(pqActiveObjects::instance().activeView());
  const auto shows = [this](pqRenderView* view)
  {
    pqDataRepresentation* shown = this->Port ? this->Port->getRepresentation(view) : nullptr;
    return shown && shown->isVisible();
  };
  if (!active || !shows(active))
  {
    auto* model = pqApplicationCore::instance()->getServerManagerModel();
    for (pqRenderView* other :
      model->findItems<pqRenderView*>(pqActiveObjects::instance().activeServer()))
    {
      if (shows(other))
      {
        return other;
      }
    }
  }
  return active;
}

//------------------------------------------------------------------------------
pqDataRepresentation* MeshOutput::representation() const
{
  pqRenderView* view = this->view();
  return this->Port && view ? this->Port->getRepresentation(view) : nullptr;
}
}
