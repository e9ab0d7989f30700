// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The language of rules: what a line means, and what is reported about a wrong one.
#include "Base/Number.h"
#include "Rules/ParsedRules.h"
#include "Rules/RuleLine.h"
#include "Sanitized.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sys/stat.h>

using namespace camaron;

namespace
{
constexpr double Most = std::numeric_limits<double>::max();
const std::string ClausesExpected = "expected of, in, where, tolerate, undefined or end of line";
const std::string ShapeNames =
  "triangles, quadrangles, polygons, tetrahedra, pyramids, wedges, "
  "hexahedra, polyhedra, 2D cells, 3D cells; or faces, edges or vertices";

//------------------------------------------------------------------------------
ParsedRules ParseText(const std::string& text, const std::string& tolerance = "")
{
  return ParseRules({ { "rules", text } }, "", tolerance);
}

//------------------------------------------------------------------------------
// The rules of a text without problems.
std::vector<Rule> Parse(const std::string& text, const std::string& tolerance = "")
{
  const ParsedRules parsed = ParseText(text, tolerance);
  EXPECT_TRUE(parsed.Problems.empty()) << text << '\n' << parsed.GetMessage();
  return parsed.Rules;
}

//------------------------------------------------------------------------------
Rule ParseOne(const std::string& text)
{
  const std::vector<Rule> rules = Parse(text);
  EXPECT_EQ(rules.size(), 1u) << text;
  return rules.empty() ? Rule() : rules[0];
}

//------------------------------------------------------------------------------
std::vector<std::string> GetTexts(const std::string& text)
{
  std::vector<std::string> texts;
  for (const Rule& rule : Parse(text))
  {
    texts.push_back(rule.GetText());
  }
  return texts;
}

//------------------------------------------------------------------------------
std::string GetScope(const std::string& text)
{
  return ParseOne(text).GetScopeText();
}

//------------------------------------------------------------------------------
class RulesFile : public ::testing::Test
{
protected:
  std::string Write(const std::string& bytes) const
  {
    const std::string path = this->Folder + "/my.rules";
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }

  // The problem of reading or parsing a file, without its name.
  static std::string GetProblem(const std::string& path)
  {
    RulesText text{ path, "" };
    RuleProblem problem;
    if (!ReadRulesFile(path, text.Text, problem))
    {
      EXPECT_EQ(problem.Source, path);
      return problem.Text;
    }
    const ParsedRules parsed = ParseRules({ text });
    return parsed.Problems.empty() ? "" : parsed.Problems[0].Text;
  }

  const TemporaryFolder Temporary;
  const std::string Folder = this->Temporary.Path.string();
};
}

//------------------------------------------------------------------------------
// Acceptable numbers are those between two numbers, both included; a printed rule has the same.
TEST(Rules, Ranges)
{
  const double above0 = std::nextafter(0.0, 1), above1 = std::nextafter(1.0, 2);
  const std::tuple<const char*, double, double> cases[] = { { "1 2", 1, 2 }, { "1 *", 1, Most },
    { "- 2", -Most, 2 }, { "-inf 2", -Most, 2 }, { "-1.5e-3 +1d3", -0.0015, 1000 },
    { ">= 10", 10, Most }, { ">=10", 10, Most }, { "> 0", above0, Most }, { "> 1", above1, Most },
    { "<= 1e3", -Most, 1000 }, { "< 5", -Most, std::nextafter(5.0, 0) }, { "= 3", 3, 3 },
    { "== 3", 3, 3 }, { "> 1 <= 2", above1, 2 }, { "< 2 >= 1", 1, std::nextafter(2.0, 0) },
    { "3 3", 3, 3 }, { "0.1234567890123 1e300", 0.1234567890123, 1e300 },
    { "\u00a0>=\u00a0\u00a010", 10, Most } };
  for (const auto& [words, least, most] : cases)
  {
    const Rule rule = ParseOne("Volume " + std::string(words));
    const Rule again = ParseOne(rule.GetLineText());
    for (const Rule& each : { rule, again })
    {
      EXPECT_EQ(each.GetLeast(), least) << words;
      EXPECT_EQ(each.GetMost(), most) << words;
    }
    EXPECT_EQ(again.GetText(), rule.GetText());
  }
}

