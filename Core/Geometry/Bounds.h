// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Bounds.h
 * @brief A box with sides along the axes.
 */
#ifndef camaron_Bounds_h
#define camaron_Bounds_h

#include "Base/Vector.h"

#include <algorithm> // for smaller and larger ones
#include <limits>    // for infinity

namespace camaron
{
struct Bounds
{
  static constexpr double Infinity = std::numeric_limits<double>::infinity();
  Vector Low = { Infinity, Infinity, Infinity };
  Vector High = { -Infinity, -Infinity, -Infinity };

  bool IsEmpty() const { return !(this->Low.X <= this->High.X); }
  void Add(const Vector& x)
  {
    this->Low = { std::min(this->Low.X, x.X), std::min(this->Low.Y, x.Y),
      std::min(this->Low.Z, x.Z) };
    this->High = { std::max(this->High.X, x.X), std::max(this->High.Y, x.Y),
      std::max(this->High.Z, x.Z) };
  }
  void Add(const Bounds& box)
  {
    this->Low = { std::min(this->Low.X, box.Low.X), std::min(this->Low.Y, box.Low.Y),
      std::min(this->Low.Z, box.Low.Z) };
    this->High = { std::max(this->High.X, box.High.X), std::max(this->High.Y, box.High.Y),
      std::max(this->High.Z, box.High.Z) };
  }
  void Grow(double length)
  {
    const Vector margin = { length, length, length };
    this->Low = this->Low - margin;
    this->High = this->High + margin;
  }
  bool Meets(const Bounds& box) const
  {
    return this->Low.X <= box.High.X && box.Low.X <= this->High.X && this->Low.Y <= box.High.Y &&
      box.Low.Y <= this->High.Y && this->Low.Z <= box.High.Z && box.Low.Z <= this->High.Z;
  }
  bool Contains(const Vector& x) const
  {
    return this->Low.X <= x.X && x.X <= this->High.X && this->Low.Y <= x.Y && x.Y <= this->High.Y &&
      this->Low.Z <= x.Z && x.Z <= this->High.Z;
  }
  bool Contains(const Bounds& box) const
  {
    return this->Low.X <= box.Low.X && box.High.X <= this->High.X && this->Low.Y <= box.Low.Y &&
      box.High.Y <= this->High.Y && this->Low.Z <= box.Low.Z && box.High.Z <= this->High.Z;
  }
  /// Of a point; 0 inside.
  double GetSquaredDistance(const Vector& x) const
  {
    const auto beyond = [](double low, double high, double at)
    { return std::max({ low - at, at - high, 0.0 }); };
    return Norm2({ beyond(this->Low.X, this->High.X, x.X), beyond(this->Low.Y, this->High.Y, x.Y),
      beyond(this->Low.Z, this->High.Z, x.Z) });
  }
  Vector GetCenter() const { return 0.5 * (this->Low + this->High); }
  double GetDiagonal() const { return this->IsEmpty() ? 0 : Norm(this->High - this->Low); }
};
}

#endif
