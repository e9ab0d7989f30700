// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CoarseMeshDemand.h"

#include "vtkClientServerStream.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPVRenderView.h"
#include "vtkProcessModule.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSession.h"
#include "vtkSMViewProxy.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Null on processes without proxies, that is, servers.
vtkSMViewProxy* FindProxy(vtkPVRenderView* view)
{
  vtkSMSession* session = vtkSMProxyManager::IsInitialized()
    ? vtkSMProxyManager::GetProxyManager()->GetActiveSession()
    : nullptr;
  if (!session)
  {
    return nullptr;
  }
  vtkNew<vtkSMProxyIterator> proxies;
  proxies->SetSession(session);
  proxies->SetModeToOneGroup();
  for (proxies->Begin("views"); !proxies->IsAtEnd(); proxies->Next())
  {
    auto* proxy = vtkSMViewProxy::SafeDownCast(proxies->GetProxy());
    if (proxy && proxy->GetClientSideView() == view)
    {
      return proxy;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
void AskForCoarseMesh(vtkSMViewProxy* view)
{
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(view) << "UpdateLOD"
         << vtkClientServerStream::End;
  vtkSMSession* session = view->GetSession();
  session->PrepareProgress();
  session->ExecuteStream(view->GetLocation(), stream);
  session->CleanupPendingProgress();
}
}

//------------------------------------------------------------------------------
CoarseMeshDemand::~CoarseMeshDemand()
{
  this->Forget();
}

//------------------------------------------------------------------------------
void CoarseMeshDemand::Update(vtkPVRenderView* view)
{
  this->WasAsked = false;
  if (!this->Proxy || this->View != view)
  {
    this->Forget();
    this->View = view;
    this->Proxy = view ? FindProxy(view) : nullptr;
    if (this->Proxy)
    {
      this->Tag =
        this->Proxy->AddObserver(vtkCommand::StartEvent, this, &CoarseMeshDemand::BeginPicture);
    }
  }
}

//------------------------------------------------------------------------------
bool CoarseMeshDemand::IsDue(bool isMade)
{
  this->IsAwaited = !this->WasAsked && !isMade;
  this->WasAsked = true;
  return !this->IsAwaited;
}

//------------------------------------------------------------------------------
void CoarseMeshDemand::Forget()
{
  if (this->Proxy)
  {
    this->Proxy->RemoveObserver(this->Tag);
  }
  this->Proxy = nullptr;
  this->View = nullptr;
}

//------------------------------------------------------------------------------
void CoarseMeshDemand::BeginPicture(vtkObject*, unsigned long, void* isInteractive)
{
  if (!isInteractive || *static_cast<int*>(isInteractive) == 0)
  {
    return;
  }
  this->Proxy->Update(); // otherwise the view would do it next, and send a request then
  // A still frame may already have sent the first request.
  for (int i = 0; i < 2 && this->IsToBeAskedFor(); ++i)
  {
    AskForCoarseMesh(this->Proxy);
  }
}

//------------------------------------------------------------------------------
bool CoarseMeshDemand::IsToBeAskedFor() const
{
  return this->View->GetUseLODForInteractiveRender() && (!this->WasAsked || this->IsAwaited) &&
    this->IsWanted();
}
}
