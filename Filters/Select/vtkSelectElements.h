// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSelectElements
 * @brief Selects cells or points of a mesh with one of several strategies.
 *
 * Inputs: the mesh, any vtkDataSet or composite data set (port 0); the current selection, any
 * vtkSelection (port 1, optional); a closed surface (port 2, optional); other elements of the mesh
 * (port 3, optional). Without port 1, the array `Selected` of the mesh is the current selection, so
 * Select Elements filters can be chained.
 *
 * Outputs:
 * 0. the mesh with the unsigned char array `Selected` of its cells or points: 1 for selected
 *    elements, 0 for others. A mesh has one selection: an array `Selected` of the other element
 *    type is removed.
 * 1. a vtkSelection of the selected elements with one node per data set of this process: by global
 *    id if all elements have one, else by index
 *
 * camaron::GetStrategies() lists the strategies. NaN is on neither side of a range and never among
 * the worst values; infinite values count. "Failed criteria" adds the int array
 * `FailedCriteriaCount`.
 *
 * Ghosts are ignored; in the output, ghost cells are marked like their originals. The selection is
 * the same on any number of processes if cells have global ids or every process has a consecutive
 * range of the cells; see camaron::ElementBlocks.
 */
#ifndef vtkSelectElements_h
#define vtkSelectElements_h

#include "SelectionParameters.h"
#include "vtkQualityAlgorithm.h"

#include "vtkNew.h"          // for names
#include "vtkSmartPointer.h" // for names
#include "vtkStringArray.h"  // for names

#include <string> // for the report
#include <vector> // for marks

namespace camaron
{
class ElementBlocks;
class SelectionTask;
}

