// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonOFFMesh.h"

#include "Intake/CellMesh/CellGrid.h"
#include "PolygonOFFFaces.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <type_traits>

namespace camaron
{
//------------------------------------------------------------------------------
void OFFVertexCensus::Merge(const OFFVertexCensus& other)
{
  this->Colors.Merge(other.Colors);
  this->WithMore.Merge(other.WithMore);
  this->WithoutColor.Merge(other.WithoutColor);
  this->OutOfRange.Merge(other.OutOfRange);
}

//------------------------------------------------------------------------------
void OFFFaceCensus::Add(const OFFFace& face)
{
  if (face.Points.size() <= 2)
  {
    (face.Points.empty()          ? this->WithoutVertices
        : face.Points.size() == 1 ? this->OfOneVertex
                                  : this->OfTwoVertices)
      .Add(face.Row);
  }
  if (!this->Colors.Add(face.Color) || face.HasOddColor)
  {
    this->WithOddColor.Add(face.Row);
  }
  if (!face.Color.IsInRange())
  {
    this->OutOfRange.Add(face.Row);
  }
}

//------------------------------------------------------------------------------
void OFFFaceCensus::Merge(const OFFFaceCensus& other)
{
  this->Colors.Merge(other.Colors);
  this->WithoutVertices.Merge(other.WithoutVertices);
  this->OfOneVertex.Merge(other.OfOneVertex);
  this->OfTwoVertices.Merge(other.OfTwoVertices);
  this->WithOddColor.Merge(other.WithOddColor);
  this->OutOfRange.Merge(other.OutOfRange);
}

//------------------------------------------------------------------------------
template <typename Real>
void OFFMesh::Fill(OFFVertices<Real>& vertices, const CellMeshPiece& piece,
  const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings,
  const Progress& progress)
{
  const OFFHeader& header = this->Header;
  const OFFFaceCensus& ofFaces = this->FaceCensus;
  const OFFVertexCensus& ofVertices = this->VertexCensus;
  using Array = std::conditional_t<std::is_same<Real, float>::value, vtkFloatArray, vtkDoubleArray>;
  const auto points = vertices.Coordinates.template TakeArray<Array>(3);
  if (request.Piece == 0)
  {
    if (header.Dimension > 3)
    {
      warnings.Add("the vertices have " + std::to_string(header.Dimension) +
        " dimensions; only the first three are shown");
    }
    warnings.Add(ofVertices.WithMore, "vertex", "vertices",
      "with more numbers than the keyword of the file declares, which are ignored");
    warnings.Add(ofVertices.WithoutColor, "vertex", "vertices",
      "without the color that the keyword of the file declares, shown in gray");
    constexpr char OutOfRange[] =
      "with a color outside 0 to 255, or 0 to 1 for real numbers, clamped to this range";
    warnings.Add(ofVertices.OutOfRange, "vertex", "vertices", OutOfRange);
    warnings.Add(ofFaces.OutOfRange, "face", "faces", OutOfRange);
    warnings.Add(ofFaces.WithoutVertices, "face", "faces", "without vertices, omitted");
    warnings.Add(ofFaces.OfOneVertex, "face", "faces", "with one vertex, shown as a vertex");
    warnings.Add(ofFaces.OfTwoVertices, "face", "faces", "with two vertices, shown as a line");
    warnings.Add(ofFaces.WithOddColor, "face", "faces",
      "with data after the vertices that is not a color, ignored");
    piece.WarnOfRepeatedPoints(this->Faces, warnings, progress.Part(0.4, 1), "face", "faces");
  }

  FillGrid(this->Faces, piece, points, grid);
  if (ofFaces.Colors.HasColors || ofFaces.Colors.HasIndices)
  {
    // Integers are bytes (Geomview manual), unless others are real and none is above 1.
    this->FaceColors.AddTo(
      grid->GetCellData(), ofFaces.Colors, ofFaces.Colors.HasReals && !ofFaces.Colors.HasBytes);
  }
  if (header.HasNormals)
  {
    grid->GetPointData()->SetNormals(vertices.Normals.template TakeArray<Array>(3, "Normals"));
  }
  if (header.HasTexture)
  {
    grid->GetPointData()->SetTCoords(vertices.Texture.template TakeArray<Array>(2, "TCoords"));
  }
  if (header.HasColors)
  {
    // Colors of vertices are real according to the manual, but many programs write bytes.
    vertices.Colors.AddTo(grid->GetPointData(), ofVertices.Colors, !ofVertices.Colors.HasBytes);
  }
}
template void OFFMesh::Fill(OFFVertices<float>&, const CellMeshPiece&, const PieceRequest&,
  vtkUnstructuredGrid*, Warnings&, const Progress&);
template void OFFMesh::Fill(OFFVertices<double>&, const CellMeshPiece&, const PieceRequest&,
  vtkUnstructuredGrid*, Warnings&, const Progress&);
}
