// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rules/ParsedRules.h"

#include "Base/Text.h"
#include "Rules/RuleLine.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <map>
#include <system_error>
#include <tuple>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// A rule of a preset, and the scope that the text gives it; none: the shapes that the preset
// covers.
struct RuleOfPreset
{
  camaron::Rule Rule;
  std::optional<Scope> Named;
};

//------------------------------------------------------------------------------
// Where a rule is, for messages. An option of the command has one rule, without a line.
std::string GetPlace(const std::string& source, int line)
{
  const bool hasLines = line > 0 && source.compare(0, 2, "--") != 0;
  return source + (hasLines ? ":" + std::to_string(line) : "");
}

//------------------------------------------------------------------------------
// Calls function(line, number) for each line of a text, whatever the line ends.
template <typename Function>
void ForEachLine(std::string_view text, Function&& function)
{
  const std::string_view mark = "\xef\xbb\xbf"; // byte order
  text.remove_prefix(text.substr(0, mark.size()) == mark ? mark.size() : 0);
  for (int number = 1; !text.empty(); ++number)
  {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    function(text.substr(0, end), number);
    text.remove_prefix(end);
    text.remove_prefix(text.substr(0, 2) == "\r\n" ? 2 : text.empty() ? 0 : 1);
  }
}

//------------------------------------------------------------------------------
class Collector
{
public:
  explicit Collector(const std::string& tolerance)
  {
    this->Try("Tolerate", 0,
      [&]
      {
        if (!tolerance.empty())
        {
          this->Default = ParseTolerance(tolerance);
        }
      });
  }

  void AddPreset(const std::string& name)
  {
    this->Try("Preset", 0,
      [&]
      {
        for (const Rule& rule : ParseRuleLine("preset " + QuoteName(name), this->Default))
        {
          this->AddRule(rule);
        }
      });
  }

  void AddText(const RulesText& text)
  {
    this->LastSource = text.Name;
    if (!IsUtf8(text.Text))
    {
      this->AddProblem(text.Name, 0, "expected text in UTF-8, found other bytes");
    }
    else if (text.Text.find('\0') != std::string::npos)
    {
      this->AddProblem(text.Name, 0, "expected text, found a zero byte");
    }
    else
    {
      ForEachLine(text.Text,
        [&](std::string_view line, int number) { this->AddLine(line, text.Name, number); });
    }
  }

  ParsedRules Finish()
  {
    ParsedRules parsed;
    for (const RuleOfPreset& of : this->OfPresets)
    {
      const bool isReplaced =
        std::any_of(this->Written.begin(), this->Written.end(), [&](const Rule& rule)
          { return rule.Criterion == of.Rule.Criterion && rule.Scope == of.Named; });
      if (!isReplaced)
      {
        parsed.Rules.push_back(of.Rule);
      }
    }
    std::copy_if(this->Written.begin(), this->Written.end(), std::back_inserter(parsed.Rules),
      [](const Rule& rule) { return rule.HasRange(); });
    if (parsed.Rules.empty() && this->Problems.empty())
    {
      this->AddProblem(
        this->LastSource, 0, "expected at least one criterion with a range, found none");
    }
    parsed.Problems = std::move(this->Problems);
    if (!parsed.Problems.empty())
    {
      parsed.Rules.clear();
    }
    return parsed;
  }

private:
  void AddProblem(const std::string& source, int line, const std::string& text)
  {
    this->Problems.push_back({ source, line, text });
  }

  template <typename Function>
  void Try(const std::string& source, int line, Function&& function)
  {
    try
    {
      function();
    }
    catch (const RuleError& error)
    {
      this->AddProblem(source, line, MakeReadable(error.what()));
    }
  }

  void AddLine(std::string_view line, const std::string& name, int number)
  {
    this->Try(name, number,
      [&]
      {
        for (Rule& rule : ParseRuleLine(line, this->Default))
        {
          rule.Line = number;
          rule.Source = name;
          this->AddRule(rule);
        }
      });
  }

