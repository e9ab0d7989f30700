// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetGenWriter.h"

#include "Intake/CellMesh/CellConversion.h"
#include "Intake/CellMesh/OutputMesh.h"
#include "Intake/CellMesh/OutputWarnings.h"
#include "Intake/Write/RealFormat.h"
#include "Intake/Write/WriteRows.h"
#include "Mesh/BoundarySurface.h"
#include "Mesh/CellShape.h"
#include "TetGenArrays.h"
#include "TetGenFiles.h"
#include "TetGenMidpoints.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// All elements of a file have the same number of nodes. Quadratic ones are kept if there are no
// linear elements of the same dimension.
CellTypeSet ChooseTypes(const MeshView& mesh)
{
  std::array<vtkIdType, 256> counts{};
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    ++counts[mesh.GetCellType(cell)];
  }
  bool hasOther[4] = { false, false, false, false };
  for (int type = 0; type < 256; ++type)
  {
    const int dimension = GetCellShape(static_cast<unsigned char>(type)).Dimension;
    if (counts[type] > 0 && dimension >= 2 && type != VTK_QUADRATIC_TETRA &&
      type != VTK_QUADRATIC_TRIANGLE)
    {
      hasOther[dimension] = true;
    }
  }
  return { hasOther[3] || counts[VTK_QUADRATIC_TETRA] == 0 ? VTK_TETRA : VTK_QUADRATIC_TETRA,
    hasOther[2] || counts[VTK_QUADRATIC_TRIANGLE] == 0 ? VTK_TRIANGLE : VTK_QUADRATIC_TRIANGLE };
}

//------------------------------------------------------------------------------
// Some of the cells of a mesh.
struct CellList
{
  vtkIdType Size = 0;
  int Corners = 4;
  int NumberOfNodes = 4;
  std::vector<vtkIdType> Cells; ///< empty if it is all
  vtkIdType operator[](vtkIdType i) const { return this->Cells.empty() ? i : this->Cells[i]; }
};

CellList ListCells(const OutputMesh& mesh, int corners)
{
  CellList list;
  list.Corners = corners;
  const unsigned char linear = corners == 4 ? VTK_TETRA : VTK_TRIANGLE;
  const unsigned char quadratic = corners == 4 ? VTK_QUADRATIC_TETRA : VTK_QUADRATIC_TRIANGLE;
  const vtkIdType quadratics = mesh.Count(quadratic);
  list.Size = mesh.Count(linear) + quadratics;
  list.NumberOfNodes = quadratics == 0 ? corners : corners == 4 ? 10 : 6;
  if (list.Size < mesh.GetNumberOfCells())
  {
    list.Cells.reserve(static_cast<std::size_t>(list.Size));
    for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
    {
      if (mesh.GetCellType(cell) == linear || mesh.GetCellType(cell) == quadratic)
      {
        list.Cells.push_back(cell);
      }
    }
  }
  return list;
}

//------------------------------------------------------------------------------
bool IsFlat(const OutputMesh& mesh)
{
  double x[3] = { 0, 0, 0 };
  for (vtkIdType point = 0; point < mesh.GetNumberOfPoints() && x[2] == 0; ++point)
  {
    mesh.GetPoint(point, x);
  }
  return x[2] == 0;
}

//------------------------------------------------------------------------------
class TetGenWriting
{
public:
  TetGenWriting(
    vtkDataSet* mesh, const OutputMesh& output, int firstId, bool withArrays, bool withBoundary)
    : Mesh(mesh)
    , Output(output)
    , FirstId(firstId)
    , WithArrays(withArrays)
    , WithBoundary(withBoundary)
    , Elements(ListCells(output,
        output.Count(VTK_TETRA) + output.Count(VTK_QUADRATIC_TETRA) > 0 ||
            output.GetNumberOfCells() == 0
          ? 4
          : 3))
  {
    if (this->Elements.Corners == 4)
    {
      this->Faces = ListCells(output, 3);
    }
    if (withArrays)
    {
      this->PointArrays = TetGenArrays(mesh->GetPointData(), "attr_0", true);
    }
    if (withArrays && this->Elements.Size > 0)
    {
      this->CellArrays = TetGenArrays(mesh->GetCellData(), "Region", this->HasFaces());
    }
  }

