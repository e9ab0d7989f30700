// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ServerConnection.h
 * @brief Questions to a server that may have ended.
 *
 * ParaView notices the end of a server when it next handles events, or waits for an answer. If the
 * answer is an information property, it aborts then.
 */
#ifndef camaron_ServerConnection_h
#define camaron_ServerConnection_h

class vtkSMProxy;
class vtkSMProperty;
class vtkSMSession;

namespace camaron
{
/// Whether the server of the session still runs; without a server, or on Windows, always.
bool IsConnected(vtkSMSession* session);

/// Updates an information property, or all of them, if the server still runs; else returns false.
bool UpdateInformation(vtkSMProxy* proxy, vtkSMProperty* property = nullptr);
}

#endif
