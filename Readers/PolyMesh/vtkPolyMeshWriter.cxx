// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyMeshWriter.h"

#include "Base/Number.h"
#include "FoamFile.h"
#include "Intake/CellMesh/ConvertedMesh.h"
#include "Intake/Fluent/FluentWriting.h"
#include "Intake/Rows/Bytes.h"
#include "Intake/Write/RealFormat.h"
#include "PolyMeshFolder.h"
#include "PolyMeshOutput.h"
#include "Scan/MappedFile.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
constexpr const char* Selected = "Selected";

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
        for (const double coordinate : x)
        {
          AppendBytes(bytes, coordinate, false);
        }
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
