// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::HelperFilters
 * @brief Filters of the server that answer questions of the panel, and their answers.
 *
 * They are not registered: no state, trace or undo step contains them. Each is kept for the next
 * question, and answers the same one again without computing.
 *
 * While a filter executes, ParaView may handle events. A question that one of these asks is
 * refused, because VTK's filters cannot execute twice at once: see isBusy() and onRefused().
 */
#ifndef camaron_HelperFilters_h
#define camaron_HelperFilters_h

#include "PanelTable.h"

#include "pqUndoStack.h" // for what is not recorded

#include "vtkSMSourceProxy.h" // for the filters
#include "vtkSmartPointer.h"  // for the filters

#include <QMap>
#include <QScopedValueRollback> // for questions
#include <QString>

#include <functional> // for what to do
#include <memory>     // for what is not recorded

class pqOutputPort;
class pqPipelineSource;

namespace camaron
{
/// A filter that answers questions, or nothing. While it is held, changes are not recorded for
/// undo.
class Helper
{
public:
  Helper(vtkSMSourceProxy* proxy)
    : Proxy(proxy)
    , Pause(std::make_shared<pqScopedUndoExclude>())
  {
  }
  operator vtkSMSourceProxy*() const { return this->Proxy; }
  vtkSMSourceProxy* operator->() const { return this->Proxy; }

private:
  vtkSMSourceProxy* Proxy;
  std::shared_ptr<pqScopedUndoExclude> Pause;
};

class HelperFilters
{
public:
  /// A proxy of the active server, as it was left; the key tells apart several of one name. nullptr
  /// if the server does not know it.
  Helper get(const char* group, const char* name, const char* key = "");

  using Properties = QMap<QString, QVariant>;
  ///@{
  /// A filter with these properties, and an output or that of another helper as input; nullptr
  /// without.
  Helper filter(
    const char* name, pqOutputPort* input, const char* key = "", const Properties& properties = {});
  Helper filter(const char* name, vtkSMSourceProxy* input, const char* key = "",
    const Properties& properties = {}, int port = 0);
  ///@}

  /// Releases all helpers.
  void clear();

  /// Releases the helpers that would keep @a removed alive: those whose input is not @a other.
  void forget(pqPipelineSource* removed, pqPipelineSource* other);

  /// The time of the active server's animation.
  static double time();

  /// Updates a filter for the current time. False if that was refused, and for nullptr.
  bool update(vtkSMSourceProxy* source);

  /// Updates a filter and returns a table that it computes: on process 0, or by pieces on all. It
  /// is empty for nullptr.
  PanelTable fetch(vtkSMSourceProxy* source, int port, bool isDistributed = false);

  /// While the returned object exists, the server computes.
  using Question = QScopedValueRollback<int>;
  Question ask() { return Question(this->Questions, this->Questions + 1); }

  bool isBusy() const { return this->Questions > 0; }

  /// Sets the action after a refused question.
  void onRefused(std::function<void()> action) { this->Refused = std::move(action); }

private:
  QMap<QString, vtkSmartPointer<vtkSMSourceProxy>> Known;
  vtkSmartPointer<vtkSMProxy> DataMover;
  int Questions = 0;
  std::function<void()> Refused;
};
}

#endif
