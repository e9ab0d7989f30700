// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellConversion.h
 * @brief Makes of a mesh what a format can hold.
 */
#ifndef camaron_CellConversion_h
#define camaron_CellConversion_h

#include "Base/Progress.h"
#include "Scan/ScanError.h"

#include <bitset>           // for sets of types
#include <initializer_list> // for sets of types
#include <string>           // for names

class vtkDataSet;

namespace camaron
{
class OutputMesh;

/// What becomes of cells that a format cannot hold.
enum class UnsupportedCells
{
  Refuse = 0, ///< an error, nothing is written
  Skip = 1,   ///< left out, with a warning
  Convert =
    2 ///< cut into triangles or tetrahedra; left out, with a warning, where that does not help
};

/// What becomes of 3D cells in a format of polygons.
enum class SurfaceFaces
{
  None = 0,     ///< nothing, the format holds 3D cells
  Boundary = 1, ///< the faces that only one cell has
  Every = 2     ///< every face once, as the first cell has it
};

/// A set of VTK's cell types.
class CellTypeSet
{
public:
  CellTypeSet(std::initializer_list<int> types)
  {
    for (const int type : types)
    {
      this->Bits.set(static_cast<std::size_t>(type));
    }
  }
  bool Has(unsigned char type) const { return this->Bits[type]; }

private:
  std::bitset<256> Bits;
};

/// What a format can hold, and what the user wants.
struct CellConversion
{
  std::string Format; ///< for messages, e.g. "TRI"
  CellTypeSet Held;
  UnsupportedCells Others = UnsupportedCells::Refuse;
  SurfaceFaces Surface = SurfaceFaces::None;
  /// Whether a mesh of vertices only is written as points without cells.
  bool HoldsClouds = true;
};

/**
 * Finds the cells to write of a vtkUnstructuredGrid or vtkPolyData.
 *
 * Types that are held stay as they are. What another type says as well is always rewritten: voxels,
 * pixels and polygons of three or four points as hexahedra, quadrilaterals and triangles (or these
 * as polygons), strips, lines and vertices one by one, any 3D cell as polyhedron if only these are
 * held. Cells of higher order that are not held lose their further nodes, with a warning; Faces of
 * 3D cells are taken outward, as @a how.Surface says, with a warning, and treated like 2D cells of
 * the mesh. Then
 * @a how.Others decides. If it is Convert,
 * - polyhedra that are tetrahedra, pyramids, wedges or hexahedra become these if they are held; a
 *   polyhedron whose faces run inward becomes an inverted cell;
 * - 2D cells are cut into triangles, also concave ones;
 * - 3D cells are cut into tetrahedra without new points, all faces and the cell itself from the
 * smallest point id. Neighbors thus fit, if both are cut. Tetrahedra of cells that are not convex
 * may have no positive volume; these are warned of.
 *
 * Points that were used by cells, and are not any more, are left out; those of vertices and those
 * of no cell stay. Order is kept. Works in parallel; the result does not depend on the number of
 * threads.
 *
 * @param path of the file, for errors
 * @return false with the error in @a error, or without one if stopped
 */
bool ConvertCells(vtkDataSet* mesh, const CellConversion& how, const std::string& path,
  OutputMesh& output, Warnings& warnings, ScanError& error, const Progress& progress = Progress());

/// A type for people, such as "quadratic tetra".
std::string GetCellTypeName(unsigned char type);
}

#endif
