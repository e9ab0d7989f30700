// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMSelectElementsInitializationHelper
 * @brief Gives Select Elements the active selection of its input when the filter is made.
 *
 * As for Extract Selection; and the copy is registered, so that states of scripts keep it, and
 * traced. ParaView's trace knows Extract Selection by its name and leaves the creation of any other
 * filter with such an input out.
 */
#ifndef vtkSMSelectElementsInitializationHelper_h
#define vtkSMSelectElementsInitializationHelper_h

#include "vtkSMExtractSelectionProxyInitializationHelper.h"

class vtkSMSelectElementsInitializationHelper
  : public vtkSMExtractSelectionProxyInitializationHelper
{
public:
  static vtkSMSelectElementsInitializationHelper* New();
  vtkTypeMacro(
    vtkSMSelectElementsInitializationHelper, vtkSMExtractSelectionProxyInitializationHelper);

  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* element, vtkMTimeType initializedAt) override;

protected:
  vtkSMSelectElementsInitializationHelper() = default;
  ~vtkSMSelectElementsInitializationHelper() override = default;

private:
  vtkSMSelectElementsInitializationHelper(const vtkSMSelectElementsInitializationHelper&) = delete;
  void operator=(const vtkSMSelectElementsInitializationHelper&) = delete;
};

#endif
