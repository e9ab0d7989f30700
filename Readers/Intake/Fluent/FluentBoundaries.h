// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentBoundaries.h
 * @brief The zones of a Fluent mesh: names as field data, and boundary faces as blocks.
 */
#ifndef camaron_FluentBoundaries_h
#define camaron_FluentBoundaries_h

#include "Intake/Fluent/FluentMesh.h"

class vtkFieldData;
class vtkMultiBlockDataSet;
class vtkPoints;

namespace camaron
{
/// Adds the zones of the file as "ZoneIds", "ZoneNames", "ZoneTypes" and "ZoneBoundaryTypes"
/// (Fluent's numbers of boundary types).
void AddFluentZones(const FluentFile& file, vtkFieldData* fieldData);

/**
 * Creates a block, a vtkPolyData, for every face zone, except interior ones and parents of split
 * faces. Faces are oriented outward of their (first) cell. They have the cell arrays "Zone" and
 * "BoundaryType", Fluent's number of the boundary type.
 * @param points of the piece
 * @param warnings receives the numbers of faces that belong to no cell, by zone; may be nullptr
 * @return false if there are too many zones
 */
bool MakeFluentBoundaries(const FluentFile& file, const FluentMesh& mesh, vtkPoints* points,
  vtkMultiBlockDataSet* blocks, Warnings* warnings);
}

#endif
