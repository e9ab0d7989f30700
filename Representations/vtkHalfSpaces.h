// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHalfSpaces
 * @brief vtkPlanes that are told one by one: the convex polyhedron, open or closed, that is behind all of them.
 *
 * @sa vtkMeshInspectionRepresentation::SetCutShape
 */
#ifndef vtkHalfSpaces_h
#define vtkHalfSpaces_h

#include "vtkPlanes.h"

class vtkHalfSpaces : public vtkPlanes
{
public:
  static vtkHalfSpaces* New();
  vtkTypeMacro(vtkHalfSpaces, vtkPlanes);

  ///@{
  /// A plane by a point of it and its normal, of any length, which points outward. Default: none.
  void AddPlane(const double pointAndNormal[6]);
  void ClearPlanes();
  ///@}

protected:
  vtkHalfSpaces();
  ~vtkHalfSpaces() override = default;

private:
  vtkHalfSpaces(const vtkHalfSpaces&) = delete;
  void operator=(const vtkHalfSpaces&) = delete;
};

#endif
