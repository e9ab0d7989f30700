// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CoarseMeshDemand
 * @brief Tells when the coarse mesh that is drawn while the camera moves has to be made: when it
 * begins to move.
 *
 * ParaView 6.0 and 6.1 ask for it before the first picture after each update, for which nobody
 * needs it, and do not ask again. The first request after an update is therefore passed over. The
 * client, before its view begins to draw interactively, has the view ask once more if the coarse
 * mesh would be drawn, on all processes: these get the same requests and answer alike.
 */
#ifndef camaron_CoarseMeshDemand_h
#define camaron_CoarseMeshDemand_h

#include "vtkWeakPointer.h" // for the view

#include <functional> // for what the representation tells
#include <utility>    // for std::move

class vtkObject;
class vtkPVRenderView;
class vtkSMViewProxy;

namespace camaron
{
class CoarseMeshDemand
{
public:
  /// @a isWanted: for the client, whether the coarse mesh would be drawn if it was there.
  explicit CoarseMeshDemand(std::function<bool()> isWanted)
    : IsWanted(std::move(isWanted))
  {
  }
  ~CoarseMeshDemand();
  CoarseMeshDemand(const CoarseMeshDemand&) = delete;
  void operator=(const CoarseMeshDemand&) = delete;

  /// The view is updated, and may ask anew.
  void Update(vtkPVRenderView* view);
  /// The view asks for the coarse mesh. @a isMade: that of the present mesh is there.
  bool IsDue(bool isMade);
  /// The view is gone.
  void Forget();

private:
  void BeginPicture(vtkObject* proxy, unsigned long event, void* isInteractive);

  bool IsToBeAskedFor() const;

  std::function<bool()> IsWanted;
  vtkWeakPointer<vtkPVRenderView> View;
  vtkWeakPointer<vtkSMViewProxy> Proxy; ///< of the view, on the client
  unsigned long Tag = 0;
  bool WasAsked = false;
  bool IsAwaited = false;
};
}

#endif
