// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RuleCompletion.h"

#include <QRegularExpression>

#include <algorithm>

namespace camaron
{
namespace
{
using Choices = QVector<RuleCompletion::Choice>;

const QStringList Shapes = { "triangles", "quadrangles", "polygons", "tetrahedra", "pyramids",
  "wedges", "hexahedra", "polyhedra", "2D cells", "3D cells", "faces", "edges", "vertices" };
const QStringList Clauses = { "of", "in", "where", "tolerate", "undefined" };

//------------------------------------------------------------------------------
// A name as rules need it.
QString Quote(const QString& name)
{
  static const QRegularExpression plain("^\\w+$");
  return plain.match(name).hasMatch() ? name : '"' + name + '"';
}

//------------------------------------------------------------------------------
// Those words that begin with the text, unless it is one already.
Choices FindWords(const QStringList& words, const QString& text)
{
  Choices found;
  for (const QString& word : words)
  {
    if (word.startsWith(text, Qt::CaseInsensitive) && word != text)
    {
      found << RuleCompletion::Choice{ word, QString() };
    }
  }
  return found;
}

//------------------------------------------------------------------------------
Choices FindNames(const QStringList& names, const QString& text)
{
  QStringList quoted;
  for (const QString& name : names)
  {
    if (name.contains(text, Qt::CaseInsensitive) && name != text)
    {
      quoted << Quote(name);
    }
  }
  return FindWords(quoted, QString());
}

//------------------------------------------------------------------------------
Choices FindCriteria(const RuleWords& words, const QString& text)
{
  Choices first, later; // names that begin with the text stand before those that have its words
  const QStringList parts = text.split(' ', Qt::SkipEmptyParts);
  for (const auto& [name, label] : words.Criteria)
  {
    if (parts.isEmpty() || name == parts.join(' '))
    {
      return {};
    }
    const bool begins =
      name.startsWith(text, Qt::CaseInsensitive) || label.startsWith(text, Qt::CaseInsensitive);
    const bool hasAll =
      std::all_of(parts.begin(), parts.end(), [&, both = name + ' ' + label](const QString& part)
        { return both.contains(part, Qt::CaseInsensitive); });
    if (hasAll)
    {
      (begins ? first : later) << RuleCompletion::Choice{ name, label };
    }
  }
  return first + later + FindWords({ "preset" }, text);
}
}

//------------------------------------------------------------------------------
RuleCompletion CompleteRule(const QString& line, const RuleWords& words)
{
  // What precedes the word at the end, and the word, which may be in quotes.
  static const QRegularExpression start("^\\s*([\\w ]+)$"),
    shape("\\sof\\s+(?:[\\w ]+,\\s*)*([\\w ]*)$"), preset("^\\s*preset\\s+([\"']?[^\"']*)$"),
    array("\\swhere\\s+([\"']?[^\"'=]*)$"), undefined("\\sundefined\\s+(\\w*)$"),
    clause("[\\w.%*\"'-]\\s+(\\w+)$");
  const auto unquoted = [](QString text) { return text.remove('"').remove('\''); };
  RuleCompletion completion;
  const auto complete = [&](const QRegularExpression& context, auto find)
  {
    const QRegularExpressionMatch match = context.match(line);
    if (match.hasMatch())
    {
      completion.Start = static_cast<int>(match.capturedStart(1));
      completion.Choices = find(match.captured(1));
    }
    return !completion.Choices.isEmpty();
  };
  if (line.contains('#')) // a comment
  {
    return completion;
  }
  complete(preset, [&](const QString& text) { return FindNames(words.Presets, unquoted(text)); }) ||
    complete(start, [&](const QString& text) { return FindCriteria(words, text); }) ||
    complete(shape, [&](const QString& text) { return FindWords(Shapes, text); }) ||
    complete(
      array, [&](const QString& text) { return FindNames(words.GroupArrays, unquoted(text)); }) ||
    complete(
      undefined, [&](const QString& text) { return FindWords({ "fails", "passes" }, text); }) ||
    complete(clause, [&](const QString& text) { return FindWords(Clauses, text); });
  return completion;
}
}
