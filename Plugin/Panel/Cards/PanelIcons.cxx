// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CardTools.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QImage>
#include <QPainter>
#include <QPalette>
#include <QPixmap>

namespace
{
// Draws in the color that texts have at that moment.
class TextColorEngine : public QIconEngine
{
public:
  explicit TextColorEngine(const QByteArray& drawing)
    : Drawing(drawing)
  {
  }

  QIconEngine* clone() const override { return new TextColorEngine(this->Drawing); }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State) override
  {
    const QPalette palette = QGuiApplication::palette();
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    const QRgb color = palette.color(group, QPalette::Text).rgb();
    for (const Drawn& drawn : std::as_const(this->Cache))
    {
      if (drawn.Color == color && drawn.Pixmap.size() == size)
      {
        return drawn.Pixmap;
      }
    }
    QByteArray svg = this->Drawing;
    svg.replace("currentColor", QColor(color).name().toUtf8());
    svg.replace("<svg ",
      QString("<svg width=\"%1\" height=\"%2\" ").arg(size.width()).arg(size.height()).toUtf8());
    this->Cache << Drawn{ color, QPixmap::fromImage(QImage::fromData(svg, "svg")) };
    return this->Cache.back().Pixmap;
  }

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override
  {
    const QSizeF size = QSizeF(rect.size()) * painter->device()->devicePixelRatioF();
    painter->drawPixmap(rect, this->pixmap(size.toSize(), mode, state));
  }

private:
  struct Drawn
  {
    QRgb Color;
    QPixmap Pixmap;
  };

  QByteArray Drawing;
  QVector<Drawn> Cache; // a few sizes and colors
};
}

namespace camaron
{
//------------------------------------------------------------------------------
QIcon PanelIcon(const QString& name)
{
  QFile file(QString(":/CamaronPanel/Icons/%1.svg").arg(name));
  return file.open(QIODevice::ReadOnly) ? QIcon(new TextColorEngine(file.readAll())) : QIcon();
}
}
