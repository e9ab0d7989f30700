// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TetGenNeighbors.h"

#include "vtkCellData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr std::int32_t None = -1; // at the boundary
}

//------------------------------------------------------------------------------
bool TetGenNeighbors::ReadHeader(TextScanner& scanner, Header& header)
{
  header = Header();
  std::int64_t numbers[2] = { 0, 4 };
  if (!ReadTetGenHeader(scanner, numbers, 2, ErrorKind::NotThisFormat,
        "neighbors of TetGen or Triangle, whose first line has the number of elements and of "
        "neighbors per element"))
  {
    return false;
  }
  scanner.SkipSpace();
  if (numbers[1] != 3 && numbers[1] != 4)
  {
    return scanner.FailAt(scanner.GetPosition(), ErrorKind::NotThisFormat,
      "3 or 4 neighbors per element, as the second number of the first line",
      std::to_string(numbers[1]));
  }
  header.Corners = static_cast<int>(numbers[1]);
  constexpr int BytesPerNumber = 2;
  if (!scanner.ReadCount(header.Count, BytesPerNumber * (1 + header.Corners),
        "the number of elements with neighbors"))
  {
    return false;
  }
  scanner.SkipLine();
  return true;
}

//------------------------------------------------------------------------------
bool TetGenNeighbors::Read(TextScanner& scanner, const TextLines* lines, const TetGenCells& cells,
  const CellMeshPiece& piece, const IdMap& ids, const Progress& progress)
{
  Header header;
  const char* const begin = scanner.GetPosition();
  if (!ReadHeader(scanner, header))
  {
    return false;
  }
  if (header.Corners != cells.GetNumberOfCorners() || header.Count != cells.GetCount())
  {
    const auto describe = [](std::int64_t count, int corners)
    {
      return std::to_string(corners) + " neighbors for each of " + std::to_string(count) +
        " elements";
    };
    return scanner.FailAt(begin, ErrorKind::Count,
      describe(cells.GetCount(), cells.GetNumberOfCorners()) + ", as in the file of elements",
      describe(header.Count, header.Corners));
  }
  this->Corners = header.Corners;
  this->Neighbors = Buffer<std::int32_t>(header.Corners * piece.GetNumberOfCells());
  std::fill(this->Neighbors.data(), this->Neighbors.data() + this->Neighbors.size(), None);
  const RowSequence rows(scanner, lines, header.Count, RowLayout::OneLine);
  return rows.ForEach(progress,
    [&](vtkIdType, vtkIdType, TextRow& row)
    {
      constexpr char Element[] = "the id of an element",
                     Neighbor[] = "a neighbor, the id of an element";
      std::int64_t id;
      if (!row.ReadInteger(id, Element))
      {
        return false;
      }
      const std::int32_t element = ids.Find(id);
      if (element < 0)
      {
        return row.FailAtLast(ErrorKind::Index, std::string(Element) + " of the mesh");
      }
      const vtkIdType index = piece.FindCell(element);
      for (int i = 0; i < this->Corners; ++i)
      {
        if (!row.ReadInteger(id, Neighbor))
        {
          return false;
        }
        const std::int32_t neighbor = id == None ? None : ids.Find(id);
        if (neighbor < 0 && id != None)
        {
          return row.FailAtLast(ErrorKind::Index, std::string(Neighbor) + " of the mesh, or -1");
        }
        if (index >= 0)
        {
          this->Neighbors[this->Corners * index + i] = neighbor;
        }
      }
      return true;
    });
}

//------------------------------------------------------------------------------
void TetGenNeighbors::AddArrays(vtkUnstructuredGrid* grid)
{
  AddIntegers(grid->GetCellData(), "Neighbors", std::move(this->Neighbors), this->Corners);
}
}
