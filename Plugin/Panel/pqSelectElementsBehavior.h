// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqSelectElementsBehavior
 * @brief Makes what a Select Elements filter selects the active selection of the window.
 *
 * Happens when properties of the filter have changed and it has run, that is after Apply, and after
 * a state was loaded. The selection is the description "Selected is 1 on the output of the filter",
 * so it needs no help to follow later updates, and a selection that the user makes meanwhile is
 * left alone. Traces record it as SelectThresholds.
 */
#ifndef pqSelectElementsBehavior_h
#define pqSelectElementsBehavior_h

#include "vtkNew.h" // for the connector

#include <QObject>
#include <QSet> // for the filters that changed

class pqPipelineSource;
class vtkEventQtSlotConnect;
class vtkObject;

class pqSelectElementsBehavior : public QObject
{
  Q_OBJECT

public:
  explicit pqSelectElementsBehavior(QObject* parent = nullptr);
  ~pqSelectElementsBehavior() override;

  ///@{
  /// Called when the plugin is loaded and when the program ends.
  void startup();
  void shutdown();
  ///@}

private Q_SLOTS:
  void onSourceAdded(pqPipelineSource* source);
  void onSourceRemoved(pqPipelineSource* source);
  void onPropertyUpdated(vtkObject* proxy);
  void onDataUpdated(pqPipelineSource* source);

private:
  Q_DISABLE_COPY(pqSelectElementsBehavior)

  void select(pqPipelineSource* source);

  vtkNew<vtkEventQtSlotConnect> Connector;
  QSet<vtkObject*> ChangedProxies;
};

#endif
