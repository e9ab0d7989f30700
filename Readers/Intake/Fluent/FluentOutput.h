// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentOutput
 * @brief The faces, cells and zones of a mesh as they are written to a Fluent file.
 *
 * Interior faces come first, then the others zone by zone, and in each zone by their cells; each
 * face starts at its smallest node. So the file does not depend on the order of the nodes of a
 * cell. Cells of a lower dimension that are faces of others determine the zones of these faces, and
 * are not cells of the file; their points may be duplicates of those of the others, as after
 * merging blocks. Two such cells on the same interior face, one for each side as for thin walls,
 * split it into two faces with one cell each.
 */
#ifndef camaron_FluentOutput_h
#define camaron_FluentOutput_h

#include "Intake/FaceMesh/FaceOrientation.h"
#include "Intake/Fluent/FluentFile.h"
#include "Intake/Fluent/FluentInteriorZones.h"
#include "Intake/Ids/IdSet.h"
#include "Mesh/CellFacets.h"
#include "Mesh/MeshTopology.h"

#include <map>     // for zones
#include <memory>  // for the orientation
#include <utility> // for sides of faces
#include <vector>  // for faces

namespace camaron
{
class FluentOutput
{
public:
  /// @a mesh must stay alive; @a dimension is that of the cells in the file.
  FluentOutput(vtkDataSet* mesh, int dimension);

  /// Writes a face that both its cells traverse in the same direction once, as that of the first
  /// cell, not once for each cell.
  void JoinInconsistentFaces() { this->JoinsInconsistent = true; }

  /// Finds everything; false with the reason in @a reason if faces have more than two cells, or if
  /// aborted.
  bool Build(Warnings& warnings, std::string& reason, const Progress& progress);

  const MeshView& GetMesh() const { return this->Mesh; }
  const FacetTable& GetFacets() const { return this->Facets; }
  /// Of the faces of 3D cells.
  const FaceOrientation& GetOrientation() const { return *this->Orientation; }
  /// Cells of a lower dimension that are not faces of others.
  const Tally& GetLostCells() const { return this->Lost; }
  int GetDimension() const { return this->Dimension; }

  ///@{
  /// Points and cells of the file, and of the mesh, numbered from 0.
  vtkIdType GetNumberOfPoints() const
  {
    return this->AllPoints ? this->Mesh.GetNumberOfPoints()
                           : static_cast<vtkIdType>(this->Points.size());
  }
  vtkIdType GetMeshPoint(vtkIdType point) const
  {
    return this->AllPoints ? point : this->Points[static_cast<std::size_t>(point)];
  }
  vtkIdType GetFilePoint(vtkIdType point) const
  {
    return this->AllPoints ? point : this->FilePoints.GetNumber(point);
  }
  vtkIdType GetNumberOfCells() const
  {
    return this->AllCells ? this->Mesh.GetNumberOfCells()
                          : static_cast<vtkIdType>(this->Cells.size());
  }
  vtkIdType GetMeshCell(vtkIdType cell) const
  {
    return this->AllCells ? cell : this->Cells[static_cast<std::size_t>(cell)];
  }
  ///@}
  /// Fluent's number of the type of a cell of the file.
  int GetElement(vtkIdType cell) const;

  struct Face
  {
    Index Facet;
    std::int32_t Cells[2]; ///< of the file, -1 for none; the normal points into the first
    std::int32_t Size;
    std::int32_t Least; ///< smallest node
  };
  /// Consecutive cells or faces of a zone.
  struct Section
  {
    int Zone = 0;
    int Type = 0; ///< boundary type
    vtkIdType Begin = 0, End = 0;
    int Element = 0;       ///< 0 if they differ
    bool IsMade = false;   ///< whether the zone is one for elements without any
    bool IsMarked = false; ///< whether cells of a lower dimension have the zone
    bool IsTyped = false;  ///< whether the mesh says the type; otherwise it is the usual one
  };
  const std::vector<Face>& GetFaces() const { return this->Faces; }
  const std::vector<Section>& GetFaceSections() const { return this->FaceSections; }
  const std::vector<Section>& GetCellSections() const { return this->CellSections; }
  const std::vector<FluentZone>& GetZones() const { return this->Zones; }
  /// A zone of these, or nullptr.
  const FluentZone* FindZone(int id) const { return Find(this->Zones, id); }
  /// Number of cell zones with several sections.
  int GetNumberOfSplitZones() const { return this->NumberOfSplitZones; }

