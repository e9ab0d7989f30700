// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MergedWarnings.h"

#include <algorithm>
#include <set>

namespace camaron
{
//------------------------------------------------------------------------------
Warnings MergeWarnings(const std::vector<Warnings>& ofProcesses)
{
  std::vector<Warning> merged;
  std::set<std::string> said;
  for (const Warnings& warnings : ofProcesses)
  {
    std::size_t next = 0; // position of the warning after the last known one
    for (const Warning& warning : warnings.Get())
    {
      const auto known = std::find_if(merged.begin(), merged.end(),
        [&](const Warning& other)
        {
          return other.What == warning.What && other.One == warning.One &&
            other.Note == warning.Note;
        });
      // Equal sentences are about the whole file.
      const bool isNew = said.insert(warning.GetSentence()).second;
      if (known != merged.end())
      {
        known->Found.Merge(isNew ? warning.Found : Tally());
        next = static_cast<std::size_t>(known - merged.begin()) + 1;
      }
      else if (isNew)
      {
        merged.insert(merged.begin() + static_cast<std::ptrdiff_t>(next), warning);
        ++next;
      }
    }
  }
  Warnings all;
  for (Warning& warning : merged)
  {
    all.Add(std::move(warning));
  }
  return all;
}
}
