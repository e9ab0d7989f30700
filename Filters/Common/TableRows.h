// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TableRows.h
 * @brief Adds columns and rows to the tables that filters create, and sorts rows of all processes.
 */
#ifndef camaron_TableRows_h
#define camaron_TableRows_h

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"
#include "vtkVariant.h"
#include "vtkVariantArray.h"

#include <array>            // for coordinates
#include <cstdint>          // for counts
#include <initializer_list> // for names
#include <limits>           // for NaN
#include <optional>         // for times
#include <string>           // for text

namespace camaron
{
class Reducer;

/// A column of 64-bit integers. VTK sends a vtkIdTypeArray from server to client as 32-bit
/// integers, but this type unchanged.
using IntegerColumn = vtkTypeInt64Array;

template <typename Array>
void AddColumns(vtkTable* table, std::initializer_list<std::string> names)
{
  for (const std::string& name : names)
  {
    vtkNew<Array> column;
    column->SetName(name.c_str());
    table->AddColumn(column);
  }
}

/// Adds the columns of the labels with which a TableRow starts.
inline void AddLabelColumns(vtkTable* table, bool hasTime)
{
  if (hasTime)
  {
    AddColumns<vtkDoubleArray>(table, { "Time" });
  }
  AddColumns<vtkStringArray>(table, { "Criterion", "Unit", "Group" });
}

/// A row of a table. Add its values in the order of the columns.
class TableRow
{
public:
  TableRow() = default;
  /// Starts with labels. @a time: for tables with that column
  TableRow(const std::optional<double>& time, const std::string& criterion, const std::string& unit,
    const std::string& group)
  {
    if (time)
    {
      this->Add(*time);
    }
    this->Add(criterion, unit, group);
  }

  /// Numbers are double or std::int64_t.
  template <typename... Values>
  void Add(const Values&... values)
  {
    (this->AddValue(values), ...);
  }
  void AppendTo(vtkTable* table) const { table->InsertNextRow(this->Values); }

private:
  void AddValue(const std::string& text) { this->Values->InsertNextValue(vtkVariant(text)); }
  void AddValue(double number) { this->Values->InsertNextValue(vtkVariant(number)); }
  void AddValue(std::int64_t count)
  {
    this->Values->InsertNextValue(vtkVariant(static_cast<vtkIdType>(count)));
  }
  void AddValue(const std::array<double, 3>& place) { this->Add(place[0], place[1], place[2]); }

  vtkNew<vtkVariantArray> Values;
};

/// @a part of @a whole in percent; NaN if @a whole is 0.
inline double Percent(std::int64_t part, std::int64_t whole)
{
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole)
                   : std::numeric_limits<double>::quiet_NaN();
}

/// One process has memory for them.
constexpr int MostSortedRows = 1000000;

/**
 * Moves the rows of all processes to process 0 and sorts them by a column of one component, which
 * moves behind the first @a fixed columns; rows with the same value by the columns Block and Id.
 * Undefined values are last. Columns without any value (only NaN or empty texts) are left out.
 * Without the column, the rows are those of one process after the other. More than MostSortedRows
 * of all processes stay where they are. All processes must call this. Throws std::runtime_error on
 * all of them if the rows cannot be gathered.
 */
void SortRows(
  vtkTable* table, const std::string& column, bool isDescending, int fixed, Reducer& reducer);
}

#endif
