// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellGeometry
 * @brief Geometry of one cell, computed once and shared by all criteria of that cell.
 *
 * A polygon cell has one face. Coordinates are double and relative to the first point of the cell.
 * The faces of a polyhedron are oriented consistently and outward, at voids into the void, unless
 * the user trusts the orientation of the mesh. The faces of a standard cell follow from VTK's node
 * order; if this makes the volume negative, the angles are still those of the cell with correct
 * orientation.
 *
 *     CellGeometry cell;
 *     cell.Load(mesh, id, options);
 *     cell.Normalize();
 *     cell.Compute(NeedsFaces | NeedsVolume);
 *     const double volume = cell.ToMesh(cell.GetVolume(), 3);
 *
 * Load() and Compute() reuse all memory; a loop over cells does not allocate.
 */
#ifndef camaron_CellGeometry_h
#define camaron_CellGeometry_h

#include "Base/Null.h"
#include "Base/Units.h"
#include "Base/Vector.h"
#include "Base/VectorPair.h"
#include "Cell/AngleRange.h"
#include "Cell/CellKernel.h"
#include "Cell/Shapes.h"
#include "Curved/CellMap.h"
#include "Mesh/CellShape.h"
#include "Mesh/CellTopology.h"
#include "Mesh/MeshView.h"
#include "Mesh/RecentTopologies.h"

#include "vtkDataSetAttributes.h" // for the kinds of ghosts

#include <algorithm> // for tolerances
#include <cstdint>   // for numbers of cells
#include <limits>    // for tolerances
#include <optional>  // for the status
#include <vector>    // for the parts

class vtkDataArray;

namespace camaron
{
struct MeanSizes;
struct MeshRegions;
struct PointRegions;
struct PieceLinks;
struct SurfaceSides;

struct EvaluationOptions
{
  AngleUnit Angles = AngleUnit::Degrees;
  /// Assume that the faces of polyhedra are oriented outward, and keep the sign of the volume.
  bool TrustFaceOrientation = false;
  /// Edges shorter than this fraction of the cell diameter are collapsed; 0 for the default, see
  /// GetZeroLength.
  double DegeneracyTolerance = 0;
  /// The mesh is one of several pieces without ghost cells, so a cell at its boundary may have a
  /// neighbor in another piece.
  bool IsPieceWithoutGhosts = false;
  /// Whether CellStatus reports cells without a kernel; Evaluate sets it if IsStarShaped is
  /// requested.
  bool ChecksStarShape = false;
  /// How far an angle of a convex cell may exceed 180 degrees, in degrees.
  double ConvexityTolerance = 1e-4;
  /// Maximum warpage of a planar face.
  double PlanarityTolerance = 0.1;
  /// Ghost flags of every cell, 0 for own cells; or nullptr.
  const unsigned char* Ghosts = nullptr;
  /// Ids that identify cells across pieces; without them, the cell's number in CellNumbers or its
  /// index in the mesh is used.
  vtkDataArray* GlobalIds = nullptr;
  /// If some pieces have no global ids: for every cell, its number in the block, in particular of
  /// duplicates; or nullptr.
  const std::int64_t* CellNumbers = nullptr;
  /// Cells of other pieces at the facets; or nullptr.
  const PieceLinks* Links = nullptr;
  /// Mean cell sizes over all pieces; nullptr for those of the evaluated mesh.
  const MeanSizes* Means = nullptr;
  /// Closed surfaces over all pieces; nullptr for those of the evaluated mesh.
  const SurfaceSides* Sides = nullptr;
  /// Regions over all pieces; nullptr for those of the evaluated mesh.
  const MeshRegions* Regions = nullptr;
  /// Groups of cells at points over all pieces; nullptr for those of the evaluated mesh.
  const PointRegions* PointGroups = nullptr;

