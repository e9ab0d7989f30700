// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ElementArray.h
 * @brief The arrays that faces, edges and vertices of a mesh may have, and how they are filled.
 */
#ifndef camaron_ElementArray_h
#define camaron_ElementArray_h

#include "Cell/CellNeighborhood.h"
#include "Criteria/Criterion.h"
#include "Elements/ElementContext.h"

#include <string> // for names of arrays
#include <vector> // for lists of arrays

class vtkPolyData;

namespace camaron
{
/// One row of the tables of arrays. Text ends up in the documentation.
struct ElementArray
{
  const char* Name;        ///< array name, CamelCase, never changes
  const char* Description; ///< one sentence: definition, then remarks
  unsigned Dimensions;     ///< CellDimensions, at least one of which the mesh must have
  enum camaron::Unit Unit;
  bool IsDefault; ///< whether it is made unless the user says otherwise

  ///@{
  /**
   * One of them is set. The first three fill an array of the size of the elements; FacetFunction
   * (for faces of 3D cells) and ShapeFunction (for any faces) return the value of one face and
   * share a pass over the cells. Plane angles are in radian.
   */
  void (*IdFunction)(const ElementContext& context, vtkIdType* values);
  void (*FlagFunction)(const ElementContext& context, unsigned char* values);
  void (*RealFunction)(const ElementContext& context, double* values);
  double (*FacetFunction)(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
  double (*ShapeFunction)(const CellGeometry& cell, int face);
  ///@}
};

/// What rows are written with.
#define CAMARON_IDS(Function) Function, nullptr, nullptr, nullptr, nullptr
#define CAMARON_FLAGS(Function) nullptr, Function, nullptr, nullptr, nullptr
#define CAMARON_REALS(Function) nullptr, nullptr, Function, nullptr, nullptr
#define CAMARON_FACETS(Function) nullptr, nullptr, nullptr, Function, nullptr
#define CAMARON_SHAPES(Function) nullptr, nullptr, nullptr, nullptr, Function

///@{
/**
 * All arrays, in the order in which people see them. A name may come twice for different
 * dimensions: then the first row counts that the mesh has cells for.
 */
const std::vector<ElementArray>& GetFaceArrays();
const std::vector<ElementArray>& GetEdgeArrays();
const std::vector<ElementArray>& GetVertexArrays();
///@}

/**
 * Adds those of the rows whose names are chosen, as cell arrays with UNITS_LABEL, and the points of
 * the mesh with their data. Nothing is computed for others. Returns ElementContext::GoesOn.
 */
bool AddElementArrays(const ElementContext& context, const std::vector<ElementArray>& rows,
  const std::vector<std::string>& names, vtkPolyData* elements);

/// Adds "vtkGhostType" to the elements and returns its values, all 0.
unsigned char* AddGhostArray(vtkPolyData* elements);

/// Fills the values of rows with a FacetFunction or ShapeFunction, which are parallel to @a values.
void EvaluateFaces(const ElementContext& context, const std::vector<const ElementArray*>& rows,
  const std::vector<double*>& values);
}

#endif
