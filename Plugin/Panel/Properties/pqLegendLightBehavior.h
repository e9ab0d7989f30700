// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLegendLightBehavior
 * @brief Takes the even light of reports back from meshes of one color that are not inspected.
 *
 * With ParaView's light, faces that are turned away match no color of a legend: Mesh Inspection and
 * the Mesh Inspector set an even one, in which a surface of one color looks flat without edges. It
 * is back when an array colors the mesh again. Another light that a user has chosen stays.
 */
#ifndef pqLegendLightBehavior_h
#define pqLegendLightBehavior_h

#include <QObject>

class pqDataRepresentation;
class pqRepresentation;

class pqLegendLightBehavior : public QObject
{
  Q_OBJECT

public:
  explicit pqLegendLightBehavior(QObject* parent = nullptr);

  ///@{
  /// Called when the plugin is loaded and unloaded.
  void startup();
  void shutdown();
  ///@}

private:
  void follow(pqRepresentation* representation);
};

#endif
