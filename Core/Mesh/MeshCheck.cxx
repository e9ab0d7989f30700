// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MeshCheck.h"

#include "Base/Parallel.h"
#include "Mesh/CellShape.h"
#include "Mesh/MeshView.h"
#include "vtkCamaronCompat.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace camaron
{
namespace
{
/**
 * How many points the cells of a mesh can have, by their types.
 *
 * Most types have a fixed number. Polygons, polyhedra and the like can have any; those with too few
 * to enclose something are defects that criteria report. The number of points of a Lagrange or
 * Bezier cell follows from its order; VTK reads orders that differ by direction from the cell array
 * of the attribute HigherOrderDegrees, otherwise the order is the same in all directions.
 */
class CellSizes
{
public:
  explicit CellSizes(vtkDataSet* mesh);

  /// The number of points of every cell of a type, or one of these.
  static constexpr int AnySize = 0, ///< as in a polygon, or a type without known vertices
    SomeSizes = -1;                 ///< CanBe knows them
  int Get(unsigned char type) const { return this->Sizes[type]; }

  /// Whether a cell of this type can have so many points. Thread-safe.
  bool CanBe(vtkIdType cell, unsigned char type, vtkIdType size) const;

  /// The numbers that a cell can have, such as "8", "4, 10, 15, 20, 35, ..." or "12 for its degrees
  /// 1, 2 and 1".
  std::string Describe(vtkIdType cell, unsigned char type) const;

  /// Whether cells of a type have degrees of their own.
  bool DependOnCell(unsigned char type) const;

private:
  bool GetDegrees(vtkIdType cell, unsigned char type, std::array<vtkIdType, 3>& degrees) const;

  std::array<int, 256> Sizes;
  vtkSmartPointer<vtkDataArray> Degrees;
};

//------------------------------------------------------------------------------
// The sign of the result tells whether an id is negative or not below the limit: either the id or
// its distance from the last valid id is negative then.
template <typename Id>
auto FindIdBeyond(const Id* ids, vtkIdType size, vtkIdType limit)
{
  using Bits = std::make_unsigned_t<Id>;
  const Bits last =
    static_cast<Bits>(std::min<std::int64_t>(limit - 1, std::numeric_limits<Id>::max()));
  Bits bits = 0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    const Bits id = static_cast<Bits>(ids[i]);
    bits |= id | (last - id);
  }
  return static_cast<Id>(bits);
}

//------------------------------------------------------------------------------
bool HasIdBeyond(const IndexArray& ids, vtkIdType begin, vtkIdType size, vtkIdType limit)
{
  return ids.Values32 ? FindIdBeyond(ids.Values32 + begin, size, limit) < 0
                      : FindIdBeyond(ids.Values64 + begin, size, limit) < 0;
}

//------------------------------------------------------------------------------
template <typename Id>
bool Descend(const Id* offsets, vtkIdType size)
{
  int descend = 0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    descend |= offsets[i + 1] < offsets[i];
  }
  return descend != 0;
}

//------------------------------------------------------------------------------
template <typename Id>
bool HaveSize(const Id* offsets, vtkIdType count, Id size)
{
  Id difference = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    difference |= (offsets[i + 1] - offsets[i]) ^ size;
  }
  return difference == 0;
}

//------------------------------------------------------------------------------
// Whether the lists from begin to end lie in the array of values.
bool AreInArray(const IndexLists& lists, vtkIdType begin, vtkIdType end)
{
  const IndexArray& offsets = lists.Offsets;
  return offsets[begin] >= 0 && offsets[end] <= lists.GetNumberOfValues() &&
    !(offsets.Values32 ? Descend(offsets.Values32 + begin, end - begin)
                       : Descend(offsets.Values64 + begin, end - begin));
}

//------------------------------------------------------------------------------
// Whether the values of all lists are between 0 and the limit, and isGood(begin, end) of all parts
// of the lists, which it can read.
template <typename IsGood>
bool AreValid(const IndexLists& lists, vtkIdType limit, IsGood&& isGood)
{
  std::atomic<bool> areValid(true);
  ParallelFor(lists.NumberOfLists, MediumGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      const vtkIdType first = lists.Offsets[begin], size = lists.Offsets[end] - first;
      if (!AreInArray(lists, begin, end) || HasIdBeyond(lists.Values, first, size, limit) ||
        !isGood(begin, end))
      {
        areValid = false;
      }
    });
  return areValid;
}

