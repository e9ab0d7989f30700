// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonOFFWriting.h"

#include "Base/Bytes.h"
#include "CellMesh/OutputMesh.h"
#include "CellMesh/OutputWarnings.h"
#include "PolygonOFFColumns.h"
#include "Scan/MappedFile.h"
#include "Write/RealFormat.h"
#include "Write/WriteRows.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"

#include <limits>

namespace camaron
{
namespace
{
constexpr int Full = 255; // of a color

//------------------------------------------------------------------------------
// Writes numbers in either encoding; a row of text ends where the next one begins.
class TextSink
{
public:
  TextSink(std::string& bytes, int digits)
    : Bytes(bytes)
    , Digits(digits)
  {
  }
  ~TextSink() { this->Bytes.back() = '\n'; }
  void AddReal(double value, bool isFloat)
  {
    (this->Digits > 0 ? RealFormat::Significant(this->Digits) : RealFormat::Shortest(isFloat))
      .Append(this->Bytes, value);
    this->Bytes += ' ';
  }
  void AddInteger(vtkIdType value)
  {
    AppendNumber(this->Bytes, value);
    this->Bytes += ' ';
  }
  void AddByte(int value) { this->AddInteger(value); }
  void AddColorSize(int) {} // follows from the end of the line

private:
  std::string& Bytes;
  int Digits;
};

class BinarySink
{
public:
  BinarySink(std::string& bytes, int)
    : Bytes(bytes)
    , Swap(GetByteOrder() != ByteOrder::Big)
  {
  }
  void AddReal(double value, bool)
  {
    AppendBytes(this->Bytes, static_cast<float>(value), this->Swap);
  }
  void AddInteger(vtkIdType value)
  {
    AppendBytes(this->Bytes, static_cast<std::int32_t>(value), this->Swap);
  }
  void AddByte(int value) { this->AddReal(value / static_cast<double>(Full), true); }
  void AddColorSize(int size) { this->AddInteger(size); }

private:
  std::string& Bytes;
  bool Swap;
};

//------------------------------------------------------------------------------
class Writing
{
public:
  Writing(const OutputMesh& mesh, const OFFColumns& columns, int digits)
    : Mesh(mesh)
    , Columns(columns)
    , Digits(digits)
  {
  }

  template <typename Sink>
  bool WriteRowsOf(OutputFile& file, vtkIdType faces, const Progress& progress) const
  {
    return WriteRows(file, this->Mesh.GetNumberOfPoints(), progress.Part(0, 0.5),
             [&](vtkIdType point, std::string& bytes)
             {
               Sink sink(bytes, this->Digits);
               this->AddVertex(sink, point);
             }) &&
      WriteRows(file, faces, progress.Part(0.5, 1),
        [&](vtkIdType cell, std::string& bytes)
        {
          Sink sink(bytes, this->Digits);
          this->AddFace(sink, cell);
        });
  }

private:
  template <typename Sink>
  void AddVertex(Sink& sink, vtkIdType point) const
  {
    double x[3];
    this->Mesh.GetPoint(point, x);
    for (const double coordinate : x)
    {
      sink.AddReal(coordinate, this->Mesh.HasFloatPoints());
    }
    const vtkIdType tuple = this->Mesh.GetInputPoint(point);
    if (this->Columns.Normals)
    {
      AddReals(sink, this->Columns.Normals, tuple, 3);
    }
    if (this->Columns.VertexColors)
    {
      this->AddColor(sink, this->Columns.VertexColors, tuple);
    }
    if (this->Columns.Texture)
    {
      AddReals(sink, this->Columns.Texture, tuple, 2);
    }
  }

  template <typename Sink>
  static void AddReals(Sink& sink, vtkDataArray* array, vtkIdType tuple, int count)
  {
    const bool isFloat = array->GetDataType() == VTK_FLOAT;
    const int components = array->GetNumberOfComponents();
    for (int c = 0; c < count; ++c)
    {
      sink.AddReal(c < components ? array->GetComponent(tuple, c) : 0, isFloat);
    }
  }

