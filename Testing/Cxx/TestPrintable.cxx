// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What of a name reaches a terminal.
#include "Base/Text.h"

#include <gtest/gtest.h>

using camaron::MakePrintable;

//------------------------------------------------------------------------------
// If this fails, a terminal obeys names of files, or names in other alphabets are lost.
TEST(Printable, KeepsWhatIsShown)
{
  for (const char* text : { "", "part.visf:7: expected <x>", "Camar\xc3\xb3n", "\xe6\xbc\xa2",
         "\xf0\x9f\x98\x80", "\xc2\xa0\xed\x9f\xbf\xf4\x8f\xbf\xbf" })
  {
    EXPECT_EQ(MakePrintable(text), text);
  }
  EXPECT_EQ(MakePrintable("a\x1b[31mb\r\n\x7f"), "a?[31mb???");
  EXPECT_EQ(MakePrintable("a\xc2\x9b"
                          "31m"),
    "a?31m"); // of one character
}

//------------------------------------------------------------------------------
// If this fails, Python gets nothing of a message with such a name.
TEST(Printable, IsUTF8)
{
  EXPECT_EQ(MakePrintable("caf\xe9.visf"), "caf?.visf");
  EXPECT_EQ(MakePrintable("\x80\xbf\xfe\xff"), "????");
  EXPECT_EQ(MakePrintable("\xc0\xaf"), "??");           // more bytes than it needs
  EXPECT_EQ(MakePrintable("\xed\xa0\x80"), "???");      // a surrogate
  EXPECT_EQ(MakePrintable("\xf4\x90\x80\x80"), "????"); // beyond the last character
  EXPECT_EQ(MakePrintable("x\xe6\xbc"), "x??");         // cut off
}
