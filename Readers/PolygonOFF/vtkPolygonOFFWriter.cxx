// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolygonOFFWriter.h"

#include "Intake/CellMesh/CellConversion.h"
#include "Intake/CellMesh/OutputMesh.h"
#include "Intake/CellMesh/OutputWarnings.h"
#include "Intake/Write/NumberEncoder.h"
#include "Intake/Write/RealFormat.h"
#include "Intake/Write/WriteRows.h"
#include "PolygonOFFColors.h"
#include "PolygonOFFColumns.h"
#include "Scan/MappedFile.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkObjectFactory.h"

#include <limits>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
class Writing
{
public:
  Writing(const OutputMesh& mesh, const OFFColumns& columns, bool isBinary, int digits)
    : Mesh(mesh)
    , Columns(columns)
    , Encoder(!isBinary, true)
    , Digits(digits)
  {
  }

  bool Write(OutputFile& file, vtkIdType faces, const Progress& progress) const
  {
    // Camarón expects the counts on the second line.
    std::string header = this->Columns.GetKeyword() + (this->Encoder.IsText() ? "\n" : " BINARY\n");
    for (const vtkIdType count : { this->Mesh.GetNumberOfPoints(), faces, vtkIdType(0) })
    {
      this->AddInteger(header, count);
    }
    this->Encoder.EndRow(header);
    file.Write(header);
    return WriteRows(file, this->Mesh.GetNumberOfPoints(), progress.Part(0, 0.5),
             [this](vtkIdType point, std::string& bytes) { this->AddVertex(bytes, point); }) &&
      WriteRows(file, faces, progress.Part(0.5, 1),
        [this](vtkIdType cell, std::string& bytes) { this->AddFace(bytes, cell); });
  }

private:
  void AddReal(std::string& bytes, double value, bool isFloat) const
  {
    if (!this->Encoder.IsText())
    {
      this->Encoder.Append(bytes, static_cast<float>(value));
      return;
    }
    (this->Digits > 0 ? RealFormat::Significant(this->Digits) : RealFormat::Shortest(isFloat))
      .Append(bytes, value);
    bytes += ' ';
  }
  void AddInteger(std::string& bytes, vtkIdType value) const
  {
    if (this->Encoder.IsText())
    {
      this->Encoder.Append(bytes, value);
    }
    else
    {
      this->Encoder.Append(bytes, static_cast<std::int32_t>(value));
    }
  }
  /// In text, it follows from the end of the line.
  void AddColorSize(std::string& bytes, int size) const
  {
    if (!this->Encoder.IsText())
    {
      this->AddInteger(bytes, size);
    }
  }

  void AddVertex(std::string& bytes, vtkIdType point) const
  {
    double x[3];
    this->Mesh.GetPoint(point, x);
    for (const double coordinate : x)
    {
      this->AddReal(bytes, coordinate, this->Mesh.HasFloatPoints());
    }
    const vtkIdType tuple = this->Mesh.GetInputPoint(point);
    this->AddReals(bytes, this->Columns.Normals, tuple, 3);
    if (this->Columns.VertexColors)
    {
      this->AddColor(bytes, this->Columns.VertexColors, tuple);
    }
    this->AddReals(bytes, this->Columns.Texture, tuple, 2);
    this->Encoder.EndRow(bytes);
  }

  /// Nothing without an array.
  void AddReals(std::string& bytes, vtkDataArray* array, vtkIdType tuple, int count) const
  {
    for (int c = 0; array && c < count; ++c)
    {
      this->AddReal(bytes, c < array->GetNumberOfComponents() ? array->GetComponent(tuple, c) : 0,
        array->GetDataType() == VTK_FLOAT);
    }
  }

