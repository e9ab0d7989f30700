// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyMeshWriter.h"

#include "Base/Number.h"
#include "Intake/CellMesh/ConvertedMesh.h"
#include "Intake/Fluent/FluentWriting.h"
#include "Intake/Rows/Bytes.h"
#include "Intake/Write/RealFormat.h"
#include "Intake/Write/WriteRows.h"
#include "PolyMeshFolder.h"
#include "PolyMeshOutput.h"
#include "Scan/MappedFile.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkObjectFactory.h"

#include "vtk_zlib.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>

namespace camaron
{
namespace
{
constexpr const char* Selected = "Selected";

/// How the files of a mesh are written.
struct FoamEncoding
{
  bool IsBinary = false;
  bool Has64BitLabels = false;
  bool IsCompressed = false; ///< by gzip
  FoamEncoding AsText() const { return { false, this->Has64BitLabels, this->IsCompressed }; }
};

//------------------------------------------------------------------------------
// A file of a mesh: a header and lists, in text or binary.
class FoamFile
{
public:
  /**
   * @param folder of the file, which exists
   * @param kind OpenFOAM's class of the contents, e.g. labelList
   * @param note of the header; empty for none
   */
  FoamFile(const std::filesystem::path& folder, const std::string& name, const std::string& kind,
    const FoamEncoding& encoding, const std::string& note = "")
    : Name(name + (encoding.IsCompressed ? ".gz" : ""))
    , Encoding(encoding)
  {
    const std::string path = (folder / this->Name).string();
    this->File = gzopen(path.c_str(), encoding.IsCompressed ? "wb" : "wbT"); // T: not compressed
    if (!this->File)
    {
      this->Fail();
      return;
    }
    const std::string order = GetByteOrder() == ByteOrder::Little ? "LSB" : "MSB";
    this->Write("FoamFile\n{\n    version     2.0;\n    format      " +
      std::string(encoding.IsBinary ? "binary" : "ascii") + ";\n    arch        \"" + order +
      ";label=" + (encoding.Has64BitLabels ? "64" : "32") + ";scalar=64\";\n    class       " +
      kind + ";\n" + (note.empty() ? "" : "    note        \"" + note + "\";\n") +
      "    location    \"constant/polyMesh" + (kind == "cellSet" ? "/sets" : "") +
      "\";\n    object      " + name + ";\n}\n");
  }
  ~FoamFile()
  {
    if (this->File)
    {
      gzclose(this->File);
    }
  }
  FoamFile(const FoamFile&) = delete;
  FoamFile& operator=(const FoamFile&) = delete;

  void Write(const std::string& bytes)
  {
    if (!this->HasFailed() && !bytes.empty() &&
      gzwrite(this->File, bytes.data(), static_cast<unsigned>(bytes.size())) <= 0)
    {
      this->Fail();
    }
  }
  bool HasFailed() const { return static_cast<bool>(this->Error); }
  /// Completes the file; false with the error, or without one if @a isWritten is false.
  bool Finish(bool isWritten, ScanError& error)
  {
    if (this->File && gzclose(this->File) != Z_OK && !this->HasFailed())
    {
      this->Fail();
    }
    this->File = nullptr;
    error = error ? error : this->Error;
    return isWritten && !this->HasFailed();
  }

  /// Appends a label; in text without anything behind it.
  void AppendLabel(std::string& bytes, vtkIdType label) const
  {
    if (!this->Encoding.IsBinary)
    {
      AppendNumber(bytes, label);
    }
    else if (this->Encoding.Has64BitLabels)
    {
      AppendBytes(bytes, static_cast<std::int64_t>(label), false);
    }
    else
    {
      AppendBytes(bytes, static_cast<std::int32_t>(label), false);
    }
  }

