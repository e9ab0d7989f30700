// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ConversionPlan
 * @brief For every cell type, how it is converted for a format that supports certain types.
 */
#ifndef camaron_ConversionPlan_h
#define camaron_ConversionPlan_h

#include "Intake/CellMesh/CellConversion.h"

#include "vtkCellType.h" // for the types of cells

#include <array> // for one step per type

namespace camaron
{
struct ConversionStep
{
  enum class Kind : unsigned char
  {
    None,       ///< not supported
    Nodes,      ///< a cell of Type with some of the nodes
    Polygon,    ///< the vertices of a 2D cell; the type depends on their number
    Strip,      ///< its triangles
    Lines,      ///< one line per segment
    Vertices,   ///< one vertex per point
    Surface,    ///< faces of a 3D cell
    Polyhedron, ///< converted if recognized, else divided
    Tetrahedra  ///< divided into tetrahedra
  };
  Kind What = Kind::None;
  unsigned char Type = 0;
  bool IsSame = false;        ///< kept unchanged
  bool LosesNodes = false;    ///< a higher-order cell written with fewer nodes
  int NumberOfNodes = 0;      ///< 0 for all
  const int* Order = nullptr; ///< of the nodes; nullptr to keep it
};

class ConversionPlan
{
public:
  explicit ConversionPlan(const CellConversion& how);

  const ConversionStep& operator[](unsigned char type) const { return this->Steps[type]; }

  /// The type that a polygon with @a size points is written as, or VTK_EMPTY_CELL.
  unsigned char GetPolygonType(vtkIdType size) const;
  /// Whether polygons without a supported type are divided into triangles.
  bool CutsPolygons() const { return this->Cuts && this->Holds(VTK_TRIANGLE); }
  bool Holds(int type) const { return this->How.Held.Has(static_cast<unsigned char>(type)); }

private:
  ConversionStep Choose(unsigned char type) const;
  ConversionStep ChooseFor3D(unsigned char type) const;

  const CellConversion& How;
  bool Cuts;
  std::array<ConversionStep, 256> Steps;
};
}

#endif
