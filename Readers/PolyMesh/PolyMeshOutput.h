// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PolyMeshOutput
 * @brief The points, faces and zones of a mesh in the order that OpenFOAM requires.
 *
 * Cells keep their order. Faces between two cells come first, by owner and then by neighbor (upper
 * triangular order); the owner is the cell with the smaller id. The others follow patch by patch.
 * A face is oriented outward of its owner: faces of a polyhedron are first oriented consistently,
 * and cells that are connected by faces on whose orientation they agree are mirrored if the sum of
 * their volumes is negative. Points that no cell uses are left out.
 *
 * Zones are those of a Fluent mesh, see FluentOutput.
 */
#ifndef camaron_PolyMeshOutput_h
#define camaron_PolyMeshOutput_h

#include "Intake/Fluent/FluentOutput.h"
#include "Intake/Ids/IdSet.h"

namespace camaron
{
class PolyMeshOutput
{
public:
  /// @a mesh must stay alive; it has 3D cells, and 2D cells that mark zones of faces.
  /// @a scale: a factor for the coordinates.
  PolyMeshOutput(vtkDataSet* mesh, double scale);

  /**
   * Finds everything.
   * @param refusesLost whether 2D cells that are no face of a 3D cell are an error, not a warning
   * @return false with the reason in @a reason, or if aborted
   */
  bool Build(bool refusesLost, Warnings& warnings, std::string& reason, const Progress& progress);

  vtkIdType GetNumberOfPoints() const { return static_cast<vtkIdType>(this->Points.size()); }
  void GetPoint(vtkIdType point, double x[3]) const
  {
    this->Mesh.GetMesh().GetPoint(this->Points[point], x);
    for (int c = 0; c < 3; ++c)
    {
      x[c] *= this->Scale;
    }
  }
  /// Whether float stores the coordinates.
  bool HasFloatPoints() const { return this->Mesh.GetMesh().HasFloatPoints() && this->Scale == 1; }
  vtkIdType GetNumberOfCells() const { return this->Mesh.GetNumberOfCells(); }
  /// The cell of the mesh that a cell is.
  vtkIdType GetMeshCell(vtkIdType cell) const { return this->Mesh.GetMeshCell(cell); }

  struct Face
  {
    Index Facet;
    std::int32_t Owner, Neighbor; ///< -1 for none
    std::int32_t Size;
    int Zone; ///< index of a section of FluentOutput
    bool IsReversed;
  };
  /// Those between two cells come first.
  const std::vector<Face>& GetFaces() const { return this->Faces; }
  vtkIdType GetNumberOfInteriorFaces() const { return this->NumberOfInteriorFaces; }
  /// Points of a face, outward of its owner; @a points is overwritten.
  void GetFacePoints(const Face& face, std::vector<vtkIdType>& points) const;

  /// Consecutive faces at the boundary.
  struct Patch
  {
    std::string Name, Type;
    std::string Group; ///< Fluent's type of the zone; empty if unknown
    vtkIdType Begin = 0, End = 0;
  };
  /// Some cells, or some faces between cells. The only zone of faces that are not marked has none:
  /// it would be all of them.
  struct Zone
  {
    std::string Name;
    std::string Group;          ///< Fluent's type, if it is not fluid or interior
    std::vector<vtkIdType> Ids; ///< ascending
  };
  const std::vector<Patch>& GetPatches() const { return this->Patches; }
  const std::vector<Zone>& GetCellZones() const { return this->CellZones; }
  const std::vector<Zone>& GetFaceZones() const { return this->FaceZones; }

private:
  void FindMirroredCells();
  void CollectFaces(Warnings& warnings);
  void SortFaces();
  void NumberPoints(Warnings& warnings);
  void FindPatches(Warnings& warnings);
  void FindZones(Warnings& warnings);
  std::string MakeName(const std::string& name, std::vector<std::string>& used);

  FluentOutput Mesh;
  double Scale;
  const FacetTable& Facets;
  std::vector<unsigned char> IsMirrored; ///< cells of the mesh
  std::vector<Face> Faces;
  vtkIdType NumberOfInteriorFaces = 0;
  IdSet UsedPoints;                 ///< of the mesh
  std::vector<std::int32_t> Points; ///< the same
  std::vector<Patch> Patches;
  std::vector<Zone> CellZones, FaceZones;
  Tally Renamed;
};
}

#endif
