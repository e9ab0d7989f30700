// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ServerConnection.h"

#include "vtkClientSocket.h"
#include "vtkMultiProcessController.h"
#include "vtkSMProperty.h"
#include "vtkSMProxy.h"
#include "vtkSMSession.h"
#include "vtkSocket.h"
#include "vtkSocketCommunicator.h"

#ifndef _WIN32
#include <cerrno>
#include <sys/socket.h>
#endif

namespace camaron
{
//------------------------------------------------------------------------------
bool IsConnected(vtkSMSession* session)
{
  vtkMultiProcessController* controller =
    session ? session->GetController(vtkPVSession::DATA_SERVER_ROOT) : nullptr;
  auto* communicator =
    controller ? vtkSocketCommunicator::SafeDownCast(controller->GetCommunicator()) : nullptr;
  if (!communicator)
  {
    return true;
  }
  vtkSocket* server = communicator->GetSocket();
  if (!server || !server->GetConnected())
  {
    return false;
  }
#ifndef _WIN32
  char byte = 0;
  const auto read =
    recv(server->GetSocketDescriptor(), &byte, sizeof(byte), MSG_PEEK | MSG_DONTWAIT);
  return read > 0 || (read < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR));
#else
  return true;
#endif
}

//------------------------------------------------------------------------------
bool UpdateInformation(vtkSMProxy* proxy, vtkSMProperty* property)
{
  if (!IsConnected(proxy->GetSession()))
  {
    return false;
  }
  if (property)
  {
    proxy->UpdatePropertyInformation(property);
  }
  else
  {
    proxy->UpdatePropertyInformation();
  }
  return true;
}
}
