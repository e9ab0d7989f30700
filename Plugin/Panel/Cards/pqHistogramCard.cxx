// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqHistogramCard.h"

#include "CardTools.h"
#include "HistogramBrush.h"
#include "NumberText.h"
#include "PanelColors.h"
#include "pqHistogramPlot.h"
#include "pqInspectedMesh.h"
#include "pqLimitFields.h"
#include "pqMeshDisplay.h"
#include "pqMeshFilters.h"
#include "pqMeshQuestions.h"
#include "pqMeshSelection.h"

#include "pqScopedOverrideCursor.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
pqHistogramCard::pqHistogramCard(pqInspectorState* state, QWidget* parent)
  : Superclass("Histogram", tr("Histogram"), true, state, parent)
  , Criterion(camaron::Make<QComboBox>(this->content(), "Criterion"))
  , Group(camaron::Make<QComboBox>(this->content(), "Group"))
  , Bins(camaron::Make<QSpinBox>(this->content(), "Bins"))
  , Plot(camaron::Make<pqHistogramPlot>(this->content(), "Plot"))
  , Limits(camaron::Make<pqLimitFields>(this->content(), "Limits"))
  , Verdict(camaron::MakeText(this->content(), "Verdict", true))
  , Brush(camaron::MakeText(this->content(), "Brush"))
{
  this->makeToolBar();
  this->contentLayout()->addWidget(this->Plot);
  this->contentLayout()->addWidget(this->Limits);
  // Space for two lines, so that nothing moves while limits are dragged.
  this->Verdict->setMinimumHeight(2 * this->fontMetrics().lineSpacing());
  this->Verdict->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  this->contentLayout()->addWidget(this->Brush);
  this->contentLayout()->addWidget(this->Verdict);

  QObject::connect(
    this->Plot, &pqHistogramPlot::acceptableDragging, this, &pqHistogramCard::showLimits);
  QObject::connect(
    this->Plot, &pqHistogramPlot::acceptableChanged, state, &pqInspectorState::setLimits);
  QObject::connect(this->Limits, &pqLimitFields::limitsEdited, this,
    [this](double low, double high)
    {
      this->Plot->showAcceptable(low, high);
      this->showVerdict(low, high);
    });
  QObject::connect(
    this->Limits, &pqLimitFields::limitsChanged, state, &pqInspectorState::setLimits);
  QObject::connect(
    this->Limits, &pqLimitFields::resetRequested, state, &pqInspectorState::resetLimits);
  QObject::connect(this->Verdict, &QLabel::linkActivated, this, &pqHistogramCard::selectFailing);
  QObject::connect(this->Plot, &pqHistogramPlot::brushDragging, this, &pqHistogramCard::showBrush);
  QObject::connect(this->Plot, &pqHistogramPlot::brushEnded, this, &pqHistogramCard::endBrush);
  QObject::connect(this->Plot, &pqHistogramPlot::brushed, this, &pqHistogramCard::select);
  QObject::connect(this->Plot, &pqHistogramPlot::rangeRequested, this, &pqHistogramCard::zoom);
  QObject::connect(this->Plot, &pqHistogramPlot::rangeReset, this,
    [this]
    {
      this->Request.Range.reset();
      this->showDistribution();
    });
  QObject::connect(state, &pqInspectorState::criterionChanged, this,
    [this]
    {
      this->Request.Range.reset();
      this->refreshWhenVisible();
    });
  QObject::connect(
    state, &pqInspectorState::elementsChanged, this, &pqHistogramCard::refreshWhenVisible);
  QObject::connect(this->filters(), &pqMeshFilters::evaluating, this,
    [this](double seconds)
    {
      this->Plot->setData({});
      this->Plot->setEmptyText(camaron::SpellWork(seconds));
      this->Plot->repaint(); // while it computes, nothing else does
    });
  QObject::connect(state, &pqInspectorState::limitsChanged, this,
    [this]
    {
      const double low = this->state()->low(), high = this->state()->high();
      this->Plot->showAcceptable(low, high);
      this->showLimits(low, high);
      if (this->state()->mayCompute() && this->isVisible())
      { // with edges of bins there, and the exact number outside
        this->showDistribution();
      }
    });
  QObject::connect(this->selection(), &pqMeshSelection::selectionChanged, this,
    [this]
    {
      const bool isOfBrush = this->IsSelecting;
      this->IsSelecting = false;
      if (!isOfBrush)
      {
        this->Plot->showSelected({});
      }
      if (this->isVisible() && this->isOpen())
      {
        this->showSelection();
        if (!isOfBrush)
        {
          this->showSelectedParts();
        }
      }
    });
}

