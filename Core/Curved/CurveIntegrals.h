// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurveIntegrals.h
 * @brief Integrals of the magnitude of a vector polynomial, for lengths of edges and areas of
 * faces.
 *
 * These are not polynomials. The domain is bisected until parts by Gauss quadrature change the
 * result by less than 1e-10 of it; less precise where a surface folds.
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
