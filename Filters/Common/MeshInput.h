// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshInput.h
 * @brief What filters read: data sets as the types that Core reads, without invalid ones, and small
 * files of the user.
 */
#ifndef camaron_MeshInput_h
#define camaron_MeshInput_h

#include "ElementBlocks.h"

#include "Ranks/Reducer.h"
#include "vtkDataSet.h"      // for the result
#include "vtkSmartPointer.h" // for the result
#include <string>            // for the text

namespace camaron
{
/**
 * A vtkUnstructuredGrid or vtkPolyData with the cells of @a data in the same order, and its ghost
 * array. @a data itself if possible; else
 *
 * - images and structured grids become vtkUnstructuredGrids,
 * - VTK_CONVEX_POINT_SET cells get the faces of their convex hull,
 * - hidden and refined cells become VTK_EMPTY_CELL, for which a vtkPolyData becomes a
 *   vtkUnstructuredGrid.
 */
vtkSmartPointer<vtkDataSet> AsMesh(vtkDataSet* data);

/**
 * @a data itself, or if it has triangle strips, a mesh of their triangles. Each triangle has the
 * cell data of its strip. In a vtkUnstructuredGrid the triangles replace their strip; in a
 * vtkPolyData they follow the other polygons.
 */
vtkSmartPointer<vtkDataSet> WithoutStrips(vtkDataSet* data);

/// Throws std::runtime_error, with the name of the block, if cells cannot be read (CheckCells) or
/// an array "vtkGhostType" is invalid.
void CheckLeaf(const DataSetLeaf& leaf);

/// Collective. The data sets of the input of a filter, as GetLeaves. If CheckLeaf throws on one
/// process, all throw std::runtime_error. Only data sets from here may be used to read cells.
std::vector<DataSetLeaf> GetMeshes(vtkDataObject* input, Reducer& reducer);

/// Collective. Throws std::runtime_error on all processes if there are polyhedra in the data sets
/// of GetMeshes, but none of them has faces.
void CheckFaces(const std::vector<DataSetLeaf>& leaves, Reducer& reducer);

/**
 * Collective. The bytes of a file, which process 0 reads. Throws std::runtime_error on all
 * processes if the file cannot be read, is a pipe or a device, or is larger than 1 MiB.
 *
 * @param what the expected content for messages, such as "a file of ranges"
 */
std::string ReadSmallFile(const std::string& path, const std::string& what, Reducer& reducer);
}

#endif
