// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PieceGathering.h
 * @brief Brings a mesh that several processes have to the one that writes it.
 *
 * VTK's own way (vtkMultiProcessController::Gather of data objects, as vtkParallelSerialWriter uses it)
 * goes through the legacy file format, which takes minutes and ten times the memory for a million
 * polyhedra, even within one process. Here the arrays themselves travel.
 */
#ifndef camaron_PieceGathering_h
#define camaron_PieceGathering_h

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkDataSet;
class vtkMultiProcessController;

namespace camaron
{
/**
 * One mesh of all that this process has: a vtkUnstructuredGrid or vtkPolyData without seams as it is;
 * else all leaves of composite data, whatever their types, merged to a vtkUnstructuredGrid as MergePieces
 * does.
 */
vtkSmartPointer<vtkDataSet> MergeLeaves(vtkDataObject* data);

/**
 * Sends the mesh of every process to process 0, where all are merged; returns the result there, and
 * nullptr elsewhere. All processes must call it.
 */
vtkSmartPointer<vtkDataSet> Gather(vtkDataSet* mesh, vtkMultiProcessController* controller);
}

#endif
