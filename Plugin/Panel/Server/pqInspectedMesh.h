// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqInspectedMesh
 * @brief The mesh that the Mesh Inspector shows: everything that the panel asks of the server.
 *
 * Cards ask the server nothing except through it. The mesh is the output of the active source, if
 * that has cells. It never comes to the client: tables do, which the server's filters compute from
 * it and which have at most a few thousand rows. Filters that only answer a question stay
 * unregistered, so states and traces contain what the user created: Element Quality and Select
 * Elements.
 *
 * Calls that compute block the window as ParaView's Apply does, with its progress bar. They are
 * made on request of the user, or by themselves for meshes up to automaticLimit() cells.
 *
 * The implementation has one file per subject: pqInspectedMesh.cxx (which mesh),
 * pqInspectedMeshData.cxx (counts and arrays), pqInspectedMeshRegistry.cxx (criteria),
 * pqInspectedMeshTables.cxx (tables and distributions), pqInspectedMeshAnswers.cxx (validity,
 * elements, verdicts), pqInspectedMeshElements.cxx (cells, faces, edges, vertices),
 * pqInspectedMeshFilters.cxx (filters in the pipeline), pqInspectedMeshSelection.cxx (the active
 * selection), pqInspectedMeshSteps.cxx (steps of selection), pqInspectedMeshHistory.cxx (past
 * selections), pqInspectedMeshFiles.cxx (exports), pqInspectedMeshView.cxx (display),
 * pqInspectedMeshCamera.cxx (flights).
 */
#ifndef pqInspectedMesh_h
#define pqInspectedMesh_h

#include "DisplayState.h"
#include "ElementMarker.h"
#include "HelperFilters.h"
#include "HistogramBrush.h"
#include "InspectedMeshTypes.h"
#include "PastSelection.h"

#include "vtkEventQtSlotConnect.h" // for the representation
#include "vtkNew.h"                // for the connector
#include "vtkSmartPointer.h"       // for helper proxies

#include <QMap>
#include <QObject>
#include <QPointer>          // for the port
#include <QVariantAnimation> // for the flight
#include <pqTimer.h>         // for delayed signals

#include <functional> // for what follows a flight
#include <optional>   // for the summary

class pqDataRepresentation;
class pqOutputPort;
class pqPipelineSource;
class pqRenderView;
class pqServer;
class vtkPVDataInformation;
class vtkSMProxy;
class vtkSMSourceProxy;

class pqInspectedMesh : public QObject
{
  Q_OBJECT

public:
  /// The instance of the application, created on first use.
  static pqInspectedMesh* instance();

  /// @name Which mesh
  ///@{
  /// Whether to follow the active source; a hidden panel asks for nothing. Default: no.
  void setFollowing(bool follows);

  /// The output that is inspected; nullptr if the active source has no cells or was not applied.
  pqOutputPort* port() const;

  /// Message for the user if there is no mesh.
  QString reasonForNone() const;

  /// The server of the mesh, for file dialogs.
  pqServer* server() const;

  /// Counts, bounds, memory and arrays, which the client has.
  camaron::MeshSummary summary() const;

  /// Element type of the cells of the mesh: "Cell", or "Face", "Edge" or "Vertex" of Mesh Elements.
  QString elementType() const;

  ///@{
  /// Name of one and of several elements in texts, such as "face" and "faces".
  QString element() const;
  QString elements() const;
  ///@}

  /// Names of the criteria that the mesh has as cell arrays, in the order of the registry.
  QStringList evaluated() const;

  /// The worst criterion of this mesh according to Element Quality, else the first criterion.
  QString worstCriterion() const;

  /// One-component cell arrays of the mesh.
  QStringList cellArrays() const;

  /// One-component cell arrays that are no criteria, such as a temperature: histograms show them,
  /// too.
  QStringList otherArrays() const;

  /// One-component cell arrays of categories, such as Material: whole numbers but neither ids nor
  /// criteria.
  QStringList groupArrays() const;

  /// Whether the mesh is small enough for computations without request.
  bool isSmall() const;

  /// Number of cells up to which the panel computes by itself, from ParaView's settings.
  qint64 automaticLimit() const;

  /// Version counter of the cells and their data; steps of selection do not change it.
  int cellsVersion() const { return this->CellsVersion; }

  /// Version counter of the elements; evaluating criteria does not change it, either.
  int meshVersion() const { return this->MeshVersion; }

  /// How tables of the server identify elements: "Global id" if the mesh has them, else "Index".
  QString idSpace() const;

  /// Whether the server computes for the panel; events that arrive meanwhile must wait.
  bool isComputing() const { return this->Helpers.isBusy(); }

  /// Whether evaluate() computes criteria.
  bool isEvaluating() const { return this->IsEvaluating; }
  ///@}