//------------------------------------------------------------------------------
/// Whether there is a value beyond the limit; @a bad returns the first of them.
bool FindBad(const IndexRange& values, vtkIdType limit, vtkIdType& bad)
{
  for (const vtkIdType value : values)
  {
    if (value < 0 || value >= limit)
    {
      bad = value;
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
class CellCheck
{
public:
  explicit CellCheck(vtkDataSet* data)
    : Mesh(data)
    , Sizes(data)
    , HasTypes(data->IsA("vtkUnstructuredGrid"))
  {
  }

  /// Whether all cells are valid, except that faces without a cell do not matter.
  bool IsValid() const;
  /// Throws an error about the first invalid cell; none if only faces without a cell are invalid.
  void Explain() const;

private:
  bool HaveSizes(vtkIdType begin, vtkIdType end) const;
  template <typename Id>
  bool HaveSizes(const Id* offsets, vtkIdType begin, vtkIdType end) const;
  bool HasTypesOfCells() const;
  bool HasLocationsOfCells() const;
  static void ExplainOffsets(const IndexLists& lists, const std::string& what, vtkIdType first);
  std::string Explain(vtkIdType cell) const;

  const MeshView Mesh;
  const CellSizes Sizes;
  const bool HasTypes;
};

//------------------------------------------------------------------------------
bool CellCheck::HasTypesOfCells() const
{
  return !this->HasTypes || this->Mesh.GetNumberOfTypes() == this->Mesh.GetNumberOfCells();
}

//------------------------------------------------------------------------------
bool CellCheck::HasLocationsOfCells() const
{
  const vtkIdType size = this->Mesh.GetFaceLocations().NumberOfLists;
  return size == 0 || size == this->Mesh.GetNumberOfCells();
}

//------------------------------------------------------------------------------
bool CellCheck::HaveSizes(vtkIdType begin, vtkIdType end) const
{
  const IndexArray& offsets = this->Mesh.GetCellLists()[0].Offsets;
  return offsets.Values32 ? this->HaveSizes(offsets.Values32, begin, end)
                          : this->HaveSizes(offsets.Values64, begin, end);
}

//------------------------------------------------------------------------------
// Most meshes have long runs of cells of one type.
template <typename Id>
bool CellCheck::HaveSizes(const Id* offsets, vtkIdType begin, vtkIdType end) const
{
  for (vtkIdType first = begin; first < end;)
  {
    const unsigned char type = this->Mesh.GetCellType(first);
    vtkIdType last = first + 1;
    while (last < end && this->Mesh.GetCellType(last) == type)
    {
      ++last;
    }
    const int size = this->Sizes.Get(type);
    if (size > 0 && !HaveSize(offsets + first, last - first, static_cast<Id>(size)))
    {
      return false;
    }
    Id known = -1; // size of the cell before
    for (vtkIdType cell = first; cell < last && size == CellSizes::SomeSizes; ++cell)
    {
      const Id own = offsets[cell + 1] - offsets[cell];
      if ((own != known || this->Sizes.DependOnCell(type)) && !this->Sizes.CanBe(cell, type, own))
      {
        return false;
      }
      known = own;
    }
    first = last;
  }
  return true;
}

//------------------------------------------------------------------------------
bool CellCheck::IsValid() const
{
  const auto always = [](vtkIdType, vtkIdType) { return true; };
  const MeshView& mesh = this->Mesh;
  const IndexLists& faces = mesh.GetFaceLists();
  if (!this->HasTypesOfCells() || !this->HasLocationsOfCells())
  {
    return false;
  }
  bool isValid = AreValid(mesh.GetFaceLocations(), faces.NumberOfLists, always) &&
    AreValid(faces, mesh.GetNumberOfPoints(), always);
  for (const IndexLists& cells : mesh.GetCellLists())
  {
    isValid = isValid &&
      AreValid(cells, mesh.GetNumberOfPoints(), [this](vtkIdType begin, vtkIdType end)
        { return !this->HasTypes || this->HaveSizes(begin, end); });
  }
  return isValid;
}

//------------------------------------------------------------------------------
void CellCheck::ExplainOffsets(const IndexLists& lists, const std::string& what, vtkIdType first)
{
  for (vtkIdType list = 0; list < lists.NumberOfLists; ++list)
  {
    if (!AreInArray(lists, list, list + 1))
    {
      throw std::runtime_error(what + std::to_string(first + list) + " have the offsets " +
        std::to_string(lists.Offsets[list]) + " and " + std::to_string(lists.Offsets[list + 1]) +
        ", expected ascending numbers from 0 to " + std::to_string(lists.GetNumberOfValues()));
    }
  }
}

//------------------------------------------------------------------------------
// What is wrong with a cell; empty if nothing is.
std::string CellCheck::Explain(vtkIdType cell) const
{
  const MeshView& mesh = this->Mesh;
  const IndexRange points = mesh.GetCellPoints(cell);
  const unsigned char type = mesh.GetCellType(cell);
  if (this->HasTypes && !this->Sizes.CanBe(cell, type, points.Size))
  {
    return "cell " + std::to_string(cell) + " (" + GetCellTypeName(type) + ") has " +
      std::to_string(points.Size) + (points.Size == 1 ? " point" : " points") + ", expected " +
      this->Sizes.Describe(cell, type);
  }
  const auto describe = [&](const char* what, vtkIdType number, vtkIdType limit)
  {
    return "cell " + std::to_string(cell) + " uses " + what + " " + std::to_string(number) +
      ", but the mesh has " + std::to_string(limit) + " " + what + "s";
  };
  vtkIdType bad = 0;
  if (FindBad(points, mesh.GetNumberOfPoints(), bad))
  {
    return describe("point", bad, mesh.GetNumberOfPoints());
  }
  const IndexRange faces = mesh.GetPolyhedronFaces(cell);
  if (FindBad(faces, mesh.GetFaceLists().NumberOfLists, bad))
  {
    return describe("face", bad, mesh.GetFaceLists().NumberOfLists);
  }
  for (const vtkIdType face : faces)
  {
    if (FindBad(mesh.GetPolyhedronFacePoints(face), mesh.GetNumberOfPoints(), bad))
    {
      return describe("point", bad, mesh.GetNumberOfPoints());
    }
  }
  return "";
}

//------------------------------------------------------------------------------
void CellCheck::Explain() const
{
  const MeshView& mesh = this->Mesh;
  const vtkIdType numberOfCells = mesh.GetNumberOfCells();
  if (!this->HasTypesOfCells())
  {
    throw std::runtime_error("the mesh has " + std::to_string(numberOfCells) +
      " cells, but the types of " + std::to_string(mesh.GetNumberOfTypes()));
  }
  if (!this->HasLocationsOfCells())
  {
    throw std::runtime_error("the mesh has " + std::to_string(numberOfCells) +
      " cells, but lists of faces of " + std::to_string(mesh.GetFaceLocations().NumberOfLists));
  }
  vtkIdType first = 0;
  for (const IndexLists& cells : mesh.GetCellLists())
  {
    ExplainOffsets(cells, "the points of cell ", first);
    first += cells.NumberOfLists;
  }
  ExplainOffsets(mesh.GetFaceLocations(), "the faces of cell ", 0);
  ExplainOffsets(mesh.GetFaceLists(), "the points of face ", 0);
  std::atomic<vtkIdType> bad(numberOfCells);
  ParallelFor(numberOfCells, MediumGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end && cell < bad; ++cell)
      {
        if (!this->Explain(cell).empty())
        {
          LowerTo(bad, cell);
        }
      }
    });
  if (bad < numberOfCells)
  {
    throw std::runtime_error(this->Explain(bad));
  }
}
}

