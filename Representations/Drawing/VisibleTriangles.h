// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::VisibleTriangles
 * @brief Finds on the graphics card which triangles of a mesh are seen when only some cells are
 * drawn.
 *
 * First every cell is told to be drawn or not (KeepCells.vs.glsl), then every triangle from which
 * of its cells it is seen (VisibleTriangles.*.glsl); nothing is uploaded. Runs only when the mesh,
 * the shape or the choice changed. Source: W. Canepa et al., Camarón (GRAPP 2016), which tested all
 * faces in every picture.
 */
#ifndef camaron_VisibleTriangles_h
#define camaron_VisibleTriangles_h

#include "FeedbackProgram.h"
#include "InspectionStyle.h"
#include "TextureBuffer.h"

#include <string> // for errors

namespace camaron
{
class InspectionMesh;

class VisibleTriangles
{
public:
  /**
   * Brings the list up to date. Needs the context current and no program in use; changes texture
   * units.
   * @return false when the graphics card refuses; GetError says why
   */
  bool Update(InspectionMesh& mesh, const InspectionStyle& style);

  /// One row, triangle << 1 | side, for each visible triangle.
  const TextureBuffer& GetTable() const { return this->Table; }
  std::size_t GetNumberOfTriangles() const { return this->NumberOfTriangles; }
  const std::string& GetError() const { return this->Error; }

  void Release();

private:
  void KeepCells(InspectionMesh& mesh, const InspectionStyle& style);

  struct Request
  {
    int Version = -1;
    Walls WallsToDraw = Walls::Surface;
    Chosen CellsToDraw = Chosen::All;
    CutBy Cut = CutBy::Nothing;
    bool KeepInside = false;
    bool BordersAreOpen = true;
    ConvexShape Shape;
    bool operator==(const Request& other) const
    {
      return this->Version == other.Version && this->WallsToDraw == other.WallsToDraw &&
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
  std::string Error;
};
}

#endif
