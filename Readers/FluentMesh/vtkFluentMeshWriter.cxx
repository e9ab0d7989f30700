// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluentMeshWriter.h"

#include "Intake/CellMesh/CellConversion.h"
#include "Intake/CellMesh/ConvertedMesh.h"
#include "Intake/CellMesh/OutputWarnings.h"
#include "Intake/Fluent/FluentOutput.h"
#include "Intake/Rows/Bytes.h"
#include "Intake/Write/RealFormat.h"
#include "Intake/Write/WriteRows.h"
#include "Scan/MappedFile.h"

#include "vtkBoundingBox.h"
#include "vtkDataSet.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The highest dimension of a mesh's cells.
int GetDimension(vtkDataSet* dataSet)
{
  const MeshView mesh(dataSet);
  int dimension = 0;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells() && dimension < 3; ++cell)
  {
    dimension = std::max(dimension, GetCellShape(mesh.GetCellType(cell)).Dimension);
  }
  return dimension;
}

//------------------------------------------------------------------------------
// Converts the parts of a file to bytes.
class Writing
{
public:
  Writing(OutputFile& file, const FluentOutput& mesh, int encoding)
    : File(file)
    , Mesh(mesh)
    , Encoding(encoding)
    , Swap(GetByteOrder() != ByteOrder::Little)
    , Real(RealFormat::Shortest(mesh.GetMesh().HasFloatPoints()))
  {
  }

  bool Write(const Progress& progress)
  {
    this->WriteHeader();
    if (!this->WriteNodes(progress.Part(0, 0.3)) || !this->WriteCells(progress.Part(0.3, 0.4)) ||
      !this->WriteFaces(progress.Part(0.4, 1)))
    {
      return false;
    }
    std::string text;
    for (const FluentZone& zone : this->Mesh.GetZones())
    {
      text += "(45 (" + std::to_string(zone.Id) + " " + zone.Type + " " + zone.Name + ")())\n";
    }
    this->File.Write(text);
    return true;
  }

private:
  bool IsText() const { return this->Encoding == vtkFluentMeshWriter::ASCII; }

  void WriteHeader()
  {
    const int dimension = this->Mesh.GetDimension();
    std::string text = "(0 \"Camaron\")\n(2 " + std::to_string(dimension) + ")\n";
    if (!this->IsText())
    {
      text += "(4 (60 0 0 1 2 4 4 4 8 8 8 4))\n"; // little endian, and the sizes of C types
    }
    const auto declare = [&text](int index, vtkIdType count, const std::string& more)
    {
      text += "(" + std::to_string(index) + " (0 1 ";
      AppendHex(text, static_cast<std::uint64_t>(count));
      text += " 0" + more + "))\n";
    };
    declare(10, this->Mesh.GetNumberOfPoints(), " " + std::to_string(dimension));
    declare(12, this->Mesh.GetNumberOfCells(), "");
    declare(13, static_cast<vtkIdType>(this->Mesh.GetFaces().size()), "");
    this->File.Write(text);
  }

  int GetIndex(int plain) const
  {
    constexpr int SingleBase = 2000, DoubleBase = 3000;
    return plain +
      (this->IsText()                                            ? 0
          : this->Encoding == vtkFluentMeshWriter::BINARY_SINGLE ? SingleBase
                                                                 : DoubleBase);
  }
  void Open(int index, const std::vector<vtkIdType>& header, bool hasData)
  {
    std::string text = "(" + std::to_string(this->GetIndex(index)) + " (";
    for (std::size_t i = 0; i < header.size(); ++i)
    {
      text += i > 0 ? " " : "";
      AppendHex(text, static_cast<std::uint64_t>(header[i]));
    }
    text += hasData ? this->IsText() ? ")(\n" : ")\n(" : ")";
    this->File.Write(text);
  }
  void Close(int index, bool hasData)
  {
    std::string text;
    if (this->IsText())
    {
      text = hasData ? "))\n" : ")\n";
    }
    else
    {
      text = (hasData ? ")\nEnd of Binary Section   " : "\nEnd of Binary Section   ") +
        std::to_string(this->GetIndex(index)) + ")\n";
    }
    this->File.Write(text);
  }
  void AppendInteger(std::string& bytes, vtkIdType value, char end) const
  {
    if (this->IsText())
    {
      AppendHex(bytes, static_cast<std::uint64_t>(value));
      bytes += end;
    }
    else
    {
      AppendBytes(bytes, static_cast<std::int32_t>(value), this->Swap);
    }
  }

