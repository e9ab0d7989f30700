// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// How far a cell is from violating the mesh assumptions of virtual element methods.
#include "Cell/CellKernel.h"
#include "Criteria/CriterionRows.h"
#include "Geometry/PointPairs.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
double KernelRatio(const CellGeometry& cell);

namespace
{
struct FaceLengths
{
  double ShortestEdge, Diameter;
};

//------------------------------------------------------------------------------
FaceLengths GetFaceLengths(const CellGeometry& cell, int face)
{
  const FaceRing ring(cell, face);
  double shortest = Infinity;
  for (int i = 0; i < ring.GetSize(); ++i)
  {
    shortest = std::min(shortest, Norm2(ring.GetEnd(i) - ring.GetBegin(i)));
  }
  thread_local std::vector<Vector> corners;
  ring.GetCorners(corners);
  const double longest = FindLargestSquaredDistance(corners.data(), corners.size());
  return { std::sqrt(shortest), std::sqrt(longest) };
}

//------------------------------------------------------------------------------
double Combine(double kernels, double lengths, double counts)
{
  return std::sqrt(0.5 * kernels * (lengths + counts));
}
}

//------------------------------------------------------------------------------
double VemRho2(const CellGeometry& cell)
{
  if (cell.IsZeroLength(cell.GetDiameter()))
  {
    return Null(NullReason::Degenerate);
  }
  const double size = std::sqrt(cell.GetPolygonArea());
  return std::min(size, cell.GetMinEdgeLength()) / std::max(size, cell.GetDiameter());
}

//------------------------------------------------------------------------------
double VemRho3(const CellGeometry& cell)
{
  const std::size_t edges = cell.GetTopology().Edges.size();
  return edges < 3 ? Null(NullReason::InvalidTopology) : 3.0 / edges;
}

//------------------------------------------------------------------------------
double VemQuality(const CellGeometry& cell)
{
  const double kernels = KernelRatio(cell);
  return std::isnan(kernels) ? kernels : Combine(kernels, VemRho2(cell), VemRho3(cell));
}

//------------------------------------------------------------------------------
double PolyhedronRho1(const CellGeometry& cell)
{
  const double ratio = KernelRatio(cell);
  if (std::isnan(ratio))
  {
    return ratio;
  }
  double product = 1;
  for (int face = 0; face < cell.GetTopology().GetNumberOfFaces(); ++face)
  {
    product *= cell.GetKernel().GetFaceRatio(cell, face);
  }
  return 0.5 * (ratio + product);
}

//------------------------------------------------------------------------------
double PolyhedronRho2(const CellGeometry& cell)
{
  if (std::isnan(cell.GetVolume()))
  {
    return cell.GetVolume();
  }
  if (cell.IsZeroLength(cell.GetDiameter()))
  {
    return Null(NullReason::Degenerate);
  }
  const int numberOfFaces = cell.GetTopology().GetNumberOfFaces();
  double smallestFace = Infinity, sum = 0;
  for (int face = 0; face < numberOfFaces; ++face)
  {
    const FaceLengths lengths = GetFaceLengths(cell, face);
    smallestFace = std::min(smallestFace, lengths.Diameter);
    if (!cell.IsZeroLength(lengths.Diameter))
    {
      const double size = std::sqrt(cell.GetFaceArea(face));
      sum += std::min(size, lengths.ShortestEdge) / std::max(size, lengths.Diameter);
    }
  }
  const double size = std::cbrt(std::abs(cell.GetVolume()));
  return 0.5 *
    (std::min(size, smallestFace) / std::max(size, cell.GetDiameter()) + sum / numberOfFaces);
}

//------------------------------------------------------------------------------
double PolyhedronRho3(const CellGeometry& cell)
{
  if (std::isnan(cell.GetVolume()))
  {
    return cell.GetVolume();
  }
  const int numberOfFaces = cell.GetTopology().GetNumberOfFaces();
  double sum = 4;
  for (int face = 0; face < numberOfFaces; ++face)
  {
    sum += 3.0 / cell.GetTopology().GetFaceSize(face);
  }
  return 0.5 * sum / numberOfFaces;
}

//------------------------------------------------------------------------------
double PolyhedronQuality(const CellGeometry& cell)
{
  const double kernels = PolyhedronRho1(cell);
  return std::isnan(kernels) ? kernels
                             : Combine(kernels, PolyhedronRho2(cell), PolyhedronRho3(cell));
}

