// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqCriteriaCard
 * @brief Card "Criteria": which criteria to evaluate, and their results.
 *
 * Ticks are evaluated with one Element Quality filter (for faces, edges and vertices with one Mesh
 * Elements filter): by themselves for small meshes, see MeshOutput::isSmall(), else
 * when the user clicks *Evaluate*. A click on a criterion shows its histogram and colors the mesh.
 */
#ifndef pqCriteriaCard_h
#define pqCriteriaCard_h

#include "InspectedMeshTypes.h"
#include "pqInspectorCard.h"

#include <pqTimer.h> // for delays

class pqCriteriaTree;
class pqSearchBox;
class QComboBox;
class QLabel;
class QPushButton;

class pqCriteriaCard : public pqInspectorCard
{
  Q_OBJECT
  typedef pqInspectorCard Superclass;

public:
  pqCriteriaCard(pqInspectorState* state, QWidget* parent);

protected:
  void refresh() override;

private:
  QString elementType() const;
  void fillTree();
  void tickPreset();

  /// The criteria of the tree that the mesh has.
  QStringList shownCriteria() const;
  /// Small histograms, with the selected elements in stronger colors.
  void showDistributions();
  /// Shows the preset that has the ticked criteria, if there is one.
  void showPreset();
  void onTicksChanged();
  /// The button is there only if something waits for it.
  void showEvaluate();
  void evaluate();
  void choose(const QString& name);

  QComboBox* Elements;
  QComboBox* Preset;
  pqSearchBox* Search;
  pqCriteriaTree* Tree;
  QLabel* Cost;
  QPushButton* Evaluate;
  int TickedMesh = 0; // its version
  pqTimer Delay;
  pqTimer AfterPicture;       ///< the selection is drawn before all criteria of it are asked for
  QString ShownType = "Cell"; ///< of the mesh
  bool HasUserTicks = false;  ///< ticks that are not evaluated yet
};

#endif