  /// Whether a cell duplicates a cell that belongs to another piece.
  bool IsCopy(vtkIdType cell) const
  {
    return this->Ghosts && (this->Ghosts[cell] & vtkDataSetAttributes::DUPLICATECELL);
  }
  /// Whether a cell without a neighbor may have one in another piece.
  bool MayHaveMore(vtkIdType cell) const
  {
    return this->IsPieceWithoutGhosts || (this->Ghosts && this->Ghosts[cell]);
  }
};

///@{
/**
 * Lengths up to these are zero: GetAbsoluteTolerance for coordinates of magnitude up to
 * @a largest, GetZeroLength in a cell with a diameter. For areas and volumes see the methods of
 * CellGeometry.
 */
inline double GetAbsoluteTolerance(double largest)
{
  constexpr double roundingUnits =
    8; // in machine epsilons of double precision, also for float points: the mesh decides
  return roundingUnits * largest * std::numeric_limits<double>::epsilon();
}
inline double GetZeroLength(
  const EvaluationOptions& options, double diameter, double absoluteTolerance)
{
  constexpr double minRelativeTolerance = 1e-12;
  return options.DegeneracyTolerance > 0
    ? options.DegeneracyTolerance * diameter
    : std::max(minRelativeTolerance * diameter, absoluteTolerance);
}
///@}

class CellGeometry
{
public:
  CellGeometry();

  /// Reads the points and faces of a cell.
  void Load(const MeshView& mesh, vtkIdType cell, const EvaluationOptions& options);
  /**
   * Call between Load and Compute: if the cell is so large or small that products of many lengths
   * would overflow or underflow, coordinates relative to the first point, and everything computed
   * from them, are expressed in the unit 2^GetLengthExponent(). ToMesh converts values to the
   * units of the mesh, ToCell converts positions to those of the cell.
   */
  void Normalize()
  {
    if (!this->HasUsualSize && this->Finite)
    {
      this->ChooseUnit();
    }
  }
  /// Computes the parts named by a combination of Needs.
  void Compute(unsigned needs);

  /// Shapes of the cell: Polygons or Polyhedra (neither for points and lines) and, if its topology
  /// matches, one of the simple shapes, regardless of its VTK type.
  unsigned GetShapes() const { return this->Shapes; }
  unsigned char GetCellType() const { return this->CellType; }
  /// False if a coordinate is NaN or infinite; only counts have a value then.
  bool IsFinite() const { return this->Finite; }
  /// Whether the faces of its VTK type follow from the nodes.
  bool IsOfStandardType() const { return this->IsStandard; }
  /// Whether its points are the vertices of such a 3D type in VTK's order; false if two of them are
  /// the same.
  bool HasNodesInOrder() const { return !this->OwnTopology; }
  /// Whether a cell of higher order lists corners more than once and has all nodes of what remains:
  /// it then is that cell, such as a quadratic wedge written as a hexahedron.
  bool IsInDegenerateForm() const { return this->DegenerateForm; }
  /// What it is then, after Load; nullptr for other cells.
  const CollapsedShape* GetCollapsedShape() const
  {
    return this->DegenerateForm ? this->Map.GetCollapsed() : nullptr;
  }
  /// Whether a face has the same point twice in a row, unless the cell is in degenerate form.
  bool HasRepeatedPoints() const { return this->HasRepeatedPoint; }
  const EvaluationOptions& GetOptions() const { return *this->Options; }

  /**
   * Vertices of a cell of a simple shape, for polyhedra after Compute(NeedsFaces | NeedsVolume), in
   * the usual order: those of a wedge as of an extrusion, see Cell/Shapes.h. Returns their number.
   */
  int GetSimpleCorners(Vector corners[MaxSimpleNodes]) const;
  /// The map of the cell from its parametric domain: of a curved cell, or of the linear cell with
  /// its vertices. Requires the same; nullptr for other than simple shapes. Loaded on demand from
  /// the mesh given to Load.
  const CellMap* GetMap() const;
  /// The map of a curved cell; nullptr for any other.
  const CellMap* GetCurvedMap() const
  {
    return this->CellShapes[this->CellType].IsHigherOrder && this->GetMap() && this->Map.IsCurved()
      ? &this->Map
      : nullptr;
  }
  /// For a polygon cell, the direction in which the Jacobian determinant of its map is positive.
  Vector GetNormal() const;

  /// Topology of a 3D type with fixed faces whose points are all different.
  static const CellTopology& GetTopologyOfType(unsigned char type);
  const CellTopology& GetTopology() const { return *this->Topology; }
  /// The first point, in mesh coordinates.
  const Vector& GetOrigin() const { return this->Origin; }
  int GetNumberOfPoints() const { return this->NumberOfPoints; }
  /// Id of a point in the mesh.
  vtkIdType GetPointId(int point) const
  {
    return this->OwnTopology ? this->PointIds[point] : this->Nodes[point];
  }
  /// Point ids of a polygon as listed in the mesh, including consecutive repetitions.
  const std::vector<vtkIdType>& GetCornerIds() const { return this->CornerIds; }
  /// Relative to the first point.
  const Vector& GetPoint(int point) const { return this->Points[point]; }

