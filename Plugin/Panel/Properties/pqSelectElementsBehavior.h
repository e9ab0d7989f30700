// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqSelectElementsBehavior
 * @brief Makes the result of a Select Elements filter the active selection of the window.
 *
 * This happens when the filter has executed after its properties changed, that is, after Apply and
 * after loading a state. The active selection is the query "Selected is 1 on the output of the
 * filter", so it follows later updates by itself, and a selection that the user makes in the
 * meantime is kept. Traces record it as SelectThresholds.
 */
#ifndef pqSelectElementsBehavior_h
#define pqSelectElementsBehavior_h

#include "vtkEventQtSlotConnect.h" // for the filters that change
#include "vtkNew.h"                // for the connector

#include <QList> // for the filters that were updated
#include <QObject>
#include <QPointer>
#include <QSet> // for the filters that changed

class pqPipelineSource;
class vtkObject;

class pqSelectElementsBehavior : public QObject
{
  Q_OBJECT

public:
  using QObject::QObject;

  ///@{
  /// Called when the plugin is loaded and when the program exits.
  void startup();
  void shutdown();
  ///@}

private Q_SLOTS:
  void onSourceAdded(pqPipelineSource* source);
  void onSourceRemoved(pqPipelineSource* source);
  void onPropertyUpdated(vtkObject* proxy);
  void onDataUpdated(pqPipelineSource* source);

private:
  vtkNew<vtkEventQtSlotConnect> Connector;
  QSet<vtkObject*> ChangedProxies;
  QList<QPointer<pqPipelineSource>> Updated; // their results are to become the selection
};

#endif
