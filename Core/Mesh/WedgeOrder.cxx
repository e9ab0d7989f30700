// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/WedgeOrder.h"

#include "Mesh/CellShape.h"

namespace camaron
{
//------------------------------------------------------------------------------
bool IsExtrusion(unsigned char wedgeType)
{
  const CellShape& shape = GetCellShape(wedgeType);
  for (int f = 0; f < shape.NumberOfFaces; ++f)
  {
    const int* face = shape.FacePoints + shape.FaceOffsets[f];
    if (shape.FaceOffsets[f + 1] - shape.FaceOffsets[f] == 3 && face[0] + face[1] + face[2] == 3)
    {
      // The face is oriented outward, which is opposite to (0,1,2) in an extrusion.
      const int zero = face[0] == 0 ? 0 : face[1] == 0 ? 1 : 2;
      return face[(zero + 1) % 3] == 2;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
const int* GetExtrusionOrder(unsigned char wedgeType)
{
  static const int same[MaxWedgeNodes] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14 };
  // Nodes 1 and 2, 4 and 5 are swapped, and so are the edges that end there.
  static const int turned[MaxWedgeNodes] = { 0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13 };
  return IsExtrusion(wedgeType) ? same : turned;
}
}
