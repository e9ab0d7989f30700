// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The table of all criteria. To add one: write its function in a .cxx of this folder (a cell function
// `double Foo(const CellGeometry&)`, or a mesh function as in NeighborNormals.cxx) and a row here.
#include "Criteria/CellNeighborhood.h"
#include "Criteria/Criterion.h"
#include "Criteria/MeshContext.h"
#include "Criteria/Verdict.h"

#include <limits>

namespace camaron
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double None = std::numeric_limits<double>::quiet_NaN();
constexpr double Positive = std::numeric_limits<double>::min(); // smallest value that is above zero
constexpr double SquareRootOf3Over8 = 0.61237243569579452; // of the regular tetrahedron
constexpr double SquareRootOf1Over3 = 0.57735026918962573; // of the equilateral triangle
constexpr double SquareRootOf2 = 1.4142135623730951;
constexpr double FullSphere = 12.566370614359172;          // 4 pi

constexpr const char* Verdict = "Verdict manual, rev. A";
constexpr const char* CheckMesh = "OpenFOAM checkMesh";
constexpr const char* NoRange = "";
constexpr bool Hint = true;
constexpr bool Cited = false;
constexpr bool Integer = true;
constexpr bool Real = false;

constexpr unsigned NeedsAll =
  NeedsEdges | NeedsFaces | NeedsVolume | NeedsCorners | NeedsDihedral | NeedsSolidAngle | NeedsCentroid;

// Calls one function for a block of cells; declares the function, too. A direct call per cell.
#define CELLS(Function)                                                                            \
  [](const CellGeometry* cells, int numberOfCells, double* values)                                 \
  {                                                                                                \
    double Function(const CellGeometry&);                                                          \
    for (int i = 0; i < numberOfCells; ++i)                                                        \
    {                                                                                              \
      values[i] = Function(cells[i]);                                                              \
    }                                                                                              \
  },                                                                                               \
    nullptr
// The same for a function with neighbours, which has the loop itself.
#define MESH(Function)                                                                             \
  nullptr, [](const MeshContext& mesh, vtkIdType begin, vtkIdType end, double* values)             \
  {                                                                                                \
    void Function(const MeshContext&, vtkIdType, vtkIdType, double*);                              \
    Function(mesh, begin, end, values);                                                            \
  }
// The same for a function of a cell and the cells at its faces.
#define NEIGHBORS(Function)                                                                        \
  nullptr, nullptr, [](const CellNeighborhood& cell)                                               \
  {                                                                                                \
    double Function(const CellNeighborhood&);                                                      \
    return Function(cell);                                                                         \
  }
}

