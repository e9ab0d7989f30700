// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurveIntegrals.h
 * @brief Integrals of the magnitude of a vector polynomial, for lengths of edges and areas of
 * faces.
 *
 * These are not polynomials. Most need two rules of Gauss quadrature that agree. The magnitude has
 * a kink where an edge turns back or a face nearly folds: there, faces are integrated line by line,
 * and lines are bisected. The result is off by at most 1e-10 of itself, also then.
 */
#ifndef camaron_CurveIntegrals_h
#define camaron_CurveIntegrals_h

#include "Base/Vector.h"
#include "Curved/BernsteinSpace.h"

namespace camaron
{
/// @a coefficients of a polynomial on a line, triangle or quadrilateral, whose measure is 1, 1/2 or
/// 1.
double IntegrateMagnitude(const BernsteinSpace& space, const Vector* coefficients);
}

#endif