  /// @name The server's registry of criteria
  ///@{
  const QVector<camaron::CriterionInfo>& criteria() const;
  /// The criterion of the elements of the mesh, else the first one with this name.
  const camaron::CriterionInfo* criterion(const QString& name) const;
  const QVector<camaron::PresetInfo>& presets() const;

  /// Names of presets that judge the shape of none of the cells of the mesh.
  QStringList unfitPresets() const;

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
  camaron::PanelTable element(qint64 id, const QString& idSpace) const;

  /// Criteria whose acceptable range a cell violates.
  QStringList failing(qint64 id, const QString& idSpace) const;

  /// The shapes of the cells by their topology, as types of VTK such as "Hexahedron", also for
  /// polyhedra that have it.
  QStringList shapes() const;

  /// Cells by type, and by value of CellStatus, evaluated for this if the mesh lacks it.
  camaron::ValidityInfo validity() const;

  /// The verdicts on rules, with the worst cell of each.
  camaron::CheckResult check(const camaron::CheckRequest& request) const;
  ///@}

  /// @name Filters in the pipeline
  ///@{
  /// Estimated seconds for evaluating criteria; 0 if unknown.
  double estimatedSeconds(const QStringList& names) const;

  /**
   * Evaluates exactly these criteria of an elementType(), with the one Element
   * Quality or Mesh Elements of the panel: the one whose output is inspected, else one that has the
   * mesh as input, else a new one. It becomes the active source and replaces its input in the view.
   */
  void evaluate(const QStringList& names, const QString& elementType = "Cell");

  /// Inspects the cells, faces, edges or vertices that belong to the mesh, if they have been
  /// created.
  void showElements(const QString& elementType);

  /// Shows an output of the Quality Statistics of these arrays, which is created if necessary, in a
  /// view of its own: "SpreadSheetView" or "XYBarChartView".
  void showStatistics(const QStringList& arrays, int table, const QString& viewType);

  /// Writes statistics, histograms and worst cells as CSV files; returns what to tell the user.
  QString saveTables(const QString& folder) const;
  /// Writes a file of the client, but not over one from which the mesh was read; returns an error.
  QString writeText(const QString& path, const QByteArray& content) const;

  ///@{
  /// Writes the report of `camaron inspect`, with verdicts on rules, to a folder of this computer,
  /// which needs Python. Returns an error, empty if written.
  bool canSaveReport() const;
  /// Where a report is written unless the user gives a folder: beside the mesh, or at home.
  QString reportFolder() const;
  QString saveReport(const QString& folder, const camaron::CheckRequest& rules) const;
  ///@}
  ///@}

  /// @name The active selection
  ///@{
  camaron::SelectionInfo selection() const;

  /// The id of the first selected element in idSpace(); empty if there is none.
  QString selectedId() const;

  /// Makes the cells with a value in one of the closed ranges, or with a special value, the active
  /// selection of the mesh, or combines them with it. Returns whether the selection changes.
  bool selectValues(const QString& array, const QVector<QPair<double, double>>& ranges,
    int specials, camaron::Combination combine);

  /// Applies a strategy of Select Elements; see selection.md. Steps form a chain in the pipeline.
  void selectBy(const QString& strategy, const QMap<QString, QVariant>& properties,
    camaron::Combination combine = camaron::Combination::Replace);

  /// Selects the elements that a criterion fails: outside the limits, by default its acceptable
  /// range, or undefined.
  void selectOutside(const QString& criterion, const camaron::Limits& limits = {});

  /// Selects the elements with a bit of CellStatus, which is evaluated if they lack it.
  void selectDefect(const QString& bit);

  /// Selects connected groups of cells outside a range, by the id of one cell of each.
  void selectPlaces(const QStringList& ids, const QString& idSpace, const QString& array,
    const camaron::Limits& limits);

  /// The steps of the chain that ends at the mesh, first to last.
  QStringList selectionSteps() const;

  /// Removes steps from the end until `count` are left; returns an error if a filter uses one.
  QString undoSelectionTo(int count);

  void clearSelection();

  /// The last 20 active selections, latest first, by brushes, steps and in views: what was
  /// selected, and how many elements.
  QStringList pastSelections() const;

  /// Makes one of them the active selection again, and its mesh the inspected one.
  void reselect(int place);

  /// Writes the selected elements to a file of the server, ".csv" or any mesh, or of this computer,
  /// ".txt" or an OpenFOAM set in a folder "sets". Returns an error, empty if written.
  /// The rows of a table of cells are sorted by a criterion, worst first, or by another array.
  QString exportSelection(const QString& path, bool onServer, const QString& criterion) const;
  ///@}

