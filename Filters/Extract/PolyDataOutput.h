// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolyDataOutput.h
 * @brief Outputs with a vtkPolyData for each data set of the input.
 *
 * For filters whose processes must work together; VTK would run them block by block, each process
 * for its own.
 */
#ifndef camaron_PolyDataOutput_h
#define camaron_PolyDataOutput_h

#include <vector> // for the leaves

class vtkDataObject;
class vtkInformationVector;
class vtkPolyData;

namespace camaron
{
/// For RequestDataObject: makes each output a vtkPolyData, or the kind of blocks that the input is.
void MakePolyDataOutputs(vtkInformationVector** inputVector, vtkInformationVector* outputVector);

/**
 * Gives an output of that kind the structure of the input.
 * @return the vtkPolyData, empty, that belong to the data sets of GetLeaves(input), in their order
 */
std::vector<vtkPolyData*> MakePolyDataLeaves(vtkDataObject* input, vtkDataObject* output);
}

#endif