  /// Writes a list of @a count items, "n(...)": append(i, bytes) for each of some rows with all of
  /// them; in text one row per line.
  template <typename Append>
  bool WriteList(vtkIdType count, vtkIdType rows, const Progress& progress, Append&& append)
  {
    const bool isBinary = this->Encoding.IsBinary;
    const bool isOpen = count > 0 || !isBinary; // binary lists of no items have no parentheses
    this->Write("\n" + std::to_string(count) + (isOpen ? isBinary ? "\n(" : "\n(\n" : "\n"));
    const bool good = WriteRows(*this, rows, progress,
      [&](vtkIdType i, std::string& bytes)
      {
        append(i, bytes);
        bytes.append(isBinary ? 0 : 1, '\n');
      });
    this->Write(isOpen ? ")\n" : "\n");
    return good;
  }
  ///@{
  /// Writes a list of labels; get(i) for each.
  template <typename Get>
  bool WriteLabels(vtkIdType count, const Progress& progress, Get&& get)
  {
    return this->WriteList(count, count, progress,
      [&](vtkIdType i, std::string& bytes) { this->AppendLabel(bytes, get(i)); });
  }
  bool WriteLabels(const std::vector<vtkIdType>& labels, const Progress& progress)
  {
    return this->WriteLabels(
      static_cast<vtkIdType>(labels.size()), progress, [&](vtkIdType i) { return labels[i]; });
  }
  ///@}

private:
  void Fail()
  {
    this->Error = { errno == ENOSPC || errno == EFBIG ? ErrorKind::DiskFull : ErrorKind::Write,
      this->Name + ": cannot write the file: " + std::strerror(errno) };
  }

  std::string Name;
  FoamEncoding Encoding;
  gzFile File; ///< also for files that are not compressed
  ScanError Error;
};

//------------------------------------------------------------------------------
// Writes the files of a mesh into a folder.
struct Writing
{
  const std::filesystem::path& Folder;
  const PolyMeshOutput& Mesh;
  const FoamEncoding& Encoding;
  ScanError& Error;

  bool Write(const std::vector<vtkIdType>& selected, const Progress& progress)
  {
    return this->WritePoints(progress.Part(0, 0.3)) && this->WriteFaces(progress.Part(0.3, 0.7)) &&
      this->WriteCellsOfFaces(progress.Part(0.7, 0.9)) && this->WriteBoundary() &&
      this->WriteZones("cell", this->Mesh.GetCellZones(), progress.Part(0.9, 0.95)) &&
      this->WriteZones("face", this->Mesh.GetFaceZones(), progress.Part(0.95, 1)) &&
      (selected.empty() || this->WriteSet(selected));
  }

  bool WritePoints(const Progress& progress)
  {
    FoamFile file(this->Folder, "points", "vectorField", this->Encoding);
    const RealFormat real = RealFormat::Shortest(this->Mesh.HasFloatPoints());
    const vtkIdType count = this->Mesh.GetNumberOfPoints();
    const bool good = file.WriteList(count, count, progress,
      [&](vtkIdType point, std::string& bytes)
      {
        double x[3];
        this->Mesh.GetPoint(point, x);
        if (!this->Encoding.IsBinary)
        {
          bytes += '(';
          real.AppendRow(bytes, x, 3, ')');
          return;
        }
        AppendBytes<double>(bytes, 3, [&x](std::ptrdiff_t c) { return x[c]; }, false);
      });
    return file.Finish(good, this->Error);
  }

  /// In text the points of each face; in binary the offsets of all faces, then their points.
  bool WriteFaces(const Progress& progress)
  {
    const std::vector<PolyMeshOutput::Face>& faces = this->Mesh.GetFaces();
    const auto count = static_cast<vtkIdType>(faces.size());
    const bool isBinary = this->Encoding.IsBinary;
    FoamFile file(this->Folder, "faces", isBinary ? "faceCompactList" : "faceList", this->Encoding);
    std::vector<vtkIdType> offsets(1, 0);
    for (vtkIdType face = 0; isBinary && face < count; ++face)
    {
      offsets.push_back(offsets.back() + faces[face].Size);
    }
    const bool good = (!isBinary || file.WriteLabels(offsets, progress.Part(0, 0.3))) &&
      file.WriteList(isBinary ? offsets.back() : count, count, progress.Part(0.3, 1),
        [&](vtkIdType face, std::string& bytes)
        {
          thread_local std::vector<vtkIdType> points;
          this->Mesh.GetFacePoints(faces[face], points);
          bytes += isBinary ? "" : std::to_string(points.size()) + "(";
          for (const vtkIdType& point : points)
          {
            file.AppendLabel(bytes, point);
            bytes.append(isBinary ? 0 : 1, &point == &points.back() ? ')' : ' ');
          }
        });
    return file.Finish(good, this->Error);
  }

