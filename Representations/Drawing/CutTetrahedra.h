// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CutTetrahedra
 * @brief Finds, on the graphics card, the tetrahedra that intersect the boundary of a shape.
 *
 * Blocks of cells that are entirely on one side are skipped. Runs only if the mesh, the choice of
 * cells or the shape has changed, not when the camera moves.
 */
#ifndef camaron_CutTetrahedra_h
#define camaron_CutTetrahedra_h

#include "FeedbackProgram.h"
#include "InspectionStyle.h"
#include "TextureBuffer.h"

#include <array>  // for bounds
#include <vector> // for bounds

namespace camaron
{
class InspectionMesh;

class CutTetrahedra
{
public:
  /**
   * Updates the list. Requires that the context is current and no program is in use; changes
   * texture units.
   *
   * @throw std::exception if the graphics card cannot do it
   */
  void Update(InspectionMesh& mesh, const InspectionStyle& style);

  /// Indices of the tetrahedra, one per row.
  const TextureBuffer& GetTable() const { return this->Table; }
  std::size_t GetNumberOfTetrahedra() const { return this->NumberOfTetrahedra; }
  void Release();

private:
  struct Request
  {
    int Version = -1;
    DrawnCells CellsToDraw = DrawnCells::All;
    bool CellsMove = false;
    ConvexShape Shape;
    bool operator==(const Request& other) const
    {
      return this->Version == other.Version && this->CellsToDraw == other.CellsToDraw &&
        this->CellsMove == other.CellsMove && this->Shape == other.Shape;
    }
  };

  FeedbackProgram Program;
  TextureBuffer Table{ TextureBuffer::Row::UInt };
  std::vector<std::array<double, 6>> BlockBounds;
  Request Last;
  std::size_t NumberOfTetrahedra = 0;
};
}

#endif