  template <typename Sink>
  void AddFace(Sink& sink, vtkIdType cell) const
  {
    const IndexRange points = this->Mesh.GetCellPoints(cell);
    sink.AddInteger(points.Size);
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      sink.AddInteger(points[i]);
    }
    const vtkIdType tuple = this->Mesh.GetInputCell(cell);
    const double index =
      this->Columns.FaceIndices ? this->Columns.FaceIndices->GetComponent(tuple, 0) : -1;
    if (this->Columns.FaceColors)
    {
      sink.AddColorSize(4);
      this->AddColor(sink, this->Columns.FaceColors, tuple);
    }
    else if (index >= 0 && index <= std::numeric_limits<std::int32_t>::max())
    {
      sink.AddColorSize(1);
      sink.AddInteger(static_cast<vtkIdType>(index));
    }
    else
    {
      sink.AddColorSize(0);
    }
  }

  template <typename Sink>
  void AddColor(Sink& sink, vtkDataArray* colors, vtkIdType tuple) const
  {
    int bytes[4];
    GetOFFColor(colors, tuple, bytes);
    for (const int byte : bytes)
    {
      sink.AddByte(byte);
    }
  }

  const OutputMesh& Mesh;
  const OFFColumns& Columns;
  int Digits; ///< of real numbers in text
};

//------------------------------------------------------------------------------
void WarnOfShortFaces(const OutputMesh& mesh, Warnings& warnings)
{
  const vtkIdType lines = mesh.Count(VTK_LINE), vertices = mesh.Count(VTK_VERTEX);
  if (lines + vertices > 0)
  {
    warnings.Add("lines written as faces with two vertices: " + std::to_string(lines) +
      ", vertices as faces with one: " + std::to_string(vertices) +
      "; some programs cannot read these");
  }
}
}

//------------------------------------------------------------------------------
bool WritePolygonOFF(const std::string& path, vtkDataSet* mesh, const OFFOptions& options,
  Warnings& warnings, ScanError& error, const Progress& progress)
{
  OFFColumns columns;
  const CellConversion how{ "OFF", { VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON, VTK_LINE, VTK_VERTEX },
    options.Others, options.Surface };
  OutputMesh output;
  if (!columns.Find(mesh, options, path, warnings, error) ||
    !ConvertCells(mesh, how, path, output, warnings, error, progress.Part(0, 0.3)))
  {
    return false;
  }
  const bool hasFaceColumn = columns.FaceColors || columns.FaceIndices;
  const bool isCloud = !hasFaceColumn && output.IsCloud();
  const vtkIdType points = output.GetNumberOfPoints();
  const vtkIdType faces = isCloud ? 0 : output.GetNumberOfCells();
  const bool isBinary = options.Encoding == OFFEncoding::Binary;
  if (isBinary && std::max(points, faces) > std::numeric_limits<std::int32_t>::max())
  {
    error = { ErrorKind::Unsupported,
      GetFileName(path) +
        ": expected fewer than 2147483648 vertices and faces for binary OFF, found more" };
    return false;
  }
  if (isBinary &&
    !(CheckSinglePrecision(mesh, path, warnings, error) &&
      CheckSinglePrecision(columns.Normals, 3, "normal", "normals", path, warnings, error) &&
      CheckSinglePrecision(
        columns.Texture, 2, "texture coordinate", "texture coordinates", path, warnings, error)))
  {
    return false;
  }
  if (!isCloud)
  {
    WarnOfShortFaces(output, warnings);
  }

  OutputFile file(path);
  const Writing writing(output, columns, options.Digits);
  bool good = false;
  if (isBinary)
  {
    std::string bytes = columns.GetKeyword() + " BINARY\n";
    BinarySink sink(bytes, 0);
    sink.AddInteger(points);
    sink.AddInteger(faces);
    sink.AddInteger(0);
    file.Write(bytes);
    good = writing.WriteRowsOf<BinarySink>(file, faces, progress.Part(0.3, 1));
  }
  else
  {
    WarnOfDigits(mesh, output, options.Digits, warnings);
    // Camarón expects the counts on the second line.
    file.Write(
      columns.GetKeyword() + "\n" + std::to_string(points) + " " + std::to_string(faces) + " 0\n");
    good = writing.WriteRowsOf<TextSink>(file, faces, progress.Part(0.3, 1));
  }
  return file.Finish(good, error);
}
}
