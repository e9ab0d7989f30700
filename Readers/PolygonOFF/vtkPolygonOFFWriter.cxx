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
#include "Scan/MappedFile.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <limits>

namespace camaron
{
namespace
{
constexpr char IndexName[] = "ColorIndex"; // name used by the reader

//------------------------------------------------------------------------------
// The arrays to write; the names of colors are empty or "None" for none.
struct OFFColumnNames
{
  bool Normals;
  bool Texture;
  std::string VertexColors, FaceColors;
};

//------------------------------------------------------------------------------
// The arrays of a mesh that are written.
class OFFColumns
{
public:
  /**
   * Finds the arrays with these names, and warns about those that are not written. False
   * with the error in @a error if one cannot be written.
   */
  bool Find(vtkDataSet* mesh, const OFFColumnNames& names, const std::string& path,
    Warnings& warnings, ScanError& error);

  vtkDataArray* Normals = nullptr;
  vtkDataArray* Texture = nullptr;
  vtkDataArray* VertexColors = nullptr;
  vtkDataArray* FaceColors = nullptr;  ///< with three or four components
  vtkDataArray* FaceIndices = nullptr; ///< into a color map
};

//------------------------------------------------------------------------------
// Whether colors of an array are real numbers from 0 to 1, not integers from 0 to 255.
bool IsReal(vtkDataArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

//------------------------------------------------------------------------------
bool IsColor(vtkDataArray* array)
{
  return array->GetNumberOfComponents() == 3 || array->GetNumberOfComponents() == 4;
}

//------------------------------------------------------------------------------
// Warns about colors that GetOFFColor clamps.
void WarnOfColors(vtkDataArray* colors, const char* one, const char* many, Warnings& warnings)
{
  if (!colors || colors->GetDataType() == VTK_UNSIGNED_CHAR)
  {
    return;
  }
  const double last = IsReal(colors) ? 1 : FullColor;
  Tally outOfRange;
  for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < colors->GetNumberOfComponents(); ++c)
    {
      const double value = colors->GetComponent(i, c);
      if (!(value >= 0 && value <= last))
      {
        outOfRange.Add(i);
        break;
      }
    }
  }
  warnings.Add(outOfRange, one, many,
    "with a color outside 0 to 255, or 0 to 1 for real numbers, clamped to this range");
}

//------------------------------------------------------------------------------
// Whether an array is a color by its type or name.
bool LooksLikeColor(vtkDataArray* array, bool ofCells)
{
  return array->GetName() &&
    ((IsColor(array) && array->GetDataType() == VTK_UNSIGNED_CHAR) ||
      (ofCells && array->GetNumberOfComponents() == 1 &&
        std::string(array->GetName()) == IndexName));
}

//------------------------------------------------------------------------------
bool OFFColumns::Find(vtkDataSet* mesh, const OFFColumnNames& names, const std::string& path,
  Warnings& warnings, ScanError& error)
{
  vtkPointData* const points = mesh->GetPointData();
  vtkCellData* const cells = mesh->GetCellData();
  const auto find = [&](vtkDataSetAttributes* data, const std::string& name, const char* of,
                      bool mayBeIndex) -> vtkDataArray*
  {
    const bool isNone = name.empty() || name == "None";
    vtkDataArray* const array = isNone ? nullptr : data->GetArray(name.c_str());
    const bool isIndex =
      array && mayBeIndex && array->GetNumberOfComponents() == 1 && !IsReal(array);
    if (!isNone && !error && !(array && (IsColor(array) || isIndex)))
    {
      error = { ErrorKind::Unsupported,
        GetFileName(path) + ": colors of " + of + " need an array with three or four components" +
          (mayBeIndex ? ", or with one integer" : "") + ", " +
          (array ? "but " + name + " has " + std::to_string(array->GetNumberOfComponents())
                 : "and there is no " + name) };
    }
    return array;
  };
  this->VertexColors = find(points, names.VertexColors, "vertices", false);
  this->FaceColors = find(cells, names.FaceColors, "faces", true);
  if (error)
  {
    return false;
  }
  if (this->FaceColors && this->FaceColors->GetNumberOfComponents() == 1)
  {
    std::swap(this->FaceColors, this->FaceIndices);
  }
  if (names.Normals)
  {
    this->Normals = points->GetNormals();
    if (!this->Normals)
    {
      warnings.Add("the mesh has no point normals to write");
    }
  }
  if (names.Texture)
  {
    this->Texture = points->GetTCoords();
    if (!this->Texture)
    {
      warnings.Add("the mesh has no texture coordinates to write");
    }
    else if (this->Texture->GetNumberOfComponents() != 2)
    {
      const bool isMore = this->Texture->GetNumberOfComponents() > 2;
      warnings.Add(std::string("OFF files store two texture coordinates: ") +
        (isMore ? "the third one is not written" : "a second one of 0 is added"));
    }
  }

  WrittenArrays written;
  std::string unasked;
  for (const bool ofCells : { false, true })
  {
    vtkDataSetAttributes* const data =
      mesh->GetAttributes(ofCells ? vtkDataObject::CELL : vtkDataObject::POINT);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* const array = data->GetArray(i);
      const bool isAsked = array &&
        (array == this->Normals || array == this->Texture || array == this->VertexColors ||
          array == this->FaceColors || array == this->FaceIndices);
      const bool isKnown = array &&
        (array == points->GetNormals() || array == points->GetTCoords() ||
          LooksLikeColor(array, ofCells));
      if (isKnown && !isAsked)
      {
        unasked += (unasked.empty() ? "" : ", ") + DescribeArray(mesh, array, ofCells);
      }
      if (isKnown || isAsked)
      {
        (ofCells ? written.Cells : written.Points).push_back(DescribeArray(array));
      }
    }
  }
  if (!unasked.empty())
  {
    warnings.Add(
      "normals, texture coordinates and colors are only written if selected; not written: " +
      unasked);
  }
  WarnOfArrays(mesh, "OFF", warnings, written);
  WarnOfColors(this->VertexColors, "point", "points", warnings);
  WarnOfColors(this->FaceColors, "cell", "cells", warnings);
  return true;
}

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
  /// Adds get(0) to get(count - 1).
  template <typename Get>
  void AddReals(std::string& bytes, int count, bool isFloat, Get&& get) const
  {
    if (!this->Encoder.IsText())
    {
      this->Encoder.Append<float>(bytes, count, get);
      return;
    }
    const RealFormat format =
      this->Digits > 0 ? RealFormat::Significant(this->Digits) : RealFormat::Shortest(isFloat);
    for (int i = 0; i < count; ++i)
    {
      format.Append(bytes, get(i));
      bytes += ' ';
    }
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
    this->AddReals(bytes, 3, this->Mesh.HasFloatPoints(), [&x](std::ptrdiff_t c) { return x[c]; });
    const vtkIdType tuple = this->Mesh.GetInputPoint(point);
    this->AddTuple(bytes, this->Columns.Normals, tuple, 3);
    if (this->Columns.VertexColors)
    {
      this->AddColor(bytes, this->Columns.VertexColors, tuple);
    }
    this->AddTuple(bytes, this->Columns.Texture, tuple, 2);
    this->Encoder.EndRow(bytes);
  }

  /// Nothing without an array.
  void AddTuple(std::string& bytes, vtkDataArray* array, vtkIdType tuple, int count) const
  {
    if (array)
    {
      const int components = array->GetNumberOfComponents();
      this->AddReals(bytes, count, array->GetDataType() == VTK_FLOAT,
        [=](int c) { return c < components ? array->GetComponent(tuple, c) : 0; });
    }
  }

  void AddFace(std::string& bytes, vtkIdType cell) const
  {
    const IndexRange points = this->Mesh.GetCellPoints(cell);
    const vtkIdType tuple = this->Mesh.GetInputCell(cell);
    const double index =
      this->Columns.FaceIndices ? this->Columns.FaceIndices->GetComponent(tuple, 0) : -1;
    const bool hasIndex = index >= 0 && index <= std::numeric_limits<std::int32_t>::max();
    const vtkIdType colorSize = this->Columns.FaceColors ? 4 : hasIndex ? 1 : 0;
    // In text, the size of the color follows from the end of the line.
    const vtkIdType count = points.Size + (this->Encoder.IsText() ? 1 : 2);
    this->Encoder.Append<std::int32_t>(bytes, count, [&](vtkIdType i)
      { return i == 0        ? points.Size
          : i <= points.Size ? points[i - 1]
                             : colorSize; });
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
    const auto getByte = [=](std::ptrdiff_t c)
    {
      return c < colors->GetNumberOfComponents()
        ? ToColorByte(colors->GetComponent(tuple, static_cast<int>(c)), IsReal(colors))
        : FullColor;
    };
    if (this->Encoder.IsText())
    {
      this->Encoder.Append<int>(bytes, 4, getByte);
    }
    else
    {
      this->AddReals(bytes, 4, true,
        [&](std::ptrdiff_t c) { return getByte(c) / static_cast<double>(FullColor); });
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
