// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TetGenFacets
 * @brief The facets, holes and regions of a .poly or .smesh file of TetGen.
 *
 * In a .poly file a facet has any number of polygons, and holes; in a .smesh file it is one
 * polygon.
 */
#ifndef camaron_TetGenFacets_h
#define camaron_TetGenFacets_h

#include "Intake/CellMesh/CellRows.h"
#include "TetGenNodes.h"

class vtkFieldData;

namespace camaron
{
class TetGenFacets
{
public:
  /// Reads the facets; the scanner is after the nodes.
  bool Read(TextScanner& scanner, const TextLines* lines, const TetGenNodes& nodes, bool isSmesh,
    const Progress& progress);

  CellMesh& GetMesh() { return this->Mesh; }
  /// Adds "Facet" and, if there are markers, "BoundaryMarker".
  void AddArrays(vtkUnstructuredGrid* grid, const CellMeshPiece& piece);
  /// Adds "FacetHoles" and "FacetOfHole" if there are holes in facets.
  void AddFields(vtkFieldData* fields) const;
  void Warn(Warnings& warnings) const;

private:
  bool ReadOneByOne(TextScanner& scanner, const TetGenNodes& nodes, const Progress& progress);
  bool ReadPairs(TextScanner& scanner, const TextLines* lines, const TetGenNodes& nodes,
    const Progress& progress);
  bool ReadFacet(TextScanner& scanner, const TetGenNodes& nodes, vtkIdType facet, CellSink& sink);
  bool ReadHole(TextScanner& scanner, vtkIdType facet);
  bool ReadMarker(TextRow& row, vtkIdType facet);

  std::int64_t Count = 0; ///< of facets
  vtkIdType NumberOfCells = 0;
  bool HasMarkers = false;
  CellMesh Mesh;
  std::vector<std::int32_t> Facets;  ///< one per cell; empty if every facet is one cell
  std::vector<std::int32_t> Markers; ///< one per facet
  IdSet Unmarked;                    ///< facets without marker
  std::vector<double> Holes;
  std::vector<std::int32_t> FacetsOfHoles;
  Tally WithHoles;
};

/**
 * @class camaron::TetGenSeeds
 * @brief Points that mark holes and regions, at the end of a .poly or .smesh file.
 */
class TetGenSeeds
{
public:
  /// Reads both lists, which may be missing.
  bool Read(TextScanner& scanner, int dimension);
  /// Adds "Holes" and "Regions" if there are any.
  void AddFields(vtkFieldData* fields) const;

private:
  std::vector<double> Holes;   ///< x y z
  std::vector<double> Regions; ///< x y z, attribute, largest volume or area (-1 for none)
};
}

#endif
