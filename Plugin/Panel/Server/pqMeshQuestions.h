// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqMeshQuestions
 * @brief What the Mesh Inspector asks the server about the mesh: criteria, tables, verdicts.
 *
 * Answers are tables of at most a few thousand rows, which the server's filters compute. These
 * filters stay unregistered, so states and traces contain what the user created.
 *
 * Calls that compute block the window as ParaView's Apply does, with its progress bar. They are
 * made on request of the user, or by themselves for small meshes, see MeshOutput::isSmall().
 */
#ifndef pqMeshQuestions_h
#define pqMeshQuestions_h

#include "HelperFilters.h"
#include "InspectedMeshTypes.h"

#include <QMap>
#include <QObject>

#include <optional> // for the summary

class pqInspectedMesh;
class pqOutputPort;
class vtkSMSourceProxy;

class pqMeshQuestions : public QObject
{
  Q_OBJECT

public:
  pqMeshQuestions(pqInspectedMesh* mesh, QObject* parent);

  /// Counts, bounds, memory and names.
  camaron::MeshSummary summary() const;

  /// @name Arrays
  ///@{
  /// Names of the criteria that the mesh has as cell arrays, in the order of the registry.
  QStringList evaluated() const;

  /// The worst criterion of this mesh according to Element Quality, else the first criterion.
  QString worstCriterion() const;

  /// One-component cell arrays that are no criteria, such as a temperature: histograms show them,
  /// too.
  QStringList otherArrays() const;

  /// One-component cell arrays of categories, such as Material: whole numbers but neither ids nor
  /// criteria.
  QStringList groupArrays() const;
  ///@}

  /// @name The server's registry of criteria
  ///@{
  const QVector<camaron::CriterionInfo>& criteria() const;
  /// The criterion of the elements of the mesh, else the first one with this name.
  const camaron::CriterionInfo* criterion(const QString& name) const;
  const QVector<camaron::PresetInfo>& presets() const;

  /// Presets that judge none of the cells of the mesh: why, by their names.
  QMap<QString, QString> unfitPresets() const;

  /// Bits of CellStatus: columns Bit, Name, Description, Invalid.
  const camaron::PanelTable& statusBits() const { return this->registry(4); }
  ///@}

  /// @name Tables
  ///@{
  /// Statistics and histograms of arrays of the mesh or of another one, in their order; missing
  /// arrays are left out.
  QVector<camaron::Distribution> distributions(const QStringList& arrays,
    const camaron::DistributionRequest& request, const QString& otherMesh = QString()) const;

  /// The same for an array of any output, also if the panel is hidden.
  camaron::Distribution distribution(
    pqOutputPort* port, const QString& array, const camaron::DistributionRequest& request) const;

  /// Names of other sources that have the array.
  QStringList otherMeshes(const QString& array) const;

  /// The worst cells of a criterion, as in table 2 of Quality Statistics.
  camaron::PanelTable worst(const QString& array, int number) const;

  /// Connected groups of cells outside a range, largest first; see Quality Regions.
  camaron::PanelTable regions(
    const QString& array, int number, const camaron::Limits& limits) const;

  /// The cell with an id and all its arrays, then its neighbors across faces.
  camaron::PanelTable elementWithNeighbors(qint64 id, const QString& idSpace) const;

  /// Criteria whose acceptable range a cell violates.
  QStringList failing(qint64 id, const QString& idSpace, const QStringList& ranges) const;

  /// Where an element is; not finite if there is no such element, or its points are not finite.
  camaron::Location locate(qint64 id, const QString& idSpace) const;

  /// The shapes of the cells by their topology, as types of VTK such as "Hexahedron", also for
  /// polyhedra that have it.
  QStringList shapes() const;

  /// Whether all cells of a small mesh are polygons: neighbors share edges then.
  bool isSurface() const;

  /// Cells by type, and by value of CellStatus, evaluated for this if the mesh lacks it.
  camaron::ValidityInfo validity() const;

  /// The verdicts on rules, with the worst cell of each.
  camaron::CheckResult check(const camaron::CheckRequest& request) const;

  /// How the criteria of the mesh were evaluated: options of its Element Quality, or the default
  /// ones. Check Quality and Select Elements have the same properties.
  QMap<QString, QVariant> evaluationOptions() const;

  /// The id of the first selected element in MeshOutput::idSpace(); empty if there is none.
  QString selectedId() const;
  ///@}

  /// @name Filters that answer questions of others
  ///@{
  /// A filter with the mesh or an output of another helper as input; the key as for HelperFilters.
  camaron::Helper filterHelper(
    const char* name, const char* key = "", vtkSMSourceProxy* input = nullptr) const;

  /// The same with the cells before the steps of selection as input, so that a step computes
  /// nothing again.
  camaron::Helper cellsHelper(const char* name, const char* key = "") const;

  /// Select Elements that marks "Cells" or "Points" in the array Selected: with the strategy
  /// "Current", those of the active selection; nullptr without a mesh.
  camaron::Helper marked(const QString& strategy, const QString& elements) const;

  /// Number of elements that a strategy marks, without ghosts.
  qint64 count(const QString& strategy, const QString& elements) const;

  /// The elements of a location.
  camaron::Helper extracted(const camaron::Location& location, const char* key) const;
  ///@}

Q_SIGNALS:
  /// The registry of another server.
  void registryChanged();

private:
  /// An output of the server's Criteria Table.
  const camaron::PanelTable& registry(int port) const;

  /// What Quality Statistics computes for a request.
  QVector<camaron::Distribution> fetchDistributions(vtkSMSourceProxy* statistics,
    const QStringList& arrays, const camaron::DistributionRequest& request, bool hasWeights) const;

  /// Cells by "Cell type", or by the value of a criterion ("Cell array"), which is evaluated for
  /// this if the mesh lacks it.
  QVector<camaron::ValidityInfo::NamedCount> countGroups(
    const QString& array, const QString& groupBy) const;

  pqInspectedMesh* Mesh;
  mutable std::optional<camaron::MeshSummary> Summary; // of the data so far
  mutable QMap<int, camaron::PanelTable> Registry;
  mutable QVector<camaron::CriterionInfo> Criteria;
  mutable QVector<camaron::PresetInfo> Presets;
};

#endif
