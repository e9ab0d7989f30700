// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGhostRequests
 * @brief Sets the number of layers of ghost cells that ParaView requests from sources, on all
 * processes of a server.
 *
 * With several processes ParaView requests one layer, because Surface needs it to find outer faces.
 * If the cells of a mesh are not sorted by position, one layer around a piece is most of the mesh.
 * Filters and Mesh Inspection of this plugin need no ghost cells.
 */
#ifndef vtkGhostRequests_h
#define vtkGhostRequests_h

#include "CamaronFiltersModule.h"
#include "vtkObject.h"

class CAMARONFILTERS_EXPORT vtkGhostRequests : public vtkObject
{
public:
  static vtkGhostRequests* New();
  vtkTypeMacro(vtkGhostRequests, vtkObject);

  /// Layers for unstructured data, from now on and for all pipelines of the process. ParaView
  /// starts with 1.
  void SetLayers(int layers);

protected:
  vtkGhostRequests() = default;
  ~vtkGhostRequests() override = default;

private:
  vtkGhostRequests(const vtkGhostRequests&) = delete;
  void operator=(const vtkGhostRequests&) = delete;
};

#endif
