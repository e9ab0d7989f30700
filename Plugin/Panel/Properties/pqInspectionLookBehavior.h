// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqInspectionLookBehavior
 * @brief Gives meshes that Mesh Inspection draws the edges, light and color of the report.
 *
 * Turns the camera to an isometric view when Mesh Inspection shows the first data of a view. Along
 * an axis, as ParaView looks at first, most solids look like one of their sides. Views of flat
 * meshes, views with other data, and cameras that were moved before stay as they are.
 *
 * With ParaView's light, faces that are turned away match no color of a legend: Mesh Inspection and
 * the Mesh Inspector set an even one, in which a surface of one color looks flat without edges. It
 * is taken back from meshes of one color that are not inspected, and is there again when an array
 * colors the mesh. Another light that a user has chosen stays.
 */
#ifndef pqInspectionLookBehavior_h
#define pqInspectionLookBehavior_h

#include <QObject>

class pqRepresentation;
class pqView;

class pqInspectionLookBehavior : public QObject
{
  Q_OBJECT

public:
  using QObject::QObject;

  ///@{
  /// Called when the plugin is loaded and unloaded.
  void startup();
  void shutdown();
  ///@}

private:
  void followView(pqView* view);
  void follow(pqRepresentation* representation);
};

#endif
