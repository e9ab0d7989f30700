// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlotToolTip.h
 * @brief Tool tips of a histogram plot.
 */
#ifndef camaron_PlotToolTip_h
#define camaron_PlotToolTip_h

#include <QStringList>

class QPointF;
class QRect;

namespace camaron
{
struct HistogramContent;
struct HistogramData;
class HistogramLayout;

/// Range, count, percentage and groups of a column, as lines of plain text.
QStringList DescribeColumn(const HistogramData& data, int column);

/// Rich text about what is at a position, and the @a area that it is about; or an empty text.
QString GetToolTip(const HistogramContent& content, const HistogramLayout& layout,
  const QPointF& position, QRect& area);

/// Rich text about a column.
QString GetColumnToolTip(const HistogramData& data, int column);
}

#endif
