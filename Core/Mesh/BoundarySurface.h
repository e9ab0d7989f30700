// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoundarySurface.h
 * @brief The outside of a mesh as polygons, taken from its topology.
 */
#ifndef camaron_BoundarySurface_h
#define camaron_BoundarySurface_h

class vtkDataSet;
class vtkPolyData;

namespace camaron
{
class FacetLinks;

/**
 * Fills @a surface with the faces that have one 3D cell, with the 2D cells, lines and vertices of
 * @a mesh (a vtkUnstructuredGrid or vtkPolyData), and with the data of their cells and points.
 * Faces keep all their points and run outward. Cells marked as ghosts are left out, but count as
 * neighbors. So do those that @a links, if there are, know of.
 *
 * Adds the arrays `vtkOriginalCellIds` and `vtkOriginalPointIds`.
 * @throw std::length_error for a piece of more than 2^30 faces
 */
void MakeBoundarySurface(vtkDataSet* mesh, vtkPolyData* surface, const FacetLinks* links = nullptr);
}

#endif
