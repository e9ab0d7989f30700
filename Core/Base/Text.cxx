// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Text.h"

#include <algorithm>
#include <tuple>

namespace camaron
{
//------------------------------------------------------------------------------
bool IsUtf8(std::string_view text)
{
  while (!text.empty())
  {
    const std::size_t size = GetCharacterSize(text);
    if (size == 0)
    {
      return false;
    }
    text.remove_prefix(size);
  }
  return true;
}

namespace
{
using Text = std::string_view;

//------------------------------------------------------------------------------
// The longest common substring, as start in a, start in b and size; the first one in a, then in b.
std::tuple<std::size_t, std::size_t, std::size_t> FindLongest(Text a, Text b)
{
  std::size_t startInA = 0, startInB = 0, longest = 0;
  std::vector<std::size_t> sizes(b.size() + 1); // of common substrings that end before j
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    for (std::size_t j = b.size(); j > 0; --j)
    {
      sizes[j] = a[i - 1] == b[j - 1] ? sizes[j - 1] + 1 : 0;
      if (sizes[j] > longest ||
        (sizes[j] == longest && longest > 0 && i - longest == startInA && j - longest < startInB))
      {
        longest = sizes[j];
        startInA = i - longest;
        startInB = j - longest;
      }
    }
  }
  return { startInA, startInB, longest };
}

//------------------------------------------------------------------------------
std::size_t CountCommon(Text a, Text b)
{
  const auto [i, j, size] = FindLongest(a, b);
  return size == 0 ? 0
                   : size + CountCommon(a.substr(0, i), b.substr(0, j)) +
      CountCommon(a.substr(i + size), b.substr(j + size));
}
}

//------------------------------------------------------------------------------
std::string FindSimilarName(std::string_view word, const std::vector<std::string>& known)
{
  constexpr double least = 0.6;
  const std::string wanted = ToLower(std::string(word));
  std::tuple<double, std::string> best;
  std::string similar;
  for (const std::string& name : known)
  {
    const std::string lower = ToLower(name);
    const auto whole = static_cast<double>(lower.size() + wanted.size());
    if (2.0 * static_cast<double>(std::min(lower.size(), wanted.size())) / whole < least)
    {
      continue; // also NaN if both are empty
    }
    const double ratio = 2.0 * static_cast<double>(CountCommon(lower, wanted)) / whole;
    if (ratio >= least && std::tie(ratio, lower) >= best)
    {
      best = { ratio, lower };
      similar = name;
    }
  }
  return similar;
}
}
