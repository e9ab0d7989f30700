// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqCriterionRangeWidget.h"

#include "CardTools.h"
#include "MeshOutput.h"
#include "NumberText.h"
#include "pqHistogramPlot.h"
#include "pqMeshQuestions.h"
#include "pqMeshServices.h"

#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqScopedOverrideCursor.h"
#include "pqServerManagerModel.h"

#include "vtkCommand.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <limits>

namespace
{
constexpr const char* Custom = "Custom"; // a choice of Range

//------------------------------------------------------------------------------
double ReadLimit(const QLineEdit* field, double none)
{
  return camaron::LimitValidator::Read(field->text(), none).value_or(none);
}
}

//------------------------------------------------------------------------------
pqCriterionRangeWidget::pqCriterionRangeWidget(
  vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : Superclass(proxy, group, parent)
  , Range(camaron::Make<QComboBox>(this, "Range"))
  , Plot(camaron::Make<pqHistogramPlot>(this, "Plot"))
  , Compute(camaron::Make<QPushButton>(this, "Compute", tr("Compute Histogram")))
  , Low(camaron::Make<QLineEdit>(this, "LowerLimit"))
  , High(camaron::Make<QLineEdit>(this, "UpperLimit"))
{
  this->setShowLabel(false);
  this->Low->setPlaceholderText(tr("no lower limit"));
  this->High->setPlaceholderText(tr("no upper limit"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* choice = new QHBoxLayout;
  choice->addWidget(new QLabel(tr("Range"), this));
  choice->addWidget(this->Range, 1);
  layout->addLayout(choice);
  layout->addWidget(this->Plot);
  layout->addWidget(this->Compute);
  auto* limits = new QHBoxLayout;
  limits->addWidget(this->Low);
  limits->addWidget(this->High);
  layout->addLayout(limits);
  this->addPropertyLink(this->Range, "Range");
  this->addPropertyLink(this->Low, "LowerLimit");
  this->addPropertyLink(this->High, "UpperLimit");
  this->setChangeAvailableAsChangeFinished(true);

  QObject::connect(
    this->Plot, &pqHistogramPlot::acceptableChanged, this, &pqCriterionRangeWidget::setLimits);
  QObject::connect(this->Compute, &QPushButton::clicked, this, &pqCriterionRangeWidget::compute);
  QObject::connect(
    this->Range, &QComboBox::currentTextChanged, this, &pqCriterionRangeWidget::showRange);
  for (QLineEdit* field : { this->Low, this->High })
  {
    field->setValidator(new camaron::LimitValidator(field));
    QObject::connect(field, &QLineEdit::textChanged, this, &pqCriterionRangeWidget::showRange);
  }
  this->Delay.setSingleShot(true);
  this->Delay.setInterval(0);
  QObject::connect(&this->Delay, &QTimer::timeout, this, &pqCriterionRangeWidget::refresh);
  for (const char* name : { "Array", "ElementType", "Preset" })
  {
    for (const int change : { static_cast<int>(vtkCommand::UncheckedPropertyModifiedEvent),
           static_cast<int>(vtkCommand::ModifiedEvent) })
    {
      pqCoreUtilities::connect(proxy->GetProperty(name), change, &this->Delay, SLOT(start()));
    }
  }
  this->Compute->hide();
}

//------------------------------------------------------------------------------
pqOutputPort* pqCriterionRangeWidget::input() const
{
  vtkSMPropertyHelper input(this->proxy(), "Input");
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  auto* source = model->findItem<pqPipelineSource*>(input.GetAsProxy());
  return source ? source->getOutputPort(static_cast<int>(input.GetOutputPort())) : nullptr;
}

//------------------------------------------------------------------------------
QString pqCriterionRangeWidget::array() const
{
  const auto get = [&](const char* name)
  { return vtkSMUncheckedPropertyHelper(this->proxy()->GetProperty(name)).GetAsString(); };
  return qstrcmp(get("ElementType"), "Points") == 0 ? QString() : QString::fromUtf8(get("Array"));
}

//------------------------------------------------------------------------------
void pqCriterionRangeWidget::showEvent(QShowEvent* event)
{
  this->Superclass::showEvent(event);
  this->Delay.start();
}

//------------------------------------------------------------------------------
void pqCriterionRangeWidget::refresh()
{
  pqOutputPort* port = this->input();
  const bool hasValues = port && !this->array().isEmpty();
  const bool isSmall = hasValues && camaron::MeshOutput(port).isSmall();
  this->Plot->setVisible(hasValues);
  this->Compute->setVisible(hasValues && !isSmall);
  this->Shown = {};
  if (this->isVisible() && isSmall)
  {
    this->compute();
  }
  else
  {
    this->Plot->setData(this->Shown.Histogram);
    this->showRange();
  }
}

//------------------------------------------------------------------------------
void pqCriterionRangeWidget::compute()
{
  const pqScopedOverrideCursor waiting(Qt::WaitCursor);
  camaron::DistributionRequest request;
  request.Preset = vtkSMUncheckedPropertyHelper(this->proxy()->GetProperty("Preset")).GetAsString();
  pqOutputPort* port = this->input();
  const auto found = port
    ? pqMeshServices::instance()->Questions->distributions({ this->array() }, request, port)
    : QVector<camaron::Distribution>();
  this->Shown = found.value(0);
  this->Plot->setData(this->Shown.Histogram);
  this->Compute->hide();
  this->showRange();
}

//------------------------------------------------------------------------------
void pqCriterionRangeWidget::showRange()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool isCustom = this->Range->currentText() == Custom;
  this->Low->setVisible(isCustom);
  this->High->setVisible(isCustom);
  this->Plot->showAcceptable(isCustom ? ReadLimit(this->Low, -infinity) : this->Shown.Low,
    isCustom ? ReadLimit(this->High, infinity) : this->Shown.High);
}

//------------------------------------------------------------------------------
void pqCriterionRangeWidget::setLimits(double low, double high)
{
  this->Low->setText(camaron::ExactLimit(low));
  this->High->setText(camaron::ExactLimit(high));
  this->Range->setCurrentText(Custom);
}
