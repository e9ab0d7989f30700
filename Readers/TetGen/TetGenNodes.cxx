// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TetGenNodes.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr char Coordinate[] = "a coordinate of a node";
constexpr char Id[] = "the id of a node";
}

//------------------------------------------------------------------------------
bool TetGenNodes::ReadHeader(TextScanner& scanner, Header& header)
{
  constexpr char Expected[] =
    "nodes of TetGen or Triangle, whose first line has the number of nodes, the dimension, the "
    "number of attributes and a flag for markers";
  header = Header();
  std::int64_t numbers[4] = { 0, 3, 0, 0 };
  if (!ReadTetGenHeader(scanner, numbers, 4, ErrorKind::NotThisFormat, Expected))
  {
    return false;
  }
  scanner.SkipSpace();
  const std::int64_t dimension = numbers[1], attributes = numbers[2];
  if (dimension != 2 && dimension != 3)
  {
    return scanner.FailAt(scanner.GetPosition(), ErrorKind::NotThisFormat,
      "nodes in 2 or 3 dimensions, as the second number of the first line",
      std::to_string(dimension));
  }
  if (!CheckTetGenAttributes(scanner, attributes, "nodes"))
  {
    return false;
  }
  const int perRow = 1 + static_cast<int>(dimension + attributes);
  if (!scanner.ReadCount(header.Count, BytesPerNumber * perRow, "the number of nodes"))
  {
    return false;
  }
  scanner.SkipLine();
  header.Dimension = static_cast<int>(dimension);
  header.Columns.Attributes = static_cast<int>(attributes);
  header.Columns.Markers = numbers[3] != 0;
  return true;
}

//------------------------------------------------------------------------------
void TetGenNodes::Allocate(vtkIdType size)
{
  this->Coordinates = Buffer<double>(3 * size);
  this->Columns.Start(this->Table.Columns, this->GetCount());
  this->Columns.Allocate(size);
}

