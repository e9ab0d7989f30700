// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::LargeSelection
 * @brief Draws what a brush selects: everything else is gray. Of a large mesh, it has the color of
 * selections.
 *
 * ParaView copies and outlines each selected element instead, which takes seconds and gigabytes for
 * some hundred thousand. Only the server's representation changes, not its properties: nothing of
 * it is in states, traces and undo.
 */
#ifndef camaron_LargeSelection_h
#define camaron_LargeSelection_h

#include "PastSelection.h"        // for brushes
#include "pqDataRepresentation.h" // for a pointer to it

#include "vtkSMSourceProxy.h" // for a pointer to it
#include "vtkSmartPointer.h"  // for the selection

#include <QPair>
#include <QPointer>
#include <QVector>

namespace camaron
{
class LargeSelection
{
public:
  /// More elements than this are many.
  static constexpr qint64 Least = 10000;

  ~LargeSelection() { this->hide(); }

  /// Emphasizes this selection of the mesh, which brushes make.
  void show(
    pqDataRepresentation* mesh, vtkSMSourceProxy* selection, const QVector<BrushedValues>& brushes);

  /// Emphasizes a range of the values that color the mesh, while a brush is dragged.
  void preview(pqDataRepresentation* mesh, const QPair<double, double>& range);

  /// Whether it is drawn of this mesh.
  bool isOf(const pqDataRepresentation* mesh) const { return mesh && mesh == this->Mesh; }

  /// Whether the mesh still has that selection.
  bool isActive() const;

  /// Draws the mesh and its selection as its properties say.
  void hide();

private:
  void follow(pqDataRepresentation* mesh);
  void draw(
    const QVector<BrushedValues>& brushes, int emphasis, const QPair<double, double>& range) const;

  QPointer<pqDataRepresentation> Mesh;
  vtkSmartPointer<vtkSMSourceProxy> Selection;
};
}

#endif
