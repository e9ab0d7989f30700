// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NumberText.h
 * @brief Numbers, counts, percentages, limits and durations as text: the same in plots, cards and
 * property panels.
 */
#ifndef camaron_NumberText_h
#define camaron_NumberText_h

#include <QDoubleValidator>
#include <QPair>
#include <QString>

#include <optional> // for texts that are no limit

namespace camaron
{
/// With at most @a digits significant digits; exponents are short, as in 1e-6. Empty for NaN, and a
/// symbol for infinity.
QString ShortNumber(double number, int digits = 6);

/// The shortest text that is this number exactly.
QString ExactNumber(double number);

/// With one digit and an exponent, such as 2e-6.
QString FormatScientific(double value);

/// The smallest number of digits, but at least @a least, with which a number keeps its value up to
/// @a tolerance.
int GetNumberOfDigits(double value, double tolerance, int least);

/// Two different numbers with as many digits as it takes to tell them apart.
QPair<QString, QString> FormatNumbers(double low, double high);

/// A multiple of 10^exponent, with the digits that distinguish it from the other multiples.
QString FormatMultiple(double value, int exponent);

/// Whether a lower limit means "above zero": it is positive, but below 1e-300.
bool IsPositive(double low);

/// A limit with its unit: 12.5°, 3 m; "> 0" if IsPositive().
QString FormatLimit(double value, const QString& unit, int digits = 6);

/// A limit as the server reads it: exact, and empty for none, which is an infinite one.
QString ExactLimit(double limit);

/// The symbol of a unit of the server's tables with a leading space if it needs one: "°", " m".
QString GetUnitSuffix(const QString& unit);

/// A name with the symbol of its unit in parentheses, such as "Angle (°)".
QString AddUnit(const QString& name, const QString& unit);

/// The number; from five digits on with a thin space between groups of three, as in the reports.
QString GroupedInteger(qint64 number);

/// For axes: 500, 20k, 1.5M, 3G, 2e15.
QString FormatShortCount(double count);

/// Such as "33.3 %", with a no-break space. 0 % and 100 % are exactly that, or 0 % of nothing;
/// other percentages are "< 0.01 %" or "> 99.9 %" at least. Labels with rich text need it escaped.
QString FormatPercent(double part, double whole);

/// For estimates: "40 s", "3 min", "2.5 h".
QString FormatDuration(double seconds);

/**
 * Reads limits of ranges that users type.
 *
 * A limit is a finite number, or nothing for no limit. In any language, a comma is taken for a
 * point; there are no separators of groups.
 */
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
