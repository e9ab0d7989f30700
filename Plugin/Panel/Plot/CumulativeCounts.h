// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CumulativeCounts
 * @brief Cumulative curve of a criterion: how many elements have at most a value.
 *
 * Exact at the points of the curve and interpolated linearly between them. With the values that
 * GetCurveValues() returns among its points (CurveValues of QualityStatistics), the counts are
 * exact for the limits that the plot offers while a handle is dragged.
 */
#ifndef camaron_CumulativeCounts_h
#define camaron_CumulativeCounts_h

#include "HistogramData.h"

#include <vector> // for points

namespace camaron
{
struct CumulativeCounts
{
  /// A number, and whether it is exact or interpolated.
  struct Estimate
  {
    double Value = 0;
    bool Exact = true;
  };
  /// The elements outside a range.
  struct Outside
  {
    Estimate Count;
    Estimate WeightPercent; ///< NaN without weights
  };

  std::vector<double> Values;         ///< strictly increasing
  std::vector<qint64> Counts;         ///< number of elements with at most this value
  std::vector<double> WeightPercents; ///< percentage of the total weight; empty without weights

  bool IsEmpty() const { return this->Values.empty(); }

  /**
   * Elements with a value below @a low or above @a high, infinite ones included; either limit may
   * be infinite. @a numberOfValues: HistogramData::GetNumberOfValues. Below the first point there
   * are none, and up to a value above the last one as many as there: exact if the points include
   * the extreme values.
   */
  Outside GetOutside(double low, double high, qint64 numberOfValues) const;
};

/**
 * Values at which a limit may be put by dragging, increasing: round numbers, about 100 over the
 * range of the histogram; whole numbers for bins of integers.
 */
std::vector<double> GetRoundLimits(const HistogramData& data);

/**
 * Values at which the curve must be known for exact counts outside any range between bin edges,
 * round limits, @a low and @a high: these, and for each the next smaller number.
 */
std::vector<double> GetCurveValues(const HistogramData& data, double low, double high);
}

#endif
