// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/IdRanges.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <stdexcept>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Parses one id at the beginning of the text and advances the text past it.
std::int64_t ParseId(const char* property, const char*& text, const char* end)
{
  std::int64_t id;
  const auto [next, error] = std::from_chars(text, end, id);
  if (error != std::errc())
  {
    throw std::invalid_argument(std::string(property) + ": expected a number, found '" +
      std::string(text, std::min<std::ptrdiff_t>(end - text, 20)) + "' (example: 3, 10-20, 40)");
  }
  text = next;
  return id;
}
}

//------------------------------------------------------------------------------
std::vector<IdRange> ParseIdRanges(const char* property, const std::string& list)
{
  constexpr const char* separators = ",; \t\r\n";
  std::vector<IdRange> ranges;
  const char* text = list.data();
  const char* end = text + list.size();
  const auto skip = [&](const char* characters)
  {
    while (text != end && std::strchr(characters, *text))
    {
      ++text;
    }
  };
  for (skip(separators); text != end; skip(separators))
  {
    IdRange range;
    range.First = range.Last = ParseId(property, text, end);
    const char* afterFirst = text;
    skip(" \t");
    if (text != end && *text == '-')
    {
      ++text;
      skip(" \t");
      range.Last = ParseId(property, text, end);
    }
    else
    {
      text = afterFirst;
    }
    if (range.Last < range.First)
    {
      throw std::invalid_argument(std::string(property) + ": " + std::to_string(range.First) + "-" +
        std::to_string(range.Last) + " is a descending range");
    }
    ranges.push_back(range);
  }
  std::sort(ranges.begin(), ranges.end(),
    [](const IdRange& a, const IdRange& b) { return a.First < b.First; });
  std::vector<IdRange> merged;
  for (const IdRange& range : ranges)
  {
    if (!merged.empty() && range.First <= merged.back().Last)
    {
      merged.back().Last = std::max(merged.back().Last, range.Last);
    }
    else
    {
      merged.push_back(range);
    }
  }
  return merged;
}

//------------------------------------------------------------------------------
bool Contains(const std::vector<IdRange>& ranges, std::int64_t id)
{
  const auto next = std::upper_bound(ranges.begin(), ranges.end(), id,
    [](std::int64_t value, const IdRange& range) { return value < range.First; });
  return next != ranges.begin() && id <= std::prev(next)->Last;
}
}
