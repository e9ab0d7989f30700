// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GatheredMesh.h
 * @brief Makes one mesh of its blocks, and of pieces that several processes had.
 */
#ifndef camaron_GatheredMesh_h
#define camaron_GatheredMesh_h

#include "vtkSmartPointer.h"

#include <vector> // for parts

class vtkDataSet;
class vtkUnstructuredGrid;

namespace camaron
{
class Warnings;

/// A part of a mesh: a vtkUnstructuredGrid or vtkPolyData.
struct MeshPart
{
  vtkSmartPointer<vtkDataSet> Mesh;
  int Block = 0; ///< parts of one block are pieces of one mesh
};

/**
 * Whether a mesh has ghost or hidden cells, several points of the same global id and place, or
 * points or cells that do not follow each other by global id, as it may after pieces were put
 * together.
 */
bool HasSeams(vtkDataSet* mesh);

/**
 * Puts parts together, so that the mesh does not depend on how it was split: their cells without
 * ghost and hidden ones, and their points without those that only such cells use. If all parts have
 * global ids of points, points of the same id and place are merged and all are sorted by id; if all
 * have global ids of cells, cells are sorted by them. Otherwise they stay in the order of the
 * parts, and the points of each block are merged by global id or, if its pieces have none, where
 * points of different pieces are at the same place. Which of several points of a piece at one place
 * was meant cannot be told; they stay apart.
 *
 * Arrays are those of all parts, see AddPartialArrays for what not all have; a merged point has the
 * values of the first. Field data is that of all parts, by name of the first.
 * @param parts sorted by block
 */
vtkSmartPointer<vtkUnstructuredGrid> MergeParts(
  const std::vector<MeshPart>& parts, Warnings& warnings);
}

#endif
