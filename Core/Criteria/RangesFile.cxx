// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/RangesFile.h"

#include "Base/Number.h"
#include "Base/Text.h"
#include "Scan/TextScanner.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Edit distance: number of letters to insert, delete or replace, ignoring case.
std::size_t GetDistance(std::string_view a, std::string_view b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t replaced = diagonal + (ToLower(a[i - 1]) == ToLower(b[j - 1]) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({ replaced, row[j] + 1, row[j - 1] + 1 });
    }
  }
  return row.back();
}

//------------------------------------------------------------------------------
// The first line of the text [begin, end), without its line end.
class Line
{
public:
  explicit Line(TextScanner& scanner)
    : Scanner(scanner)
    , End(FindLineEnd(scanner.GetPosition(), scanner.GetEnd()))
  {
  }

  /// The next word; on failure the error names @a what as expected.
  bool ReadWord(std::string_view& word, const char* what)
  {
    if (!this->Scanner.SkipSpace() || this->Scanner.GetPosition() >= this->End)
    {
      this->Scanner.FailAt(this->End, ErrorKind::Syntax, what, "end of line");
      return false;
    }
    return this->Scanner.ReadWord(word, what);
  }

  bool ReadLimit(double& limit, double open, const char* what)
  {
    std::string_view word;
    if (!this->ReadWord(word, what))
    {
      return false;
    }
    limit = open;
    if (word == "*" || word == "-")
    {
      return true;
    }
    const char* end = word.data() + word.size();
    if (ParseReal(word.data(), end, limit) != end || std::isnan(limit))
    {
      this->Scanner.FailAt(word.data(), ErrorKind::Syntax, what);
      return false;
    }
    return true;
  }

  bool ReadEnd()
  {
    if (this->Scanner.SkipSpace() && this->Scanner.GetPosition() < this->End)
    {
      this->Scanner.FailAt(this->Scanner.GetPosition(), ErrorKind::Syntax, "end of line");
    }
    return !this->Scanner.HasFailed();
  }

private:
  TextScanner& Scanner;
  const char* End;
};

//------------------------------------------------------------------------------
void ReadRule(TextScanner& scanner, const Criterion* (*find)(std::string_view),
  std::vector<Preset::Rule>& rules)
{
  Line line(scanner);
  std::string_view name;
  if (!line.ReadWord(name, "the name of a criterion"))
  {
    return;
  }
  const Criterion* criterion = find(name);
  if (!criterion)
  {
    const std::string similar = FindSimilarName(name);
    scanner.FailAt(name.data(), ErrorKind::Syntax, "the name of a criterion");
    scanner.AddToError(similar.empty() ? "" : "; did you mean " + similar + "?");
    return;
  }
  if (std::any_of(rules.begin(), rules.end(),
        [&](const Preset::Rule& rule) { return name == rule.Criterion; }))
  {
    scanner.FailAt(name.data(), ErrorKind::Syntax, "one range per criterion",
      "another range of " + std::string(name));
    return;
  }
  Preset::Rule rule = { criterion->Name, { -Infinity, Infinity } };
  if (line.ReadLimit(rule.Acceptable[0], -Infinity, "the lower limit: a number, or * for none") &&
    line.ReadLimit(rule.Acceptable[1], Infinity, "the upper limit: a number, or * for none") &&
    line.ReadEnd())
  {
    if (rule.Acceptable[0] > rule.Acceptable[1] || rule.Acceptable[0] == Infinity ||
      rule.Acceptable[1] == -Infinity)
    {
      scanner.FailAt(name.data(), ErrorKind::Syntax,
        "a lower limit that is not above the upper one",
        "a range of " + std::string(name) + " without values");
      return;
    }
    rules.push_back(rule);
  }
}
}

//------------------------------------------------------------------------------
std::string FindSimilarName(std::string_view name)
{
  constexpr std::size_t maxSize = 64; // maximum size of a word that may be a misspelled name
  std::string similar;
  std::size_t smallest = name.size() / 3 + 1; // words with a larger distance are not similar
  if (name.size() > maxSize)
  {
    return similar;
  }
  for (const Criterion& criterion : GetCriteria())
  {
    // A prefix of a name is as similar as one wrong letter.
    const std::string_view known = criterion.Name;
    const bool isBeginning = !name.empty() && GetDistance(name, known.substr(0, name.size())) == 0;
    const std::size_t distance = isBeginning ? 1 : GetDistance(name, known);
    if (distance <= smallest && (similar.empty() || distance < smallest))
    {
      similar = criterion.Name;
      smallest = distance;
    }
  }
  return similar;
}

//------------------------------------------------------------------------------
std::vector<Preset::Rule> ParseRanges(const std::string& file, const char* begin, const char* end,
  ScanError& error, const Criterion* (*find)(std::string_view))
{
  TextScanner scanner(file, begin, end, '#');
  std::vector<Preset::Rule> rules;
  while (!scanner.HasFailed() && scanner.SkipSpace())
  {
    ReadRule(scanner, find, rules);
  }
  error = scanner.GetError();
  return rules;
}
}