  ///@{
  /// Convert between the units of the cell and the mesh; see Normalize. Values out of range become
  /// NaN.
  int GetLengthExponent() const { return this->LengthExponent; }
  double ToMesh(double value, int dimension) const
  {
    return this->LengthExponent == 0 ? value : this->Rescale(value, dimension);
  }
  /// With which power of the length values of a unit grow; Jacobians of polygons are areas.
  int GetPower(enum Unit unit) const
  {
    return unit == Unit::Length                                                 ? 1
      : unit == Unit::Area || (unit == Unit::Volume && this->Shapes & Polygons) ? 2
      : unit == Unit::Volume                                                    ? 3
                                                                                : 0;
  }
  Vector ToMesh(const Vector& place) const;
  Vector ToCell(const Vector& place) const
  {
    return this->LengthExponent == 0 ? place - this->Origin : this->ToUnit(place - this->Origin);
  }
  ///@}

  ///@{
  /// Whether a length, area or volume is zero within the precision of the points.
  bool IsZeroLength(double length) const
  {
    // The diagonal of the bounding box is an upper limit of the diameter and cheap, so the diameter
    // is only computed for small values.
    return length <= this->GetBoxScale().Length &&
      length <= this->GetScale(this->GetDiameter()).Length;
  }
  bool IsZeroArea(double area) const
  {
    return area <= this->GetBoxScale().Area && area <= this->GetScale(this->GetDiameter()).Area;
  }
  bool IsZeroVolume(double volume) const
  {
    volume = std::abs(volume);
    return volume <= this->GetBoxScale().Volume &&
      volume <= this->GetScale(this->GetDiameter()).Volume;
  }
  ///@}
  /// Points closer than this cannot be distinguished; at least as large as the limit of
  /// IsZeroLength.
  double GetZeroLength() const { return this->GetBoxScale().Length; }
  /// Maximum distance of two points.
  double GetDiameter() const;

  ///@{
  /// Requires NeedsEdges. A point repeated in a row is an edge of length 0.
  double GetEdgeLength(int edge) const { return std::sqrt(this->SquaredLengths[edge]); }
  int GetNumberOfEdges() const { return static_cast<int>(this->Topology->Edges.size()); }
  double GetSumOfSquaredLengths() const;
  double GetTotalEdgeLength() const;
  /// Perimeter of a polygon cell; edges that it traverses more than once count each time.
  double GetPerimeter() const;
  double GetMinSquaredLength() const { return this->MinSquaredLength; }
  double GetMaxSquaredLength() const { return this->MaxSquaredLength; }
  double GetMinEdgeLength() const { return std::sqrt(this->MinSquaredLength); }
  double GetMaxEdgeLength() const { return std::sqrt(this->MaxSquaredLength); }
  ///@}

  ///@{
  /// Requires NeedsFaces: vector areas, centers, and areas of the triangles about the center.
  const Vector& GetFaceVector(int face) const { return this->FaceVectors[face]; }
  const Vector& GetFaceCenter(int face) const { return this->FaceCenters[face]; }
  double GetFaceArea(int face) const { return this->FaceAreas[face]; }
  /// Area of a polygon cell; 0 if fewer than three different points remain.
  double GetPolygonArea() const
  {
    return this->Topology->GetNumberOfFaces() > 0 ? this->FaceAreas[0] : 0;
  }
  double GetFanArea(int face) const
  {
    this->GetSurfaceArea();
    return this->FanAreas[face];
  }
  double GetSurfaceArea() const
  {
    if (this->SurfaceArea < 0)
    {
      this->ComputeFanAreas();
    }
    return this->SurfaceArea;
  }
  ///@}

  /// Requires NeedsVolume; NaN if the cell is not closed.
  double GetVolume() const { return this->Volume; }
  /// Requires NeedsCentroid. For a polygon, the center of its face; for a polyhedron without
  /// volume, the mean of its points. Relative to the first point.
  const Vector& GetCentroid() const { return this->Centroid; }

