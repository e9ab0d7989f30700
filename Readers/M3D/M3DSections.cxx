// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "M3DSections.h"

#include "Base/Number.h"
#include "Base/Text.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Whether a text begins with a keyword, in any case, whatever follows.
bool BeginsWith(const char* text, const char* end, std::string_view keyword)
{
  const std::string_view rest(text, static_cast<std::size_t>(end - text));
  return EqualsInAnyCase(rest.substr(0, keyword.size()), keyword);
}
}

//------------------------------------------------------------------------------
void OtherSections::Add(const char* text, const char* end)
{
  constexpr int MaxName = 30;
  for (int i = 0; this->Count == 0 && i < MaxName && text < end && *text != '\r' && *text != '\n';
    ++i)
  {
    this->First += ToPrintable(*text++);
  }
  ++this->Count;
}

//------------------------------------------------------------------------------
bool FindSection(
  TextScanner& scanner, std::string_view keyword, vtkIdType size, OtherSections& others)
{
  const char* const limit = scanner.GetPosition() + std::min(size, scanner.GetBytesLeft());
  while (scanner.GetPosition() < limit && scanner.SkipSpace())
  {
    const char* const text = scanner.GetPosition();
    if (BeginsWith(text, scanner.GetEnd(), keyword))
    {
      const char* const lineEnd = FindLineEnd(text, scanner.GetEnd());
      const char* const bracket = std::find(text, lineEnd, ']');
      scanner.SetPosition(bracket + (bracket < lineEnd));
      return true;
    }
    if (*text == '[')
    {
      others.Add(text, scanner.GetEnd());
    }
    scanner.SkipLine();
  }
  return false;
}

//------------------------------------------------------------------------------
bool ReadHeading(TextScanner& scanner, M3DDialect& dialect, OtherSections& others)
{
  constexpr vtkIdType MaxBytesBefore = 65536; // of other sections and of remarks
  const char* const begin = scanner.GetPosition();
  dialect = M3DDialect::M3D;
  if (FindSection(scanner, "[nodes,", MaxBytesBefore, others))
  {
    return true;
  }
  scanner.SetPosition(begin);
  std::string_view word;
  if (scanner.SkipSpace() && scanner.ReadWord(word, "") && word.size() == 5 &&
    BeginsWith(word.data(), word.data() + word.size(), "mixed"))
  {
    dialect = M3DDialect::MVM;
    return true;
  }
  scanner.SetPosition(begin);
  scanner.SkipSpace();
  constexpr char Expected[] = "an M3D file, which begins with '[Nodes, ARRAY1<STRING>]'";
  return BeginsWith(begin, scanner.GetEnd(), "3dmo")
    ? scanner.FailAt(begin, ErrorKind::NotThisFormat, Expected, "a binary Model 3D file ('3DMO')")
    : scanner.FailAt(scanner.GetPosition(), ErrorKind::NotThisFormat, Expected);
}
}
