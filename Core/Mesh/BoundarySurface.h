// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoundarySurface.h
 * @brief The boundary surface of a mesh as vtkPolyData, taken from its topology.
 */
#ifndef camaron_BoundarySurface_h
#define camaron_BoundarySurface_h

class vtkDataSet;
class vtkPolyData;

namespace camaron
{
class FacetLinks;

/**
 * Fills @a surface with the boundary faces of @a mesh (a vtkUnstructuredGrid or vtkPolyData),
 * which are those with one 3D cell, with its 2D cells, lines and vertices, and with the cell and
 * point data of all of these.
 * Faces keep all their points and are oriented outward. Ghost cells contribute no faces but count
 * as neighbors, and so do the cells of other pieces in @a links, if given.
 *
 * Adds the arrays `vtkOriginalCellIds` and `vtkOriginalPointIds`.
 * @throw std::length_error for a piece with more than 2^30 faces
 */
void MakeBoundarySurface(vtkDataSet* mesh, vtkPolyData* surface, const FacetLinks* links = nullptr);
}

#endif
