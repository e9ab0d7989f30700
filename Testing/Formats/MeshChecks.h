// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshChecks.h
 * @brief Checks whether a mesh is valid for filters, and whether two are the same.
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
 * Describes what is invalid in a mesh; empty if it is valid: ids are in range, offsets ascend and
 * end at the end of the list, cells have the number of points of their type, faces of polyhedra
 * exist, arrays have the right length. Reads every value of every array.
 */
std::string FindFault(vtkUnstructuredGrid* grid);

/// The same for all blocks of any data object.
std::string FindFault(vtkDataObject* data);

/// The first difference between two grids, bit by bit, including arrays; empty if there is none.
std::string FindDifference(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b);

/// The same for points, cells and faces only.
std::string FindDifferenceOfCells(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b);
}
}

#endif
