// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CheckStates.h
 * @brief Errors about state files whose properties have former names.
 */
#ifndef camaron_CheckStates_h
#define camaron_CheckStates_h

namespace camaron
{
/// Called when the plugin is loaded. From now on, every .pvsm file that sets a property by a former
/// name causes an error with the new name; ParaView would ignore the property without a message.
void CheckStates();
}

#endif
