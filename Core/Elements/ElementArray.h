// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ElementArray.h
 * @brief The arrays available for faces, edges and vertices of a mesh, and their functions.
 */
#ifndef camaron_ElementArray_h
#define camaron_ElementArray_h

#include "Cell/CellNeighborhood.h"
#include "Criteria/Criterion.h"
#include "Elements/ElementContext.h"

#include <algorithm> // for copies
#include <cmath>     // for NaN
#include <string>    // for names of arrays
#include <vector>    // for lists of arrays

class vtkPolyData;

namespace camaron
{
/// A row of the tables of arrays. Texts appear in the documentation.
struct ElementArray
{
  const char* Name;        ///< array name in CamelCase; never changes
  const char* Label;       ///< display name
  const char* Description; ///< definition in one sentence, then remarks
  unsigned Dimensions;     ///< CellDimensions; the mesh must have cells of at least one of them
  enum camaron::Unit Unit;
  bool IsDefault; ///< whether it is on by default

  ///@{
  /**
   * One of them is set. The first three fill an array for all elements. FacetFunction (for faces
   * of 3D cells) and ShapeFunction (for any faces) return the value of one face and share a pass
   * over the cells. Plane angles are in radians.
   */
  void (*IdFunction)(const ElementContext& context, vtkIdType* values);
  void (*FlagFunction)(const ElementContext& context, unsigned char* values);
  void (*RealFunction)(const ElementContext& context, double* values);
  double (*FacetFunction)(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
  double (*ShapeFunction)(const CellGeometry& cell, int face);
  ///@}

  /// Name of the criterion of cells that is the worst of these values in a cell. The array has its
  /// good end, ideal value and acceptable range; see ElementCriteria.h. Default: none.
  const char* Criterion = "";
  ///@{
  /// Good end and ideal value without such a criterion.
  camaron::Better Better = camaron::Better::Neither;
  double Ideal = NAN;
  ///@}
};

/// Columns of a row that set one of the functions.
#define CAMARON_IDS(Function) Function, nullptr, nullptr, nullptr, nullptr
#define CAMARON_FLAGS(Function) nullptr, Function, nullptr, nullptr, nullptr
#define CAMARON_REALS(Function) nullptr, nullptr, Function, nullptr, nullptr
#define CAMARON_FACETS(Function) nullptr, nullptr, nullptr, Function, nullptr
#define CAMARON_SHAPES(Function) nullptr, nullptr, nullptr, nullptr, Function

///@{
/**
 * All arrays, in display order. A name may occur twice for different dimensions; the first row
 * with matching cells in the mesh counts.
 */
const std::vector<ElementArray>& GetFaceArrays();
const std::vector<ElementArray>& GetEdgeArrays();
const std::vector<ElementArray>& GetVertexArrays();
///@}

/**
 * Adds the arrays with the given names as cell arrays with UNITS_LABEL, and the points of the mesh
 * with their data. Nothing else is computed. Returns ElementContext::GoesOn.
 */
bool AddElementArrays(const ElementContext& context, const std::vector<ElementArray>& rows,
  const std::vector<std::string>& names, vtkPolyData* elements);

/// Adds "vtkGhostType" to the elements and returns its values, initially 0.
unsigned char* AddGhostArray(vtkPolyData* elements);

/// A function of an array that copies the values of one of the tables of ElementContext.
template <auto GetTable, auto Column, typename Value>
void CopyOf(const ElementContext& context, Value* values)
{
  const auto& column = (context.*GetTable)().*Column;
  std::copy(column.begin(), column.end(), values);
}

/// Fills the values of rows with a FacetFunction or ShapeFunction; @a values are parallel to
/// @a rows.
void EvaluateFaces(const ElementContext& context, const std::vector<const ElementArray*>& rows,
  const std::vector<double*>& values);
}

#endif
