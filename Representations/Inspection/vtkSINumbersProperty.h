// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSINumbersProperty
 * @brief Gives the rows of a property that is a table to its object one number after the other.
 *
 * ParaView calls the command of such a property once for each whole row and drops what is left
 * over. With `si_class="vtkSINumbersProperty"` the command is called for each number, so that the
 * object can tell that a row is not complete; the panel still shows rows of
 * number_of_elements_per_command.
 */
#ifndef vtkSINumbersProperty_h
#define vtkSINumbersProperty_h

#include "vtkSIDoubleVectorProperty.h"

class vtkSINumbersProperty : public vtkSIDoubleVectorProperty
{
public:
  static vtkSINumbersProperty* New();
  vtkTypeMacro(vtkSINumbersProperty, vtkSIDoubleVectorProperty);

protected:
  vtkSINumbersProperty() = default;
  ~vtkSINumbersProperty() override = default;

  bool ReadXMLAttributes(vtkSIProxy* proxy, vtkPVXMLElement* element) override;

private:
  vtkSINumbersProperty(const vtkSINumbersProperty&) = delete;
  void operator=(const vtkSINumbersProperty&) = delete;
};

#endif
