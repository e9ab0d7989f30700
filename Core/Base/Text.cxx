// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Text.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace camaron
{
namespace
{
struct Range
{
  char32_t First, Last;
};

// Separators, and control characters that separate.
constexpr Range Blanks[] = { { 0x09, 0x0d }, { 0x1c, 0x20 }, { 0x85, 0x85 }, { 0xa0, 0xa0 },
  { 0x1680, 0x1680 }, { 0x2000, 0x200a }, { 0x2028, 0x2029 }, { 0x202f, 0x202f },
  { 0x205f, 0x205f }, { 0x3000, 0x3000 } };

// Besides blanks: categories Cc, Cf, Cs and Co of Unicode 15.
constexpr Range Unprintable[] = { { 0x00, 0x1f }, { 0x7f, 0xa0 }, { 0xad, 0xad }, { 0x600, 0x605 },
  { 0x61c, 0x61c }, { 0x6dd, 0x6dd }, { 0x70f, 0x70f }, { 0x890, 0x891 }, { 0x8e2, 0x8e2 },
  { 0x180e, 0x180e }, { 0x200b, 0x200f }, { 0x202a, 0x202e }, { 0x2060, 0x206f },
  { 0xd800, 0xf8ff }, { 0xfeff, 0xfeff }, { 0xfff9, 0xfffb }, { 0x110bd, 0x110bd },
  { 0x110cd, 0x110cd }, { 0x13430, 0x1343f }, { 0x1bca0, 0x1bca3 }, { 0x1d173, 0x1d17a },
  { 0xe0001, 0x10ffff } };

//------------------------------------------------------------------------------
template <std::size_t Size>
bool Contains(const Range (&ranges)[Size], char32_t character)
{
  return std::any_of(std::begin(ranges), std::end(ranges),
    [=](const Range& range) { return character >= range.First && character <= range.Last; });
}
}

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

//------------------------------------------------------------------------------
std::u32string ToCharacters(std::string_view text)
{
  constexpr char32_t replacement = 0xfffd;
  std::u32string characters;
  while (!text.empty())
  {
    const std::size_t size = GetCharacterSize(text);
    auto character = static_cast<char32_t>(static_cast<unsigned char>(text[0]));
    if (size > 1)
    {
      character &= 0x7fu >> size; // the bits after those that count the bytes
      for (std::size_t i = 1; i < size; ++i)
      {
        character = character << 6 | (static_cast<unsigned char>(text[i]) & 0x3fu);
      }
    }
    characters.push_back(size > 0 ? character : replacement);
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return characters;
}

//------------------------------------------------------------------------------
void AppendCharacter(std::string& text, char32_t character)
{
  const auto follow = [&](int shift)
  { text += static_cast<char>(0x80u | (character >> shift & 0x3fu)); };
  if (character < 0x80)
  {
    text += static_cast<char>(character);
  }
  else if (character < 0x800)
  {
    text += static_cast<char>(0xc0u | character >> 6);
    follow(0);
  }
  else if (character < 0x10000)
  {
    text += static_cast<char>(0xe0u | character >> 12);
    follow(6);
    follow(0);
  }
  else
  {
    text += static_cast<char>(0xf0u | character >> 18);
    follow(12);
    follow(6);
    follow(0);
  }
}

//------------------------------------------------------------------------------
std::string ToUtf8(std::u32string_view characters)
{
  std::string text;
  for (const char32_t character : characters)
  {
    AppendCharacter(text, character);
  }
  return text;
}

//------------------------------------------------------------------------------
bool IsBlank(char32_t character)
{
  return Contains(Blanks, character);
}

//------------------------------------------------------------------------------
bool IsPrintable(char32_t character)
{
  return character == ' ' || (!Contains(Blanks, character) && !Contains(Unprintable, character));
}

namespace
{
using Text = std::u32string_view;

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
  const std::u32string wanted = ToCharacters(ToLower(std::string(word)));
  std::tuple<double, std::u32string> best;
  std::string similar;
  for (const std::string& name : known)
  {
    const std::u32string lower = ToCharacters(ToLower(name));
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
