// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshInput.h
 * @brief Brings any data set into the form that Core reads, and refuses input that is no mesh.
 */
#ifndef camaron_MeshInput_h
#define camaron_MeshInput_h

#include "ElementBlocks.h"

#include "vtkDataSet.h"      // for the result
#include "vtkSmartPointer.h" // for the result

namespace camaron
{
/**
 * A vtkUnstructuredGrid or vtkPolyData with the same cells in the same order as @a data and its
 * ghost array: @a data itself whenever possible. Images and structured grids become unstructured;
 * VTK_CONVEX_POINT_SET cells get the faces of their hull; cells that are hidden or refined
 * elsewhere become VTK_EMPTY_CELL, for which a vtkPolyData becomes unstructured, too.
 */
vtkSmartPointer<vtkDataSet> AsMesh(vtkDataSet* data);

/**
 * @a data itself, or when it has triangle strips a mesh of their triangles, each with the cell data
 * of its strip: in its place in a grid, after the other polygons in a vtkPolyData.
 */
vtkSmartPointer<vtkDataSet> WithoutStrips(vtkDataSet* data);

/**
 * Collective. Throws std::runtime_error on all processes if cells of one have points that are not
 * there, if "vtkGhostType" is none that VTK knows, or if there are polyhedra but none that has a
 * face.
 */
void CheckMeshes(const std::vector<DataSetLeaf>& leaves, Reducer& reducer);
}

#endif
