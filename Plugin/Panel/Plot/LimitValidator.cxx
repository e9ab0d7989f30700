// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LimitValidator.h"

#include <cmath>

namespace camaron
{
//------------------------------------------------------------------------------
LimitValidator::LimitValidator(QObject* parent)
  : QDoubleValidator(parent)
{
  QLocale locale = QLocale::c();
  locale.setNumberOptions(QLocale::RejectGroupSeparator);
  this->setLocale(locale);
}

//------------------------------------------------------------------------------
QValidator::State LimitValidator::validate(QString& text, int& place) const
{
  text.replace(',', '.');
  const State state = this->QDoubleValidator::validate(text, place);
  return state == Intermediate ? Acceptable : state;
}

//------------------------------------------------------------------------------
std::optional<double> LimitValidator::Read(const QString& text, double none)
{
  const QString trimmed = text.trimmed();
  bool isNumber = false;
  const double number = QString(trimmed).replace(',', '.').toDouble(&isNumber);
  if (trimmed.isEmpty())
  {
    return none;
  }
  return isNumber && std::isfinite(number) ? std::optional<double>(number) : std::nullopt;
}
}
