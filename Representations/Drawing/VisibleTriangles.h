// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::VisibleTriangles
 * @brief Finds, on the graphics card, the visible triangles of a mesh of which only some cells are
 * drawn.
 *
 * A first shader decides for each cell whether it is drawn (KeepCells.vs.glsl), a second one for
 * each triangle from which of its cells it is visible (VisibleTriangles.*.glsl); nothing is
 * uploaded. Runs only if the mesh, the shape or the choice of cells has changed. Source: W. Canepa
 * et al., Camarón (GRAPP 2016), which tests all faces in every frame.
 */
#ifndef camaron_VisibleTriangles_h
#define camaron_VisibleTriangles_h

#include "FeedbackProgram.h"
#include "InspectionStyle.h"
#include "TextureBuffer.h"

namespace camaron
{
class InspectionMesh;

class VisibleTriangles
{
public:
  /**
   * Updates the list. Requires that the context is current and no program is in use; changes
   * texture units.
   *
   * @throw std::exception if the graphics card cannot do it
   */
  void Update(InspectionMesh& mesh, const InspectionStyle& style);

  /// One row, triangle << 1 | side, per visible triangle.
  const TextureBuffer& GetTable() const { return this->Table; }
  std::size_t GetNumberOfTriangles() const { return this->NumberOfTriangles; }

  void Release();

private:
  void KeepCells(InspectionMesh& mesh, const InspectionStyle& style);

  struct Request
  {
    int Version = -1;
    DrawnFaces FacesToDraw = DrawnFaces::Surface;
    DrawnCells CellsToDraw = DrawnCells::All;
    CutBy Cut = CutBy::Nothing;
    bool KeepInside = false;
    bool BordersAreOpen = true;
    ConvexShape Shape;
    bool operator==(const Request& other) const
    {
      return this->Version == other.Version && this->FacesToDraw == other.FacesToDraw &&
        this->CellsToDraw == other.CellsToDraw && this->Cut == other.Cut &&
        this->KeepInside == other.KeepInside && this->BordersAreOpen == other.BordersAreOpen &&
        this->Shape == other.Shape;
    }
  };

  FeedbackProgram CellProgram;
  FeedbackProgram TriangleProgram;
  TextureBuffer Keep{ TextureBuffer::Row::UInt };
  TextureBuffer Table{ TextureBuffer::Row::UInt };
  Request Last;
  std::size_t NumberOfTriangles = 0;
};
}

#endif
