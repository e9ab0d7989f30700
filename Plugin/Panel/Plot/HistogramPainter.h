// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HistogramPainter.h
 * @brief Draws histograms.
 */
#ifndef camaron_HistogramPainter_h
#define camaron_HistogramPainter_h

#include "HistogramScene.h"

class QPainter;
class QPalette;
class QRect;

namespace camaron
{
struct PlotColors;

/// The scene of a histogram plot.
void PaintHistogram(QPainter* painter, const HistogramScene& scene, const QPalette& palette);

///@{
/// Parts of it: the lines at the ticks of counts, behind the bars; axes, labels, titles, legend and
/// handles of the acceptable range.
void PaintGrid(QPainter* painter, const HistogramScene& scene, const PlotColors& colors);
void PaintAxes(QPainter* painter, const HistogramScene& scene, const PlotColors& colors);
///@}

/**
 * A histogram for the cell of a table: bars without axes in @a rect, about 80 x 16 pixels: green
 * within the acceptable range and red outside, or neutral if neither limit is finite; pale but for
 * what is selected. No bar with elements is lower than two pixels. Draws no background and leaves
 * the state of the painter unchanged.
 */
void PaintSmallHistogram(QPainter* painter, const QRect& rect, const HistogramData& data,
  double acceptableLow, double acceptableHigh, const QPalette& palette);
}

#endif
