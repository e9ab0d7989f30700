// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Reading text line by line and number by number, serially and in parallel.
#include "Intake/Ids/IdSet.h"
#include "Intake/Rows/TextLines.h"
#include "Intake/Rows/TextRows.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

using namespace camaron;

namespace
{
TextScanner MakeScanner(const std::string& text)
{
  return TextScanner("file", text.data(), text.data() + text.size(), '#');
}
}

//------------------------------------------------------------------------------
// If this fails, padding after a text is read as text, or text as padding.
TEST(ScanText, EndsBeforePadding)
{
  using namespace std::string_literals;
  for (const std::string& padding : { ""s, "\x1a"s, "\0"s, "\x1a\x1a\x1a"s, std::string(5000, '\0'),
         "\x1a\r\n"s, "\0\n \0\x1a\t\0"s })
  {
    for (const std::string& text : { ""s, ")"s, "a\n"s, "a\0b\n\n"s,
           "\x1a"
           "1 \r\n"s })
    {
      const std::string whole = text + padding;
      const char* const end = FindTextEnd(whole.data(), whole.data() + whole.size());
      EXPECT_EQ(end - whole.data(), static_cast<std::ptrdiff_t>(text.size()))
        << text << '|' << padding;
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, the rest of a number is read as a number if the rest of the file was lost.
TEST(ScanText, ZerosBehindWordsAreDamage)
{
  using namespace std::string_literals;
  for (const std::string& text : { "1 8.0\0\0\0"s, "1.\0\0\n"s, "TRGL\0\0"s })
  {
    EXPECT_EQ(FindTextEnd(text.data(), text.data() + text.size()), text.data() + text.size());
  }
  for (const std::string& text : { "1 8.0\0"s, "1 8.0\x1a\0\0"s, "1 8.0\x1a\x1a"s, "1 8.0 \0\0"s })
  {
    EXPECT_EQ(FindTextEnd(text.data(), text.data() + text.size()),
      text.data() + text.find_first_of("\x1a\0"s));
  }
}

//------------------------------------------------------------------------------
// If this fails, a word ends within a number as printed by old Microsoft run-time libraries.
TEST(ScanText, CommentsBeginBehindNumbers)
{
  const std::string text = "1.#QNAN -1.#IND00#c\n1.#J a1.#INF\n1.5#INF\n2.# 3\nx#INF\n#IND\n7";
  const char* const words[] = { "1.#QNAN", "-1.#IND00", "1.#J", "a1.", "1.5", "2.", "x", "7" };
  TextScanner scanner = MakeScanner(text);
  TextScanner rows = MakeScanner(text);
  TextRow row(rows);
  std::string_view word;
  for (const char* expected : words)
  {
    EXPECT_TRUE(scanner.ReadWord(word, ""));
    EXPECT_EQ(word, expected);
    EXPECT_TRUE(row.ReadWord(word, ""));
    EXPECT_EQ(word, expected);
  }
  TextRow line(text.data(), text.data() + text.find('\n'), '#');
  EXPECT_TRUE(line.ReadWord(word, ""));
  EXPECT_EQ(word, words[0]);
  EXPECT_TRUE(line.ReadWord(word, ""));
  EXPECT_EQ(word, words[1]);
  EXPECT_FALSE(line.HasMore());
}

//------------------------------------------------------------------------------
// If this fails, messages contain the wrong line number for some type of line end.
TEST(ScanText, LineNumbers)
{
  for (const std::string end : { "\n", "\r\n", "\r" })
  {
    const std::string text = "1" + end + end + "# two" + end + "3 4" + end + "x";
    TextScanner scanner = MakeScanner(text);
    std::int64_t value = 0;
    EXPECT_TRUE(scanner.ReadInteger(value, "a number"));
    EXPECT_TRUE(scanner.ReadInteger(value, "a number"));
    EXPECT_EQ(value, 3);
    scanner.SkipLine();
    EXPECT_FALSE(scanner.ReadInteger(value, "a number"));
    EXPECT_EQ(value, 3);
    EXPECT_EQ(scanner.GetError().Message, "file:5: expected a number, found 'x'");
    EXPECT_FALSE(scanner.ReadInteger(value, "another")); // the first error is kept
    EXPECT_EQ(scanner.GetError().Message, "file:5: expected a number, found 'x'");
  }
}

//------------------------------------------------------------------------------
// If this fails, binary garbage or endless words appear in messages.
TEST(ScanText, Quotes)
{
  const std::string text = std::string("\x01\xff", 2) + std::string(100, 'y');
  TextScanner scanner = MakeScanner(text);
  std::int64_t value;
  EXPECT_FALSE(scanner.ReadInteger(value, "a number"));
  EXPECT_EQ(scanner.GetError().Message,
    "file:1: expected a number, found '??" + std::string(28, 'y') + "...'");
  const std::string empty = " # nothing";
  TextScanner atEnd = MakeScanner(empty);
  EXPECT_FALSE(atEnd.ReadInteger(value, "a number"));
  EXPECT_EQ(atEnd.GetError().Message, "file:1: expected a number, found the end of the file");
  EXPECT_EQ(atEnd.GetError().Kind, ErrorKind::Truncated);
}

//------------------------------------------------------------------------------
// If this fails, lines are lost or numbered incorrectly where text is split into chunks.
TEST(ScanText, LinesDoNotDependOnChunks)
{
  std::mt19937 random(4);
  for (int round = 0; round < 50; ++round)
  {
    std::string text;
    std::vector<std::string> lines;
    for (int i = 0; i < 200; ++i)
    {
      switch (random() % 6)
      {
        case 0:
          text += random() % 2 ? "\n" : " \t\r\n";
          break;
        case 1:
          text += "  # " + std::string(random() % 50, 'c') + "\n";
          break;
        default:
          lines.push_back(std::to_string(i) + std::string(random() % 30, 'x'));
          text += (random() % 3 ? "" : "  ") + lines.back() + (random() % 2 ? "\n" : "\r\n");
      }
    }
    if (round % 2)
    {
      text.pop_back(); // no last line end
    }
    TextScanner scanner = MakeScanner(text);
    for (const vtkIdType chunk : { 1, 7, 64, 1000, 100000 })
    {
      const TextLines index(scanner, Progress(), chunk);
      const char* place = text.data();
      for (std::size_t first = 0; first < lines.size();)
      {
        const auto count =
          static_cast<vtkIdType>(std::min<std::size_t>(random() % 40, lines.size() - first));
        const TextLines::Section section = index.Find(place, count);
        ASSERT_TRUE(section);
        std::vector<std::string> seen(static_cast<std::size_t>(count));
        EXPECT_TRUE(index.ForEach(section, Progress(),
          [&](vtkIdType piece, vtkIdType line, const char* begin, const char* end)
          {
            EXPECT_LT(piece, index.GetNumberOfPieces(section));
            EXPECT_LT(line, count);
            std::string content(begin, end);
            while (!content.empty() && content.back() == '\r')
            {
              content.pop_back();
            }
            seen[line] = content;
            return true;
          }));
        EXPECT_EQ(
          seen, std::vector<std::string>(lines.begin() + first, lines.begin() + first + count));
        place = section.End;
        first += static_cast<std::size_t>(count);
        if (count == 0 && random() % 3 == 0)
        {
          break;
        }
      }
      EXPECT_FALSE(index.Find(text.data(), static_cast<vtkIdType>(lines.size()) + 1));
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, lines are visited twice if some end with a lone CR, and so one more than
// requested.
TEST(ScanText, LinesBehindLoneCarriageReturns)
{
  const std::string text = "header\r1\n2\n3\n4\n5\n6\n";
  TextScanner scanner = MakeScanner(text);
  for (vtkIdType chunk = 1; chunk < 20; ++chunk)
  {
    const TextLines index(scanner, Progress(), chunk);
    EXPECT_FALSE(index.Find(text.data() + 7, 3));
    EXPECT_TRUE(index.Find(text.data(), 6));
    EXPECT_TRUE(index.Find(text.data() + 9, 5));
  }
}

//------------------------------------------------------------------------------
// If this fails, the lines after a count are read serially, in twice the time, or the rest of the
// line with the count is treated as one of them.
TEST(ScanText, LinesBehindANumber)
{
  for (const std::string head : { "x\n3\n", "x\n3 \t\r\n", "3\n", "x\n3 # lines\n\n" })
  {
    const std::string text = head + "1\n2\n4\n";
    TextScanner scanner = MakeScanner(text);
    for (vtkIdType chunk = 1; chunk < 20; ++chunk)
    {
      const TextLines index(scanner, Progress(), chunk);
      const TextLines::Section section = index.Find(text.data() + text.find('3') + 1, 3);
      ASSERT_TRUE(section) << head;
      std::string seen(3, ' ');
      EXPECT_TRUE(index.ForEach(section, Progress(),
        [&](vtkIdType, vtkIdType line, const char* begin, const char*)
        {
          seen[static_cast<std::size_t>(line)] = *begin;
          return true;
        }));
      EXPECT_EQ(seen, "124");
      EXPECT_FALSE(index.Find(text.data() + text.find('3') + 1, 4));
    }
  }
  const std::string text = "3 1\n2\n4\n5\n";
  EXPECT_FALSE(TextLines(MakeScanner(text), Progress(), 4).Find(text.data() + 1, 3));
}

//------------------------------------------------------------------------------
// If this fails, a single row in parallel reading is two rows, and an error, for a scanner.
TEST(ScanText, RowsEndAtLoneCarriageReturns)
{
  const std::string text = "1\r2";
  std::int64_t value = 0;
  TextRow row(text.data(), text.data() + text.size(), '#');
  EXPECT_TRUE(row.ReadInteger(value, "a number"));
  EXPECT_FALSE(row.HasMore());
  EXPECT_FALSE(row.ReadInteger(value, "a number"));
}

//------------------------------------------------------------------------------
// If this fails, parallel reading gives other numbers than serial reading.
TEST(ScanText, TablesDoNotDependOnChunks)
{
  std::string text;
  for (int i = 0; i < 1000; ++i)
  {
    text += std::to_string(i) + " " + std::to_string(i * 0.5) + (i % 7 ? " 1 # x\n" : "\r\n\n");
  }
  std::vector<double> expected(2000), values(2000);
  TextScanner whole = MakeScanner(text);
  const auto read = [](TextScanner& scanner, const TextLines* lines, std::vector<double>& to)
  {
    return RowSequence(scanner, lines, 1000)
      .ForEach(Progress(),
        [&](vtkIdType row, vtkIdType, TextRow& text)
        {
          return text.ReadReal(to[2 * row], "a number") &&
            text.ReadReal(to[2 * row + 1], "a number");
        });
  };
  ASSERT_TRUE(read(whole, nullptr, expected));
  EXPECT_EQ(expected[1999], 499.5);
  for (const vtkIdType chunk : { 10, 333, 5000 })
  {
    TextScanner scanner = MakeScanner(text);
    const TextLines lines(scanner, Progress(), chunk);
    values.assign(2000, -1);
    ASSERT_TRUE(read(scanner, &lines, values));
    EXPECT_EQ(values, expected);
    EXPECT_FALSE(scanner.SkipSpace());
  }
}

//------------------------------------------------------------------------------
// If this fails, ids of pieces are mixed up.
TEST(ScanText, IdSets)
{
  for (const vtkIdType limit : { 1, 63, 64, 65, 1000 })
  {
    IdSet set(limit);
    std::vector<std::int32_t> expected;
    std::vector<bool> in(static_cast<std::size_t>(limit));
    for (vtkIdType id = 0; id < limit; id += 1 + id % 5)
    {
      set.Add(id);
      set.Add(id);
      in[id] = true;
      expected.push_back(static_cast<std::int32_t>(id));
    }
    EXPECT_EQ(set.Number(), static_cast<vtkIdType>(expected.size()));
    EXPECT_EQ(set.GetMembers(), expected);
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      EXPECT_EQ(set.GetNumber(expected[i]), static_cast<vtkIdType>(i));
    }
    IdSet rest(limit);
    rest.AddMissing(set);
    EXPECT_EQ(rest.Number() + set.GetNumberOfMembers(), limit);
    for (vtkIdType id = 0; id < limit; ++id)
    {
      EXPECT_EQ(set.Contains(id), in[id]);
      EXPECT_EQ(rest.Contains(id), !in[id]);
    }
    rest.AddAll(set);
    EXPECT_EQ(rest.Number(), limit);
  }
}