  bool WriteNodes(const Progress& progress)
  {
    const int dimension = this->Mesh.GetDimension();
    const vtkIdType count = this->Mesh.GetNumberOfPoints();
    this->Open(10, { 1, 1, count, 1, dimension }, true);
    const bool good = WriteRows(this->File, count, progress,
      [&](vtkIdType row, std::string& bytes)
      {
        double x[3];
        this->Mesh.GetMesh().GetPoint(this->Mesh.GetMeshPoint(row), x);
        if (this->IsText())
        {
          this->Real.AppendRow(bytes, x, dimension);
          return;
        }
        for (int c = 0; c < dimension; ++c)
        {
          if (this->Encoding == vtkFluentMeshWriter::BINARY_SINGLE)
          {
            AppendBytes(bytes, static_cast<float>(x[c]), this->Swap);
          }
          else
          {
            AppendBytes(bytes, x[c], this->Swap);
          }
        }
      });
    this->Close(10, true);
    return good;
  }

  bool WriteCells(const Progress& progress)
  {
    for (const FluentOutput::Section& section : this->Mesh.GetCellSections())
    {
      const bool hasData = section.Element == 0;
      this->Open(12, { section.Zone, section.Begin + 1, section.End, 1, section.Element }, hasData);
      constexpr vtkIdType PerLine = 40;
      const vtkIdType count = hasData ? section.End - section.Begin : 0;
      if (!WriteRows(this->File, count, progress,
            [&](vtkIdType row, std::string& bytes)
            {
              const bool endsLine = row % PerLine == PerLine - 1 || row + 1 == count;
              this->AppendInteger(
                bytes, this->Mesh.GetElement(section.Begin + row), endsLine ? '\n' : ' ');
            }))
      {
        return false;
      }
      this->Close(12, hasData);
    }
    return true;
  }

  bool WriteFaces(const Progress& progress)
  {
    const auto total = static_cast<double>(this->Mesh.GetFaces().size()) + 1;
    for (const FluentOutput::Section& section : this->Mesh.GetFaceSections())
    {
      this->Open(
        13, { section.Zone, section.Begin + 1, section.End, section.Type, section.Element }, true);
      constexpr int Polygons = 5;
      const bool isSized = section.Element > 0 && section.Element < Polygons;
      if (!WriteRows(this->File, section.End - section.Begin,
            progress.Part(
              static_cast<double>(section.Begin) / total, static_cast<double>(section.End) / total),
            [&](vtkIdType row, std::string& bytes)
            {
              thread_local std::vector<vtkIdType> nodes;
              const FluentOutput::Face& face =
                this->Mesh.GetFaces()[static_cast<std::size_t>(section.Begin + row)];
              this->Mesh.GetNodes(face, nodes);
              if (!isSized)
              {
                this->AppendInteger(bytes, face.Size, ' ');
              }
              for (const vtkIdType node : nodes)
              {
                this->AppendInteger(bytes, this->Mesh.GetFilePoint(node) + 1, ' ');
              }
              this->AppendInteger(bytes, vtkIdType(face.Cells[0]) + 1, ' ');
              this->AppendInteger(bytes, vtkIdType(face.Cells[1]) + 1, '\n');
            }))
      {
        return false;
      }
      this->Close(13, true);
    }
    return true;
  }

  OutputFile& File;
  const FluentOutput& Mesh;
  int Encoding;
  bool Swap;
  RealFormat Real;
};