class vtkSelectElements
  : public vtkQualityAlgorithm
  , private camaron::SelectionParameters
{
public:
  static vtkSelectElements* New();
  vtkTypeMacro(vtkSelectElements, vtkQualityAlgorithm);
  vtkMTimeType GetMTime() override;

  /// Name of the array that the filter adds.
  static const char* GetSelectedArrayName() { return "Selected"; }

  /// The current selection, see above.
  void SetSelectionConnection(vtkAlgorithmOutput* selection)
  {
    this->SetInputConnection(1, selection);
  }

  /// Surface: polygons that enclose a volume, convex or not, on any processes.
  void SetSurfaceConnection(vtkAlgorithmOutput* surface) { this->SetInputConnection(2, surface); }

  /**
   * Change element type: a data set with the points of the mesh. Its selected cells (or, without a
   * cell array `Selected`, its selected points) are changed to elements of the mesh. It is, for
   * example, the mesh with selected cells if the input is the output of vtkMeshElements with its
   * faces or edges, or the other way around. Without it, the selected points of the mesh are
   * changed to its cells, or its selected cells to its points, as given by Selection or the array
   * `Selected`.
   */
  void SetElementsConnection(vtkAlgorithmOutput* elements)
  {
    this->SetInputConnection(3, elements);
  }

  ///@{
  /// Element type to select: "Cells" (default) or "Points".
  vtkSetStdStringFromCharMacro(ElementType);
  vtkGetCharFromStdStringMacro(ElementType);
  ///@}

  ///@{
  /**
   * How the elements found by the strategy change the current selection: "Replace" (default) it,
   * "Add" to it, "Subtract" from it, "Intersect" with it (keep what is in both), or "Toggle" (keep
   * what is in exactly one of both). "Refine" applies the strategy to the selected elements only,
   * for example to select the worst N of them.
   */
  vtkSetStdStringFromCharMacro(Combination);
  vtkGetCharFromStdStringMacro(Combination);
  ///@}

  ///@{
  /// Name of the strategy, see above. Default: "By criterion".
  vtkSetStdStringFromCharMacro(Strategy);
  vtkGetCharFromStdStringMacro(Strategy);
  /// The choices for Strategy, and what each of them selects.
  vtkStringArray* GetStrategyNames() { return this->StrategyNames; }
  vtkStringArray* GetSelectedByStrategies() { return this->SelectedByStrategies; }
  ///@}

  ///@{
  /**
   * By criterion, Worst N, Worst percentage, Undefined, Invert: one-component cell array or point
   * array, according to the element type. Empty (default): the name set on another process, else
   * the active scalars, else the first array by name.
   */
  vtkSetStdStringFromCharMacro(Array);
  vtkGetCharFromStdStringMacro(Array);
  vtkSetStdStringFromCharMacro(PointArray);
  ///@}

  ///@{
  /**
   * By criterion: select values "Outside" (default) or "Inside" the range, limits included:
   * "Acceptable" (default), the acceptable range of the criterion, or "Custom", from LowerLimit to
   * UpperLimit. These are texts in the unit of the array; empty (default) means unbounded.
   */
  vtkSetStdStringFromCharMacro(Side);
  vtkGetCharFromStdStringMacro(Side);
  vtkSetStdStringFromCharMacro(Range);
  vtkGetCharFromStdStringMacro(Range);
  vtkSetStdStringFromCharMacro(LowerLimit);
  vtkGetCharFromStdStringMacro(LowerLimit);
  vtkSetStdStringFromCharMacro(UpperLimit);
  vtkGetCharFromStdStringMacro(UpperLimit);
  ///@}

  ///@{
  /**
   * By criterion, Failed criteria: source of the acceptable ranges, "Default ranges" (default, the
   * table of criteria) or the name of a preset. Ranges of a file (Core/Rules/ParsedRules.h) take
   * precedence. Default: empty, no file.
   */
  vtkSetStdStringFromCharMacro(Preset);
  vtkGetCharFromStdStringMacro(Preset);
  /// All valid values of Preset.
  vtkStringArray* GetPresetNames() { return this->PresetNames; }
  vtkSetStdStringFromCharMacro(RangesFile);
  vtkGetCharFromStdStringMacro(RangesFile);
  ///@}

  /// Failed criteria: smallest number of failed criteria, 1 or more. Default: 1.
  vtkSetMacro(NumberOfFailures, int);

  ///@{
  /// Failed rules: rules as those of vtkCheckQuality, one per line. Default: empty. Their criteria
  /// are evaluated with the options of vtkQualityAlgorithm.
  vtkSetStdStringFromCharMacro(Rules);
  vtkGetCharFromStdStringMacro(Rules);
  ///@}

  ///@{
  /// Worst N: number of elements, 0 or more. Default: 10. Worst percentage: percentage of the
  /// elements, 0 to 100. Default: 1. Both: the bad end of the values, "By criterion" (default), as
  /// in the table of criteria; "Largest" or "Smallest".
  vtkSetMacro(NumberOfWorst, int);
  vtkGetMacro(NumberOfWorst, int);
  vtkSetMacro(WorstPercentage, double);
  vtkGetMacro(WorstPercentage, double);
  vtkSetStdStringFromCharMacro(WorstValues);
  vtkGetCharFromStdStringMacro(WorstValues);
  ///@}

  ///@{
  /// Status: names of camaron::CellStatusBits, such as "InvertedOrZeroVolume, OpenCell". Default:
  /// empty, all bits.
  vtkSetStdStringFromCharMacro(StatusBits);
  vtkGetCharFromStdStringMacro(StatusBits);
  ///@}

  ///@{
  /**
   * Cell type: VTK's names without "vtk", or VTK's numbers, such as "Tetra, Hexahedron, 42".
   * Default: empty. With ByTopology (default: off), polyhedra and higher-order cells count as the
   * linear cells with the same topology.
   */
  vtkSetStdStringFromCharMacro(CellTypes);
  vtkGetCharFromStdStringMacro(CellTypes);
  vtkSetMacro(ByTopology, bool);
  vtkGetMacro(ByTopology, bool);
  ///@}

  ///@{
  /// Number of elements: count "Faces" (default), "Edges" or "Vertices" of each cell, and select
  /// cells with the numbers Counts, such as "4, 7-10". Default of Counts: empty.
  vtkSetStdStringFromCharMacro(Counted);
  vtkSetStdStringFromCharMacro(Counts);
  vtkGetCharFromStdStringMacro(Counts);
  ///@}

  ///@{
  /**
   * By id: ids and ranges of ids, such as "3, 10-20, 40" (default: empty), and their meaning.
   * "Index" (default): the index among the cells of all blocks and processes, which is VTK's cell
   * id for a single data set. "Global id" or "Pedigree id": the arrays with that attribute type.
   */
  vtkSetStdStringFromCharMacro(Ids);
  vtkGetCharFromStdStringMacro(Ids);
  vtkSetStdStringFromCharMacro(IdSpace);
  vtkGetCharFromStdStringMacro(IdSpace);
  ///@}

  /// Shape: a vtkSphere, vtkBox, vtkCylinder (infinite) or vtkPlane (its inside is opposite to the
  /// normal), or a class that ParaView derives from them. Default: none.
  vtkSetSmartPointerMacro(Shape, vtkImplicitFunction);

  ///@{
  /// Half-spaces: six numbers per plane, a point and the outward normal. Default: none.
  void AddPlaneNumber(double number);
  void ClearPlanes();
  ///@}

  /// Shape file: path of a file with a sphere, planes or the polygons of a closed surface as text;
  /// see camaron::ShapeText. Default: empty.
  vtkSetStdStringFromCharMacro(ShapeFile);

  ///@{
  /// Set: path of one of OpenFOAM's sets, or of a file of zones with the name of one of them; see
  /// SelectSet.cxx. Default: empty.
  vtkSetStdStringFromCharMacro(SetFile);
  vtkSetStdStringFromCharMacro(SetName);
  ///@}

  ///@{
  /**
   * Shape, Half-spaces, Surface, Shape file: which cells are in the shape. "Any vertex inside",
   * "All vertices inside", "Centroid inside" (default); "Intersects": the cell and the shape have a
   * common point, even if only a face or an edge crosses the shape or the whole shape is inside the
   * cell; "Cut by boundary": the cell has points inside and outside. Points on the surface of the
   * shape, up to 1e-12 of the diagonal of the mesh, are inside. With InsideOut (default: off), the
   * other elements are selected instead.
   */
  vtkSetStdStringFromCharMacro(Placement);
  vtkGetCharFromStdStringMacro(Placement);
  vtkSetMacro(InsideOut, bool);
  vtkGetMacro(InsideOut, bool);
  ///@}

  /**
   * Change element type: whether "Any" (default) or "All" elements of the other type must be
   * selected: the faces, edges or points of a cell, or the cells of a face, edge or point, in any
   * piece. Elements without such elements are not selected.
   */
  vtkSetStdStringFromCharMacro(Quantifier);

  ///@{
  /**
   * Expand, Shrink, Connected, Connected to ids, Component: cells are neighbors if they share a
   * "Face" (default; an edge for 2D cells), an "Edge" or a "Vertex". Points are neighbors on a
   * common face, edge or (for "Vertex") cell. With "Face", 2D cells whose normals differ by more
   * than FeatureAngle, in degrees, are not neighbors; 0 or more, default: 180, no limit.
   */
  vtkSetStdStringFromCharMacro(Adjacency);
  vtkGetCharFromStdStringMacro(Adjacency);
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /// Expand, Shrink: number of layers of neighbors, 0 or more. Default: 1.
  vtkSetMacro(NumberOfLayers, int);
  vtkGetMacro(NumberOfLayers, int);
  ///@}

  ///@{
  /// Expand, Connected, Connected to ids: stay within the elements of Boundary, and within those
  /// that By criterion would select. Default: off.
  vtkSetMacro(OnlyBoundary, bool);
  vtkGetMacro(OnlyBoundary, bool);
  vtkSetMacro(OnlyInRange, bool);
  vtkGetMacro(OnlyInRange, bool);
  ///@}

  ///@{
  /// Component: number of the component by size, from 1 (default), the largest; among components of
  /// the same size the one with the smallest id comes first.
  vtkSetMacro(ComponentNumber, int);
  vtkGetMacro(ComponentNumber, int);
  ///@}

  ///@{
  /// Invert: exclude elements for which the array is undefined (NaN). Default: off.
  vtkSetMacro(ExcludeUndefined, bool);
  vtkGetMacro(ExcludeUndefined, bool);
  ///@}

  /// Whether only GetReport() reports missing ids, without a warning. Default: off.
  vtkSetMacro(Quiet, bool);

  /// Number of selected elements on all processes after the last update.
  vtkGetMacro(NumberOfSelectedElements, vtkIdType);
  /// Warning of the last update, such as "2 of 5 ids do not exist"; else empty.
  const char* GetReport() const { return this->Report.c_str(); }

protected:
  vtkSelectElements();
  ~vtkSelectElements() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSelectElements(const vtkSelectElements&) = delete;
  void operator=(const vtkSelectElements&) = delete;

  std::vector<std::vector<unsigned char>> Select(
    camaron::SelectionTask& task, camaron::ElementBlocks& blocks);

  const vtkSmartPointer<vtkStringArray> PresetNames;
  vtkNew<vtkStringArray> StrategyNames, SelectedByStrategies;
  vtkIdType NumberOfSelectedElements = 0;
  std::string Report;
};

#endif
