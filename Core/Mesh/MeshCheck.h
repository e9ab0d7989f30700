// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshCheck.h
 * @brief Rejects meshes with point ids out of range, and polyhedra that have lost their faces.
 */
#ifndef camaron_MeshCheck_h
#define camaron_MeshCheck_h

#include <cstdint> // for counts

class vtkDataSet;

namespace camaron
{
/**
 * Checks the point ids of a vtkUnstructuredGrid or vtkPolyData, in one parallel pass over its
 * cells; other data sets have none.
 * @throw std::runtime_error if a point id is out of range; the message names the first such cell
 */
void CheckPointIds(vtkDataSet* data);

/**
 * Distinguishes meshes whose polyhedra have all lost their faces, as when VTK before 9.4 reads
 * files of later versions, from meshes with single broken polyhedra. Add counts over all data sets
 * of a mesh; sum the counts over all ranks before Check.
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
