// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PartialArrays.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <limits>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// An array name with the parts that have it.
struct PartialArray
{
  std::string Name;
  std::vector<vtkAbstractArray*> OfParts;

  /// An array for all parts, filled with the value for "undefined"; nullptr if they do not match.
  vtkSmartPointer<vtkDataArray> MakeJoint(vtkIdType size) const
  {
    int type = VTK_VOID, components = 0;
    for (vtkAbstractArray* const array : this->OfParts)
    {
      if (!array)
      {
        continue;
      }
      const bool isFirst = type == VTK_VOID;
      if (!vtkDataArray::SafeDownCast(array) || array->GetDataType() == VTK_BIT ||
        (!isFirst && array->GetNumberOfComponents() != components))
      {
        return nullptr;
      }
      components = array->GetNumberOfComponents();
      type = isFirst || array->GetDataType() == type ? array->GetDataType() : VTK_DOUBLE;
    }
    auto joint = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    joint->SetName(this->Name.c_str());
    joint->SetNumberOfComponents(components);
    joint->SetNumberOfTuples(size);
    const bool isReal = type == VTK_FLOAT || type == VTK_DOUBLE;
    joint->Fill(isReal ? std::numeric_limits<double>::quiet_NaN() : 0);
    return joint;
  }
};

//------------------------------------------------------------------------------
std::vector<PartialArray> FindPartialArrays(
  const std::vector<vtkDataSetAttributes*>& parts, vtkDataSetAttributes* merged)
{
  std::vector<PartialArray> found;
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    for (int i = 0; i < parts[part]->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = parts[part]->GetAbstractArray(i);
      const std::string name = array->GetName() ? array->GetName() : "";
      if (name.empty() || merged->HasArray(name.c_str()) ||
        name == vtkDataSetAttributes::GhostArrayName() || array == parts[part]->GetGlobalIds())
      {
        continue;
      }
      auto known = std::find_if(found.begin(), found.end(),
        [&name](const PartialArray& other) { return other.Name == name; });
      if (known == found.end())
      {
        known =
          found.insert(known, { name, std::vector<vtkAbstractArray*>(parts.size(), nullptr) });
      }
      known->OfParts[part] = array;
    }
  }
  return found;
}
}

//------------------------------------------------------------------------------
std::vector<std::string> AddPartialArrays(const std::vector<vtkDataSetAttributes*>& parts,
  vtkIdType size, const std::function<TupleSource(vtkIdType)>& getSource,
  vtkDataSetAttributes* merged)
{
  std::vector<std::string> leftOut;
  for (const PartialArray& partial : FindPartialArrays(parts, merged))
  {
    const vtkSmartPointer<vtkDataArray> joint = partial.MakeJoint(size);
    if (!joint)
    {
      leftOut.push_back(partial.Name);
      continue;
    }
    for (vtkIdType i = 0; i < size; ++i)
    {
      const TupleSource source = getSource(i);
      auto* const array = vtkDataArray::SafeDownCast(partial.OfParts[source.Part]);
      for (int c = 0; array && c < joint->GetNumberOfComponents(); ++c)
      {
        joint->SetComponent(i, c, array->GetComponent(source.Tuple, c));
      }
    }
    merged->AddArray(joint);
  }
  return leftOut;
}
}
