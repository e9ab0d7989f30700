// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqMeshQuestions
 * @brief What the Mesh Inspector asks the server about the mesh: criteria, tables, verdicts.
 *
 * Answers are tables of at most a few thousand rows, computed by camaron::HelperFilters.
 *
 * Calls that compute block the window as ParaView's Apply does, with its progress bar. They are
 * made on request of the user, or by themselves for small meshes, see MeshOutput::isSmall().
 */
#ifndef pqMeshQuestions_h
#define pqMeshQuestions_h

#include "InspectedMeshTypes.h"

#include <QMap>
#include <QObject>

#include <optional> // for the summary

class pqInspectedMesh;
class pqOutputPort;

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

  /// One-component cell arrays that are no criteria, such as a temperature, for histograms.
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
  /// Statistics and histograms of arrays of the mesh, in their order, without missing ones; or of
  /// another mesh, also if the panel is hidden.
  QVector<camaron::Distribution> distributions(const QStringList& arrays,
    const camaron::DistributionRequest& request, pqOutputPort* other = nullptr) const;

  /// Other meshes that have the array, and their names.
  QVector<QPair<QString, pqOutputPort*>> otherMeshes(const QString& array) const;

  /// The worst cells of a criterion, as in table 2 of Quality Statistics.
  camaron::PanelTable worst(const QString& array, int number) const;

  /// Connected groups of cells outside a range, largest first; see Quality Regions.
  camaron::PanelTable regions(
    const QString& array, int number, const camaron::Limits& limits) const;

  /// The element with an id, judged by acceptable ranges or, as lines, by those of the user.
  camaron::ElementInfo element(qint64 id, const QString& idSpace, const QStringList& ranges) const;

  /// Where an element is; not finite if there is no such element, or its points are not finite.
  camaron::Location locate(qint64 id, const QString& idSpace) const;

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

Q_SIGNALS:
  /// The registry of another server.
  void registryChanged();

private:
  /// An output of the server's Criteria Table.
  const camaron::PanelTable& registry(int port) const;

  pqInspectedMesh* Mesh;
  mutable std::optional<camaron::MeshSummary> Summary; // of the data so far
  mutable QMap<int, camaron::PanelTable> Registry;
  mutable QVector<camaron::CriterionInfo> Criteria;
  mutable QVector<camaron::PresetInfo> Presets;
};

#endif
