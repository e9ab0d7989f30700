// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PanelColors
 * @brief Colors of verdicts on a light or dark background, the same ones everywhere in the panel.
 */
#ifndef camaron_PanelColors_h
#define camaron_PanelColors_h

#include <QColor>
#include <QPalette>

namespace camaron
{
struct PanelColors
{
  QColor Passes, Warns, Fails, Unknown;

  explicit PanelColors(const QPalette& palette)
  {
    constexpr int middle = 128;
    const bool isDark = palette.color(QPalette::Base).lightness() < middle;
    this->Passes = isDark ? QColor("#5fbf77") : QColor("#1a7f37");
    this->Warns = isDark ? QColor("#e0b040") : QColor("#9a6700");
    this->Fails = isDark ? QColor("#ff7b72") : QColor("#c62828");
    this->Unknown = palette.color(QPalette::Disabled, QPalette::Text);
  }
};
}

#endif
