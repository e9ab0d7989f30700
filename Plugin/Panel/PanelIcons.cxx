// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PanelIcons.h"

#include <QFile>
#include <QImage>
#include <QPalette>
#include <QPixmap>

namespace camaron
{
//------------------------------------------------------------------------------
QIcon PanelIcon(const QString& name, const QPalette& palette)
{
  QFile file(QString(":/CamaronPanel/Icons/%1.svg").arg(name));
  QIcon icon;
  if (!file.open(QIODevice::ReadOnly))
  {
    return icon;
  }
  const QByteArray drawing = file.readAll();
  const auto add = [&](QPalette::ColorGroup group, QIcon::Mode mode)
  {
    QByteArray colored = drawing;
    colored.replace("currentColor", palette.color(group, QPalette::Text).name().toUtf8());
    for (const int size : { 16, 32, 64 })
    {
      QByteArray sized = colored;
      sized.replace("<svg ", QString("<svg width=\"%1\" height=\"%1\" ").arg(size).toUtf8());
      icon.addPixmap(QPixmap::fromImage(QImage::fromData(sized, "svg")), mode);
    }
  };
  add(QPalette::Active, QIcon::Normal);
  add(QPalette::Disabled, QIcon::Disabled);
  return icon;
}
}
