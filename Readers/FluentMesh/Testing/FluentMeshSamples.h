// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Fluent files for tests, of cells given by VTK's nodes or by faces, in every encoding.
#ifndef camaron_FluentMeshSamples_h
#define camaron_FluentMeshSamples_h

#include "FormatTesting.h"
#include "Intake/Rows/Bytes.h"
#include "Intake/Write/RealFormat.h"
#include "Mesh/CellShape.h"
#include "vtkFluentMeshReader.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

namespace camaron
{
namespace testing
{
struct FluentSample
{
  struct Face
  {
    std::vector<int> Nodes; ///< from 0
    int Cells[2];           ///< from 0, -1 for none; the normal points into the first
    int Zone = 0;           ///< 0: interior or wall
  };
  struct Cell
  {
    int Element; ///< Fluent's number
    int Zone = 2;
  };
  int Dimension = 3;
  std::vector<std::array<double, 3>> Points;
  std::vector<Face> Faces;
  std::vector<Cell> Cells;
  std::map<int, int> BoundaryTypes; ///< of zones other than 3 (interior) and 4 (wall)

  int AddPoint(double x, double y, double z = 0)
  {
    this->Points.push_back({ x, y, z });
    return static_cast<int>(this->Points.size()) - 1;
  }

  /// Adds a cell by faces that are oriented outward.
  void AddCell(int element, const std::vector<std::vector<int>>& outward, int zone = 2)
  {
    const int id = static_cast<int>(this->Cells.size());
    this->Cells.push_back({ element, zone });
    for (std::vector<int> face : outward)
    {
      std::vector<int> key = face;
      std::sort(key.begin(), key.end());
      const auto known = std::find_if(this->Faces.begin(), this->Faces.end(),
        [&](const Face& f)
        {
          std::vector<int> other = f.Nodes;
          std::sort(other.begin(), other.end());
          return other == key;
        });
      if (known != this->Faces.end())
      {
        known->Cells[1] = id;
        continue;
      }
      if (this->Dimension == 3)
      {
        std::reverse(face.begin(), face.end()); // the normal points into the first cell
      }
      this->Faces.push_back({ face, { id, -1 } });
    }
  }
  /// Adds a cell by nodes in VTK's order.
  void AddVTKCell(int element, int type, const std::vector<int>& nodes, int zone = 2)
  {
    const CellShape& shape = GetCellShape(static_cast<unsigned char>(type));
    std::vector<std::vector<int>> faces;
    for (int f = 0; f < shape.NumberOfFaces; ++f)
    {
      faces.emplace_back();
      for (int i = shape.FaceOffsets[f]; i < shape.FaceOffsets[f + 1]; ++i)
      {
        faces.back().push_back(nodes[static_cast<std::size_t>(shape.FacePoints[i])]);
      }
    }
    this->AddCell(element, faces, zone);
  }
  /// Adds a 2D cell by its nodes, counterclockwise if it is not inverted.
  void AddPolygon(int element, const std::vector<int>& nodes, int zone = 2)
  {
    std::vector<std::vector<int>> edges;
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      edges.push_back({ nodes[i], nodes[(i + 1) % nodes.size()] });
    }
    this->AddCell(element, edges, zone);
  }
};

struct FluentEncoding
{
  int RealSize = 0;     ///< 0 for text
  bool Swap = false;    ///< big endian
  bool Uniform = false; ///< one section per face size and cell type
  std::string LineEnd = "\n";
  std::string Gap; ///< between "(" and binary data
  bool NodesLast = false;
  bool HasDimension = true;
};

/// Appends sections with data to a file.
class FluentWords
{
public:
  FluentWords(std::string& bytes, const FluentEncoding& encoding)
    : Bytes(bytes)
    , How(encoding)
  {
  }
  void Open(int index, const std::vector<int>& header, bool hasBody = true)
  {
    this->Index = this->How.RealSize == 0 ? index : index + (this->How.RealSize == 4 ? 2000 : 3000);
    this->Bytes += "(" + std::to_string(this->Index) + " (";
    for (std::size_t i = 0; i < header.size(); ++i)
    {
      this->Bytes += i > 0 ? " " : "";
      AppendHex(this->Bytes, static_cast<std::uint64_t>(header[i]));
    }
    this->Bytes += ")";
    this->HasBody = hasBody;
    if (hasBody)
    {
      this->Bytes += this->How.RealSize > 0 ? "\n(" + this->How.Gap : "(" + this->How.LineEnd;
    }
  }
  void Integer(int value, bool endOfRow)
  {
    if (this->How.RealSize > 0)
    {
      AppendBytes(this->Bytes, static_cast<std::int32_t>(value), this->How.Swap);
      return;
    }
    AppendHex(this->Bytes, static_cast<std::uint64_t>(value));
    this->Bytes += endOfRow ? this->How.LineEnd : " ";
  }
  void Real(double value, bool endOfRow)
  {
    if (this->How.RealSize == 4)
    {
      AppendBytes(this->Bytes, static_cast<float>(value), this->How.Swap);
    }
    else if (this->How.RealSize == 8)
    {
      AppendBytes(this->Bytes, value, this->How.Swap);
    }
    else
    {
      AppendNumber(this->Bytes, value);
      this->Bytes += endOfRow ? this->How.LineEnd : " ";
    }
  }
  void Close()
  {
    if (this->How.RealSize == 0)
    {
      this->Bytes += this->HasBody ? "))\n" : ")\n";
      return;
    }
    this->Bytes += this->HasBody ? ")" : "";
    this->Bytes += "\nEnd of Binary Section   " + std::to_string(this->Index) + ")\n";
  }

private:
  std::string& Bytes;
  const FluentEncoding& How;
  int Index = 0;
  bool HasBody = true;
};

inline std::string Encode(const FluentSample& mesh, const FluentEncoding& how = {})
{
  std::string bytes = "(0 \"a sample :-)\")\n";
  bytes += how.HasDimension ? "(2 " + std::to_string(mesh.Dimension) + ")\n" : "";
  bytes += how.RealSize > 0
    ? how.Swap ? "(4 (17 0 0 1 2 4 4 4 8 8 8 4))\n" : "(4 (60 0 0 1 2 4 4 4 8 8 8 4))\n"
    : "";
  const auto declare = [&bytes](int index, std::size_t count, const std::string& more)
  {
    bytes += "(" + std::to_string(index) + " (0 1 ";
    AppendHex(bytes, count);
    bytes += " 0" + more + "))\n";
  };
  declare(10, mesh.Points.size(), " " + std::to_string(mesh.Dimension));
  declare(12, mesh.Cells.size(), "");
  declare(13, mesh.Faces.size(), "");
  FluentWords words(bytes, how);
  const auto writeNodes = [&]
  {
    words.Open(10, { 1, 1, static_cast<int>(mesh.Points.size()), 1, mesh.Dimension });
    for (const auto& point : mesh.Points)
    {
      for (int c = 0; c < mesh.Dimension; ++c)
      {
        words.Real(point[static_cast<std::size_t>(c)], c + 1 == mesh.Dimension);
      }
    }
    words.Close();
  };
  if (!how.NodesLast)
  {
    writeNodes();
  }

  // Consecutive cells of a zone, and of one type if sections are uniform.
  for (std::size_t begin = 0; begin < mesh.Cells.size();)
  {
    std::size_t end = begin;
    bool same = true;
    while (end < mesh.Cells.size() && mesh.Cells[end].Zone == mesh.Cells[begin].Zone &&
      (!how.Uniform || mesh.Cells[end].Element == mesh.Cells[begin].Element))
    {
      same = same && mesh.Cells[end].Element == mesh.Cells[begin].Element;
      ++end;
    }
    words.Open(12,
      { mesh.Cells[begin].Zone, static_cast<int>(begin) + 1, static_cast<int>(end), 1,
        same ? mesh.Cells[begin].Element : 0 },
      !same);
    for (std::size_t i = begin; i < end && !same; ++i)
    {
      words.Integer(mesh.Cells[i].Element, i % 9 == 8);
    }
    words.Close();
    begin = end;
  }

  // Faces by zone, and by size if sections are uniform.
  const auto getZone = [](const FluentSample::Face& face)
  {
    return face.Zone > 0 ? face.Zone : face.Cells[1] >= 0 ? 3 : 4;
  };
  std::map<std::pair<int, std::size_t>, std::vector<const FluentSample::Face*>> groups;
  for (const FluentSample::Face& face : mesh.Faces)
  {
    groups[{ getZone(face), how.Uniform ? face.Nodes.size() : 0 }].push_back(&face);
  }
  int first = 1;
  for (const auto& group : groups)
  {
    const int zone = group.first.first;
    const auto type = mesh.BoundaryTypes.find(zone);
    const auto size = static_cast<int>(group.first.second);
    const bool isSized = how.Uniform && size <= 4;
    const int last = first + static_cast<int>(group.second.size()) - 1;
    words.Open(13,
      { zone, first, last,
        type != mesh.BoundaryTypes.end() ? type->second
          : zone == 3                    ? 2
                                         : 3,
        isSized         ? size
          : how.Uniform ? 5
                        : 0 });
    for (const FluentSample::Face* face : group.second)
    {
      if (!isSized)
      {
        words.Integer(static_cast<int>(face->Nodes.size()), false);
      }
      for (const int node : face->Nodes)
      {
        words.Integer(node + 1, false);
      }
      words.Integer(face->Cells[0] + 1, false);
      words.Integer(face->Cells[1] + 1, true);
    }
    words.Close();
    first = last + 1;
  }
  if (how.NodesLast)
  {
    writeNodes();
  }
  return bytes +
    "(45 (2 fluid water)())\n(45 (3 interior inside)())\n(39 (4 wall skin 1)(\n(a . \")\")))\n";
}

//------------------------------------------------------------------------------
/// Stacked layers, each of a hexahedron, two wedges, a pyramid and a tetrahedron next to each
/// other.
inline FluentSample MakeMixed(int columns = 2)
{
  FluentSample mesh;
  std::vector<std::array<int, 10>> levels;
  for (int level = 0; level <= columns; ++level)
  {
    const double z = level * 1.25;
    std::array<int, 10> ids{};
    const double places[6][2] = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 0, 1 }, { 1, 1.1 }, { 2, 1 } };
    for (std::size_t i = 0; i < 6; ++i)
    {
      ids[i] = mesh.AddPoint(places[i][0], places[i][1], z);
    }
    levels.push_back(ids);
  }
  for (std::size_t l = 0; l + 1 < levels.size(); ++l)
  {
    const auto& a = levels[l];
    const auto& b = levels[l + 1];
    mesh.AddVTKCell(4, VTK_HEXAHEDRON, { a[0], a[1], a[4], a[3], b[0], b[1], b[4], b[3] }, 2);
    // Nodes of a wedge of VTK: the first triangle faces outward.
    mesh.AddVTKCell(6, VTK_WEDGE, { a[1], a[5], a[2], b[1], b[5], b[2] }, 5);
    mesh.AddVTKCell(6, VTK_WEDGE, { a[1], a[4], a[5], b[1], b[4], b[5] }, 5);
    const int apex = mesh.AddPoint(-0.7, 0.5, l * 1.25 + 0.6);
    mesh.AddVTKCell(5, VTK_PYRAMID, { a[0], b[0], b[3], a[3], apex }, 5);
    const int top = mesh.AddPoint(-0.7, 0.5, l * 1.25 + 1.5);
    mesh.AddVTKCell(2, VTK_TETRA, { b[0], b[3], apex, top }, 2);
  }
  return mesh;
}

