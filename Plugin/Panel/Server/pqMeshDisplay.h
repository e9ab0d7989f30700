// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqMeshDisplay
 * @brief How the inspected mesh is drawn in the active view: colors, cuts, and the camera.
 */
#ifndef pqMeshDisplay_h
#define pqMeshDisplay_h

#include "InspectedMeshTypes.h"

#include <QMap>
#include <QObject>

#include <memory>   // for members
#include <optional> // for locations

namespace camaron
{
class MeshColors;
}
class pqInspectedMesh;
class pqMeshQuestions;
class pqMeshSelection;
class pqRenderView;

class pqMeshDisplay : public QObject
{
  Q_OBJECT

public:
  pqMeshDisplay(
    pqInspectedMesh* mesh, pqMeshQuestions* questions, pqMeshSelection* selection, QObject* parent);
  ~pqMeshDisplay() override;

  ///@{
  /// Whether Mesh Inspection draws the mesh in the active view, or could.
  bool isInspected() const;
  bool canInspect() const;
  ///@}

  /// A property of the representation: a number, a text, or a list of them; invalid if the mesh is
  /// not shown.
  QVariant value(const QString& property) const;

  /// Sets properties of Mesh Inspection, switching to it if necessary, as one undoable step.
  void set(const QMap<QString, QVariant>& properties);

  /// The same, but only while the mouse moves: no trace, no undo.
  void preview(const QMap<QString, QVariant>& properties);

  /// Emphasizes a range of the values that color the mesh, until showSelection.
  void previewBrush(double low, double high);

  /// Lets selected elements shine through the mesh in the view, unless they are many or drawn
  /// alone; if many, and selected by values, everything else is gray.
  void showSelection();

  /// @name The cut
  ///@{
  /// Its shape: "Plane", "CuttingSphere", "CuttingBox" or "HalfSpaces".
  QString cutShape() const;

  /// Chooses the shape, and sets its properties.
  void setCut(const QString& shape, const QMap<QString, QVariant>& values);

  /// Properties of the shape.
  QMap<QString, QVariant> cut(const QStringList& names) const;

  /// As setCut for the present shape, but only while the mouse moves: no trace, no undo.
  void previewCut(const QMap<QString, QVariant>& values);

  /// Whether it can have handles in the view: the Properties panel has the display of the mesh.
  bool hasCutHandles() const;
  ///@}

  /// Its color map, and its legend.
  camaron::MeshColors& colors();

  /// Point array of isosurfaces, empty without one, and the range of its values.
  QString isosurfaceArray() const;
  QPair<double, double> isosurfaceRange() const;

  /// @name The camera
  ///@{
  /// Moves it to a location, marks what is there and, if `open`, cuts the mesh around it.
  /// An element whose points are not all finite has no location: nothing moves.
  void flyTo(const camaron::Location& location, bool open);

  /// Draws only the selected elements, inside the glass shell of the mesh, and moves the camera to
  /// where they are, if that is known.
  void showSelected(const std::optional<camaron::Location>& location);

  /// Restores camera and display as they were before flyTo or showSelected, without the mark.
  void flyBack();
  bool canFlyBack() const;
  ///@}

Q_SIGNALS:
  /// The view, the representation or its properties.
  void displayChanged();

protected:
  /// The legend keeps its place when the view gets another size.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  struct BeforeFlight;
  struct Place;

  void followDisplay();

  /// Before the first flight, and before a mesh is opened, unless it is open already.
  void rememberCamera(pqRenderView* view);
  void rememberDisplay();
  void closeDisplay();

  /// Marks the element at a location.
  void mark(pqRenderView* view, const camaron::Location& location);

  ///@{
  /// Undo of the camera's ways, with the mark: where it is, or where the present flight began; adds
  /// a way from there to the present step of undo; and goes a way again.
  Place here(pqRenderView* view) const;
  void recordWay(const Place& from, const QVector<double>& camera);
  void goTo(const Place& place);
  ///@}

  pqInspectedMesh* Mesh;
  pqMeshQuestions* Questions;
  pqMeshSelection* Selection;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
