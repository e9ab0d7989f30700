// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PieceGathering.h
 * @brief Brings a mesh that several processes have to the one that writes it.
 *
 * VTK's own way (vtkMultiProcessController::Gather of data objects, as vtkParallelSerialWriter uses
 * it) goes through the legacy file format, which takes minutes and ten times the memory for a
 * million polyhedra, even within one process. Here the arrays themselves travel.
 */
#ifndef camaron_PieceGathering_h
#define camaron_PieceGathering_h

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkDataSet;
class vtkMultiProcessController;

namespace camaron
{
class Warnings;

/**
 * One mesh of all that the processes have, on process 0; nullptr on the others. A single
 * vtkUnstructuredGrid or vtkPolyData without seams stays as it is; else all leaves of composite
 * data, whatever their types, are merged to a vtkUnstructuredGrid as MergeParts does, block by
 * block. All processes must call it.
 * @param controller none for what this process has
 * @throw std::runtime_error on all processes, for polyhedra none of which has a face, and for
 * "vtkGhostType" that VTK does not know
 */
vtkSmartPointer<vtkDataSet> Gather(
  vtkDataObject* data, vtkMultiProcessController* controller, Warnings& warnings);
}

#endif
