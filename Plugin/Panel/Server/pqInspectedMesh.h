// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqInspectedMesh
 * @brief Which mesh the Mesh Inspector shows, and when it changes.
 *
 * The mesh is the output of the active source, if that has cells. It never comes to the client:
 * tables do, see pqMeshQuestions.
 */
#ifndef pqInspectedMesh_h
#define pqInspectedMesh_h

#include "HelperFilters.h"
#include "MeshOutput.h"

#include "vtkEventQtSlotConnect.h" // for the settings
#include "vtkNew.h"                // for the connector

#include <QObject>
#include <pqTimer.h> // for a delayed signal

class pqPipelineSource;
class pqServer;

class pqInspectedMesh
  : public QObject
  , public camaron::MeshOutput
{
  Q_OBJECT

public:
  explicit pqInspectedMesh(QObject* parent);

  ///@{
  /// Whether to follow the active source; a hidden panel asks for nothing. Default: no.
  void setFollowing(bool follows);
  bool isFollowing() const { return this->IsFollowing; }
  ///@}

  /// The output that is inspected; nullptr if the active source has no cells or was not applied.
  void setPort(pqOutputPort* port);

  /// The output before the steps of selection.
  pqOutputPort* cellsPort() const { return this->CellsPort; }

  /// The output before steps and evaluations.
  pqOutputPort* meshPort() const { return this->MeshPort; }

  /// Message for the user if there is no mesh.
  QString reasonForNone() const;

  /// The server of the mesh, for file dialogs.
  pqServer* server() const;

  /// Looks for the mesh again when the events so far have been handled.
  void findLater() { this->MeshTimer.start(); }
  bool willBeFound() const { return this->MeshTimer.isActive(); }

  ///@{
  /// Version counter of the cells and their data, which steps of selection do not change, and of
  /// the elements, which evaluating criteria does not change, either.
  int cellsVersion() const { return this->CellsVersion; }
  int meshVersion() const { return this->MeshVersion; }
  ///@}

  ///@{
  /// The filters that answer questions about the mesh. While they compute, events must wait.
  camaron::HelperFilters& helpers() const { return this->Helpers; }
  bool isComputing() const { return this->Helpers.isBusy(); }
  ///@}

Q_SIGNALS:
  /// Another mesh, or other data.
  void meshChanged();

  /// At once, while meshChanged follows events.
  void portChanged();
  void cellsPortChanged();
  void followingChanged();

  /// A source will be removed, perhaps that of the mesh.
  void aboutToRemove(pqPipelineSource* source);

  /// The server of everything is going.
  void forgotten();

private:
  /// Follows the active source.
  void findMesh();
  void followCells();
  void forget();

  bool IsFollowing = false;
  QPointer<pqOutputPort> CellsPort;
  QPointer<pqOutputPort> MeshPort;
  QString MeshElements; // type of its elements that are inspected
  int CellsVersion = 0;
  int MeshVersion = 0;
  QString ReasonForNone; // empty if there is no active source
  pqTimer MeshTimer;
  mutable camaron::HelperFilters Helpers;
  vtkNew<vtkEventQtSlotConnect> SettingsConnector;
};

#endif
