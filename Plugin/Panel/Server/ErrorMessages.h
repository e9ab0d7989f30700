// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorMessages.h
 * @brief Errors of VTK or Python, to show them where the user is working.
 */
#ifndef camaron_ErrorMessages_h
#define camaron_ErrorMessages_h

#include <QString>

#include "vtkNew.h"          // for the callback
#include "vtkSmartPointer.h" // for the observed object

class vtkCallbackCommand;
class vtkObject;

namespace camaron
{
/// Collects the errors that VTK reports while it exists; they also appear in Output Messages.
class ErrorMessages
{
public:
  /// Observes VTK's output window, or another object that passes texts with error events.
  explicit ErrorMessages(vtkObject* observed = nullptr);
  ~ErrorMessages();

  /// The first error without its place in the source code; empty if there was none.
  QString first() const;

private:
  Q_DISABLE_COPY(ErrorMessages)

  vtkSmartPointer<vtkObject> Observed;
  vtkNew<vtkCallbackCommand> Callback;
  unsigned long Tag;
  QString Text;
};
}

#endif