  void AddFace(std::string& bytes, vtkIdType cell) const
  {
    const IndexRange points = this->Mesh.GetCellPoints(cell);
    this->AddInteger(bytes, points.Size);
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      this->AddInteger(bytes, points[i]);
    }
    const vtkIdType tuple = this->Mesh.GetInputCell(cell);
    const double index =
      this->Columns.FaceIndices ? this->Columns.FaceIndices->GetComponent(tuple, 0) : -1;
    if (this->Columns.FaceColors)
    {
      this->AddColorSize(bytes, 4);
      this->AddColor(bytes, this->Columns.FaceColors, tuple);
    }
    else if (index >= 0 && index <= std::numeric_limits<std::int32_t>::max())
    {
      this->AddColorSize(bytes, 1);
      this->AddInteger(bytes, static_cast<vtkIdType>(index));
    }
    else
    {
      this->AddColorSize(bytes, 0);
    }
    this->Encoder.EndRow(bytes);
  }

  /// Integers in text, else real numbers from 0 to 1.
  void AddColor(std::string& bytes, vtkDataArray* colors, vtkIdType tuple) const
  {
    int color[4];
    GetOFFColor(colors, tuple, color);
    for (const int byte : color)
    {
      if (this->Encoder.IsText())
      {
        this->AddInteger(bytes, byte);
      }
      else
      {
        this->AddReal(bytes, byte / static_cast<double>(FullColor), true);
      }
    }
  }

  const OutputMesh& Mesh;
  const OFFColumns& Columns;
  NumberEncoder Encoder;
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

//------------------------------------------------------------------------------
struct OFFOptions
{
  bool IsBinary;
  int Digits; ///< of real numbers in text; 0 for the fewest that are exact
  OFFColumnNames Columns;
  CellConversion Cells;
};

//------------------------------------------------------------------------------
bool WriteOFF(const std::string& path, vtkDataSet* mesh, const OFFOptions& options,
  Warnings& warnings, ScanError& error, const Progress& progress)
{
  OFFColumns columns;
  OutputMesh output;
  if (!columns.Find(mesh, options.Columns, path, warnings, error) ||
    !ConvertCells(mesh, options.Cells, path, output, warnings, error, progress.Part(0, 0.3)))
  {
    return false;
  }
  const bool hasFaceColumn = columns.FaceColors || columns.FaceIndices;
  const bool isCloud = !hasFaceColumn && output.IsCloud();
  const vtkIdType points = output.GetNumberOfPoints();
  const vtkIdType faces = isCloud ? 0 : output.GetNumberOfCells();
  if (options.IsBinary && std::max(points, faces) > std::numeric_limits<std::int32_t>::max())
  {
    error = { ErrorKind::Unsupported,
      GetFileName(path) +
        ": expected fewer than 2147483648 vertices and faces for binary OFF, found more" };
    return false;
  }
  if (options.IsBinary &&
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

  if (!options.IsBinary)
  {
    WarnOfDigits(mesh, output, options.Digits, warnings);
  }
  OutputFile file(path);
  const bool good = Writing(output, columns, options.IsBinary, options.Digits)
                      .Write(file, faces, progress.Part(0.3, 1));
  return file.Finish(good, error);
}
}
}

vtkStandardNewMacro(vtkPolygonOFFWriter);

//------------------------------------------------------------------------------
int vtkPolygonOFFWriter::GetDigitsOfCoordinates() const
{
  return this->Encoding == BINARY ? camaron::DigitsOfFloat : this->Digits;
}

//------------------------------------------------------------------------------
bool vtkPolygonOFFWriter::WriteMesh(const std::string& path, vtkDataSet* mesh,
  camaron::Warnings& warnings, camaron::ScanError& error, const camaron::Progress& progress)
{
  const auto getName = [](const std::string& name)
  { return name == "None" ? std::string() : name; };
  const camaron::OFFOptions options = { this->Encoding == BINARY, this->Digits,
    { this->WriteNormals, this->WriteTextureCoordinates, getName(this->VertexColors),
      getName(this->FaceColors) },
    { "OFF", { VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON, VTK_LINE, VTK_VERTEX }, this->GetOtherCells(),
      this->GetSurfaceFaces() } };
  return camaron::WriteOFF(path, mesh, options, warnings, error, progress);
}

//------------------------------------------------------------------------------
void vtkPolygonOFFWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Encoding: " << this->Encoding << "\n";
  os << indent << "Digits: " << this->Digits << "\n";
  os << indent << "WriteNormals: " << this->WriteNormals << "\n";
  os << indent << "WriteTextureCoordinates: " << this->WriteTextureCoordinates << "\n";
  os << indent << "VertexColors: " << this->VertexColors << "\n";
  os << indent << "FaceColors: " << this->FaceColors << "\n";
}
