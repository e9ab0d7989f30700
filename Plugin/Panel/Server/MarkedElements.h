// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MarkedElements.h
 * @brief Some elements of the inspected mesh, as filters of the server find them.
 */
#ifndef camaron_MarkedElements_h
#define camaron_MarkedElements_h

#include "HelperFilters.h"

class pqInspectedMesh;

namespace camaron
{
struct Location;

/// Select Elements that marks "Cells" or "Points" in the array Selected: with the strategy
/// "Current", those of the active selection; nullptr without a mesh.
Helper MarkElements(const pqInspectedMesh& mesh, const QString& strategy, const QString& elements);

/// Number of elements that a strategy marks, without ghosts.
qint64 CountElements(const pqInspectedMesh& mesh, const QString& strategy, const QString& elements);

/// The elements of a location; the key as for HelperFilters.
Helper ExtractElements(const pqInspectedMesh& mesh, const Location& location, const char* key);
}

#endif
