// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSINumbersProperty
 * @brief Passes the numbers of a table property to its object one by one.
 *
 * ParaView calls the command of such a property once for each complete row and drops the remaining
 * numbers. With `si_class="vtkSINumbersProperty"` the command is called for each number, so the
 * object can report an incomplete row. The panel still shows rows of number_of_elements_per_command
 * numbers.
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
