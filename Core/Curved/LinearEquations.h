// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LinearEquations.h
 * @brief Small systems of linear equations, which tables of shapes follow from.
 */
#ifndef camaron_LinearEquations_h
#define camaron_LinearEquations_h

#include <vector> // for rows

namespace camaron
{
using DenseMatrix = std::vector<std::vector<double>>;

/// The x with a x = b, for several b; all are lists of rows. Empty if @a a is singular, relative to
/// numbers of magnitude 1.
DenseMatrix SolveEquations(DenseMatrix a, DenseMatrix b);
}

#endif
