// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentMesh.h"

#include "Intake/Pieces/PieceRequest.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <map>
#include <set>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Lists all zones once: those with a name first, then the others.
std::vector<FluentZone> ListZones(const FluentFile& file)
{
  std::vector<FluentZone> zones;
  std::set<int> known;
  for (const FluentZone& zone : file.Zones)
  {
    if (known.insert(zone.Id).second)
    {
      zones.push_back(zone);
    }
  }
  const auto addUnnamed = [&](const FluentSection& section, const std::string& type)
  {
    const int id = static_cast<int>(section.Header[0]);
    if (known.insert(id).second)
    {
      zones.push_back({ id, type, "zone-" + std::to_string(id) });
    }
  };
  for (const FluentSection& section : file.Cells)
  {
    addUnnamed(section, "fluid");
  }
  std::map<int, int> types;
  for (const FluentSection& section : file.Faces)
  {
    const int type = static_cast<int>(section.Header[3]);
    addUnnamed(section, GetFluentZoneType(type));
    types.emplace(static_cast<int>(section.Header[0]), type);
  }
  for (FluentZone& zone : zones)
  {
    const auto type = types.find(zone.Id);
    zone.BoundaryType = type != types.end() ? type->second : 0;
  }
  return zones;
}

//------------------------------------------------------------------------------
// Adds an empty array.
template <typename Array>
vtkSmartPointer<Array> Add(vtkFieldData* data, const char* name)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  data->AddArray(array);
  return array;
}

//------------------------------------------------------------------------------
// The faces of one zone that a piece owns.
struct ZoneFaces
{
  vtkNew<vtkTypeInt32Array> Nodes; // points of the piece
  vtkNew<vtkTypeInt32Array> Ends;  // of every face in Nodes, after 0
  vtkNew<vtkIntArray> Types;
  std::vector<vtkIdType> Faces; // positions in the file
  vtkIdType Free = 0;           // number of faces that belong to no cell
  bool IsShown = false;         // even without faces

  ZoneFaces() { this->Ends->InsertNextValue(0); }
};

//------------------------------------------------------------------------------
void Collect(const FluentMesh& mesh, const FluentFaces::Run& run, ZoneFaces& zone)
{
  FluentFaces::ForEachOf(run, run.Begin, run.End,
    [&](vtkIdType position, const FluentFace& face)
    {
      int side = 0;
      vtkIdType leaf = -1;
      for (; side < 2 && leaf < 0; ++side)
      {
        leaf = mesh.Cells.FindLeaf(face.GetCell(side));
      }
      const std::int32_t size = face.Size;
      zone.Free += run.Bounds && face.GetCell(0) == 0 && face.GetCell(1) == 0;
      if (leaf < 0 || size == 0 || mesh.Piece.IsGhostCell(leaf))
      {
        return;
      }
      // The normal points into the first cell; edges have it on the left, which is already outward.
      const bool isReversed = (side == 1) == (mesh.File.GetDimension() == 3);
      for (std::int32_t i = 0; i < size; ++i)
      {
        const std::int32_t node = face.Nodes[isReversed ? (size - i) % size : i];
        const vtkIdType point = mesh.Piece.FindPoint(node - 1);
        // Always true for cells bounded by this face, unless the file has just changed.
        const bool isThere = point >= 0 && point < mesh.Piece.GetNumberOfPoints();
        zone.Nodes->InsertNextValue(static_cast<std::int32_t>(isThere ? point : 0));
      }
      zone.Ends->InsertNextValue(static_cast<std::int32_t>(zone.Nodes->GetNumberOfValues()));
      zone.Types->InsertNextValue(run.BoundaryType);
      zone.Faces.push_back(position);
    });
}

