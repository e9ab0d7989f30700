// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CellSizes.h"

#include "Mesh/CellShape.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"

namespace camaron
{
namespace
{
constexpr int NumberOfExamples = 5; // in messages
constexpr double MaxDegree = 1000;  // VTK evaluates up to 10

//------------------------------------------------------------------------------
// The shape of cells of variable order.
enum class Form
{
  None,
  Curve,
  Triangle,
  Quadrilateral,
  Tetrahedron,
  Hexahedron,
  Wedge
};

//------------------------------------------------------------------------------
Form GetForm(unsigned char type)
{
  switch (type)
  {
    case VTK_LAGRANGE_CURVE:
    case VTK_BEZIER_CURVE:
      return Form::Curve;
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_BEZIER_TRIANGLE:
      return Form::Triangle;
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_QUADRILATERAL:
      return Form::Quadrilateral;
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_BEZIER_TETRAHEDRON:
      return Form::Tetrahedron;
    case VTK_LAGRANGE_HEXAHEDRON:
    case VTK_BEZIER_HEXAHEDRON:
      return Form::Hexahedron;
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_WEDGE:
      return Form::Wedge;
    default:
      return Form::None;
  }
}

//------------------------------------------------------------------------------
// The number of points of a cell with these degrees.
vtkIdType GetSize(Form form, const std::array<vtkIdType, 3>& degrees)
{
  const vtkIdType i = degrees[0] + 1, j = degrees[1] + 1, k = degrees[2] + 1;
  switch (form)
  {
    case Form::Curve:
      return i;
    case Form::Triangle:
      return i * (i + 1) / 2;
    case Form::Quadrilateral:
      return i * j;
    case Form::Tetrahedron:
      return i * (i + 1) * (i + 2) / 6;
    case Form::Hexahedron:
      return i * j * k;
    case Form::Wedge:
      return i * (i + 1) / 2 * k;
    default:
      return 0;
  }
}

//------------------------------------------------------------------------------
// VTK's quadratic cells with points at the centers of their faces and their volume; else 0.
vtkIdType GetSizeWithCenters(Form form)
{
  return form == Form::Triangle ? 7 : form == Form::Tetrahedron ? 15 : form == Form::Wedge ? 21 : 0;
}

//------------------------------------------------------------------------------
bool IsSizeOfAnOrder(Form form, vtkIdType size)
{
  vtkIdType order = 1;
  while (GetSize(form, { order, order, order }) < size)
  {
    ++order;
  }
  return GetSize(form, { order, order, order }) == size ||
    (size > 0 && size == GetSizeWithCenters(form));
}
}

//------------------------------------------------------------------------------
CellSizes::CellSizes(vtkDataSet* mesh)
  : Degrees(mesh->GetCellData()->GetHigherOrderDegrees())
{
  for (int type = 0; type < 256; ++type)
  {
    const bool hasOrder = GetForm(static_cast<unsigned char>(type)) != Form::None;
    this->Sizes[type] = hasOrder || type == VTK_QUADRATIC_POLYGON
      ? SomeSizes
      : GetCellShape(static_cast<unsigned char>(type)).NumberOfNodes;
  }
}

//------------------------------------------------------------------------------
// The order of simplices is always the same in all directions.
bool CellSizes::DependOnCell(unsigned char type) const
{
  const Form form = GetForm(type);
  return this->Degrees &&
    (form == Form::Quadrilateral || form == Form::Hexahedron || form == Form::Wedge);
}

//------------------------------------------------------------------------------
bool CellSizes::GetDegrees(
  vtkIdType cell, unsigned char type, std::array<vtkIdType, 3>& degrees) const
{
  if (cell >= this->Degrees->GetNumberOfTuples() || this->Degrees->GetNumberOfComponents() != 3)
  {
    return false;
  }
  degrees[2] = 1;
  for (int i = 0; i < (GetForm(type) == Form::Quadrilateral ? 2 : 3); ++i)
  {
    const double degree = this->Degrees->GetComponent(cell, i);
    if (!(degree >= 1 && degree <= MaxDegree))
    {
      return false;
    }
    degrees[i] = static_cast<vtkIdType>(degree);
  }
  return true;
}

//------------------------------------------------------------------------------
bool CellSizes::CanBe(vtkIdType cell, unsigned char type, vtkIdType size) const
{
  if (this->Sizes[type] != SomeSizes)
  {
    return this->Sizes[type] == AnySize || this->Sizes[type] == size;
  }
  if (type == VTK_QUADRATIC_POLYGON)
  {
    return size % 2 == 0; // a vertex and the middle of an edge in turn
  }
  const Form form = GetForm(type);
  if (!this->DependOnCell(type))
  {
    return IsSizeOfAnOrder(form, size);
  }
  std::array<vtkIdType, 3> degrees;
  if (!this->GetDegrees(cell, type, degrees) || (form == Form::Wedge && degrees[0] != degrees[1]))
  {
    return false;
  }
  const bool isQuadratic = degrees[0] == 2 && degrees[2] == 2;
  return GetSize(form, degrees) == size || (isQuadratic && size == GetSizeWithCenters(form));
}

//------------------------------------------------------------------------------
std::string CellSizes::Describe(vtkIdType cell, unsigned char type) const
{
  if (this->Sizes[type] != SomeSizes)
  {
    return std::to_string(this->Sizes[type]);
  }
  if (type == VTK_QUADRATIC_POLYGON)
  {
    return "an even number";
  }
  const Form form = GetForm(type);
  std::array<vtkIdType, 3> degrees;
  if (this->DependOnCell(type) && !this->GetDegrees(cell, type, degrees))
  {
    return "three degrees of at least 1 for it in HigherOrderDegrees";
  }
  if (this->DependOnCell(type))
  {
    const std::string first = std::to_string(degrees[0]), second = std::to_string(degrees[1]),
                      third = std::to_string(degrees[2]);
    if (form == Form::Wedge && degrees[0] != degrees[1])
    {
      return "equal degrees in its triangles, not " + first + " and " + second;
    }
    return std::to_string(GetSize(form, degrees)) + " for its degrees " + first +
      (form == Form::Quadrilateral ? " and " + second : ", " + second + " and " + third);
  }
  std::string sizes;
  for (vtkIdType order = 1; order <= NumberOfExamples; ++order)
  {
    sizes += std::to_string(GetSize(form, { order, order, order })) + ", ";
    const vtkIdType size = order == 2 ? GetSizeWithCenters(form) : 0;
    sizes += size > 0 ? std::to_string(size) + ", " : "";
  }
  return sizes + "...";
}
}
