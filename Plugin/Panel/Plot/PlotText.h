// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlotText.h
 * @brief Descriptions of a histogram and its columns, and tool tips.
 */
#ifndef camaron_PlotText_h
#define camaron_PlotText_h

#include "HistogramData.h"

#include <QStringList>

class QPointF;
class QRect;

namespace camaron
{
class HistogramScene;

/// "cells" or another noun.
QString GetElements(const HistogramData& data);

/// The values in a column, such as "10° ≤ value < 12°" or "Undefined (NaN)".
QString GetColumnName(const HistogramData& data, int column);

/// Label below a column that is no bin; short if @a brief.
QString GetColumnLabel(HistogramData::Column type, bool brief);

/// Range, count, percentage and groups of a column, as lines of plain text.
QStringList DescribeColumn(const HistogramData& data, int column);

/// Rich text about what is at a position, and the @a area that it is about; or an empty text.
QString GetToolTip(const HistogramScene& scene, const QPointF& position, QRect& area);

/// Rich text about a column.
QString GetColumnToolTip(const HistogramData& data, int column);
}

#endif
