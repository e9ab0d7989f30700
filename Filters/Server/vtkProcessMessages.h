// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkProcessMessages
 * @brief Collects errors and warnings of all processes.
 *
 * ParaView only shows what its first process reports; messages of other processes end up in their
 * standard error at best. While this object exists, processes store their messages instead of
 * printing them, and Gather collects them.
 */
#ifndef vtkProcessMessages_h
#define vtkProcessMessages_h

#include "vtkNew.h" // for observers
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for the window

#include <string> // for messages

class vtkCallbackCommand;
class vtkOutputWindow;

class vtkProcessMessages : public vtkObject
{
public:
  static vtkProcessMessages* New();
  vtkTypeMacro(vtkProcessMessages, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Collective. Moves messages of all other processes since the last call to the first process.
  void Gather();

  ///@{
  /// The messages that Gather collected, in the order of processes, each followed by a unit
  /// separator (0x1f). Empty on other processes than the first.
  const char* GetErrors() const { return this->Errors.c_str(); }
  const char* GetWarnings() const { return this->Warnings.c_str(); }
  ///@}

protected:
  vtkProcessMessages();
  ~vtkProcessMessages() override;

private:
  vtkProcessMessages(const vtkProcessMessages&) = delete;
  void operator=(const vtkProcessMessages&) = delete;

  void Observe(unsigned long event, vtkCallbackCommand* observer, std::string& messages);
  static void Collect(std::string& messages);

  vtkSmartPointer<vtkOutputWindow> Window; ///< null on the first process
  vtkNew<vtkCallbackCommand> ErrorObserver;
  vtkNew<vtkCallbackCommand> WarningObserver;
  int Mode = 0;
  int Verbosity = 0;
  std::string Errors;
  std::string Warnings;
};

#endif
