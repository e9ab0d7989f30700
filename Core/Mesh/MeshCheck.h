// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshCheck.h
 * @brief Finds what would be read beyond the arrays of a mesh, and polyhedra that have lost their
 * faces.
 */
#ifndef camaron_MeshCheck_h
#define camaron_MeshCheck_h

#include <cstdint> // for counts

class vtkDataSet;

namespace camaron
{
/**
 * Throws std::runtime_error, naming the first such cell, if a cell of a vtkUnstructuredGrid or
 * vtkPolyData has a point that the mesh does not have. Other data sets have none of these. One
 * parallel pass over the cells.
 */
void CheckPointIds(vtkDataSet* data);

/**
 * Tells meshes of polyhedra that have lost all their faces, as readers of VTK before 9.4 do with
 * files of later ones, from those in which some polyhedron is broken. Counts are added up over all
 * data sets and processes of a mesh.
 */
struct PolyhedronFaces
{
  std::int64_t NumberWithFaces = 0;   ///< of data sets
  std::int64_t NumberOfPolyhedra = 0; ///< of the other ones

  void Add(vtkDataSet* data);
  /// Throws std::runtime_error if there are polyhedra, and none of them has a face.
  void Check() const;
};
}

#endif