//------------------------------------------------------------------------------
void CheckCells(vtkDataSet* data)
{
  const CellCheck check(data);
  if (!check.IsValid())
  {
    check.Explain();
  }
}

//------------------------------------------------------------------------------
void PolyhedronFaces::Add(vtkDataSet* data)
{
  const MeshView mesh(data);
  this->NumberWithFaces += mesh.HasPolyhedra();
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells() && !mesh.HasPolyhedra(); ++cell)
  {
    this->NumberOfPolyhedra += mesh.GetCellType(cell) == VTK_POLYHEDRON;
  }
}

//------------------------------------------------------------------------------
void PolyhedronFaces::Check() const
{
  if (this->NumberOfPolyhedra > 0 && this->NumberWithFaces == 0)
  {
    throw std::runtime_error(std::to_string(this->NumberOfPolyhedra) +
      " cells are polyhedra, but none of them has faces" + GetReasonForLostFaces());
  }
}

namespace
{
constexpr int NumberOfExamples = 5; // in messages
constexpr double MaxDegree = 1000;  // VTK evaluates up to 10

//------------------------------------------------------------------------------
// The Lagrange type of the same shape as a Lagrange or Bezier type, which VTK numbers in the same
// order; 0 for other types.
int GetLagrangeType(int type)
{
  constexpr int difference = VTK_BEZIER_CURVE - VTK_LAGRANGE_CURVE;
  const bool isLagrange = type >= VTK_LAGRANGE_CURVE && type <= VTK_LAGRANGE_PYRAMID;
  const bool isBezier = type >= VTK_BEZIER_CURVE && type <= VTK_BEZIER_PYRAMID;
  return isLagrange ? type : isBezier ? type - difference : 0;
}

//------------------------------------------------------------------------------
// The number of points of a cell with these degrees.
vtkIdType GetSize(int lagrange, const std::array<vtkIdType, 3>& degrees)
{
  const vtkIdType i = degrees[0] + 1, j = degrees[1] + 1, k = degrees[2] + 1;
  switch (lagrange)
  {
    case VTK_LAGRANGE_CURVE:
      return i;
    case VTK_LAGRANGE_TRIANGLE:
      return i * (i + 1) / 2;
    case VTK_LAGRANGE_QUADRILATERAL:
      return i * j;
    case VTK_LAGRANGE_TETRAHEDRON:
      return i * (i + 1) * (i + 2) / 6;
    case VTK_LAGRANGE_HEXAHEDRON:
      return i * j * k;
    case VTK_LAGRANGE_WEDGE:
      return i * (i + 1) / 2 * k;
    case VTK_LAGRANGE_PYRAMID:
      return i * (i + 1) * (2 * i + 1) / 6;
    default:
      return 0;
  }
}

//------------------------------------------------------------------------------
// VTK's quadratic cells with points at the centers of their faces and their volume; else 0.
vtkIdType GetSizeWithCenters(int lagrange)
{
  return lagrange == VTK_LAGRANGE_TRIANGLE ? 7
    : lagrange == VTK_LAGRANGE_TETRAHEDRON ? 15
    : lagrange == VTK_LAGRANGE_WEDGE       ? 21
                                           : 0;
}

//------------------------------------------------------------------------------
bool IsSizeOfAnOrder(int lagrange, vtkIdType size)
{
  vtkIdType order = 1;
  while (GetSize(lagrange, { order, order, order }) < size)
  {
    ++order;
  }
  return GetSize(lagrange, { order, order, order }) == size ||
    (size > 0 && size == GetSizeWithCenters(lagrange));
}
}

