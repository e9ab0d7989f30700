// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSINumbersProperty.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSINumbersProperty);

//------------------------------------------------------------------------------
bool vtkSINumbersProperty::ReadXMLAttributes(vtkSIProxy* proxy, vtkPVXMLElement* element)
{
  const bool isRead = this->Superclass::ReadXMLAttributes(proxy, element);
  this->NumberOfElementsPerCommand = 1;
  return isRead;
}
