// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLimitFields.h"

#include "CardTools.h"
#include "NumberText.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include <cmath>

namespace
{
//------------------------------------------------------------------------------
QString SpellLimit(double limit)
{
  return std::isfinite(limit) ? camaron::FormatLimit(limit, QString()) : QString();
}

//------------------------------------------------------------------------------
// A field that the user has not changed keeps all digits.
std::optional<double> ReadLimit(const QLineEdit* field, double shown, double none)
{
  const QString text = field->text();
  return text == SpellLimit(shown) ? shown : camaron::LimitValidator::Read(text, none);
}
}

//------------------------------------------------------------------------------
pqLimitFields::pqLimitFields(QWidget* parent)
  : Superclass(parent)
  , Low(this->addField("Lower", tr("Smallest acceptable value; empty for no limit")))
  , High(this->addField("Upper", tr("Largest acceptable value; empty for no limit")))
  , Unit(new QLabel(this))
  , Reset(camaron::MakeTool(this, "ResetLimits", tr("Back to the range of the criterion")))
{
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(new QLabel(tr("Acceptable"), this));
  layout->addWidget(this->Low, 1);
  layout->addWidget(new QLabel(tr("to"), this));
  layout->addWidget(this->High, 1);
  layout->addWidget(this->Unit);
  layout->addWidget(this->Reset);
  QObject::connect(
    this->Reset, &QToolButton::clicked, this, [this] { Q_EMIT this->resetRequested(); });
}

//------------------------------------------------------------------------------
QLineEdit* pqLimitFields::addField(const char* name, const QString& tip)
{
  auto* field = camaron::Make<QLineEdit>(this, name);
  field->setPlaceholderText(tr("none"));
  field->setToolTip(tip);
  field->setAccessibleName(tip);
  field->setValidator(new camaron::LimitValidator(field));
  constexpr int characters = 6;
  field->setMinimumWidth(field->fontMetrics().averageCharWidth() * characters);
  QObject::connect(field, &QLineEdit::textChanged, this,
    [this]
    {
      if (const auto limits = this->read())
      {
        Q_EMIT this->limitsEdited(limits->first, limits->second);
      }
    });
  QObject::connect(field, &QLineEdit::editingFinished, this, &pqLimitFields::finish);
  return field;
}

//------------------------------------------------------------------------------
std::optional<QPair<double, double>> pqLimitFields::read() const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto low = ReadLimit(this->Low, this->Shown.first, -infinity);
  const auto high = ReadLimit(this->High, this->Shown.second, infinity);
  return low && high && *low <= *high ? std::optional(qMakePair(*low, *high)) : std::nullopt;
}

//------------------------------------------------------------------------------
void pqLimitFields::finish()
{
  const auto limits = this->read();
  if (!limits)
  {
    this->showTexts();
    Q_EMIT this->limitsEdited(this->Shown.first, this->Shown.second);
  }
  else if (*limits != this->Shown)
  {
    Q_EMIT this->limitsChanged(limits->first, limits->second);
  }
}

//------------------------------------------------------------------------------
void pqLimitFields::showTexts()
{
  const QSignalBlocker lowBlocker(this->Low), highBlocker(this->High);
  this->Low->setText(SpellLimit(this->Shown.first));
  this->High->setText(SpellLimit(this->Shown.second));
}

//------------------------------------------------------------------------------
void pqLimitFields::showLimits(double low, double high, const QString& unit, bool isOwn)
{
  this->Shown = { low, high };
  this->showTexts();
  this->Unit->setText(camaron::GetUnitSuffix(unit).trimmed());
  this->Reset->setEnabled(!isOwn);
}
