// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces, edges and vertices of the inspected mesh, which are cells of outputs of Mesh Elements.
#include "pqInspectedMesh.h"

#include "InspectedMeshTypes.h"
#include "ThresholdSelection.h"

#include "pqOutputPort.h"
#include "pqPipelineSource.h"

namespace
{
constexpr const char* ElementsName = "MeshElements";

//------------------------------------------------------------------------------
// The input of a filter whose output has the same elements; nullptr for other sources.
pqOutputPort* GetSameElements(pqOutputPort* port)
{
  bool isSame = false;
  for (const char* name :
    { "ElementQuality", camaron::SelectName, "ExtractSelection", "Threshold" })
  {
    isSame = isSame || camaron::IsFilter(port->getSource(), name);
  }
  return isSame ? camaron::GetInput(port->getSource()) : nullptr;
}
}

const QStringList pqInspectedMesh::ElementTypes = { "Face", "Edge", "Vertex" };

//------------------------------------------------------------------------------
pqOutputPort* pqInspectedMesh::elementSource() const
{
  pqOutputPort* port = this->Port;
  while (port && !camaron::IsFilter(port->getSource(), ElementsName))
  {
    port = GetSameElements(port);
  }
  return port;
}

//------------------------------------------------------------------------------
QString pqInspectedMesh::elementType() const
{
  const pqOutputPort* port = this->elementSource();
  return port ? ElementTypes.value(port->getPortNumber()) : QString("Cell");
}

//------------------------------------------------------------------------------
QString pqInspectedMesh::element() const
{
  const QString names[] = { tr("face"), tr("edge"), tr("vertex") };
  const pqOutputPort* port = this->elementSource();
  return port ? names[port->getPortNumber()] : tr("cell");
}

//------------------------------------------------------------------------------
QString pqInspectedMesh::elements() const
{
  const QString names[] = { tr("faces"), tr("edges"), tr("vertices") };
  const pqOutputPort* port = this->elementSource();
  return port ? names[port->getPortNumber()] : tr("cells");
}

//------------------------------------------------------------------------------
pqPipelineSource* pqInspectedMesh::elementsFilter() const
{
  for (pqOutputPort* port = this->Port; port; port = GetSameElements(port))
  {
    for (pqPipelineSource* consumer : port->getConsumers())
    {
      if (camaron::IsFilter(consumer, ElementsName))
      {
        return consumer;
      }
    }
  }
  return nullptr;
}