  bool Write(const std::string& path, ScanError& error, const Progress& progress);
  void Warn(const std::string& path, Warnings& warnings) const;

private:
  void WarnOfLostValues(Warnings& warnings) const;
  bool HasFaces() const { return this->Elements.Corners == 4 && this->Faces.Size > 0; }
  bool HasBoundary() const
  {
    return this->WithBoundary && !this->HasFaces() && this->Elements.Corners == 4;
  }
  void AppendCell(std::string& text, const CellList& list, vtkIdType number) const;
  bool WriteNodes(OutputFile& file, const Progress& progress) const;
  bool WriteElements(OutputFile& file, const Progress& progress) const;
  bool WriteFaces(OutputFile& file, const Progress& progress) const;
  bool WriteBoundary(OutputFile& file, const Progress& progress) const;
  vtkSmartPointer<vtkDataSet> MakeGrid() const;

  vtkDataSet* Mesh;
  const OutputMesh& Output;
  int FirstId;
  bool WithArrays;   ///< attributes, regions and markers
  bool WithBoundary; ///< of tetrahedra, if the mesh has no triangles
  CellList Elements, Faces;
  TetGenArrays PointArrays, CellArrays;
};

//------------------------------------------------------------------------------
bool TetGenWriting::WriteNodes(OutputFile& file, const Progress& progress) const
{
  const bool isFlat =
    this->Elements.Corners == 3 && this->Elements.Size > 0 && IsFlat(this->Output);
  const int dimension = isFlat ? 2 : 3;
  const RealFormat format = RealFormat::Shortest(this->Output.HasFloatPoints());
  file.Write(std::to_string(this->Output.GetNumberOfPoints()) + " " + std::to_string(dimension) +
    " " + std::to_string(this->PointArrays.GetNumberOfAttributes()) +
    (this->PointArrays.HasMarkers() ? " 1\n" : " 0\n"));
  return WriteRows(file, this->Output.GetNumberOfPoints(), progress,
    [&](vtkIdType point, std::string& text)
    {
      double x[3];
      this->Output.GetPoint(point, x);
      AppendNumber(text, point + this->FirstId);
      for (int c = 0; c < dimension; ++c)
      {
        text += ' ';
        format.Append(text, x[c]);
      }
      const vtkIdType tuple = this->Output.GetInputPoint(point);
      this->PointArrays.AppendAttributes(text, tuple);
      this->PointArrays.AppendMarker(text, tuple);
      text += '\n';
    });
}

//------------------------------------------------------------------------------
// Appends the id of a cell and its nodes in the order of the file.
void TetGenWriting::AppendCell(std::string& text, const CellList& list, vtkIdType number) const
{
  const IndexRange nodes = this->Output.GetCellPoints(list[number]);
  AppendNumber(text, number + this->FirstId);
  const TetGenMidpointOrder order = GetUsualMidpointOrder(list.Corners);
  vtkIdType ids[10];
  for (int i = 0; i < list.NumberOfNodes; ++i)
  {
    ids[i < list.Corners ? i : list.Corners + order[i - list.Corners]] = nodes[i];
  }
  for (int i = 0; i < list.NumberOfNodes; ++i)
  {
    text += ' ';
    AppendNumber(text, ids[i] + this->FirstId);
  }
}

//------------------------------------------------------------------------------
bool TetGenWriting::WriteElements(OutputFile& file, const Progress& progress) const
{
  const CellList& list = this->Elements;
  file.Write(std::to_string(list.Size) + " " + std::to_string(list.NumberOfNodes) + " " +
    std::to_string(this->CellArrays.GetNumberOfAttributes()) + "\n");
  return WriteRows(file, list.Size, progress,
    [&](vtkIdType number, std::string& text)
    {
      this->AppendCell(text, list, number);
      this->CellArrays.AppendAttributes(text, this->Output.GetInputCell(list[number]));
      text += '\n';
    });
}

