// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHalfSpaces
 * @brief vtkPlanes defined one by one: an intersection of half-spaces, that is, a bounded or
 * unbounded convex polyhedron.
 *
 * @sa vtkMeshInspectionRepresentation::SetCutShape
 */
#ifndef vtkHalfSpaces_h
#define vtkHalfSpaces_h

#include "vtkPlanes.h"

#include <vector> // for the numbers

class vtkHalfSpaces : public vtkPlanes
{
public:
  static vtkHalfSpaces* New();
  vtkTypeMacro(vtkHalfSpaces, vtkPlanes);

  ///@{
  /// Six numbers define a plane: a point and the outward normal, of any length. Default: none.
  void AddNumber(double number);
  void ClearNumbers();
  std::size_t GetNumberOfNumbers() const { return this->Numbers.size(); }
  ///@}

protected:
  vtkHalfSpaces();
  ~vtkHalfSpaces() override = default;

private:
  std::vector<double> Numbers;

  vtkHalfSpaces(const vtkHalfSpaces&) = delete;
  void operator=(const vtkHalfSpaces&) = delete;
};

#endif
