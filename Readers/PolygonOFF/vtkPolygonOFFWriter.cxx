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
    std::string header = std::string(this->Columns.Texture ? "ST" : "") +
      (this->Columns.VertexColors ? "C" : "") + (this->Columns.Normals ? "N" : "") +
      (this->Encoder.IsText() ? "OFF\n" : "OFF BINARY\n");
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
    this->Encoder.IsText() ? this->Encoder.Append(bytes, value)
                           : this->Encoder.Append(bytes, static_cast<std::int32_t>(value));
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
    const bool hasIndex = index >= 0 && index <= std::numeric_limits<std::int32_t>::max();
    if (!this->Encoder.IsText()) // there it follows from the end of the line
    {
      this->AddInteger(bytes, this->Columns.FaceColors ? 4 : hasIndex ? 1 : 0);
    }
    if (this->Columns.FaceColors)
    {
      this->AddColor(bytes, this->Columns.FaceColors, tuple);
    }
    else if (hasIndex)
    {
      this->AddInteger(bytes, static_cast<vtkIdType>(index));
    }
    this->Encoder.EndRow(bytes);
  }

  /// Integers from 0 to 255 in text, else real numbers from 0 to 1.
  void AddColor(std::string& bytes, vtkDataArray* colors, vtkIdType tuple) const
  {
    for (int c = 0; c < 4; ++c)
    {
      const int byte = c < colors->GetNumberOfComponents()
        ? ToColorByte(colors->GetComponent(tuple, c), IsReal(colors))
        : FullColor;
      this->Encoder.IsText() ? this->AddInteger(bytes, byte)
                             : this->AddReal(bytes, byte / static_cast<double>(FullColor), true);
    }
  }

  const OutputMesh& Mesh;
  const OFFColumns& Columns;
  NumberEncoder Encoder;
  int Digits; ///< of real numbers in text
};
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
  const bool isBinary = this->Encoding == BINARY;
  camaron::OFFColumns columns;
  camaron::OutputMesh output;
  if (!columns.Find(mesh,
        { this->WriteNormals, this->WriteTextureCoordinates, this->VertexColors, this->FaceColors },
        path, warnings, error) ||
    !camaron::ConvertCells(mesh,
      { "OFF", { VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON, VTK_LINE, VTK_VERTEX }, this->GetOtherCells(),
        this->GetSurfaceFaces() },
      path, output, warnings, error, progress.Part(0, 0.3)))
  {
    return false;
  }
  const bool isCloud = !columns.FaceColors && !columns.FaceIndices && output.IsCloud();
  const vtkIdType faces = isCloud ? 0 : output.GetNumberOfCells();
  if (isBinary &&
    std::max(output.GetNumberOfPoints(), faces) > std::numeric_limits<std::int32_t>::max())
  {
    error = { camaron::ErrorKind::Unsupported,
      camaron::GetFileName(path) +
        ": expected fewer than 2147483648 vertices and faces for binary OFF, found more" };
    return false;
  }
  if (isBinary &&
    !(camaron::CheckSinglePrecision(mesh, path, warnings, error) &&
      camaron::CheckSinglePrecision(
        columns.Normals, 3, "normal", "normals", path, warnings, error) &&
      camaron::CheckSinglePrecision(
        columns.Texture, 2, "texture coordinate", "texture coordinates", path, warnings, error)))
  {
    return false;
  }
  const vtkIdType lines = output.Count(VTK_LINE), vertices = output.Count(VTK_VERTEX);
  if (!isCloud && lines + vertices > 0)
  {
    warnings.Add("lines written as faces with two vertices: " + std::to_string(lines) +
      ", vertices as faces with one: " + std::to_string(vertices) +
      "; some programs cannot read these");
  }
  if (!isBinary)
  {
    camaron::WarnOfDigits(mesh, output, this->Digits, warnings);
  }
  camaron::OutputFile file(path);
  const bool good = camaron::Writing(output, columns, isBinary, this->Digits)
                      .Write(file, faces, progress.Part(0.3, 1));
  return file.Finish(good, error);
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