//------------------------------------------------------------------------------
void pqHistogramCard::refresh()
{
  if (this->mesh()->elementType() != this->OutlineOf)
  {
    this->OutlineOf = this->mesh()->elementType();
    this->OutlineSource = nullptr;
  }
  this->fillCriteria();
  this->fillGroups();
  this->showDistribution();
  this->showSelection();
}

//------------------------------------------------------------------------------
void pqHistogramCard::recolor()
{
  this->showVerdict(this->Plot->acceptableLow(), this->Plot->acceptableHigh());
}

//------------------------------------------------------------------------------
void pqHistogramCard::showDistribution()
{
  const QString name = this->state()->criterion();
  this->Shown = {};
  const bool isComputed = this->mayCompute(!name.isEmpty());
  this->Plot->setEmptyText(this->filters()->isEvaluating() ? camaron::SpellWork()
      : name.isEmpty() ? tr("Evaluate a criterion to see its histogram")
      : isComputed     ? tr("No data")
                       : QString());
  if (isComputed)
  {
    const pqScopedOverrideCursor waiting(Qt::WaitCursor);
    this->findEdges();
    const auto found = this->questions()->distributions({ name }, this->Request);
    if (!found.isEmpty())
    {
      this->state()->setAcceptable(found.front().Low, found.front().High);
      this->findEdges();
      // once more, with the curve at the limits that the handles offer for these bins
      camaron::DistributionRequest request = this->Request;
      const auto values = camaron::GetCurveValues(
        found.front().Histogram, this->state()->low(), this->state()->high());
      request.CurveValues = QVector<double>(values.begin(), values.end());
      request.CurvePoints = 2; // the extremes
      this->Shown = this->questions()->distributions({ name }, request).value(0);
      for (auto& group : this->Shown.Histogram.Groups)
      { // the range of the user is for all cells
        group.Judged = this->state()->userLimits() ? group.Counts : group.Judged;
      }
    }
  }
  const camaron::CriterionInfo* info = this->questions()->criterion(name);
  this->Shown.Histogram.Name = info ? info->Label : name;
  this->Shown.Histogram.Elements = this->mesh()->elements();
  this->Plot->setData(this->Shown.Histogram);
  this->Plot->setCurve(this->Shown.Cumulative);
  this->Plot->showAcceptable(this->state()->low(), this->state()->high());
  this->showLimits(this->state()->low(), this->state()->high());
  this->showOutline();
  if (this->Plot->brushedCount() == 0)
  {
    this->showSelectedParts();
  }
  camaron::SetEnabled(this->CopyRule, info && info->Element == this->mesh()->elementType(),
    tr("Rules judge criteria."));
}

//------------------------------------------------------------------------------
// Bins end at the limits, so that a brush up to a limit selects what is within. A bin has its lower
// edge: the upper limit itself belongs to what is below.
void pqHistogramCard::findEdges()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  this->Request.Edges.clear();
  if (std::isfinite(this->state()->low()))
  {
    this->Request.Edges << this->state()->low();
  }
  if (std::isfinite(this->state()->high()))
  {
    this->Request.Edges << std::nextafter(this->state()->high(), infinity);
  }
}