//------------------------------------------------------------------------------
// Texts of tables, with few digits.
TEST(Rules, RangesInTables)
{
  const std::pair<const char*, const char*> cases[] = { { "0.2 1", "0.2 to 1" }, { "> 0", "> 0" },
    { "1e-305 *", "> 0" }, { "0.123456789 *", ">= 0.123457" }, { "1000000 *", ">= 1e+06" },
    { "999999 *", ">= 999999" }, { "- -2.5", "<= -2.5" }, { "= 0", "= 0" },
    { "> 1 < 2", "> 1 < 2" }, { ">= 1 < 2", ">= 1 < 2" } };
  for (const auto& [words, text] : cases)
  {
    EXPECT_EQ(ParseOne("Volume " + std::string(words)).GetRangeText(), text);
  }
  EXPECT_EQ(ParseOne("FaceCount <= 12 of polyhedra").GetText(), "FaceCount <= 12 of polyhedra");
}

//------------------------------------------------------------------------------
TEST(Rules, Scopes)
{
  const std::pair<const char*, const char*> cases[] = { { "", "" },
    { "of tetrahedra", "of tetrahedra" }, { "of Tetrahedron", "of tetrahedra" },
    { "of wedge", "of wedges" }, { "of type Tetra", "of type Tetra" },
    { "of tetrahedron, wedges", "of tetrahedra, wedges" }, { "of 2D cells", "of 2D cells" },
    { "of pyramids, 2d", "of pyramids, 2D cells" }, { "in rotor/blades", "in rotor/blades" },
    { "in \"my # block\"", "in \"my # block\"" }, { "in 'a \"b\"'", "in 'a \"b\"'" },
    { "in of", "in of" }, { "where Material = 3", "where Material = 3" },
    { "where 'my array'=-3", "where \"my array\" = -3" },
    { "where Material == 3.0", "where Material = 3" },
    { "where Material = 1e3", "where Material = 1000" },
    { "where Material = -0", "where Material = 0" },
    { "where Material = 9007199254740991", "where Material = 9007199254740991" },
    { "where Material = -9007199254740991", "where Material = -9007199254740991" } };
  for (const auto& [words, text] : cases)
  {
    const Rule rule = ParseOne("Volume > 0 " + std::string(words) + "  # a comment");
    EXPECT_EQ(rule.GetScopeText(), text);
    EXPECT_TRUE(ParseOne(rule.GetLineText()).Scope == rule.Scope) << words;
  }
  const auto getIds = [](const char* words)
  { return ParseOne("Volume > 0 of " + std::string(words)).Scope->GetFamilyIds(); };
  EXPECT_EQ(getIds("tetrahedra, wedges"), (std::vector<int>{ 10, 13 }));
  EXPECT_EQ(getIds("2D cells"), (std::vector<int>{ 5, 9, 7 }));
  EXPECT_EQ(getIds("pyramids, 2d"), (std::vector<int>{ 5, 9, 7, 14 }));
  EXPECT_EQ(getIds("3D cells"), (std::vector<int>{ 10, 14, 13, 12, 42 }));
}

//------------------------------------------------------------------------------
// Other elements have criteria of their own, some of the same name.
TEST(Rules, Elements)
{
  for (const char* text : { "NonOrthogonality <= 70 of faces", "EdgeLength > 0 of edges",
         "IsBoundary = 0 of vertices", "Warpage <= 0.1 of faces" })
  {
    const Rule rule = ParseOne(text);
    EXPECT_EQ(rule.GetText(), text);
    EXPECT_FALSE(rule.IsOfCells());
    EXPECT_EQ("of " + rule.GetElements(), rule.GetScopeText());
    ASSERT_TRUE(rule.FindCriterion());
    EXPECT_TRUE(ParseOne(rule.GetLineText()).Scope == rule.Scope);
  }
  EXPECT_EQ(ParseOne("EdgeLength > 0 of Edge").GetScopeText(), "of edges");
  EXPECT_EQ(ParseOne("VertexCellCount > 0 of vertex").GetElements(1), "vertex");
  EXPECT_EQ(ParseOne("Volume > 0").GetElements(), "cells");
  EXPECT_TRUE(ParseOne("Volume > 0 of wedges").IsOfCells());
}

