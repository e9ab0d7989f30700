// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorMessages.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkOutputWindow.h"

#include <QRegularExpression>

namespace
{
//------------------------------------------------------------------------------
void AddText(vtkObject*, unsigned long, void* clientData, void* callData)
{
  *static_cast<QString*>(clientData) += QString::fromUtf8(static_cast<const char*>(callData));
}
}

namespace camaron
{
//------------------------------------------------------------------------------
ErrorMessages::ErrorMessages(vtkObject* observed)
  : Observed(observed ? observed : vtkOutputWindow::GetInstance())
{
  this->Callback->SetClientData(&this->Text);
  this->Callback->SetCallback(AddText);
  this->Tag = this->Observed->AddObserver(vtkCommand::ErrorEvent, this->Callback);
}

//------------------------------------------------------------------------------
ErrorMessages::~ErrorMessages()
{
  this->Observed->RemoveObserver(this->Tag);
}

//------------------------------------------------------------------------------
QString ErrorMessages::first() const
{
  // "ERROR: In vtkReader.cxx, line 12", "vtkReader (0x55): reason", an empty line
  QString text = this->Text;
  text.remove(QRegularExpression("^\\s*ERROR: In .*, line \\d+\\s*"));
  text.remove(QRegularExpression("^[\\w:<>]+ \\((0x)?[0-9a-fA-F]+\\): "));
  return text.section("\n\n", 0, 0).simplified();
}
}