  void AddRule(const Rule& rule)
  {
    const std::string scope = rule.GetScopeText();
    if (rule.Preset.empty())
    {
      const Key key = { rule.Criterion, scope, rule.GetLeast(), rule.GetMost() };
      const auto [found, isNew] = this->KeysOfWritten.emplace(key, this->Written.size());
      if (!isNew)
      {
        const Rule& other = this->Written[found->second];
        const std::string place = other.Source == rule.Source ? "line " + std::to_string(other.Line)
                                                              : GetPlace(other.Source, other.Line);
        throw RuleError(
          "expected a rule other than that of " + place + ", found " + rule.GetText() + " again");
      }
      this->Written.push_back(rule);
      return;
    }
    const Preset* const preset = FindPreset(rule.Preset);
    const auto range = std::find_if(preset->Rules.begin(), preset->Rules.end(),
      [&](const Preset::Rule& candidate) { return rule.Criterion == candidate.Criterion; });
    const bool isNamed = !(rule.Scope == ToScope(range->AcceptableFor));
    const Key key = { rule.Criterion, isNamed ? scope : "", 0, 0 };
    const auto [found, isNew] = this->KeysOfPresets.emplace(key, this->OfPresets.size());
    if (isNew)
    {
      this->OfPresets.emplace_back();
    }
    this->OfPresets[found->second] = { rule, isNamed ? rule.Scope : std::nullopt };
  }

  // Criterion, text of the scope, and range.
  using Key = std::tuple<std::string, std::string, double, double>;

  Tolerance Default;
  std::string LastSource = "rules";
  std::vector<Rule> Written;
  std::vector<RuleOfPreset> OfPresets;
  std::map<Key, std::size_t> KeysOfWritten, KeysOfPresets;
  std::vector<RuleProblem> Problems;
};
}

//------------------------------------------------------------------------------
std::string RuleProblem::GetMessage() const
{
  return GetPlace(this->Source, this->Line) + ": " + this->Text;
}

//------------------------------------------------------------------------------
std::string ParsedRules::GetMessage() const
{
  std::string message;
  for (const RuleProblem& problem : this->Problems)
  {
    message += (message.empty() ? "" : "\n") + problem.GetMessage();
  }
  return message;
}

//------------------------------------------------------------------------------
ParsedRules ParseRules(
  const std::vector<RulesText>& texts, const std::string& preset, const std::string& tolerance)
{
  Collector collector(tolerance);
  if (!preset.empty())
  {
    collector.AddPreset(preset);
  }
  for (const RulesText& text : texts)
  {
    collector.AddText(text);
  }
  return collector.Finish();
}

//------------------------------------------------------------------------------
std::vector<Preset::Rule> ParseRanges(
  const RulesText& text, const Criterion* (*find)(std::string_view))
{
  std::vector<Preset::Rule> ranges;
  ForEachLine(text.Text,
    [&](std::string_view line, int number)
    {
      try
      {
        ParseRangeLine(line, find, ranges);
      }
      catch (const RuleError& error)
      {
        const RuleProblem problem = { text.Name, number, MakeReadable(error.what()) };
        throw std::runtime_error(problem.GetMessage());
      }
    });
  return ranges;
}

//------------------------------------------------------------------------------
bool ReadRulesFile(const std::string& path, std::string& text, RuleProblem& problem)
{
  constexpr std::size_t maxSize = 1 << 20; // larger files are not what the user meant
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(path, failure);
  problem = { path, 0, "" };
  if (!failure && std::filesystem::is_directory(status))
  {
    failure = std::make_error_code(std::errc::is_a_directory);
  }
  else if (!failure && !std::filesystem::is_regular_file(status))
  {
    problem.Text = "expected a file of rules, found a pipe or a device";
  }
  if (!failure && problem.Text.empty())
  {
    std::ifstream file(path, std::ios::binary);
    text.resize(maxSize + 1);
    file.read(&text[0], static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (file.bad() || (text.empty() && !file.eof()))
    {
      failure = std::error_code(errno, std::generic_category());
    }
    else if (text.size() > maxSize)
    {
      problem.Text = "too large for a file of rules";
    }
  }
  problem.Text = failure ? failure.message() : problem.Text;
  return problem.Text.empty();
}
}
