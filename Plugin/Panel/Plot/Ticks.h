// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Ticks.h
 * @brief Round numbers, the scale of an axis, and its ticks.
 */
#ifndef camaron_Ticks_h
#define camaron_Ticks_h

#include <QString>

#include <vector> // for lists

namespace camaron
{
/// Position of values along an axis from 0 (low) to 1 (high).
struct Scale
{
  /// @a low < @a high, finite; both positive if logarithmic.
  Scale(double low = 0, double high = 1, bool logarithmic = false)
    : Low(low)
    , High(high)
    , Logarithmic(logarithmic)
  {
  }

  ///@{
  /// Not clamped to [0, 1], except that values without a logarithm are at -1.
  double ToFraction(double value) const;
  double FromFraction(double fraction) const;
  ///@}

  double Low, High;
  bool Logarithmic;
};

struct Tick
{
  double Value = 0;
  QString Label; ///< empty for minor ticks
};

/**
 * Multiples of 1, 2 or 5 times a power of ten within [low, high], at most @a most + 1; their
 * distance is at least @a smallestStep.
 */
std::vector<double> GetRoundNumbers(double low, double high, int most, double smallestStep);

/// Numbers with one or two significant digits in each decade within [low, high], at most about
/// @a most; both ends positive.
std::vector<double> GetRoundNumbersOfDecades(double low, double high, int most);

/// Ticks of an axis with at most about @a most labels (at least 2); of a linear one, their distance
/// is at least @a smallestStep.
std::vector<Tick> GetTicks(const Scale& scale, int most, double smallestStep = 0);

/// Ticks of an axis of counts; no fractions, and large numbers as 20k or 1.5M.
std::vector<Tick> GetCountTicks(const Scale& scale, int most);
}

#endif