/// A ring of 2D cells: triangles, quadrilaterals and a polygon.
inline FluentSample MakeFlat(int columns = 3)
{
  FluentSample mesh;
  mesh.Dimension = 2;
  int lower = mesh.AddPoint(0, 0), upper = mesh.AddPoint(0, 1);
  for (int i = 0; i < columns; ++i)
  {
    const int nextLower = mesh.AddPoint(i + 1, 0), nextUpper = mesh.AddPoint(i + 1, 1);
    if (i % 3 == 0)
    {
      mesh.AddPolygon(3, { lower, nextLower, nextUpper, upper });
    }
    else if (i % 3 == 1)
    {
      mesh.AddPolygon(1, { lower, nextLower, nextUpper });
      mesh.AddPolygon(1, { lower, nextUpper, upper });
    }
    else
    {
      const int middle = mesh.AddPoint(i + 0.5, -0.25);
      mesh.AddPolygon(7, { lower, middle, nextLower, nextUpper, upper });
    }
    lower = nextLower;
    upper = nextUpper;
  }
  return mesh;
}

/// All encodings, with their description.
inline std::vector<FluentEncoding> GetEncodings()
{
  std::vector<FluentEncoding> all;
  for (const int size : { 0, 4, 8 })
  {
    for (const bool uniform : { false, true })
    {
      FluentEncoding how;
      how.RealSize = size;
      how.Uniform = uniform;
      all.push_back(how);
      how.NodesLast = true;
      how.LineEnd = "\r\n";
      how.Gap = "\r\n";
      how.Swap = true;
      all.push_back(how);
    }
  }
  return all;
}

