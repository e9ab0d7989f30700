// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OnLoading.h
 * @brief What is called when the plugin is loaded.
 */
#ifndef camaron_OnLoading_h
#define camaron_OnLoading_h

namespace camaron
{
/**
 * On a client, now and for later connections and plugins: if both sides have the plugin, offers
 * Mesh Inspection as a representation type, and warns once per connection if the plugin's version
 * or build differs. Does nothing on servers.
 */
void FollowSessions();

/**
 * The part for ParaView's window is a plugin of its own. In a program with this window,
 * Panel/CamaronPanel.so beside the plugin, if it is there, is loaded right after it, whoever loads
 * the plugin. Does nothing in other programs, which have no Qt.
 */
void LoadPanel();
}

#endif