//------------------------------------------------------------------------------
bool TetGenWriting::WriteFaces(OutputFile& file, const Progress& progress) const
{
  file.Write(std::to_string(this->Faces.Size) + (this->CellArrays.HasMarkers() ? " 1\n" : " 0\n"));
  return WriteRows(file, this->Faces.Size, progress,
    [&](vtkIdType number, std::string& text)
    {
      this->AppendCell(text, this->Faces, number);
      this->CellArrays.AppendMarker(text, this->Output.GetInputCell(this->Faces[number]));
      text += '\n';
    });
}

//------------------------------------------------------------------------------
// The tetrahedra that are written, by their vertices only.
vtkSmartPointer<vtkDataSet> TetGenWriting::MakeGrid() const
{
  const vtkIdType size = this->Elements.Size;
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfValues(4 * size);
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    const IndexRange nodes = this->Output.GetCellPoints(this->Elements[cell]);
    for (int i = 0; i < 4; ++i)
    {
      ids->SetValue(4 * cell + i, nodes[i]);
    }
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(4, ids);
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(this->Output.GetNumberOfPoints());
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(VTK_TETRA, cells);
  return grid;
}

//------------------------------------------------------------------------------
bool TetGenWriting::WriteBoundary(OutputFile& file, const Progress& progress) const
{
  vtkNew<vtkPolyData> surface;
  MakeBoundarySurface(this->MakeGrid(), surface);
  vtkDataArray* const original = surface->GetPointData()->GetArray("vtkOriginalPointIds");
  const MeshView view(surface);
  file.Write(std::to_string(view.GetNumberOfCells()) + " 1\n");
  constexpr char OnBoundary[] = " 1\n"; // the marker that TetGen uses
  return WriteRows(file, view.GetNumberOfCells(), progress,
    [&](vtkIdType number, std::string& text)
    {
      const IndexRange corners = view.GetCellPoints(number);
      AppendNumber(text, number + this->FirstId);
      for (vtkIdType i = 0; i < corners.Size; ++i)
      {
        text += ' ';
        AppendNumber(
          text, static_cast<vtkIdType>(original->GetComponent(corners[i], 0)) + this->FirstId);
      }
      text += OnBoundary;
    });
}

//------------------------------------------------------------------------------
bool TetGenWriting::Write(const std::string& path, ScanError& error, const Progress& progress)
{
  const auto target = [&path](TetGenKind kind)
  { return GetTetGenKind(path) == kind ? path : GetTetGenCompanion(path, kind); };
  OutputFile nodes(target(TetGenKind::Node));
  OutputFile elements(target(TetGenKind::Ele));
  std::vector<OutputFile*> files{ &nodes, &elements };
  std::unique_ptr<OutputFile> faces;
  bool good = this->WriteNodes(nodes, progress.Part(0, 0.4)) &&
    this->WriteElements(elements, progress.Part(0.4, 0.8));
  if (good && (this->HasFaces() || this->HasBoundary()))
  {
    faces = std::make_unique<OutputFile>(target(TetGenKind::Face));
    files.push_back(faces.get());
    good = this->HasFaces() ? this->WriteFaces(*faces, progress.Part(0.8, 1))
                            : this->WriteBoundary(*faces, progress.Part(0.8, 1));
  }
  for (OutputFile* file : files)
  {
    good = good && file->Close();
  }
  for (OutputFile* file : files)
  {
    good = good && file->Commit();
    error = error ? error : file->GetError();
  }
  return good;
}

