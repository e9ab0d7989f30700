// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RuleLine.h
 * @brief The words of a line of rules, and the errors about them.
 */
#ifndef camaron_RuleLine_h
#define camaron_RuleLine_h

#include <deque>       // for tokens
#include <stdexcept>   // for errors
#include <string>      // for words
#include <string_view> // for names
#include <vector>      // for names

namespace camaron
{
/// Internal to the parser of rules: the problem of a line.
struct RuleError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

class RuleLine
{
public:
  /// Splits a line. Throws RuleError if a quotation mark is not closed.
  explicit RuleLine(std::string_view text);

  enum class Kind
  {
    End,
    Word,
    Quoted,
    Sign ///< >=, <=, ==, >, < or =
  };

  ///@{
  /// Of the next word; the kind is End and the text empty after the last one.
  Kind GetKind() const;
  const std::string& GetText() const;
  bool Is(Kind kind, std::string_view text) const;
  ///@}

  /// The error for a next word other than @a expected, with the most similar of the @a known names.
  RuleError MakeError(
    const std::string& expected, const std::vector<std::string>& known = {}) const;

  ///@{
  /// Takes the next word: whatever it is; a name, which may be quoted; a number, which may be
  /// infinite; or this word, if it is the next. The second and third throw MakeError(expected).
  std::string Take();
  std::string TakeName(const std::string& expected);
  double TakeNumber(const std::string& expected);
  bool TakeIf(std::string_view word);
  ///@}

private:
  struct Token
  {
    RuleLine::Kind Kind;
    std::string Text;
  };
  std::deque<Token> Tokens;
};

/// The name as a word of a line: in quotation marks if it contains anything that ends a word.
std::string QuoteName(const std::string& name);

/// The message with long words truncated, and printable (Text.h).
std::string MakeReadable(const std::string& message);
}

#endif
