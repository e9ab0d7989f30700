// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellGeometry
 * @brief Geometry of one cell, computed once and shared by all criteria of that cell.
 *
 * A polygon cell is a shape with one face. Coordinates are relative to the cell's first point and
 * always double. The faces of a polyhedron are made consistent and then outward, unless the user trusts
 * them; those of a standard type are as VTK's node order says, and where that makes the volume negative
 * the angles are nevertheless those of the cell turned inside out.
 *
 * Load() and Compute() keep all memory; a loop over cells does not allocate.
 */
#ifndef camaron_CellGeometry_h
#define camaron_CellGeometry_h

#include "Criteria/Criterion.h"
#include "Mesh/CellShape.h"
#include "Mesh/CellTopology.h"
#include "Mesh/MeshView.h"
#include "Mesh/Vector.h"

#include <vector> // for the parts

namespace camaron
{
struct EvaluationOptions
{
  AngleUnit Angles = AngleUnit::Degrees;
  /// Take the faces of polyhedra as oriented outward, and keep the sign of their volume.
  bool TrustFaceOrientation = false;
  /// Relative length below which an edge counts as collapsed; 0 for the default of the specification.
  double DegeneracyTolerance = 0;
};

/// The smallest and largest of some angles, in radian; null when there is none.
struct AngleRange
{
  double Min;
  double Max;
};

class CellGeometry
{
public:
  /// Reads the points and faces of a cell.
  void Load(const MeshView& mesh, vtkIdType cell, const EvaluationOptions& options);
  /// Computes the parts named by a combination of Needs.
  void Compute(unsigned needs);

  /// Shapes that the cell is: one of Polygons and Polyhedra (neither for points and lines) and, where
  /// the topology says so, Triangles or Tetrahedra.
  unsigned GetShapes() const { return this->Shapes; }
  unsigned char GetCellType() const { return this->CellType; }
  bool IsHigherOrder() const { return this->HigherOrder; }

  const CellTopology& GetTopology() const { return *this->Topology; }
  const std::vector<Vector>& GetPoints() const { return this->Points; }

  ///@{
  /// A length, area or volume so small that it is zero for the precision of the points.
  bool IsZeroLength(double length) const;
  bool IsZeroArea(double area) const;
  bool IsZeroVolume(double volume) const;
  ///@}
  /// Largest distance of two points.
  double GetDiameter() const;

  ///@{
  /// With NeedsEdges. An edge that leads back to its own point has length 0.
  const std::vector<double>& GetEdgeLengths() const { return this->EdgeLengths; }
  double GetMinEdgeLength() const { return this->MinEdgeLength; }
  double GetMaxEdgeLength() const { return this->MaxEdgeLength; }
  double GetTotalEdgeLength() const { return this->TotalEdgeLength; }
  ///@}

  ///@{
  /// With NeedsFaces: vector areas, centres, and areas of the fan of triangles about the centre.
  const Vector& GetFaceVector(int face) const { return this->FaceVectors[face]; }
  const Vector& GetFaceCenter(int face) const { return this->FaceCenters[face]; }
  double GetFaceArea(int face) const { return this->FaceAreas[face]; }
  /// Area of a polygon cell; 0 when less than three points are left of it.
  double GetPolygonArea() const { return this->FaceAreas.empty() ? 0 : this->FaceAreas[0]; }
  double GetFanArea(int face) const;
  double GetSurfaceArea() const;
  ///@}

  /// With NeedsVolume; a null value when the cell is not closed.
  double GetVolume() const { return this->Volume; }

  /// With NeedsCorners: interior angles of one face; null when the face has none.
  const AngleRange& GetFaceAngles(int face) const { return this->FaceAngles[face]; }
  /// With NeedsDihedral, NeedsSolidAngle; null with the reason where undefined.
  const AngleRange& GetDihedralAngles() const { return this->DihedralAngles; }
  const AngleRange& GetSolidAngles() const { return this->SolidAngles; }

  /// Radian to the unit that the user chose.
  double ToAngleUnit(double radian) const { return this->AngleFactor * radian; }

private:
  void LoadStandard(const MeshView& mesh, const CellShape& shape, const IndexRange& points);
  void LoadPolygon(const MeshView& mesh, const CellShape& shape, const IndexRange& points);
  void LoadPolyhedron(const MeshView& mesh, vtkIdType cell);
  int AddPoint(const MeshView& mesh, vtkIdType id);
  int FindOrAddPoint(const MeshView& mesh, vtkIdType id);
  void AddFace(const int* points, int size);
  void FinishOwnTopology();

  double GetThreshold(double diameter) const;
  void ComputeEdges();
  void ComputeFaces();
  void ComputeVolume();
  double SumVolume(int group) const;
  void OrientPolyhedron();
  void ComputeCorners();
  AngleRange ComputeFaceAngles(int face);
  void ComputeDihedralAngles();
  void ComputeSolidAngles();
  double ComputeSolidAngle(const CellTopology& topology, int point);
  void MergeCollapsedEdges();

  unsigned Shapes = 0;
  unsigned char CellType = 0;
  bool HigherOrder = false;
  bool IsStandard = false;
  bool HasRepeatedPoint = false;
  bool TrustFaceOrientation = false;
  double AngleFactor = 1;
  double RelativeTolerance = 0;
  double AbsoluteTolerance = 0;
  double BoxDiagonal = 0;
  mutable double Diameter = -1;

  Vector Origin;
  std::vector<Vector> Points;
  std::vector<vtkIdType> PointIds;
  std::vector<int> HashTable;
  std::vector<int> LocalFace;
  const CellTopology* Topology = nullptr; // that of the standard type, or OwnTopology
  CellTopology OwnTopology;

  double MinEdgeLength = 0, MaxEdgeLength = 0, TotalEdgeLength = 0;
  std::vector<double> EdgeLengths;
  std::vector<Vector> FaceVectors, FaceCenters;
  std::vector<double> FaceAreas;
  double Volume = 0;
  double OrientationSign = 1;
  std::vector<AngleRange> FaceAngles;
  AngleRange DihedralAngles = {}, SolidAngles = {};

  CellTopology MergedTopology; // without collapsed edges
  std::vector<int> MergedFaces; // their numbers in Topology
  std::vector<int> Representatives, Ring;
  std::vector<Vector> Spokes;
};
}

#endif
