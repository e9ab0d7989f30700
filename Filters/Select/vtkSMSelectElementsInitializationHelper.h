// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMSelectElementsInitializationHelper
 * @brief Copies the active selection of the input to a new Select Elements filter.
 *
 * Extract Selection does the same. In addition, the copy is registered, so that state scripts
 * contain it, and traced: ParaView's trace handles Extract Selection by name and skips the creation
 * of any other filter with such an input.
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
