// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MeshColors
 * @brief The color map of the inspected mesh and its legend: those of a criterion, see
 * vtkQualityColors, unless the user has chosen others.
 */
#ifndef camaron_MeshColors_h
#define camaron_MeshColors_h

#include "InspectedMeshTypes.h"

#include <QCoreApplication> // for translations
#include <QMap>
#include <QVariant>

class pqInspectedMesh;
class pqMeshQuestions;
class vtkSMProxy;

namespace camaron
{
/// The type of representation that shows the colors of criteria.
constexpr const char* InspectionName = "Mesh Inspection";

class MeshColors
{
  Q_DECLARE_TR_FUNCTIONS(MeshColors)

public:
  MeshColors(pqInspectedMesh* mesh, pqMeshQuestions* questions)
    : Mesh(mesh)
    , Questions(questions)
  {
  }

  /// The color map; nullptr without one.
  vtkSMProxy* map() const;

  /// Whether Mesh Inspection draws the mesh, which tells cells apart that no range judges.
  bool areOfInspection() const;

  /// Cell array that colors the mesh; empty if none does.
  QString array() const;

  /// Whether the mesh is colored by an array, and has got its colors from colorBy.
  bool areOf(const QString& array) const;

  /// Colors the mesh by a criterion or by another array, as one undoable step. Without limits, the
  /// acceptable range of the criterion is marked. Colors that the user has changed stay.
  void colorBy(const QString& array, const Limits& limits = {});

  /// Marks other limits in the colors of a criterion, if it colors the mesh.
  void judgeBy(const QString& array, const Limits& limits);

  /// Fits the colors of a criterion to new values, as of another time step.
  void refit();

  /// Shows the legend again if undo has taken it away, at its place, and with the labels of the
  /// color map; the legend, nullptr without one.
  vtkSMProxy* updateLegend();

  ///@{
  /// Forgets which color maps are those of criteria; perhaps undo has changed them.
  void forget() { this->Colored.clear(); }
  void forgetUndone()
  {
    this->forget();
    this->IsUndone = true;
  }
  ///@}

private:
  /// A color map that a criterion has got: its points, and what they depend on.
  struct OwnColors
  {
    QVariant Points;
    QPair<double, double> Acceptable;
    bool HasUndefined = false;
    bool HasNotJudged = false;      ///< cells that its acceptable range is not for
    QMap<QString, QVariant> Legend; ///< properties of its legend
  };

  /// What a legend has got here.
  struct PlacedLegend
  {
    QVariant Place;
    QVariant ColorBehind;
  };

  vtkSMProxy* legend() const;
  /// Whether they are those of a criterion, and nobody has changed them.
  bool areOwn() const;
  /// Whether they may become those of a criterion.
  bool mayColor() const;
  /// Sets by what they judge: the limits, for all cells, or the acceptable range.
  OwnColors& judge(const Distribution& values, const Limits& limits);
  /// Fits the color map of the criterion to the values of the mesh.
  void fit();
  /// Tells cells apart that no range judges.
  void markNotJudged(bool areMarked);
  void placeLegend();

  pqInspectedMesh* Mesh;
  pqMeshQuestions* Questions;
  QMap<quint32, PlacedLegend> Legends; // by their ids
  bool HasLegend = false;              // the last colors of the mesh
  bool IsUndone = false;               // or redone, since the legend was updated
  QMap<quint32, OwnColors> Colored;    // by the ids of color maps
};
}

#endif
