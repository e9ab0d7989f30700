// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkElementOverlay
 * @brief Draws a few elements over everything else in a view, as if the mesh around them were
 * glass.
 *
 * Their surface is a film of one color with their edges on it. All processes get all elements, and
 * those that show the view draw them, so they are for small parts of a mesh: selections.
 */
#ifndef vtkElementOverlay_h
#define vtkElementOverlay_h

#include "vtkNew.h" // for the actor
#include "vtkPVDataRepresentation.h"

class vtkActor;
class vtkDataSetSurfaceFilter;
class vtkMergeBlocks;
class vtkPolyData;

class vtkElementOverlay : public vtkPVDataRepresentation
{
public:
  static vtkElementOverlay* New();
  vtkTypeMacro(vtkElementOverlay, vtkPVDataRepresentation);

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

  void SetVisibility(bool isVisible) override;

  /// The overlay is empty if there are more cells on all processes. Default: 100,000.
  vtkSetMacro(MostCells, vtkIdType);

  /// Color of film and edges. Default: magenta, as ParaView's selections.
  void SetColor(double red, double green, double blue);

protected:
  vtkElementOverlay();
  ~vtkElementOverlay() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkElementOverlay(const vtkElementOverlay&) = delete;
  void operator=(const vtkElementOverlay&) = delete;

  vtkNew<vtkMergeBlocks> Blocks;
  vtkNew<vtkDataSetSurfaceFilter> Surface;
  vtkNew<vtkPolyData> Drawn;
  vtkNew<vtkActor> Actor;
  vtkIdType MostCells = 100000;
};

#endif
