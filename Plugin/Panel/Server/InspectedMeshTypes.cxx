// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InspectedMeshTypes.h"

#include "NumberText.h"

#include <QCoreApplication>

#include <cmath>

namespace
{
//------------------------------------------------------------------------------
QString Translate(const char* text)
{
  return QCoreApplication::translate("pqInspectedMesh", text);
}
}

namespace camaron
{
//------------------------------------------------------------------------------
bool CriterionInfo::hasRange() const
{
  return std::isfinite(this->Low) || std::isfinite(this->High);
}

//------------------------------------------------------------------------------
QString CriterionInfo::title() const
{
  return AddUnit(this->Label, this->Unit);
}

//------------------------------------------------------------------------------
QString CriterionInfo::rangeText() const
{
  if (!this->hasRange())
  {
    return QString();
  }
  const QString unit = GetUnitSuffix(this->Unit);
  const QString low = FormatLimit(this->Low, QString()), high = ShortNumber(this->High);
  if (IsPositive(this->Low) && !std::isfinite(this->High))
  {
    return Translate("more than 0%1").arg(unit);
  }
  if (!std::isfinite(this->Low))
  {
    return Translate("at most %1%2").arg(high, unit);
  }
  return std::isfinite(this->High) ? Translate("%1 to %2%3").arg(low, high, unit)
                                   : Translate("at least %1%2").arg(low, unit);
}

//------------------------------------------------------------------------------
QString CriterionInfo::toolTip() const
{
  const auto escaped = [](const QString& text) { return text.toHtmlEscaped(); };
  QString text = QString("<b>%1</b> (%2)<br/>%3")
                   .arg(escaped(this->Label), escaped(this->Name), escaped(this->Description));
  const auto add = [&](const QString& title, const QString& value)
  {
    if (!value.isEmpty())
    {
      text += QString("<br/><i>%1:</i> %2").arg(title, escaped(value));
    }
  };
  add(Translate("Unit"), GetUnitSuffix(this->Unit).trimmed());
  add(Translate("Applies to"), this->AppliesTo);
  add(Translate("Ideal"), ShortNumber(this->Ideal));
  add(this->IsHint ? Translate("Recommended") : Translate("Acceptable"), this->rangeText());
  add(Translate("Source"), this->hasRange() ? this->Source : QString());
  add(Translate("Outside the range"), this->Consequence);
  return text;
}
}
