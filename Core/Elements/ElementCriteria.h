// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ElementCriteria.h
 * @brief Criteria of any elements: those of cells, and the arrays of faces, edges and vertices.
 */
#ifndef camaron_ElementCriteria_h
#define camaron_ElementCriteria_h

#include "Criteria/Criterion.h"
#include "Elements/ElementArray.h"

namespace camaron
{
/// A table of arrays: "Face", "Edge" or "Vertex", and the rows as criteria, without functions.
struct ElementTable
{
  const char* Element;
  const std::vector<ElementArray>& Arrays;
  std::vector<Criterion> Criteria; ///< parallel to Arrays
};

/**
 * The tables of faces, edges and vertices. The acceptable range of a criterion of polyhedra holds
 * for their faces, which are polygons; edges and vertices have no ranges.
 */
const std::vector<ElementTable>& GetElementTables();

/// The criterion of cells with this name, else the first one of elements; nullptr if there is none.
const Criterion* FindAnyCriterion(std::string_view name);
}

#endif
