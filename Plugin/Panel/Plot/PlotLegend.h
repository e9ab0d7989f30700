// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PlotLegend
 * @brief Places the entries of a legend in lines.
 */
#ifndef camaron_PlotLegend_h
#define camaron_PlotLegend_h

#include <QFontMetricsF>
#include <QRectF>
#include <QStringList>

#include <vector> // for entries

namespace camaron
{
class PlotLegend
{
public:
  struct Entry
  {
    int Index; ///< of the label, or -1 for "and 12 more"
    QString Text;
    QRectF Swatch;
    QRectF TextBox;
  };

  PlotLegend() = default;
  /// Left-aligned lines, at most @a mostLines; the last entry summarizes those that do not fit.
  PlotLegend(const QStringList& labels, const QPointF& topLeft, double width,
    const QFontMetricsF& metrics, int mostLines);

  const std::vector<Entry>& GetEntries() const { return this->Entries; }
  double GetHeight() const { return this->Height; }

private:
  std::vector<Entry> Entries;
  double Height = 0;
};
}

#endif
