// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MatchingCells.h"

#include "Base/Parallel.h"
#include "Mesh/MeshView.h"

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <atomic>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool AreEqual(const IndexRange& a, const IndexRange& b)
{
  bool equal = a.Size == b.Size;
  for (vtkIdType i = 0; i < a.Size && equal; ++i)
  {
    equal = a[i] == b[i];
  }
  return equal;
}

//------------------------------------------------------------------------------
bool HaveSameFaces(const MeshView& a, const MeshView& b, vtkIdType cell)
{
  const IndexRange facesOfA = a.GetPolyhedronFaces(cell), facesOfB = b.GetPolyhedronFaces(cell);
  bool equal = facesOfA.Size == facesOfB.Size;
  for (vtkIdType face = 0; face < facesOfA.Size && equal; ++face)
  {
    equal = AreEqual(
      a.GetPolyhedronFacePoints(facesOfA[face]), b.GetPolyhedronFacePoints(facesOfB[face]));
  }
  return equal;
}

//------------------------------------------------------------------------------
bool HaveSameCells(const MeshView& a, const MeshView& b)
{
  std::atomic<bool> same(true);
  ParallelFor(a.GetNumberOfCells(), 1 << 14,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end && same; ++cell)
      {
        // Polyhedra are compared by their faces: the order of their points is arbitrary.
        const bool hasFaces = a.GetPolyhedronFaces(cell).Size > 0;
        if (a.GetCellType(cell) != b.GetCellType(cell) || !HaveSameFaces(a, b, cell) ||
          !(hasFaces || AreEqual(a.GetCellPoints(cell), b.GetCellPoints(cell))))
        {
          same = false;
        }
      }
    });
  return same;
}

//------------------------------------------------------------------------------
// The same for images and other data sets that do not list their cells.
bool HaveSameImplicitCells(vtkDataSet* a, vtkDataSet* b)
{
  vtkNew<vtkIdList> pointsOfA, pointsOfB;
  bool equal = true;
  for (vtkIdType cell = 0; cell < a->GetNumberOfCells() && equal; ++cell)
  {
    a->GetCellPoints(cell, pointsOfA);
    b->GetCellPoints(cell, pointsOfB);
    equal = a->GetCellType(cell) == b->GetCellType(cell) &&
      std::equal(pointsOfA->begin(), pointsOfA->end(), pointsOfB->begin(), pointsOfB->end());
  }
  return equal;
}

//------------------------------------------------------------------------------
bool HaveSameCells(const ElementBlock& a, const ElementBlock& b)
{
  if (a.Data == b.Data)
  {
    return true;
  }
  if (a.Number != b.Number || a.GetSize() != b.GetSize() ||
    a.Data->GetNumberOfPoints() != b.Data->GetNumberOfPoints())
  {
    return false;
  }
  const MeshView meshOfA(a.Data), meshOfB(b.Data);
  const bool areListed =
    meshOfA.GetNumberOfCells() == a.GetSize() && meshOfB.GetNumberOfCells() == b.GetSize();
  return areListed ? HaveSameCells(meshOfA, meshOfB) : HaveSameImplicitCells(a.Data, b.Data);
}
}

//------------------------------------------------------------------------------
bool HaveSameCells(const ElementBlocks& a, const ElementBlocks& b, Reducer& reducer)
{
  std::int64_t same = a.Get().size() == b.Get().size();
  for (std::size_t block = 0; block < a.Get().size() && same; ++block)
  {
    same = HaveSameCells(a.Get()[block], b.Get()[block]);
  }
  reducer.Min(&same, 1);
  return same != 0;
}
}
