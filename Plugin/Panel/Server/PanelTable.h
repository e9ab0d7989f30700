// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PanelTable.h
 * @brief A table that the panel received from the server.
 */
#ifndef camaron_PanelTable_h
#define camaron_PanelTable_h

#include <QStringList>
#include <QVariant>
#include <QVector>

class vtkTable;

namespace camaron
{
/// Rows of a few thousand cells at most; numbers are double or qlonglong, everything else is text.
struct PanelTable
{
  QStringList Columns;
  QVector<QVector<QVariant>> Rows;

  bool isEmpty() const { return this->Rows.isEmpty(); }
  int size() const { return static_cast<int>(this->Rows.size()); }

  /// Adds the rows of a table, whose columns may have another order; missing ones become invalid.
  void append(const PanelTable& other);

  /// A cell; an invalid variant if there is no such row or column.
  QVariant value(int row, const QString& column) const;

  double number(int row, const QString& column) const;
  qint64 integer(int row, const QString& column) const;
  QString text(int row, const QString& column) const;
};

/// All rows of a table; an empty table for nullptr.
PanelTable ToPanelTable(vtkTable* table);
}

#endif
