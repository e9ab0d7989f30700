// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshCheck.h
 * @brief Rejects meshes whose cells cannot be read, and polyhedra that have lost their faces.
 */
#ifndef camaron_MeshCheck_h
#define camaron_MeshCheck_h

#include <cstdint> // for counts

class vtkDataSet;

namespace camaron
{
/**
 * Checks the cells of a vtkUnstructuredGrid or vtkPolyData; other data sets have none. Afterwards
 * MeshView reads nothing but what is there:
 *
 * - every cell has a type, and a number of points that its type can have,
 * - the lists of points and faces lie in their arrays,
 * - the points and faces of every cell exist. Faces without a cell may have other point ids.
 *
 * In one parallel pass over each array, without additional memory.
 * @throw std::runtime_error that names the first such cell
 */
void CheckCells(vtkDataSet* data);

/**
 * Distinguishes meshes whose polyhedra have all lost their faces, as when VTK before 9.4 reads
 * files of later versions, from meshes with single broken polyhedra. Add counts over all data sets
 * of a mesh, which CheckCells accepts; sum the counts over all ranks before Check.
 */
struct PolyhedronFaces
{
  std::int64_t NumberWithFaces = 0;   ///< data sets with polyhedra that have faces
  std::int64_t NumberOfPolyhedra = 0; ///< in the other data sets

  void Add(vtkDataSet* data);
  /// @throw std::runtime_error if there are polyhedra, but none of them has faces
  void Check() const;
};
}

#endif
