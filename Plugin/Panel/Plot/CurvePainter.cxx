// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CurvePainter.h"

#include <QPainter>

#include <algorithm>

namespace camaron
{
namespace
{
constexpr double CurveWidth = 1.5; // pixels
constexpr double AllPercent = 100;
}

//------------------------------------------------------------------------------
CurvePainter::CurvePainter(const HistogramContent& content, const HistogramLayout& layout)
  : Content(content)
  , Layout(layout)
{
}

//------------------------------------------------------------------------------
void CurvePainter::Paint(QPainter* painter, const QColor& color) const
{
  if (this->Content.Data.Edges.empty())
  {
    return;
  }
  const QPolygonF curve = this->Content.Curve.IsEmpty() ? this->GetCurveOfBins() : this->GetCurve();
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  constexpr double margin = 1; // for the width of the line
  painter->setClipRect(this->Layout.Plot.adjusted(0, -margin, 0, margin));
  painter->setPen(QPen(color, CurveWidth));
  painter->drawPolyline(curve);
  painter->restore();
}

//------------------------------------------------------------------------------
QPolygonF CurvePainter::GetCurve() const
{
  const CumulativeCounts& curve = this->Content.Curve;
  const double total = static_cast<double>(this->Content.Data.GetNumberOfValues());
  const QRectF& plot = this->Layout.Plot;
  QPolygonF points;
  double y = this->Layout.PercentToY(0);
  points << QPointF(plot.left(), y);
  for (std::size_t i = 0; i < curve.Values.size(); ++i)
  {
    // Positions far outside the plot would exceed what the painter can draw.
    const double x = this->Layout.ToX(curve.Values[i]);
    const double inside = std::clamp(x, plot.left() - plot.width(), plot.right() + plot.width());
    if (i == 0)
    {
      points << QPointF(inside, y);
    }
    y = this->Layout.PercentToY(AllPercent * static_cast<double>(curve.Counts[i]) / total);
    points << QPointF(inside, y);
  }
  points << QPointF(std::max(plot.right(), points.back().x()), y);
  return points;
}

//------------------------------------------------------------------------------
QPolygonF CurvePainter::GetCurveOfBins() const
{
  const HistogramData& data = this->Content.Data;
  const double total = static_cast<double>(data.GetNumberOfValues());
  double upTo = static_cast<double>(data.GetCount(0));
  QPolygonF points;
  const auto add = [&](double value)
  {
    points << QPointF(this->Layout.ToX(value), this->Layout.PercentToY(AllPercent * upTo / total));
  };
  const double first = data.Edges.front(), last = data.Edges.back();
  points << QPointF(this->Layout.Plot.left(), this->Layout.PercentToY(AllPercent * upTo / total));
  add(first);
  for (int bin = 0; bin < data.GetNumberOfBins(); ++bin)
  {
    upTo += static_cast<double>(data.GetCount(data.GetColumnOfBin(bin)));
    add(data.Edges[bin + 1]);
  }
  if (this->Layout.ToX(last) < this->Layout.Plot.right())
  {
    points << QPointF(this->Layout.Plot.right(), points.back().y());
  }
  return points;
}
}
