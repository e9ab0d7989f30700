// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ElementMarker
 * @brief Draws some elements in a view in a separate color.
 *
 * Its representation is hidden as those of ParaView's 3D widgets: it is in no state, trace or undo
 * step, and in no list of the user.
 */
#ifndef camaron_ElementMarker_h
#define camaron_ElementMarker_h

#include "pqRenderView.h" // for the pointer to it

#include "vtkSmartPointer.h" // for the representation
#include "vtkWeakPointer.h"  // for what it draws

#include <QMap>
#include <QPointer>
#include <QString>
#include <QVariant>

class vtkSMProxy;
class vtkSMSourceProxy;

namespace camaron
{
class ElementMarker
{
public:
  /// @param name of the representation
  explicit ElementMarker(const char* name)
    : Name(name)
  {
  }
  ~ElementMarker();
  ElementMarker(const ElementMarker&) = delete;
  void operator=(const ElementMarker&) = delete;

  /// Draws the first output of a filter, which consists of these elements.
  void show(
    pqRenderView* view, vtkSMSourceProxy* elements, const QMap<QString, QVariant>& properties);
  void hide();

private:
  const char* Name;
  vtkSmartPointer<vtkSMProxy> Representation;
  vtkWeakPointer<vtkSMSourceProxy> Elements;
  QPointer<pqRenderView> View;
};
}

#endif