//------------------------------------------------------------------------------
/// The faces of a cell of a sample, oriented outward, each from its smallest node.
using FaceSet = std::set<std::vector<vtkIdType>>;
inline void Normalize(std::vector<vtkIdType>& face)
{
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
}
inline FaceSet GetFaceSet(const FluentSample& mesh, int cell)
{
  FaceSet faces;
  for (const FluentSample::Face& face : mesh.Faces)
  {
    for (int side = 0; side < 2; ++side)
    {
      if (face.Cells[side] == cell && !face.Nodes.empty())
      {
        std::vector<vtkIdType> nodes(face.Nodes.begin(), face.Nodes.end());
        if (side == 0)
        {
          std::reverse(nodes.begin(), nodes.end());
        }
        Normalize(nodes);
        faces.insert(nodes);
      }
    }
  }
  return faces;
}
inline FaceSet GetFaceSet(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  FaceSet faces;
  const MeshView mesh(grid);
  CellFacets(mesh).ForEach(cell,
    [&](const vtkIdType* points, vtkIdType size, vtkIdType)
    {
      std::vector<vtkIdType> face(points, points + size);
      Normalize(face);
      faces.insert(face);
    });
  return faces;
}

//------------------------------------------------------------------------------
/// A cube next to four slabs that were refined; the face between is split. Without parents, it has
/// nine faces.
inline FluentSample MakeHangingSample(bool withTree, int element)
{
  FluentSample mesh;
  std::vector<int> cube;
  for (int i = 0; i < 8; ++i)
  {
    cube.push_back(mesh.AddPoint((i & 1) ^ (i >> 1 & 1), i >> 1 & 1, i >> 2));
  }
  // Positions (y, z) of a 3 x 3 grid on the side x = 1 and behind it.
  int front[3][3], back[3][3];
  for (int y = 0; y < 3; ++y)
  {
    for (int z = 0; z < 3; ++z)
    {
      const bool isCorner = y != 1 && z != 1;
      front[y][z] = isCorner ? cube[static_cast<std::size_t>((y == 0 ? 1 : 2) + (z == 0 ? 0 : 4))]
                             : mesh.AddPoint(1, y / 2., z / 2.);
      back[y][z] = mesh.AddPoint(1.5, y / 2., z / 2.);
    }
  }
  std::vector<std::vector<int>> faces = { { cube[0], cube[4], cube[7], cube[3] },
    { cube[0], cube[1], cube[5], cube[4] }, { cube[3], cube[7], cube[6], cube[2] },
    { cube[0], cube[3], cube[2], cube[1] }, { cube[4], cube[5], cube[6], cube[7] } };
  for (int y = 0; y < 2; ++y)
  {
    for (int z = 0; z < 2; ++z)
    {
      faces.push_back({ front[y][z], front[y + 1][z], front[y + 1][z + 1], front[y][z + 1] });
    }
  }
  mesh.AddCell(element, faces);
  for (int y = 0; y < 2; ++y)
  {
    for (int z = 0; z < 2; ++z)
    {
      mesh.AddVTKCell(4, VTK_HEXAHEDRON,
        { front[y][z], back[y][z], back[y + 1][z], front[y + 1][z], front[y][z + 1], back[y][z + 1],
          back[y + 1][z + 1], front[y + 1][z + 1] });
    }
  }
  if (withTree)
  {
    // The interior faces come first; the split one comes last, and belongs to the parent of the
    // slabs.
    mesh.Cells.push_back({ 4, 9 });
    mesh.BoundaryTypes[8] = 31;
    mesh.Faces.push_back({ { cube[1], cube[5], cube[6], cube[2] }, { 0, 5 }, 8 });
  }
  return mesh;
}

