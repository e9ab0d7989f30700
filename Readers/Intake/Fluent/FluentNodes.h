// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentNodes
 * @brief Reads the coordinates of a Fluent file.
 */
#ifndef camaron_FluentNodes_h
#define camaron_FluentNodes_h

#include "Intake/Fluent/FluentFile.h"
#include "Intake/Ids/IdSet.h"
#include "Intake/Pieces/PieceOfSpace.h"

#include "vtkSmartPointer.h"

class vtkDataArray;

namespace camaron
{
class FluentNodes
{
public:
  explicit FluentNodes(FluentFile& file)
    : File(file)
  {
  }

  /// Number of nodes, after checking that the sections define all of them; -1 with the error in the
  /// file.
  vtkIdType Count() const;

  /// Passes all nodes, from any thread; false with the error in the file, or if aborted.
  bool ForEach(const PieceOfSpace::Visit& visit, const Progress& progress) const;

  /**
   * Coordinates: float if all sections are binary in single precision, else double. nullptr with
   * the error in the file, or if aborted.
   * @param nodes their number
   * @param some the nodes to read, numbered; nullptr for all
   */
  vtkSmartPointer<vtkDataArray> Read(
    vtkIdType nodes, const IdSet* some, const Progress& progress) const;

private:
  using Visit = PieceOfSpace::Visit;
  int GetDimension(const FluentSection& section) const;
  bool VisitSection(
    const FluentSection& section, const Visit& visit, const Progress& progress) const;
  /// Calls pass(first, last, coordinates) until it returns false; false then, or with the error.
  bool VisitText(const FluentSection& section,
    FunctionRef<bool(std::int64_t, std::int64_t, const double*)> pass) const;
  template <typename Array, typename Real>
  vtkSmartPointer<vtkDataArray> ReadAs(
    vtkIdType nodes, const IdSet* some, const Progress& progress) const;

  FluentFile& File;
};
}

#endif
