// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MarkedElements.h"

#include "InspectedMeshTypes.h"
#include "ProxyValues.h"
#include "pqInspectedMesh.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

namespace camaron
{
//------------------------------------------------------------------------------
Helper MarkElements(const pqInspectedMesh& mesh, const QString& strategy, const QString& elements)
{
  // One for each, which marks again without computing.
  const QByteArray key = "Marked" + (strategy + elements).toLatin1();
  const Helper select = mesh.helpers().filter(
    SelectName, mesh.port(), key, { { "Strategy", strategy }, { "ElementType", elements } });
  if (select)
  {
    vtkSMPropertyHelper input(select, "Selection");
    vtkSMSourceProxy* selection = mesh.selection();
    if (input.GetAsProxy() != selection) // else the filter would mark them once more
    {
      input.RemoveAllValues();
      if (selection)
      {
        input.Set(selection, 0);
      }
    }
    select->UpdateVTKObjects();
  }
  return select;
}

//------------------------------------------------------------------------------
qint64 CountElements(const pqInspectedMesh& mesh, const QString& strategy, const QString& elements)
{
  const Helper select = MarkElements(mesh, strategy, elements);
  if (!mesh.helpers().update(select))
  {
    return 0;
  }
  vtkSMProperty* number = select->GetProperty("NumberOfSelectedElements");
  UpdateInformation(select, number);
  return vtkSMPropertyHelper(number).GetAsIdType();
}

//------------------------------------------------------------------------------
Helper ExtractElements(const pqInspectedMesh& mesh, const Location& location, const char* key)
{
  const bool isOfPlace = !location.GroupArray.isEmpty();
  HelperFilters::Properties properties = isOfPlace
    ? GrowToPlace(location.GroupArray, location.GroupLimits)
    : HelperFilters::Properties();
  properties["Strategy"] = QString(isOfPlace ? "Connected to ids" : "By id");
  properties["Ids"] = location.Id;
  properties["IdSpace"] = location.IdSpace;
  const Helper selected = mesh.helpers().filter(SelectName, mesh.cellsPort(), key, properties);
  const Helper extraction = mesh.helpers().filter("ExtractSelection", mesh.cellsPort(), key);
  if (!selected || !extraction)
  {
    return nullptr;
  }
  vtkSMPropertyHelper(extraction, "Selection").Set(selected, 1);
  extraction->UpdateVTKObjects();
  return extraction;
}
}
