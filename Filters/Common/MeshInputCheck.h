// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshInputCheck.h
 * @brief Refuses input that is no mesh.
 */
#ifndef camaron_MeshInputCheck_h
#define camaron_MeshInputCheck_h

#include "ElementBlocks.h"

namespace camaron
{
/**
 * Collective. Throws std::runtime_error on all processes if cells of one have points that are not there, if
 * "vtkGhostType" is none that VTK knows, or if there are polyhedra but none that has a face.
 */
void CheckMeshes(const std::vector<DataSetLeaf>& leaves, Reducer& reducer);
}

#endif
