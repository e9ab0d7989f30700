// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GatheredMesh.h
 * @brief Merges blocks, and pieces from several processes, to one mesh.
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
 * Whether a mesh has ghost or hidden cells, several points with the same global id and position, or
 * points or cells that are not sorted by global id, as may happen after pieces were appended.
 */
bool HasSeams(vtkDataSet* mesh);

/**
 * Merges parts to a mesh that does not depend on how it was split. Ghost and hidden cells are
 * dropped, and points that only these use. If all parts have global point ids, points with the same
 * id and position are merged and all points are sorted by id; if all have global cell ids, cells
 * are sorted by id. Otherwise the order of the parts is kept, and the points of each block are
 * merged by global id or, if its pieces have none, where points of different pieces coincide. If a
 * piece has several points at one position, the matching one is ambiguous, so they stay separate.
 *
 * The result has the arrays that all parts have. Numeric arrays that some parts lack are filled
 * with NaN there (0 for integers); arrays whose types differ between parts become double. Global
 * ids and ghost arrays of some parts are skipped. A merged point has the values of the first one.
 * Field data is merged from all parts; the first array of a name wins.
 * @param parts sorted by block
 */
vtkSmartPointer<vtkUnstructuredGrid> MergeParts(
  const std::vector<MeshPart>& parts, Warnings& warnings);
}

#endif