  /// Requires NeedsCorners: interior angles of one face; empty if none is defined.
  const AngleRange& GetFaceAngles(int face) const { return this->FaceAngles[face]; }

  ///@{
  /// Require NeedsCorners, NeedsDihedral and NeedsSolidAngle, respectively. In radians and
  /// steradians; NaN if undefined.
  double GetMinFaceAngle() const { return this->JoinFaceAngles().GetMin(); }
  double GetMaxFaceAngle() const { return this->JoinFaceAngles().GetMax(); }
  double GetMinDihedralAngle() const { return this->DihedralAngles.GetMin(); }
  double GetMaxDihedralAngle() const { return this->DihedralAngles.GetMax(); }
  double GetMinSolidAngle() const { return Twice(this->HalfSolidAngles.GetMin()); }
  double GetMaxSolidAngle() const { return Twice(this->HalfSolidAngles.GetMax()); }
  /// At one edge.
  double GetDihedralAngle(int edge) const;
  /// At one point; also NaN at the ends of collapsed edges.
  double GetSolidAngle(int point);
  ///@}

  /// Requires NeedsFaces and NeedsVolume: kernel, inscribed and enclosing balls of this cell,
  /// computed on demand.
  CellKernel& GetKernel() const { return this->Kernel; }

  /// Converts radians to the unit chosen by the user; keeps the reason of NaN.
  double ToAngleUnit(double radian) const
  {
    return std::isnan(radian) ? radian : this->AngleFactor * radian;
  }

  /// The value of CellStatus, if it has been evaluated; stored because several criteria read it.
  std::optional<unsigned>& GetKnownStatus() const { return this->KnownStatus; }

private:
  /// Limits below which a value is zero, for a cell of a given size.
  struct Scale
  {
    double Length, Area, Volume;
  };
  struct StandardCell;
  static const StandardCell* GetStandardCells();

  void LoadStandard(const MeshView& mesh, const CellShape& shape, const IndexRange& points);
  void LoadCollapsed(const MeshView& mesh, const CellShape& shape, const IndexRange& points);
  void LoadPolygon(const MeshView& mesh, const CellShape& shape, const IndexRange& points);
  void LoadPolyhedron(const MeshView& mesh, vtkIdType cell);
  template <typename Id>
  void LoadCorners(const MeshView& mesh, const Id* ids, int size);
  template <typename Id>
  void NumberPoints(const MeshView& mesh, const Id* ids, int size, int* numbers);
  template <typename Id>
  void TakePoints(const MeshView& mesh, const Id* ids, const int* corners, int count);
  /// Finding the edges may be postponed until Compute needs them; simple shapes are recognized from
  /// them.
  void FindOwnTopology(bool edgesCanWait = false);

