// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CutTetrahedra
 * @brief Finds the tetrahedra that the boundary of a shape crosses, on the graphics card.
 *
 * Blocks of cells that lie on one side are left out. Runs only when the mesh, the choice of cells
 * or the shape changed; the camera does not matter.
 */
#ifndef camaron_CutTetrahedra_h
#define camaron_CutTetrahedra_h

#include "FeedbackProgram.h"
#include "InspectionStyle.h"
#include "TextureBuffer.h"

#include <array>  // for bounds
#include <string> // for errors
#include <vector> // for bounds

namespace camaron
{
class InspectionMesh;

class CutTetrahedra
{
public:
  /**
   * Brings the list up to date. Needs the context current and no program in use; changes texture
   * units.
   * @return false when the graphics card refuses; GetError says why
   */
  bool Update(InspectionMesh& mesh, const InspectionStyle& style);

  /// The indices of the tetrahedra, a row each.
  const TextureBuffer& GetTable() const { return this->Table; }
  std::size_t GetNumberOfTetrahedra() const { return this->NumberOfTetrahedra; }
  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  struct Request
  {
    int Version = -1;
    Chosen CellsToDraw = Chosen::All;
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
  std::string Error;
};
}

#endif
