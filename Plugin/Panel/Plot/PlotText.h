// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlotText.h
 * @brief Numbers as text, and the descriptions of columns.
 */
#ifndef camaron_PlotText_h
#define camaron_PlotText_h

#include "HistogramData.h"

#include <QPair>
#include <QString>

namespace camaron
{
/// With at most @a digits significant digits; exponents are short, as in 1e-6.
QString FormatNumber(double value, int digits = 6);

/// With one digit and an exponent, such as 2e-6.
QString FormatScientific(double value);

/// The smallest number of digits, but at least @a least, with which a number keeps its value up to
/// @a tolerance.
int GetNumberOfDigits(double value, double tolerance, int least);

/// Two different numbers with as many digits as it takes to tell them apart.
QPair<QString, QString> FormatNumbers(double low, double high);

/// A multiple of 10^exponent, with the digits that distinguish it from the other multiples.
QString FormatMultiple(double value, int exponent);

/// The symbol of a unit of the server's tables with a leading space if it needs one: "°", " m".
QString GetUnitSuffix(const QString& unit);

/// A number with its unit: 12.5°, 3 m. Smaller limits than 1e-300 mean "above zero": > 0.
QString FormatLimit(double value, const QString& unit, int digits = 6);

/// With separators between groups of three digits, as in the language of the program.
QString FormatCount(qint64 count);

/// For axes: 500, 20k, 1.5M, 3G, 2e15.
QString FormatShortCount(double count);

/// Rounded to 0% or 100% only if it is exactly that; "0%" of nothing.
QString FormatPercent(double part, double whole);

/// Name of the criterion with its unit.
QString GetTitle(const HistogramData& data);

/// "cells" or another noun.
QString GetElements(const HistogramData& data);

/// The values in a column, such as "10° ≤ value < 12°" or "Undefined (NaN)".
QString GetColumnName(const HistogramData& data, int column);

/// Label below a column that is no bin; @a brief where there is little space.
QString GetColumnLabel(HistogramData::Column type, bool brief);
}

#endif