  bool WriteCellsOfFaces(const Progress& progress)
  {
    const std::vector<PolyMeshOutput::Face>& faces = this->Mesh.GetFaces();
    const vtkIdType inside = this->Mesh.GetNumberOfInteriorFaces();
    const std::string note = "nPoints:" + std::to_string(this->Mesh.GetNumberOfPoints()) +
      "  nCells:" + std::to_string(this->Mesh.GetNumberOfCells()) +
      "  nFaces:" + std::to_string(faces.size()) + "  nInternalFaces:" + std::to_string(inside);
    const auto write = [&](const char* name, vtkIdType count, const Progress& part,
                         std::int32_t PolyMeshOutput::Face::* cell)
    {
      FoamFile file(this->Folder, name, "labelList", this->Encoding, note);
      const bool good =
        file.WriteLabels(count, part, [&](vtkIdType face) { return faces[face].*cell; });
      return file.Finish(good, this->Error);
    };
    return write("owner", static_cast<vtkIdType>(faces.size()), progress.Part(0, 0.6),
             &PolyMeshOutput::Face::Owner) &&
      write("neighbour", inside, progress.Part(0.6, 1), &PolyMeshOutput::Face::Neighbor);
  }

  bool WriteBoundary()
  {
    FoamFile file(this->Folder, "boundary", "polyBoundaryMesh", this->Encoding.AsText());
    const std::vector<PolyMeshOutput::Patch>& patches = this->Mesh.GetPatches();
    std::string text = "\n" + std::to_string(patches.size()) + "\n(\n";
    for (const PolyMeshOutput::Patch& patch : patches)
    {
      // As OpenFOAM does for its constraint types and walls; others must not be names of patches.
      const bool isPlain = patch.Type == "patch";
      const std::string group = isPlain ? patch.Group : patch.Type;
      const bool isName = isPlain &&
        std::any_of(patches.begin(), patches.end(),
          [&group](const PolyMeshOutput::Patch& other) { return other.Name == group; });
      text += "    " + patch.Name + "\n    {\n        type            " + patch.Type + ";\n" +
        (group.empty() || isName ? "" : "        inGroups        1(" + group + ");\n") +
        "        nFaces          " + std::to_string(patch.End - patch.Begin) +
        ";\n        startFace       " + std::to_string(patch.Begin) + ";\n    }\n";
    }
    file.Write(text + ")\n");
    return file.Finish(true, this->Error);
  }

  /// A dictionary of lists of cells or faces; none if there are no zones.
  bool WriteZones(const std::string& element, const std::vector<PolyMeshOutput::Zone>& zones,
    const Progress& progress)
  {
    if (zones.empty())
    {
      return true;
    }
    FoamFile file(this->Folder, element + "Zones", "regIOobject", this->Encoding);
    file.Write("\n" + std::to_string(zones.size()) + "\n(\n");
    bool good = true;
    for (const PolyMeshOutput::Zone& zone : zones)
    {
      file.Write(zone.Name + "\n{\n    type            " + element + "Zone;\n" +
        (zone.Group.empty() ? "" : "    inGroups        1(" + zone.Group + ");\n") + "    " +
        element + "Labels      List<label> ");
      good = good && file.WriteLabels(zone.Ids, progress);
      file.Write(";\n");
      if (element == "face")
      {
        const auto count = static_cast<vtkIdType>(zone.Ids.size());
        file.Write("    flipMap         List<bool> ");
        good = good &&
          file.WriteList(count, count, progress,
            [&](vtkIdType, std::string& bytes) { bytes += this->Encoding.IsBinary ? '\0' : '0'; });
        file.Write(";\n");
      }
      file.Write("}\n");
    }
    file.Write(")\n");
    return file.Finish(good, this->Error);
  }

