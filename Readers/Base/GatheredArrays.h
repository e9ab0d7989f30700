// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GatheredArrays.h
 * @brief Arrays of a mesh that was merged from pieces.
 */
#ifndef camaron_GatheredArrays_h
#define camaron_GatheredArrays_h

#include "GatheredPieces.h"

class vtkFieldData;
class vtkUnstructuredGrid;

namespace camaron
{
/// Copies the values of points and cells from the pieces to @a grid, which was merged from them.
/// Warns about arrays that cannot be joined.
void MergeArrays(const GatheredPieces& pieces, vtkUnstructuredGrid* grid, Warnings& warnings);

/// Merges field data; of arrays with the same name, the one of the first part is used.
void MergeFieldData(const std::vector<MeshPart>& parts, vtkFieldData* merged);
}

#endif
