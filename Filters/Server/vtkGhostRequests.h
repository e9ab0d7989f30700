// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGhostRequests
 * @brief Sets how many layers of ghost cells ParaView asks sources for, on all processes of a
 * server.
 *
 * ParaView asks for one as soon as there are several processes, for the outside of what Surface
 * draws. Of a mesh whose cells are in no order of place, a layer around a piece is most of the
 * mesh; filters and pictures of this plugin need none.
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
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Layers for unstructured data, from now on and for everything in the process. ParaView begins
  /// with 1.
  void SetLayers(int layers);
  int GetLayers() const;
  ///@}

protected:
  vtkGhostRequests() = default;
  ~vtkGhostRequests() override = default;

private:
  vtkGhostRequests(const vtkGhostRequests&) = delete;
  void operator=(const vtkGhostRequests&) = delete;
};

#endif
