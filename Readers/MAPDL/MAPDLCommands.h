// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MAPDLCommands.h
 * @brief Command lines of Mechanical APDL: fields, abbreviations, parameters.
 */
#ifndef camaron_MAPDLCommands_h
#define camaron_MAPDLCommands_h

#include <cstdint>       // for integers of known size
#include <string>        // for names
#include <string_view>   // for fields
#include <unordered_map> // for parameters
#include <vector>        // for fields

namespace camaron
{
/// Text without leading and trailing blanks.
std::string_view TrimMAPDL(std::string_view text);
/// Text in upper case; the program ignores the case of names.
std::string ToUpperMAPDL(std::string_view text);

/// Whether a field that is no number looks like an expression of numbers, parameters and functions,
/// such as -A, (8/12) or 1%A%, rather than like a damaged number.
bool IsMAPDLExpression(std::string_view field);

/**
 * @class camaron::MAPDLCommand
 * @brief A command: its name and fields, still in the text.
 */
class MAPDLCommand
{
public:
  /**
   * Takes the next command of a line, which may contain several separated by $; false if there is
   * none. Comments after ! are ignored, and those that are commands (/COM, /TITLE, C***) end the
   * line.
   */
  bool Take(const char*& text, const char* end);

  /// Whether this is the command with a name in upper case, or its first letters, at least four.
  bool Is(std::string_view name) const;
  /// Field by number, the name being field 0; empty if it does not exist.
  std::string_view GetField(std::size_t i) const
  {
    return i < this->Fields.size() ? this->Fields[i] : std::string_view();
  }
  std::size_t GetNumberOfFields() const { return this->Fields.size(); }
  /// For name=value returns the name, and the value in @a value; else empty.
  std::string_view GetAssignment(std::string_view& value) const;

private:
  std::string_view Text;
  std::vector<std::string_view> Fields;
};

/**
 * @class camaron::MAPDLParameters
 * @brief Values of parameters that are numbers.
 */
class MAPDLParameters
{
public:
  /// Sets a parameter; if the text is neither a number nor a known parameter, its value becomes
  /// unknown.
  void Set(std::string_view name, std::string_view value);

  enum class Value
  {
    Absent, ///< a blank field
    Number,
    Unknown ///< a parameter without known value, an expression, a word
  };
  Value Read(std::string_view field, double& value) const;
  /// The same, rounded to an integer; values beyond 32 bits are unknown.
  Value Read(std::string_view field, std::int32_t& value) const;

private:
  std::unordered_map<std::string, double> Values;
};
}

#endif