  bool WriteSet(const std::vector<vtkIdType>& selected)
  {
    FoamFile file(this->Folder / "sets", Selected, "cellSet", this->Encoding.AsText());
    return file.Finish(file.WriteLabels(selected, Progress()), this->Error);
  }
};

//------------------------------------------------------------------------------
// The cells of the file whose array Selected is not 0.
std::vector<vtkIdType> FindSelected(vtkDataSet* cells, const PolyMeshOutput& mesh)
{
  std::vector<vtkIdType> ids;
  vtkDataArray* const marks = cells->GetCellData()->GetArray(Selected);
  const bool hasMarks = marks && marks->GetNumberOfComponents() == 1;
  for (vtkIdType cell = 0; hasMarks && cell < mesh.GetNumberOfCells(); ++cell)
  {
    if (marks->GetComponent(mesh.GetMeshCell(cell), 0) > 0) // not NaN
    {
      ids.push_back(cell);
    }
  }
  return ids;
}
}
}

vtkStandardNewMacro(vtkPolyMeshWriter);

//------------------------------------------------------------------------------
bool vtkPolyMeshWriter::WriteMesh(const std::string& path, vtkDataSet* mesh,
  camaron::Warnings& warnings, camaron::ScanError& error, const camaron::Progress& progress)
{
  const auto refuse = [&](const std::string& reason)
  {
    error = { camaron::ErrorKind::Unsupported, camaron::GetFileName(path) + ": " + reason };
    return false;
  };
  if (!(this->Scale > 0 && std::isnormal(this->Scale)))
  {
    std::string found;
    camaron::AppendNumber(found, this->Scale);
    return refuse("expected a Scale from 2.3e-308 to 1.7e308, found " + found);
  }
  if (camaron::GetDimension(mesh) != 3)
  {
    return refuse("expected 3D cells, found none");
  }
  camaron::PolyMeshFolder folder(path);
  if (!folder.Check(this->Overwrite, error))
  {
    return false;
  }
  const camaron::CellConversion how{ "OpenFOAM polyMesh",
    { VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON, VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON,
      VTK_POLYHEDRON },
    this->GetOtherCells() };
  const vtkSmartPointer<vtkDataSet> cells = camaron::ConvertMesh(mesh, how, path,
    { "Zone", "BoundaryType", camaron::Selected }, warnings, error, progress.Part(0, 0.2));
  if (!cells)
  {
    return false;
  }
  camaron::PolyMeshOutput output(cells, this->Scale);
  std::string reason;
  if (!output.Build(
        this->GetUnsupportedCells() == REFUSE, warnings, reason, progress.Part(0.2, 0.5)))
  {
    return reason.empty() ? false : refuse(reason);
  }
  camaron::WarnOfLostArrays(mesh, "OpenFOAM polyMesh", warnings, { camaron::Selected });
  const camaron::FoamEncoding encoding{ this->Encoding == BINARY, this->LabelSize == LABELS_64,
    this->Compress };
  const std::vector<vtkIdType> selected = camaron::FindSelected(cells, output);
  return folder.Open(!selected.empty(), error) &&
    camaron::Writing{ folder.GetPath(), output, encoding, error }.Write(
      selected, progress.Part(0.5, 1)) &&
    folder.Commit(error);
}

//------------------------------------------------------------------------------
void vtkPolyMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Encoding: " << this->Encoding << "\n";
  os << indent << "Compress: " << this->Compress << "\n";
  os << indent << "LabelSize: " << this->LabelSize << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "Overwrite: " << this->Overwrite << "\n";
}
