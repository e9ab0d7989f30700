// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkProcessMessages
 * @brief Collects errors and warnings of all processes.
 *
 * ParaView only shows what its first process reports; messages of other processes end up in their
 * standard error at best. While this object exists, other processes store their messages instead of
 * printing them, and Gather collects them.
 *
 * After Observe, an object only collects the messages of its own process.
 *
 * Messages may come from any thread. Therefore a window of its own stores them: events of VTK's
 * window are not safe for threads, and observers in Python would wait forever for Python's lock,
 * which is held while a pipeline is updated, if a thread of the pipeline reports something, as
 * those of ParaView 6.1's reader of OpenFOAM cases do.
 */
#ifndef vtkProcessMessages_h
#define vtkProcessMessages_h

#include "vtkObject.h"
#include "vtkSmartPointer.h" // for the window

#include <string> // for messages

class vtkMessageStore;

class vtkProcessMessages : public vtkObject
{
public:
  static vtkProcessMessages* New();
  vtkTypeMacro(vtkProcessMessages, vtkObject);

  /// Collects the messages of this process, and only these, from now on; no longer prints them.
  void Observe();

  /// Collective, unless Observe was called. Moves the messages since the last call to the first
  /// process.
  void Gather();

  ///@{
  /// The messages that the last Gather collected, in the order of processes, each followed by a
  /// unit separator (0x1f). Empty on other processes than the first.
  const char* GetErrors() const { return this->Errors.c_str(); }
  const char* GetWarnings() const { return this->Warnings.c_str(); }
  ///@}

protected:
  vtkProcessMessages();
  ~vtkProcessMessages() override;

private:
  vtkProcessMessages(const vtkProcessMessages&) = delete;
  void operator=(const vtkProcessMessages&) = delete;

  void Start();
  std::string Collect(const std::string& texts) const;

  vtkSmartPointer<vtkMessageStore> Store; ///< null if this process is not observed
  bool IsAlone = false;                   ///< only messages of this process are wanted
  int Verbosity = 0;
  std::string Errors;
  std::string Warnings;
};

#endif
