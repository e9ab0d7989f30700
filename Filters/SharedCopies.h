// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedCopies.h
 * @brief Lets cells share points again that a mesh has several times.
 */
#ifndef camaron_SharedCopies_h
#define camaron_SharedCopies_h

#include "vtkDataSet.h"      // for the result
#include "vtkSmartPointer.h" // for the result

namespace camaron
{
/**
 * The mesh itself, or if it has points of the same global id at the same place, as a reader leaves them that puts
 * several pieces of a file together, one with the same points and cells in which all cells have the first of them.
 * Point ids of cells must be valid.
 */
vtkSmartPointer<vtkDataSet> ShareCopiesOfPoints(vtkDataSet* mesh);
}

#endif
