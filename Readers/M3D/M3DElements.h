// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file M3DElements.h
 * @brief The elements of M3D and M2D files: letters, types and order of nodes.
 */
#ifndef camaron_M3DElements_h
#define camaron_M3DElements_h

#include "Mesh/CellShape.h"

#include "vtkCellType.h" // for the types of cells

namespace camaron
{
/// Numbers after every element; mesh generators write 1000.0 0.45 1.0.
constexpr int MaterialSize = 3;
constexpr char MaterialName[] = "Material";

constexpr int MaxElementNodes = 8;

struct ElementKind
{
  char Letter;
  unsigned char Type;
  int NumberOfNodes;

  /// Position of each of VTK's nodes in the file, and vice versa.
  const int* GetOrder() const
  {
    static const int same[MaxElementNodes] = { 0, 1, 2, 3, 4, 5, 6, 7 };
    return this->Type == VTK_WEDGE ? GetExtrusionOrder(VTK_WEDGE) : same;
  }
};

/// Those of M3D files, then those of M2D files.
constexpr ElementKind ElementKinds[] = {
  { 'T', VTK_TETRA, 4 },
  { 'P', VTK_PYRAMID, 5 },
  { 'R', VTK_WEDGE, 6 },
  { 'H', VTK_HEXAHEDRON, 8 },
  { 't', VTK_TRIANGLE, 3 },
  { 'q', VTK_QUAD, 4 },
};

/// The kind of element for which @a is(ElementKind), or nullptr.
template <typename Is>
const ElementKind* FindElementKind(Is&& is)
{
  for (const ElementKind& kind : ElementKinds)
  {
    if (is(kind))
    {
      return &kind;
    }
  }
  return nullptr;
}
}

#endif
