// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Binary files of Cart3D.
#include "Base/Parallel.h"
#include "Intake/Rows/BinaryScanner.h"
#include "TRIMesh.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
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
// The data between the two lengths of a record.
struct Record
{
  const char* Begin = nullptr;
  std::int64_t Size = 0;
};

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
  bool ReadRecord(Record& record, const char* what, std::initializer_list<std::int64_t> sizes);
  bool ReadCounts();
  bool FindRecords();
  template <typename Value, typename Take>
  bool ForEachRow(const Record& record, vtkIdType rows, std::int64_t size, const Progress& progress,
    Take&& take) const;
  bool VisitPoints(const PieceOfSpace::Visit& visit) const;
  bool ReadCells(const Progress& progress);
  template <typename Visit>
  bool VisitTriangles(const Progress& progress, Visit&& visit);
  template <typename Array, typename Find>
  vtkSmartPointer<Array> ReadArray(const Record& record, vtkIdType rows, std::int64_t size,
    vtkIdType kept, const Progress& progress, Find&& find) const;
  vtkSmartPointer<vtkDataArray> ReadReals(
    const Record& record, std::int64_t size, const Progress& progress) const;

  PieceRequest Request;
  std::int32_t Vertices = 0;
  std::int32_t Triangles = 0;
  std::int32_t Scalars = 0;
  std::int64_t ScalarSize = 0; // numbers per vertex
  std::int64_t RealBytes = 4;
  Record Coordinates, Corners, Components, Values;
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
bool BinaryReading::FindRecords()
{
  const std::int64_t vertices = this->Vertices, triangles = this->Triangles;
  constexpr std::int64_t FloatBytes = sizeof(float), DoubleBytes = sizeof(double);
  if (!this->ReadRecord(this->Coordinates, "the coordinates of the vertices",
        { 3 * FloatBytes * vertices, 3 * DoubleBytes * vertices }) ||
    !this->ReadRecord(this->Corners, "the vertices of the triangles", { 3 * Word * triangles }))
  {
    return false;
  }
  this->RealBytes = this->Coordinates.Size > 3 * FloatBytes * vertices ? DoubleBytes : FloatBytes;
  if (this->Scalars == 0 && this->Scanner.GetBytesLeft() == 0)
  {
    return true;
  }
  const std::int64_t column = this->RealBytes * vertices; // of a scalar
  if (!this->ReadRecord(
        this->Components, "the components of the triangles", { Word * triangles }) ||
    (this->Scalars > 0 &&
      !this->ReadRecord(this->Values, "the scalars of the vertices",
        { column * this->Scalars, column * (this->Scalars + std::int64_t(1)) })))
  {
    return false;
  }
  this->ScalarSize = vertices > 0 ? this->Values.Size / column : 0;
  return true;
}

//------------------------------------------------------------------------------
// Calls take(row, values) for rows of a record, in any order and from any thread; false if aborted.
template <typename Value, typename Take>
bool BinaryReading::ForEachRow(const Record& record, vtkIdType rows, std::int64_t size,
  const Progress& progress, Take&& take) const
{
  const bool swap = this->Scanner.IsSwapped();
  constexpr auto Bytes = static_cast<std::int64_t>(sizeof(Value));
  return progress.For(rows,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Value> values(static_cast<std::size_t>(size));
      for (vtkIdType row = begin; row < end; ++row)
      {
        for (std::int64_t i = 0; i < size; ++i)
        {
          values[i] = Load<Value>(record.Begin + (row * size + i) * Bytes, swap);
        }
        take(row, values.data());
      }
    });
}

//------------------------------------------------------------------------------
// Calls visit(triangle, points), in any order and from any thread; false with the error, or if
// aborted.
template <typename Visit>
bool BinaryReading::VisitTriangles(const Progress& progress, Visit&& visit)
{
  std::atomic<vtkIdType> wrong{ VTK_ID_MAX }; // corner
  const bool isDone = this->ForEachRow<std::int32_t>(this->Corners, this->Triangles, 3, progress,
    [&](vtkIdType triangle, std::int32_t* points)
    {
      for (int i = 0; i < 3; ++i)
      {
        if (points[i] < 1 || points[i] > this->Vertices)
        {
          LowerTo(wrong, 3 * triangle + i);
          return;
        }
        --points[i];
      }
      visit(triangle, points);
    });
  if (isDone && wrong < VTK_ID_MAX)
  {
    const char* const place = this->Corners.Begin + Word * wrong;
    return this->Scanner.FailAt(place, ErrorKind::Index,
      "a vertex of a triangle from 1 to " + std::to_string(this->Vertices),
      std::to_string(Load<std::int32_t>(place, this->Scanner.IsSwapped())));
  }
  return isDone;
}

