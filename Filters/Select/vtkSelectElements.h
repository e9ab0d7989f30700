// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSelectElements
 * @brief Selects cells or points of a mesh by one of several strategies.
 *
 * Inputs: any vtkDataSet or composite of them (port 0); the selection so far (port 1, optional),
 * any vtkSelection; a closed surface (port 2, optional); other elements of the mesh (port 3,
 * optional). Without port 1 the selection so far is what the array `Selected` of the mesh says, as
 * one Select Elements after the other leaves it. Outputs: 0. the mesh with the unsigned char array
 * `Selected` of its cells or points, 1 for selected ones and 0 for others; as there is one
 * selection, an array `Selected` of the other kind is left out;
 * 1. a vtkSelection of the selected elements with a node for each data set of this process: by
 * global id if all elements have one, else by index.
 *
 * Strategies, by name:
 * - "By criterion": values of Array inside or outside of a range; NaN is on neither side, infinite
 *   values take part;
 * - "Worst N": the NumberOfWorst worst values of Array in exact order, the smaller identity first
 * among equal ones; NaN never, infinite values take part;
 * - "Worst share": the WorstShare percent that are worst of those with a value, rounded down;
 * - "Status": cells of whose CellStatus a bit is set, any or those that StatusBits names;
 * - "Cell type": cells of CellTypes;
 * - "Null": NaN in Array;
 * - "Number of elements": cells with so many faces, edges or vertices;
 * - "Failed criteria": elements of which at least NumberOfFailures arrays are out of the ranges of
 * the preset; adds the int array `FailedCriteriaCount`;
 * - "By id": a list of ids;
 * - "Shape", "Half-spaces", "Surface": what lies in a sphere, box, cylinder or behind a plane;
 * behind all planes of a list; in a closed surface, as Placement says; "Shape file": the same of a
 * shape as text;
 * - "Expand", "Shrink": the selection so far with rings of neighbors, or without;
 * - "Connected": all that hangs together with the selection so far; "Part": of its parts the n-th
 * largest;
 * - "Change kind": cells with any or all of their faces, edges or points selected, or these of
 * cells;
 * - "Boundary": 3D cells with a face, and 2D cells with an edge, that no other cell has, in
 * whatever piece; or the points of these faces and edges;
 * - "All", "Current" (the selection so far), "Invert" (what is not in it).
 *
 * Ghosts do not count; in the output ghost cells are marked as their originals are. The same cells
 * are selected on any number of processes, if these have global ids or hold consecutive ranges of
 * the cells; see camaron::ElementBlocks.
 */
#ifndef vtkSelectElements_h
#define vtkSelectElements_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkSmartPointer.h" // for names

#include <memory> // for the parameters
#include <string> // for the report
#include <vector> // for marks

class vtkImplicitFunction;
class vtkStringArray;

namespace camaron
{
class ElementBlocks;
class SelectionTask;
struct SelectionParameters;
}

