// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GatheredArrays.h
 * @brief Arrays of a mesh that was made of pieces.
 */
#ifndef camaron_GatheredArrays_h
#define camaron_GatheredArrays_h

#include "GatheredPieces.h"

class vtkFieldData;
class vtkUnstructuredGrid;

namespace camaron
{
/// Gives points and cells of @a grid, which is made of the pieces, the values they had there.
/// Arrays that cannot be joined are told.
void MergeArrays(const GatheredPieces& pieces, vtkUnstructuredGrid* grid, Warnings& warnings);

/// Of arrays of the same name, those of the first part.
void MergeFieldData(const std::vector<MeshPart>& parts, vtkFieldData* merged);
}

#endif
