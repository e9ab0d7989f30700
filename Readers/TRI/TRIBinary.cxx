// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Binary files of Cart3D.
#include "Intake/CellMesh/CellLists.h"
#include "TRIMesh.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <initializer_list>
#include <optional>

namespace camaron
{
namespace
{
constexpr std::int64_t Word = 4; // bytes of an integer, and of the length of a record

//------------------------------------------------------------------------------
// The byte order in which the first record consists of two or three valid counts.
std::optional<ByteOrder> FindByteOrder(const MappedFile& file)
{
  for (const ByteOrder order : { ByteOrder::Little, ByteOrder::Big })
  {
    const bool swap = order != GetByteOrder();
    for (const std::int32_t length : { 8, 12 })
    {
      if (static_cast<std::int64_t>(file.size()) >= length + 2 * Word &&
        Load<std::int32_t>(file.begin(), swap) == length &&
        Load<std::int32_t>(file.begin() + Word + length, swap) == length)
      {
        return order;
      }
    }
  }
  return std::nullopt;
}

//------------------------------------------------------------------------------
class BinaryReading
{
public:
  BinaryReading(const MappedFile& file, ByteOrder order, const PieceRequest& request)
    : Scanner(file.GetName(), file.begin(), file.end(), order)
    , Request(request)
  {
  }

  bool Read(vtkUnstructuredGrid* grid, Warnings& warnings, const Progress& progress);

  BinaryScanner Scanner;

private:
  /// A record: the data between its two lengths, as a table of rows of one property.
  struct Record
  {
    const char* Begin = nullptr;
    std::int64_t Size = 0;
    std::unique_ptr<TableRows> Rows;
  };

  bool ReadRecord(Record& record, const char* what, std::initializer_list<std::int64_t> sizes);
  bool ReadCounts();
  bool FindRecords();
  bool MakeRows(Record& record, vtkIdType rows, ValueType type, std::int64_t size);
  bool ReadCells(const Progress& progress);
  vtkSmartPointer<vtkDataArray> ReadArray(
    const Record& record, vtkIdType tuples, const IdSet& kept, const Progress& progress) const;