//------------------------------------------------------------------------------
// With triangles and tetrahedra, the .ele file cannot store markers, and the .face file nothing
// else.
void TetGenWriting::WarnOfLostValues(Warnings& warnings) const
{
  const auto count = [this](const CellList& list, auto&& isLost)
  {
    Tally tally;
    vtkIdType last = -1; // a cell may have been cut into several ones, which are consecutive
    for (vtkIdType i = 0; this->HasFaces() && i < list.Size; ++i)
    {
      const vtkIdType cell = this->Output.GetInputCell(list[i]);
      if (cell != last && isLost(cell))
      {
        tally.Add(cell);
      }
      last = cell;
    }
    return tally;
  };
  const Tally triangles =
    count(this->Faces, [this](vtkIdType cell) { return this->CellArrays.HasAttributes(cell); });
  const Tally tetrahedra =
    count(this->Elements, [this](vtkIdType cell) { return this->CellArrays.HasMarker(cell); });
  warnings.Add(triangles, "cell", "cells",
    "written as a face, with nonzero values other than BoundaryMarker, which TetGen cannot store",
    FromZero);
  warnings.Add(tetrahedra, "cell", "cells",
    "written as an element, with a BoundaryMarker, which TetGen cannot store", FromZero);
}

//------------------------------------------------------------------------------
void TetGenWriting::Warn(const std::string& path, Warnings& warnings) const
{
  if (this->WithArrays)
  {
    WrittenArrays written;
    this->PointArrays.AddNames(written.Points);
    this->CellArrays.AddNames(written.Cells);
    WarnOfArrays(this->Mesh, "TetGen", warnings, written);
    const std::string points = this->PointArrays.DescribeRenamed();
    const std::string cells = this->CellArrays.DescribeRenamed();
    if (!points.empty() || !cells.empty())
    {
      warnings.Add("TetGen files store attributes without names; the reader will show " + points +
        (points.empty() || cells.empty() ? "" : ", ") + cells);
    }
  }
  this->WarnOfLostValues(warnings);
  std::string old;
  for (const TetGenKind kind : { TetGenKind::Face, TetGenKind::Edge, TetGenKind::Neigh })
  {
    const bool isWritten = kind == TetGenKind::Face && (this->HasFaces() || this->HasBoundary());
    if (!isWritten && HasTetGenCompanion(path, kind))
    {
      old += (old.empty() ? "" : ", ") + GetFileName(GetTetGenCompanion(path, kind));
    }
  }
  if (!old.empty())
  {
    warnings.Add("existing companion files do not belong to this mesh: " + old);
  }
}
}
}

using namespace camaron;

vtkStandardNewMacro(vtkTetGenWriter);

//------------------------------------------------------------------------------
bool vtkTetGenWriter::WriteMesh(const std::string& path, vtkDataSet* mesh,
  camaron::Warnings& warnings, camaron::ScanError& error, const camaron::Progress& progress)
{
  const TetGenKind kind = GetTetGenKind(path);
  if (kind != TetGenKind::Node && kind != TetGenKind::Ele && kind != TetGenKind::None)
  {
    error = { ErrorKind::Unsupported,
      camaron::GetFileName(path) +
        ": expected a name that ends with .node or .ele; a .face file is written in addition if "
        "there are triangles as well as tetrahedra" };
    return false;
  }
  // For other extensions, that of TetGen is appended.
  const std::string target = kind == TetGenKind::None ? path + ".ele" : path;
  const CellConversion how{ "TetGen", ChooseTypes(MeshView(mesh)), this->GetOtherCells() };
  OutputMesh output;
  if (!ConvertCells(mesh, how, path, output, warnings, error, progress.Part(0, 0.3)))
  {
    return false;
  }
  TetGenWriting writing(mesh, output, this->FirstId, this->WriteArrays, this->WriteBoundaryFaces);
  if (!writing.Write(target, error, progress.Part(0.3, 1)))
  {
    return false;
  }
  writing.Warn(target, warnings);
  return true;
}

//------------------------------------------------------------------------------
void vtkTetGenWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FirstId: " << this->FirstId << "\n";
  os << indent << "WriteArrays: " << this->WriteArrays << "\n";
  os << indent << "WriteBoundaryFaces: " << this->WriteBoundaryFaces << "\n";
}
