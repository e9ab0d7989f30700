// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FormerNames.h
 * @brief Public names that were replaced before version 0.1.0, for errors that give the new name.
 *
 * The former names are not accepted.
 */
#ifndef camaron_FormerNames_h
#define camaron_FormerNames_h

#include <string>      // for messages
#include <string_view> // for names

namespace camaron
{
struct FormerName
{
  std::string_view Former;
  std::string_view Name;
};

inline constexpr FormerName FormerNames[] = {
  // Properties:
  { "LeaveNulls", "ExcludeUndefined" },
  { "NullColor", "UndefinedColor" },
  { "NumberOfRings", "NumberOfLayers" },
  { "PartNumber", "ComponentNumber" },
  { "WorstShare", "WorstPercentage" },
  { "WriteNullMask", "WriteUndefinedMask" },
  // Strategies of Select Elements, and Worst Values of Quality Statistics:
  { "Change kind", "Change element type" },
  { "Null", "Undefined" },
  { "Part", "Component" },
  { "Worst share", "Worst percentage" },
  // Rules:
  { "null", "undefined" },
};

/// The end of an error about an unknown name: "; it is now NumberOfLayers", or empty if the name
/// was never valid.
inline std::string DescribeFormerName(std::string_view name)
{
  for (const FormerName& entry : FormerNames)
  {
    if (entry.Former == name)
    {
      return "; it is now " + std::string(entry.Name);
    }
  }
  return {};
}
}

#endif
