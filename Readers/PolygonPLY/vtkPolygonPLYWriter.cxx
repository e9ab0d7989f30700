// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolygonPLYWriter.h"

#include "Intake/CellMesh/CellConversion.h"
#include "Intake/CellMesh/OutputMesh.h"
#include "Intake/CellMesh/OutputWarnings.h"
#include "Intake/FaceMesh/SharedFaces.h"
#include "Intake/Write/WriteRows.h"
#include "PLYHeader.h"
#include "Scan/MappedFile.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace camaron
{
namespace
{
struct PLYWriteOptions
{
  PLYEncoding Encoding;
  bool FloatCoordinates; ///< even if the mesh has double
  bool Cells;            ///< 3D cells as elements `cell`, not only their faces
  UnsupportedCells Others;
  SurfaceFaces Surface;
};

constexpr vtkIdType MaxByteLength = 255; // of lists whose length is stored in one byte

//------------------------------------------------------------------------------
CellConversion GetConversion(const PLYWriteOptions& options)
{
  CellConversion how{ "PLY", { VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON, VTK_LINE, VTK_VERTEX },
    options.Others, options.Surface };
  if (options.Cells)
  {
    how.Held = { VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON, VTK_LINE, VTK_VERTEX, VTK_TETRA, VTK_PYRAMID,
      VTK_WEDGE, VTK_HEXAHEDRON, VTK_POLYHEDRON, VTK_EMPTY_CELL };
    how.Surface = SurfaceFaces::None;
  }
  return how;
}

//------------------------------------------------------------------------------
// Writes one file.
class Writing
{
public:
  Writing(OutputFile& file, vtkDataSet* mesh, const PLYWriteOptions& options, Warnings& warnings)
    : File(file)
    , Mesh(mesh)
    , Options(options)
    , Encoder(options.Encoding == PLYEncoding::Text, options.Encoding == PLYEncoding::BigEndian)
    , Messages(warnings)
  {
  }

  bool Write(const std::string& path, ScanError& error, const Progress& progress);

private:
  void PlanArrays();
  void SortCells();
  void ShareFaces();
  void WarnOfOrder();
  void WriteHeader();
  std::string GetListType(const char* name, vtkIdType greatest);
  bool WritePoints(const Progress& progress);
  bool WriteCells(bool areEdges, const Progress& progress);
  bool WriteLists(const WordLists& lists, bool areFaces, const Progress& progress);
  void AppendLength(std::string& bytes, vtkIdType length, vtkIdType greatest) const
  {
    if (greatest > MaxByteLength)
    {
      this->Encoder.Append(bytes, static_cast<std::int32_t>(length));
    }
    else
    {
      this->Encoder.Append(bytes, static_cast<std::uint8_t>(length));
    }
  }
  vtkIdType GetNumberOfFaceCells() const
  {
    return this->AreAllFaces ? this->Output.GetNumberOfCells()
                             : static_cast<vtkIdType>(this->FaceCells.size());
  }
  static vtkIdType GetGreatestLength(const WordLists& lists);

  OutputFile& File;
  vtkDataSet* Mesh;
  const PLYWriteOptions& Options;
  NumberEncoder Encoder;
  Warnings& Messages;
  PLYColumns PointColumns, CellColumns;
  OutputMesh Output;
  bool IsDouble = false;
  bool AreAllFaces = false; ///< whether every cell is a face
  bool EdgesFirst = false;
  std::vector<std::int32_t> FaceCells; ///< cells of Output written as faces
  std::vector<std::int32_t> EdgeCells; ///< cells of Output written as edges
  vtkIdType GreatestFace = 0;
  ///@{
  /// With 3D cells: the polygons that these share, and other 2D cells.
  std::unique_ptr<SharedFaces> Shared;
  vtkIdType GreatestCell = 0;
  ///@}
};

//------------------------------------------------------------------------------
void Writing::PlanArrays()
{
  WrittenArrays written;
  this->PointColumns =
    PLYColumns(this->Mesh->GetPointData(), { "x", "y", "z" }, written.Points, this->Messages);
  // The same names in all elements, so that readers create one array.
  const std::set<std::string> reserved = { "vertex_indices", "vertex_index", "face_indices",
    "face_index", "vertex1", "vertex2", "v1", "v2" };
  this->CellColumns =
    PLYColumns(this->Mesh->GetCellData(), reserved, written.Cells, this->Messages);
  WarnOfArrays(this->Mesh, "PLY", this->Messages, written);
}

//------------------------------------------------------------------------------
// Determines which cells are written as faces and as edges.
void Writing::SortCells()
{
  const vtkIdType size = this->Output.GetNumberOfCells();
  if (size == 0 || (this->CellColumns.IsEmpty() && this->Output.IsCloud()))
  {
    return; // readers create these cells from the points alone
  }
  this->AreAllFaces = !this->Options.Cells && this->Output.Count(VTK_LINE) == 0;
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    const unsigned char type = this->Output.GetCellType(cell);
    if (type == VTK_LINE)
    {
      this->EdgeCells.push_back(static_cast<std::int32_t>(cell));
    }
    else if (!this->Options.Cells || type == VTK_VERTEX)
    {
      this->GreatestFace = std::max(this->GreatestFace, this->Output.GetCellPoints(cell).Size);
      if (!this->AreAllFaces)
      {
        this->FaceCells.push_back(static_cast<std::int32_t>(cell));
      }
    }
  }
}

//------------------------------------------------------------------------------
vtkIdType Writing::GetGreatestLength(const WordLists& lists)
{
  vtkIdType greatest = 0;
  const std::int32_t* const end = lists.Words.data() + lists.Words.size();
  for (const std::int32_t* word = lists.Words.data(); word < end; word += 1 + *word)
  {
    greatest = std::max<vtkIdType>(greatest, *word);
  }
  return greatest;
}

//------------------------------------------------------------------------------
void Writing::ShareFaces()
{
  SharedFaces::RoleTable roles = SharedFaces::GetUsualRoles();
  // Points are faces with one vertex, lines are edges.
  std::replace(roles.begin(), roles.end(), FaceRole::Pieces, FaceRole::None);
  this->Shared = std::make_unique<SharedFaces>(this->Mesh, roles);
  this->Shared->Build();
  this->GreatestFace = std::max(this->GreatestFace, GetGreatestLength(this->Shared->Polygons));
  this->GreatestCell = GetGreatestLength(this->Shared->Polyhedra);
}

//------------------------------------------------------------------------------
// Readers list the cells of one element after those of another.
void Writing::WarnOfOrder()
{
  const auto getRank = [&](vtkIdType cell)
  {
    const unsigned char type = this->Output.GetCellType(cell);
    const int dimension = GetCellShape(type).Dimension;
    return type == VTK_LINE                      ? (this->EdgesFirst ? 0 : 4)
      : dimension == 3 || type == VTK_EMPTY_CELL ? 1
      : dimension == 2 || !this->Options.Cells   ? 2
                                                 : 3;
  };
  if (!this->Options.Cells && !this->EdgeCells.empty() && !this->FaceCells.empty())
  {
    this->EdgesFirst = this->EdgeCells.back() < this->FaceCells.front();
  }
  int last = 0;
  for (vtkIdType cell = 0; cell < this->Output.GetNumberOfCells(); ++cell)
  {
    const int rank = getRank(cell);
    if (rank < last)
    {
      this->Messages.Add("the cells are written in another order: "
                         "3D cells, faces, edges");
      return;
    }
    last = rank;
  }
}

//------------------------------------------------------------------------------
std::string Writing::GetListType(const char* name, vtkIdType greatest)
{
  const bool isLong = greatest > MaxByteLength;
  if (isLong)
  {
    this->Messages.Add("the lists '" + std::string(name) + "' have up to " +
      std::to_string(greatest) + " values; their lengths are written as int instead of uchar");
  }
  return std::string("property list ") + (isLong ? "int" : "uchar") + " int " + name + "\n";
}

//------------------------------------------------------------------------------
void Writing::WriteHeader()
{
  const char* const real = this->IsDouble ? "property double " : "property float ";
  const auto element = [](const char* name, vtkIdType count)
  { return "element " + std::string(name) + " " + std::to_string(count) + "\n"; };
  const std::string cellProperties = this->CellColumns.GetProperties();

  std::string header = "ply\nformat " +
    std::string(PLYEncodingNames[static_cast<int>(this->Options.Encoding)]) + " 1.0\n" +
    this->PointColumns.GetComments() + this->CellColumns.GetComments();
  const bool hasCells = this->Shared && this->Shared->Polyhedra.Count > 0;
  if (hasCells && !this->CellColumns.IsEmpty())
  {
    header += std::string("comment ") + BlankFacesOfCells + "\n";
  }
  header += element("vertex", this->Output.GetNumberOfPoints());
  for (const char* axis : { "x\n", "y\n", "z\n" })
  {
    header += real;
    header += axis;
  }
  header += this->PointColumns.GetProperties();
  const vtkIdType faces =
    this->GetNumberOfFaceCells() + (this->Shared ? this->Shared->Polygons.Count : 0);
  std::string edges;
  if (!this->EdgeCells.empty())
  {
    edges = element("edge", static_cast<vtkIdType>(this->EdgeCells.size())) +
      "property int vertex1\nproperty int vertex2\n" + cellProperties;
  }
  header += this->EdgesFirst ? edges : "";
  if (faces > 0)
  {
    header += element("face", faces) + this->GetListType("vertex_indices", this->GreatestFace) +
      cellProperties;
  }
  if (hasCells)
  {
    header += element("cell", this->Shared->Polyhedra.Count) +
      this->GetListType("face_indices", this->GreatestCell) + cellProperties;
  }
  header += this->EdgesFirst ? "" : edges;
  this->File.Write(header + "end_header\n");
}

//------------------------------------------------------------------------------
bool Writing::WritePoints(const Progress& progress)
{
  return WriteRows(this->File, this->Output.GetNumberOfPoints(), progress,
    [&](vtkIdType point, std::string& bytes)
    {
      double x[3];
      this->Output.GetPoint(point, x);
      if (this->IsDouble)
      {
        this->Encoder.Append<double>(bytes, 3, [&x](std::ptrdiff_t c) { return x[c]; });
      }
      else
      {
        this->Encoder.Append<float>(
          bytes, 3, [&x](std::ptrdiff_t c) { return static_cast<float>(x[c]); });
      }
      this->PointColumns.Append(this->Encoder, bytes, this->Output.GetInputPoint(point));
      this->Encoder.EndRow(bytes);
    });
}

//------------------------------------------------------------------------------
// Writes the cells that are faces, or edges, which have no lists.
bool Writing::WriteCells(bool areEdges, const Progress& progress)
{
  const auto edges = static_cast<vtkIdType>(this->EdgeCells.size());
  return WriteRows(this->File, areEdges ? edges : this->GetNumberOfFaceCells(), progress,
    [&](vtkIdType row, std::string& bytes)
    {
      const vtkIdType cell = areEdges ? this->EdgeCells[row]
        : this->AreAllFaces           ? row
                                      : this->FaceCells[row];
      const IndexRange points = this->Output.GetCellPoints(cell);
      if (!areEdges)
      {
        this->AppendLength(bytes, points.Size, this->GreatestFace);
      }
      this->Encoder.Append<std::int32_t>(
        bytes, points.Size, [&points](vtkIdType i) { return points[i]; });
      this->CellColumns.Append(this->Encoder, bytes, this->Output.GetInputCell(cell));
      this->Encoder.EndRow(bytes);
    });
}

//------------------------------------------------------------------------------
// Writes the polygons or polyhedra that share faces. A face of a 3D cell has no values of its own.
bool Writing::WriteLists(const WordLists& lists, bool areFaces, const Progress& progress)
{
  const SharedFaces& shared = *this->Shared;
  std::vector<vtkIdType> firstRows(1, 0);
  for (vtkIdType chunk = 0; chunk < lists.GetNumberOfChunks(); ++chunk)
  {
    vtkIdType rows = firstRows.back();
    for (vtkIdType at = lists.Starts[chunk]; at < lists.Starts[chunk + 1];
      at += 1 + lists.Words[at])
    {
      ++rows;
    }
    firstRows.push_back(rows);
  }
  std::vector<std::int32_t> polyhedra; // cells of the mesh
  for (vtkIdType cell = 0; !areFaces && cell < shared.GetMesh().GetNumberOfCells(); ++cell)
  {
    if (shared.GetRole(cell) == FaceRole::Polyhedron)
    {
      polyhedra.push_back(static_cast<std::int32_t>(cell));
    }
  }
  const vtkIdType greatest = areFaces ? this->GreatestFace : this->GreatestCell;
  return WriteChunks(this->File, lists.GetNumberOfChunks(), progress,
    [&](vtkIdType chunk, std::string& bytes)
    {
      vtkIdType row = firstRows[chunk];
      const std::int32_t* word = lists.Words.data() + lists.Starts[chunk];
      const std::int32_t* const end = lists.Words.data() + lists.Starts[chunk + 1];
      for (; word < end; ++row)
      {
        const std::int32_t size = *word++;
        this->AppendLength(bytes, size, greatest);
        this->Encoder.Append<std::int32_t>(bytes, size, [&](std::ptrdiff_t i)
          { return areFaces ? this->Output.GetPointOf(word[i]) : vtkIdType(word[i]); });
        word += size;
        const vtkIdType cell = areFaces ? shared.CellOfPolygon[row] : polyhedra[row];
        const bool isFace = areFaces && shared.GetRole(cell) == FaceRole::Polyhedron;
        this->CellColumns.Append(this->Encoder, bytes, isFace ? -1 : cell);
        this->Encoder.EndRow(bytes);
      }
    });
}

//------------------------------------------------------------------------------
bool Writing::Write(const std::string& path, ScanError& error, const Progress& progress)
{
  this->PlanArrays();
  if (!ConvertCells(this->Mesh, GetConversion(this->Options), path, this->Output, this->Messages,
        error, progress.Part(0, 0.3)))
  {
    return false;
  }
  if (std::max(this->Output.GetNumberOfPoints(), this->Output.GetNumberOfCells()) > INT32_MAX)
  {
    throw std::length_error("more vertices or cells than PLY files can number");
  }
  this->IsDouble = !this->Output.HasFloatPoints() && !this->Options.FloatCoordinates;
  if (this->Options.FloatCoordinates &&
    !CheckSinglePrecision(this->Mesh, path, this->Messages, error))
  {
    return false;
  }
  this->SortCells();
  if (this->Options.Cells)
  {
    this->ShareFaces();
    WarnOfInvertedCells(this->Mesh, "PLY", this->Messages);
  }
  this->WarnOfOrder();
  this->WriteHeader();
  bool good = this->WritePoints(progress.Part(0.3, 0.5)) &&
    (!this->EdgesFirst || this->WriteCells(true, progress.Part(0.5, 0.55)));
  if (this->Shared)
  {
    good = good && this->WriteLists(this->Shared->Polygons, true, progress.Part(0.55, 0.8));
  }
  good = good && this->WriteCells(false, progress.Part(0.55, 0.9));
  if (this->Shared)
  {
    good = good && this->WriteLists(this->Shared->Polyhedra, false, progress.Part(0.9, 0.95));
  }
  return good && (this->EdgesFirst || this->WriteCells(true, progress.Part(0.95, 1)));
}
}
}

vtkStandardNewMacro(vtkPolygonPLYWriter);

//------------------------------------------------------------------------------
int vtkPolygonPLYWriter::GetDigitsOfCoordinates() const
{
  return this->Coordinates == FLOAT ? camaron::DigitsOfFloat : camaron::AllDigits;
}

//------------------------------------------------------------------------------
bool vtkPolygonPLYWriter::WriteMesh(const std::string& path, vtkDataSet* mesh,
  camaron::Warnings& warnings, camaron::ScanError& error, const camaron::Progress& progress)
{
  const camaron::PLYWriteOptions options = { static_cast<camaron::PLYEncoding>(this->Encoding),
    this->Coordinates == FLOAT, this->WriteCells, this->GetOtherCells(), this->GetSurfaceFaces() };
  camaron::OutputFile file(path);
  const bool good = !file.HasFailed() &&
    camaron::Writing(file, mesh, options, warnings).Write(path, error, progress);
  return file.Finish(good, error);
}

//------------------------------------------------------------------------------
void vtkPolygonPLYWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Encoding: " << this->Encoding << "\n";
  os << indent << "Coordinates: " << this->Coordinates << "\n";
  os << indent << "WriteCells: " << this->WriteCells << "\n";
}
