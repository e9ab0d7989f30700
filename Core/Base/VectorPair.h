// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VectorPair.h
 * @brief SIMD: two numbers or vectors at a time, for identical operations on many faces.
 *
 * Every 64-bit processor computes two doubles as fast as one, but compilers do not vectorize loops
 * over the faces of a cell. Each half has exactly the result of Vector.h.
 */
#ifndef camaron_VectorPair_h
#define camaron_VectorPair_h

#include "Base/Vector.h"

#include <cmath>   // for std::sqrt
#include <cstdint> // for the bits of numbers
#include <cstring> // for std::memcpy

#if defined(__SSE2__)
#include <emmintrin.h> // for the square root of a pair
#endif

namespace camaron
{
using Pair = double __attribute__((vector_size(2 * sizeof(double))));

inline Pair MakePair(double a, double b)
{
  return Pair{ a, b };
}

inline Pair Sqrt(Pair a)
{
#if defined(__SSE2__)
  return _mm_sqrt_pd(a);
#else
  return MakePair(std::sqrt(a[0]), std::sqrt(a[1]));
#endif
}

/// @a a with its sign flipped where @a sign is negative.
inline Pair TurnSign(Pair a, Pair sign)
{
  using Bits = long long __attribute__((vector_size(2 * sizeof(long long))));
  constexpr Pair zero = {}, signs = { -0.0, -0.0 };
  return (Pair)((Bits)a ^ ((Bits)(sign < zero) & (Bits)signs));
}

/// @a yes where @a a is less than @a b, otherwise @a no. Does not branch, because branches are
/// mispredicted in irregular meshes.
inline Pair SelectLess(Pair a, Pair b, Pair yes, Pair no)
{
  return a < b ? yes : no;
}

///@{
/// The smaller or larger one; @a b if either is NaN.
inline Pair Min(Pair a, Pair b)
{
  return a < b ? a : b;
}
inline Pair Max(Pair a, Pair b)
{
  return a > b ? a : b;
}
///@}

inline Pair Abs(Pair a)
{
  return TurnSign(a, a);
}

///@{
/// Two consecutive numbers in memory.
inline Pair LoadPair(const double* values)
{
  return MakePair(values[0], values[1]);
}
inline void StorePair(Pair a, double* values)
{
  std::memcpy(values, &a, sizeof(a));
}
///@}

/// Two numbers from arbitrary addresses.
template <typename Real>
Pair GatherPair(const Real* a, const Real* b)
{
  return MakePair(*a, *b);
}

///@{
/// The same for one number, for templates of either type.
inline double Sqrt(double a)
{
  return std::sqrt(a);
}
inline double Abs(double a)
{
  return std::abs(a);
}
inline double TurnSign(double a, double sign)
{
  return sign < 0 ? -a : a;
}
///@}

/// Two vectors, one in each half of the numbers.
struct VectorPair
{
  Pair X{}, Y{}, Z{};

  VectorPair() = default;
  VectorPair(Pair x, Pair y, Pair z)
    : X(x)
    , Y(y)
    , Z(z)
  {
  }
  VectorPair(const Vector& a, const Vector& b)
    : X(MakePair(a.X, b.X))
    , Y(MakePair(a.Y, b.Y))
    , Z(MakePair(a.Z, b.Z))
  {
  }
  Vector operator[](int i) const { return { this->X[i], this->Y[i], this->Z[i] }; }
};

inline VectorPair operator+(const VectorPair& a, const VectorPair& b)
{
  return { a.X + b.X, a.Y + b.Y, a.Z + b.Z };
}
inline VectorPair operator-(const VectorPair& a, const VectorPair& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}
inline VectorPair operator*(Pair s, const VectorPair& a)
{
  return { s * a.X, s * a.Y, s * a.Z };
}
inline VectorPair operator*(double s, const VectorPair& a)
{
  return { s * a.X, s * a.Y, s * a.Z };
}
inline Pair Dot(const VectorPair& a, const VectorPair& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}
inline Pair Norm2(const VectorPair& a)
{
  return Dot(a, a);
}
inline Pair Norm(const VectorPair& a)
{
  return Sqrt(Norm2(a));
}
inline VectorPair Cross(const VectorPair& a, const VectorPair& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}

/// Cube roots of positive normal numbers, correct to one unit in the last place.
inline Pair CubeRoot(Pair a)
{
  // Dividing exponent and mantissa by three gives a start value with a relative error of 3.2 %. The
  // offset is two thirds of the bits of 1, adjusted so that the errors on both sides are equal.
  const auto getFirst = [](double value)
  {
    constexpr std::uint64_t offset = 0x2a9f7893782da1ceull;
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    bits = bits / 3 + offset;
    std::memcpy(&value, &bits, sizeof(bits));
    return value;
  };
  Pair root = MakePair(getFirst(a[0]), getFirst(a[1]));
  // A step of Halley's method reduces a relative error to two thirds of its cube: 2e-5, 7e-15,
  // none.
  for (int step = 0; step < 3; ++step)
  {
    const Pair cube = root * root * root;
    root = root - root * ((cube - a) / (cube + cube + a));
  }
  return root;
}
inline double CubeRoot(double a)
{
  return CubeRoot(MakePair(a, a))[0];
}
}

#endif
