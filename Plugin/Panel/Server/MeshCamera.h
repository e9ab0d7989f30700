// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MeshCamera
 * @brief Flies the camera to elements of the inspected mesh and back, so that one sees where it
 * goes, marks the element, and opens the mesh around it.
 */
#ifndef camaron_MeshCamera_h
#define camaron_MeshCamera_h

#include "ElementMarker.h"
#include "InspectedMeshTypes.h"

#include <QCoreApplication> // for translations
#include <QPointer>
#include <QVariantAnimation> // for the flight

#include <functional> // for what follows
#include <optional>   // for locations

class pqDataRepresentation;
class pqInspectedMesh;
class pqMeshDisplay;
class pqOutputPort;

namespace camaron
{
class MeshCamera
{
  Q_DECLARE_TR_FUNCTIONS(MeshCamera)

public:
  MeshCamera(pqInspectedMesh* mesh, pqMeshDisplay* display)
    : Mesh(mesh)
    , Display(display)
  {
  }

  /// Moves it to a location, marks what is there and, if `open`, cuts the mesh around it.
  /// An element whose points are not all finite has no location: nothing moves.
  void flyTo(const Location& location, bool open);

  /// Draws only the selected elements, inside the glass shell of the mesh, and moves the camera to
  /// where they are, if that is known.
  void showSelected(const std::optional<Location>& location);

  ///@{
  /// Restores camera and display as they were before flyTo or showSelected, without the mark.
  void flyBack();
  bool canFlyBack() const;
  ///@}

  /// Takes the mark away.
  void unmark();

  /// The same, and forgets what to go back to.
  void forget()
  {
    this->unmark();
    this->Before.reset();
  }

private:
  /// What a flight to an element changes, to restore it.
  struct BeforeFlight
  {
    QPointer<pqRenderView> View;
    QVector<double> Camera;
    QPointer<pqOutputPort> Cells;
    QPointer<pqDataRepresentation> Drawn; // whose display was changed
    QMap<QString, QVariant> Properties;   // of it; empty if it was not changed
    QString CutShape;
  };

  /// Where undo and redo go.
  struct Place
  {
    QPointer<pqRenderView> View;
    QVector<double> Camera;
    QPointer<pqOutputPort> Cells;
    std::optional<Location> Marked;
    std::optional<BeforeFlight> Before;
  };

  /// Moves the camera of a view; then something may happen. It waits while the mesh is computed.
  void start(
    pqRenderView* view, const QVector<double>& camera, const std::function<void()>& arrive = {});
  void stop();
  void end(pqRenderView* view, const QVector<double>& camera, const std::function<void()>& arrive);

  /// Before the first flight, and before a mesh is opened, unless it is open already.
  void rememberCamera(pqRenderView* view);
  void rememberDisplay();
  void closeDisplay();

  void mark(pqRenderView* view, const Location& location);

  ///@{
  /// Undo of the camera's ways, with the mark: where it is, or where the present flight began; adds
  /// a way from there to the present step of undo; and goes a way again.
  Place here(pqRenderView* view) const;
  void recordWay(const Place& from, const QVector<double>& camera);
  void goTo(const Place& place);
  ///@}

  pqInspectedMesh* Mesh;
  pqMeshDisplay* Display;
  QPointer<QVariantAnimation> Animation;
  Place From; // of the flight that is under way
  std::optional<BeforeFlight> Before;
  ElementMarker Marker{ "GeometryRepresentation" };
  std::optional<Location> Marked;
};
}

#endif