//------------------------------------------------------------------------------
// Columns: name, label, description; shapes, unit, range, ideal, better; acceptable range, its source,
// hint or cited, integer or real; cost, needs, function.
static std::vector<Criterion> MakeCriteria()
{
  // clang-format off
  std::vector<Criterion> criteria = {
    // Size and counts. Acceptable sizes depend on the problem; only signs are judged.
    { "Area", "Area", "Length of the polygon's vector area; the area of a planar polygon.",
      Polygons, Unit::Area, { 0, Infinity }, None, Better::Neither,
      { Positive, Infinity }, "not collapsed", Cited, Real, Cost::Faces, NeedsFaces, CELLS(Area) },
    { "Perimeter", "Perimeter", "Sum of the edge lengths.",
      Polygons, Unit::Length, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsEdges, CELLS(Perimeter) },
    { "SurfaceArea", "Surface area",
      "Sum over the faces of the signed triangle areas about the face centre; of a planar face its area.",
      Polyhedra, Unit::Area, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsFaces, CELLS(SurfaceArea) },
    { "Volume", "Volume",
      "Volume by the divergence theorem, the same for a standard cell and for its polyhedron; negative "
      "for a standard cell whose nodes are in the wrong order. Null for an open polyhedron.",
      Polyhedra, Unit::Volume, { -Infinity, Infinity }, None, Better::Neither,
      { Positive, Infinity }, "neither flat nor inverted", Cited, Real, Cost::Edges, NeedsVolume, CELLS(Volume) },
    { "VertexCount", "Vertices", "Number of distinct points.",
      PolygonsAndPolyhedra, Unit::None, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Integer, Cost::Faces, NeedsPoints, CELLS(VertexCount) },
    { "EdgeCount", "Edges", "Number of distinct edges.",
      PolygonsAndPolyhedra, Unit::None, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Integer, Cost::Edges, NeedsPoints, CELLS(EdgeCount) },
    { "FaceCount", "Faces", "Number of faces with at least three distinct points.",
      Polyhedra, Unit::None, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Integer, Cost::Faces, NeedsPoints, CELLS(FaceCount) },
    { "MinEdgeLength", "Shortest edge", "Length of the shortest edge; 0 when an edge is collapsed.",
      PolygonsAndPolyhedra, Unit::Length, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsEdges, CELLS(MinEdgeLength) },
    { "MaxEdgeLength", "Longest edge", "Length of the longest edge.",
      PolygonsAndPolyhedra, Unit::Length, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsEdges, CELLS(MaxEdgeLength) },
    { "MeanEdgeLength", "Mean edge", "Mean length of the distinct edges.",
      PolygonsAndPolyhedra, Unit::Length, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsEdges, CELLS(MeanEdgeLength) },
    { "Diameter", "Diameter", "Largest distance between two vertices.",
      PolygonsAndPolyhedra, Unit::Length, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsPoints, CELLS(Diameter) },
    { "MinFaceVertexCount", "Fewest vertices of a face", "Number of points of the face with the fewest.",
      Polyhedra, Unit::None, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Integer, Cost::Faces, NeedsPoints, CELLS(MinFaceVertexCount) },
    { "MaxFaceVertexCount", "Most vertices of a face", "Number of points of the face with the most.",
      Polyhedra, Unit::None, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Integer, Cost::Faces, NeedsPoints, CELLS(MaxFaceVertexCount) },
    { "MinFaceArea", "Smallest face", "Length of the vector area of the smallest face.",
      Polyhedra, Unit::Area, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsFaces, CELLS(MinFaceArea) },
    { "MaxFaceArea", "Largest face", "Length of the vector area of the largest face.",
      Polyhedra, Unit::Area, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsFaces, CELLS(MaxFaceArea) },
    { "EquivalentRadius", "Equivalent radius",
      "Radius of the circle of the same area, or of the ball of the same volume; 0 where that is not "
      "positive.",
      PolygonsAndPolyhedra, Unit::Length, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real,
      Cost::Edges, NeedsFaces | NeedsVolume, CELLS(EquivalentRadius) },
    { "CellTypeId", "Cell type", "VTK's number of the cell type, for grouping.",
      AnyCell, Unit::None, { 0, 255 }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Integer, Cost::Faces, NeedsPoints, CELLS(CellTypeId) },

    // Angles.
    { "MinInteriorAngle", "Smallest interior angle",
      "Smallest interior angle of the polygon; ideal is 180 (k - 2) / k for k corners.",
      Polygons, Unit::Angle, { 0, 360 }, None, Better::Bigger,
      { 30, Infinity }, "Verdict manual, rev. A, for triangles; 45 for quadrilaterals", Hint, Real,
      Cost::Faces, NeedsFaces | NeedsCorners, CELLS(MinFaceAngle) },
    { "MaxInteriorAngle", "Largest interior angle",
      "Largest interior angle of the polygon, above 180 at a reflex corner.",
      Polygons, Unit::Angle, { 0, 360 }, None, Better::Smaller,
      { -Infinity, 135 }, "Verdict manual, rev. A, for quadrilaterals; 90 for triangles", Hint, Real,
      Cost::Faces, NeedsFaces | NeedsCorners, CELLS(MaxFaceAngle) },
    { "MinFaceAngle", "Smallest face angle", "Smallest interior angle of all faces of the cell.",
      Polyhedra, Unit::Angle, { 0, 360 }, None, Better::Bigger,
      { 30, Infinity }, "Verdict manual, rev. A, for triangles; 45 for quadrilaterals", Hint, Real,
      Cost::Faces, NeedsFaces | NeedsCorners, CELLS(MinFaceAngle) },
    { "MaxFaceAngle", "Largest face angle",
      "Largest interior angle of all faces of the cell, above 180 at a reflex corner.",
      Polyhedra, Unit::Angle, { 0, 360 }, None, Better::Smaller,
      { -Infinity, 135 }, "Verdict manual, rev. A, for quadrilaterals; 90 for triangles", Hint, Real,
      Cost::Faces, NeedsFaces | NeedsCorners, CELLS(MaxFaceAngle) },
    { "MinDihedralAngle", "Smallest dihedral angle",
      "Smallest interior angle between two faces of the cell at their common edge; regular tetrahedron "
      "70.53, hexahedron 90.",
      Polyhedra, Unit::Angle, { 0, 360 }, None, Better::Bigger,
      { 20, Infinity }, "common practice; 40 for tetrahedra in the Verdict manual", Hint, Real,
      Cost::Edges, NeedsDihedral, CELLS(MinDihedralAngle) },
    { "MaxDihedralAngle", "Largest dihedral angle",
      "Largest interior angle between two faces of the cell at their common edge; above 180 the cell is "
      "not convex.",
      Polyhedra, Unit::Angle, { 0, 360 }, None, Better::Smaller,
      { -Infinity, 165 }, "common practice", Hint, Real,
      Cost::Edges, NeedsDihedral, CELLS(MaxDihedralAngle) },
    { "MinSolidAngle", "Smallest solid angle",
      "Smallest solid angle of the cell at one of its vertices; cube 1.5708, regular tetrahedron 0.5513.",
      Polyhedra, Unit::SolidAngle, { 0, FullSphere }, None, Better::Bigger,
      { 0.1, Infinity }, "common practice for tetrahedra", Hint, Real,
      Cost::Edges, NeedsSolidAngle, CELLS(MinSolidAngle) },
    { "MaxSolidAngle", "Largest solid angle",
      "Largest solid angle of the cell at one of its vertices; a full sphere is 12.566.",
      Polyhedra, Unit::SolidAngle, { 0, FullSphere }, None, Better::Smaller,
      { -Infinity, Infinity }, NoRange, Cited, Real,
      Cost::Edges, NeedsSolidAngle, CELLS(MaxSolidAngle) },
    { "EquiangleSkewness", "Equiangle skewness",
      "Largest relative deviation of an interior angle from that of the regular polygon, over all faces; "
      "above 1 at reflex corners.",
      PolygonsAndPolyhedra, Unit::None, { 0, Infinity }, 0, Better::Smaller,
      { -Infinity, 0.9 }, "common finite-volume practice", Hint, Real,
      Cost::Faces, NeedsFaces | NeedsCorners, CELLS(EquiangleSkewness) },
    { "MinNeighborNormalAngle", "Smallest angle to a neighbour",
      "Smallest angle between the normals of the polygon and of those that share an edge with it; 0 is "
      "flat.",
      Polygons, Unit::Angle, { 0, 180 }, 0, Better::Smaller,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Neighbors, NeedsFaces, MESH(MinNeighborNormalAngle) },
    { "MaxNeighborNormalAngle", "Largest angle to a neighbour",
      "Largest angle between the normals of the polygon and of those that share an edge with it; 0 is "
      "flat.",
      Polygons, Unit::Angle, { 0, 180 }, 0, Better::Smaller,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Neighbors, NeedsFaces, MESH(MaxNeighborNormalAngle) },

    // Ratios of any polygon or polyhedron.
    { "EdgeLengthRatio", "Edge length ratio", "Shortest edge divided by longest edge.",
      PolygonsAndPolyhedra, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { 1.0 / 3, Infinity }, "Verdict manual, rev. A, edge ratio of tetrahedra; 0.77 for triangles and quadrilaterals",
      Hint, Real, Cost::Faces, NeedsEdges, CELLS(EdgeLengthRatio) },
    { "EdgeRatio", "Edge ratio", "Longest edge divided by shortest edge; infinite if an edge is collapsed.",
      PolygonsAndPolyhedra, Unit::None, { 1, Infinity }, 1, Better::Smaller,
      { -Infinity, 3 }, "Verdict manual, rev. A, for tetrahedra; 1.3 for triangles and quadrilaterals",
      Hint, Real, Cost::Faces, NeedsEdges, CELLS(EdgeRatio) },
    { "EdgeDiameterRatio", "Edge to diameter", "Shortest edge divided by the largest distance of two vertices.",
      PolygonsAndPolyhedra, Unit::None, { 0, 1 }, None, Better::Bigger,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsEdges, CELLS(EdgeDiameterRatio) },
    { "MinPointDistanceRatio", "Closest vertices",
      "Smallest distance of two vertices divided by the largest.",
      PolygonsAndPolyhedra, Unit::None, { 0, 1 }, None, Better::Bigger,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsPoints, CELLS(MinPointDistanceRatio) },
    { "PrincipalAspectRatio", "Principal aspect ratio",
      "Shortest divided by longest principal axis of the vertices (square root of the ratio of the "
      "eigenvalues of their second moments; of a polygon in its plane).",
      PolygonsAndPolyhedra, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsFaces, CELLS(PrincipalAspectRatio) },
    { "IsoperimetricQuotient", "Isoperimetric quotient",
      "Compactness: 4 pi area / perimeter^2 of a polygon, 36 pi volume^2 / surface area^3 of a "
      "polyhedron; 1 for circle and ball, 0.5236 for the cube.",
      PolygonsAndPolyhedra, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { -Infinity, Infinity }, NoRange, Cited, Real,
      Cost::Edges, NeedsEdges | NeedsFaces | NeedsVolume, CELLS(IsoperimetricQuotient) },
    { "Sphericity", "Sphericity",
      "Wadell's sphericity: surface of the ball of the same volume divided by the surface area; cube 0.806.",
      Polyhedra, Unit::None, { 0, 1 }, None, Better::Bigger,
      { -Infinity, Infinity }, NoRange, Cited, Real,
      Cost::Edges, NeedsFaces | NeedsVolume, CELLS(Sphericity) },
    { "VolumeEdgeRatio", "Volume to edges", "Volume divided by the cube of the root mean square of the edge lengths; cube 1.",
      Polyhedra, Unit::None, { -Infinity, Infinity }, None, Better::Bigger,
      { -Infinity, Infinity }, NoRange, Cited, Real,
      Cost::Edges, NeedsEdges | NeedsVolume, CELLS(VolumeEdgeRatio) },
    { "CornerScaledJacobian", "Corner scaled Jacobian",
      "Smallest determinant of the unit vectors along the three edges at a vertex; 1 for right angles, "
      "negative for an inverted corner. Null for cells with a vertex of more edges.",
      Polyhedra, Unit::None, { -1, 1 }, None, Better::Bigger,
      { Positive, Infinity }, "not inverted; 0.5 for hexahedra in the Verdict manual, rev. A", Cited, Real,
      Cost::Edges, NeedsEdges | NeedsFaces | NeedsVolume | NeedsSolidAngle, CELLS(CornerScaledJacobian) },
    { "CellIsotropy", "Cell isotropy",
      "27 det T / (tr T)^3, T being the sum of the products of the face vectors with themselves; 1 for "
      "the cube and all regular polyhedra, 0 for a flat cell.",
      Polyhedra, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsFaces, CELLS(CellIsotropy) },
    { "CellAspectRatio", "Cell aspect ratio",
      "OpenFOAM's aspect ratio from the face areas seen along the axes; depends on the axes, so that a "
      "rotated box has another value.",
      Polyhedra, Unit::None, { 1, Infinity }, 1, Better::Smaller,
      { -Infinity, 1000 }, CheckMesh, Cited, Real,
      Cost::Edges, NeedsFaces | NeedsVolume, CELLS(CellAspectRatio) },

    // Triangles and tetrahedra, whatever their VTK type; null for every other shape.
    { "TriangleRadiusRatio", "Triangle radius ratio", "Twice the inradius divided by the circumradius.",
      Triangles, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { 1.0 / 3, Infinity }, Verdict, Cited, Real,
      Cost::Faces, NeedsEdges | NeedsFaces, CELLS(TriangleRadiusRatio) },
    { "BhatiaLawrence", "Bhatia-Lawrence measure",
      "4 sqrt(3) area / sum of squared edge lengths, the mean ratio of a triangle.",
      Triangles, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { 0.25, Infinity }, "Verdict manual, rev. A, shape of triangles", Cited, Real,
      Cost::Faces, NeedsEdges | NeedsFaces, CELLS(BhatiaLawrence) },
    { "TriangleRadiusEdgeRatio", "Triangle radius-edge ratio", "Circumradius divided by the shortest edge.",
      Triangles, Unit::None, { SquareRootOf1Over3, Infinity }, SquareRootOf1Over3, Better::Smaller,
      { -Infinity, SquareRootOf2 }, "Ruppert's bound, smallest angle above 20.7 degrees", Cited, Real,
      Cost::Faces, NeedsEdges | NeedsFaces, CELLS(TriangleRadiusEdgeRatio) },
    { "TetRadiusEdgeRatio", "Tetrahedron radius-edge ratio",
      "Circumradius divided by the shortest edge. Does not see slivers: read it together with the "
      "smallest dihedral angle.",
      Tetrahedra, Unit::None, { SquareRootOf3Over8, Infinity }, SquareRootOf3Over8, Better::Smaller,
      { -Infinity, 2 }, "TetGen's default bound", Cited, Real,
      Cost::Edges, NeedsEdges | NeedsVolume, CELLS(TetRadiusEdgeRatio) },
    { "TetRadiusRatio", "Tetrahedron radius ratio", "Three times the inradius divided by the circumradius.",
      Tetrahedra, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { 1.0 / 3, Infinity }, Verdict, Cited, Real,
      Cost::Edges, NeedsEdges | NeedsFaces | NeedsVolume, CELLS(TetRadiusRatio) },
    { "TetMeanRatio", "Tetrahedron mean ratio",
      "12 (3 volume)^(2/3) / sum of squared edge lengths, negative when inverted.",
      Tetrahedra, Unit::None, { -1, 1 }, 1, Better::Bigger,
      { 0.3, Infinity }, "Verdict manual, rev. A, shape of tetrahedra", Cited, Real,
      Cost::Edges, NeedsEdges | NeedsVolume, CELLS(TetMeanRatio) },
    { "TetQualityFoam", "OpenFOAM's tetrahedron quality",
      "Volume divided by that of the regular tetrahedron with the same circumsphere.",
      Tetrahedra, Unit::None, { -1, 1 }, 1, Better::Bigger,
      { 1e-15, Infinity }, "OpenFOAM's minTetQuality", Hint, Real,
      Cost::Edges, NeedsEdges | NeedsVolume, CELLS(TetQualityFoam) },

    // The faces of a cell, and the cell cut at its centroid, as finite volumes want them.
    { "MinFaceFlatness", "Smallest face flatness",
      "Length of the vector area of a face divided by the area of its triangles about the centre, the "
      "smallest of all faces; 1 is planar.",
      PolygonsAndPolyhedra, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { 0.8, Infinity }, CheckMesh, Cited, Real, Cost::Faces, NeedsFaces, CELLS(MinFaceFlatness) },
    { "MaxWarpage", "Largest warpage",
      "Largest distance of a vertex from the mean plane of its face divided by the largest distance from "
      "the centre of that face.",
      PolygonsAndPolyhedra, Unit::None, { 0, Infinity }, 0, Better::Smaller,
      { -Infinity, 0.1 }, "planarity limit of VTK's Validate Cells", Cited, Real,
      Cost::Faces, NeedsFaces, CELLS(MaxWarpage) },
    { "MaxFaceConcavity", "Largest face concavity",
      "How far the largest interior angle of a face exceeds 180 degrees; 0 for convex faces.",
      PolygonsAndPolyhedra, Unit::Angle, { 0, 180 }, 0, Better::Smaller,
      { -Infinity, 80 }, "OpenFOAM's maxConcave; checkMesh reports from 10", Cited, Real,
      Cost::Faces, NeedsFaces | NeedsCorners, CELLS(MaxFaceConcavity) },
    { "CellConcavity", "Cell concavity",
      "Largest distance of the centre of a face outside the plane of a neighbouring face, divided by the "
      "diameter; not above 0 where the cell is convex.",
      Polyhedra, Unit::None, { -1, 1 }, None, Better::Smaller,
      { -Infinity, Infinity }, NoRange, Cited, Real,
      Cost::Edges, NeedsEdges | NeedsFaces | NeedsVolume, CELLS(CellConcavity) },
    { "MinFacePyramidVolume", "Smallest face pyramid", "Volume of the smallest pyramid of a face and the centroid of the cell.",
      Polyhedra, Unit::Volume, { -Infinity, Infinity }, None, Better::Bigger,
      { Positive, Infinity }, CheckMesh, Cited, Real,
      Cost::Edges, NeedsCentroid, CELLS(MinFacePyramidVolume) },
    { "MinFacePyramidRatio", "Smallest face pyramid, relative",
      "Volume of the smallest pyramid of a face and the centroid, times the number of faces, divided by "
      "the volume of the cell; 1 if all are equal.",
      Polyhedra, Unit::None, { -Infinity, 1 }, 1, Better::Bigger,
      { Positive, Infinity }, CheckMesh, Cited, Real,
      Cost::Edges, NeedsCentroid, CELLS(MinFacePyramidRatio) },
    { "MinTetVolume", "Smallest tetrahedron of the decomposition",
      "Volume of the smallest tetrahedron of the centroid, the centre of a face and an edge of it.",
      Polyhedra, Unit::Volume, { -Infinity, Infinity }, None, Better::Bigger,
      { Positive, Infinity }, "star-shaped about its centroid", Cited, Real,
      Cost::Edges, NeedsCentroid, CELLS(MinTetVolume) },
    { "MinTetMeanRatio", "Smallest mean ratio of the decomposition",
      "Mean ratio of the worst tetrahedron of the centroid, the centre of a face and an edge of it; above "
      "0 where the cell is star-shaped about its centroid. Not 1 for the cube.",
      Polyhedra, Unit::None, { -1, 1 }, None, Better::Bigger,
      { Positive, Infinity }, "star-shaped about its centroid", Cited, Real,
      Cost::Edges, NeedsCentroid, CELLS(MinTetMeanRatio) },
    { "MinTetQuality", "Smallest OpenFOAM tetrahedron quality",
      "Volume divided by that of the regular tetrahedron with the same circumsphere, of the worst "
      "tetrahedron of the centroid, the centre of a face and an edge of it.",
      Polyhedra, Unit::None, { -1, 1 }, None, Better::Bigger,
      { 1e-15, Infinity }, "OpenFOAM's minTetQuality", Hint, Real,
      Cost::Edges, NeedsCentroid, CELLS(MinTetQuality) },
    { "Openness", "Openness",
      "Largest component of the sum of the face vectors relative to the sum of the sizes of that "
      "component; 0 where the faces close the cell.",
      Polyhedra, Unit::None, { 0, 1 }, 0, Better::Smaller,
      { -Infinity, 1e-6 }, CheckMesh, Cited, Real,
      Cost::Edges, NeedsFaces | NeedsVolume, CELLS(Openness) },

    // Validity. Bits as in CellStatusBits.h.
    { "CellStatus", "Cell status",
      "Sum of what is wrong: 1 too few points, 2 intersecting edges, 4 intersecting faces, 8 a face that "
      "comes to a point twice, 16 not convex, 32 faces not outward, 64 faces not planar, 128 degenerate "
      "faces, 256 coincident points, 4096 open edge, 8192 edge of several faces, 16384 pinched vertex, "
      "32768 inverted or no volume, 65536 edge of no length, 262144 coordinates that are not finite, "
      "524288 face vectors that do not cancel. The first nine as in VTK's Validate Cells.",
      PolygonsAndPolyhedra, Unit::None, { 0, 1048575 }, 0, Better::Smaller,
      { -Infinity, 0 }, "nothing wrong", Cited, Integer, Cost::Edges, NeedsAll, CELLS(CellStatus) },
    { "FaceOrientationStatus", "Orientation of faces",
      "0 if all faces point outward, 1 inward, 2 some of both, 3 they cannot be made to agree.",
      Polyhedra, Unit::None, { 0, 3 }, 0, Better::Smaller,
      { -Infinity, 0 }, "outward", Cited, Integer, Cost::Edges, NeedsFaces | NeedsVolume, CELLS(FaceOrientationStatus) },
    { "IsConvex", "Convex", "1 if neither faces nor edges bend inward (within ConvexityTolerance), else 0.",
      PolygonsAndPolyhedra, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { -Infinity, Infinity }, NoRange, Cited, Integer, Cost::Edges, NeedsAll, CELLS(IsConvex) },
    { "IsWatertight", "Watertight", "1 if every edge of the cell has at least two faces, else 0.",
      Polyhedra, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { 1, Infinity }, "closed", Cited, Integer, Cost::Edges, NeedsAll, CELLS(IsWatertight) },
    { "IsValid", "Valid",
      "1 if CellStatus has nothing but warped or inward faces or a shape that is not convex, else 0.",
      PolygonsAndPolyhedra, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { 1, Infinity }, "valid", Cited, Integer, Cost::Edges, NeedsAll, CELLS(IsValid) },

    // Finite volumes: a cell and its neighbours. Of polygons, with edges for faces.
    { "MaxNonOrthogonality", "Largest non-orthogonality",
      "Largest angle between the line to the centroid of a neighbour and the normal of the face between; "
      "above 90 the centroids are on the wrong sides.",
      PolygonsAndPolyhedra, Unit::Angle, { 0, 180 }, 0, Better::Smaller,
      { -Infinity, 65 }, "OpenFOAM's maxNonOrtho; checkMesh reports from 70", Cited, Real,
      Cost::Neighbors, NeedsCentroid, NEIGHBORS(MaxNonOrthogonality) },
    { "MaxBoundaryNonOrthogonality", "Largest non-orthogonality at the boundary",
      "Largest angle between the line to the centre of a boundary face and the normal of that face.",
      PolygonsAndPolyhedra, Unit::Angle, { 0, 180 }, 0, Better::Smaller,
      { -Infinity, Infinity }, NoRange, Cited, Real,
      Cost::Neighbors, NeedsCentroid, NEIGHBORS(MaxBoundaryNonOrthogonality) },
    { "MaxFaceSkewness", "Largest face skewness",
      "Largest distance of the centre of a face from where the line to the neighbour crosses it, relative "
      "to the size of the face in that direction; at the boundary as if the cell were mirrored.",
      PolygonsAndPolyhedra, Unit::None, { 0, Infinity }, 0, Better::Smaller,
      { -Infinity, 4 }, "OpenFOAM checkMesh for inner faces; 20 at the boundary", Cited, Real,
      Cost::Neighbors, NeedsCentroid, NEIGHBORS(MaxFaceSkewness) },
    { "MinFaceWeight", "Smallest face weight",
      "Smaller distance of a face from the two centroids, along its normal, divided by the sum of both.",
      PolygonsAndPolyhedra, Unit::None, { 0, 0.5 }, 0.5, Better::Bigger,
      { 0.05, Infinity }, "OpenFOAM's minFaceWeight", Cited, Real,
      Cost::Neighbors, NeedsCentroid, NEIGHBORS(MinFaceWeight) },
    { "MinVolumeRatio", "Smallest volume ratio",
      "Smaller divided by larger volume (area) of the cell and a neighbour, the worst of all neighbours.",
      PolygonsAndPolyhedra, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { 0.01, Infinity }, "OpenFOAM's minVolRatio", Cited, Real,
      Cost::Neighbors, NeedsCentroid, NEIGHBORS(MinVolumeRatio) },
    { "CellVolumeRatio", "Size growth",
      "Larger divided by smaller volume (area) of the cell and a neighbour, the worst of all neighbours.",
      PolygonsAndPolyhedra, Unit::None, { 1, Infinity }, 1, Better::Smaller,
      { -Infinity, 2 }, "common practice for transitions; 1.2 in layers", Hint, Real,
      Cost::Neighbors, NeedsCentroid, NEIGHBORS(CellVolumeRatio) },
    { "OrthogonalQuality", "Orthogonal quality",
      "Smallest cosine of the angles between the normal of a face and the lines from the centroid to the "
      "centre of the face and to the centroid of the neighbour, as in Fluent.",
      PolygonsAndPolyhedra, Unit::None, { -1, 1 }, 1, Better::Bigger,
      { 0.1, Infinity }, "Fluent practice; 0.01 at least", Hint, Real,
      Cost::Neighbors, NeedsCentroid, NEIGHBORS(OrthogonalQuality) },
    { "CellDeterminant", "Cell determinant",
      "OpenFOAM's determinant of the inner faces, relative to their mean area; 1 for a cube within a grid "
      "(8 in some releases of OpenFOAM), 0 for a cell without inner faces.",
      Polyhedra, Unit::None, { 0, Infinity }, None, Better::Bigger,
      { 0.001, Infinity }, CheckMesh, Cited, Real,
      Cost::Neighbors, NeedsCentroid, NEIGHBORS(CellDeterminant) },
  };
  // clang-format on
  const std::vector<Criterion> ofVerdict = GetVerdictCriteria();
  criteria.insert(criteria.end(), ofVerdict.begin(), ofVerdict.end());
  return criteria;
}

//------------------------------------------------------------------------------
const std::vector<Criterion>& GetCriteria()
{
  static const std::vector<Criterion> criteria = MakeCriteria();
  return criteria;
}

#undef CELLS
#undef MESH
#undef NEIGHBORS

//------------------------------------------------------------------------------
const Criterion* FindCriterion(std::string_view name)
{
  for (const Criterion& criterion : GetCriteria())
  {
    if (name == criterion.Name)
    {
      return &criterion;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
std::string Criterion::UnitLabel(AngleUnit angles) const
{
  switch (this->Unit)
  {
    case Unit::Angle:
      return angles == AngleUnit::Degrees ? "deg" : "rad";
    case Unit::SolidAngle:
      return "sr";
    default:
      return "";
  }
}
}