//------------------------------------------------------------------------------
void pqHistogramCard::showOutline()
{
  camaron::HistogramData outline;
  if (this->OutlineSource && this->Shown.Histogram.Edges.size() > 1)
  {
    camaron::DistributionRequest request = this->Request;
    request.Range = { this->Shown.Histogram.Edges.front(), this->Shown.Histogram.Edges.back() };
    request.Bins = this->Shown.Histogram.GetNumberOfBins();
    request.GroupBy = "None";
    const auto found = this->questions()->distributions(
      { this->state()->criterion() }, request, this->OutlineSource);
    outline = found.isEmpty() ? outline : found.front().Histogram;
  }
  this->Plot->setOutline(outline);
}

//------------------------------------------------------------------------------
void pqHistogramCard::showLimits(double low, double high)
{
  this->Limits->setEnabled(!this->Shown.Histogram.IsEmpty());
  this->Limits->showLimits(low, high, this->Shown.Histogram.Unit, this->isOwnRange(low, high));
  this->showVerdict(low, high);
}

//------------------------------------------------------------------------------
bool pqHistogramCard::isOwnRange(double low, double high) const
{
  return low == this->Shown.Low && high == this->Shown.High;
}

//------------------------------------------------------------------------------
void pqHistogramCard::showVerdict(double low, double high)
{
  const camaron::HistogramData& data = this->Shown.Histogram;
  this->Verdict->setVisible(!data.IsEmpty());
  this->Brush->setVisible(!data.IsEmpty());
  if (data.IsEmpty() || (std::isinf(low) && std::isinf(high)))
  {
    this->Verdict->setText(data.IsEmpty()
        ? QString()
        : tr("No acceptable range: drag the ends of the axis, or type limits"));
    return;
  }
  const auto outside = this->Shown.Cumulative.GetOutside(low, high, data.GetNumberOfValues());
  qint64 failing = static_cast<qint64>(outside.Count.Value), checked = this->Shown.Applicable;
  double volume = outside.WeightPercent.Value; // in percent; NaN if unknown
  QString elements = this->mesh()->elements();
  const camaron::CriterionInfo* info = this->questions()->criterion(this->state()->criterion());
  const bool isOwn = info && this->isOwnRange(low, high);
  if (isOwn && this->Shown.Judged < this->Shown.Applicable)
  { // a range that its source gives for some shapes only, as Check Quality judges
    failing = this->Shown.failing();
    checked = this->Shown.Judged;
    volume = 100 * this->Shown.BadVolume;
    elements = info->AcceptableFor;
  }
  else
  {
    failing += this->Shown.Undefined - (this->Shown.Count - this->Shown.Applicable);
  }
  // As Check Quality judges: hints of a criterion only warn.
  const bool warns = isOwn && info->IsHint;
  const camaron::PanelColors colors(this->palette());
  const QColor color = failing == 0 ? colors.Passes : warns ? colors.Warns : colors.Fails;
  const QString verdict = failing == 0 ? tr("PASS") : warns ? tr("WARN") : tr("FAIL");
  QString text = tr("<b style=\"color:%1\">%2</b> %3: ")
                   .arg(color.name(), verdict, this->rangeText(low, high).toHtmlEscaped());
  const QString counts =
    tr("%1%2 of %3 %4 (%5) fail")
      .arg(outside.Count.Exact ? "" : "≈ ", camaron::GroupedInteger(failing),
        camaron::GroupedInteger(checked), elements,
        camaron::FormatPercent(static_cast<double>(failing), static_cast<double>(checked))
          .toHtmlEscaped());
  text += failing == 0 ? counts
                       : QString("<a href=\"failing\" style=\"color:%1\">%2</a>")
                           .arg(this->palette().color(QPalette::Link).name(), counts);
  if (!std::isnan(volume))
  { // the sums of volumes are rounded
    constexpr double all = 100;
    volume = failing == 0 ? 0 : failing == checked ? all : volume;
    text += tr(", %1 by volume").arg(camaron::FormatPercent(volume, all).toHtmlEscaped());
  }
  this->Verdict->setText(text);
}