//------------------------------------------------------------------------------
TEST(Rules, Clauses)
{
  const Rule rule = ParseOne("Volume 0 1 undefined passes tolerate 2% of wedges");
  EXPECT_EQ(rule.GetScopeText(), "of wedges");
  EXPECT_EQ(rule.Tolerance.GetText(), "2%");
  EXPECT_FALSE(rule.UndefinedFails);
  EXPECT_EQ(rule.GetLineText(), "Volume 0 1 of wedges tolerate 2% undefined passes");
  EXPECT_TRUE(ParseOne("Volume 0 1").UndefinedFails);
  EXPECT_TRUE(ParseOne("Volume 0 1 undefined fails").UndefinedFails);
}

//------------------------------------------------------------------------------
// The percentage passes, one more cell does not, without rounding.
TEST(Rules, TolerancesAreExact)
{
  const std::tuple<const char*, std::int64_t, std::int64_t, const char*> cases[] = {
    { "0.1%", 1000, 1, "0.1%" }, { "0.1%", 999, 0, "0.1%" },
    { "0.7%", 1000, 7, "0.7%" }, // 1000 * 0.007 is 7.000000000000001 in floating point
    { "33.3%", 1000, 333, "33.3%" }, { "29%", 100, 29, "29%" }, // 100 * 0.29 is 28.999999999999996
    { "0.0000000001%", 1000000000000, 1, "1e-10%" }, { "0.0000000001%", 999999999999, 0, "1e-10%" },
    { "100%", 3, 3, "100%" }, { "0%", 3, 0, "0%" }, { "2", 1, 2, "2" }, { "5 cells", 1, 5, "5" },
    { "1 cell", 1, 1, "1" }, { "0.1 %", 1000, 1, "0.1%" }, { "1e-3%", 100000, 1, "0.001%" },
    { "+1e0%", 100, 1, "1%" }, { "1e2%", 7, 7, "100%" }, { "12.4999%", 8, 0, "12.4999%" },
    { "12.5%", 8, 1, "12.5%" }, { "1e-999%", 1000000000000000000, 0, "0%" },
    { "100%", 1000000000000000000, 1000000000000000000, "100%" }, { "5e0", 1, 5, "5" },
    { "0", 9, 0, "0" }
  };
  for (const auto& [words, checked, allowed, text] : cases)
  {
    const Tolerance tolerance = ParseTolerance(words);
    EXPECT_EQ(tolerance.GetCells(checked), allowed) << words;
    EXPECT_EQ(tolerance.GetText(), text);
    EXPECT_EQ(ParseTolerance(tolerance.GetExactText()).GetCells(checked), allowed) << words;
    const Rule rule = ParseOne("Volume > 0 tolerate " + std::string(words));
    EXPECT_EQ(ParseOne(rule.GetLineText()).Tolerance.GetCells(checked), allowed) << words;
  }
}

