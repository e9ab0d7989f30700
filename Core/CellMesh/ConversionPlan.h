// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ConversionPlan
 * @brief For every type of cells, what a format that holds certain types makes of it.
 */
#ifndef camaron_ConversionPlan_h
#define camaron_ConversionPlan_h

#include "CellMesh/CellConversion.h"

#include "vtkCellType.h" // for the types of cells

#include <array> // for one step per type

namespace camaron
{
struct ConversionStep
{
  enum class Kind : unsigned char
  {
    None,       ///< cannot be held
    Nodes,      ///< a cell of Type with some of the nodes
    Polygon,    ///< the corners of a 2D cell, whose number decides
    Strip,      ///< its triangles
    Lines,      ///< one per segment
    Vertices,   ///< one per point
    Surface,    ///< faces of a 3D cell
    Polyhedron, ///< recognized, else cut
    Tetrahedra  ///< cut
  };
  Kind What = Kind::None;
  unsigned char Type = 0;
  bool IsSame = false;        ///< nothing changes
  bool LosesNodes = false;    ///< of higher order, and written by fewer nodes
  int NumberOfNodes = 0;      ///< 0 for all
  const int* Order = nullptr; ///< of the nodes; nullptr for as they are
};

class ConversionPlan
{
public:
  explicit ConversionPlan(const CellConversion& how);

  const ConversionStep& operator[](unsigned char type) const { return this->Steps[type]; }

  /// The type that a polygon of so many points is written as, or VTK_EMPTY_CELL.
  unsigned char GetPolygonType(vtkIdType size) const;
  /// Whether polygons that have no type are cut into triangles.
  bool CutsPolygons() const { return this->Cuts && this->Has(VTK_TRIANGLE); }
  bool Holds(unsigned char type) const { return this->Has(type); }

private:
  bool Has(int type) const { return this->How.Held.Has(static_cast<unsigned char>(type)); }
  ConversionStep Choose(unsigned char type) const;
  ConversionStep ChooseFor3D(unsigned char type) const;

  const CellConversion& How;
  bool Cuts;
  std::array<ConversionStep, 256> Steps;
};
}

#endif
