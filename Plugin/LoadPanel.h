// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LoadPanel.h
 * @brief The part of the plugin for ParaView's window, which is a plugin of its own.
 */
#ifndef camaron_LoadPanel_h
#define camaron_LoadPanel_h

namespace camaron
{
/**
 * Called when the plugin is loaded. In a program with ParaView's window, Panel/CamaronPanel.so
 * beside the plugin, if it is there, is loaded right after it, whoever loads the plugin. Does
 * nothing in other programs, which have no Qt.
 */
void LoadPanel();
}

#endif
