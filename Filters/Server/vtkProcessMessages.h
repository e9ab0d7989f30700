// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkProcessMessages
 * @brief Collects the errors and warnings of all processes.
 *
 * ParaView shows what its first process reports; what readers and filters report on others ends on
 * their standard error at best. As long as this object lives, processes keep their messages instead
 * of printing them, and Gather collects them.
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

  /// Moves what was reported since the last call by other processes than the first to that.
  /// Collective.
  void Gather();

  ///@{
  /// What Gather found, in the order of the processes, each with a unit separator (0x1f) behind it.
  /// Empty on other processes than the first.
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

  vtkSmartPointer<vtkOutputWindow> Window; ///< none on the first process
  vtkNew<vtkCallbackCommand> ErrorObserver;
  vtkNew<vtkCallbackCommand> WarningObserver;
  int Mode = 0;
  int Verbosity = 0;
  std::string Errors;
  std::string Warnings;
};

#endif
