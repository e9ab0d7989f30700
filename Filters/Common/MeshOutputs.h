// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshOutputs.h
 * @brief Outputs that are copies of meshes with additional arrays, next to tables.
 */
#ifndef camaron_MeshOutputs_h
#define camaron_MeshOutputs_h

#include "vtkSmartPointer.h" // for arrays

#include <functional> // for changes
#include <map>        // for the data sets
#include <vector>     // for lists of arrays

class vtkDataObject;
class vtkDataSet;
class vtkDoubleArray;
class vtkInformationVector;

namespace camaron
{
/// Arrays to add, by flat index of the data set; 0 if the mesh is not composite.
using NewCellArrays = std::map<unsigned int, std::vector<vtkSmartPointer<vtkDoubleArray>>>;

/// A function that changes a copy of a data set.
using ChangeDataSet = std::function<void(vtkDataSet* copy, unsigned int flatIndex)>;

/// Makes @a output, which has the type of @a input, a shallow copy of it, and calls @a change for
/// each data set.
void CopyDataSets(vtkDataObject* input, vtkDataObject* output, const ChangeDataSet& change);

/// Makes @a output a shallow copy of @a input with additional cell arrays.
void CopyWithCellArrays(vtkDataObject* input, const NewCellArrays& arrays, vtkDataObject* output);

/// For RequestDataObject: creates an output of this type (VTK_POLY_DATA, ...) unless it exists.
void MakeOutput(int type, int port, vtkInformationVector* outputVector);

/// For RequestDataObject: creates @a numberOfTables tables as the first outputs, and a data object
/// of the type of @a mesh as the next one.
void MakeTablesAndMesh(int numberOfTables, vtkDataObject* mesh, vtkInformationVector* outputVector);
}

#endif
