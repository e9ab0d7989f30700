// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellGeometry
 * @brief Geometry of one cell, computed once and shared by all criteria of that cell.
 *
 * A polygon cell is a shape with one face. Coordinates are relative to the cell's first point and
 * always double. The faces of a polyhedron are made consistent and then outward, those around a
 * void into it, unless the user trusts them; those of a standard type are as VTK's node order says,
 * and where that makes the volume negative the angles are nevertheless those of the cell turned
 * inside out.
 *
 * Load() and Compute() keep all memory; a loop over cells does not allocate.
 */
#ifndef camaron_CellGeometry_h
#define camaron_CellGeometry_h

#include "Base/Null.h"
#include "Base/Units.h"
#include "Base/Vector.h"
#include "Base/VectorPair.h"
#include "Cell/AngleRange.h"
#include "Cell/CellKernel.h"
#include "Cell/Needs.h"
#include "Cell/Shapes.h"
#include "Mesh/CellShape.h"
#include "Mesh/CellTopology.h"
#include "Mesh/MeshView.h"
#include "Mesh/RecentTopologies.h"

#include "vtkDataSetAttributes.h" // for the kinds of ghosts

#include <algorithm> // for tolerances
#include <cstdint>   // for numbers of cells
#include <limits>    // for tolerances
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
  /// Take the faces of polyhedra as oriented outward, and keep the sign of their volume.
  bool TrustFaceOrientation = false;
  /// Relative length below which an edge counts as collapsed; 0 for the default of the
  /// specification.
  double DegeneracyTolerance = 0;
  /// The mesh is one of several pieces without ghost cells: a cell without a neighbor may have one
  /// in another piece.
  bool IsPieceWithoutGhosts = false;
  /// Whether CellStatus tells of cells without a kernel; Evaluate does where IsStarShaped is asked
  /// for.
  bool ChecksStarShape = false;
  /// How far an angle may exceed 180 degrees in a convex cell, in degrees.
  double ConvexityTolerance = 1e-4;
  /// Largest warpage of a planar face.
  double PlanarityTolerance = 0.1;
  /// Of every cell whether it is a ghost, not 0; or none.
  const unsigned char* Ghosts = nullptr;
  /// Ids by which cells are known in all pieces; without them it is their number or their place in
  /// the mesh.
  vtkDataArray* GlobalIds = nullptr;
  /// Where not all pieces have such ids: of every cell its number among those of its block, that of
  /// copies above all; or none.
  const std::int64_t* CellNumbers = nullptr;
  /// Cells of other pieces at the facets; or none.
  const PieceLinks* Links = nullptr;
  /// Mean sizes of the cells of all pieces; if none, those of the mesh that is evaluated.
  const MeanSizes* Means = nullptr;
  /// The closed surfaces of all pieces; if none, those of the mesh that is evaluated.
  const SurfaceSides* Sides = nullptr;
  /// The regions of all pieces; if none, those of the mesh that is evaluated.
  const MeshRegions* Regions = nullptr;
  /// The groups of cells at points over all pieces; if none, those of the mesh that is evaluated.
  const PointRegions* PointGroups = nullptr;

  /// Whether a cell is a copy of one that belongs to another piece.
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
 * What counts as zero: no length for coordinates up to @a largest, and no length in a cell of a
 * diameter. See the methods of CellGeometry for areas and volumes.
 */
