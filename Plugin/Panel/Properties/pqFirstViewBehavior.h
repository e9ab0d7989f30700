// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqFirstViewBehavior
 * @brief Turns the camera to an isometric view when Mesh Inspection shows the first data of a view.
 * Meshes have the edges, light and color of the report there, and wherever Mesh Inspection is
 * chosen.
 *
 * Along an axis, as ParaView looks at first, most solids look like one of their sides. Views of
 * flat meshes, views with other data, and cameras that were moved before stay as they are.
 */
#ifndef pqFirstViewBehavior_h
#define pqFirstViewBehavior_h

#include <QObject>

class pqRepresentation;
class pqView;

class pqFirstViewBehavior : public QObject
{
  Q_OBJECT

public:
  explicit pqFirstViewBehavior(QObject* parent = nullptr);

  ///@{
  /// Called when the plugin is loaded and unloaded.
  void startup();
  void shutdown();
  ///@}

private:
  void follow(pqView* view);
};

#endif
