// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GatheredMesh.h
 * @brief Makes one mesh of pieces that several processes had.
 */
#ifndef camaron_GatheredMesh_h
#define camaron_GatheredMesh_h

#include "vtkSmartPointer.h"

class vtkDataSet;

namespace camaron
{
/**
 * Leaves out ghost and hidden cells, and points that only these use. If several points have the same
 * global id, all points are merged and sorted by it. Returns @a mesh itself if there is nothing to do,
 * else a vtkUnstructuredGrid without arrays.
 * @param mesh a vtkUnstructuredGrid or vtkPolyData
 */
vtkSmartPointer<vtkDataSet> MergePieces(vtkDataSet* mesh);
}

#endif
