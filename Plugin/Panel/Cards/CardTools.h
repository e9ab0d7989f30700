// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CardTools.h
 * @brief Widgets that several cards have.
 */
#ifndef camaron_CardTools_h
#define camaron_CardTools_h

#include "InspectedMeshTypes.h"
#include "pqTableModel.h"

#include "pqFileDialog.h" // for its modes

#include <QIcon>
#include <QString>

class pqServer;
class QComboBox;
class QLabel;
class QTableView;
class QToolButton;
class QWidget;

namespace camaron
{
/// A widget with an object name; the other arguments of its constructor precede the parent.
template <typename Widget, typename... Arguments>
Widget* Make(QWidget* parent, const QString& name, const Arguments&... arguments)
{
  auto* widget = new Widget(arguments..., parent);
  widget->setObjectName(name);
  return widget;
}

/// How a table divides its width.
struct TableShape
{
  int Rows = 6; ///< that are visible without scrolling
  /// Index of the column that stretches; if space is short, the columns after it scroll. Its texts
  /// wrap if they are longer than this number of characters; 0: never.
  int WideColumn = 0, Characters = 0;
  bool ShrinksToRows = false; ///< no higher than its rows need
};

/// A table of whole rows without row numbers. Enter and the space bar activate the current row.
QTableView* MakeTable(
  QWidget* parent, const char* name, pqTableModel* model, const TableShape& shape);

/// The icon Icons/NAME.svg, always in the color of texts, so that it is visible on light and dark
/// backgrounds.
QIcon PanelIcon(const QString& name);

/// A flat button with the icon Icons/NAME.svg.
QToolButton* MakeTool(QWidget* parent, const char* name, const QString& tip);

/// Enables a widget, or disables it with the reason as a second line of its tool tip.
void SetEnabled(QWidget* widget, bool isEnabled, const QString& reason);

/// A label with several lines, whose text can be copied.
QLabel* MakeText(QWidget* parent, const char* name, bool hasLinks = false);

/// Sets the text of a label, which takes no space without one.
void ShowText(QLabel* label, const QString& text);

/// Fills a list with presets, each with its purpose below its name, after an item for none of them,
/// without signals. The data of an item are the names of its criteria.
void FillPresets(QComboBox* box, const QString& none, const QVector<PresetInfo>& presets);

/// What a card shows while criteria are evaluated, with the estimated time if it is worth telling.
QString SpellWork(double seconds = 0);

/// Grays presets of such a list out, with the reasons below their names.
void GrayPresets(QComboBox* box, const QMap<QString, QString>& reasons);

/**
 * Lets the user choose a path with ParaView's file dialog, on the server or, if that is nullptr, on
 * this computer. The dialog has an object name for GUI tests. Returns an empty text if canceled.
 */
QString AskForPath(QWidget* parent, const char* name, const QString& title, pqServer* server,
  const QString& filters, pqFileDialog::FileMode mode);
}

#endif
