// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Vector.h
 * @brief 3D vectors with the operations that cell geometry needs.
 */
#ifndef camaron_Vector_h
#define camaron_Vector_h

#include <algorithm> // for std::max
#include <cmath>     // for std::ldexp

namespace camaron
{
struct Vector
{
  double X = 0, Y = 0, Z = 0;

  Vector& operator+=(const Vector& v)
  {
    this->X += v.X, this->Y += v.Y, this->Z += v.Z;
    return *this;
  }
};

inline Vector operator+(const Vector& a, const Vector& b)
{
  return { a.X + b.X, a.Y + b.Y, a.Z + b.Z };
}
inline Vector operator-(const Vector& a, const Vector& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}
inline Vector operator-(const Vector& a)
{
  return { -a.X, -a.Y, -a.Z };
}
inline Vector operator*(double s, const Vector& a)
{
  return { s * a.X, s * a.Y, s * a.Z };
}
inline double Dot(const Vector& a, const Vector& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}
inline Vector Cross(const Vector& a, const Vector& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}
inline double Norm2(const Vector& a)
{
  return Dot(a, a);
}
inline double Norm(const Vector& a)
{
  return std::sqrt(Norm2(a));
}
/// The unit vector; zero stays zero.
inline Vector Unit(const Vector& a)
{
  const double norm = Norm(a);
  return norm > 0 ? (1 / norm) * a : a;
}

/// Largest absolute component.
inline double GetLargestComponent(const Vector& a)
{
  return std::max({ std::abs(a.X), std::abs(a.Y), std::abs(a.Z) });
}

inline bool IsFinite(const Vector& a)
{
  return std::isfinite(a.X) && std::isfinite(a.Y) && std::isfinite(a.Z);
}

/// The vector times 2^exponent, exactly.
inline Vector TimesPowerOfTwo(const Vector& a, int exponent)
{
  return { std::ldexp(a.X, exponent), std::ldexp(a.Y, exponent), std::ldexp(a.Z, exponent) };
}

/// Exponent of a power of two close to a length, as a unit for lengths that are too large or too
/// small for products; 0 for others.
inline int GetUnitExponent(double length)
{
  constexpr double Smallest = 1e-30, Largest = 1e30; // products of ten lengths stay in range
  const bool isUsual = length > Smallest && length < Largest;
  return isUsual || !(length > 0) || !std::isfinite(length) ? 0 : std::ilogb(length);
}
}

#endif
