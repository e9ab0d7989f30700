// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqMeshFilters
 * @brief What the Mesh Inspector adds to the pipeline after the mesh, and files about the mesh.
 */
#ifndef pqMeshFilters_h
#define pqMeshFilters_h

#include "InspectedMeshTypes.h"

#include <QMap>
#include <QObject>
#include <QVariant>

class pqInspectedMesh;
class pqMeshQuestions;
class pqOutputPort;
class pqPipelineSource;
class vtkSMSourceProxy;

class pqMeshFilters : public QObject
{
  Q_OBJECT

public:
  pqMeshFilters(pqInspectedMesh* mesh, pqMeshQuestions* questions, QObject* parent);

  ///@{
  /// Estimated seconds for evaluating criteria of the mesh, or what Element Quality with these
  /// criteria and this preset takes for an input; 0 if unknown.
  double estimatedSeconds(const QStringList& names) const;
  double estimatedSeconds(
    const QVariantList& ticks, const QString& preset, vtkSMSourceProxy* input, int port) const;
  ///@}

  /**
   * Evaluates exactly these criteria of a type of elements, with the one Element Quality or Mesh
   * Elements of the panel: the one whose output is inspected, else one that has the mesh as input,
   * else a new one. It becomes the active source and replaces its input in the view.
   */
  void evaluate(const QStringList& names, const QString& elementType = "Cell");
  bool isEvaluating() const { return this->IsEvaluating; }

  /// Evaluates a criterion besides those that the mesh has, if it is missing.
  void evaluateAlso(const QString& name);

  /// Inspects the cells, faces, edges or vertices that belong to the mesh, if they have been
  /// created.
  void showElements(const QString& elementType);

  /// Shows an output of the Quality Statistics of these arrays, which is created if necessary, in a
  /// view of its own: "SpreadSheetView" or "XYBarChartView".
  void showStatistics(const QStringList& arrays, int table, const QString& viewType);

  /// Creates a filter on the mesh as the Filters menu does, applied, with properties; nullptr on
  /// failure. It replaces the mesh in the view and becomes active. With a negative shownPort, it
  /// shows nothing and has the cells before the steps of selection as input.
  pqPipelineSource* addFilter(
    const QString& name, const QMap<QString, QVariant>& properties, int shownPort = 0);

  /// Changes properties of a filter and applies them.
  void changeFilter(pqPipelineSource* source, const QMap<QString, QVariant>& properties);

  /// Makes an output the mesh, and the active source, and shows it instead of the mesh before.
  void inspect(pqOutputPort* port);

  /// @name Files
  ///@{
  /// Writes statistics, histograms and worst cells as CSV files to a folder, a new one or that of
  /// one of these tables; returns what to tell the user.
  QString saveTables(const QString& path) const;

  /// Writes a file of the client, but not over one from which the mesh was read; returns an error.
  QString writeText(const QString& path, const QByteArray& content) const;

  /// Writes the selected elements to a file of the server, ".csv" or any mesh, or of this computer,
  /// ".txt" or an OpenFOAM set in a folder "sets". Returns an error, empty if written.
  /// The rows of a table of cells are sorted by a criterion, worst first, or by another array.
  QString exportSelection(const QString& path, bool onServer, const QString& criterion) const;

  /// Writes the report of `camaron inspect` to a folder of this computer, which needs Python.
  /// Returns an error, empty if written.
  QString saveReport(const QString& folder, const camaron::ReportRequest& request) const;
  bool canSaveReport() const;

  /// Where a report is written unless the user gives a folder: beside the mesh, or at home.
  QString reportFolder() const;
  ///@}

Q_SIGNALS:
  /// Criteria will be evaluated, which takes about this time: 0 if that is not known.
  void evaluating(double seconds);

private:
  /// Writes an output with the server's writer for the extension of a path; returns an error.
  QString write(vtkSMSourceProxy* source, int port, const QString& path) const;

  /// The value of the list of arrays of Mesh Elements.
  QVariantList elementTicks(const QStringList& names, const QString& elementType) const;

  /// Shows an output instead of another one in the active view, with the same look.
  void replaceInView(pqOutputPort* shown, pqOutputPort* before);

  pqInspectedMesh* Mesh;
  pqMeshQuestions* Questions;
  bool IsEvaluating = false;
};

#endif
