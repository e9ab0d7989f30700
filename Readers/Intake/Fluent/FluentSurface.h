// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentSurface.h
 * @brief Fluent files without cells, such as the surface meshes of Fluent Meshing.
 */
#ifndef camaron_FluentSurface_h
#define camaron_FluentSurface_h

#include "Intake/Fluent/FluentFaces.h"
#include "Intake/Pieces/PieceRequest.h"

class vtkUnstructuredGrid;

namespace camaron
{
/**
 * Reads faces that belong to no cell as cells, in the order of the file: polygons, in 2D lines,
 * with the arrays "Zone" and "BoundaryType". False with the error in @a file, or if aborted.
 */
bool ReadFluentSurface(FluentFile& file, FluentFaces& faces, const PieceRequest& request,
  vtkUnstructuredGrid* grid, Warnings& warnings, const Progress& progress);
}

#endif
