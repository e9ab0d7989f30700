// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FollowSessions.h
 * @brief What the plugin does when a client connects to a server.
 */
#ifndef camaron_FollowSessions_h
#define camaron_FollowSessions_h

namespace camaron
{
/**
 * Called when the plugin is loaded. On a client, now and for later connections and plugins: if both
 * sides have the plugin, offers Mesh Inspection as a representation type, and warns once per
 * connection if the plugin's version or build differs. Does nothing on servers.
 */
void FollowSessions();
}

#endif
