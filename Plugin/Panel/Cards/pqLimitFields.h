// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLimitFields
 * @brief Two fields for the limits of a range, and a button for the range of the criterion.
 *
 * An empty field is no limit. Once the user has finished a text that is no limit, or a lower limit
 * above the upper one, the fields show the former limits again.
 */
#ifndef pqLimitFields_h
#define pqLimitFields_h

#include <QPair>
#include <QWidget>

#include <limits>   // for infinity
#include <optional> // for texts that are no range

class QLabel;
class QLineEdit;
class QToolButton;

class pqLimitFields : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

public:
  explicit pqLimitFields(QWidget* parent = nullptr);

  /// Shows a range, with infinite ends for no limit, without signals. @a isOwn: it is the range of
  /// the criterion, so there is nothing to restore.
  void showLimits(double low, double high, const QString& unit, bool isOwn);

Q_SIGNALS:
  ///@{
  /// Emitted while the user types a valid range, and after Return or when the field is left.
  void limitsEdited(double low, double high);
  void limitsChanged(double low, double high);
  ///@}
  void resetRequested();

private:
  QLineEdit* addField(const char* name, const QString& tip);
  void finish();
  void showTexts();

  /// The range in the fields; nothing if it is invalid.
  std::optional<QPair<double, double>> read() const;

  QLineEdit* Low;
  QLineEdit* High;
  QLabel* Unit;
  QToolButton* Reset;
  QPair<double, double> Shown = { -std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() };
};

#endif