  int GetSimplePoints(int points[MaxSimpleNodes]) const;
  bool LoadMap() const;
  bool LoadDegenerateMap() const;
  bool IsQuadrilateral() const
  {
    return this->NumberOfPoints == 4 && this->Topology->GetNumberOfFaces() == 1 &&
      this->Topology->GetFaceSize(0) == 4;
  }
  void CheckCoordinates();
  void ChooseUnit();
  double Rescale(double value, int dimension) const;
  Vector ToUnit(const Vector& offset) const;
  Scale GetScale(double diameter) const;
  const Scale& GetBoxScale() const
  {
    if (this->BoxScale.Length < 0)
    {
      this->ComputeBoxScale();
    }
    return this->BoxScale;
  }
  void ComputeBoxScale() const;
  void ComputeEdges();
  void ComputeFaces(bool withMoments);
  /// get(i) is the i-th point of both faces.
  auto GetPointsOf(const CellTopology::FacePair& pair) const
  {
    return [points = this->Points.data(), first = this->Topology->GetFace(pair.First),
             second = this->Topology->GetFace(pair.Second)](int i)
    { return VectorPair(points[first[i]], points[second[i]]); };
  }
  void ComputeTriangles(const CellTopology::FacePair& pair, bool withMoments);
  void ComputeQuadrilaterals(const CellTopology::FacePair& pair, bool withMoments);
  void ComputePolygons(const CellTopology::FacePair& pair, bool withMoments);
  template <typename Weigh>
  void ComputeCenters(const CellTopology::FacePair& pair, bool withMoments, const VectorPair& mean,
    const VectorPair& sum, Weigh&& weigh);
  void KeepFaces(const CellTopology::FacePair& pair, const VectorPair& areas,
    const VectorPair& centers, Pair sizes);
  void KeepMoments(const CellTopology::FacePair& pair, const VectorPair& moments);
  void ComputeFanAreas() const;
  Pair GetFanAreas(const CellTopology::FacePair& pair) const;
  void ComputeVolume();
  double SumVolume() const;
  /// Excludes other cell types that collapse to tetrahedra, whose points are in any order.
  bool IsTetrahedronByNodes() const
  {
    return (this->Shapes & Tetrahedra) && this->HasNodesInOrder();
  }
  bool IsToBeOriented() const { return !this->IsStandard && !this->TrustFaceOrientation; }
  void OrientPolyhedron();
  void ComputeCentroid();
  void ComputeCorners();
  AngleRange JoinFaceAngles() const;
  AngleRange ComputeFaceAngles(int face);
  AngleRangePair GetRingAngles(
    const int* first, const int* second, int size, const VectorPair& area) const;
  void ComputeDihedralAngles();
  void ComputeSolidAngles();
  void AddDihedralAngle(int edge, AngleRange& angles) const;
  void AddDihedralAngles(int first, int second, AngleRangePair& angles) const;
  void AddSolidAngle(const CellTopology& topology, int point, AngleRange& halfAngles);
  bool AddSimpleAngles(
    const CellTopology& topology, int first, int second, AngleRangePair& halfAngles) const;
  /// Half of a solid angle, with the smallest squared length of the factors whose product it is.
  struct HalfAngle
  {
    double Sine, Cosine, Smallest;
  };
  HalfAngle SumFan(const Vector& corner, int numberOfSpokes) const;
  /// Keeps the reason of NaN, which arithmetic may lose.
  static double Twice(double value) { return std::isnan(value) ? value : 2 * value; }
  void MergeCollapsedEdges();

  const CellShape* CellShapes;
  const StandardCell* StandardCells;

  const EvaluationOptions* Options = nullptr;
  const MeshView* Mesh = nullptr;
  vtkIdType CellId = 0;
  unsigned Shapes = 0;
  unsigned char CellType = 0;
  bool IsStandard = false;
  bool Finite = true;
  bool HasUsualSize = true;
  int LengthExponent = 0;
  bool HasRepeatedPoint = false;
  bool DegenerateForm = false;
  bool TrustFaceOrientation = false;
  double AngleFactor = 1;
  mutable double AbsoluteTolerance = 0; // computed with BoxScale
  mutable Scale BoxScale = { -1, -1, -1 };
  mutable double Diameter = -1;    // not computed yet
  mutable double SurfaceArea = -1; // not computed yet
  mutable std::optional<unsigned> KnownStatus;
  mutable CellKernel Kernel;
  mutable CellMap Map;
  mutable std::optional<bool> HasMap; // not loaded yet

  Vector Origin;
  int NumberOfPoints = 0;
  std::vector<Vector> Points;             // grows to the size of the largest cell
  std::vector<vtkIdType> PointIds;        // used with OwnTopology
  IndexRange Nodes;                       // used without OwnTopology
  std::vector<vtkIdType> CornerIds;       // nodes, or corners of faces
  const CellTopology* Topology = nullptr; // of the standard type, or OwnTopology
  CellTopology* OwnTopology = nullptr;    // nullptr if the topology follows from the type
  RecentTopologies OwnTopologies;

  double MinSquaredLength = 0, MaxSquaredLength = 0;
  bool HasCollapsedEdge = false;
  std::vector<double> SquaredLengths;
  std::vector<Vector> FaceVectors, FaceCenters;
  std::vector<Vector> FaceMoments; // 24 times volume times centroid of the pyramids with the origin
                                   // as apex
  std::vector<double> FaceAreas;
  mutable std::vector<double> FanAreas; // computed with SurfaceArea
  double Volume = 0;
  std::vector<unsigned char> ReversedShells;
  double OrientationSign = 1;
  Vector Centroid;
  std::vector<AngleRange> FaceAngles;
  AngleRange DihedralAngles;
  AngleRange HalfSolidAngles;

  CellTopology MergedTopology; // without collapsed edges; its FaceNumbers are those in Topology
  std::vector<int> Ring;
  std::vector<Vector> EdgeDirections, Spokes;
};
}

#endif
