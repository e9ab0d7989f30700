// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqCriteriaWidget
 * @brief Panel widget of a list of criteria: labels by family, with search and tooltips.
 *
 * For properties that are lists of names and ticks, such as Criteria of Element Quality. The
 * server lists the criteria.
 */
#ifndef pqCriteriaWidget_h
#define pqCriteriaWidget_h

#include "pqPropertyWidget.h"

class pqCriteriaTree;

class pqCriteriaWidget : public pqPropertyWidget
{
  Q_OBJECT
  typedef pqPropertyWidget Superclass;

public:
  pqCriteriaWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);

  void apply() override;
  void reset() override;

private Q_SLOTS:
  void showProperty();

private:
  bool HasChanges = false; ///< ticks of the user that are not applied yet
  pqCriteriaTree* Tree;
};

#endif
