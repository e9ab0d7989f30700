// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshChecks.h"

#include "vtkCamaronCompat.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cstring>
#include <sstream>

namespace camaron
{
namespace testing
{
namespace
{
template <typename... Parts>
std::string Say(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

//------------------------------------------------------------------------------
/// Number of points of a cell type; 0 if any number, -1 for types that our readers never create.
int GetNumberOfPoints(int type)
{
  switch (type)
  {
    case VTK_VERTEX:
      return 1;
    case VTK_LINE:
      return 2;
    case VTK_TRIANGLE:
    case VTK_QUADRATIC_EDGE:
      return 3;
    case VTK_QUAD:
    case VTK_TETRA:
      return 4;
    case VTK_PYRAMID:
      return 5;
    case VTK_WEDGE:
    case VTK_QUADRATIC_TRIANGLE:
      return 6;
    case VTK_HEXAHEDRON:
    case VTK_QUADRATIC_QUAD:
      return 8;
    case VTK_QUADRATIC_TETRA:
      return 10;
    case VTK_QUADRATIC_PYRAMID:
      return 13;
    case VTK_QUADRATIC_WEDGE:
      return 15;
    case VTK_QUADRATIC_HEXAHEDRON:
      return 20;
    case VTK_EMPTY_CELL:
    case VTK_POLY_VERTEX:
    case VTK_POLY_LINE:
    case VTK_TRIANGLE_STRIP:
    case VTK_POLYGON:
    case VTK_POLYHEDRON:
      return 0;
    default:
      return -1;
  }
}

//------------------------------------------------------------------------------
// Offsets must begin at 0, not descend and end at the end of the ids, which are in [0, limit).
std::string FindFault(vtkCellArray* lists, vtkIdType limit, const char* what)
{
  vtkDataArray* offsets = lists->GetOffsetsArray();
  vtkDataArray* ids = lists->GetConnectivityArray();
  const vtkIdType count = lists->GetNumberOfCells();
  if (offsets->GetNumberOfValues() != count + 1 &&
    !(count == 0 && offsets->GetNumberOfValues() == 0))
  {
    return Say(what, ": ", offsets->GetNumberOfValues(), " offsets of ", count, " lists");
  }
  vtkIdType last = 0;
  for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i)
  {
    const auto offset = static_cast<vtkIdType>(offsets->GetComponent(i, 0));
    if (offset < last || (i == 0 && offset != 0))
    {
      return Say(what, ": offset ", i, " is ", offset, " after ", last);
    }
    last = offset;
  }
  if (last != ids->GetNumberOfValues())
  {
    return Say(what, ": offsets end at ", last, " of ", ids->GetNumberOfValues(), " ids");
  }
  for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
  {
    const auto id = static_cast<vtkIdType>(ids->GetComponent(i, 0));
    if (id < 0 || id >= limit)
    {
      return Say(what, ": id ", id, " is not below ", limit);
    }
  }
  return {};
}

//------------------------------------------------------------------------------
// A sum over all bytes, so that a sanitizer sees an array that is longer than its memory.
std::string FindFault(vtkFieldData* fields, vtkIdType tuples, const char* what)
{
  static volatile unsigned char sink;
  unsigned char sum = 0;
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = fields->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    if (name.empty())
    {
      return Say("a ", what, " array has no name");
    }
    for (int other = 0; other < i; ++other)
    {
      if (name == fields->GetAbstractArray(other)->GetName())
      {
        return Say("two ", what, " arrays are named ", name);
      }
    }
    if (tuples >= 0 && array->GetNumberOfTuples() != tuples)
    {
      return Say(
        what, " array ", name, " has ", array->GetNumberOfTuples(), " tuples, not ", tuples);
    }
    if (array->GetNumberOfComponents() < 1)
    {
      return Say(what, " array ", name, " has no components");
    }
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
    {
      const auto size = static_cast<std::size_t>(numbers->GetNumberOfValues()) *
        static_cast<std::size_t>(numbers->GetDataTypeSize());
      const auto* bytes =
        size > 0 ? static_cast<const unsigned char*>(numbers->GetVoidPointer(0)) : nullptr;
      for (std::size_t at = 0; at < size; ++at)
      {
        sum = static_cast<unsigned char>(sum + bytes[at]);
      }
    }
    else if (auto* strings = vtkStringArray::SafeDownCast(array))
    {
      for (vtkIdType at = 0; at < strings->GetNumberOfValues(); ++at)
      {
        for (const char letter : strings->GetValue(at))
        {
          sum = static_cast<unsigned char>(sum + letter);
        }
      }
    }
  }
  sink = sum;
  return {};
}

//------------------------------------------------------------------------------
std::string FindFaultOfPolyhedra(vtkUnstructuredGrid* grid)
{
  vtkCellArray* faces = grid->GetPolyhedronFaces();
  vtkCellArray* locations = grid->GetPolyhedronFaceLocations();
  const vtkIdType cells = grid->GetNumberOfCells();
  if (!faces || !locations || (locations->GetNumberOfCells() == 0 && cells > 0))
  {
    for (vtkIdType cell = 0; cell < cells; ++cell)
    {
      if (grid->GetCellType(cell) == VTK_POLYHEDRON)
      {
        return Say("polyhedron ", cell, " has no faces");
      }
    }
    return {};
  }
  if (locations->GetNumberOfCells() != cells)
  {
    return Say("faces of ", locations->GetNumberOfCells(), " cells of ", cells);
  }
  std::string fault = FindFault(faces, grid->GetNumberOfPoints(), "faces");
  if (fault.empty())
  {
    fault = FindFault(locations, faces->GetNumberOfCells(), "faces of cells");
  }
  for (vtkIdType cell = 0; cell < cells && fault.empty(); ++cell)
  {
    const bool isPolyhedron = grid->GetCellType(cell) == VTK_POLYHEDRON;
    if (isPolyhedron != (locations->GetCellSize(cell) > 0))
    {
      fault = Say("cell ", cell, " of type ", grid->GetCellType(cell), " has ",
        locations->GetCellSize(cell), " faces");
    }
  }
  return fault;
}

//------------------------------------------------------------------------------
std::string FindDifference(vtkAbstractArray* a, vtkAbstractArray* b)
{
  if (a->GetDataType() != b->GetDataType() || a->GetNumberOfValues() != b->GetNumberOfValues() ||
    a->GetNumberOfComponents() != b->GetNumberOfComponents())
  {
    return Say(a->GetNumberOfValues(), " values of ", a->GetDataTypeAsString(), " and ",
      b->GetNumberOfValues(), " of ", b->GetDataTypeAsString());
  }
  for (vtkIdType i = 0; i < a->GetNumberOfValues(); ++i)
  {
    if (a->GetVariantValue(i).ToString() != b->GetVariantValue(i).ToString())
    {
      return Say("value ", i, " is ", a->GetVariantValue(i).ToString(), " and ",
        b->GetVariantValue(i).ToString());
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::string FindDifference(vtkDataArray* a, vtkDataArray* b)
{
  const auto size = static_cast<std::size_t>(a->GetNumberOfValues()) *
    static_cast<std::size_t>(a->GetDataTypeSize());
  const bool isSame = a->GetDataType() == b->GetDataType() &&
    a->GetNumberOfValues() == b->GetNumberOfValues() &&
    (size == 0 || std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), size) == 0);
  return isSame
    ? std::string()
    : FindDifference(static_cast<vtkAbstractArray*>(a), static_cast<vtkAbstractArray*>(b)) +
      " (compared bit by bit)";
}

//------------------------------------------------------------------------------
std::string FindDifference(vtkCellArray* a, vtkCellArray* b, const char* what)
{
  const vtkIdType countOfA = a ? a->GetNumberOfCells() : 0,
                  countOfB = b ? b->GetNumberOfCells() : 0;
  if (countOfA != countOfB)
  {
    return Say(countOfA, " and ", countOfB, " lists of ", what);
  }
  vtkNew<vtkIdList> listOfA, listOfB;
  for (vtkIdType i = 0; i < countOfA; ++i)
  {
    a->GetCellAtId(i, listOfA);
    b->GetCellAtId(i, listOfB);
    bool isSame = listOfA->GetNumberOfIds() == listOfB->GetNumberOfIds();
    for (vtkIdType j = 0; isSame && j < listOfA->GetNumberOfIds(); ++j)
    {
      isSame = listOfA->GetId(j) == listOfB->GetId(j);
    }
    if (!isSame)
    {
      return Say(what, " of cell ", i, " differ");
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::string FindDifference(vtkFieldData* a, vtkFieldData* b, const char* what)
{
  if (a->GetNumberOfArrays() != b->GetNumberOfArrays())
  {
    return Say(a->GetNumberOfArrays(), " and ", b->GetNumberOfArrays(), " ", what, " arrays");
  }
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* one = a->GetAbstractArray(i);
    vtkAbstractArray* other = b->GetAbstractArray(one->GetName());
    if (!other)
    {
      return Say("only one has the ", what, " array ", one->GetName());
    }
    auto* numbers = vtkDataArray::SafeDownCast(one);
    auto* others = vtkDataArray::SafeDownCast(other);
    const std::string difference =
      numbers && others ? FindDifference(numbers, others) : FindDifference(one, other);
    if (!difference.empty())
    {
      return Say(what, " array ", one->GetName(), ": ", difference);
    }
  }
  return {};
}
}

//------------------------------------------------------------------------------
std::string FindFault(vtkUnstructuredGrid* grid)
{
  const vtkIdType points = grid->GetNumberOfPoints(), cells = grid->GetNumberOfCells();
  std::string fault = FindFault(grid->GetPointData(), points, "point");
  fault = fault.empty() ? FindFault(grid->GetCellData(), cells, "cell") : fault;
  fault = fault.empty() ? FindFault(grid->GetFieldData(), -1, "field") : fault;
  if (!fault.empty() || cells == 0)
  {
    return fault;
  }
  const vtkIdType types = GetCellTypes(grid)->GetNumberOfValues();
  if (types != cells)
  {
    return Say(types, " types of ", cells, " cells");
  }
  fault = FindFault(grid->GetCells(), points, "cells");
  for (vtkIdType cell = 0; cell < cells && fault.empty(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    const int expected = GetNumberOfPoints(type);
    const vtkIdType size = grid->GetCells()->GetCellSize(cell);
    if (expected < 0 || (expected > 0 && size != expected))
    {
      fault = Say("cell ", cell, " of type ", type, " has ", size, " points");
    }
  }
  return fault.empty() ? FindFaultOfPolyhedra(grid) : fault;
}

//------------------------------------------------------------------------------
std::string FindFault(vtkDataObject* data)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      const std::string fault = FindFault(iterator->GetCurrentDataObject());
      if (!fault.empty())
      {
        return fault;
      }
    }
    return {};
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return FindFault(grid);
  }
  auto* mesh = vtkDataSet::SafeDownCast(data);
  if (!mesh)
  {
    return {};
  }
  const vtkIdType points = mesh->GetNumberOfPoints();
  std::string fault = FindFault(mesh->GetPointData(), points, "point");
  fault = fault.empty() ? FindFault(mesh->GetCellData(), mesh->GetNumberOfCells(), "cell") : fault;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells() && fault.empty(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      if (ids->GetId(i) < 0 || ids->GetId(i) >= points)
      {
        fault = Say("cell ", cell, ": id ", ids->GetId(i), " is not below ", points);
      }
    }
  }
  return fault;
}

//------------------------------------------------------------------------------
std::string FindDifferenceOfCells(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  if (a->GetNumberOfPoints() != b->GetNumberOfPoints() ||
    a->GetNumberOfCells() != b->GetNumberOfCells())
  {
    return Say(a->GetNumberOfPoints(), " and ", b->GetNumberOfPoints(), " points, ",
      a->GetNumberOfCells(), " and ", b->GetNumberOfCells(), " cells");
  }
  std::string difference;
  if (a->GetNumberOfPoints() > 0)
  {
    difference = FindDifference(a->GetPoints()->GetData(), b->GetPoints()->GetData());
    difference = difference.empty() ? difference : "points: " + difference;
  }
  for (vtkIdType cell = 0; cell < a->GetNumberOfCells() && difference.empty(); ++cell)
  {
    if (a->GetCellType(cell) != b->GetCellType(cell))
    {
      difference =
        Say("cell ", cell, " is of type ", a->GetCellType(cell), " and ", b->GetCellType(cell));
    }
  }
  if (a->GetNumberOfCells() > 0 && difference.empty())
  {
    difference = FindDifference(a->GetCells(), b->GetCells(), "points");
  }
  if (difference.empty())
  {
    difference = FindDifference(a->GetPolyhedronFaces(), b->GetPolyhedronFaces(), "faces");
  }
  return difference;
}

//------------------------------------------------------------------------------
std::string FindDifference(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  std::string difference = FindDifferenceOfCells(a, b);
  if (difference.empty())
  {
    difference = FindDifference(a->GetPointData(), b->GetPointData(), "point");
  }
  if (difference.empty())
  {
    difference = FindDifference(a->GetCellData(), b->GetCellData(), "cell");
  }
  if (difference.empty())
  {
    difference = FindDifference(a->GetFieldData(), b->GetFieldData(), "field");
  }
  return difference;
}
}
}
