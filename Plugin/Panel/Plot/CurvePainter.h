// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CurvePainter
 * @brief Draws the cumulative curve over the bars, as percentages of the elements with a value.
 */
#ifndef camaron_CurvePainter_h
#define camaron_CurvePainter_h

#include "HistogramLayout.h"

#include <QPolygonF>

class QColor;
class QPainter;

namespace camaron
{
class CurvePainter
{
public:
  CurvePainter(const HistogramContent& content, const HistogramLayout& layout);

  void Paint(QPainter* painter, const QColor& color) const;

private:
  QPolygonF GetCurve() const;
  /// Without a curve.
  QPolygonF GetCurveOfBins() const;

  const HistogramContent& Content;
  const HistogramLayout& Layout;
};
}

#endif