//------------------------------------------------------------------------------
CellSizes::CellSizes(vtkDataSet* mesh)
  : Degrees(mesh->GetCellData()->GetHigherOrderDegrees())
{
  for (int type = 0; type < 256; ++type)
  {
    const bool hasOrder = GetLagrangeType(type) != 0;
    this->Sizes[type] = hasOrder || type == VTK_QUADRATIC_POLYGON
      ? SomeSizes
      : GetCellShape(static_cast<unsigned char>(type)).NumberOfNodes;
  }
}

//------------------------------------------------------------------------------
// The order of simplices is always the same in all directions.
bool CellSizes::DependOnCell(unsigned char type) const
{
  const int lagrange = GetLagrangeType(type);
  return this->Degrees &&
    (lagrange == VTK_LAGRANGE_QUADRILATERAL || lagrange == VTK_LAGRANGE_HEXAHEDRON ||
      lagrange == VTK_LAGRANGE_WEDGE);
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
  for (int i = 0; i < (GetLagrangeType(type) == VTK_LAGRANGE_QUADRILATERAL ? 2 : 3); ++i)
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
  const int lagrange = GetLagrangeType(type);
  if (!this->DependOnCell(type))
  {
    return IsSizeOfAnOrder(lagrange, size);
  }
  std::array<vtkIdType, 3> degrees;
  if (!this->GetDegrees(cell, type, degrees) ||
    (lagrange == VTK_LAGRANGE_WEDGE && degrees[0] != degrees[1]))
  {
    return false;
  }
  const bool isQuadratic = degrees[0] == 2 && degrees[2] == 2;
  return GetSize(lagrange, degrees) == size ||
    (isQuadratic && size == GetSizeWithCenters(lagrange));
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
  const int lagrange = GetLagrangeType(type);
  std::array<vtkIdType, 3> degrees;
  if (this->DependOnCell(type) && !this->GetDegrees(cell, type, degrees))
  {
    return "three degrees of at least 1 for it in HigherOrderDegrees";
  }
  if (this->DependOnCell(type))
  {
    const std::string first = std::to_string(degrees[0]), second = std::to_string(degrees[1]),
                      third = std::to_string(degrees[2]);
    if (lagrange == VTK_LAGRANGE_WEDGE && degrees[0] != degrees[1])
    {
      return "equal degrees in its triangles, not " + first + " and " + second;
    }
    return std::to_string(GetSize(lagrange, degrees)) + " for its degrees " + first +
      (lagrange == VTK_LAGRANGE_QUADRILATERAL ? " and " + second : ", " + second + " and " + third);
  }
  std::string sizes;
  for (vtkIdType order = 1; order <= NumberOfExamples; ++order)
  {
    sizes += std::to_string(GetSize(lagrange, { order, order, order })) + ", ";
    const vtkIdType size = order == 2 ? GetSizeWithCenters(lagrange) : 0;
    sizes += size > 0 ? std::to_string(size) + ", " : "";
  }
  return sizes + "...";
}
}
