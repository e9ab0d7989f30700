// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellTypeName.h
 * @brief Names of VTK's cell types in messages.
 */
#ifndef camaron_CellTypeName_h
#define camaron_CellTypeName_h

#include <string> // for the name

namespace camaron
{
/// In words, singular, such as "quadratic tetrahedron"; the number of a type that VTK does not
/// know.
std::string GetCellTypeName(unsigned char type);
}

#endif
