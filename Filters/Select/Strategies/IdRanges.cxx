// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/IdRanges.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Parses one id at the beginning of the text and advances the text past it.
ExactValue ParseId(const char* property, const char*& text, const char* end)
{
  const char* next = text != end && *text == '-' ? text + 1 : text;
  next = std::find_if(next, end, [](char c) { return c < '0' || c > '9'; });
  ExactValue id;
  if (!ParseInteger(std::string(text, next), id))
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
      throw std::invalid_argument(std::string(property) + ": " + ToText(range.First) + "-" +
        ToText(range.Last) + " is a descending range");
    }
    ranges.push_back(range);
  }
  std::sort(ranges.begin(), ranges.end(),
    [](const IdRange& a, const IdRange& b) { return a.First < b.First; });
  std::vector<IdRange> merged;
  for (const IdRange& range : ranges)
  {
    if (!merged.empty() && !(merged.back().Last < range.First))
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
bool Contains(const std::vector<IdRange>& ranges, const ExactValue& id)
{
  const auto next = std::upper_bound(ranges.begin(), ranges.end(), id,
    [](const ExactValue& value, const IdRange& range) { return value < range.First; });
  return next != ranges.begin() && !(std::prev(next)->Last < id);
}
}
