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

#include "InspectionModes.h"
#include "pqInspectorCard.h"

#include <QMap>
#include <QVariant>

#include <functional> // for sliders

class QComboBox;
class QGridLayout;
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
  /// Adds the switches and the kinds of cuts that the server declares, once it has the plugin.
  void makeModes();
  void makeCut();
  void makeSliders();
  /// `spell` returns the value at a share of the slider's range.
  QSlider* addSlider(QHBoxLayout* row, const char* name, const QString& label, const QString& tip,
    const std::function<QString(double share)>& spell);

  using Properties = QMap<QString, QVariant>;
  /// Sets properties of Mesh Inspection, or of the cut, for the position of the slider, as one
  /// undoable step.
  void connectSlider(QSlider* slider, const std::function<Properties(double share)>& toProperties);

  ///@{
  /// Moves the cut to the position of its slider.
  void cut();
  /// The same, from where the cut is by default.
  void cutAnew();
  void cutAcross(int axis);
  Properties cutValues() const;
  /// Shows the cut as it is, perhaps as its handles or the Properties panel placed it.
  void showCut();
  ///@}
  void showPlain();

  Properties Before; ///< a slider was pressed
  struct Mode : camaron::InspectionMode
  {
    QToolButton* Button;
  };
  QList<Mode> Modes;
  QGridLayout* ModeButtons;
  /// The size of the cut in the unit of the mesh, or the coordinate of a plane.
  QString spellCut() const;
  double isosurfaceAt(double share) const;

  QList<std::function<void()>> Spellings; ///< show the values of the sliders
  int Axis = -1;    ///< of the normal of a new plane; negative: along the longest side of the mesh
  Properties Cut;   ///< as it was last shown; empty without one
  int CutPlace = 0; ///< of its slider then
  int CutMesh = 0;  ///< its version
  QList<QToolButton*> Axes;
  QToolButton* Handles = nullptr;
  QToolButton* Flip = nullptr;
  QComboBox* CutShape;
  QComboBox* CutBy;
  QSlider* CutPosition = nullptr;
  QSlider* Shrink = nullptr;
  QSlider* Explode = nullptr;
  QSlider* Isosurface = nullptr;
};

#endif