//------------------------------------------------------------------------------
// Rules that are written out replace those of presets, of which the last one counts.
TEST(Rules, Presets)
{
  using Texts = std::vector<std::string>;
  for (const Rule& rule : Parse("preset overview"))
  {
    EXPECT_EQ(rule.Preset, "Overview");
    EXPECT_EQ(rule.Line, 1);
    EXPECT_TRUE(FindCriterion(rule.Criterion));
  }
  const Texts fem = GetTexts("preset 'FEM tetrahedra'");
  const Texts expected = { "Volume > 0 of 3D cells", "MinDihedralAngle >= 40 of tetrahedra",
    "MaxDihedralAngle <= 165 of tetrahedra", "TetRadiusEdgeRatio <= 2 of tetrahedra",
    "TetRadiusRatio >= 0.333333 of tetrahedra", "TetMeanRatio >= 0.3 of tetrahedra",
    "EdgeLengthRatio >= 0.333333 of tetrahedra" };
  EXPECT_EQ(fem, expected);
  const auto count = [](const std::string& text) { return Parse(text).size(); };
  // Of the same cells, whatever the order of the lines; an empty range removes the rule.
  Texts replaced(expected.begin() + 1, expected.end());
  EXPECT_EQ(GetTexts("Volume * *\npreset 'FEM tetrahedra'"), replaced);
  replaced.emplace_back("Volume >= 7");
  EXPECT_EQ(GetTexts("Volume >= 7\npreset \"FEM tetrahedra\""), replaced);
  EXPECT_EQ(GetTexts("preset \"fem tetrahedra\"\nVolume 7 *"), replaced);
  EXPECT_EQ(count("preset \"FEM tetrahedra\"\nVolume >= 7 of wedges"), 8u) << "other cells";
  EXPECT_EQ(count("preset \"FEM tetrahedra\"\npreset 'FEM tetrahedra' in rotor"), 14u);
  EXPECT_EQ(GetTexts("preset 'FEM tetrahedra' in rotor")[0], "Volume > 0 in rotor");
  // Among presets, the last one has priority.
  for (const Rule& rule : Parse("preset 'FEM tetrahedra'\npreset 'FEM hexahedra'"))
  {
    EXPECT_TRUE(rule.Criterion != "Volume" || rule.Preset == "FEM hexahedra");
  }
  for (const Rule& rule : Parse("preset Overview of wedges tolerate 3 undefined passes"))
  {
    EXPECT_EQ(rule.GetScopeText(), "of wedges");
    EXPECT_EQ(rule.Tolerance.GetText(), "3");
    EXPECT_FALSE(rule.UndefinedFails);
  }
  const auto isHint = [](const std::string& text)
  {
    bool found = false;
    for (const Rule& rule : Parse(text))
    {
      found = found || (rule.Criterion == "EquiangleSkewness" && rule.IsHint);
    }
    return found;
  };
  EXPECT_TRUE(isHint("preset Overview"));
  EXPECT_FALSE(isHint("preset Overview\nEquiangleSkewness <= 0.9")) << "the same range fails";
}

//------------------------------------------------------------------------------
// All presets can be written as lines, and mean the same but for hints.
TEST(Rules, PresetsAsLines)
{
  for (const Preset& preset : GetPresets())
  {
    std::string lines;
    const ParsedRules parsed = ParseRules({}, preset.Name);
    for (const Rule& rule : parsed.Rules)
    {
      EXPECT_EQ(rule.Line, 0);
      lines += rule.GetLineText() + "\n";
    }
    const std::vector<Rule> again = Parse(lines);
    ASSERT_EQ(again.size(), parsed.Rules.size()) << preset.Name;
    for (std::size_t i = 0; i < again.size(); ++i)
    {
      EXPECT_EQ(again[i].GetText(), parsed.Rules[i].GetText());
      EXPECT_EQ(again[i].GetMost(), parsed.Rules[i].GetMost());
    }
  }
}

//------------------------------------------------------------------------------
// Several rules of one criterion are all kept.
TEST(Rules, Steps)
{
  EXPECT_EQ(GetTexts("Volume > 1 tolerate 1%\nVolume > 0"),
    (std::vector<std::string>{ "Volume > 1", "Volume > 0" }));
}

//------------------------------------------------------------------------------
// The default tolerance is for rules without their own.
TEST(Rules, DefaultTolerance)
{
  for (const Rule& rule : Parse("Volume > 0\nFaceCount < 9 tolerate 0\npreset Overview\npreset "
                                "Overview of wedges tolerate 1%",
         "7"))
  {
    const bool isNamed = rule.GetScopeText() == "of wedges";
    EXPECT_EQ(rule.Tolerance.GetText(), isNamed ? "1%" : rule.Criterion == "FaceCount" ? "0" : "7");
  }
  const std::pair<const char*, const char*> cases[] = {
    { "0.5",
      "Tolerate: expected a percentage such as 0.1%, or a number of cells, found '0.5'; did you "
      "mean 0.5%?" },
    { "5 b", "Tolerate: expected end of text, found 'b'" },
    { "#", "Tolerate: expected a percentage such as 0.1%, or a number of cells, found end of line" }
  };
  for (const auto& [text, message] : cases)
  {
    EXPECT_EQ(ParseText("Volume > 0", text).GetMessage(), message);
  }
}

