// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLegendLightBehavior
 * @brief Gives meshes that an array colors an even light, and those of one color ParaView's.
 *
 * With ParaView's light, faces that are turned away match no color of the legend; with the even
 * one, a mesh of one color looks flat. The light changes with the coloring, wherever a user changes
 * that, and whether or not the Mesh Inspector is visible. Another light that a user has chosen
 * stays.
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
  Q_DISABLE_COPY(pqLegendLightBehavior)

  void follow(pqRepresentation* representation);
};

#endif
