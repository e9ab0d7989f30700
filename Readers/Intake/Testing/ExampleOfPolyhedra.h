// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ExampleOfPolyhedra.h
 * @brief The reader of a made-up format of polyhedra in text and binary, as an example for formats.
 *
 *     poly 1 text            or: poly 1 little, poly 1 big
 *     POINTS 8               then rows x y z; in binary, doubles and a line end after all rows
 *     FACES 6                then rows n point1 ... pointn, from 1; in binary, 32-bit integers
 *     CELLS 1                then rows n face1 ... facen material; faces from 1, negative if the
 *                            normal of the face points into the cell
 */
#ifndef camaron_ExampleOfPolyhedra_h
#define camaron_ExampleOfPolyhedra_h

#include "Intake/FaceMesh/FaceTables.h"
#include "Intake/FaceMesh/GridBuilder.h"
#include "Intake/Pieces/ReadMappedFile.h"

#include "vtkUnstructuredGrid.h"

namespace camaron
{
class ExampleOfPolyhedra
{
public:
  PieceRequest Request;
  Warnings Messages;

  /// @param binary the same file if its rows are binary, else nullptr
  bool Read(
    TextScanner& text, BinaryScanner* binary, const TextLines* lines, const Progress& progress)
  {
    constexpr ValueType real = ValueType::Double, integer = ValueType::Int32;
    std::unique_ptr<TableRows> points, faces, cells;
    text.SkipLine(); // poly 1 ...
    const auto open = [&](const char* keyword, double end, std::unique_ptr<TableRows>& rows,
                        const char* name, std::vector<TableProperty> properties)
    {
      std::string_view word;
      std::int64_t count = 0;
      if (!text.ReadWord(word, keyword) ||
        (word != keyword && !text.FailAt(word.data(), ErrorKind::Syntax, keyword)) ||
        !text.ReadCount(count, 4, "a number of rows") || !EndLine(text))
      {
        return false;
      }
      const Table table{ name, count, std::move(properties) };
      if (!binary)
      {
        rows = MakeTextRows(table, text, lines, RowLayout::OneLine);
        return rows->Locate(progress.Part(end - 0.1, end));
      }
      binary->SetPosition(text.GetPosition());
      rows = MakeBinaryRows(table, *binary);
      const bool good = rows->Locate(progress.Part(end - 0.1, end));
      text.SetPosition(binary->GetPosition());
      return good;
    };
    if (!open("POINTS", 0.1, points, "point", { { "x", real }, { "y", real }, { "z", real } }) ||
      !open("FACES", 0.2, faces, "face", { { "points", integer, true, integer } }) ||
      !open("CELLS", 0.3, cells, "cell",
        { { "faces", integer, true, integer }, { "material", integer } }) ||
      (text.SkipSpace() &&
        !text.FailAt(text.GetPosition(), ErrorKind::Syntax, "the end of the file")))
    {
      return false;
    }
    const ListIds ofFaces = ListIds::FromOne("a point of a face", points->GetCount());
    const ListIds ofCells = ListIds::WithSigns("a face of a cell", faces->GetCount());
    this->Materials = Buffer<std::int32_t>(cells->GetCount());
    return ReadPoints(*points, real, { 0, 1, 2 }, this->Mesh, progress.Part(0.3, 0.5)) &&
      ReadFaces(
        *faces, 0, ofFaces, this->Request, this->Mesh, this->Messages, progress.Part(0.5, 0.7)) &&
      ReadFacesOfCells(
        *cells, 0, ofCells, this->Request, this->Mesh, this->Messages, progress.Part(0.7, 0.9)) &&
      cells->ReadColumns({ { 1, -1, ValueConversion::Value, integer, this->Materials.data(), 1 } },
        {}, progress.Part(0.9, 1)) &&
      points->RefuseLongRows() && faces->RefuseLongRows() && cells->RefuseLongRows();
  }

  bool Build(vtkUnstructuredGrid* grid, ScanError& error, const Progress& progress)
  {
    if (!BuildGrid(this->Mesh, this->Request, grid, this->Messages, error, progress))
    {
      return false;
    }
    AddCellValues("Material", this->Materials, grid);
    return true;
  }

private:
  FaceMesh Mesh;
  Buffer<std::int32_t> Materials;
};

//------------------------------------------------------------------------------
/// Reads the first line. @param order of binary rows; none for text
inline bool ReadFirstLine(const MappedFile& file, std::optional<ByteOrder>& order)
{
  const std::string_view line(file.begin(), FindLineEnd(file.begin(), file.end()) - file.begin());
  const bool isBig = line == "poly 1 big";
  if (isBig || line == "poly 1 little")
  {
    order = isBig ? ByteOrder::Big : ByteOrder::Little;
  }
  return order || line == "poly 1 text";
}

//------------------------------------------------------------------------------
inline bool IsExampleOfPolyhedra(const std::string& path)
{
  const MappedFile file(path);
  std::optional<ByteOrder> order;
  return ReadFirstLine(file, order);
}

//------------------------------------------------------------------------------
inline bool ReadExampleOfPolyhedra(const std::string& path, const PieceRequest& request,
  vtkUnstructuredGrid* grid, Warnings& warnings, ScanError& error, const Progress& progress,
  vtkIdType chunk)
{
  return ReadMappedFile(path, request, grid, warnings, error, progress,
    [&](const MappedFile& file, const Progress& rest)
    {
      std::optional<ByteOrder> order;
      if (!ReadFirstLine(file, order))
      {
        TextScanner text(file.GetName(), file.begin(), file.end());
        text.FailAt(file.begin(), ErrorKind::NotThisFormat, "\"poly 1 text\", little or big");
        error = text.GetError();
        return false;
      }
      ExampleOfPolyhedra mesh;
      bool good = ReadTextOrBinary(file, order, '#', chunk, error, rest.Part(0, 0.6),
        [&](TextScanner& text, BinaryScanner* binary, const TextLines* lines, const Progress& part)
        {
          mesh = ExampleOfPolyhedra(); // at the second attempt
          mesh.Request = request;
          return mesh.Read(text, binary, lines, part);
        });
      if (good && !mesh.Build(grid, error, rest.Part(0.6, 1)))
      {
        error.Message = file.GetName() + ": " + error.Message;
        good = false;
      }
      warnings = mesh.Messages;
      return good;
    });
}
}

#endif
