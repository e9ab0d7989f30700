// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FaceTriangles
 * @brief Triangulates all faces of a cell, and lists lines on the faces.
 *
 * A face that is star-shaped about its center is represented by the triangles about its center,
 * any other face by those of PolygonTriangulator. Memory is reused for the next cell.
 */
#ifndef camaron_FaceTriangles_h
#define camaron_FaceTriangles_h

#include "Cell/CellGeometry.h"
#include "Geometry/BoxTree.h"
#include "Geometry/PolygonTriangulator.h"

#include <algorithm> // for searches
#include <array>     // for triangles
#include <cstddef>   // for std::size_t
#include <vector>    // for lists

namespace camaron
{
/// A line on a face: an edge, or a line from a vertex into the face; for the latter both Points are
/// the vertex.
struct FaceLine
{
  int Points[2];
  Vector End;
};

class FaceTriangles
{
public:
  using Triangle = std::array<Vector, 3>;

  void Load(const CellGeometry& cell);
  const std::vector<FaceLine>& GetLines() const { return this->Lines; }

  /**
   * Calls @a visit(face, triangle) for triangles near a line, of faces that do not contain its end
   * points, until it returns true.
   * @return whether @a visit returned true
   */
  template <typename Visit>
  bool FindAny(const CellGeometry& cell, const FaceLine& line, Visit&& visit) const
  {
    Bounds around;
    around.Add(cell.GetPoint(line.Points[0]));
    around.Add(line.End);
    const auto isNear = [&](const Bounds& box) { return box.Meets(around); };
    return this->Tree.FindAny(isNear,
      [&](std::size_t place)
      {
        const auto f = static_cast<int>(this->Tree.GetOrder()[place]);
        if (!isNear(this->Boxes[f]) || this->HasPoint(f, line.Points[0]) ||
          this->HasPoint(f, line.Points[1]))
        {
          return false;
        }
        const Face& face = this->Faces[f];
        if (face.IsLarge)
        {
          return face.Tree.FindAny(isNear, [&](std::size_t other)
            { return visit(f, this->Triangles[face.First + face.Tree.GetOrder()[other]]); });
        }
        return std::any_of(this->Triangles.begin() + face.First,
          this->Triangles.begin() + face.Last,
          [&](const Triangle& triangle) { return visit(f, triangle); });
      });
  }

private:
  struct Face
  {
    std::size_t First, Last; ///< range of triangles
    bool IsLarge;
    BoxTree Tree; ///< of the triangles of a large face
  };
  static constexpr std::size_t FewTriangles = 16;

  void AddFace(const CellGeometry& cell, int face);
  bool AddStar(const CellGeometry& cell, int face);
  void AddCut(const CellGeometry& cell, int face);
  void AddLine(int corner, const Vector& from, const Vector& middle);
  void FindFacesOfPoints(const CellTopology& topology);
  bool HasPoint(int face, int point) const
  {
    const auto begin = this->FacesOfPoints.begin();
    return std::binary_search(
      begin + this->FirstFaces[point], begin + this->FirstFaces[point + 1], face);
  }

  std::vector<Triangle> Triangles;
  std::vector<Face> Faces;
  std::vector<FaceLine> Lines;
  std::vector<Bounds> Boxes, BoxesOfFace;
  BoxTree Tree;                               ///< of faces
  std::vector<int> FirstFaces, FacesOfPoints; ///< FirstFaces[point] is where its faces begin in
                                              ///< FacesOfPoints
  std::vector<Vector> Corners;
  PolygonTriangulator Triangulator;
};
}

#endif