class vtkSelectElements : public vtkDataObjectAlgorithm
{
public:
  static vtkSelectElements* New();
  vtkTypeMacro(vtkSelectElements, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  vtkMTimeType GetMTime() override;

  /// Name of the array that is added.
  static const char* GetSelectedArrayName() { return "Selected"; }

  /// The selection so far, see above.
  void SetSelectionConnection(vtkAlgorithmOutput* selection)
  {
    this->SetInputConnection(1, selection);
  }

  /// Surface: closed polygons, convex or not, on any processes.
  void SetSurfaceConnection(vtkAlgorithmOutput* surface) { this->SetInputConnection(2, surface); }

  /**
   * Change kind: a data set with the points of the mesh, of whose cells (or, if these have no array
   * `Selected`, points) the selected ones are changed to elements of the mesh: the mesh with its
   * selected cells where this mesh is the faces or edges of vtkMeshElements, or the other way
   * round. Without it the cells of the mesh are changed to its points or its points to its cells,
   * as Selection or else the array `Selected` has them.
   */
  void SetElementsConnection(vtkAlgorithmOutput* elements)
  {
    this->SetInputConnection(3, elements);
  }

  ///@{
  /// What to select: "Cells" (default) or "Points".
  void SetElementType(const char* name);
  const char* GetElementType() const;
  ///@}

  ///@{
  /**
   * How the elements that the strategy finds change the selection so far: they "Replace" it
   * (default), are added to it ("Add") or taken from it ("Subtract"), it becomes what is in both
   * ("Intersect") or in one of them ("Toggle"), or the strategy looks only at what is selected
   * ("Refine"): the worst N of that.
   */
  void SetCombination(const char* name);
  const char* GetCombination() const;
  ///@}

  ///@{
  /// How to select, see above. Default: "By criterion".
  void SetStrategy(const char* name);
  const char* GetStrategy() const;
  ///@}

  ///@{
  /// By id: ids and ranges of them, such as "3, 10-20, 40". Default: none.
  void SetIds(const char* ids);
  const char* GetIds() const;
  ///@}

  ///@{
  /**
   * By id: what an id is. "Index" (default): the index among the cells of all blocks and processes,
   * VTK's cell id if there is only one data set; "Global id" or "Pedigree id": of the arrays with
   * that role.
   */
  void SetIdSpace(const char* name);
  const char* GetIdSpace() const;
  ///@}

  ///@{
  /**
   * By criterion, Worst N, Null, Invert: cell array and point array with one component, whichever
   * belongs to the elements. Where it is empty (default) the one that another process has been
   * told, else the active scalars, else the first one by name.
   */
  void SetArray(const char* name);
  const char* GetArray() const;
  void SetPointArray(const char* name);
  const char* GetPointArray() const;
  ///@}

  ///@{
  /// By criterion: select values on this side of the range, "Outside" (default) or "Inside".
  void SetSide(const char* name);
  const char* GetSide() const;
  ///@}

  ///@{
  /**
   * By criterion: the closed range, "Acceptable" (default, the one in which values of the criterion
   * are acceptable) or "Custom" (LowerLimit to UpperLimit).
   */
  void SetRange(const char* name);
  const char* GetRange() const;
  ///@}

  ///@{
  /**
   * By criterion, Failed criteria: whose acceptable range, "Default ranges" (default, those of the
   * table of criteria) or the name of a preset.
   */
  void SetPreset(const char* name);
  const char* GetPreset() const;
  /// The choices for Preset.
  vtkStringArray* GetPresetNames();
  ///@}

  ///@{
  /**
   * By criterion: file of acceptable ranges of the user (Core/Criteria/RangesFile.h), which come
   * before those of the preset. Default: empty, none.
   */
  void SetRangesFile(const char* path);
  const char* GetRangesFile() const;
  ///@}

  ///@{
  /// By criterion: ends of a custom range as text, in the unit of the array. Default: empty, no
  /// end.
  void SetLowerLimit(const char* number);
  const char* GetLowerLimit() const;
  void SetUpperLimit(const char* number);
  const char* GetUpperLimit() const;
  ///@}

  ///@{
  /// Worst N: how many cells, 0 or more. Default: 10.
  void SetNumberOfWorst(int number);
  int GetNumberOfWorst() const;
  ///@}

  ///@{
  /// Worst share: how many percent, 0 to 100. Default: 1.
  void SetWorstShare(double percent);
  double GetWorstShare() const;
  ///@}

  ///@{
  /**
   * Cell type: VTK's names without "vtk", or numbers, such as "Tetra, Hexahedron, 42". ByTopology
   * (default: off) takes a polyhedron or a cell of higher order for the linear cell that it has the
   * topology of. Default: none.
   */
  void SetCellTypes(const char* names);
  const char* GetCellTypes() const;
  void SetByTopology(bool byTopology);
  bool GetByTopology() const;
  vtkBooleanMacro(ByTopology, bool);
  ///@}

  ///@{
  /**
   * Number of elements: what is Counted, "Faces" (default), "Edges" or "Vertices" of each cell, and
   * the Counts to select, such as "4, 7-10". Default: none.
   */
  void SetCounted(const char* name);
  const char* GetCounted() const;
  void SetCounts(const char* numbers);
  const char* GetCounts() const;
  ///@}

  ///@{
  /// Failed criteria: how many must fail at least, 1 or more. Default: 1.
  void SetNumberOfFailures(int number);
  int GetNumberOfFailures() const;
  ///@}

  ///@{
  /// Status: names of camaron::CellStatusBits, such as "InvertedOrZeroVolume, OpenCell". Default:
  /// empty, all.
  void SetStatusBits(const char* names);
  const char* GetStatusBits() const;
  ///@}

  ///@{
  /**
   * Worst N, Worst share: "By criterion" (default, the end that the table of criteria calls worse),
   * "Largest" or "Smallest".
   */
  void SetWorstValues(const char* name);
  const char* GetWorstValues() const;
  ///@}

  ///@{
  /**
   * Shape: a vtkSphere, vtkBox, vtkCylinder (without ends) or vtkPlane (the side that its normal
   * points away from) and what ParaView derives from them. Default: none.
   */
  void SetShape(vtkImplicitFunction* shape);
  vtkImplicitFunction* GetShape() const;
  ///@}

  ///@{
  /// Half-spaces: six numbers for each plane, a point of it and its normal, which points away from
  /// the inside. Default: none.
  void AddPlaneNumber(double number);
  void ClearPlanes();
  ///@}

  ///@{
  /// Shape file: a sphere, planes or the polygons of a closed surface as text, see
  /// camaron::ShapeText. Default: none.
  void SetShapeFile(const char* path);
  const char* GetShapeFile() const;
  ///@}

  ///@{
  /**
   * Shape, Half-spaces, Surface, Shape file: which cells are taken, those with "Any vertex inside",
   * "All vertices inside", "Centroid inside" (default); "Intersects": with any point inside, be it
   * of a face or an edge, or all of the shape within the cell; "Cut by boundary": with points
   * inside and outside. What lies on the surface, up to 1e-12 of the diagonal of the mesh, is
   * inside.
   */
  void SetPlacement(const char* name);
  const char* GetPlacement() const;
  ///@}

  ///@{
  /**
   * Change kind: whether "Any" (default) or "All" of the elements of the other kind must be
   * selected: of a cell's faces, edges or points, or of the cells that have the face, edge or
   * point, in whatever piece. What has none of them is not selected.
   */
  void SetQuantifier(const char* name);
  const char* GetQuantifier() const;
  ///@}

  ///@{
  /// Shape, Half-spaces, Surface, Shape file: whether to take the other elements instead. Default:
  /// off.
  void SetInsideOut(bool insideOut);
  bool GetInsideOut() const;
  vtkBooleanMacro(InsideOut, bool);
  ///@}

  ///@{
  /**
   * Expand, Shrink, Connected, Part: cells are neighbors over a common "Face" (default; of 2D
   * cells an edge), "Edge" or "Vertex". Points are on a face, an edge or (Vertex) a cell.
   */
  void SetAdjacency(const char* name);
  const char* GetAdjacency() const;
  ///@}

  ///@{
  /// Expand, Shrink: how often, 0 or more. Default: 1.
  void SetNumberOfRings(int rings);
  int GetNumberOfRings() const;
  ///@}

  ///@{
  /**
   * Expand, Shrink, Connected, Part, over Faces: 2D cells whose normals differ by more than this
   * angle in degrees are no neighbors. Default: 180, all are.
   */
  void SetFeatureAngle(double degrees);
  double GetFeatureAngle() const;
  ///@}

  ///@{
  /**
   * Expand, Connected: whether to stay within the elements of Boundary, and within those that By
   * criterion would select. Default: off.
   */
  void SetOnlyBoundary(bool only);
  bool GetOnlyBoundary() const;
  vtkBooleanMacro(OnlyBoundary, bool);
  void SetOnlyInRange(bool only);
  bool GetOnlyInRange() const;
  vtkBooleanMacro(OnlyInRange, bool);
  ///@}

  ///@{
  /// Part: which one, 1 (default) for the largest; of equally large ones that with the smallest id
  /// first.
  void SetPartNumber(int number);
  int GetPartNumber() const;
  ///@}

  ///@{
  /// Invert: whether elements with a null value in the array stay unselected. Default: off.
  void SetLeaveNulls(bool leave);
  bool GetLeaveNulls() const;
  vtkBooleanMacro(LeaveNulls, bool);
  ///@}

  /// Selected elements of all processes after the last update.
  vtkGetMacro(NumberOfSelectedElements, vtkIdType);
  /// What the last update has to say, such as "2 of 5 ids do not exist"; else empty.
  const char* GetReport() const { return this->Report.c_str(); }

protected:
  vtkSelectElements();
  ~vtkSelectElements() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSelectElements(const vtkSelectElements&) = delete;
  void operator=(const vtkSelectElements&) = delete;

  void SetText(std::string& member, const char* text);
  std::vector<std::vector<unsigned char>> Select(
    camaron::SelectionTask& task, camaron::ElementBlocks& blocks);

  std::unique_ptr<camaron::SelectionParameters> Parameters;
  vtkSmartPointer<vtkStringArray> PresetNames;
  vtkIdType NumberOfSelectedElements = 0;
  std::string Report;
};

#endif
