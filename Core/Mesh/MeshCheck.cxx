// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MeshCheck.h"

#include "Mesh/MeshView.h"
#include "Parallel.h"

#include <atomic>
#include <stdexcept>
#include <string>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
/// Whether there is an id that is no point; then @a bad is the first of them.
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
    throw std::runtime_error("cell " + std::to_string(first) + " has the point " +
      std::to_string(bad) + ", and the mesh has " + std::to_string(mesh.GetNumberOfPoints()) +
      " points");
  }
}
}
