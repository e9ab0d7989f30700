// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TableRows.h
 * @brief Columns and rows of tables that filters make.
 */
#ifndef camaron_TableRows_h
#define camaron_TableRows_h

#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"
#include "vtkVariant.h"
#include "vtkVariantArray.h"

#include <array>            // for coordinates
#include <cstdint>          // for counts
#include <initializer_list> // for names
#include <limits>           // for NaN
#include <string>           // for text

namespace camaron
{
/// Columns of integers. VTK sends vtkIdTypeArray as integers of 32 bits from server to client, this
/// one as it is.
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

/// Values in the order of the columns.
class TableRow
{
public:
  void Add(const std::string& text) { this->Values->InsertNextValue(vtkVariant(text)); }
  void Add(double number) { this->Values->InsertNextValue(vtkVariant(number)); }
  void Add(std::int64_t count)
  {
    this->Values->InsertNextValue(vtkVariant(static_cast<vtkIdType>(count)));
  }
  void Add(const std::array<double, 3>& place)
  {
    for (const double coordinate : place)
    {
      this->Add(coordinate);
    }
  }
  void AppendTo(vtkTable* table) const { table->InsertNextRow(this->Values); }

private:
  vtkNew<vtkVariantArray> Values;
};

/// NaN if the whole is nothing.
inline double Percent(std::int64_t part, std::int64_t whole)
{
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole)
                   : std::numeric_limits<double>::quiet_NaN();
}
}

#endif
