// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshCheck.h
 * @brief Finds cells that would be read beyond the points of their mesh.
 */
#ifndef camaron_MeshCheck_h
#define camaron_MeshCheck_h

class vtkDataSet;

namespace camaron
{
/**
 * Throws std::runtime_error, naming the first such cell, if a cell of a vtkUnstructuredGrid or vtkPolyData has
 * a point that the mesh does not have. Other data sets have none of these. One parallel pass over the cells.
 */
void CheckPointIds(vtkDataSet* data);
}

#endif