/// The file of it.
inline std::string MakeHanging(bool withTree, int element, const FluentEncoding& how = {})
{
  const FluentSample mesh = MakeHangingSample(withTree, element);
  std::string bytes;
  if (withTree)
  {
    bytes = Encode(mesh, how);
    const std::string parent = "12 (9 6 6 1 4)", inactive = "12 (9 6 6 20 4)";
    bytes.replace(bytes.find(parent), parent.size(), inactive);
    std::string last;
    AppendHex(last, mesh.Faces.size());
    if (how.RealSize > 0)
    {
      const auto face = static_cast<int>(mesh.Faces.size());
      FluentWords words(bytes, how);
      words.Open(59, { face, face, 8, 3 });
      for (const int word : { 4, 1, 2, 3, 4 })
      {
        words.Integer(word, false);
      }
      words.Close();
      return bytes;
    }
    return bytes + "(59 (" + last + " " + last +
      " 8 3)(\n4 1 2 3 4\n))\n(58 (6 6 9 2)(\n4 2 3 4 5\n))\n";
  }
  return Encode(mesh);
}

//------------------------------------------------------------------------------
inline Result ReadBytes(const std::string& bytes, const std::string& name = "test.msh")
{
  return ReadWith<vtkFluentMeshReader>(File(bytes, name).Path);
}

/// The points of a cell, ascending.
inline std::vector<vtkIdType> GetSortedPoints(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  const IndexRange points = MeshView(grid).GetCellPoints(cell);
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < points.Size; ++i)
  {
    ids.push_back(points[i]);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}
}
}

#endif
