// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolyDataOutput.h
 * @brief Outputs with one vtkPolyData per data set of the input.
 *
 * For filters whose processes must work together. VTK would execute a plain vtkPolyData filter
 * block by block, each process for its own blocks.
 */
#ifndef camaron_PolyDataOutput_h
#define camaron_PolyDataOutput_h

#include <vector> // for the leaves

class vtkDataObject;
class vtkInformationVector;
class vtkPolyData;

namespace camaron
{
/// For RequestDataObject: makes each output a vtkPolyData, or a composite data set of the type of
/// the input.
void MakePolyDataOutputs(vtkInformationVector** inputVector, vtkInformationVector* outputVector);

/**
 * Gives such an output the structure of the input.
 *
 * @return empty vtkPolyData, one for each data set of GetLeaves(input), in that order
 */
std::vector<vtkPolyData*> MakePolyDataLeaves(vtkDataObject* input, vtkDataObject* output);
}

#endif