//------------------------------------------------------------------------------
bool TetGenNodes::ReadValuesOf(TextRow& row, vtkIdType number, vtkIdType index)
{
  double unused[3];
  double* const x = index < 0 ? unused : this->Coordinates.data() + 3 * index;
  x[2] = 0;
  if (!row.ReadReal(x[0], Coordinate) || !row.ReadReal(x[1], Coordinate) ||
    (this->Table.Dimension == 3 && !row.ReadReal(x[2], Coordinate)) ||
    !this->Columns.Read(row, number, index))
  {
    return false;
  }
  for (std::size_t i = 0; i < this->Answer.size() / 3; ++i)
  {
    if (this->Asked[i] == number)
    {
      std::copy(x, x + 3, this->Answer.data() + 3 * i);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool TetGenNodes::Read(
  TextScanner& scanner, const TextLines* lines, bool whole, const Progress& progress)
{
  this->IsWhole = whole;
  this->Answer.clear();
  if (!ReadHeader(scanner, this->Table))
  {
    return false;
  }
  const vtkIdType count = this->Table.Count;
  this->Ids = Buffer<std::int32_t>(count);
  this->Allocate(whole ? count : 0);
  const char* const begin = scanner.GetPosition();
  const RowSequence rows(scanner, lines, count, RowLayout::OneLine);
  if (!rows.ForEach(progress,
        [&](vtkIdType i, vtkIdType, TextRow& row)
        {
          return row.ReadId(this->Ids[i], 0, INT32_MAX, Id) &&
            (!whole || this->ReadValuesOf(row, i, i));
        }))
  {
    return false;
  }
  this->Map.Build(this->Ids.data(), count);
  return this->Map.GetNumberOfRepeated() == 0 || this->FailAtRepeated(scanner, begin);
}

//------------------------------------------------------------------------------
bool TetGenNodes::ForEach(TextScanner& scanner, const TextLines* lines,
  const PieceOfSpace::Visit& visit, const Progress& progress) const
{
  Header header;
  return ReadHeader(scanner, header) &&
    RowSequence(scanner, lines, this->GetCount(), RowLayout::OneLine)
      .ForEach(progress,
        [&](vtkIdType i, vtkIdType, TextRow& row)
        {
          std::int32_t id;
          double x[3] = { 0, 0, 0 };
          bool isGood = row.ReadId(id, 0, INT32_MAX, Id);
          for (int c = 0; isGood && c < this->Table.Dimension; ++c)
          {
            isGood = row.ReadReal(x[c], Coordinate);
          }
          if (isGood)
          {
            visit(i, x);
          }
          return isGood;
        });
}

//------------------------------------------------------------------------------
bool TetGenNodes::ReadValues(TextScanner& scanner, const TextLines* lines,
  const CellMeshPiece& piece, const Progress& progress)
{
  Header header;
  if (!ReadHeader(scanner, header))
  {
    return false;
  }
  this->Allocate(piece.GetNumberOfPoints());
  this->Answer.assign(3 * this->Asked.size(), 0);
  return RowSequence(scanner, lines, this->GetCount(), RowLayout::OneLine)
    .ForEach(progress,
      [&](vtkIdType i, vtkIdType, TextRow& row)
      {
        std::int32_t id;
        return row.ReadId(id, 0, INT32_MAX, Id) && this->ReadValuesOf(row, i, piece.FindPoint(i));
      });
}

//------------------------------------------------------------------------------
bool TetGenNodes::FailAtId(TextRow& row, const char* what) const
{
  std::string expected = std::string(what) + ", the id of a node";
  if (this->GetCount() == 0)
  {
    expected += " (there are none)";
  }
  else
  {
    const bool allThere = this->Map.GetGreatest() - this->Map.GetLeast() + 1 == this->GetCount();
    expected += " from " + std::to_string(this->Map.GetLeast()) + " to " +
      std::to_string(this->Map.GetGreatest()) + (allThere ? "" : " that exists");
  }
  return row.FailAtLast(ErrorKind::Index, expected);
}

//------------------------------------------------------------------------------
// Reports the line on which an id repeats. If the file was read in parallel it is read once more.
bool TetGenNodes::FailAtRepeated(TextScanner& scanner, const char* rows) const
{
  vtkIdType first = 0;
  while (this->Map.Find(this->Ids[first]) == first)
  {
    ++first;
  }
  vtkIdType again = first + 1;
  while (this->Ids[again] != this->Ids[first])
  {
    ++again;
  }
  scanner.SetPosition(rows);
  for (vtkIdType i = 0; i < again; ++i)
  {
    scanner.SkipSpace();
    scanner.SkipLine();
  }
  scanner.SkipSpace();
  return scanner.FailAt(
    scanner.GetPosition(), ErrorKind::Syntax, "a node id that has not been used before");
}

//------------------------------------------------------------------------------
void TetGenNodes::GetAnswer(double (*x)[3]) const
{
  for (std::size_t i = 0; i < this->Asked.size(); ++i)
  {
    const double* const from = this->IsWhole
      ? this->Coordinates.data() + 3 * vtkIdType(this->Asked[i])
      : this->Answer.data() + 3 * i;
    std::copy(from, from + 3, x[i]);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> TetGenNodes::TakePoints()
{
  return this->Coordinates.TakeArray<vtkDoubleArray>(3);
}

//------------------------------------------------------------------------------
void TetGenNodes::AddArrays(vtkUnstructuredGrid* grid, const CellMeshPiece& piece)
{
  this->Columns.AddTo(grid->GetPointData());
  vtkIdType same = 0;
  while (same < this->Ids.size() && this->Ids[same] == same)
  {
    ++same;
  }
  if (same == this->Ids.size())
  {
    return;
  }
  if (!piece.IsWhole())
  {
    Buffer<std::int32_t> kept(piece.GetNumberOfPoints());
    for (vtkIdType i = 0; i < this->Ids.size(); ++i)
    {
      if (const vtkIdType point = piece.FindPoint(i); point >= 0)
      {
        kept[point] = this->Ids[i];
      }
    }
    this->Ids = std::move(kept);
  }
  AddIntegers(grid->GetPointData(), "OriginalPointId", std::move(this->Ids));
}
}