  /// @name Display and camera
  ///@{
  /// The active view, or another one that shows the mesh if that does not.
  pqRenderView* view() const;

  /// The representation of the mesh in that view; nullptr if it has none.
  pqDataRepresentation* representation() const;

  ///@{
  /// Whether Mesh Inspection draws the mesh in the active view, or could.
  bool isInspected() const;
  bool canInspect() const;
  ///@}

  /// Shape of the cut: "Plane", "CuttingSphere", "CuttingBox" or "HalfSpaces".
  QString cutShape() const;

  /// A property of the representation: a number, a text, or a list of them; invalid if the mesh is
  /// not shown.
  QVariant display(const QString& property) const;

  /// Sets properties of Mesh Inspection, switching to it if necessary, as one undoable step.
  void setDisplay(const QMap<QString, QVariant>& properties);

  /// As setDisplay, but only while the mouse moves: no trace, no undo.
  void previewDisplay(const QMap<QString, QVariant>& properties);

  /// Chooses the shape of the cut: "Plane", "CuttingSphere", "CuttingBox" or "HalfSpaces", and sets
  /// its properties.
  void setCut(const QString& shape, const QMap<QString, QVariant>& values);

  /// Properties of the shape of the cut.
  QMap<QString, QVariant> cut(const QStringList& names) const;

  /// As setCut for the present shape, but only while the mouse moves: no trace, no undo.
  void previewCut(const QMap<QString, QVariant>& values);

  ///@{
  /// Whether the handles of the cut are shown in the view; nothing without the widgets of the
  /// Properties panel that have them.
  std::optional<bool> cutHandles();
  void showCutHandles(bool areShown);
  ///@}

  /// Cell array that colors the mesh; empty if none does.
  QString coloredBy() const;

  ///@{
  /// Point array of isosurfaces, empty without one, and the range of its values.
  QString isosurfaceArray() const;
  QPair<double, double> isosurfaceRange() const;
  ///@}

  /// Colors the mesh by a criterion, see vtkQualityColors, or by another array. Colors that the
  /// user has changed stay.
  void colorBy(const QString& array);

  /// Moves the camera to a location, marks what is there and, if `open`, cuts the mesh around it.
  /// An element whose points are not all finite has no location: nothing moves.
  void flyTo(const camaron::Location& location, bool open);

  /// Draws only the selected elements, inside the glass shell of the mesh, and moves the camera to
  /// where they are, if that is known.
  void showSelected(const std::optional<camaron::Location>& location);

  /// Restores camera and display as they were before flyTo or showSelected, without the mark.
  void flyBack();
  bool canFlyBack() const;
  ///@}

Q_SIGNALS:
  /// Another mesh, or other data.
  void meshChanged();

  /// The registry of another server.
  void registryChanged();

  void selectionChanged();

  /// Exactly one element is selected in a view.
  void elementPicked();

  /// The view, the representation or its properties.
  void displayChanged();

private:
  Q_DISABLE_COPY(pqInspectedMesh)

  explicit pqInspectedMesh(QObject* parent);
  ~pqInspectedMesh() override;

  /// Follows the active source.
  void findMesh();
  void setPort(pqOutputPort* port);
  void followCells();
  void followDisplay();
  vtkPVDataInformation* information() const;

  /// The page "Mesh Inspector" of ParaView's settings; nullptr without a server.
  vtkSMProxy* settings() const;

  /// Forgets the mesh and everything of its server.
  void forget();

  /// Select Elements that marks "Cells" or "Points" in the array Selected: with the strategy
  /// "Current", those of the active selection; nullptr without a mesh.
  vtkSMSourceProxy* marked(const QString& strategy, const QString& elements) const;

  /// Lets selected elements shine through the mesh in the view, unless they are many or drawn
  /// alone.
  void showSelectionThrough();

  /// Number of elements that a strategy marks, without ghosts.
  qint64 count(const QString& strategy, const QString& elements) const;

  /// An output of the server's Criteria Table.
  const camaron::PanelTable& registry(int port) const;

  /// The elements of a location; the key as for HelperFilters.
  vtkSMSourceProxy* extracted(const camaron::Location& location, const char* key) const;

  /// A filter that answers questions, with the mesh or an output of another helper as input.
  vtkSMSourceProxy* filterHelper(
    const char* name, const char* key = "", vtkSMSourceProxy* input = nullptr) const;

  /// The same with the cells before the steps of selection as input, so that a step computes
  /// nothing again.
  vtkSMSourceProxy* cellsHelper(const char* name, const char* key = "") const;

  /// The output of Mesh Elements that the mesh consists of; nullptr if it consists of cells.
  pqOutputPort* elementSource() const;

  /// The value of the list of arrays of Mesh Elements.
  QVariantList elementTicks(const QStringList& names, const QString& elementType) const;

