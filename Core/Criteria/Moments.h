// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Moments.h
 * @brief Second moments of vectors.
 */
#ifndef camaron_Moments_h
#define camaron_Moments_h

#include "Base/Vector.h"

#include "vtkMath.h" // for eigenvalues

namespace camaron
{
/// A symmetric matrix, the sum of outer products of vectors with themselves.
struct Moments
{
  double XX = 0, YY = 0, ZZ = 0, XY = 0, YZ = 0, ZX = 0;
  void Add(const Vector& v)
  {
    this->XX += v.X * v.X, this->YY += v.Y * v.Y, this->ZZ += v.Z * v.Z;
    this->XY += v.X * v.Y, this->YZ += v.Y * v.Z, this->ZX += v.Z * v.X;
  }
  double GetTrace() const { return this->XX + this->YY + this->ZZ; }
  Moments Scaled(double s) const
  {
    return { s * this->XX, s * this->YY, s * this->ZZ, s * this->XY, s * this->YZ, s * this->ZX };
  }
  double GetDeterminant() const
  {
    return this->XX * (this->YY * this->ZZ - this->YZ * this->YZ) -
      this->XY * (this->XY * this->ZZ - this->YZ * this->ZX) +
      this->ZX * (this->XY * this->YZ - this->YY * this->ZX);
  }
  /// The equivalent of the determinant for vectors in a plane.
  double GetSumOfMinors() const
  {
    return this->XX * this->YY - this->XY * this->XY + this->XX * this->ZZ - this->ZX * this->ZX +
      this->YY * this->ZZ - this->YZ * this->YZ;
  }
  /// In descending order.
  void GetEigenvalues(double values[3]) const
  {
    double rows[3][3] = { { this->XX, this->XY, this->ZX }, { this->XY, this->YY, this->YZ },
      { this->ZX, this->YZ, this->ZZ } };
    double vectors[3][3];
    double* matrix[3] = { rows[0], rows[1], rows[2] };
    double* columns[3] = { vectors[0], vectors[1], vectors[2] };
    vtkMath::Jacobi(matrix, values, columns);
  }
};
}

#endif