//------------------------------------------------------------------------------
// The surface of a zone. The points of every zone have their own global ids, so that pieces of
// zones and of the mesh merge to the same result as reading the whole file.
vtkSmartPointer<vtkPolyData> MakeSurface(const FluentMesh& mesh, ZoneFaces& zone, int id,
  vtkPoints* points, const std::vector<std::int32_t>& pointsOfPiece, vtkIdType firstGlobalPoint)
{
  IdSet used(points->GetNumberOfPoints());
  const vtkIdType size = zone.Nodes->GetNumberOfValues();
  std::int32_t* const nodes = zone.Nodes->GetPointer(0);
  std::for_each(nodes, nodes + size, [&](std::int32_t node) { used.Add(node); });
  vtkNew<vtkPoints> own;
  own->SetDataType(points->GetDataType());
  own->SetNumberOfPoints(used.Number());
  Buffer<vtkIdType> pointIds(used.GetNumberOfMembers()),
    cellIds(static_cast<vtkIdType>(zone.Faces.size()));
  vtkIdType next = 0;
  for (const std::int32_t point : used.GetMembers())
  {
    own->GetData()->SetTuple(next, point, points->GetData());
    pointIds[next++] = firstGlobalPoint +
      (pointsOfPiece.empty() ? point : pointsOfPiece[static_cast<std::size_t>(point)]);
  }
  std::transform(nodes, nodes + size, nodes,
    [&](std::int32_t node) { return static_cast<std::int32_t>(used.GetNumber(node)); });
  std::transform(zone.Faces.begin(), zone.Faces.end(), cellIds.data(),
    [&](vtkIdType face) { return mesh.Cells.GetNumberOfLeaves() + face; });
  vtkNew<vtkCellArray> cells;
  cells->SetData(zone.Ends, zone.Nodes);
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(own);
  mesh.File.GetDimension() == 2 ? surface->SetLines(cells) : surface->SetPolys(cells);
  if (!pointsOfPiece.empty())
  {
    SetGlobalIds(surface->GetPointData(), std::move(pointIds), "GlobalPointIds");
    SetGlobalIds(surface->GetCellData(), std::move(cellIds), "GlobalCellIds");
  }
  const auto zones = Add<vtkIntArray>(surface->GetCellData(), "Zone");
  zones->SetNumberOfValues(surface->GetNumberOfCells());
  zones->Fill(id);
  zone.Types->SetName("BoundaryType");
  surface->GetCellData()->AddArray(zone.Types);
  return surface;
}
}

//------------------------------------------------------------------------------
void AddFluentZones(const FluentFile& file, vtkFieldData* fieldData)
{
  const auto ids = Add<vtkIntArray>(fieldData, "ZoneIds");
  const auto names = Add<vtkStringArray>(fieldData, "ZoneNames");
  const auto types = Add<vtkStringArray>(fieldData, "ZoneTypes");
  const auto boundaryTypes = Add<vtkIntArray>(fieldData, "ZoneBoundaryTypes");
  for (const FluentZone& zone : ListZones(file))
  {
    ids->InsertNextValue(zone.Id);
    names->InsertNextValue(zone.Name);
    types->InsertNextValue(zone.Type);
    boundaryTypes->InsertNextValue(zone.BoundaryType);
  }
}

//------------------------------------------------------------------------------
bool MakeFluentBoundaries(
  const FluentMesh& mesh, vtkPoints* points, vtkMultiBlockDataSet* blocks, Warnings& warnings)
{
  std::map<int, ZoneFaces> faces;
  for (const FluentFaces::Run& run : mesh.Faces.GetRuns())
  {
    if (run.IsOfBoundary() && mesh.File.ZonesLeftOut.count(run.Zone) == 0)
    {
      // At non-conformal interfaces, faces may have no nodes at all.
      faces[run.Zone].IsShown |= run.BoundaryType < FluentBoundary::Nonconformal;
    }
  }
  constexpr std::size_t MaxZones = 10000;
  if (faces.size() > MaxZones)
  {
    warnings.Add("there are too many face zones; boundaries are not shown");
    return true;
  }
  for (const FluentFaces::Run& run : mesh.Faces.GetRuns())
  {
    if (run.IsOfBoundary() && faces.count(run.Zone) > 0 &&
      !mesh.Faces.ForBatchesOf(run, true, Progress(),
        [&](const FluentFaces::Run& batch, const Progress&)
        {
          Collect(mesh, batch, faces[run.Zone]);
          return true;
        }))
    {
      return false;
    }
  }
  std::map<int, FluentZone> zones;
  for (const FluentZone& zone : ListZones(mesh.File))
  {
    zones[zone.Id] = zone;
  }
  const std::vector<std::int32_t> pointsOfPiece =
    mesh.Piece.IsWhole() ? std::vector<std::int32_t>() : mesh.Piece.GetPoints().GetMembers();
  unsigned int number = 0;
  for (const FluentSection& section : mesh.File.Faces) // in their order
  {
    const int id = static_cast<int>(section.Header[0]);
    auto found = faces.extract(id);
    if (found.empty())
    {
      continue;
    }
    ZoneFaces& own = found.mapped();
    const FluentZone& zone = zones[id];
    if (own.Free > 0)
    {
      warnings.Add("faces of the zone " + QuoteWord(zone.Name) +
        " that belong to no cell are left out: " + std::to_string(own.Free));
    }
    if (!own.IsShown && own.Faces.empty())
    {
      continue;
    }
    const auto surface = MakeSurface(
      mesh, own, id, points, pointsOfPiece, (number + 1) * mesh.Piece.GetNumberOfMeshPoints());
    Add<vtkStringArray>(surface->GetFieldData(), "ZoneType")->InsertNextValue(zone.Type);
    blocks->SetBlock(number, surface);
    blocks->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), zone.Name.c_str());
    ++number;
  }
  return true;
}
}
