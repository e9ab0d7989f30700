// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshOutputs.h
 * @brief Copies of meshes with more arrays, as outputs after some tables.
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
/// By the flat index of the data set, 0 for one that is not composite.
using NewCellArrays = std::map<unsigned int, std::vector<vtkSmartPointer<vtkDoubleArray>>>;

/// Changes a copy of a data set.
using ChangeDataSet = std::function<void(vtkDataSet* copy, unsigned int flatIndex)>;

/// Makes @a output, of the same type, a shallow copy of @a input whose data sets are changed.
void CopyDataSets(vtkDataObject* input, vtkDataObject* output, const ChangeDataSet& change);

/// The same with arrays added.
void CopyWithCellArrays(vtkDataObject* input, const NewCellArrays& arrays, vtkDataObject* output);

/// For RequestDataObject: the first @a numberOfTables outputs are tables, the next is of the type
/// of @a mesh.
void MakeTablesAndMesh(int numberOfTables, vtkDataObject* mesh, vtkInformationVector* outputVector);
}

#endif
