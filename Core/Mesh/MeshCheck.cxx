// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MeshCheck.h"

#include "Base/Parallel.h"
#include "Mesh/MeshView.h"
#include "vtkCamaronCompat.h"

#include <algorithm>
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
constexpr vtkIdType Grain = 1 << 18; // in ids

//------------------------------------------------------------------------------
// Whether an id is negative or not below the limit: either the id or its distance from the last
// valid id is negative then.
template <typename Id>
bool HasIdBeyond(const Id* ids, vtkIdType size, vtkIdType limit)
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
  return bits >> (std::numeric_limits<Bits>::digits - 1) != 0;
}

//------------------------------------------------------------------------------
// Whether there is such an id in any list, including faces without a cell.
bool HasIdBeyond(const MeshView& mesh)
{
  const vtkIdType limit = mesh.GetNumberOfPoints();
  std::atomic<bool> isFound(false);
  mesh.VisitPointIds(
    [&](const IndexRange& ids)
    {
      ParallelFor(ids.Size, Grain,
        [&](vtkIdType begin, vtkIdType end)
        {
          const vtkIdType first = ids.Begin + begin, size = end - begin;
          if (ids.Values.Values32 ? HasIdBeyond(ids.Values.Values32 + first, size, limit)
                                  : HasIdBeyond(ids.Values.Values64 + first, size, limit))
          {
            isFound = true;
          }
        });
    });
  return isFound;
}

//------------------------------------------------------------------------------
/// Whether there is an invalid id; @a bad returns the first of them.
bool FindBadId(const IndexRange& ids, vtkIdType numberOfPoints, vtkIdType& bad)
{
  for (vtkIdType i = 0; i < ids.Size; ++i)
  {
    if (ids[i] < 0 || ids[i] >= numberOfPoints)
    {
      bad = ids[i];
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool FindBadId(const MeshView& mesh, vtkIdType cell, vtkIdType& bad)
{
  const vtkIdType numberOfPoints = mesh.GetNumberOfPoints();
  if (FindBadId(mesh.GetCellPoints(cell), numberOfPoints, bad))
  {
    return true;
  }
  if (mesh.HasPolyhedra())
  {
    const IndexRange faces = mesh.GetPolyhedronFaces(cell);
    for (vtkIdType f = 0; f < faces.Size; ++f)
    {
      if (FindBadId(mesh.GetPolyhedronFacePoints(faces[f]), numberOfPoints, bad))
      {
        return true;
      }
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
void CheckPointIds(vtkDataSet* data)
{
  const MeshView mesh(data);
  if (!HasIdBeyond(mesh))
  {
    return;
  }
  const vtkIdType numberOfCells = mesh.GetNumberOfCells();
  std::atomic<vtkIdType> first(numberOfCells);
  ParallelFor(numberOfCells, 1 << 14,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType id;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        if (FindBadId(mesh, cell, id))
        {
          vtkIdType known = first;
          while (cell < known && !first.compare_exchange_weak(known, cell))
          {
          }
          return;
        }
      }
    });
  vtkIdType bad = 0;
  if (first < numberOfCells && FindBadId(mesh, first, bad))
  {
    throw std::runtime_error("cell " + std::to_string(first) + " uses point " +
      std::to_string(bad) + ", but the mesh has " + std::to_string(mesh.GetNumberOfPoints()) +
      " points");
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
}
