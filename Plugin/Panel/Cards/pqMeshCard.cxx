// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqMeshCard.h"

#include "CardTools.h"
#include "NumberText.h"
#include "PanelColors.h"
#include "pqInspectedMesh.h"
#include "pqMeshQuestions.h"
#include "pqMeshSelection.h"

#include "pqScopedOverrideCursor.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>

namespace
{
//------------------------------------------------------------------------------
QString SpellMemory(qint64 kibibytes)
{
  constexpr double unit = 1024;
  const double mebibytes = static_cast<double>(kibibytes) / unit;
  return kibibytes < unit ? QString("%1\u00a0KiB").arg(kibibytes)
    : mebibytes < unit    ? QString("%1\u00a0MiB").arg(mebibytes, 0, 'f', mebibytes < 10 ? 1 : 0)
                          : QString("%1\u00a0GiB").arg(mebibytes / unit, 0, 'f', 1);
}
}

//------------------------------------------------------------------------------
pqMeshCard::pqMeshCard(pqInspectorState* state, QWidget* parent)
  : Superclass("Mesh", tr("Mesh"), true, state, parent)
  , Counts(camaron::MakeText(this->content(), "Counts"))
  , Bounds(camaron::MakeText(this->content(), "Bounds"))
  , Types(camaron::MakeText(this->content(), "Types"))
  , Validity(camaron::MakeText(this->content(), "Validity", true))
  , Validate(camaron::Make<QPushButton>(this->content(), "Validate", tr("Validate Cells")))
{
  this->Validate->setToolTip(
    tr("Evaluates CellStatus for all cells and counts cells by type. For meshes of this size it "
       "is done on request."));
  for (QWidget* widget : std::initializer_list<QWidget*>{
         this->Counts, this->Bounds, this->Types, this->Validity, this->Validate })
  {
    this->contentLayout()->addWidget(widget);
  }
  QObject::connect(this->Validate, &QPushButton::clicked, this, &pqMeshCard::validate);
  QObject::connect(
    this->Validity, &QLabel::linkActivated, this->selection(), &pqMeshSelection::selectDefect);
}

//------------------------------------------------------------------------------
void pqMeshCard::refresh()
{
  const camaron::MeshSummary summary = this->questions()->summary();
  const bool isMesh = this->mesh()->port() != nullptr;
  this->Bounds->setVisible(isMesh);
  // Lines and vertices are neither valid nor invalid; steps of selection change nothing.
  const QString type = this->mesh()->elementType();
  const bool hasValidity = isMesh && (type == "Cell" || type == "Face");
  const bool isKnown = hasValidity && this->mesh()->cellsVersion() == this->ValidatedVersion;
  this->Types->setVisible(isKnown);
  this->Validity->setVisible(isKnown);
  this->Validate->setVisible(hasValidity && !isKnown && !this->mesh()->isSmall());
  if (!isMesh)
  {
    this->Counts->setText(this->mesh()->reasonForNone());
    return;
  }
  const QString step =
    summary.Step.isEmpty() ? QString() : " (" + summary.Step.toHtmlEscaped() + ')';
  QString counts =
    tr("<b>%1</b>%2: <nobr>%3 %4</nobr>, <nobr>%5 points</nobr>, %6")
      .arg(summary.Name.toHtmlEscaped(), step, camaron::GroupedInteger(summary.Cells),
        this->mesh()->elements(summary.Cells), camaron::GroupedInteger(summary.Points),
        SpellMemory(summary.Memory));
  if (summary.Blocks > 0)
  {
    counts += tr(", %1&nbsp;blocks").arg(camaron::GroupedInteger(summary.Blocks));
  }
  this->Counts->setText(counts);
  QStringList sides;
  for (int i = 0; i < 3; ++i)
  {
    const double low = summary.Bounds[2 * i], high = summary.Bounds[2 * i + 1];
    constexpr int digits = 4;
    sides << tr("%1 %2 to %3")
               .arg(QChar('x' + i))
               .arg(low, 0, 'g', digits)
               .arg(high, 0, 'g', digits)
               .replace(' ', QChar(QChar::Nbsp));
  }
  this->Bounds->setText(sides.join(", "));
  this->Bounds->setToolTip(tr("Bounding box, in the unit of the mesh"));
  if (hasValidity && !isKnown && this->mesh()->isSmall())
  {
    this->validate();
  }
}

//------------------------------------------------------------------------------
void pqMeshCard::validate()
{
  const pqScopedOverrideCursor waiting(Qt::WaitCursor);
  this->Found = this->questions()->validity();
  this->ValidatedVersion = this->mesh()->cellsVersion();
  this->showValidity();
  this->Types->setVisible(!this->Found.Types.isEmpty());
  this->Validity->show();
  this->Validate->hide();
}

//------------------------------------------------------------------------------
void pqMeshCard::recolor()
{
  this->showValidity();
}

//------------------------------------------------------------------------------
void pqMeshCard::showValidity()
{
  QStringList types;
  for (const auto& type : this->Found.Types)
  {
    types << QString("%1\u00a0%2").arg(camaron::GroupedInteger(type.Count), type.Label);
  }
  this->Types->setText(types.join(", "));
  QStringList lines;
  const camaron::PanelColors colors(this->palette());
  for (const auto& defect : this->Found.Defects)
  {
    lines << QString("<a href=\"%1\" style=\"color:%2\">%3&nbsp;×&nbsp;%4</a>")
               .arg(defect.Name.toHtmlEscaped(),
                 (defect.IsInvalid ? colors.Fails : colors.Warns).name(),
                 camaron::GroupedInteger(defect.Count),
                 defect.Label.toHtmlEscaped().replace(' ', "&nbsp;"));
  }
  const bool isValid = std::none_of(this->Found.Defects.begin(), this->Found.Defects.end(),
    [](const auto& defect) { return defect.IsInvalid; });
  this->Validity->setText(lines.isEmpty()
      ? QString("<span style=\"color:%1\">✔ %2</span>")
          .arg(colors.Passes.name(), tr("All %1 are valid").arg(this->mesh()->elements()))
      : (isValid ? "⚠ " : "✘ ") + lines.join(", "));
  this->Validity->setToolTip(lines.isEmpty()
      ? QString()
      : tr("Click a defect to select its %1").arg(this->mesh()->elements()));
}
