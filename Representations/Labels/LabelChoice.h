// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::LabelChoice
 * @brief Chooses the elements of a mesh that carry their ids in a picture, and where these stand in
 * it.
 *
 * Those nearest to the camera come first; the choice depends on nothing but the mesh, its style and
 * the camera. No label covers another one or leaves the picture. Points have theirs beside them;
 * edges, faces and cells in their middle. Of a mesh that one cannot see through, an element has a
 * label if the place of the label is seen: its point, the middle of the edge, of the face, of a
 * face of the cell. Otherwise all elements of visible faces have one.
 */
#ifndef camaron_LabelChoice_h
#define camaron_LabelChoice_h

#include "LabelMesh.h"

#include <unordered_set> // for what has a label

class vtkMatrix4x4;

namespace camaron
{
class VisiblePixels;

struct IdLabel
{
  LabelKind Kind;
  vtkIdType Id;
  Place At;         ///< what it is the label of, in the coordinates of the data
  int Left, Bottom; ///< pixels, of the first digit
  double Depth;     ///< from 0, near, to 1; in front of all of the mesh behind it
};

/// Sizes of what is written, in pixels.
struct DigitSize
{
  int Width = 1; ///< from one digit to the next
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
    bool IsParallel; ///< the camera looks from infinitely far away
    int Width, Height;
    DigitSize Digits;
    /// triangle << 1 | side of all that is there, for a mesh that one can see through; null: what
    /// the pixels show.
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
    int Left, Bottom, Right, Top; // without the last two
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
  std::vector<bool> HasPoint, HasFace, HasCell; // that are candidates
  OfLabelKinds<std::unordered_set<std::uint64_t>> Done;
  // Blocks of pixels that labels cover.
  int TakenWidth = 0;
  std::vector<bool> Taken;
};
}

#endif
