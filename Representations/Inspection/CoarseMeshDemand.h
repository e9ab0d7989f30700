// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CoarseMeshDemand
 * @brief Decides when to create the coarse mesh that is drawn while the camera moves: when it
 * starts to move.
 *
 * ParaView 6.0 and 6.1 request the coarse mesh before the first frame after each update, when it is
 * not needed, and not again later. Therefore the first request after an update is ignored. When the
 * view is about to render interactively and would draw the coarse mesh, the client makes the view
 * send the request again, on all processes. All processes get the same requests and decide alike.
 */
#ifndef camaron_CoarseMeshDemand_h
#define camaron_CoarseMeshDemand_h

#include "vtkWeakPointer.h" // for the view

#include <functional> // for the question to the representation
#include <utility>    // for std::move

class vtkObject;
class vtkPVRenderView;
class vtkSMViewProxy;

namespace camaron
{
class CoarseMeshDemand
{
public:
  /// @a isWanted: asked on the client, whether the coarse mesh would be drawn if it existed.
  explicit CoarseMeshDemand(std::function<bool()> isWanted)
    : IsWanted(std::move(isWanted))
  {
  }
  ~CoarseMeshDemand();
  CoarseMeshDemand(const CoarseMeshDemand&) = delete;
  void operator=(const CoarseMeshDemand&) = delete;

  /// The view has been updated, and may send requests again.
  void Update(vtkPVRenderView* view);
  /// The view requests the coarse mesh. @a isMade: that of the present mesh exists. Returns whether
  /// to create it now.
  bool IsDue(bool isMade);
  /// The representation was removed from the view.
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
