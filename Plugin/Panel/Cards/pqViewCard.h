// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqViewCard
 * @brief Card "View": what Mesh Inspection draws, as switches and sliders.
 *
 * The values are properties of the representation, which its panel shows in full; this card has
 * those that change often. *Plain* returns to a surface with edges.
 */
#ifndef pqViewCard_h
#define pqViewCard_h

#include "pqInspectorCard.h"

class QComboBox;
class QSlider;
class QToolButton;

class pqViewCard : public pqInspectorCard
{
  Q_OBJECT
  typedef pqInspectorCard Superclass;

public:
  pqViewCard(pqInspectorState* state, QWidget* parent);

protected:
  void refresh() override;

private:
  Q_DISABLE_COPY(pqViewCard)

  void makeModes();
  void makeCut();
  void makeSliders();
  QSlider* addSlider(const char* name, const QString& label, const QString& tip);
  void cut();
  void showPlain();

  /// Position along the diagonal of the mesh or the axis of the cut, 0 to 1.
  double position() const;

  QList<QToolButton*> Modes;
  QComboBox* CutShape;
  QComboBox* CutBy;
  QSlider* CutPosition;
  QSlider* Shrink;
  QSlider* Explode;
  QSlider* Isosurface;
};

#endif
