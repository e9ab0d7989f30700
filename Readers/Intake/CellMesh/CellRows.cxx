// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/CellRows.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <limits>

namespace camaron
{
//------------------------------------------------------------------------------
bool FillCells(std::vector<CellSink>& sinks, CellMesh& mesh, ScanError& error)
{
  std::vector<vtkIdType> firstCells{ 0 }, firstPoints{ 0 };
  for (const CellSink& sink : sinks)
  {
    firstCells.push_back(firstCells.back() + static_cast<vtkIdType>(sink.Types.size()));
    firstPoints.push_back(firstPoints.back() + static_cast<vtkIdType>(sink.Points.size()));
  }
  if (firstPoints.back() > std::numeric_limits<std::int32_t>::max())
  {
    error = { ErrorKind::Unsupported, "fewer than 2147483648 points of all cells together" };
    return false;
  }
  const vtkIdType numberOfCells = firstCells.back();
  mesh.NumberOfCells = numberOfCells;
  mesh.CommonSize = 0;
  mesh.Types = Buffer<unsigned char>(numberOfCells);
  mesh.Offsets = Buffer<std::int32_t>(numberOfCells + 1);
  mesh.Connectivity = Buffer<std::int32_t>(firstPoints.back());
  mesh.Offsets[numberOfCells] = static_cast<std::int32_t>(firstPoints.back());
  ParallelFor(static_cast<vtkIdType>(sinks.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType s = begin; s < end; ++s)
      {
        CellSink& sink = sinks[s];
        std::copy(sink.Types.begin(), sink.Types.end(), mesh.Types.data() + firstCells[s]);
        std::copy(
          sink.Points.begin(), sink.Points.end(), mesh.Connectivity.data() + firstPoints[s]);
        vtkIdType offset = firstPoints[s];
        std::int32_t* offsets = mesh.Offsets.data() + firstCells[s];
        for (const std::int32_t size : sink.Sizes)
        {
          *offsets++ = static_cast<std::int32_t>(offset);
          offset += size;
        }
        sink = CellSink(); // its memory is needed elsewhere
      }
    });
  return true;
}
}