//------------------------------------------------------------------------------
bool BinaryReading::VisitPoints(const PieceOfSpace::Visit& visit) const
{
  const auto pass = [&visit](vtkIdType vertex, const auto* from)
  {
    const double x[3] = { from[0], from[1], from[2] };
    visit(vertex, x);
  };
  return this->RealBytes == 8
    ? this->ForEachRow<double>(this->Coordinates, this->Vertices, 3, Progress(), pass)
    : this->ForEachRow<float>(this->Coordinates, this->Vertices, 3, Progress(), pass);
}

//------------------------------------------------------------------------------
bool BinaryReading::ReadCells(const Progress& progress)
{
  CellMeshPiece& piece = this->Mesh.Piece;
  CellMesh& cells = this->Mesh.Cells;
  piece.SetPoints([this](const PieceOfSpace::Visit& visit) { return this->VisitPoints(visit); });
  if (this->Triangles == 0)
  {
    return MakeCloud(this->Vertices, this->Request, piece, cells);
  }
  if (!piece.Find(this->Vertices, this->Triangles, this->Request,
        [&]
        {
          return this->VisitTriangles(progress.Part(0, 0.5),
            [&](vtkIdType triangle, const std::int32_t* points)
            { piece.Visit(triangle, points, 3); });
        }))
  {
    return false;
  }
  cells = CellMesh(piece.GetNumberOfPoints(), piece.GetNumberOfCells(), VTK_TRIANGLE, 3);
  return this->VisitTriangles(progress.Part(0.5, 1),
    [&](vtkIdType triangle, const std::int32_t* points)
    {
      const vtkIdType cell = piece.FindCell(triangle);
      for (int i = 0; i < 3 && cell >= 0; ++i)
      {
        cells.Connectivity[3 * cell + i] = static_cast<std::int32_t>(piece.FindPoint(points[i]));
      }
    });
}

//------------------------------------------------------------------------------
// The rows of a record that the piece keeps, each stored at find(row).
template <typename Array, typename Find>
vtkSmartPointer<Array> BinaryReading::ReadArray(const Record& record, vtkIdType rows,
  std::int64_t size, vtkIdType kept, const Progress& progress, Find&& find) const
{
  using Value = typename Array::ValueType;
  Buffer<Value> values(kept * size);
  this->ForEachRow<Value>(record, rows, size, progress,
    [&](vtkIdType row, const Value* from)
    {
      if (const vtkIdType place = find(row); place >= 0)
      {
        std::copy(from, from + size, values.data() + place * size);
      }
    });
  return values.template TakeArray<Array>(static_cast<int>(size));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> BinaryReading::ReadReals(
  const Record& record, std::int64_t size, const Progress& progress) const
{
  const CellMeshPiece& piece = this->Mesh.Piece;
  const auto find = [&](vtkIdType vertex) { return piece.FindPoint(vertex); };
  if (this->RealBytes == 8)
  {
    return this->ReadArray<vtkDoubleArray>(
      record, this->Vertices, size, piece.GetNumberOfPoints(), progress, find);
  }
  return this->ReadArray<vtkFloatArray>(
    record, this->Vertices, size, piece.GetNumberOfPoints(), progress, find);
}

//------------------------------------------------------------------------------
bool BinaryReading::Read(vtkUnstructuredGrid* grid, Warnings& warnings, const Progress& progress)
{
  if (!this->ReadCounts() || !this->FindRecords() || !this->ReadCells(progress.Part(0, 0.5)))
  {
    return false;
  }
  this->Mesh.Points = this->ReadReals(this->Coordinates, 3, progress.Part(0.5, 0.7));
  if (this->Triangles > 0 && this->Components.Begin)
  {
    this->Mesh.Components = this->ReadArray<vtkIntArray>(this->Components, this->Triangles, 1,
      this->Mesh.Piece.GetNumberOfCells(), progress.Part(0.7, 0.8),
      [&](vtkIdType triangle) { return this->Mesh.Piece.FindCell(triangle); });
  }
  if (this->ScalarSize > 0)
  {
    this->Mesh.Scalars = this->ReadReals(this->Values, this->ScalarSize, progress.Part(0.8, 0.9));
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
