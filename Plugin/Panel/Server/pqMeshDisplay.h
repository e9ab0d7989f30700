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

#include <memory> // for members

namespace camaron
{
class MeshCamera;
class MeshColors;
}
class pqInspectedMesh;
class pqMeshQuestions;
class pqMeshSelection;

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

  /// The camera: flights to elements and back.
  camaron::MeshCamera& camera();

Q_SIGNALS:
  /// The view, the representation or its properties.
  void displayChanged();

protected:
  /// The legend keeps its place when the view gets another size.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void followDisplay();

  pqInspectedMesh* Mesh;
  pqMeshSelection* Selection;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
