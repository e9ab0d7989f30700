// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PieceGathering.h
 * @brief Collects a distributed mesh on the process that writes it.
 *
 * VTK's own method (vtkMultiProcessController::Gather of data objects, as in
 * vtkParallelSerialWriter) serializes to the legacy file format, which takes minutes and ten times
 * the memory for a million polyhedra, even within one process. This code sends the arrays.
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
 * Gathers the mesh of all processes on process 0; nullptr on the others. A single
 * vtkUnstructuredGrid or vtkPolyData without seams (see HasSeams) is returned unchanged; otherwise
 * all leaves of composite data, of any type, are merged block by block into a vtkUnstructuredGrid,
 * see MergeParts. Collective: all processes must call it.
 * @param controller nullptr to gather the blocks of this process only
 * @param namesZones whether names of blocks become zones, see NameZones
 * @throw std::runtime_error on all processes, for cells that cannot be read (CheckCells), polyhedra
 * of which none has a face, and a "vtkGhostType" array that VTK does not recognize
 */
vtkSmartPointer<vtkDataSet> Gather(
  vtkDataObject* data, vtkMultiProcessController* controller, bool namesZones, Warnings& warnings);
}

#endif
