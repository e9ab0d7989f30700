// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::LimitValidator
 * @brief Reads limits of ranges that users type.
 *
 * A limit is a finite number, or nothing for no limit. In any language, a comma is taken for a
 * point; there are no separators of groups.
 */
#ifndef camaron_LimitValidator_h
#define camaron_LimitValidator_h

#include <QDoubleValidator>

#include <optional> // for texts that are no limit

namespace camaron
{
class LimitValidator : public QDoubleValidator
{
public:
  explicit LimitValidator(QObject* parent = nullptr);

  /// Replaces commas. Accepts the beginning of a limit, such as "" or "-": fields tell their owner
  /// of accepted texts only, and it has to Read() them.
  State validate(QString& text, int& place) const override;

  /// The limit; @a none for an empty text; nothing if the text is no limit.
  static std::optional<double> Read(const QString& text, double none);
};
}

#endif
