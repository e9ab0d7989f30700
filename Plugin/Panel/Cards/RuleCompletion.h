// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RuleCompletion.h
 * @brief What may follow in a line of rules, in the language of Documentation/check.md.
 */
#ifndef camaron_RuleCompletion_h
#define camaron_RuleCompletion_h

#include <QPair>
#include <QString>
#include <QStringList>
#include <QVector>

namespace camaron
{
/// Words that depend on the server and the mesh.
struct RuleWords
{
  QVector<QPair<QString, QString>> Criteria; ///< name and label
  QStringList Presets, GroupArrays;
};

struct RuleCompletion
{
  struct Choice
  {
    QString Text;        ///< what the line gets
    QString Explanation; ///< such as the label of a criterion; may be empty
  };
  int Start = 0; ///< where the text begins that a choice replaces
  QVector<Choice> Choices;
};

/// What the end of a line may become, in the order of the documentation. Names of criteria are also
/// found by their labels.
RuleCompletion CompleteRule(const QString& line, const RuleWords& words);
}

#endif
