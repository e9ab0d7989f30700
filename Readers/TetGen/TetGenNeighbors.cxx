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
constexpr std::int32_t None = -1;    // at the boundary
constexpr std::int32_t Unknown = -2; // the file has no row for the element
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
  const CellMeshPiece& piece, bool all, const IdMap& ids, const Progress& progress)
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
  this->HasAll = all || piece.IsWhole();
  this->Neighbors =
    Buffer<std::int32_t>(header.Corners * (this->HasAll ? header.Count : piece.GetNumberOfCells()));
  std::fill(this->Neighbors.data(), this->Neighbors.data() + this->Neighbors.size(), Unknown);
  return ReadRows(
    scanner, lines, header.Count, progress,
    [&](vtkIdType, TextRow& row)
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
      const vtkIdType index = this->HasAll ? element : piece.FindCell(element);
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
    },
    RowLayout::OneLine);
}

//------------------------------------------------------------------------------
void TetGenNeighbors::Check(
  const CellMesh& mesh, Warnings& warnings, const Progress& progress) const
{
  Tally missing, oneSided, apart;
  std::mutex mutex;
  constexpr vtkIdType Block = 4096;
  const int corners = this->Corners;
  progress.ForBlocks(mesh.NumberOfCells, Block,
    [&](vtkIdType begin, vtkIdType end)
    {
      Tally myMissing, myOneSided, myApart;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const std::int32_t* const neighbors = this->Neighbors.data() + corners * cell;
        const std::int32_t* const points = mesh.GetPoints(cell);
        bool isMutual = true, isShared = true;
        for (int i = 0; i < corners; ++i)
        {
          if (neighbors[i] < 0)
          {
            continue;
          }
          const std::int32_t* const back =
            this->Neighbors.data() + vtkIdType(corners) * neighbors[i];
          const std::int32_t* const others = mesh.GetPoints(neighbors[i]);
          isMutual = isMutual && std::find(back, back + corners, cell) != back + corners;
          for (int corner = 0; corner < corners; ++corner)
          {
            isShared = isShared &&
              (corner == i ||
                std::find(others, others + corners, points[corner]) != others + corners);
          }
        }
        if (neighbors[0] == Unknown)
        {
          myMissing.Add(cell);
        }
        if (!isMutual)
        {
          myOneSided.Add(cell);
        }
        if (!isShared)
        {
          myApart.Add(cell);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      missing.Merge(myMissing);
      oneSided.Merge(myOneSided);
      apart.Merge(myApart);
    });
  warnings.Add(missing, "element", "elements", "without neighbors in the file");
  warnings.Add(oneSided, "element", "elements", "missing among the neighbors of a neighbor");
  warnings.Add(apart, "element", "elements",
    "whose facet opposite a node is not shared with the neighbor given for that node");
}

//------------------------------------------------------------------------------
void TetGenNeighbors::AddArrays(vtkUnstructuredGrid* grid, const CellMeshPiece& piece)
{
  const int corners = this->Corners;
  const vtkIdType cells = this->Neighbors.size() / corners;
  for (vtkIdType i = 0; i < this->Neighbors.size(); ++i)
  {
    this->Neighbors[i] = std::max(this->Neighbors[i], None);
  }
  if (this->HasAll && !piece.IsWhole())
  {
    Buffer<std::int32_t> kept(corners * piece.GetNumberOfCells());
    for (vtkIdType i = 0; i < cells; ++i)
    {
      if (const vtkIdType cell = piece.FindCell(i); cell >= 0)
      {
        const std::int32_t* const from = this->Neighbors.data() + corners * i;
        std::copy(from, from + corners, kept.data() + corners * cell);
      }
    }
    this->Neighbors = std::move(kept);
  }
  AddIntegers(grid->GetCellData(), "Neighbors", std::move(this->Neighbors), corners);
}
}
