// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Text.h
 * @brief Text for messages and keywords: counts, lower case, UTF-8, similar names.
 */
#ifndef camaron_Text_h
#define camaron_Text_h

#include "vtkType.h" // for vtkIdType

#include <exception>   // for reasons
#include <new>         // for std::bad_alloc
#include <string>      // for messages
#include <string_view> // for characters
#include <vector>      // for names

namespace camaron
{
/// Whether every byte is part of a valid character.
bool IsUtf8(std::string_view text);

/// "1 node" or "12 nodes".
inline std::string CountOf(vtkIdType count, std::string_view one, std::string_view many)
{
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

inline char ToLower(char c)
{
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline std::string ToLower(std::string text)
{
  for (char& c : text)
  {
    c = ToLower(c);
  }
  return text;
}

/// Case-insensitive comparison; @a lower must be lower case.
inline bool EqualsInAnyCase(std::string_view text, std::string_view lower)
{
  return text.size() == lower.size() && ToLower(std::string(text)) == lower;
}

/// Number of bytes of the UTF-8 character at the beginning of a text; 0 if it is invalid.
inline std::size_t GetCharacterSize(std::string_view text)
{
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t size = lead < 0x80 ? 1
    : lead < 0xc2                      ? 0
    : lead < 0xe0                      ? 2
    : lead < 0xf0                      ? 3
    : lead < 0xf5                      ? 4
                                       : 0;
  if (size > text.size())
  {
    return 0;
  }
  for (std::size_t i = 1; i < size; ++i)
  {
    const auto byte = static_cast<unsigned char>(text[i]);
    // Overlong encodings, surrogates and codes beyond the last character are invalid.
    const bool isSecond = i == 1;
    const unsigned char least = isSecond && lead == 0xe0 ? 0xa0
      : isSecond && lead == 0xf0                         ? 0x90
                                                         : 0x80;
    const unsigned char most = isSecond && lead == 0xed ? 0x9f
      : isSecond && lead == 0xf4                        ? 0x8f
                                                        : 0xbf;
    if (byte < least || byte > most)
    {
      return 0;
    }
  }
  return size;
}

/// The message of an exception.
inline std::string GetReason(const std::exception& error)
{
  return dynamic_cast<const std::bad_alloc*>(&error) ? "there is not enough memory" : error.what();
}

/// The message as UTF-8 with '?' for control characters and invalid bytes, which file names may
/// contain.
inline std::string MakePrintable(std::string_view message)
{
  std::string printable;
  while (!message.empty())
  {
    const std::size_t size = GetCharacterSize(message);
    const auto first = static_cast<unsigned char>(message[0]);
    const bool isControl = size < 2
      ? first < 0x20 || first >= 0x7f
      : first == 0xc2 && static_cast<unsigned char>(message[1]) < 0xa0;
    printable += isControl ? "?" : message.substr(0, size);
    message.remove_prefix(size > 0 ? size : 1);
  }
  return printable;
}

/**
 * The most similar of the known names, whatever the case of ASCII letters; empty if none is
 * similar.
 *
 * Similarity is that of Ratcliff and Obershelp, Pattern Matching: The Gestalt Approach, Dr. Dobb's
 * Journal, 1988: twice the number of common characters over the number of all characters, where the
 * longest common substring is common, and so are the common characters left and right of it. At
 * least 0.6 is similar. Python's difflib.get_close_matches has the same results for words of fewer
 * than 200 characters.
 */
std::string FindSimilarName(std::string_view word, const std::vector<std::string>& known);
}

#endif
