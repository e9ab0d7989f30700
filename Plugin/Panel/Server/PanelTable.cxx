// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PanelTable.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <limits>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
QVariant ToVariant(vtkAbstractArray* column, vtkIdType row)
{
  if (auto* numbers = vtkDataArray::SafeDownCast(column))
  {
    return numbers->IsIntegral()
      ? QVariant(static_cast<qlonglong>(numbers->GetVariantValue(row).ToLongLong()))
      : QVariant(numbers->GetTuple1(row));
  }
  return QString::fromStdString(column->GetVariantValue(row).ToString());
}
}

//------------------------------------------------------------------------------
QVariant PanelTable::value(int row, const QString& column) const
{
  const auto place = this->Columns.indexOf(column);
  return place < 0 || row < 0 || row >= this->size() ? QVariant() : this->Rows[row][place];
}

//------------------------------------------------------------------------------
void PanelTable::append(const PanelTable& other)
{
  if (this->Columns.isEmpty())
  {
    this->Columns = other.Columns;
  }
  for (int row = 0; row < other.size(); ++row)
  {
    QVector<QVariant> values;
    for (const QString& column : this->Columns)
    {
      values << other.value(row, column);
    }
    this->Rows << values;
  }
}

//------------------------------------------------------------------------------
double PanelTable::number(int row, const QString& column) const
{
  const QVariant found = this->value(row, column);
  return found.isValid() ? found.toDouble() : std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
qint64 PanelTable::integer(int row, const QString& column) const
{
  return this->value(row, column).toLongLong();
}

//------------------------------------------------------------------------------
QString PanelTable::text(int row, const QString& column) const
{
  return this->value(row, column).toString();
}

//------------------------------------------------------------------------------
PanelTable ToPanelTable(vtkTable* table)
{
  PanelTable result;
  const int columns = table ? static_cast<int>(table->GetNumberOfColumns()) : 0;
  for (int c = 0; c < columns; ++c)
  {
    result.Columns << QString::fromUtf8(table->GetColumnName(c));
  }
  const vtkIdType rows = table ? table->GetNumberOfRows() : 0;
  for (vtkIdType r = 0; r < rows; ++r)
  {
    QVector<QVariant> row;
    for (int c = 0; c < columns; ++c)
    {
      row << ToVariant(table->GetColumn(c), r);
    }
    result.Rows << row;
  }
  return result;
}
}