//------------------------------------------------------------------------------
std::vector<Criterion> VemCriteria()
{
  constexpr unsigned needs = NeedsFaces | NeedsVolume;
  return {
    CriterionRow("VemRho1", "VEM: kernel",
      "Area of the kernel of a polygon divided by its area; the same as KernelRatio.")
      .Shapes(Polygons)
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Cost(Cost::Iterative)
      .Needs(needs)
      .Cells<KernelRatio>()
      .Formula("ρ₁ = |K| / |E|")
      .Degenerate("As KernelRatio.")
      .Agreement("Sorgente et al. 2022, The role of mesh quality and mesh quality indicators in "
                 "the virtual element method."),
    CriterionRow("VemRho2", "VEM: lengths",
      "The smaller of the shortest edge and the square root of the area of a polygon, divided by "
      "the larger of its diameter and the square root of the area.")
      .Shapes(Polygons)
      .Range(0, 1)
      .Ideal(None, Better::Bigger)
      .Needs(NeedsEdges | NeedsFaces)
      .Cells<VemRho2>()
      .Formula("ρ₂ = min(√A, l_min) / max(√A, h)")
      .Degenerate(
        "0 for a collapsed edge or a flat polygon; NaN (degenerate) if all points coincide.")
      .Agreement("After Sorgente et al. 2022; the full text was not available for comparison."),
    CriterionRow("VemRho3", "VEM: edges", "3 divided by the number of edges of a polygon.")
      .Shapes(Polygons)
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Cells<VemRho3>()
      .Formula("ρ₃ = 3 / number of edges")
      .Degenerate("NaN (invalid topology) with fewer than three edges.")
      .Agreement("After Sorgente et al. 2022; the full text was not available for comparison."),
    CriterionRow("VemQuality", "VEM: quality",
      "Combination of the kernel, the lengths and the number of edges of a polygon; 1 is good.")
      .Shapes(Polygons)
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Cost(Cost::Iterative)
      .Needs(NeedsEdges | needs)
      .Cells<VemQuality>()
      .Formula(
        "√((ρ₁ρ₂ + ρ₁ρ₃) / 2). The value of a mesh is the root mean square of those of its cells.")
      .Degenerate("0 without a kernel; NaN as for VemRho1.")
      .Agreement("After Sorgente et al. 2022; the full text was not available for comparison. "
                 "Omits the term for sequences of edges with very different lengths."),
    CriterionRow("PolyhedronRho1", "Polyhedron: kernels",
      "Mean of the kernel ratio of a polyhedron and the product of the kernel ratios of its faces, "
      "each in its plane.")
      .Shapes(Polyhedra)
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Cost(Cost::Clipping)
      .Needs(needs)
      .Cells<PolyhedronRho1>()
      .Formula("½ (|K| / V + Π_f |K_f| / A_f)")
      .Degenerate("A face without area counts as 0; otherwise as KernelRatio.")
      .Agreement("The name is our own: it is meant to be ρ₁ of Sorgente et al. 2022, Polyhedral "
                 "mesh quality indicator for the virtual element method, but the formula could not "
                 "be compared with that paper."),
    CriterionRow("PolyhedronRho2", "Polyhedron: lengths",
      "Compares the cube root of the volume, the faces and the edges of a polyhedron with its "
      "diameter and the diameters of its faces.")
      .Shapes(Polyhedra)
      .Range(0, 1)
      .Ideal(None, Better::Bigger)
      .Needs(needs)
      .Cells<PolyhedronRho2>()
      .Formula("½ (min(∛V, min_f h_f) / max(∛V, h) + mean_f min(√A_f, l_min,f) / max(√A_f, h_f)), "
               "h: diameters, l: edges")
      .Degenerate("Collapsed edges and faces count as 0; NaN (degenerate) if all points coincide, "
                  "NaN (invalid topology) for open cells.")
      .Agreement("As PolyhedronRho1."),
    CriterionRow("PolyhedronRho3", "Polyhedron: faces and edges",
      "Mean of 4 divided by the number of faces of a polyhedron and the average over its faces of "
      "3 divided by the number of edges.")
      .Shapes(Polyhedra)
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Cost(Cost::Edges)
      .Needs(needs)
      .Cells<PolyhedronRho3>()
      .Formula("½ (4 / k + mean_f 3 / edges of f) for k faces")
      .Degenerate("NaN (invalid topology) for open cells.")
      .Agreement("As PolyhedronRho1."),
    CriterionRow(
      "PolyhedronQuality", "Polyhedron: quality", "Combination of PolyhedronRho1 to 3; 1 is good.")
      .Shapes(Polyhedra)
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Cost(Cost::Clipping)
      .Needs(needs)
      .Cells<PolyhedronQuality>()
      .Formula("√((ρ₁ρ₂ + ρ₁ρ₃) / 2) of PolyhedronRho1, 2, 3. The value of a mesh is the root mean "
               "square of those of its cells.")
      .Degenerate("0 without kernels of cell and faces; NaN as for PolyhedronRho1.")
      .Agreement("As PolyhedronRho1."),
  };
}
}
