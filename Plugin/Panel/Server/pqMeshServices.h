// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqMeshServices
 * @brief The five services of the Mesh Inspector about the mesh, each of which knows those before
 * it: all that cards know of ParaView.
 */
#ifndef pqMeshServices_h
#define pqMeshServices_h

#include <QObject>

class pqInspectedMesh;
class pqMeshDisplay;
class pqMeshFilters;
class pqMeshQuestions;
class pqMeshSelection;

class pqMeshServices : public QObject
{
  Q_OBJECT

public:
  /// The instance of the application, created on first use.
  static pqMeshServices* instance();

  pqInspectedMesh* const Mesh;
  pqMeshQuestions* const Questions;
  pqMeshFilters* const Filters;
  pqMeshSelection* const Selection;
  pqMeshDisplay* const Display;

private:
  explicit pqMeshServices(QObject* parent);
  ~pqMeshServices() override;
};

#endif