  PieceRequest Request;
  std::int32_t Vertices = 0;
  std::int32_t Triangles = 0;
  std::int32_t Scalars = 0;
  Record Coordinates, Components, Values;
  CellLists::Part Corners;
  TRIMesh Mesh;
};

//------------------------------------------------------------------------------
// Reads a record, which must have one of the sizes if there are any.
bool BinaryReading::ReadRecord(
  Record& record, const char* what, std::initializer_list<std::int64_t> sizes)
{
  std::int32_t length = 0, last = 0;
  const char* const place = this->Scanner.GetPosition();
  if (!this->Scanner.ReadInteger(length, what))
  {
    return false;
  }
  if (length < 0)
  {
    return this->Scanner.FailAt(place, ErrorKind::Unsupported,
      std::string("a record of at most 2147483647 bytes with ") + what,
      "the length " + std::to_string(length));
  }
  record.Size = length;
  record.Begin = this->Scanner.Skip(length, what);
  const char* const end = this->Scanner.GetPosition();
  if (!record.Begin || !this->Scanner.ReadInteger(last, "the length of a record at its end"))
  {
    return false;
  }
  if (last != length)
  {
    return this->Scanner.FailAt(end, ErrorKind::Syntax,
      "the length " + std::to_string(length) + " again at the end of the record with " + what,
      std::to_string(last));
  }
  return sizes.size() == 0 || std::find(sizes.begin(), sizes.end(), record.Size) != sizes.end() ||
    this->Scanner.FailAt(place,
      record.Size < *sizes.begin() ? ErrorKind::Truncated : ErrorKind::Count,
      "a record of " + std::to_string(*sizes.begin()) + " bytes with " + what,
      std::to_string(record.Size));
}

//------------------------------------------------------------------------------
bool BinaryReading::ReadCounts()
{
  Record record;
  if (!this->ReadRecord(record, "the numbers of vertices and triangles", {}))
  {
    return false;
  }
  std::int32_t counts[3] = { 0, 0, 0 };
  for (std::int64_t i = 0; i < std::min<std::int64_t>(record.Size / Word, 3); ++i)
  {
    const char* const place = record.Begin + Word * i;
    counts[i] = Load<std::int32_t>(place, this->Scanner.IsSwapped());
    if (counts[i] < 0)
    {
      return this->Scanner.FailAt(place, ErrorKind::Count,
        "the numbers of vertices, triangles and scalars", std::to_string(counts[i]));
    }
  }
  this->Vertices = counts[0];
  this->Triangles = counts[1];
  this->Scalars = counts[2];
  return true;
}

//------------------------------------------------------------------------------
// Makes the data of a record rows of so many values.
bool BinaryReading::MakeRows(Record& record, vtkIdType rows, ValueType type, std::int64_t size)
{
  Table table;
  table.Count = rows;
  table.Properties.push_back({ "", type });
  table.Properties[0].Length = static_cast<int>(size);
  const char* const end = this->Scanner.GetPosition();
  this->Scanner.SetPosition(record.Begin);
  record.Rows = MakeBinaryRows(table, this->Scanner);
  const bool good = record.Rows->Locate(Progress());
  this->Scanner.SetPosition(end);
  return good;
}

//------------------------------------------------------------------------------
bool BinaryReading::FindRecords()
{
  const std::int64_t vertices = this->Vertices, triangles = this->Triangles;
  constexpr std::int64_t FloatBytes = sizeof(float), DoubleBytes = sizeof(double);
  Record corners;
  if (!this->ReadRecord(this->Coordinates, "the coordinates of the vertices",
        { 3 * FloatBytes * vertices, 3 * DoubleBytes * vertices }) ||
    !this->ReadRecord(corners, "the vertices of the triangles", { 3 * Word * triangles }))
  {
    return false;
  }
  const bool isDouble = this->Coordinates.Size > 3 * FloatBytes * vertices;
  const ValueType real = isDouble ? ValueType::Double : ValueType::Float;
  const std::int64_t column = (isDouble ? DoubleBytes : FloatBytes) * vertices; // of a scalar
  const bool hasMore = this->Scalars > 0 || this->Scanner.GetBytesLeft() > 0;
  if (hasMore &&
    (!this->ReadRecord(this->Components, "the components of the triangles", { Word * triangles }) ||
      (this->Scalars > 0 &&
        !this->ReadRecord(this->Values, "the scalars of the vertices",
          { column * this->Scalars, column * (this->Scalars + std::int64_t(1)) }))))
  {
    return false;
  }
  const std::int64_t scalars = vertices > 0 ? this->Values.Size / column : 0;
  const bool good = this->MakeRows(this->Coordinates, vertices, real, 3) &&
    this->MakeRows(corners, triangles, ValueType::Int32, 3) &&
    (!hasMore || triangles == 0 ||
      this->MakeRows(this->Components, triangles, ValueType::Int32, 1)) &&
    (scalars == 0 || this->MakeRows(this->Values, vertices, real, scalars));
  this->Corners.Rows = std::move(corners.Rows);
  return good;
}

//------------------------------------------------------------------------------
bool BinaryReading::ReadCells(const Progress& progress)
{
  CellMeshPiece& piece = this->Mesh.Piece;
  piece.SetPoints([this](const PieceOfSpace::Visit& visit)
    { return this->Coordinates.Rows->ForEachPoint({ 0, 0, 0 }, visit); });
  if (this->Triangles == 0)
  {
    return MakeCloud(this->Vertices, this->Request, piece, this->Mesh.Cells);
  }
  this->Corners.List = 0;
  this->Corners.Expected = ListIds::FromOne("a vertex of a triangle", this->Vertices);
  CellLists cells;
  const bool good =
    cells.Read({ &this->Corners }, this->Vertices, false, this->Request, piece, progress);
  this->Mesh.Cells = std::move(cells.Mesh);
  return good;
}

//------------------------------------------------------------------------------
// The rows of a record that the piece keeps.
vtkSmartPointer<vtkDataArray> BinaryReading::ReadArray(
  const Record& record, vtkIdType tuples, const IdSet& kept, const Progress& progress) const
{
  const TableProperty& property = record.Rows->GetTable().Properties[0];
  const int size = property.Length;
  auto array = MakeArray(property.Type, size, tuples);
  TableTargets targets;
  targets.Kept = this->Mesh.Piece.IsWhole() ? nullptr : &kept;
  std::vector<TableColumn> columns;
  columns.reserve(static_cast<std::size_t>(size));
  for (int i = 0; tuples > 0 && i < size; ++i)
  {
    columns.push_back({ 0, i, ValueConversion::Value, property.Type,
      static_cast<char*>(array->GetVoidPointer(0)) + i * GetSize(property.Type), size });
  }
  record.Rows->ReadColumns(columns, targets, progress);
  return array;
}

//------------------------------------------------------------------------------
bool BinaryReading::Read(vtkUnstructuredGrid* grid, Warnings& warnings, const Progress& progress)
{
  if (!this->ReadCounts() || !this->FindRecords() || !this->ReadCells(progress.Part(0, 0.5)))
  {
    return false;
  }
  const CellMeshPiece& piece = this->Mesh.Piece;
  this->Mesh.Points = this->ReadArray(
    this->Coordinates, piece.GetNumberOfPoints(), piece.GetPoints(), progress.Part(0.5, 0.7));
  if (this->Components.Rows)
  {
    this->Mesh.Components = this->ReadArray(
      this->Components, piece.GetNumberOfCells(), piece.GetCells(), progress.Part(0.7, 0.8));
  }
  if (this->Values.Rows)
  {
    this->Mesh.Scalars = this->ReadArray(
      this->Values, piece.GetNumberOfPoints(), piece.GetPoints(), progress.Part(0.8, 0.9));
  }
  if (progress.IsStopped())
  {
    return false;
  }
  this->Mesh.Finish(
    this->Request, this->Scanner.GetBytesLeft() > 0, grid, warnings, progress.Part(0.9, 1));
  return !progress.IsStopped();
}
}

//------------------------------------------------------------------------------
bool IsBinaryTRI(const MappedFile& file)
{
  return FindByteOrder(file).has_value();
}

//------------------------------------------------------------------------------
bool ReadBinaryTRI(const MappedFile& file, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress)
{
  BinaryReading reading(file, FindByteOrder(file).value_or(ByteOrder::Little), request);
  const bool good = reading.Read(grid, warnings, progress);
  error = progress.IsStopped() ? ScanError() : reading.Scanner.GetError();
  return good;
}
}
