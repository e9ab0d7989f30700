// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SmallHistogram.h
 * @brief A histogram for the cell of a table.
 */
#ifndef camaron_SmallHistogram_h
#define camaron_SmallHistogram_h

class QPainter;
class QPalette;
class QRect;

namespace camaron
{
struct HistogramData;

/**
 * Draws bars without axes in @a rect, about 80 x 16 pixels: green within the acceptable range and
 * red outside, or neutral if neither limit is finite; pale but for what is selected. No bar with
 * elements is lower than two pixels. Draws no background and leaves the state of the painter
 * unchanged.
 */
void PaintSmallHistogram(QPainter* painter, const QRect& rect, const HistogramData& data,
  double acceptableLow, double acceptableHigh, const QPalette& palette);
}

#endif
