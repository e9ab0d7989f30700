// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqMeshSelection
 * @brief The active selection of the inspected mesh: brushes, steps of selection, past selections.
 *
 * Steps are Select Elements in the pipeline after the mesh.
 */
#ifndef pqMeshSelection_h
#define pqMeshSelection_h

#include "HistogramBrush.h"
#include "InspectedMeshTypes.h"
#include "PastSelection.h"

#include <QMap>
#include <QObject>
#include <QPointer>  // for a port
#include <pqTimer.h> // for a delayed signal

class pqInspectedMesh;
class pqMeshFilters;
class pqMeshQuestions;
class pqPipelineSource;

class pqMeshSelection : public QObject
{
  Q_OBJECT

public:
  pqMeshSelection(
    pqInspectedMesh* mesh, pqMeshQuestions* questions, pqMeshFilters* filters, QObject* parent);

  /// What is selected.
  camaron::SelectionInfo info() const;

  /// Makes the cells with a value in one of the closed ranges, or with a special value, the active
  /// selection of the mesh, or combines them with it. Returns whether the selection changes.
  bool selectValues(const QString& array, const QVector<QPair<double, double>>& ranges,
    int specials, camaron::Combination combine);

  /// Applies a strategy of Select Elements; see selection.md. Steps form a chain in the pipeline.
  void selectBy(const QString& strategy, const QMap<QString, QVariant>& properties,
    camaron::Combination combine = camaron::Combination::Replace);

  /// Selects the elements that a criterion fails: outside the limits, by default its acceptable
  /// range, or undefined.
  void selectOutside(const QString& criterion, const camaron::Limits& limits = {});

  /// Selects the elements with a bit of CellStatus, which is evaluated if they lack it.
  void selectDefect(const QString& bit);

  /// Selects connected groups of cells outside a range, by the id of one cell of each.
  void selectPlaces(const QStringList& ids, const QString& idSpace, const QString& array,
    const camaron::Limits& limits);

  /// How the active selection came about: a brush, or what was selected in the view, unless the
  /// steps begin anew; the steps of the chain that ends at the mesh; and a selection since then.
  /// With each, the count of steps for undoTo(), or Present for what is selected now.
  QVector<QPair<QString, int>> steps() const;
  static constexpr int Present = -1;

  /// Removes steps from the end until `count` are left, and selects what the last of these selects;
  /// returns an error if a filter uses one of the others.
  QString undoTo(int count);

  void clear();

  /// The last 20 active selections, latest first, by brushes, steps and in views: what was
  /// selected, and how many elements.
  QStringList past() const;

  /// Makes one of them the active selection again, and its mesh the inspected one.
  void reselect(int place);

  /// What selects the active selection by values of arrays; empty if it is another one.
  QVector<camaron::BrushedValues> brushes() const;

Q_SIGNALS:
  void selectionChanged();

  /// Exactly one element is selected in a view.
  void elementPicked();

private:
  /// selectValues by Select Elements, for what thresholds cannot express.
  void selectValuesBySteps(const QString& array, const QVector<QPair<double, double>>& ranges,
    int specials, camaron::Combination combination);

  /// The filters of the chain of Select Elements that ends at the mesh, first to last.
  QList<pqPipelineSource*> stepFilters() const;

  /// Description of a step of selection, such as "Worst 1 % by Volume".
  QString describeStep(pqPipelineSource* filter) const;

  /// After a step of selection was removed: activates what the step before it selects, or the
  /// selection that the first step began with.
  void restoreSelection();

  /// Adds the active selection to the past ones, unless it is one of them.
  void rememberSelection();

  /// Makes a selection that has been one before the active one, and records it in a trace.
  void activate(const camaron::PastSelection& past);
  camaron::PastSelection active() const;

  pqInspectedMesh* Mesh;
  pqMeshQuestions* Questions;
  pqMeshFilters* Filters;
  pqTimer SelectionTimer;
  camaron::PastSelection SelectionBefore; // the first step of selection
  bool IsStepRemoved = false;
  QList<camaron::PastSelection> Past; // latest first
  camaron::PastSelection Brushed;     // by the brush whose selection is to be remembered
  QPointer<pqOutputPort> BrushedPort;
  int BrushSteps = 0; // of the last brush; the last one has BrushedPort
};

#endif
