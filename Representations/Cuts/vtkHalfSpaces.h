// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHalfSpaces
 * @brief vtkPlanes that are told one by one: the convex polyhedron, open or closed, that is behind
 * all of them.
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
  /// Six numbers are a plane: a point of it and its normal, of any length, which points outward.
  /// Default: none.
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
