// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Printable.h
 * @brief Messages for terminals, which obey control characters.
 */
#ifndef camaron_Printable_h
#define camaron_Printable_h

#include <string>      // for messages
#include <string_view> // for characters

namespace camaron
{
/// Bytes of the character of UTF-8 that begins a text, 0 if there is none.
inline std::size_t GetCharacterSize(std::string_view text)
{
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t size = lead < 0x80 ? 1 : lead < 0xc2 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf5 ? 4 : 0;
  if (size > text.size())
  {
    return 0;
  }
  for (std::size_t i = 1; i < size; ++i)
  {
    const auto byte = static_cast<unsigned char>(text[i]);
    // Numbers of more bytes than they need, of surrogates and beyond the last character are none.
    const bool isSecond = i == 1;
    const unsigned char least = isSecond && lead == 0xe0 ? 0xa0 : isSecond && lead == 0xf0 ? 0x90 : 0x80;
    const unsigned char most = isSecond && lead == 0xed ? 0x9f : isSecond && lead == 0xf4 ? 0x8f : 0xbf;
    if (byte < least || byte > most)
    {
      return 0;
    }
  }
  return size;
}

/// The message as UTF-8 with '?' for control characters and for bytes that are none; names of files may have any.
inline std::string MakePrintable(std::string_view message)
{
  std::string printable;
  while (!message.empty())
  {
    const std::size_t size = GetCharacterSize(message);
    const auto first = static_cast<unsigned char>(message[0]);
    const bool isControl = size < 2 ? first < 0x20 || first >= 0x7f
                                    : first == 0xc2 && static_cast<unsigned char>(message[1]) < 0xa0;
    printable += isControl ? "?" : message.substr(0, size);
    message.remove_prefix(size > 0 ? size : 1);
  }
  return printable;
}
}

#endif
