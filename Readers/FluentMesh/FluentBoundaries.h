// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentBoundaries.h
 * @brief The zones of a Fluent mesh: names as field data, and boundary faces as blocks.
 */
#ifndef camaron_FluentBoundaries_h
#define camaron_FluentBoundaries_h

#include "FluentPiece.h"

class vtkFieldData;
class vtkMultiBlockDataSet;
class vtkPoints;

namespace camaron
{
/// Adds the zones of the file as "ZoneIds", "ZoneNames", "ZoneTypes" and "ZoneBoundaryTypes", the
/// numbers of kinds of boundaries.
void AddFluentZones(const FluentFile& file, vtkFieldData* fieldData);

/**
 * Makes a block, a vtkPolyData, of every zone of faces other than interior ones and
 * parents of split faces. Faces run outward of their (first) cell. They have the cell arrays "Zone"
 * and "BoundaryType", the number that Fluent gives to the kind of boundary.
 * @param points those of the piece
 * @return false if there are more zones than anybody can want
 */
bool MakeFluentBoundaries(const FluentFile& file, const FluentFaces& faces,
  const FluentCells& cells, const FluentPiece& piece, vtkPoints* points,
  vtkMultiBlockDataSet* blocks);
}

#endif
