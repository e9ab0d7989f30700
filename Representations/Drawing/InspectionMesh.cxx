// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InspectionMesh.h"

#include "InspectionArrays.h"
#include "InspectionStyle.h"

#include "Base/Parallel.h"
#include "Drawing/CellTetrahedra.h"
#include "Drawing/DrawableFaces.h"
#include "Drawing/SubdividedFacets.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/MeshView.h"
#include "vtkCamaronCompat.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace camaron
{
namespace
{
constexpr vtkIdType Grain = 1 << 14;

const unsigned char* GetGhosts(vtkUnstructuredGrid* grid)
{
  vtkUnsignedCharArray* ghosts = grid->GetCellGhostArray();
  return ghosts ? ghosts->GetPointer(0) : nullptr;
}

DataVersion GetVersionOf(const std::vector<vtkObject*>& arrays)
{
  DataVersion version;
  for (vtkObject* array : arrays)
  {
    version.emplace_back(array, array ? array->GetMTime() : 0);
  }
  return version;
}

// Sending the array between processes may change its type to another type of 64-bit integers.
const std::uint64_t* GetOuterFacets(vtkUnstructuredGrid* grid)
{
  vtkDataArray* bits = grid->GetCellData()->GetArray(OuterFacetsName);
  const bool isUsable = bits && bits->GetDataTypeSize() == 8 && bits->GetDataType() != VTK_DOUBLE &&
    bits->HasStandardMemoryLayout();
  return isUsable ? static_cast<const std::uint64_t*>(bits->GetVoidPointer(0)) : nullptr;
}

// Fills a table of `size` rows in parallel.
template <typename Value, typename Function>
void Fill(TextureBuffer& table, vtkIdType size, Function&& value)
{
  table.Write(static_cast<std::size_t>(size),
    [&](void* memory)
    {
      auto* const rows = static_cast<Value*>(memory);
      ParallelForEach(size, Grain, [&](vtkIdType i) { rows[i] = value(i); });
    });
}

//------------------------------------------------------------------------------
// Stores the edge bits of a tetrahedron in the two upper bits of its points, which are unused.
void PackEdges(CellTetrahedra& tetrahedra, vtkIdType numberOfPoints)
{
  constexpr int Bits = 30;
  if (numberOfPoints > vtkIdType(1) << Bits)
  {
    throw std::length_error("Cells can only be cut open in pieces of up to 2^30 points.");
  }
  ParallelForEach(static_cast<vtkIdType>(tetrahedra.Points.size()), Grain,
    [&](vtkIdType i)
    {
      for (int k = 0; k < 4; ++k)
      {
        tetrahedra.Points[i][k] |= (tetrahedra.Edges[i] >> 2 * k & 3u) << Bits;
      }
    });
}
}

//------------------------------------------------------------------------------
// Two rows per box: its lower end and Next; its upper end and Last.
std::vector<std::array<float, 4>> PackBoxes(
  const CellTetrahedra& tetrahedra, const std::array<double, 3>& middle)
{
  std::vector<std::array<float, 4>> rows;
  rows.reserve(2 * tetrahedra.NegativeBoxes.size());
  for (const CellTetrahedra::NegativeBox& node : tetrahedra.NegativeBoxes)
  {
    const auto add = [&](const Vector& end, std::uint32_t number)
    {
      rows.push_back(
        { { static_cast<float>(end.X - middle[0]), static_cast<float>(end.Y - middle[1]),
          static_cast<float>(end.Z - middle[2]), static_cast<float>(number) } });
    };
    add(node.Box.Low, node.Next);
    add(node.Box.High, node.Last);
  }
  return rows;
}

//------------------------------------------------------------------------------
CellsToDraw GetCellsToDraw(vtkUnstructuredGrid* grid)
{
  return { GetGhosts(grid), GetOuterFacets(grid) };
}

//------------------------------------------------------------------------------
std::array<double, 6> GetCellBounds(vtkUnstructuredGrid* grid)
{
  const MeshView mesh(grid);
  const std::vector<bool> areUsed = mesh.FindUsedPoints();
  vtkBoundingBox box;
  for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
  {
    const Vector x = mesh.GetPoint(point);
    if (areUsed[static_cast<std::size_t>(point)] && IsFinite(x))
    {
      box.AddPoint(x.X, x.Y, x.Z);
    }
  }
  std::array<double, 6> bounds = { { 1, -1, 1, -1, 1, -1 } };
  if (box.IsValid())
  {
    box.GetBounds(bounds.data());
  }
  return bounds;
}

//------------------------------------------------------------------------------
DataVersion GetCellBoundsVersion(vtkUnstructuredGrid* grid)
{
  vtkPoints* points = grid->GetPoints();
  vtkCellArray* cells = grid->GetCells();
  return GetVersionOf({ points ? points->GetData() : nullptr, cells->GetOffsetsArray(),
    cells->GetConnectivityArray(), GetCellTypes(grid) });
}

//------------------------------------------------------------------------------
void InspectionMesh::Update()
{
  DataVersion geometry, selected;
  if (this->Grid && this->Grid->GetPoints() && this->Grid->GetNumberOfCells() > 0)
  {
    geometry = GetCellBoundsVersion(this->Grid);
    for (const auto& other : GetVersionOf({ this->Grid->GetCellGhostArray(),
           this->Grid->GetCellData()->GetArray(OuterFacetsName) }))
    {
      geometry.push_back(other);
    }
    selected = GetVersionOf({ this->Grid->GetCellData()->GetArray(SelectedArrayName),
      this->Grid->GetCellGhostArray(), this->Grid->GetFieldData()->GetArray(HiddenLeavesName) });
  }
  if (geometry != this->Geometry || this->Subdivided != this->OfTables)
  {
    this->Release();
    this->OfTables = this->Subdivided;
    this->Geometry = geometry;
    std::array<double, 6> bounds = { { 0, 0, 0, 0, 0, 0 } };
    if (!geometry.empty())
    {
      bounds = GetCellBounds(this->Grid);
    }
    this->Middle = GetMiddleOf(bounds);
  }
  if (selected != this->Selected)
  {
    this->Selected = selected;
    this->Marks.Release();
    this->Owners.Release();
    ++this->Version;
  }
}

//------------------------------------------------------------------------------
vtkIdType InspectionMesh::GetNumberOfNodes() const
{
  const vtkIdType all = this->Grid ? this->Grid->GetNumberOfPoints() : 0;
  return this->Subdivided ? all - this->Subdivided->GetNumberOfNewPoints() : all;
}

//------------------------------------------------------------------------------
void InspectionMesh::NeedFaces(bool inner)
{
  if (this->Triangles.IsUploaded() && (this->HasInnerFaces || !inner))
  {
    return;
  }
  const MeshTopology topology(this->Grid);
  CellsToDraw cells = GetCellsToDraw(this->Grid);
  cells.Subdivided = this->Subdivided.get();
  const DrawableFaces faces =
    MakeDrawableFaces(topology, cells, inner ? FacesToDraw::All : FacesToDraw::Outer);
  this->Triangles.Upload(faces.Triangles.data(), faces.Triangles.size());
  this->Faces.Upload(faces.Faces.data(), faces.Faces.size());
  this->NumberOfOuterTriangles = faces.NumberOfOuterTriangles;
  this->HasInnerFaces = inner;
  ++this->Version;
}

//------------------------------------------------------------------------------
void InspectionMesh::NeedPoints()
{
  if (!this->Points.IsUploaded())
  {
    const MeshView mesh(this->Grid);
    Fill<std::array<float, 4>>(this->Points, mesh.GetNumberOfPoints(),
      [&](vtkIdType point)
      {
        double x[3];
        mesh.GetPoint(point, x);
        return std::array<float, 4>{ { static_cast<float>(x[0] - this->Middle[0]),
          static_cast<float>(x[1] - this->Middle[1]), static_cast<float>(x[2] - this->Middle[2]),
          1.0f } };
      });
  }
}

//------------------------------------------------------------------------------
void InspectionMesh::NeedMarks()
{
  if (!this->Marks.IsUploaded())
  {
    const unsigned char* ghosts = GetGhosts(this->Grid);
    vtkDataArray* selected = this->Grid->GetCellData()->GetArray(SelectedArrayName);
    vtkDataArray* leaves = this->Grid->GetCellData()->GetArray(LeavesName);
    vtkDataArray* hidden = this->Grid->GetFieldData()->GetArray(HiddenLeavesName);
    const auto isHidden = [=](vtkIdType cell)
    {
      return leaves && hidden &&
        hidden->GetComponent(static_cast<vtkIdType>(leaves->GetComponent(cell, 0)), 0) != 0;
    };
    Fill<unsigned char>(this->Marks, this->Grid->GetNumberOfCells(),
      [&](vtkIdType cell)
      {
        const int ghost = ghosts ? ghosts[cell] : 0;
        return static_cast<unsigned char>((ghost & vtkDataSetAttributes::DUPLICATECELL ? 1 : 0) |
          (ghost & vtkDataSetAttributes::HIDDENCELL || isHidden(cell) ? 2 : 0) |
          (selected && selected->GetComponent(cell, 0) != 0 ? 4 : 0));
      });
  }
}

//------------------------------------------------------------------------------
void InspectionMesh::NeedCentroids()
{
  if (!this->Centroids.IsUploaded())
  {
    const MeshView mesh(this->Grid);
    Fill<std::array<float, 4>>(this->Centroids, mesh.GetNumberOfCells(),
      [&](vtkIdType cell)
      {
        const IndexRange points = mesh.GetCellPoints(cell);
        double sum[3] = { 0, 0, 0 };
        for (vtkIdType i = 0; i < points.Size; ++i)
        {
          double x[3];
          mesh.GetPoint(points[i], x);
          for (int k = 0; k < 3; ++k)
          {
            sum[k] += x[k] - this->Middle[k];
          }
        }
        const double size = points.Size > 0 ? static_cast<double>(points.Size) : 1.0;
        return std::array<float, 4>{ { static_cast<float>(sum[0] / size),
          static_cast<float>(sum[1] / size), static_cast<float>(sum[2] / size), 1.0f } };
      });
  }
}

//------------------------------------------------------------------------------
void InspectionMesh::NeedConnectivity()
{
  if (!this->CellOffsets.IsUploaded())
  {
    const IndexLists cells(this->Grid->GetCells());
    const vtkIdType numberOfCells = this->Grid->GetNumberOfCells();
    Fill<std::uint32_t>(this->CellOffsets, numberOfCells + 1,
      [&](vtkIdType cell) { return static_cast<std::uint32_t>(cells.Offsets[cell]); });
    Fill<std::uint32_t>(this->CellPoints, cells.Offsets[numberOfCells],
      [&](vtkIdType i) { return static_cast<std::uint32_t>(cells.Values[i]); });
  }
}

//------------------------------------------------------------------------------
void InspectionMesh::NeedOwners()
{
  if (!this->Owners.IsUploaded())
  {
    vtkCellData* data = this->Grid->GetCellData();
    vtkDataArray* processes = data->GetArray(ProcessIdsName);
    vtkDataArray* blocks = data->GetArray(BlockIdsName);
    const auto get = [](vtkDataArray* array, vtkIdType cell)
    { return array ? static_cast<std::uint32_t>(array->GetComponent(cell, 0)) : 0u; };
    Fill<std::array<std::uint32_t, 2>>(this->Owners, this->Grid->GetNumberOfCells(),
      [&](vtkIdType cell)
      { return std::array<std::uint32_t, 2>{ { get(processes, cell), get(blocks, cell) } }; });
  }
}

//------------------------------------------------------------------------------
void InspectionMesh::NeedLeaves()
{
  vtkDataArray* leaves = this->Grid->GetCellData()->GetArray(LeavesName);
  if (leaves && !this->Leaves.IsUploaded())
  {
    Fill<std::uint32_t>(this->Leaves, this->Grid->GetNumberOfCells(),
      [&](vtkIdType cell) { return static_cast<std::uint32_t>(leaves->GetComponent(cell, 0)); });
  }
}

//------------------------------------------------------------------------------
void InspectionMesh::NeedTetrahedra()
{
  if (!this->Tetrahedra.IsUploaded())
  {
    CellTetrahedra tetrahedra = MakeCellTetrahedra(MeshView(this->Grid), this->Subdivided.get());
    PackEdges(tetrahedra, this->Grid->GetNumberOfPoints());
    this->Tetrahedra.Upload(tetrahedra.Points.data(), tetrahedra.Points.size());
    this->CellsOfTetrahedra.Upload(tetrahedra.Cells.data(), tetrahedra.Cells.size());
    if (!tetrahedra.FirstNegatives.empty())
    {
      this->FirstNegatives.Upload(
        tetrahedra.FirstNegatives.data(), tetrahedra.FirstNegatives.size());
      this->NegativeBoxes.Upload(
        PackBoxes(tetrahedra, this->Middle).data(), 2 * tetrahedra.NegativeBoxes.size());
    }
    this->Blocks = std::move(tetrahedra.Blocks);
  }
}

//------------------------------------------------------------------------------
void InspectionMesh::Release()
{
  for (TextureBuffer* table : { &this->Points, &this->Triangles, &this->Faces, &this->Marks,
         &this->Centroids, &this->CellOffsets, &this->CellPoints, &this->Owners, &this->Leaves,
         &this->Tetrahedra, &this->CellsOfTetrahedra, &this->FirstNegatives, &this->NegativeBoxes })
  {
    table->Release();
  }
  this->HasInnerFaces = false;
  this->NumberOfOuterTriangles = 0;
  ++this->Version;
}
}
