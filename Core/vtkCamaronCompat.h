// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkCamaronCompat.h
 * @brief Hides the differences between the VTK versions of the supported ParaViews (5.13 to 6.1).
 *
 * Every version check of the project lives here, with the reason and the condition for its removal.
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
 * True when the cell array keeps plain int32 or int64 offsets and connectivity arrays. VTK 9.6 adds
 * fixed-size and generic storages whose arrays may be implicit; delete this when VTK < 9.6 is no
 * longer supported and ask GetStorageType() instead.
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
 * Class name of a cell type such as "vtkTetra". VTK's own table has triangles and quadrilaterals of
 * Lagrange and Bezier in each other's place. VTK 9.6 moves the method to a class of its own; delete
 * this when VTK < 9.6 is no longer supported.
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
 * Types of the cells of a grid, whatever kind of array holds them. From VTK 9.6 on that may be an
 * implicit one; delete this when VTK < 9.6 is no longer supported and call GetCellTypes() instead.
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
 * Why polyhedra may have lost their faces, for the end of a message: VTK 9.4 writes them in another
 * layout, which VTK before it does not read. Delete this when VTK < 9.4 is no longer supported.
 */
inline const char* GetReasonForLostFaces()
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  return "";
#else
  return "; a file that VTK 9.4 or newer wrote is read with its faces by ParaView 6.0 or newer";
#endif
}

/**
 * Data of blocks within blocks; null for anything else. Adaptive meshes become trees in VTK 9.6,
 * but their iterator counts boxes as it did before, which is not how trees are counted, and they
 * hold no other data sets than grids; delete this when their classes are gone, and call
 * SafeDownCast instead.
 */
inline vtkDataObjectTree* GetTree(vtkDataObject* data)
{
  return vtkUniformGridAMR::SafeDownCast(data) ? nullptr : vtkDataObjectTree::SafeDownCast(data);
}
}

#endif