//------------------------------------------------------------------------------
// Line ends of every system, a byte order mark, comments, blank lines.
TEST_F(RulesFile, Read)
{
  const std::string path = this->Write("\xef\xbb\xbf# mine\r\n\r\nVolume > 0 # all\rFaceCount 4 "
                                       "20\n\t\nEdgeLengthRatio>=.1");
  RulesText text{ path, "" };
  RuleProblem problem;
  ASSERT_TRUE(ReadRulesFile(path, text.Text, problem)) << problem.GetMessage();
  const ParsedRules parsed = ParseRules({ text });
  ASSERT_EQ(parsed.Rules.size(), 3u) << parsed.GetMessage();
  const std::pair<const char*, int> expected[] = { { "Volume", 3 }, { "FaceCount", 4 },
    { "EdgeLengthRatio", 6 } };
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_EQ(parsed.Rules[i].Criterion, expected[i].first);
    EXPECT_EQ(parsed.Rules[i].Line, expected[i].second);
    EXPECT_EQ(parsed.Rules[i].Source, path);
  }
}

//------------------------------------------------------------------------------
TEST_F(RulesFile, Refused)
{
  using namespace std::string_literals;
  EXPECT_EQ(this->GetProblem(this->Write("Volume > 0 # \xff\xfe\n")),
    "expected text in UTF-8, found other bytes");
  EXPECT_EQ(this->GetProblem(this->Write("Volume > 0\0\n"s)), "expected text, found a zero byte");
  constexpr std::size_t maxSize = 1 << 20;
  EXPECT_EQ(
    this->GetProblem(this->Write(std::string(maxSize + 1, '#'))), "too large for a file of rules");
  EXPECT_EQ(this->GetProblem(this->Write(std::string(maxSize, '#'))),
    "expected at least one criterion with a range, found none");
  EXPECT_EQ(
    this->GetProblem(this->Write("")), "expected at least one criterion with a range, found none");
  const std::string pipe = this->Folder + "/pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& special : { pipe, std::string("/dev/zero") })
  {
    EXPECT_EQ(this->GetProblem(special), "expected a file of rules, found a pipe or a device");
  }
  EXPECT_EQ(this->GetProblem(this->Folder), "Is a directory");
  EXPECT_EQ(this->GetProblem(this->Folder + "/none.rules"), "No such file or directory");
}

