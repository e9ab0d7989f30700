// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FacesOfCells.h
 * @brief The faces of every cell, from the cells on both sides of every face.
 */
#ifndef camaron_FacesOfCells_h
#define camaron_FacesOfCells_h

#include "Base/Buffer.h"

#include <cstdint> // for ids

namespace camaron
{
/// Lists n id1 ... idn, one after the other, with ids ascending; @a sides as in FaceMesh. A face
/// with the same cell on both sides is listed twice.
Buffer<std::int32_t> ListFacesOfCells(const Buffer<std::int32_t>& sides, vtkIdType numberOfCells);
}

#endif
