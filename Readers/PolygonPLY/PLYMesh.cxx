// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PLYMesh.h"

#include "Base/Text.h"
#include "Intake/CellMesh/CellGrid.h"
#include "Intake/FaceMesh/FaceTables.h"
#include "Intake/FaceMesh/GridBuilder.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr char Vertex[] = "vertex";
constexpr std::int32_t MostItems = 1024; ///< of lists that become components
constexpr std::int64_t MostPadding = 2;  ///< array values per list value

//------------------------------------------------------------------------------
std::vector<PLYArrayPlan> Plan(const PLYPart& part, const PLYHeader& header)
{
  const PLYSubject subject = part.Role == PLYRole::Points ? PLYSubject::Points
    : part.Role == PLYRole::None                          ? PLYSubject::Other
                                                          : PLYSubject::Cells;
  return PlanArrays(part.Element, subject, header.Components, part.Used, part.Lists);
}

//------------------------------------------------------------------------------
// Reads arrays of which the rows set all tuples.
bool ReadArrays(PLYArrays& arrays, vtkIdType tuples, std::vector<PLYArrayPlan>& plans,
  TableRows& rows, const TableTargets& targets, const Progress& progress)
{
  arrays.Add(plans);
  arrays.Allocate(tuples, true);
  return rows.ReadColumns(arrays.GetColumns(plans), targets, progress);
}
}

