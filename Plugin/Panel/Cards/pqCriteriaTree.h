// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqCriteriaTree
 * @brief Criteria to tick, by family, with a summary of their values.
 *
 * Columns: label with a tick box, small histogram, number of elements outside the acceptable range.
 * Used by the card "Criteria" and by the panel of Element Quality.
 */
#ifndef pqCriteriaTree_h
#define pqCriteriaTree_h

#include "InspectedMeshTypes.h"

#include <QTreeWidget>

class pqCriteriaTree : public QTreeWidget
{
  Q_OBJECT
  typedef QTreeWidget Superclass;
  /// Names of the ticked criteria, separated by blanks; for GUI tests.
  Q_PROPERTY(QString ticks READ ticksText WRITE setTicksText)
  /// The number of selected elements in each small histogram, as far as they differ; for GUI tests.
  Q_PROPERTY(QString selectedCounts READ selectedCounts)
  /// Names of criteria that some elements fail, each with their number; for GUI tests.
  Q_PROPERTY(QString badCounts READ badCounts)

public:
  explicit pqCriteriaTree(QWidget* parent = nullptr);

  /// Shows the criteria of an element type: "Cell", "Face", "Edge" or "Vertex".
  void setCriteria(const QVector<camaron::CriterionInfo>& criteria, const QString& element);

  ///@{
  /// Names of the ticked criteria in their order. Setting them emits nothing.
  QStringList ticks() const;
  void setTicks(const QStringList& names);
  QString ticksText() const { return this->ticks().join(' '); }
  void setTicksText(const QString& text);
  ///@}

  /// No more than the minimum, so that other cards are seen beside it; it grows in a high window.
  QSize sizeHint() const override { return this->minimumSize(); }

  /// Shows histograms and counts; criteria without any lose theirs. @a elements: noun for tooltips;
  /// @a own: criteria whose range the user has set, so that it is no hint.
  void setDistributions(const QVector<camaron::Distribution>& distributions,
    const QString& elements, const QStringList& own);

  QString selectedCounts() const;
  QString badCounts() const;

  /// Marks a criterion as the current one without a signal.
  void setCurrentCriterion(const QString& name);

public Q_SLOTS:
  /// Shows only criteria whose label, name or description contains all words of the text.
  void search(const QString& text);

Q_SIGNALS:
  /// The user ticked a criterion.
  void ticksChanged();

  /// The user chose a criterion.
  void criterionChosen(const QString& name);
  /// The user clicked the number of bad elements of the chosen criterion.
  void failingChosen(const QString& name);

private:
  /// Items of criteria, not of families.
  QList<QTreeWidgetItem*> items() const;

  QVector<camaron::CriterionInfo> Criteria;
};

#endif
