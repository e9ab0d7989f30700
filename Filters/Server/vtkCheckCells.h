// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCheckCells
 * @brief Passes on a mesh whose cells can be read, and fails on others, on all processes.
 *
 * For the commands, which pass meshes to filters, writers and representations of ParaView. These
 * read beyond the points of a cell that has too few for its type. Output: a shallow copy of the
 * input, of the same type; empty after an error, which names the first such cell (CheckCells).
 */
#ifndef vtkCheckCells_h
#define vtkCheckCells_h

#include "vtkPassInputTypeAlgorithm.h"

class vtkCheckCells : public vtkPassInputTypeAlgorithm
{
public:
  static vtkCheckCells* New();
  vtkTypeMacro(vtkCheckCells, vtkPassInputTypeAlgorithm);

protected:
  vtkCheckCells() = default;
  ~vtkCheckCells() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCheckCells(const vtkCheckCells&) = delete;
  void operator=(const vtkCheckCells&) = delete;
};

#endif
