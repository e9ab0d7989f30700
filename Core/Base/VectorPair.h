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
#if defined(__GNUC__)
using Pair = double __attribute__((vector_size(2 * sizeof(double))));
#else
struct Pair
{
  double Values[2];
  double operator[](int i) const { return this->Values[i]; }
  double& operator[](int i) { return this->Values[i]; }
};
inline Pair operator+(Pair a, Pair b)
{
  return { { a[0] + b[0], a[1] + b[1] } };
}
inline Pair operator-(Pair a, Pair b)
{
  return { { a[0] - b[0], a[1] - b[1] } };
}
inline Pair operator*(Pair a, Pair b)
{
  return { { a[0] * b[0], a[1] * b[1] } };
}
inline Pair operator/(Pair a, Pair b)
{
  return { { a[0] / b[0], a[1] / b[1] } };
}
inline Pair operator*(double a, Pair b)
{
  return { { a * b[0], a * b[1] } };
}
inline Pair operator/(double a, Pair b)
{
  return { { a / b[0], a / b[1] } };
}
inline Pair operator/(Pair a, double b)
{
  return { { a[0] / b, a[1] / b } };
}
#endif

inline Pair MakePair(double a, double b)
{
#if defined(__GNUC__)
  return Pair{ a, b };
#else
  return { { a, b } };
#endif
}

inline Pair Sqrt(Pair a)
{
#if defined(__SSE2__) && defined(__GNUC__)
  return _mm_sqrt_pd(a);
#else
  return MakePair(std::sqrt(a[0]), std::sqrt(a[1]));
#endif
}

/// @a a with its sign flipped where @a sign is negative.
inline Pair TurnSign(Pair a, Pair sign)
{
#if defined(__SSE2__) && defined(__GNUC__)
  const __m128d isBelow = _mm_cmplt_pd(sign, _mm_setzero_pd());
  return _mm_xor_pd(a, _mm_and_pd(isBelow, _mm_set1_pd(-0.0)));
#else
  return MakePair(sign[0] < 0 ? -a[0] : a[0], sign[1] < 0 ? -a[1] : a[1]);
#endif
}

/// @a yes where @a a is less than @a b, otherwise @a no. Does not branch, because branches are
/// mispredicted in irregular meshes.
inline Pair SelectLess(Pair a, Pair b, Pair yes, Pair no)
{
#if defined(__SSE2__) && defined(__GNUC__)
  const __m128d isLess = _mm_cmplt_pd(a, b);
  return _mm_or_pd(_mm_and_pd(isLess, yes), _mm_andnot_pd(isLess, no));
#else
  return MakePair(a[0] < b[0] ? yes[0] : no[0], a[1] < b[1] ? yes[1] : no[1]);
#endif
}

///@{
/// The smaller or larger one; @a b if either is NaN.
inline Pair Min(Pair a, Pair b)
{
#if defined(__SSE2__) && defined(__GNUC__)
  return _mm_min_pd(a, b);
#else
  return SelectLess(a, b, a, b);
#endif
}
inline Pair Max(Pair a, Pair b)
{
#if defined(__SSE2__) && defined(__GNUC__)
  return _mm_max_pd(a, b);
#else
  return SelectLess(b, a, a, b);
#endif
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
#if defined(__SSE2__) && defined(__GNUC__)
  return _mm_loadu_pd(values);
#else
  return MakePair(values[0], values[1]);
#endif
}
inline void StorePair(Pair a, double* values)
{
#if defined(__SSE2__) && defined(__GNUC__)
  _mm_storeu_pd(values, a);
#else
  values[0] = a[0];
  values[1] = a[1];
#endif
}
///@}

///@{
/// Two numbers from arbitrary addresses.
inline Pair GatherPair(const double* a, const double* b)
{
  return MakePair(*a, *b);
}
inline Pair GatherPair(const float* a, const float* b)
{
#if defined(__SSE2__) && defined(__GNUC__)
  return _mm_cvtps_pd(_mm_unpacklo_ps(_mm_load_ss(a), _mm_load_ss(b)));
#else
  return MakePair(*a, *b);
#endif
}
///@}

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

/// One vector per lane; Lanes is the type of their components.
template <typename Lanes>
struct VectorLanes
{
  Lanes X{}, Y{}, Z{};

  VectorLanes() = default;
  VectorLanes(const Lanes& x, const Lanes& y, const Lanes& z)
    : X(x)
    , Y(y)
    , Z(z)
  {
  }
  ///@{
  /// Constructors for the number of lanes.
  VectorLanes(const Vector& a, const Vector& b)
    : X(Lanes{ a.X, b.X })
    , Y(Lanes{ a.Y, b.Y })
    , Z(Lanes{ a.Z, b.Z })
  {
    static_assert(sizeof(Lanes) == 2 * sizeof(double), "one vector for each lane");
  }
  VectorLanes(const Vector& a, const Vector& b, const Vector& c, const Vector& d)
    : X(Lanes{ a.X, b.X, c.X, d.X })
    , Y(Lanes{ a.Y, b.Y, c.Y, d.Y })
    , Z(Lanes{ a.Z, b.Z, c.Z, d.Z })
  {
    static_assert(sizeof(Lanes) == 4 * sizeof(double), "one vector for each lane");
  }
  ///@}
  Vector operator[](int i) const { return { this->X[i], this->Y[i], this->Z[i] }; }
};

using VectorPair = VectorLanes<Pair>;

template <typename Lanes>
VectorLanes<Lanes> operator+(const VectorLanes<Lanes>& a, const VectorLanes<Lanes>& b)
{
  return { a.X + b.X, a.Y + b.Y, a.Z + b.Z };
}
template <typename Lanes>
VectorLanes<Lanes> operator-(const VectorLanes<Lanes>& a, const VectorLanes<Lanes>& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}
template <typename Lanes>
VectorLanes<Lanes> operator*(const Lanes& s, const VectorLanes<Lanes>& a)
{
  return { s * a.X, s * a.Y, s * a.Z };
}
template <typename Lanes>
VectorLanes<Lanes> operator*(double s, const VectorLanes<Lanes>& a)
{
  return { s * a.X, s * a.Y, s * a.Z };
}
template <typename Lanes>
Lanes Dot(const VectorLanes<Lanes>& a, const VectorLanes<Lanes>& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}
template <typename Lanes>
Lanes Norm2(const VectorLanes<Lanes>& a)
{
  return Dot(a, a);
}
template <typename Lanes>
Lanes Norm(const VectorLanes<Lanes>& a)
{
  return Sqrt(Norm2(a));
}
template <typename Lanes>
VectorLanes<Lanes> Cross(const VectorLanes<Lanes>& a, const VectorLanes<Lanes>& b)
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
