// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkCamaronCompat.h
 * @brief Hides differences between the VTK versions of the supported ParaView versions (5.13 to
 * 6.1).
 *
 * All version checks of the project are here, with their reason and the condition for their
 * removal.
 */
#ifndef vtkCamaronCompat_h
#define vtkCamaronCompat_h

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkUniformGridAMR.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"
#if __has_include("vtkCellTypeUtilities.h")
#include "vtkCellTypeUtilities.h"
#else
#include "vtkCellTypes.h"
#endif

namespace camaron
{
/**
 * Whether the cell array stores plain int32 or int64 offsets and connectivity arrays. VTK 9.6 adds
 * fixed-size and generic storages whose arrays may be implicit; when VTK < 9.6 is no longer
 * supported, delete this and use GetStorageType().
 */
inline bool HasPlainStorage(vtkCellArray* cells)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return cells->GetStorageType() == vtkCellArray::Int64 ||
    cells->GetStorageType() == vtkCellArray::Int32;
#else
  (void)cells;
  return true;
#endif
}

/**
 * Class name of a cell type such as "vtkTetra". VTK's own table swaps the triangles and
 * quadrilaterals of Lagrange and Bezier. VTK 9.6 moves the method to another class; delete this
 * when VTK < 9.6 is no longer supported.
 */
inline const char* GetCellClassName(int cellType)
{
  switch (cellType)
  {
    case VTK_LAGRANGE_TRIANGLE:
      return "vtkLagrangeTriangle";
    case VTK_LAGRANGE_QUADRILATERAL:
      return "vtkLagrangeQuadrilateral";
    case VTK_BEZIER_TRIANGLE:
      return "vtkBezierTriangle";
    case VTK_BEZIER_QUADRILATERAL:
      return "vtkBezierQuadrilateral";
    default:
      break;
  }
#if __has_include("vtkCellTypeUtilities.h")
  return vtkCellTypeUtilities::GetClassNameFromTypeId(cellType);
#else
  return vtkCellTypes::GetClassNameFromTypeId(cellType);
#endif
}

/**
 * The cell types of a grid, in any type of array. From VTK 9.6 on, the array may be implicit; when
 * VTK < 9.6 is no longer supported, delete this and use GetCellTypes().
 */
inline vtkDataArray* GetCellTypes(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return grid->GetCellTypes();
#else
  return grid->GetCellTypesArray();
#endif
}

/**
 * Why polyhedra may have lost their faces, to be appended to a message: VTK 9.4 writes them in a
 * new layout, which older versions cannot read. Delete this when VTK < 9.4 is no longer supported.
 */
inline const char* GetReasonForLostFaces()
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  return "";
#else
  return "; if VTK 9.4 or newer wrote them, use ParaView 6.0 or newer";
#endif
}

/**
 * The tree of a composite data set; nullptr for anything else. Adaptive meshes become trees in VTK
 * 9.6, but their iterator still counts boxes, unlike that of other trees, and they only contain
 * grids; when their classes are removed, delete this and use SafeDownCast.
 */
inline vtkDataObjectTree* GetTree(vtkDataObject* data)
{
  return vtkUniformGridAMR::SafeDownCast(data) ? nullptr : vtkDataObjectTree::SafeDownCast(data);
}
}

#endif