//------------------------------------------------------------------------------
void pqHistogramCard::selectFailing()
{
  const pqScopedOverrideCursor waiting(Qt::WaitCursor);
  const double low = this->state()->low(), high = this->state()->high();
  this->selection()->selectOutside(this->state()->criterion(),
    this->isOwnRange(low, high) ? camaron::Limits() : camaron::Limits({ low, high }));
}

//------------------------------------------------------------------------------
QString pqHistogramCard::rangeText(double low, double high) const
{
  camaron::CriterionInfo info;
  info.Unit = this->Shown.Histogram.Unit;
  info.Low = low;
  info.High = high;
  return info.rangeText();
}

//------------------------------------------------------------------------------
void pqHistogramCard::showBrush(double low, double high, qint64 count)
{
  this->Brush->setText(tr("%1 of %2 %3 (%4)")
      .arg(camaron::GroupedInteger(count), camaron::GroupedInteger(this->Shown.Count),
        this->mesh()->elements(),
        camaron::FormatPercent(
          static_cast<double>(count), static_cast<double>(this->Shown.Count))));
  if (std::isfinite(low) && std::isfinite(high))
  {
    this->display()->previewBrush(low, high);
  }
}

//------------------------------------------------------------------------------
void pqHistogramCard::endBrush()
{
  this->display()->showSelection();
  this->showSelection();
}

//------------------------------------------------------------------------------
void pqHistogramCard::select(const QVector<QPair<double, double>>& ranges, int specials, qint64,
  Qt::KeyboardModifiers modifiers)
{
  const pqScopedOverrideCursor waiting(Qt::WaitCursor);
  // The brush stays although the selection changes.
  this->IsSelecting = this->selection()->selectValues(
    this->state()->criterion(), ranges, specials, camaron::ToCombination(modifiers));
}

//------------------------------------------------------------------------------
void pqHistogramCard::showSelection()
{
  const camaron::SelectionInfo selected = this->selection()->info();
  this->Brush->setText(selected.Count == 0
      ? tr("Click bars, or drag over them, to select their %1").arg(this->mesh()->elements())
      : tr("%1 of %2 %3 selected (%4)")
          .arg(camaron::GroupedInteger(selected.Count), camaron::GroupedInteger(selected.Total),
            selected.IsOfPoints ? tr("points") : this->mesh()->elements(),
            camaron::FormatPercent(
              static_cast<double>(selected.Count), static_cast<double>(selected.Total))));
}

//------------------------------------------------------------------------------
void pqHistogramCard::showSelectedParts()
{
  const camaron::SelectionInfo selected = this->selection()->info();
  if (selected.Count == 0 || selected.IsOfPoints || !this->state()->mayCompute() ||
    this->Shown.Histogram.IsEmpty())
  {
    return;
  }
  camaron::DistributionRequest request = this->Request;
  request.CountsSelected = true;
  const auto found = this->questions()->distributions({ this->state()->criterion() }, request);
  if (!found.isEmpty() && found.front().Histogram.Edges == this->Shown.Histogram.Edges)
  {
    const camaron::HistogramData& parts = found.front().Histogram;
    this->Plot->showSelected(parts.Selected, parts.Groups);
  }
}

//------------------------------------------------------------------------------
void pqHistogramCard::zoom(double low, double high)
{
  this->Request.Range = { low, high };
  this->showDistribution();
}

//------------------------------------------------------------------------------
void pqHistogramCard::copyRule()
{
  const QString line = this->state()->rule();
  if (!line.isEmpty())
  {
    QApplication::clipboard()->setText(line);
    this->state()->addRule(line);
  }
}