//------------------------------------------------------------------------------
// Each problem states what was expected, what was found, and what may have been meant.
TEST(Rules, WrongLines)
{
  using namespace std::string_literals;
  const std::string toleranceExpected =
    "expected a percentage such as 0.1%, or a number of cells, found ";
  const std::pair<std::string, std::string> cases[] = {
    { "MinDihedralAngel >= 10",
      "expected the name of a criterion, found 'MinDihedralAngel'; did you mean "
      "MinDihedralAngle?" },
    { "volume >= 10", "expected the name of a criterion, found 'volume'; did you mean Volume?" },
    { "qqq >= 10", "expected the name of a criterion, found 'qqq'" },
    { ">= 10", "expected the name of a criterion, found '>='" },
    { "q\x01q >= 10", "expected the name of a criterion, found 'q?q'" },
    { "\u00e9\u4e2d >= 10", "expected the name of a criterion, found '\u00e9\u4e2d'" },
    { std::string(1000, 'q') + " >= 10",
      "expected the name of a criterion, found '" + std::string(59, 'q') + "..." },
    { "Volume", "expected a range: >= 10, or a lower and an upper limit, found end of line" },
    { "Volume of wedges", "expected the lower limit: a number, or * for none, found 'of'" },
    { "Volume 1", "expected the upper limit: a number, or * for none, found end of line" },
    { "Volume 1 x", "expected the upper limit: a number, or * for none, found 'x'" },
    { "Volume nan *", "expected the lower limit: a number, or * for none, found 'nan'" },
    { "Volume 1.#INF *", "expected the upper limit: a number, or * for none, found end of line" },
    { "Volume '1' *", "expected the lower limit: a number, or * for none, found '1'" },
    { "Volume 1 2 3", ClausesExpected + ", found '3'" },
    { "Volume 2 1",
      "expected a lower limit that is not above the upper limit, found Volume 2 to 1" },
    { "Volume > 1 < 1",
      "expected a lower limit that is not above the upper limit, found Volume > 1 < 1" },
    { "Volume inf *", "expected a range with values, found none of Volume" },
    { "Volume * -inf", "expected a range with values, found none of Volume" },
    { "Volume > x", "expected a number, found 'x'" },
    { "Volume >", "expected a number, found end of line" },
    { "Volume < inf", "expected a finite number after <, found inf" },
    { "Volume >= -1e400", "expected a finite number after >=, found -inf" },
    { "Volume > 1 >= 2", "expected one lower and one upper limit, found another: '>='" },
    { "Volume = 1 < 2", "expected one lower and one upper limit, found another: '<'" },
    { "NonOrthogonality <= 70",
      "expected a criterion of cells, found 'NonOrthogonality', one of faces and edges; did you "
      "mean of faces?" },
    { "Volume > 0 of faces", "expected a criterion of faces, found 'Volume', one of cells" },
    { "EdgeLength > 0 of faces",
      "expected a criterion of faces, found 'EdgeLength', one of edges" },
    { "preset General of faces", "expected a criterion of faces, found 'Area', one of cells" },
    { "Volume > 0 of", "expected type, or a shape: " + ShapeNames + ", found end of line" },
    { "Volume > 0 of wedges,", "expected type, or a shape: " + ShapeNames + ", found end of line" },
    { "Volume > 0 of tetraeder",
      "expected type, or a shape: " + ShapeNames +
        ", found 'tetraeder'; did you mean tetrahedra?" },
    { "Volume > 0 of type Tetrah",
      "expected VTK's name of a cell type, such as Tetra, found 'Tetrah'; did you mean Tetra?" },
    { "Volume > 0 in", "expected the name of a block, found end of line" },
    { "Volume > 0 where", "expected the name of a cell array, found end of line" },
    { "Volume > 0 where Material 3", "expected = after Material, found '3'" },
    { "Volume > 0 where Material > 3", "expected = after Material, found '>'" },
    { "Volume > 0 where Material = steel", "expected an integer, found 'steel'" },
    { "Volume > 0 where Material = 3.5", "expected an integer below 2^53, found '3.5'" },
    { "Volume > 0 where Material = 2e19", "expected an integer below 2^53, found '2e19'" },
    { "Volume > 0 where Material = 9007199254740993",
      "expected an integer below 2^53, found '9007199254740993'" },
    { "Volume > 0 where Material = -9007199254740992",
      "expected an integer below 2^53, found '-9007199254740992'" },
    { "Volume > 0 where Material = 1e999999999999",
      "expected an integer below 2^53, found '1e999999999999'" },
    { "Volume > 0 where Material = inf", "expected an integer below 2^53, found 'inf'" },
    { "Volume > 0 tolerate", toleranceExpected + "end of line" },
    { "Volume > 0 tolerate few", toleranceExpected + "'few'" },
    { "Volume > 0 tolerate -1", toleranceExpected + "'-1'" },
    { "Volume > 0 tolerate %", toleranceExpected + "'%'" },
    { "Volume > 0 tolerate 1d1%", toleranceExpected + "'1d1%'" },
    { "Volume > 0 tolerate 5%%", toleranceExpected + "'5%%'" },
    { "Volume > 0 tolerate 0.1", toleranceExpected + "'0.1'; did you mean 0.1%?" },
    { "Volume > 0 tolerate 101%", "expected a percentage of at most 100%, found '101%'" },
    { "Volume > 0 undefined", "expected fails or passes after undefined, found end of line" },
    { "Volume > 0 undefined pass",
      "expected fails or passes after undefined, found 'pass'; did you mean passes?" },
    { "Volume > 0 tolerat 1%", ClausesExpected + ", found 'tolerat'; did you mean tolerate?" },
    { "Volume > 0 'of' wedges", ClausesExpected + ", found 'of'; did you mean of?" },
    { "Volume > 0 of wedges in x",
      "expected one of the words of, in and where, found another: 'in'" },
    { "Volume > 0 tolerate 1 tolerate 1", "expected one tolerate, found another: 'tolerate'" },
    { "Volume > 0 undefined fails undefined fails",
      "expected one undefined, found another: 'undefined'" },
    { "Volume > 0 in \"my block", "expected a closing \", found end of line" },
    { "Volume > 0 in 'my block", "expected a closing ', found end of line" },
    { "preset", "expected the name of a preset, found end of line" },
    { "preset Finite volume",
      "expected the name of a preset, found 'Finite'; did you mean Finite volume?" },
    { "preset Overview 1 2", ClausesExpected + ", found '1'" },
  };
  for (const auto& [line, message] : cases)
  {
    const ParsedRules parsed = ParseText("# first\n" + line);
    EXPECT_EQ(parsed.GetMessage(), "rules:2: " + message);
    EXPECT_TRUE(parsed.Rules.empty());
  }
}

