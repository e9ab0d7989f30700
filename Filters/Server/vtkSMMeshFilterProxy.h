// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMMeshFilterProxy
 * @brief Proxy of a filter that is drawn again after the cause of a failed update is fixed.
 *
 * ParaView's client notifies only proxies that it considers up to date. After a failed update, the
 * proxies downstream never are, so later changes would not reach the view, the selection or the
 * panel. This proxy notifies all representations downstream in that case.
 */
#ifndef vtkSMMeshFilterProxy_h
#define vtkSMMeshFilterProxy_h

#include "vtkSMSourceProxy.h"

class vtkSMMeshFilterProxy : public vtkSMSourceProxy
{
public:
  static vtkSMMeshFilterProxy* New();
  vtkTypeMacro(vtkSMMeshFilterProxy, vtkSMSourceProxy);

  void MarkDirty(vtkSMProxy* modifiedProxy) override;

protected:
  vtkSMMeshFilterProxy() = default;
  ~vtkSMMeshFilterProxy() override = default;

private:
  vtkSMMeshFilterProxy(const vtkSMMeshFilterProxy&) = delete;
  void operator=(const vtkSMMeshFilterProxy&) = delete;
};

#endif