  /// Evaluates a criterion besides those that the mesh has, if it is missing.
  void evaluateAlso(const QString& name);

  /// Creates a filter on the mesh as the Filters menu does, applied, with properties; nullptr on
  /// failure. It replaces the mesh in the view and becomes active. With a negative shownPort, it
  /// shows nothing and has the cells before the steps of selection as input.
  pqPipelineSource* addFilter(
    const QString& name, const QMap<QString, QVariant>& properties, int shownPort = 0);

  /// Changes properties of a filter and applies them.
  void changeFilter(pqPipelineSource* source, const QMap<QString, QVariant>& properties);

  /// Makes an output the mesh, and the active source, and shows it instead of the mesh before.
  void inspect(pqOutputPort* port);

  /// What Quality Statistics computes for a request.
  QVector<camaron::Distribution> fetchDistributions(vtkSMSourceProxy* statistics,
    const QStringList& arrays, const camaron::DistributionRequest& request, bool hasWeights) const;

  /// Shows an output instead of another one in the active view, with the same look.
  void replaceInView(pqOutputPort* shown, pqOutputPort* before);

  /// selectValues by Select Elements, for what thresholds cannot express.
  void selectValuesBySteps(const QString& array, const QVector<QPair<double, double>>& ranges,
    int specials, camaron::Combination combination);

  /// Adds the active selection to the past ones, unless it is one of them.
  void rememberSelection();

  /// The filters of the chain of Select Elements that ends at the mesh, first to last.
  QList<pqPipelineSource*> stepFilters() const;

  /// Makes a selection that has been one before the active one, and records it in a trace.
  void activate(const camaron::PastSelection& past);

  /// Description of a step of selection, such as "Worst 1 % by Volume".
  QString describeStep(vtkSMProxy* step) const;

  /// After a step of selection was removed: activates what the step before it selects, or the
  /// selection that the first step began with.
  void restoreSelection();

  /// The shape of the cut; nullptr if the mesh is not shown.
  vtkSMProxy* cutProxy() const;

  ///@{
  /// Remembers the camera before the first flight.
  void rememberCamera(pqRenderView* view);
  /// Remembers the display before a mesh is opened, unless it is open already; restores it.
  void rememberDisplay();
  void closeDisplay();
  ///@}

  ///@{
  /// Moves the camera of a view: position, focal point, view up, parallel scale; then something may
  /// happen.
  void fly(
    pqRenderView* view, const QVector<double>& end, const std::function<void()>& arrive = {});
  void endFlight(
    pqRenderView* view, const QVector<double>& end, const std::function<void()>& arrive);
  ///@}

  camaron::PanelTable checkProblems(vtkSMSourceProxy* check) const;

  /// Writes an output with the server's writer for the extension of a path; returns an error.
  QString write(vtkSMSourceProxy* source, int port, const QString& path) const;

  /// Types of the outputs of Mesh Elements.
  static const QStringList ElementTypes;

  bool IsFollowing = false;
  bool IsEvaluating = false;
  QPointer<pqOutputPort> Port;
  QPointer<pqOutputPort> CellsPort; // before the steps of selection
  QPointer<pqOutputPort> MeshPort;  // before steps and evaluations
  QString MeshElements;             // type of its elements that are inspected
  int CellsVersion = 0;
  int MeshVersion = 0;
  QString ReasonForNone;                               // empty if there is no active source
  mutable std::optional<camaron::MeshSummary> Summary; // of the data so far
  pqTimer MeshTimer;
  pqTimer DisplayTimer;
  pqTimer SelectionTimer;
  mutable camaron::HelperFilters Helpers;
  mutable QMap<int, camaron::PanelTable> Registry;
  mutable QVector<camaron::CriterionInfo> Criteria;
  mutable QVector<camaron::PresetInfo> Presets;
  QPointer<pqDataRepresentation> Followed;
  vtkNew<vtkEventQtSlotConnect> DisplayConnector;
  vtkNew<vtkEventQtSlotConnect> SettingsConnector;
  QMap<QString, QVariant> Colored;        // the color maps that criteria have got
  camaron::PastSelection SelectionBefore; // the first step of selection
  bool IsStepRemoved = false;
  QList<camaron::PastSelection> Past; // latest first
  camaron::PastSelection Brushed;     // by the brush whose selection is to be remembered
  QPointer<pqOutputPort> BrushedPort;
  int BrushSteps = 0; // of the last brush; the last one has BrushedPort
  camaron::ElementMarker Marker{ "GeometryRepresentation" };
  camaron::ElementMarker Shining{ "ElementOverlay" }; // what is selected
  std::optional<camaron::DisplayState> BeforeFlight;
  QPointer<QVariantAnimation> Flight;
};

#endif