  /// Whether the second cell of a facet has the opposite orientation of the first; false without.
  bool AreOpposite(Index facet) const;
  /// Points of a face of 3D cells, outward of the first cell of its facet, see FaceOrientation.
  /// Consecutive duplicates are removed.
  void GetRing(Index facet, std::vector<vtkIdType>& points) const;
  /// Nodes of a face in the order of the file, as points of the mesh; @a nodes is overwritten.
  /// Consecutive duplicates are removed.
  void GetNodes(const Face& face, std::vector<vtkIdType>& nodes) const;

private:
  void FindCells();
  void MergeCopies();
  bool FindFaces(Warnings& warnings, std::string& reason, const Progress& progress);
  void SortFacesOfCells();
  Index GetFileCell(Index cell) const
  {
    return cell < 0 || this->AllCells  ? cell
      : this->FileCells.Contains(cell) ? static_cast<Index>(this->FileCells.GetNumber(cell))
                                       : -1;
  }
  void GetPoints(Index facet, std::vector<vtkIdType>& points) const;
  int CountCorners(vtkIdType meshCell) const;
  bool IsFarSide(const Face& face) const;
  void ReadZones();
  void SortFaces();
  void AddFaceSection(vtkIdType begin, vtkIdType end, int id);
  void FindCellSections();
  void FindMarks(Warnings& warnings);
  std::vector<std::size_t> SplitFace(std::size_t face, const std::vector<std::int32_t>& marks);
  bool IsOutward(std::int32_t mark, const Face& face) const;
  std::vector<vtkIdType> GetMarkNodes(std::int32_t mark) const;
  int GetInteriorZone(const Face& face) const;
  void WarnOfOddZones(Warnings& warnings) const;
  void WarnOfLostZones(Warnings& warnings) const;
  const FluentZone* FindOnlyZone(const std::string& type) const;
  int GetMarkedZone(int zone, int type);
  int GetFreeZone(int least) const;
  int GetZone(vtkIdType cell) const;
  static const FluentZone* Find(const std::vector<FluentZone>& zones, int id);
  FluentZone Describe(int zone, const std::string& type) const;

  vtkDataSet* DataSet;
  int Dimension;
  MeshTopology Topology;
  const MeshView& Mesh;
  const FacetTable& Facets;
  std::unique_ptr<FaceOrientation> Orientation; ///< of 3D cells
  const CellShape* Shapes;
  bool AllCells = true, AllPoints = true;
  bool JoinsInconsistent = false;
  IdSet FileCells, FilePoints;              ///< those of the mesh in the file
  std::vector<std::int32_t> Cells, Points;  ///< the same as lists, if some are not in the file
  std::vector<std::int32_t> Marks;          ///< cells of the mesh that are faces of others
  std::map<vtkIdType, vtkIdType> Originals; ///< of duplicate points
  std::vector<Face> Faces;
  std::map<std::pair<Index, std::int32_t>, int>
    MarkedZones;                                  ///< zones of facets with their first cell
  std::map<int, int> MarkedTypes;                 ///< boundary types of these zones
  std::map<std::pair<int, int>, int> ZonesByType; ///< of a zone and a type that is not its first
  FluentInteriorZones InteriorZones;
  std::vector<Section> FaceSections, CellSections;
  std::vector<FluentZone> Zones, KnownZones;
  Tally Renamed;  ///< zones whose name the format cannot store
  Tally Repeated; ///< ids of zones with several names
  Tally Lost;
  int NumberOfSplitZones = 0;
  vtkDataArray* ZoneArray = nullptr;
};
}

#endif
