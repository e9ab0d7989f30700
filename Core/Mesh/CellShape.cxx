// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CellShape.h"

#include "vtkCamaronCompat.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <array>
#include <cctype>
#include <utility>

namespace camaron
{
namespace
{
// Short names of VTK.
constexpr std::pair<const char*, const char*> Shortened[] = { { "tetra", "tetrahedron" },
  { "quad", "quadrangle" } };

//------------------------------------------------------------------------------
// Gets the faces of a fixed-size VTK cell type, reduced to vertices.
void AddFaces(CellShape& shape, int cellType)
{
  vtkNew<vtkGenericCell> cell;
  cell->SetCellType(cellType);
  const vtkIdType numberOfNodes = cell->GetNumberOfPoints();
  for (vtkIdType node = 0; node < numberOfNodes; ++node)
  {
    cell->GetPointIds()->SetId(node, node);
  }
  shape.NumberOfFaces = cell->GetNumberOfFaces();
  int end = 0;
  for (int f = 0; f < shape.NumberOfFaces; ++f)
  {
    vtkCell* face = cell->GetFace(f);
    const int begin = end;
    for (vtkIdType node = 0; node < face->GetNumberOfPoints(); ++node)
    {
      if (face->GetPointId(node) < shape.NumberOfCorners)
      {
        shape.FacePoints[end++] = static_cast<int>(face->GetPointId(node));
      }
    }
    if (face->GetCellType() == VTK_PIXEL)
    {
      std::swap(shape.FacePoints[begin + 2], shape.FacePoints[begin + 3]);
    }
    shape.FaceOffsets[f + 1] = end;
  }
}

//------------------------------------------------------------------------------
// The number of nodes of VTK's cells of a type; 0 if it varies. Cells of variable order have an
// initial number.
int CountNodes(int cellType)
{
  if (cellType >= VTK_LAGRANGE_CURVE && cellType <= VTK_BEZIER_PYRAMID)
  {
    return 0;
  }
  vtkNew<vtkGenericCell> cell;
  cell->SetCellType(cellType);
  return static_cast<int>(cell->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
struct Row
{
  int CellType;
  int Dimension;
  int NumberOfCorners;
  int FacesOf; // fixed-size type whose faces to take; 0 if none
};

// clang-format off
constexpr Row LinearRows[] = {
  { VTK_VERTEX, 0, 1, 0 }, { VTK_POLY_VERTEX, 0, 0, 0 },
  { VTK_LINE, 1, 2, 0 }, { VTK_POLY_LINE, 1, 0, 0 },
  { VTK_TRIANGLE, 2, 3, 0 }, { VTK_TRIANGLE_STRIP, 2, 0, 0 }, { VTK_POLYGON, 2, 0, 0 },
  { VTK_PIXEL, 2, 4, 0 }, { VTK_QUAD, 2, 4, 0 },
  { VTK_TETRA, 3, 4, VTK_TETRA }, { VTK_VOXEL, 3, 8, VTK_VOXEL },
  { VTK_HEXAHEDRON, 3, 8, VTK_HEXAHEDRON }, { VTK_WEDGE, 3, 6, VTK_WEDGE },
  { VTK_PYRAMID, 3, 5, VTK_PYRAMID }, { VTK_PENTAGONAL_PRISM, 3, 10, VTK_PENTAGONAL_PRISM },
  { VTK_HEXAGONAL_PRISM, 3, 12, VTK_HEXAGONAL_PRISM },
  { VTK_CONVEX_POINT_SET, 3, 0, 0 }, { VTK_POLYHEDRON, 3, 0, 0 },
};
constexpr Row HigherOrderRows[] = {
  { VTK_QUADRATIC_EDGE, 1, 2, 0 }, { VTK_CUBIC_LINE, 1, 2, 0 },
  { VTK_LAGRANGE_CURVE, 1, 2, 0 }, { VTK_BEZIER_CURVE, 1, 2, 0 },
  { VTK_QUADRATIC_TRIANGLE, 2, 3, 0 }, { VTK_BIQUADRATIC_TRIANGLE, 2, 3, 0 },
  { VTK_LAGRANGE_TRIANGLE, 2, 3, 0 }, { VTK_BEZIER_TRIANGLE, 2, 3, 0 },
  { VTK_QUADRATIC_QUAD, 2, 4, 0 }, { VTK_BIQUADRATIC_QUAD, 2, 4, 0 },
  { VTK_QUADRATIC_LINEAR_QUAD, 2, 4, 0 }, { VTK_LAGRANGE_QUADRILATERAL, 2, 4, 0 },
  { VTK_BEZIER_QUADRILATERAL, 2, 4, 0 }, { VTK_QUADRATIC_POLYGON, 2, 0, 0 },
  { VTK_QUADRATIC_TETRA, 3, 4, VTK_TETRA }, { VTK_LAGRANGE_TETRAHEDRON, 3, 4, VTK_TETRA },
  { VTK_BEZIER_TETRAHEDRON, 3, 4, VTK_TETRA },
  { VTK_QUADRATIC_HEXAHEDRON, 3, 8, VTK_HEXAHEDRON },
  { VTK_TRIQUADRATIC_HEXAHEDRON, 3, 8, VTK_HEXAHEDRON },
  { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 3, 8, VTK_HEXAHEDRON },
  { VTK_LAGRANGE_HEXAHEDRON, 3, 8, VTK_HEXAHEDRON }, { VTK_BEZIER_HEXAHEDRON, 3, 8, VTK_HEXAHEDRON },
  { VTK_QUADRATIC_PYRAMID, 3, 5, VTK_PYRAMID }, { VTK_TRIQUADRATIC_PYRAMID, 3, 5, VTK_PYRAMID },
  { VTK_QUADRATIC_WEDGE, 3, 6, VTK_QUADRATIC_WEDGE },
  { VTK_QUADRATIC_LINEAR_WEDGE, 3, 6, VTK_QUADRATIC_WEDGE },
  { VTK_BIQUADRATIC_QUADRATIC_WEDGE, 3, 6, VTK_QUADRATIC_WEDGE },
  { VTK_LAGRANGE_WEDGE, 3, 6, VTK_QUADRATIC_WEDGE }, { VTK_BEZIER_WEDGE, 3, 6, VTK_QUADRATIC_WEDGE },
  { VTK_LAGRANGE_PYRAMID, 3, 5, VTK_PYRAMID }, { VTK_BEZIER_PYRAMID, 3, 5, VTK_PYRAMID },
};
// clang-format on

//------------------------------------------------------------------------------
std::array<CellShape, 256> MakeShapes()
{
  std::array<CellShape, 256> shapes;
  const auto add = [&shapes](const Row& row, bool higherOrder)
  {
    CellShape& shape = shapes[row.CellType];
    shape.Dimension = row.Dimension;
    shape.NumberOfCorners = row.NumberOfCorners;
    shape.NumberOfNodes = CountNodes(row.CellType);
    shape.IsHigherOrder = higherOrder;
    shape.ListsFaces = row.Dimension == 3 && row.FacesOf == 0;
    if (row.FacesOf)
    {
      AddFaces(shape, row.FacesOf);
    }
  };
  for (const Row& row : LinearRows)
  {
    add(row, false);
  }
  for (const Row& row : HigherOrderRows)
  {
    add(row, true);
  }
  return shapes;
}
}

//------------------------------------------------------------------------------
const CellShape& GetCellShape(unsigned char cellType)
{
  static const std::array<CellShape, 256> shapes = MakeShapes();
  return shapes[cellType];
}

//------------------------------------------------------------------------------
vtkIdType GetNumberOfCorners(unsigned char cellType, vtkIdType numberOfPoints)
{
  const int corners = GetCellShape(cellType).NumberOfCorners;
  return corners                        ? corners
    : cellType == VTK_QUADRATIC_POLYGON ? numberOfPoints / 2
                                        : numberOfPoints;
}

//------------------------------------------------------------------------------
bool IsExtrusion(unsigned char wedgeType)
{
  const CellShape& shape = GetCellShape(wedgeType);
  for (int f = 0; f < shape.NumberOfFaces; ++f)
  {
    const int* face = shape.FacePoints + shape.FaceOffsets[f];
    if (shape.FaceOffsets[f + 1] - shape.FaceOffsets[f] == 3 && face[0] + face[1] + face[2] == 3)
    {
      // The face is oriented outward, which is opposite to (0,1,2) in an extrusion.
      const int zero = face[0] == 0 ? 0 : face[1] == 0 ? 1 : 2;
      return face[(zero + 1) % 3] == 2;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
const int* GetExtrusionOrder(unsigned char wedgeType)
{
  static const int same[MaxWedgeNodes] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14 };
  // Nodes 1 and 2, 4 and 5 are swapped, and so are the edges that end there.
  static const int turned[MaxWedgeNodes] = { 0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13 };
  return IsExtrusion(wedgeType) ? same : turned;
}

//------------------------------------------------------------------------------
std::string GetCellTypeName(unsigned char type)
{
  if (type == VTK_EMPTY_CELL)
  {
    return "empty cell";
  }
  const std::string name = GetCellClassName(type); // vtkQuadraticTetra
  if (name.compare(0, 3, "vtk") != 0)
  {
    return std::to_string(static_cast<int>(type));
  }
  std::string words;
  std::size_t last = 0; // where the last word begins
  for (std::size_t i = 3; i < name.size(); ++i)
  {
    const bool isUpper = std::isupper(static_cast<unsigned char>(name[i])) != 0;
    const bool wasLower = i > 3 && !std::isupper(static_cast<unsigned char>(name[i - 1]));
    words += isUpper && wasLower ? " " : "";
    last = isUpper && wasLower ? words.size() : last;
    words += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  }
  for (const auto& [shortened, word] : Shortened)
  {
    if (words.compare(last, std::string::npos, shortened) == 0)
    {
      return words.substr(0, last) + word;
    }
  }
  return words;
}
}
