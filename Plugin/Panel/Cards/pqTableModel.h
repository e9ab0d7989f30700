// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTableModel
 * @brief Columns of a table from the server for a view: titles, formats, tooltips.
 */
#ifndef pqTableModel_h
#define pqTableModel_h

#include "PanelTable.h"

#include <QAbstractTableModel>

#include <functional> // for formats

class pqTableModel : public QAbstractTableModel
{
  Q_OBJECT
  typedef QAbstractTableModel Superclass;

public:
  /// A column of the view: its title, and its text for a row of the table.
  struct Column
  {
    QString Title;
    std::function<QString(const camaron::PanelTable&, int row)> Text;
    bool IsNumber = true; ///< numbers are aligned on the right
  };

  /// A column that shows a column of the table.
  static Column ShowColumn(const QString& title, const QString& column, bool isNumber = true);

  pqTableModel(QVector<Column> columns, QObject* parent);

  ///@{
  void setTable(const camaron::PanelTable& table);
  const camaron::PanelTable& table() const { return this->Table; }
  ///@}

  /// Color of the text of a row; the palette's if invalid. Default: none.
  void setRowColor(std::function<QColor(const camaron::PanelTable&, int row)> color);

  int rowCount(const QModelIndex& parent = QModelIndex()) const override;
  int columnCount(const QModelIndex& parent = QModelIndex()) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
  QVector<Column> Columns;
  camaron::PanelTable Table;
  std::function<QColor(const camaron::PanelTable&, int row)> RowColor;
};

#endif
