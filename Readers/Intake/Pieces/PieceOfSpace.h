// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PieceOfSpace
 * @brief Divides space into boxes, one per piece of a mesh, and finds the points in one of them.
 *
 * An element belongs to the piece whose box has its first point. So pieces are compact, and have
 * few ghosts, whatever the order of the elements in the file.
 *
 * The boxes are those of a k-d tree of about 1000 elements per piece, chosen by their ids: every
 * node of the tree divides its longest side in proportion to the numbers of pieces on both sides.
 * All boxes have about the same number of elements. Points with equal coordinates are divided by
 * their ids. Every process finds the same boxes from the file alone, so none sends a message.
 *
 * Memory: two bits per point of the file.
 */
#ifndef camaron_PieceOfSpace_h
#define camaron_PieceOfSpace_h

#include "Base/Hash.h"
#include "Intake/Ids/IdSet.h"
#include "Intake/Pieces/PieceRequest.h"

#include <algorithm>  // for ranges of ids
#include <functional> // for visiting points
#include <vector>     // for cuts

namespace camaron
{
class PieceOfSpace
{
public:
  using Visit = std::function<void(vtkIdType point, const double* x)>;
  /// Passes all points once, in any order, from any thread; false on errors or if stopped.
  using ForEachPoint = std::function<bool(const Visit& visit)>;

  ///@{
  /**
   * Finds the points: after Start, add all elements, in any order and from any thread, of which
   * only some are used. Then Find calls @a forEach twice; if it fails, it may be called again. If
   * the piece is the whole mesh, none of this is necessary.
   */
  void Start(vtkIdType numberOfPoints, vtkIdType numberOfElements, const PieceRequest& request);
  void Add(vtkIdType element, vtkIdType first)
  {
    const vtkIdType i = element / this->Range;
    if (static_cast<std::size_t>(i) < this->Firsts.size() && element == this->Chosen(i))
    {
      this->Firsts[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(first);
    }
  }
  bool Find(const ForEachPoint& forEach);
  ///@}

  ///@{
  /// Whether elements with this first point belong to the piece, or to one before it. Elements
  /// without points, for which any invalid id is passed, belong to the first piece.
  bool Has(vtkIdType first) const
  {
    return this->IsPoint(first) ? this->Own.Contains(first) : this->IsFirst;
  }
  bool IsBefore(vtkIdType first) const
  {
    return this->IsPoint(first) ? this->Before.Contains(first) : !this->IsFirst;
  }
  ///@}

private:
  struct Sample
  {
    float X[3] = { 0, 0, 0 }; ///< float, as rounding does not matter here
    std::int32_t Point = -1;
  };
  static Sample MakeSample(vtkIdType point, const double* x);
  /// A side of a plane.
  struct Cut
  {
    Sample At;
    int Axis = 0;
    bool IsAbove = false; ///< the side of the piece
  };
  static bool IsBelow(const Sample& a, const Sample& b, int axis)
  {
    return a.X[axis] < b.X[axis] || (a.X[axis] == b.X[axis] && a.Point < b.Point);
  }

  /// The element that stands for a range of ids; any, because the ids of some meshes follow a
  /// pattern.
  vtkIdType Chosen(vtkIdType range) const
  {
    const vtkIdType begin = range * this->Range;
    const vtkIdType size = std::min(this->Range, this->NumberOfElements - begin);
    return begin +
      static_cast<vtkIdType>(
        Mix(static_cast<std::uint64_t>(range)) % static_cast<std::uint64_t>(size));
  }
  bool FindSamples(const ForEachPoint& forEach, std::vector<Sample>& samples) const;
  void FindBox(std::vector<Sample>& samples);
  bool IsPoint(vtkIdType id) const
  {
    return static_cast<std::uint64_t>(id) < static_cast<std::uint64_t>(this->Own.GetLimit());
  }

  int Piece = 0;
  int NumberOfPieces = 1;
  bool IsFirst = true;
  vtkIdType NumberOfElements = 0;
  vtkIdType Range = 1;
  std::vector<std::int32_t> Firsts; ///< first points of chosen elements
  std::vector<Cut> Box;
  IdSet Own, Before;
};
}

#endif
