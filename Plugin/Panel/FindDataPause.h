// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FindDataPause
 * @brief Keeps ParaView's panel Find Data from computing its table of the selected elements while
 * it is hidden, which takes as long as it takes to draw them.
 */
#ifndef camaron_FindDataPause_h
#define camaron_FindDataPause_h

#include <QObject>
#include <QPointer> // for the panel

namespace camaron
{
class FindDataPause : public QObject
{
public:
  /// @param window that contains the panel, if there is one
  explicit FindDataPause(QWidget* window);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void follow(bool isVisible);

  QPointer<QObject> Table;
};
}

#endif