inline double GetAbsoluteTolerance(double largest)
{
  constexpr double roundingUnits =
    8; // quality criteria, section 1, but the same for float points: the mesh decides
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
   * Between Load and Compute: coordinates relative to the first point, and all that is made of
   * them, get the unit 2^GetLengthExponent() if the cell is so large or small that products of many
   * lengths would leave the range of numbers. ToMesh brings values into the units of the mesh,
   * ToCell places into those of the cell.
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

  /// Shapes that the cell is: one of Polygons and Polyhedra (neither for points and lines) and,
  /// where the topology says so, one of the simple shapes, whatever its VTK type.
  unsigned GetShapes() const { return this->Shapes; }
  unsigned char GetCellType() const { return this->CellType; }
  /// False if a coordinate is NaN or infinite: nothing but counts has a value then.
  bool IsFinite() const { return this->Finite; }
  /// True for a type whose faces follow from its nodes.
  bool IsOfStandardType() const { return this->IsStandard; }
  /// True if its points are the corner nodes of such a 3D type in VTK's order; not if two of them
  /// are the same.
  bool HasNodesInOrder() const { return !this->OwnTopology; }
  /// True if a face has the same point twice in a row.
  bool HasRepeatedPoints() const { return this->HasRepeatedPoint; }
  const EvaluationOptions& GetOptions() const { return *this->Options; }

  /// Of a cell of a fixed 3D type whose points are all different.
  static const CellTopology& GetTopologyOfType(unsigned char type);
  const CellTopology& GetTopology() const { return *this->Topology; }
  /// The first point.
  const Vector& GetOrigin() const { return this->Origin; }
  int GetNumberOfPoints() const { return this->NumberOfPoints; }
  /// Id of a point in the mesh.
  vtkIdType GetPointId(int point) const
  {
    return this->OwnTopology ? this->PointIds[point] : this->Nodes[point];
  }
  /// Of a polygon as the mesh lists them, also those that follow themselves.
  const std::vector<vtkIdType>& GetCornerIds() const { return this->CornerIds; }
  /// Relative to the first point.
  const Vector& GetPoint(int point) const { return this->Points[point]; }

  ///@{
  /// See Normalize. A value beyond the range of numbers becomes null.
  int GetLengthExponent() const { return this->LengthExponent; }
  double ToMesh(double value, int dimension) const
  {
    return this->LengthExponent == 0 ? value : this->Rescale(value, dimension);
  }
  Vector ToMesh(const Vector& place) const;
  Vector ToCell(const Vector& place) const
  {
    return this->LengthExponent == 0 ? place - this->Origin : this->ToUnit(place - this->Origin);
  }
  ///@}

  ///@{
  /// A length, area or volume so small that it is zero for the precision of the points.
  bool IsZeroLength(double length) const
  {
    // The diagonal of the box is at least the diameter: only what may be zero pays for the latter.
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
  /// Length up to which nothing can be told apart; not smaller than what IsZeroLength takes for
  /// zero.
  double GetZeroLength() const { return this->GetBoxScale().Length; }
  /// Largest distance of two points.
  double GetDiameter() const;

  ///@{
  /// With NeedsEdges. A point that follows itself makes an edge of length 0.
  double GetEdgeLength(int edge) const { return std::sqrt(this->SquaredLengths[edge]); }
  int GetNumberOfEdges() const { return static_cast<int>(this->Topology->Edges.size()); }
  double GetSumOfSquaredLengths() const;
  double GetTotalEdgeLength() const;
  /// Length of the way around a polygon cell, which may run along an edge more than once.
  double GetPerimeter() const;
  double GetMinSquaredLength() const { return this->MinSquaredLength; }
  double GetMaxSquaredLength() const { return this->MaxSquaredLength; }
  double GetMinEdgeLength() const { return std::sqrt(this->MinSquaredLength); }
  double GetMaxEdgeLength() const { return std::sqrt(this->MaxSquaredLength); }
  ///@}

  ///@{
  /// With NeedsFaces: vector areas, centers, and areas of the fan of triangles about the center.
  const Vector& GetFaceVector(int face) const { return this->FaceVectors[face]; }
  const Vector& GetFaceCenter(int face) const { return this->FaceCenters[face]; }
  double GetFaceArea(int face) const { return this->FaceAreas[face]; }
  /// Area of a polygon cell; 0 when less than three points are left of it.
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

  /// With NeedsVolume; a null value when the cell is not closed.
  double GetVolume() const { return this->Volume; }
  /// With NeedsCentroid: of a polygon the center of its face; of a polyhedron without a volume the
  /// mean of its points. Relative to the first point.
  const Vector& GetCentroid() const { return this->Centroid; }

  /// With NeedsCorners: interior angles of one face; empty when the face has none.
  const AngleRange& GetFaceAngles(int face) const { return this->FaceAngles[face]; }

  ///@{
  /// With NeedsCorners, NeedsDihedral and NeedsSolidAngle: in radian and steradian; null where
  /// undefined.
  double GetMinFaceAngle() const { return this->JoinFaceAngles().GetMin(); }
  double GetMaxFaceAngle() const { return this->JoinFaceAngles().GetMax(); }
  double GetMinDihedralAngle() const { return this->DihedralAngles.GetMin(); }
  double GetMaxDihedralAngle() const { return this->DihedralAngles.GetMax(); }
  double GetMinSolidAngle() const { return Twice(this->HalfSolidAngles.GetMin()); }
  double GetMaxSolidAngle() const { return Twice(this->HalfSolidAngles.GetMax()); }
  /// At one edge.
  double GetDihedralAngle(int edge) const;
  /// At one point; null at the ends of collapsed edges, too.
  double GetSolidAngle(int point);
  ///@}

  /// With NeedsFaces and NeedsVolume: kernel and balls of this cell, which computes what it is
  /// asked for.
  CellKernel& GetKernel() const { return this->Kernel; }

  /// Radian to the unit that the user chose.
  double ToAngleUnit(double radian) const { return this->AngleFactor * radian; }

  ///@{
  /// A number that several criteria of the cell read, kept from the first to the last of them.
  bool HasStatus() const { return this->StatusIsKnown; }
  unsigned GetStatus() const { return this->Status; }
  void KeepStatus(unsigned status) const
  {
    this->Status = status;
    this->StatusIsKnown = true;
  }
  ///@}

private:
  /// What counts as zero in a cell of some size.
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
  /// Edges may wait until Compute is asked for something that needs them; simple shapes are told by
  /// them.
  void FindOwnTopology(bool edgesCanWait = false);

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
  void ComputeFacesInQuads(bool withMoments);
  template <typename Group>
  void ComputeFacesIn(bool withMoments);
  template <typename Group>
  void ComputeTriangles(const Group& group, bool withMoments);
  template <typename Group>
  void ComputeQuadrilaterals(const Group& group, bool withMoments);
  template <typename Group>
  void ComputePolygons(const Group& group, bool withMoments);
  template <typename Group, typename Weigh>
  void ComputeCenters(const Group& group, bool withMoments, const typename Group::Vectors& mean,
    const typename Group::Vectors& sum, Weigh&& weigh);
  template <typename Group>
  void KeepFaces(const Group& group, const typename Group::Vectors& areas,
    const typename Group::Vectors& centers, const typename Group::Lanes& sizes);
  template <typename Group>
  void KeepMoments(const Group& group, const typename Group::Vectors& moments);
  void ComputeFanAreas() const;
  void ComputeFanAreasInQuads() const;
  template <typename Group>
  void ComputeFanAreasIn() const;
  void ComputeVolume();
  double SumVolume() const;
  /// Not one that another type collapses to, whose points are in any order.
  bool IsTetrahedronByNodes() const
  {
    return (this->Shapes & Tetrahedra) && this->HasNodesInOrder();
  }
  bool IsToBeOriented() const { return !this->IsStandard && !this->TrustFaceOrientation; }
  void OrientPolyhedron();
  void ComputeCentroid();
  void ComputeCorners();
  AngleRange JoinFaceAngles() const;
  void ComputeFaceAngles(int face, AngleRange& angles);
  void ComputeTriangleAngles(const CellTopology::FacePair& pair);
  void ComputePolygonAngles(const CellTopology::FacePair& pair);
  void KeepAngles(const CellTopology::FacePair& pair, const AngleRangePair& angles);
  void ComputeDihedralAngles();
  void ComputeSolidAngles();
  void AddDihedralAngle(int edge, AngleRange& angles) const;
  void AddDihedralAngles(int first, int second, AngleRangePair& angles) const;
  void AddSolidAngle(const CellTopology& topology, int point, AngleRange& halfAngles);
  bool AddSimpleAngles(
    const CellTopology& topology, int first, int second, AngleRangePair& halfAngles) const;
  /// Half of a solid angle, with the smallest squared length of the factors that it is the product
  /// of.
  struct HalfAngle
  {
    double Sine, Cosine, Smallest;
  };
  HalfAngle SumFan(const Vector& corner, int numberOfSpokes) const;
  /// Keeps the reason of a null value, which arithmetic may lose.
  static double Twice(double value) { return std::isnan(value) ? value : 2 * value; }
  void MergeCollapsedEdges();

  const CellShape* CellShapes;
  const StandardCell* StandardCells;

  const EvaluationOptions* Options = nullptr;
  unsigned Shapes = 0;
  unsigned char CellType = 0;
  bool IsStandard = false;
  bool Finite = true;
  bool HasUsualSize = true;
  int LengthExponent = 0;
  bool HasRepeatedPoint = false;
  bool TrustFaceOrientation = false;
  double AngleFactor = 1;
  mutable double AbsoluteTolerance = 0; // with BoxScale
  mutable Scale BoxScale = { -1, -1, -1 };
  mutable double Diameter = -1;    // not computed yet
  mutable double SurfaceArea = -1; // not computed yet
  mutable unsigned Status = 0;
  mutable bool StatusIsKnown = false;
  mutable CellKernel Kernel;

  Vector Origin;
  int NumberOfPoints = 0;
  std::vector<Vector> Points;             // grows to the largest cell
  std::vector<vtkIdType> PointIds;        // with OwnTopology
  IndexRange Nodes;                       // without
  std::vector<vtkIdType> CornerIds;       // of nodes or corners of faces
  const CellTopology* Topology = nullptr; // that of the standard type, or OwnTopology
  CellTopology* OwnTopology = nullptr;    // none where the type tells it
  RecentTopologies OwnTopologies;

  double MinSquaredLength = 0, MaxSquaredLength = 0;
  bool HasCollapsedEdge = false;
  std::vector<double> SquaredLengths;
  std::vector<Vector> FaceVectors, FaceCenters;
  std::vector<Vector> FaceMoments; // 24 times volume by centroid of the pyramids of the origin
  std::vector<double> FaceAreas;
  mutable std::vector<double> FanAreas; // with SurfaceArea
  double Volume = 0;
  std::vector<unsigned char> ReversedShells;
  double OrientationSign = 1;
  Vector Centroid;
  std::vector<AngleRange> FaceAngles;
  AngleRange DihedralAngles;
  AngleRange HalfSolidAngles;

  CellTopology MergedTopology; // without collapsed edges; its FaceNumbers are those in Topology
  std::vector<int> Representatives, Ring;
  std::vector<Vector> EdgeDirections, Spokes;
};
}

#endif
