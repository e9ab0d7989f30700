// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ElementPlaces.h
 * @brief Positions of elements, gathered on all processes.
 */
#ifndef camaron_ElementPlaces_h
#define camaron_ElementPlaces_h

#include "ElementBlocks.h"
#include "Statistics/Summary.h"
#include "Statistics/Worst.h"

#include "vtkIdList.h" // for points
#include "vtkNew.h"    // for points

#include <array>  // for coordinates
#include <set>    // for blocks
#include <string> // for names
#include <vector> // for positions

namespace camaron
{
/// Finds positions of elements; reuses its memory.
class PlaceFinder
{
public:
  /// Position of an element: the mean of the points of a cell, whatever their order, or the
  /// coordinates of a point.
  void Find(const ElementBlock& block, vtkIdType element, double place[3]);

private:
  vtkNew<vtkIdList> Ids;
  std::vector<double> Coordinates;
};

/// Position of a single element, see PlaceFinder.
void GetPlace(const ElementBlock& block, vtkIdType element, double place[3]);

/// Diagonal of the bounding box of the points of a cell, in the unit of the mesh; 0 for a point.
double GetSize(const ElementBlock& block, vtkIdType element);

/// CellType of points in WorstElement.
constexpr int PointCellType = -1;

/// Sets the members of an element of @a values that its owner, this process, knows.
void DescribeElement(
  const ElementBlocks& blocks, const BlockValues& values, int process, WorstElement& element);

/// Collective. Positions of elements of @a values, each of which exists on one process; NaN if no
/// process has it.
std::vector<std::array<double, 3>> FindPlaces(const std::vector<ElementPlace>& elements,
  const ElementBlocks& blocks, const BlockValues& values, Reducer& reducer);

/**
 * Ids of the points of cells, gathered on all processes.
 *
 * A point is identified by its global id if all points have one, else by VTK's id in its block. If
 * a block is split into several pieces, ids inside a piece are meaningless elsewhere, so its points
 * have no ids.
 */
class ElementVertices
{
public:
  /// Collective. Stores references to both arguments.
  ElementVertices(const ElementBlocks& blocks, Reducer& reducer);

  /**
   * Collective. For each element of @a values the ids of its points, separated by blanks, in the
   * order of the cell; ascending for polyhedra, whose points have no order. Empty if the points
   * have no ids, and for elements that are points.
   */
  std::vector<std::string> Find(
    const std::vector<WorstElement>& elements, const BlockValues& values) const;

private:
  std::string Describe(const ElementBlock& block, vtkIdType cell) const;

  const ElementBlocks& Blocks;
  camaron::Reducer& Reducer;
  bool HaveGlobalIds = false;
  std::set<int> BlocksInOnePiece; // numbers of the blocks that are not split
};
}

#endif
