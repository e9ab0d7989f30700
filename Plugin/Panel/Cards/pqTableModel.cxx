// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTableModel.h"

#include "NumberText.h"

#include <QColor>

#include <utility>

//------------------------------------------------------------------------------
pqTableModel::Column pqTableModel::ShowColumn(
  const QString& title, const QString& column, bool isNumber)
{
  return { title,
    [column](const camaron::PanelTable& table, int row)
    {
      const QVariant value = table.value(row, column);
      return value.userType() == QMetaType::Double ? camaron::ShortNumber(value.toDouble())
                                                   : value.toString();
    },
    isNumber };
}

//------------------------------------------------------------------------------
pqTableModel::pqTableModel(QVector<Column> columns, QObject* parent)
  : Superclass(parent)
  , Columns(std::move(columns))
{
}

//------------------------------------------------------------------------------
void pqTableModel::setTable(const camaron::PanelTable& table)
{
  this->beginResetModel();
  this->Table = table;
  this->endResetModel();
}

//------------------------------------------------------------------------------
void pqTableModel::setRowColor(std::function<QColor(const camaron::PanelTable&, int row)> color)
{
  this->RowColor = std::move(color);
}

//------------------------------------------------------------------------------
int pqTableModel::rowCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : this->Table.size();
}

//------------------------------------------------------------------------------
int pqTableModel::columnCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : static_cast<int>(this->Columns.size());
}

//------------------------------------------------------------------------------
QVariant pqTableModel::data(const QModelIndex& index, int role) const
{
  const Column& column = this->Columns[index.column()];
  switch (role)
  {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
      return column.Text(this->Table, index.row());
    case Qt::TextAlignmentRole:
      return QVariant((column.IsNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case Qt::ForegroundRole:
    {
      const QColor color = this->RowColor ? this->RowColor(this->Table, index.row()) : QColor();
      return color.isValid() ? QVariant(color) : QVariant();
    }
    default:
      return QVariant();
  }
}

//------------------------------------------------------------------------------
QVariant pqTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
  if (orientation != Qt::Horizontal)
  {
    return QVariant();
  }
  const Column& column = this->Columns[section];
  return role == Qt::DisplayRole ? QVariant(column.Title)
    : role == Qt::TextAlignmentRole
    ? QVariant((column.IsNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter)
    : QVariant();
}