//------------------------------------------------------------------------------
// All problems at once, each with its line.
TEST(Rules, AllProblems)
{
  const ParsedRules parsed = ParseRules(
    { { "a.rules",
        "Volume > x\nVolume > 0\n\nFaceCont > 1\nVolume 0 *\nVolume > 0 of wedges\nVolume > 0" },
      { "rules", "FaceCount < 5\nVolume > 0\n" } },
    "VEN", "1.5");
  std::vector<std::string> messages;
  for (const RuleProblem& problem : parsed.Problems)
  {
    messages.push_back(problem.GetMessage());
  }
  const std::vector<std::string> expected = {
    "Tolerate: expected a percentage such as 0.1%, or a number of cells, found '1.5'; did you "
    "mean 1.5%?",
    "Preset: expected the name of a preset, found 'VEN'; did you mean VEM?",
    "a.rules:1: expected a number, found 'x'",
    "a.rules:4: expected the name of a criterion, found 'FaceCont'; did you mean FaceCount?",
    "a.rules:7: expected a rule other than that of line 2, found Volume > 0 again",
    "rules:2: expected a rule other than that of a.rules:2, found Volume > 0 again"
  };
  EXPECT_EQ(messages, expected);
  for (const char* text : { "", "# nothing", "Volume * *" })
  {
    EXPECT_EQ(ParseText(text).GetMessage(),
      "rules: expected at least one criterion with a range, found none");
  }
}

//------------------------------------------------------------------------------
// Any text is rules or problems, and the text of a rule is a rule with that text.
TEST(Rules, AnyText)
{
  const std::vector<std::string> words = { "Volume", ">", ">=", "=", "1", "*", "-", "inf", "of",
    "in", "where", "undefined", "%", "'", "\"", "#", "type", "tolerate", "preset", "VEM", "wedges,",
    "0.1%", "\xc3\xa9", "\xff", "passes", "Material" };
  std::mt19937 random(3);
  const auto choose = [&](std::size_t size) { return random() % size; };
  int numberOfRules = 0, numberOfProblems = 0;
  for (int i = 0; i < Often(20000); ++i)
  {
    std::string line = choose(2) ? "Volume > 0" : "";
    const char* const blank = choose(2) ? " " : "";
    for (std::size_t count = 1 + choose(7); count > 0; --count)
    {
      line += blank + words[choose(words.size())];
    }
    const ParsedRules parsed = ParseText(line + "\nFaceCount > 0");
    for (const Rule& rule : parsed.Rules)
    {
      const ParsedRules again = ParseText(rule.GetLineText());
      ASSERT_EQ(again.Rules.size(), 1u) << line << '\n' << rule.GetLineText();
      EXPECT_EQ(again.Rules[0].GetLineText(), rule.GetLineText());
      ++numberOfRules;
    }
    for (const RuleProblem& problem : parsed.Problems)
    {
      EXPECT_EQ(problem.Text.compare(0, 9, "expected "), 0) << line;
      EXPECT_NE(problem.Text.find(" found "), std::string::npos) << line;
      ++numberOfProblems;
    }
  }
  EXPECT_GT(numberOfRules, Often(1000));
  EXPECT_GT(numberOfProblems, Often(1000));
}
