// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonOFFMesh.h"

#include "Intake/CellMesh/CellGrid.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <type_traits>

namespace camaron
{
namespace
{
constexpr char OutOfRange[] =
  "with a color outside 0 to 255, or 0 to 1 for real numbers, clamped to this range";

/// The warnings about oddities.
constexpr struct
{
  const char* One;
  const char* Many;
  const char* What;
} Sentences[NumberOfOFFOddities] = {
  { "vertex", "vertices",
    "with more numbers than the keyword of the file declares, which are ignored" },
  { "vertex", "vertices",
    "without the color that the keyword of the file declares, shown in gray" },
  { "vertex", "vertices", OutOfRange },
  { "face", "faces", OutOfRange },
  { "face", "faces", "without vertices, omitted" },
  { "face", "faces", "with one vertex, shown as a vertex" },
  { "face", "faces", "with two vertices, shown as a line" },
  { "face", "faces", "with data after the vertices that is not a color, ignored" },
};
}

//------------------------------------------------------------------------------
void OFFCensus::AddFace(vtkIdType row, const OFFColor& color, bool isOdd)
{
  if (!this->Colors.Add(color) || isOdd)
  {
    this->Add(OFFOddity::FaceWithOddColor, row);
  }
  if (!color.IsInRange())
  {
    this->Add(OFFOddity::FaceOutOfRange, row);
  }
}

//------------------------------------------------------------------------------
void OFFCensus::Merge(const OFFCensus& other)
{
  this->Colors.Merge(other.Colors);
  for (int i = 0; i < NumberOfOFFOddities; ++i)
  {
    this->Oddities[i].Merge(other.Oddities[i]);
  }
}

//------------------------------------------------------------------------------
template <typename Real>
void OFFMesh::Fill(OFFVertices<Real>& vertices, const CellMeshPiece& piece,
  const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings,
  const Progress& progress)
{
  const OFFHeader& header = this->Header;
  const OFFCensus& ofFaces = this->FaceCensus;
  const OFFCensus& ofVertices = this->VertexCensus;
  using Array = std::conditional_t<std::is_same<Real, float>::value, vtkFloatArray, vtkDoubleArray>;
  const auto points = vertices.Coordinates.template TakeArray<Array>(3);
  if (request.Piece == 0)
  {
    if (header.Dimension > 3)
    {
      warnings.Add("the vertices have " + std::to_string(header.Dimension) +
        " dimensions; only the first three are shown");
    }
    OFFCensus all = ofVertices;
    all.Merge(ofFaces);
    for (int i = 0; i < NumberOfOFFOddities; ++i)
    {
      warnings.Add(all.Oddities[i], Sentences[i].One, Sentences[i].Many, Sentences[i].What);
    }
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
