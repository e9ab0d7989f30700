// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::LabelChoice
 * @brief Chooses the elements of a mesh that get an id label in a frame, and the positions of the
 * labels.
 *
 * Elements nearest to the camera come first. The choice depends only on the mesh, its style and the
 * camera. Labels do not overlap and are entirely inside the view. Labels of points are beside the
 * point; those of edges, faces and cells at their center. In an opaque mesh, an element gets a
 * label only if the position of the label is visible: the point, the center of the edge, of the
 * face, or of a face of the cell. In a translucent mesh, all elements of visible faces get one.
 */
#ifndef camaron_LabelChoice_h
#define camaron_LabelChoice_h

#include "LabelMesh.h"

#include <unordered_set> // for elements with a label

class vtkMatrix4x4;

namespace camaron
{
class VisiblePixels;

struct IdLabel
{
  LabelKind Kind;
  vtkIdType Id;
  Place At;         ///< position of the element, in coordinates of the data
  int Left, Bottom; ///< of the first digit, in pixels
  double Depth;     ///< from 0 (near) to 1; in front of everything of the mesh behind the label
};

/// Sizes of digits in pixels.
struct DigitSize
{
  int Width = 1; ///< distance from one digit to the next
  int Height = 1;
  int Margin = 1; ///< around the digits
};

class LabelChoice
{
public:
  struct Picture
  {
    const VisiblePixels& Pixels;
    vtkMatrix4x4* ToView;
    vtkMatrix4x4* ToDisplay;
    bool IsParallel; ///< parallel projection
    int Width, Height;
    DigitSize Digits;
    /// For a translucent mesh, triangle << 1 | side of all its triangles; null: use the visible
    /// pixels.
    const std::vector<std::uint32_t>* Entries;
  };

  LabelChoice(const LabelMesh& mesh, const LabelStyle& style, const Picture& picture);
  std::vector<IdLabel> Choose();

private:
  struct Candidate
  {
    float Distance;
    LabelKind Kind;
    std::uint32_t First, Second; ///< points of an edge; point, face or cell
    std::uint32_t Entry;

    bool operator>(const Candidate& other) const;
  };
  struct Rectangle
  {
    int Left, Bottom, Right, Top; // the last two are exclusive
  };

  void Gather();
  void GatherEntry(std::uint32_t entry);
  void Add(LabelKind kind, std::uint32_t first, std::uint32_t second, std::uint32_t entry);
  Place GetPlace(const Candidate& candidate) const;
  bool Project(const Place& place, double pixel[2], double& depth) const;
  bool IsSeen(const Candidate& candidate, const double pixel[2]) const;
  bool IsPartOf(const Candidate& candidate, std::uint32_t entry) const;
  vtkIdType GetId(const Candidate& candidate) const;
  bool Take(const Rectangle& rectangle);
  double FindDepth(const Rectangle& rectangle, double depth) const;
  bool HasLabel(std::uint32_t entryOfFace) const;
  bool Try(const Candidate& candidate, IdLabel& label);

  const LabelMesh& Mesh;
  const LabelStyle& Style;
  const Picture& Of;
  std::vector<Candidate> Candidates;
  std::vector<bool> HasPoint, HasFace, HasCell; // elements that are candidates
  OfLabelKinds<std::unordered_set<std::uint64_t>> Done;
  // Blocks of pixels that are covered by labels.
  int TakenWidth = 0;
  std::vector<bool> Taken;
};
}

#endif
