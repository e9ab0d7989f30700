// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluentMeshWriter.h"

#include "Intake/CellMesh/OutputWarnings.h"
#include "Intake/Fluent/FluentWriting.h"
#include "Intake/Rows/Bytes.h"
#include "Intake/Write/RealFormat.h"
#include "Intake/Write/WriteRows.h"

#include "vtkObjectFactory.h"

#include <algorithm>

namespace camaron
{
namespace
{
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

  /// Writes a section with rows of data, or with none: append(row, bytes) converts a row.
  template <typename Append>
  bool WriteSection(int plain, const std::vector<vtkIdType>& header, vtkIdType count,
    const Progress& progress, Append&& append)
  {
    constexpr int SingleBase = 2000, DoubleBase = 3000;
    const int base = this->IsText()                          ? 0
      : this->Encoding == vtkFluentMeshWriter::BINARY_SINGLE ? SingleBase
                                                             : DoubleBase;
    const std::string index = std::to_string(plain + base);
    std::string text = "(" + index + " (";
    for (std::size_t i = 0; i < header.size(); ++i)
    {
      text += i > 0 ? " " : "";
      AppendHex(text, static_cast<std::uint64_t>(header[i]));
    }
    this->File.Write(text + (count == 0 ? ")" : this->IsText() ? ")(\n" : ")\n("));
    const bool good = WriteRows(this->File, count, progress, append);
    text = count > 0 ? ")" : "";
    this->File.Write(
      text + (this->IsText() ? ")\n" : "\nEnd of Binary Section   " + index + ")\n"));
    return good;
  }
  /// Appends get(0) to get(count - 1), in text as a line.
  template <typename Get>
  void AppendIntegers(std::string& bytes, vtkIdType count, Get&& get) const
  {
    if (!this->IsText())
    {
      AppendBytes<std::int32_t>(bytes, count, get, this->Swap);
      return;
    }
    AppendWords(bytes, count, [&get](vtkIdType i, char* to)
      { return std::to_chars(to, to + 16, static_cast<std::uint64_t>(get(i)), 16).ptr; });
    bytes.back() = '\n';
  }

  bool WriteNodes(const Progress& progress)
  {
    const int dimension = this->Mesh.GetDimension();
    const vtkIdType count = this->Mesh.GetNumberOfPoints();
    return this->WriteSection(FluentSection::NodesIndex, { 1, 1, count, 1, dimension }, count,
      progress,
      [&](vtkIdType row, std::string& bytes)
      {
        double x[3];
        this->Mesh.GetMesh().GetPoint(this->Mesh.GetMeshPoint(row), x);
        if (this->IsText())
        {
          this->Real.AppendRow(bytes, x, dimension);
          return;
        }
        const auto get = [&x](std::ptrdiff_t c) { return x[c]; };
        this->Encoding == vtkFluentMeshWriter::BINARY_SINGLE
          ? AppendBytes<float>(bytes, dimension, get, this->Swap)
          : AppendBytes<double>(bytes, dimension, get, this->Swap);
      });
  }

  bool WriteCells(const Progress& progress)
  {
    bool good = true;
    for (const FluentOutput::Section& section : this->Mesh.GetCellSections())
    {
      constexpr vtkIdType PerLine = 40;
      const vtkIdType count = section.Element == 0 ? section.End - section.Begin : 0;
      good = good &&
        this->WriteSection(FluentSection::CellsIndex,
          { section.Zone, section.Begin + 1, section.End, 1, section.Element },
          (count + PerLine - 1) / PerLine, progress,
          [&](vtkIdType row, std::string& bytes)
          {
            const vtkIdType first = section.Begin + row * PerLine;
            this->AppendIntegers(bytes, std::min(PerLine, section.End - first),
              [&](vtkIdType i) { return this->Mesh.GetElement(first + i); });
          });
    }
    return good;
  }

  bool WriteFaces(const Progress& progress)
  {
    bool good = true;
    const auto total = static_cast<double>(this->Mesh.GetFaces().size()) + 1;
    for (const FluentOutput::Section& section : this->Mesh.GetFaceSections())
    {
      const bool isSized = section.Element > 0 && section.Element < FluentSection::Polygons;
      const auto from = static_cast<double>(section.Begin), to = static_cast<double>(section.End);
      good = good &&
        this->WriteSection(FluentSection::FacesIndex,
          { section.Zone, section.Begin + 1, section.End, section.Type, section.Element },
          section.End - section.Begin, progress.Part(from / total, to / total),
          [&](vtkIdType row, std::string& bytes)
          {
            thread_local std::vector<vtkIdType> nodes;
            const FluentOutput::Face& face =
              this->Mesh.GetFaces()[static_cast<std::size_t>(section.Begin + row)];
            this->Mesh.GetNodes(face, nodes);
            const auto size = static_cast<vtkIdType>(nodes.size());
            const auto get = [&](vtkIdType i) // the size, the nodes, the cells
            {
              return i == 0 ? vtkIdType(face.Size)
                : i <= size ? this->Mesh.GetFilePoint(nodes[static_cast<std::size_t>(i) - 1]) + 1
                            : vtkIdType(face.Cells[i - size - 1]) + 1;
            };
            const vtkIdType first = isSized ? 1 : 0; // the section has the size
            this->AppendIntegers(
              bytes, size + 3 - first, [&](vtkIdType i) { return get(first + i); });
          });
    }
    return good;
  }

  OutputFile& File;
  const FluentOutput& Mesh;
  int Encoding;
  bool Swap;
  RealFormat Real;
};

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
  return camaron::WriteFluent(path, mesh, this->GetOtherCells(), warnings, error, progress,
    [&](
      const camaron::FluentOutput& output, camaron::OutputFile& file, const camaron::Progress& part)
    {
      return (this->Encoding != BINARY_SINGLE ||
               camaron::CheckSinglePrecision(mesh, path, warnings, error)) &&
        camaron::Writing(file, output, this->Encoding).Write(part);
    });
}

//------------------------------------------------------------------------------
void vtkFluentMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Encoding: " << this->Encoding << "\n";
}
