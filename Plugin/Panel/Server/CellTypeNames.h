// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellTypeNames.h
 * @brief Names of cell types in sentences.
 */
#ifndef camaron_CellTypeNames_h
#define camaron_CellTypeNames_h

#include <QString>

namespace camaron
{
/// The word for a number of cells of a type, from its label in the server's tables: "Tetra" is
/// "tetrahedron" or "tetrahedra", "QuadraticWedge" is "quadratic wedge" or "quadratic wedges".
/// An unknown type has one word for all numbers.
QString CellTypeName(const QString& label, qint64 count = 1);

/// Whether a cell type, by its label, belongs to shapes as the server's table of criteria lists
/// them: "any cell", "tetrahedra, wedges and hexahedra"; "polygons" are all surface cells,
/// "polyhedra" all solid ones.
bool IsAmong(const QString& label, const QString& shapes);
}

#endif
