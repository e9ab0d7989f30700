// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshChecks.h
 * @brief Whether a mesh is one that filters can work with, and whether two are the same.
 */
#ifndef camaron_MeshChecks_h
#define camaron_MeshChecks_h

#include <string> // for what is wrong

class vtkDataObject;
class vtkUnstructuredGrid;

namespace camaron
{
namespace testing
{
/**
 * What is wrong with a mesh, or nothing: ids in range, offsets that ascend and end where the list
 * ends, cells with as many points as their type has, polyhedra whose faces exist, arrays of the
 * right length. Reads every value of every array.
 */
std::string FindFault(vtkUnstructuredGrid* grid);

/// The same for any data object: of all its blocks.
std::string FindFault(vtkDataObject* data);

/// The first difference between two grids, bit by bit, arrays included, or nothing.
std::string FindDifference(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b);

/// The same of points, cells and faces only.
std::string FindDifferenceOfCells(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b);
}
}

#endif
