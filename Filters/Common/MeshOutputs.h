// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshOutputs.h
 * @brief Outputs of filters: copies of meshes with additional arrays, tables, and one vtkPolyData
 * per data set of the input.
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
class vtkPolyData;
class vtkUnsignedCharArray;

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

/// The number of pieces in which the pipeline works, which may exceed that of the processes.
int GetNumberOfPieces(vtkInformationVector* outputs);

/// For RequestDataObject: creates an output of this type (VTK_POLY_DATA, ...) unless it exists.
void MakeOutput(int type, int port, vtkInformationVector* outputVector);

/// For RequestDataObject: creates @a numberOfTables tables as the first outputs, and a data object
/// of the type of @a mesh as the next one.
void MakeTablesAndMesh(int numberOfTables, vtkDataObject* mesh, vtkInformationVector* outputVector);

/// For RequestDataObject of filters whose processes must work together: makes each output a
/// vtkPolyData, or a composite data set of the type of the input. VTK would execute a plain
/// vtkPolyData filter block by block, each process for its own blocks.
void MakePolyDataOutputs(vtkInformationVector** inputVector, vtkInformationVector* outputVector);

/**
 * Gives such an output the structure of the input.
 *
 * @return empty vtkPolyData, one for each data set of GetLeaves(input), in that order
 */
std::vector<vtkPolyData*> MakePolyDataLeaves(vtkDataObject* input, vtkDataObject* output);

/// Creates the array "<name>_Undefined" with the camaron::NullReason of each value; 0 if it is
/// defined.
/// @a values are cell values of @a mesh.
vtkSmartPointer<vtkUnsignedCharArray> MakeUndefinedMask(vtkDoubleArray* values, vtkDataSet* mesh);
}

#endif
