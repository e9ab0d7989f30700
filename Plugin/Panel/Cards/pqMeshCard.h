// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqMeshCard
 * @brief Card "Mesh": counts by cell type, bounds, memory, and whether the cells are valid.
 *
 * Validity is computed by itself for small meshes, see MeshOutput::isSmall(), else on
 * request. A click on the line of a defect selects its cells.
 */
#ifndef pqMeshCard_h
#define pqMeshCard_h

#include "InspectedMeshTypes.h"
#include "pqInspectorCard.h"

class QLabel;
class QPushButton;

class pqMeshCard : public pqInspectorCard
{
  Q_OBJECT
  typedef pqInspectorCard Superclass;

public:
  pqMeshCard(pqInspectorState* state, QWidget* parent);

protected:
  void refresh() override;
  void recolor() override;

private:
  void validate();
  void showValidity();

  QLabel* Counts;
  QLabel* Bounds;
  QLabel* Types;
  QLabel* Validity;
  QPushButton* Validate;
  camaron::ValidityInfo Found;
  int ValidatedVersion = -1; ///< of the cells with what was found
};

#endif
