// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqInspectorState
 * @brief What the cards of the Mesh Inspector share: the mesh, the current criterion, and the
 * current element.
 */
#ifndef pqInspectorState_h
#define pqInspectorState_h

#include "InspectedMeshTypes.h"

#include <QObject>

class pqMeshServices;

class pqInspectorState : public QObject
{
  Q_OBJECT

public:
  pqInspectorState(const pqMeshServices& services, QObject* parent);

  const pqMeshServices& services() const { return this->Services; }

  ///@{
  /// Array whose histogram and worst elements are shown; empty if the mesh has no criterion, or
  /// none of the elements whose criteria the user looks at.
  QString criterion() const;
  void setCriterion(const QString& name);
  ///@}

  ///@{
  /// Type of the elements whose criteria the user looks at; perhaps they have not been evaluated
  /// yet.
  void setElements(const QString& type);
  bool awaitsElements() const;
  ///@}

  /// The user chose a criterion: it also colors the mesh.
  void chooseCriterion(const QString& name);

  ///@{
  /// The range that the histogram and the colors of the mesh judge by; the acceptable range until
  /// the user drags it, infinite without a criterion. Changes can be undone.
  double low() const { return this->limits().first; }
  double high() const { return this->limits().second; }
  void setLimits(double low, double high);
  void resetLimits() { this->changeLimits({}); }
  ///@}

  /// The acceptable range of the criterion for these cells, when the histogram knows it.
  void setAcceptable(double low, double high);

  ///@{
  /// Whether cards may compute tables of all cells without request: the mesh is small, or the user
  /// has allowed it for these cells.
  bool mayCompute() const;
  void allowComputing();
  ///@}

  ///@{
  /// The ranges that the user has set: of the current criterion or another one of the elements of
  /// the mesh, none while it has its acceptable range; and all of elements such as "Cell" as lines
  /// of a file of ranges (Core/Rules/ParsedRules.h).
  camaron::Limits userLimits() const { return this->userLimitsOf(this->Criterion); }
  camaron::Limits userLimitsOf(const QString& criterion) const
  {
    return this->LimitsOf.value(this->keyOf(criterion));
  }
  QStringList userRanges(const QString& elements) const;
  ///@}

  /// The range as a rule for `camaron check`; empty without limits or criterion.
  QString rule() const;

  ///@{
  /// What a report is about: the rules of the last check, then the ranges that the user has set,
  /// as rules and, those of cells, as the acceptable ranges.
  void setChecked(const camaron::CheckRequest& rules) { this->Checked = rules; }
  camaron::ReportRequest reportRequest() const;
  ///@}

  /// Adds a line to the rules of the Check card.
  void addRule(const QString& line) { Q_EMIT this->ruleAdded(line); }

  ///@{
  /// Whether flights to elements open the mesh around them. Default: on.
  void setOpensMesh(bool opens) { this->OpensMesh = opens; }
  bool opensMesh() const { return this->OpensMesh; }
  ///@}

  /// Shows the card of an element; the id is as in tables of the server.
  void showElement(qint64 id, const QString& idSpace) { Q_EMIT this->elementChosen(id, idSpace); }

Q_SIGNALS:
  void criterionChanged();
  void elementsChanged();
  void limitsChanged();
  void computingAllowed();
  void ruleAdded(const QString& line);
  void elementChosen(qint64 id, const QString& idSpace);

private:
  void followMesh();

  /// Another criterion colors the mesh, by ParaView's own means or by undo.
  void followColors();

  using Key = QPair<QString, QString>; // element type and criterion
  void changeLimits(const camaron::Limits& limits);

  /// Of a criterion shown now or before, by its key in LimitsOf.
  void restoreLimits(const Key& key, const camaron::Limits& limits);
  Key keyOf(const QString& criterion) const { return { this->ElementType, criterion }; }

  QPair<double, double> limits() const;

  const pqMeshServices& Services;
  QString ElementType = "Cell";
  QString WantedElements;
  QString Criterion;
  QString Colored;
  QMap<Key, camaron::Limits> LimitsOf; ///< of the user
  QMap<QString, QString> CriterionOf;  ///< the last one, by element type
  QPair<double, double> Acceptable;
  camaron::CheckRequest Checked;
  bool OpensMesh = true;
  int AllowedVersion = -1; ///< of the cells
};

#endif
