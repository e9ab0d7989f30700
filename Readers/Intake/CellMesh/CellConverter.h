// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellConverter
 * @brief Converts single cells of a mesh according to a ConversionPlan.
 *
 * Holds scratch memory: use one object per thread.
 */
#ifndef camaron_CellConverter_h
#define camaron_CellConverter_h

#include "Intake/CellMesh/CellCutter.h"
#include "Intake/CellMesh/ConversionFindings.h"
#include "Intake/CellMesh/ConversionPlan.h"
#include "Mesh/FacetTable.h"

#include <vector> // for cells

namespace camaron
{
/// The cells that a chunk of the input is converted to.
struct CellChunk
{
  std::vector<unsigned char> Types;
  std::vector<std::int64_t> Ends; ///< of the points of every cell
  std::vector<std::int64_t> Points;
  std::vector<std::int64_t> Inputs;
};

class CellConverter
{
public:
  CellConverter(const MeshView& mesh, const ConversionPlan& plan, const CellConversion& how,
    const FacetTable* faces)
    : Mesh(mesh)
    , Plan(plan)
    , How(how)
    , Faces(faces)
    , Facets(mesh)
    , Cutter(mesh)
  {
  }

  /// Appends the cells that a cell is converted to.
  void Convert(vtkIdType cell, CellChunk& chunk);
  ConversionFindings Found;

private:
  void Put(unsigned char type)
  {
    this->Chunk->Types.push_back(type);
    this->Chunk->Ends.push_back(static_cast<std::int64_t>(this->Chunk->Points.size()));
    this->Chunk->Inputs.push_back(this->Cell);
  }
  template <typename Ids>
  void Put(unsigned char type, const Ids& ids, vtkIdType size)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->Chunk->Points.push_back(ids[i]);
    }
    this->Put(type);
  }
  /// Appends the result of a step for the cell.
  void Put(const ConversionStep& step);
  void PutPolygon(const vtkIdType* points, vtkIdType size);
  void PutSurface();
  void PutPolyhedron();
  void PutTetrahedra();
  void AddOnce(Tally& tally)
  {
    if (!this->IsCounted)
    {
      tally.Add(this->Cell);
      this->IsCounted = true;
    }
  }

  const MeshView& Mesh;
  const ConversionPlan& Plan;
  const CellConversion& How;
  const FacetTable* Faces;
  CellFacets Facets;
  CellCutter Cutter;
  std::vector<vtkIdType> Polygon;
  CellChunk* Chunk = nullptr;
  vtkIdType Cell = 0;
  unsigned char Type = 0;
  bool IsCounted = false; // a cell counts once, regardless of its number of parts
};
}

#endif
