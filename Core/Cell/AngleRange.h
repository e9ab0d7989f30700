// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::AngleRange
 * @brief Minimum and maximum of a set of angles between 0 and 2 pi.
 *
 * Angles are compared by sine and cosine, so only the two extremes cost an arc tangent.
 * AngleRangePair computes two ranges at a time.
 */
#ifndef camaron_AngleRange_h
#define camaron_AngleRange_h

#include "Base/Null.h"
#include "Base/Number.h"
#include "Base/Vector.h"
#include "Base/VectorPair.h"

#include <cmath> // for std::atan2

namespace camaron
{
class AngleRange
{
public:
  /// Removes all angles; GetMin and GetMax then return NaN with this reason.
  void Clear(NullReason reason = NullReason::Degenerate)
  {
    this->MinOrder = 5; // orders are in [0, 4]
    this->MaxOrder = -1;
    this->Reason = reason;
  }
  bool IsEmpty() const { return this->MaxOrder < 0; }

  /// Adds the angle with this sine and cosine, both scaled by the same positive factor.
  void Add(double sine, double cosine)
  {
    const double sum = std::abs(sine) + std::abs(cosine);
    const bool isAcute = sine >= 0 && cosine >= 0; // keeps the significant digits of small angles
    const double share = sum > 0 ? (isAcute ? sine : cosine) / sum : 0;
    const double order = sine < 0 ? 3 + share : isAcute ? share : 1 - share;
    if (order < this->MinOrder)
    {
      this->MinOrder = order;
      this->Min = { sine, cosine };
    }
    if (order > this->MaxOrder)
    {
      this->MaxOrder = order;
      this->Max = { sine, cosine };
    }
  }
  void Add(const AngleRange& other)
  {
    if (other.MinOrder < this->MinOrder)
    {
      this->MinOrder = other.MinOrder;
      this->Min = other.Min;
    }
    if (other.MaxOrder > this->MaxOrder)
    {
      this->MaxOrder = other.MaxOrder;
      this->Max = other.Max;
    }
  }

  ///@{
  /// In radians; NaN without angles.
  double GetMin() const { return this->IsEmpty() ? Null(this->Reason) : this->Min.GetAngle(); }
  double GetMax() const { return this->IsEmpty() ? Null(this->Reason) : this->Max.GetAngle(); }
  ///@}

private:
  friend class AngleRangePair;
  struct Direction
  {
    double Sine, Cosine;
    double GetAngle() const
    {
      constexpr double turn = 6.283185307179586476925286766559;
      const double angle = std::atan2(this->Sine, this->Cosine);
      return angle < 0 ? angle + turn : angle + 0.0; // no negative zero
    }
  };
  double MinOrder = 5, MaxOrder = -1;
  Direction Min = { 0, 1 }, Max = { 0, 1 };
  NullReason Reason = NullReason::Degenerate;
};

class AngleRangePair
{
public:
  void Add(Pair sine, Pair cosine)
  {
    const Pair zero = MakePair(0, 0), one = MakePair(1, 1);
    const Pair sum = Abs(sine) + Abs(cosine);
    const Pair ofAcute = SelectLess(cosine, zero, cosine, sine);
    const Pair share = SelectLess(zero, sum, SelectLess(sine, zero, cosine, ofAcute) / sum, zero);
    const Pair ofUpper = SelectLess(cosine, zero, one - share, share);
    const Pair order = SelectLess(sine, zero, MakePair(3, 3) + share, ofUpper);
    this->MinSine = SelectLess(order, this->MinOrder, sine, this->MinSine);
    this->MinCosine = SelectLess(order, this->MinOrder, cosine, this->MinCosine);
    this->MinOrder = SelectLess(order, this->MinOrder, order, this->MinOrder);
    this->MaxSine = SelectLess(this->MaxOrder, order, sine, this->MaxSine);
    this->MaxCosine = SelectLess(this->MaxOrder, order, cosine, this->MaxCosine);
    this->MaxOrder = SelectLess(this->MaxOrder, order, order, this->MaxOrder);
  }
  AngleRange operator[](int i) const
  {
    AngleRange range;
    range.MinOrder = this->MinOrder[i];
    range.MaxOrder = this->MaxOrder[i];
    range.Min = { this->MinSine[i], this->MinCosine[i] };
    range.Max = { this->MaxSine[i], this->MaxCosine[i] };
    return range;
  }

private:
  Pair MinOrder = MakePair(5, 5), MinSine = MakePair(0, 0), MinCosine = MakePair(1, 1);
  Pair MaxOrder = MakePair(-1, -1), MaxSine = MakePair(0, 0), MaxCosine = MakePair(1, 1);
};

constexpr double DihedralRounding = 1e-14; // limit of sines

/**
 * In radians, from 0 to 2 pi, on the side opposite to the unit normals.
 * @param along unit vector of the edge, in the direction in which the first polygon traverses it
 */
inline double GetDihedralAngle(const Vector& along, const Vector& normal0, const Vector& normal1)
{
  const double sine = Dot(along, Cross(normal0, normal1));
  // Roundoff must not turn an angle of 0 into 2 pi.
  return Pi - std::atan2(std::abs(sine) <= DihedralRounding ? 0 : sine, Dot(normal0, normal1));
}
}

#endif
