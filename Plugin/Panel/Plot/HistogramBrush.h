// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::HistogramBrush
 * @brief The columns of a histogram that are brushed, and the values that they stand for.
 *
 * The number of elements in the columns is exactly the number of elements whose value is in one of
 * the closed ranges or among the specials, also for values on edges of bins.
 */
#ifndef camaron_HistogramBrush_h
#define camaron_HistogramBrush_h

#include "HistogramData.h"

#include <QBitArray>
#include <QPair>
#include <QVector>

namespace camaron
{
/// How a new brush is combined with the previous one.
enum class Combination
{
  Replace,
  Add,
  Subtract,
  Intersect
};

/// No modifier replaces, Shift adds, Ctrl subtracts, Ctrl+Shift intersects.
Combination ToCombination(Qt::KeyboardModifiers modifiers);

class HistogramBrush
{
public:
  /// Values outside of ranges.
  enum Special
  {
    Undefined = 1,
    Infinite = 2
  };
  using Ranges = QVector<QPair<double, double>>;

  /// Nothing is brushed.
  HistogramBrush() = default;
  /// The columns from @a first to @a last, in any order; columns that do not exist are ignored.
  HistogramBrush(const HistogramData& data, int first, int last);

  /// This brush combined with a newer one.
  HistogramBrush Combined(const HistogramBrush& newer, Combination combination) const;

  bool IsEmpty() const { return this->Columns.count(true) == 0; }
  bool Contains(int column) const { return column < this->Columns.size() && this->Columns[column]; }
  bool operator==(const HistogramBrush& other) const
  {
    return (this->Columns ^ other.Columns).count(true) == 0;
  }
  bool operator!=(const HistogramBrush& other) const { return !(*this == other); }

  /**
   * Closed ranges of finite values, increasing; adjacent columns share one. A bin [low, high) is
   * [low, largest number below high]. Underflow and overflow extend to the largest finite numbers.
   */
  Ranges GetRanges(const HistogramData& data) const;
  /// Sum of Special.
  int GetSpecials(const HistogramData& data) const;
  /// Number of elements.
  qint64 GetCount(const HistogramData& data) const;

private:
  QBitArray Columns; ///< missing ones are not brushed
};
}

#endif
