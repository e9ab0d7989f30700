// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqMeshInspectorPanel
 * @brief The dock "Mesh Inspector": quality of the active mesh in cards.
 *
 * A card is a class in Cards/ and a row in pqMeshInspectorPanel.cxx. Start reading at
 * pqMeshServices, which are all that cards know of ParaView, and at pqInspectorCard.
 *
 * When the plugin is loaded the first time, the dock is a tab beside the Properties panel. As soon
 * as the window is wide enough, it moves to the right of the view, in the tabs of ParaView's Color
 * Map Editor, unless the user moved it; afterwards ParaView restores the place that the user gave
 * it.
 */
#ifndef pqMeshInspectorPanel_h
#define pqMeshInspectorPanel_h

#include <QDockWidget>

class pqMeshInspectorPanel : public QDockWidget
{
  Q_OBJECT
  typedef QDockWidget Superclass;

public:
  Q_INVOKABLE explicit pqMeshInspectorPanel(QWidget* parent = nullptr); // for tests

  /// Waits for the window to be shown and to be wide.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  /// Lets the menu View bring it to the front if it is behind another dock, instead of closing it.
  void raiseFromMenu();

  /// Moves the dock to its place in the window, which has added it.
  void findPlace();

  /// Moves the dock from the Properties panel to the right of the view if the window is wide.
  void moveBesideView();

  /// Shows no welcome dialog of ParaView this time. It would appear while `camaron view` opens a
  /// mesh: ParaView 6.1 then waits in the middle of a filter for its end, and ignores the mouse.
  void skipWelcome();

  bool IsBehind = false; // another dock of the same place
  bool IsPlaced = false; // beside the view, or where the user moved it since
  bool WasShown = false; // the window
};

#endif
