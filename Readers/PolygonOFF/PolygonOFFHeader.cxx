// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonOFFHeader.h"

#include "Intake/Rows/TextRows.h"

namespace camaron
{
namespace
{
constexpr char Expected[] = "an OFF file, which begins with [ST][C][N][4][n]OFF";
constexpr std::int64_t NumberBytes = 2; // of text: a digit and a blank
constexpr std::int64_t FaceBytes = 2;   // "0" and a line end

//------------------------------------------------------------------------------
bool Remove(std::string_view& word, std::string_view prefix)
{
  const bool found = word.substr(0, prefix.size()) == prefix;
  word.remove_prefix(found ? prefix.size() : 0);
  return found;
}

//------------------------------------------------------------------------------
// If the word begins with this prefix, removes it and sets a flag, which must not be set yet.
bool Take(std::string_view& word, std::string_view prefix, bool& flag)
{
  const bool found = !flag && Remove(word, prefix);
  flag = flag || found;
  return found;
}

//------------------------------------------------------------------------------
// Removes the keyword from the beginning of a word.
bool TakeKeyword(std::string_view& word, OFFHeader& header)
{
  while (!Remove(word, "OFF"))
  {
    const bool hadNormals = header.HasNormals;
    if (Take(word, "C", header.HasColors))
    {
      header.HasColorsFirst = hadNormals;
    }
    else if (!Take(word, "ST", header.HasTexture) && !Take(word, "N", header.HasNormals) &&
      !Take(word, "4", header.IsHomogeneous) && !Take(word, "n", header.HasDimension))
    {
      return false;
    }
  }
  header.HasKeyword = true;
  return true;
}

//------------------------------------------------------------------------------
bool IsInteger(std::string_view word)
{
  std::int64_t value;
  const char* const end = word.data() + word.size();
  return ParseInteger(word.data(), end, value) == end;
}

//------------------------------------------------------------------------------
// Whether the rest of a line has four counts: vertices, faces, edges and cells of a polytope, in
// files of Stella4D and Miratope.
bool HasFourCounts(TextScanner scanner)
{
  std::string_view word;
  for (int counts = 0; counts < 4; ++counts)
  {
    if (!scanner.SkipSpace() || !scanner.ReadWord(word, "") || !IsInteger(word))
    {
      return false;
    }
  }
  return !TextRow(scanner).HasMore();
}

//------------------------------------------------------------------------------
// Skips the braces at the beginning of Geomview files that describe the appearance.
bool SkipAppearance(TextScanner& scanner)
{
  TextScanner next = scanner;
  std::string_view word;
  if (!next.ReadWord(word, "") || !Remove(word, "appearance"))
  {
    return false;
  }
  int depth = 0;
  next.SetPosition(word.data());
  do
  {
    if (!next.SkipSpace())
    {
      return false;
    }
    const char c = *next.GetPosition();
    depth += c == '{' ? 1 : c == '}' ? -1 : 0;
    next.SetPosition(next.GetPosition() + 1);
    if (depth == 0 && c != '}')
    {
      return false; // no brace
    }
  } while (depth > 0);
  scanner.SetPosition(next.GetPosition());
  return true;
}

//------------------------------------------------------------------------------
// Whether the next line contains only the number of edges.
bool HasEdgesOnNextLine(TextScanner scanner)
{
  std::string_view word;
  return scanner.SkipSpace() && scanner.ReadWord(word, "") && IsInteger(word) &&
    !TextRow(scanner).HasMore();
}
}

//------------------------------------------------------------------------------
bool ReadOFFKeyword(TextScanner& scanner, bool mayLackKeyword, OFFHeader& header)
{
  if (!scanner.SkipSpace() || (SkipAppearance(scanner) && !scanner.SkipSpace()))
  {
    return scanner.FailAt(scanner.GetPosition(), ErrorKind::NotThisFormat, Expected);
  }
  const char* const begin = scanner.GetPosition();
  std::string_view word;
  scanner.ReadWord(word, Expected);
  if (mayLackKeyword && IsInteger(word))
  {
    scanner.SetPosition(begin);
    return true;
  }
  if (!TakeKeyword(word, header) || (!word.empty() && !IsDigit(word[0])))
  {
    return scanner.FailAt(begin, ErrorKind::NotThisFormat, Expected);
  }
  if (!word.empty())
  {
    scanner.SetPosition(word.data()); // the first count follows the keyword without a blank
    return true;
  }
  if (TextRow(scanner).HasMore())
  {
    TextScanner next = scanner;
    next.ReadWord(word, "");
    if (word == "BINARY")
    {
      header.IsBinary = true;
      next.SkipLine();
      scanner = next;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool ReadOFFCounts(TextScanner& scanner, OFFHeader& header)
{
  scanner.SkipSpace();
  const char* const begin = scanner.GetPosition();
  if (header.IsHomogeneous && !header.HasDimension && HasFourCounts(scanner))
  {
    return scanner.FailAt(begin, ErrorKind::Unsupported, "a surface",
      "a polytope of 4 dimensions in the dialect of Stella4D and Miratope, which is not supported");
  }
  if (header.HasDimension &&
    (!scanner.ReadInteger(
      header.Dimension, 1, INT32_MAX, ErrorKind::Count, "the number of dimensions")))
  {
    return false;
  }
  // Sizes that overflow are limited, as the file is too short for them anyway.
  const auto vertexBytes =
    static_cast<int>(std::min<std::int64_t>(NumberBytes * header.GetVertexSize(), INT32_MAX));
  if (!scanner.ReadCount(header.Vertices, vertexBytes, "the number of vertices") ||
    !scanner.ReadCount(header.Faces, FaceBytes, "the number of faces"))
  {
    return false;
  }
  // The number of edges may be wrong or missing. A vertex with one number looks like it.
  if (!TextRow(scanner).HasMore() && HasEdgesOnNextLine(scanner))
  {
    scanner.SkipSpace();
  }
  scanner.SkipLine();
  return true;
}
}
