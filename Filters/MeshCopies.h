// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshCopies.h
 * @brief Copies of meshes with more cell arrays, as outputs after some tables.
 */
#ifndef camaron_MeshCopies_h
#define camaron_MeshCopies_h

#include "vtkSmartPointer.h" // for arrays

#include <map>    // for the data sets
#include <vector> // for lists of arrays

class vtkDataObject;
class vtkDoubleArray;
class vtkInformationVector;

namespace camaron
{
/// By the flat index of the data set, 0 for one that is not composite.
using NewCellArrays = std::map<unsigned int, std::vector<vtkSmartPointer<vtkDoubleArray>>>;

/// Makes @a output, of the same type, a shallow copy of @a input with the arrays.
void CopyWithCellArrays(vtkDataObject* input, const NewCellArrays& arrays, vtkDataObject* output);

/// For RequestDataObject: the first @a numberOfTables outputs are tables, the next is of the type of @a mesh.
void MakeTablesAndMesh(int numberOfTables, vtkDataObject* mesh, vtkInformationVector* outputVector);
}

#endif
