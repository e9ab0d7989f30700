// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GatheredArrays.h"

#include "Scan/ScanError.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributesFieldList.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace camaron
{
namespace
{
using Piece = GatheredPieces::Piece;

//------------------------------------------------------------------------------
// A FieldList sorts arrays by name; this restores the order of the mesh.
void RestoreOrder(vtkDataSetAttributes* data, vtkDataSetAttributes* model)
{
  std::vector<std::pair<vtkSmartPointer<vtkAbstractArray>, int>> arrays;
  for (int i = 0; i < model->GetNumberOfArrays(); ++i)
  {
    const char* const name = model->GetAbstractArray(i)->GetName();
    int index = -1;
    vtkAbstractArray* const array = name ? data->GetAbstractArray(name, index) : nullptr;
    if (array)
    {
      arrays.emplace_back(array, data->IsArrayAnAttribute(index));
    }
  }
  for (const auto& array : arrays)
  {
    data->RemoveArray(array.first->GetName());
  }
  for (const auto& array : arrays)
  {
    const int index = data->AddArray(array.first);
    if (array.second >= 0)
    {
      data->SetActiveAttribute(index, array.second);
    }
  }
}

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

//------------------------------------------------------------------------------
// Where a point or cell of the merged mesh comes from.
struct TupleSource
{
  std::size_t Part;
  vtkIdType Tuple;
};

//------------------------------------------------------------------------------
// Merges the arrays of points or cells, see MergeParts; adds the names of those that cannot be
// joined to @a leftOut: strings, bits, or different numbers of components.
void Merge(const std::vector<vtkDataSetAttributes*>& parts, vtkIdType size,
  const std::function<TupleSource(vtkIdType)>& getSource, vtkDataSetAttributes* merged,
  std::vector<std::string>& leftOut)
{
  if (parts.empty())
  {
    return;
  }
  vtkDataSetAttributes::FieldList fields;
  for (vtkDataSetAttributes* const part : parts)
  {
    fields.IntersectFieldList(part);
  }
  merged->CopyGlobalIdsOn(); // all points merged into one have the same id
  merged->CopyAllocate(fields, size);
  for (vtkIdType i = 0; merged->GetNumberOfArrays() > 0 && i < size; ++i)
  {
    const TupleSource source = getSource(i);
    fields.CopyData(static_cast<int>(source.Part), parts[source.Part], source.Tuple, merged, i);
  }
  merged->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  RestoreOrder(merged, parts.front());
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
}
}

//------------------------------------------------------------------------------
void MergeArrays(const GatheredPieces& pieces, vtkUnstructuredGrid* grid, Warnings& warnings)
{
  std::vector<vtkDataSetAttributes*> ofPoints, ofCells;
  for (const Piece& piece : pieces.GetPieces())
  {
    ofPoints.push_back(piece.Mesh->GetPointData());
    ofCells.push_back(piece.Mesh->GetCellData());
  }
  const auto getSource = [&pieces](vtkIdType id, vtkIdType Piece::* first)
  {
    const Piece& piece = pieces.FindPiece(id, first);
    return TupleSource{ pieces.GetIndex(piece), id - piece.*first };
  };
  std::vector<std::string> leftOut;
  Merge(
    ofPoints, pieces.GetNumberOfNewPoints(),
    [&](vtkIdType i) { return getSource(pieces.GetOldPoint(i), &Piece::FirstPoint); },
    grid->GetPointData(), leftOut);
  Merge(
    ofCells, grid->GetNumberOfCells(), [&](vtkIdType i)
    { return getSource(pieces.GetOldCell(i), &Piece::FirstCell); }, grid->GetCellData(), leftOut);
  std::string names;
  for (const std::string& name : leftOut)
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  if (!names.empty())
  {
    warnings.Add(
      "arrays that some parts of the mesh lack or store in another form are omitted: " + names);
  }
}

//------------------------------------------------------------------------------
void MergeFieldData(const std::vector<MeshPart>& parts, vtkFieldData* merged)
{
  for (const MeshPart& part : parts)
  {
    vtkFieldData* const data = part.Mesh->GetFieldData();
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = data->GetAbstractArray(i);
      if (array->GetName() && !merged->HasArray(array->GetName()))
      {
        merged->AddArray(array);
      }
    }
  }
}
}