//------------------------------------------------------------------------------
PLYPart* PLYMesh::FindPart(PLYRole role)
{
  for (PLYPart& part : this->Parts)
  {
    if (part.Role == role)
    {
      return &part;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
// Determines the arrays of lists that are not points or faces, and warns about losses.
bool PLYMesh::ShapeLists(PLYPart& part, const Progress& progress)
{
  const PLYElement& element = part.Element;
  part.Lists.assign(element.Properties.size(), PLYListShape());
  for (std::size_t i = 0; i < element.Properties.size() && element.Count > 0; ++i)
  {
    if (!element.Properties[i].IsList || part.Used[i])
    {
      continue;
    }
    ListSizes sizes;
    if (!part.Rows->ReadSizes(static_cast<int>(i), sizes, progress))
    {
      return false;
    }
    std::int32_t least = sizes.Common, most = sizes.Common;
    for (vtkIdType row = 0; sizes.Common < 0 && row < element.Count; ++row)
    {
      const auto size = static_cast<std::int32_t>(sizes.GetSize(row));
      least = row == 0 ? size : std::min(least, size);
      most = std::max(most, size);
    }
    const std::string what = "the lists " + QuoteWord(element.Properties[i].Name) + " of " +
      CountOf(element.Count, "element ", "elements ") + QuoteWord(element.Name);
    if (most > MostItems || std::int64_t(most) * element.Count > MostPadding * sizes.Total)
    {
      this->Messages.Add(what + ", of " + std::to_string(least) + " to " + std::to_string(most) +
        " values, are omitted, as arrays need the same number of values for all");
      continue;
    }
    part.Lists[i] = { most, least < most };
    if (least < most)
    {
      this->Messages.Add(what + " become an array with " + std::to_string(most) +
        " components, padded with nan (0 for integers) for shorter lists; another array has their "
        "lengths");
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void PLYMesh::WarnOfCells(const std::vector<PLYPart*>& parts)
{
  Tally empty, few;
  for (const PLYPart* part : parts)
  {
    empty.Merge(part->Few[0]);
    for (int size = 1; size < 3 && part->Role == PLYRole::Faces; ++size)
    {
      few.Merge(part->Few[size]);
    }
  }
  this->Messages.Add(empty, "list", "lists", "without vertices, omitted");
  this->Messages.Add(few, "face", "faces", "with fewer than 3 vertices");
}

//------------------------------------------------------------------------------
// Reads the arrays of cells; sets the targets that depend on the part.
bool PLYMesh::ReadCellArrays(const std::vector<PLYPart*>& parts, vtkIdType tuples,
  const TableTargets& targets, PLYArrays& arrays, const Progress& progress)
{
  std::vector<std::vector<PLYArrayPlan>> plans;
  for (const PLYPart* part : parts)
  {
    plans.push_back(Plan(*part, this->Header));
    if (part->Role == PLYRole::Strips && !plans.back().empty())
    {
      this->Messages.Add("the values of triangle strips are omitted");
      plans.back().clear();
    }
    arrays.Add(plans.back());
  }
  if (arrays.IsEmpty())
  {
    return true;
  }
  // Faces of polyhedra come after the cells, in another order.
  const bool isCovered = parts.size() == 1 && parts[0]->Role == PLYRole::Faces;
  arrays.Allocate(tuples, isCovered);
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const PLYPart& part = *parts[i];
    TableTargets own = targets;
    own.First = part.FirstCell;
    own.Items = part.Items.size() > 0 ? part.Items.data() : nullptr;
    if (!part.Rows->ReadColumns(arrays.GetColumns(plans[i]), own, progress))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool PLYMesh::ReadCells(const Progress& progress)
{
  const PLYPart& vertices = *this->FindPart(PLYRole::Points);
  const vtkIdType numberOfPoints = vertices.Rows->GetCount();
  std::vector<PLYArrayPlan> plans = Plan(vertices, this->Header);
  std::vector<PLYPart*> parts;
  for (PLYPart& part : this->Parts)
  {
    if (part.Role != PLYRole::None && part.Role != PLYRole::Points && part.Rows->GetCount() > 0)
    {
      parts.push_back(&part);
    }
  }
  CellLists cells;
  CellMeshPiece piece;
  piece.SetPoints([&](const PieceOfSpace::Visit& visit)
    { return vertices.Rows->ForEachPoint(plans[0].Properties, visit); });
  if (!parts.empty() &&
    !cells.Read({ parts.begin(), parts.end() }, numberOfPoints, false, this->Request, piece,
      progress.Part(0, 0.5)))
  {
    return false;
  }
  this->WarnOfCells(parts);
  if (cells.NumberOfCells == 0)
  {
    parts.clear();
    if (!MakeCloud(numberOfPoints, this->Request, piece, cells.Mesh))
    {
      return false;
    }
  }
  PLYArrays pointArrays, cellArrays;
  TableTargets points, cellTargets;
  points.Kept = piece.IsWhole() ? nullptr : &piece.GetPoints();
  cellTargets.Kept = piece.IsWhole() ? nullptr : &piece.GetCells();
  if (!ReadArrays(pointArrays, piece.GetNumberOfPoints(), plans, *vertices.Rows, points,
        progress.Part(0.5, 0.8)) ||
    !this->ReadCellArrays(
      parts, piece.GetNumberOfCells(), cellTargets, cellArrays, progress.Part(0.8, 0.95)))
  {
    return false;
  }
  const vtkSmartPointer<vtkDataArray> coordinates = pointArrays.Get(plans[0].Name);
  if (this->Request.Piece == 0 && !parts.empty())
  {
    piece.WarnOfRepeatedPoints(cells.Mesh, this->Messages, progress.Part(0.95, 1));
  }
  FillGrid(cells.Mesh, piece, coordinates, this->Grid);
  pointArrays.MoveTo(this->Grid->GetPointData());
  cellArrays.MoveTo(this->Grid->GetCellData());
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
bool PLYMesh::ReadPolyhedra(const Progress& progress)
{
  PLYPart& vertices = *this->FindPart(PLYRole::Points);
  const vtkIdType numberOfPoints = vertices.Rows->GetCount();
  // Cells refer to faces by number; all other elements come after these.
  PLYPart* const facePart = this->FindPart(PLYRole::Faces);
  std::vector<PLYPart*> faceParts, cellParts;
  if (facePart)
  {
    faceParts.push_back(facePart);
  }
  for (PLYPart& part : this->Parts)
  {
    if (part.Role == PLYRole::Polyhedra)
    {
      cellParts.push_back(&part);
    }
    else if (part.Role != PLYRole::None && part.Role != PLYRole::Points && &part != facePart)
    {
      faceParts.push_back(&part);
    }
  }
  CellLists faces, cells;
  CellMeshPiece whole;
  const vtkIdType referable = facePart ? facePart->Rows->GetCount() : 0;
  if (!faces.Read({ faceParts.begin(), faceParts.end() }, numberOfPoints, true, {}, whole,
        progress.Part(0, 0.2)) ||
    !cells.Read(
      { cellParts.begin(), cellParts.end() }, referable, true, {}, whole, progress.Part(0.2, 0.3)))
  {
    return false;
  }
  this->WarnOfCells(faceParts);

  FaceMesh mesh;
  const vtkIdType numberOfFaces = faces.Mesh.NumberOfCells;
  const vtkIdType numberOfCells = cells.Mesh.NumberOfCells;
  IdLists::Expectation faceLists = mesh.ExpectFaces(numberOfPoints, this->Request);
  IdLists::Expectation cellLists = mesh.ExpectCells(numberOfFaces);
  const auto open = [&](CellMesh& from, IdLists& lists, IdLists::Expectation& expected)
  {
    return lists.Open(std::move(from.Connectivity), std::move(from.Offsets), from.CommonSize,
      from.NumberOfCells, expected, progress.Part(0.3, 0.4));
  };
  if (!open(faces.Mesh, mesh.Faces, faceLists) || !open(cells.Mesh, mesh.Cells, cellLists))
  {
    return false;
  }
  mesh.HasEmptyFaces = faceLists.Empty.Count > 0;
  if (this->Request.Piece == 0)
  {
    this->Messages.Add(faceLists.Repeating, "face", "faces", "with the same vertex more than once");
    this->Messages.Add(cellLists.Empty, "cell", "cells", "without faces");
  }

  // The coordinates of all points, as they determine the shapes of cells; other arrays when their
  // targets are known.
  std::vector<PLYArrayPlan> plans = Plan(vertices, this->Header);
  const PLYArrayPlan pointPlan = plans[0];
  plans.erase(plans.begin());
  const std::vector<int>& of = pointPlan.Properties;
  if (!ReadPoints(
        *vertices.Rows, pointPlan.Type, { of[0], of[1], of[2] }, mesh, progress.Part(0.4, 0.5)))
  {
    return false;
  }
  const vtkIdType kept = this->NumberFaces(mesh, faceParts, numberOfCells);
  if (!BuildGrid(
        mesh, this->Request, this->Grid, this->Messages, this->Error, progress.Part(0.5, 0.9)))
  {
    return false;
  }

  TableTargets points, items;
  Buffer<std::int32_t> pointPlaces, itemPlaces;
  if (this->Request.NumberOfPieces > 1)
  {
    pointPlaces = FindPlaces(this->Grid->GetPointData(), numberOfPoints);
    itemPlaces = FindPlaces(this->Grid->GetCellData(), kept);
    points.Places = pointPlaces.data();
    items.Places = itemPlaces.data();
  }
  PLYArrays pointArrays, cellArrays;
  cellParts.insert(cellParts.end(), faceParts.begin(), faceParts.end());
  if (!ReadArrays(pointArrays, this->Grid->GetNumberOfPoints(), plans, *vertices.Rows, points,
        progress.Part(0.9, 0.95)) ||
    !this->ReadCellArrays(
      cellParts, this->Grid->GetNumberOfCells(), items, cellArrays, progress.Part(0.95, 1)))
  {
    return false;
  }
  pointArrays.MoveTo(this->Grid->GetPointData());
  cellArrays.MoveTo(this->Grid->GetCellData());
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
// Determines the items of the mesh for the rows of faces: those of no cell come after the cells,
// the others have none. Returns the number of items.
vtkIdType PLYMesh::NumberFaces(
  const FaceMesh& mesh, const std::vector<PLYPart*>& faceParts, vtkIdType numberOfCells)
{
  vtkIdType item = numberOfCells;
  vtkIdType lost = 0;
  std::vector<std::int32_t> items;
  items.reserve(static_cast<std::size_t>(mesh.Faces.GetCount()));
  mesh.Faces.ForEachInOrder(
    [&](vtkIdType face, const IdList& list)
    {
      const bool isOwned = mesh.FacesOfCells.Contains(face);
      lost += isOwned ? 1 : 0;
      items.push_back(isOwned || list.Size == 0 ? -1 : static_cast<std::int32_t>(item++));
    });
  for (PLYPart* part : faceParts)
  {
    part->Items = Buffer<std::int32_t>(part->NumberOfCells);
    std::copy_n(items.begin() + part->FirstCell, part->NumberOfCells, part->Items.data());
  }
  const bool hasValues = !faceParts.empty() && !Plan(*faceParts[0], this->Header).empty();
  if (lost > 0 && hasValues && !this->Header.FacesOfCellsAreBlank)
  {
    this->Messages.Add("the values of " + CountOf(lost, "face that belongs", "faces that belong") +
      " to cells are omitted");
  }
  return item;
}

//------------------------------------------------------------------------------
// Reads elements other than points and cells; every piece gets all of them as field data.
bool PLYMesh::ReadOthers(const Progress& progress)
{
  for (PLYPart& part : this->Parts)
  {
    std::vector<PLYArrayPlan> plans = Plan(part, this->Header);
    if (part.Role == PLYRole::None && !plans.empty())
    {
      PLYArrays arrays;
      if (!ReadArrays(arrays, part.Rows->GetCount(), plans, *part.Rows, TableTargets(), progress))
      {
        return false;
      }
      arrays.MoveTo(this->Grid->GetFieldData(), part.Element.Name + ".");
    }
    if (!part.Rows->Check(progress))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool PLYMesh::Read(TableScanner& scanner, RowLayout layout, const Progress& progress)
{
  this->Grid->Initialize();
  this->Messages = Warnings();
  this->Error = ScanError();
  this->Parts.clear();
  for (const std::string& oddity : this->Header.Oddities)
  {
    this->Messages.Add(oddity);
  }
  for (const PLYElement& element : this->Header.Elements)
  {
    this->Parts.push_back(MakePart(element, this->FindPart(PLYRole::Points) != nullptr));
    PLYPart& part = this->Parts.back();
    if (!scanner.Locate(part.Rows, part.Element, progress.Part(0, 0.2), layout) ||
      !this->ShapeLists(part, progress.Part(0, 0.2)))
    {
      return false;
    }
  }

  PLYPart* const vertices = this->FindPart(PLYRole::Points);
  bool good = true;
  if (!vertices)
  {
    this->Messages.Add("the file has no element 'vertex', so there is nothing to show");
  }
  else
  {
    const PLYElement& element = vertices->Element;
    if (element.Find({ "x" }, false) < 0 || element.Find({ "y" }, false) < 0)
    {
      this->Error = { ErrorKind::Unsupported,
        "expected the properties 'x', 'y' and 'z' of the element 'vertex', found none of these "
        "names" };
      return false;
    }
    if (element.Find({ "z" }, false) < 0)
    {
      this->Messages.Add("vertices have no property 'z'; 0 is assumed");
    }
    const PLYPart* const cells = this->FindPart(PLYRole::Polyhedra);
    good = cells && cells->Rows->GetCount() > 0 ? this->ReadPolyhedra(progress.Part(0.2, 0.95))
                                                : this->ReadCells(progress.Part(0.2, 0.95));
  }
  good = good && this->ReadOthers(progress.Part(0.95, 1));
  for (const PLYPart& part : this->Parts)
  {
    const std::string name = "row of " + QuoteWord(part.Element.Name);
    const std::string names = "rows of " + QuoteWord(part.Element.Name);
    this->Messages.Add(part.Rows->GetLongRows(), name.c_str(), names.c_str(),
      "with more values than the header declares");
    if (const vtkIdType odd = part.Rows->CountOddColors())
    {
      this->Messages.Add(CountOf(odd, "color value", "color values") + " of " +
        QuoteWord(part.Element.Name) +
        " outside 0 to 1, or 0 to 255 for integers, clamped to this range");
    }
  }
  return good && !progress.IsStopped();
}
}
