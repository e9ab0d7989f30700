// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::HistogramData
 * @brief A histogram as the server computed it, and its columns.
 *
 * Plain data without any drawing. A *column* is what the plot draws as a bar: the bins, and besides
 * them the elements that are in no bin. Columns are numbered from left to right as they appear.
 */
#ifndef camaron_HistogramData_h
#define camaron_HistogramData_h

#include <QString>

#include <limits>  // for infinity
#include <utility> // for pair
#include <vector>  // for edges and counts

namespace camaron
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

struct HistogramData
{
  struct Group
  {
    QString Label;
    std::vector<qint64> Counts; ///< one per column
    std::vector<qint64> Judged; ///< in each bin, those that the acceptable range applies to
  };

  /// In the order of the columns.
  enum class Column
  {
    Underflow, ///< finite and below the first edge
    Bin,
    Overflow, ///< finite and above the last edge
    Infinite, ///< of either sign
    Undefined ///< NaN
  };

  QString Name;     ///< of the criterion, for people
  QString Unit;     ///< as in the tables of the server, such as "deg"; may be empty
  QString Elements; ///< plural noun such as "cells"; may be empty
  /**
   * Bin i is [edge i, edge i+1); the last one includes its upper edge. Either empty, or n+1 finite
   * numbers for n bins in increasing order, or twice the same number for constant data.
   */
  std::vector<double> Edges;
  std::vector<Group> Groups; ///< stacked if more than one
  Group Selected;            ///< the selected ones of all; without Counts if they are not known
  std::vector<Group> SelectedGroups; ///< of each group if there are several; empty ones may lack
  bool Logarithmic = false;          ///< bins of equal ratio; all edges are positive

  int GetNumberOfBins() const;
  /// All values in bins are the same.
  bool IsConstant() const;
  /// Bins that contain one integer each, as those of counts.
  bool HasIntegerBins() const;
  /// The values may be whole numbers only, as far as the bins tell.
  bool HasWholeNumbers() const;
  /// No group has an element.
  bool IsEmpty() const { return this->GetTotal() == 0; }

  ///@{
  /// Underflow, the bins, overflow, infinite, undefined: number of bins + 4.
  int GetNumberOfColumns() const { return this->GetNumberOfBins() + 4; }
  Column GetType(int column) const;
  bool IsBin(int column) const { return this->GetType(column) == Column::Bin; }
  int GetColumnOfBin(int bin) const { return bin + 1; }
  int GetColumn(Column type) const; ///< of a type other than Bin
  ///@}

  ///@{
  /// Number of elements of all groups: in a column, in all columns, in the bin with the most.
  qint64 GetCount(int column) const;
  qint64 GetCount(Column type) const { return this->GetCount(this->GetColumn(type)); }
  qint64 GetTotal() const;
  qint64 GetLargestCount() const;
  ///@}

  /// Number of elements in a column that the acceptable range does not apply to, while it applies
  /// to others; 0 for several groups.
  qint64 GetNotJudged(int column) const;

  /// Number of elements whose value is not NaN, on which the cumulative curve is based.
  qint64 GetNumberOfValues() const;

  /// Ends of the axis: the first and the last edge, wider for constant data, arbitrary without
  /// bins.
  std::pair<double, double> GetAxisRange() const;

  /// Whether edges, scale and groups agree, so that the data can be drawn.
  bool IsValid() const;
};
}

#endif
