// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMMeshFilterProxy
 * @brief A filter that is drawn again when what made an update fail has been mended.
 *
 * ParaView's client tells of a change only those that it knows to be up to date. What a failed
 * update leaves behind is not, for good: no later change would reach the view, the selection or the
 * panel. Here such changes wake all representations downstream.
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