//------------------------------------------------------------------------------
// A 2D mesh must lie in a plane of constant z, except for rounding errors; @a z is the value with
// the greatest magnitude.
bool IsPlanar(const FluentOutput& mesh, double& z)
{
  constexpr double Rounding = 1e-12; // relative to the size of the mesh
  vtkBoundingBox box;
  for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
  {
    double x[3];
    mesh.GetMesh().GetPoint(mesh.GetMeshPoint(point), x);
    if (std::isnan(x[2]))
    {
      return false;
    }
    box.AddPoint(x);
  }
  const double *low = box.GetMinPoint(), *high = box.GetMaxPoint();
  z = std::fabs(low[2]) > std::fabs(high[2]) ? low[2] : high[2];
  return high[2] - low[2] <= Rounding * box.GetDiagonalLength();
}

//------------------------------------------------------------------------------
bool Write(OutputFile& file, const std::string& path, vtkDataSet* mesh, int encoding,
  UnsupportedCells others, Warnings& warnings, ScanError& error, const Progress& progress)
{
  const auto refuse = [&](const std::string& reason)
  {
    error = { ErrorKind::Unsupported, GetFileName(path) + ": " + reason };
    return false;
  };
  const int dimension = GetDimension(mesh);
  if (dimension < 2)
  {
    return refuse("expected cells of two or three dimensions, found none");
  }
  // Cells of one dimension less may be boundaries of others.
  CellConversion how{ "Fluent mesh",
    { VTK_EMPTY_CELL, VTK_LINE, VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON }, others };
  if (dimension == 3)
  {
    how.Held = { VTK_EMPTY_CELL, VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON, VTK_TETRA, VTK_PYRAMID,
      VTK_WEDGE, VTK_HEXAHEDRON, VTK_POLYHEDRON };
  }
  const vtkSmartPointer<vtkDataSet> cells = ConvertMesh(
    mesh, how, path, { "Zone", "BoundaryType" }, warnings, error, progress.Part(0, 0.2));
  if (!cells)
  {
    return false;
  }
  FluentOutput output(cells, dimension);
  std::string reason;
  if (!output.Build(warnings, reason, progress.Part(0.2, 0.5)))
  {
    return reason.empty() ? false : refuse(reason);
  }
  output.WarnOfSplitZones(warnings);
  if (output.GetFaces().empty())
  {
    return refuse("expected cells with faces, found none");
  }
  if (std::max(output.GetNumberOfPoints(), static_cast<vtkIdType>(output.GetFaces().size())) >
    INT32_MAX)
  {
    return refuse("more nodes or faces than Fluent can number");
  }
  double z = 0;
  if (dimension == 2 && !IsPlanar(output, z))
  {
    return refuse("expected a 2D mesh in a plane of constant z, found a curved or inclined one");
  }
  if (z != 0)
  {
    warnings.Add("the mesh is not exactly in the plane z = 0; z is not written");
  }
  WrittenArrays written;
  written.Cells = { "Zone", "BoundaryType" };
  written.Fields = { "ZoneIds", "ZoneNames", "ZoneTypes", "ZoneBoundaryTypes", "ZoneType",
    FluentInteriorZones::ArrayName };
  WarnOfArrays(mesh, "Fluent mesh", warnings, written);
  if (encoding == vtkFluentMeshWriter::BINARY_SINGLE &&
    !CheckSinglePrecision(mesh, path, warnings, error))
  {
    return false;
  }
  return Writing(file, output, encoding).Write(progress.Part(0.5, 1));
}
}
}

vtkStandardNewMacro(vtkFluentMeshWriter);

//------------------------------------------------------------------------------
int vtkFluentMeshWriter::GetDigitsOfCoordinates() const
{
  return this->Encoding == BINARY_SINGLE ? camaron::DigitsOfFloat : camaron::AllDigits;
}

//------------------------------------------------------------------------------
bool vtkFluentMeshWriter::WriteMesh(const std::string& path, vtkDataSet* mesh,
  camaron::Warnings& warnings, camaron::ScanError& error, const camaron::Progress& progress)
{
  camaron::OutputFile file(path);
  const bool good = !file.HasFailed() &&
    camaron::Write(
      file, path, mesh, this->Encoding, this->GetOtherCells(), warnings, error, progress);
  return file.Finish(good, error);
}

//------------------------------------------------------------------------------
void vtkFluentMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Encoding: " << this->Encoding << "\n";
}
