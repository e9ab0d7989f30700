// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellConversion.h
 * @brief Converts the cells of a mesh to cells that a file format can store.
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

/// What to do with cells that a format cannot store.
enum class UnsupportedCells
{
  Refuse = 0, ///< report an error and write nothing
  Skip = 1,   ///< omit them, with a warning
  Convert = 2 ///< divide them into triangles or tetrahedra; if this is not possible, omit them with
              ///< a warning
};

/// Which faces represent 3D cells in a format for polygons.
enum class SurfaceFaces
{
  None = 0,     ///< none, the format stores 3D cells
  Boundary = 1, ///< faces with one cell
  Every = 2     ///< every face once, with the orientation of its first cell
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

/// What a format can store, and what the user has selected.
struct CellConversion
{
  std::string Format; ///< for messages, e.g. "TRI"
  CellTypeSet Held;
  UnsupportedCells Others = UnsupportedCells::Refuse;
  SurfaceFaces Surface = SurfaceFaces::None;
};

/**
 * Finds the cells to write, for a vtkUnstructuredGrid or vtkPolyData.
 *
 * Cells with supported types are kept. Cells that another type represents exactly are always
 * converted: voxels, pixels and polygons with three or four points to hexahedra, quadrilaterals
 * and triangles (or these to polygons), strips, lines and vertices to single ones, and any 3D cell
 * to a polyhedron if the format only supports those. Higher-order cells that are not supported
 * lose their additional nodes, with a warning. Faces of 3D cells are extracted with outward
 * orientation as @a how.Surface says, with a warning, and then treated like 2D cells of the mesh.
 * @a how.Others decides about all other cells. For Convert,
 * - polyhedra that are tetrahedra, pyramids, wedges or hexahedra are converted to these if they
 * are supported; a polyhedron with inward faces becomes an inverted cell;
 * - 2D cells are divided into triangles, even if they are concave;
 * - 3D cells are divided into tetrahedra without new points; all faces, and the cell, are divided
 * at the smallest point id. Neighbors therefore match if both are divided. Tetrahedra of
 * non-convex cells may have a volume of zero or less; the writer warns about them.
 *
 * Points whose cells are all omitted are omitted, too; points of vertices and unused points are
 * kept. The order is kept. Works in parallel; the result does not depend on the number of threads.
 *
 * @param path of the file, for errors
 * @return false with the error in @a error, or without one if stopped
 */
bool ConvertCells(vtkDataSet* mesh, const CellConversion& how, const std::string& path,
  OutputMesh& output, Warnings& warnings, ScanError& error, const Progress& progress = Progress());
}

#endif
