// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BlockZones.h
 * @brief Names of blocks as zones, for formats whose boundaries have names.
 */
#ifndef camaron_BlockZones_h
#define camaron_BlockZones_h

#include "GatheredMesh.h"

#include <string> // for names

namespace camaron
{
/**
 * Makes blocks of 2D cells zones with the names of the blocks, such as the patches that ParaView's
 * OpenFOAM reader shows: their cells get the array "Zone", and the mesh the field data "ZoneIds"
 * and "ZoneNames". Blocks without a name, or with other cells, have no zone. Nothing is done if
 * a part has zones already, or if none has 3D cells.
 * @param names of all blocks, empty for none
 */
void NameZones(std::vector<MeshPart>& parts, const std::vector<std::string>& names);
}

#endif
