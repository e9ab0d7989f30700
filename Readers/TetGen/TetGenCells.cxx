// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TetGenCells.h"

#include "Intake/CellMesh/PieceRows.h"

#include "vtkCellData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <set>

namespace camaron
{
namespace
{
constexpr int TetrahedronNodes = 10, TriangleNodes = 6, EdgeNodes = 3; // of quadratic cells

//------------------------------------------------------------------------------
struct Names
{
  const char* One;
  const char* Many;
  const char* Header;
  const char* Count;
  const char* Id;
  const char* Node;
};

const Names& GetNames(TetGenKind kind)
{
  static const Names element = { "element", "elements",
    "elements of TetGen or Triangle, whose first line has the number of elements, of nodes per "
    "element and of attributes",
    "the number of elements", "the id of an element", "a node of an element" };
  static const Names face = { "face", "faces",
    "faces of TetGen, whose first line has the number of faces and a flag for markers",
    "the number of faces", "the id of a face", "a node of a face" };
  static const Names edge = { "edge", "edges",
    "edges of TetGen or Triangle, whose first line has the number of edges and a flag for markers",
    "the number of edges", "the id of an edge", "a node of an edge" };
  return kind == TetGenKind::Ele ? element : kind == TetGenKind::Face ? face : edge;
}

//------------------------------------------------------------------------------
// Counts the words of a row.
int CountColumns(TextScanner scanner)
{
  constexpr int Enough = 16; // more than the columns of any table of faces or edges
  if (!scanner.SkipSpace())
  {
    return 0;
  }
  TextRow row(scanner);
  std::string_view word;
  int columns = 0;
  while (columns < Enough && row.HasMore() && row.ReadWord(word, ""))
  {
    ++columns;
  }
  return columns;
}

//------------------------------------------------------------------------------
unsigned char GetType(int corners, bool isQuadratic)
{
  switch (corners)
  {
    case 4:
      return isQuadratic ? VTK_QUADRATIC_TETRA : VTK_TETRA;
    case 3:
      return isQuadratic ? VTK_QUADRATIC_TRIANGLE : VTK_TRIANGLE;
    default:
      return isQuadratic ? VTK_QUADRATIC_EDGE : VTK_LINE;
  }
}

//------------------------------------------------------------------------------
// The columns of a row of faces: id, three vertices, three midside nodes if quadratic, marker, two
// adjacent tetrahedra. The header only declares the marker.
void SetFaceColumns(int columns, bool hasMarkers, TetGenCells::Header& header)
{
  int rest = columns - 4;
  header.NumberOfNodes = header.Corners = 3;
  if (rest > 3 || (rest == 3 && !hasMarkers))
  {
    header.NumberOfNodes = TriangleNodes;
    rest -= 3;
  }
  header.Columns.Markers = rest == 1 || rest >= 3 || (rest == 2 && hasMarkers);
  header.Columns.Tetrahedra = rest >= 3 || (rest == 2 && !hasMarkers) ? 2 : 0;
}

//------------------------------------------------------------------------------
// The columns of a row of edges: id, two vertices, a midside node if quadratic, marker, an adjacent
// tetrahedron. Whether the column after the vertices is a midside node must be inferred.
void SetEdgeColumns(int columns, bool hasMarkers, bool hasMidpoints, TetGenCells::Header& header)
{
  const int rest = columns - 3 - (hasMidpoints ? 1 : 0);
  header.NumberOfNodes = hasMidpoints ? EdgeNodes : 2;
  header.Columns.Markers = hasMarkers && rest >= 1;
  header.Columns.Tetrahedra = rest >= (hasMarkers ? 2 : 1) ? 1 : 0;
}

//------------------------------------------------------------------------------
bool IsKnownNumberOfNodes(std::int64_t nodes)
{
  return nodes == 3 || nodes == 4 || nodes == TriangleNodes || nodes == TetrahedronNodes;
}
}

//------------------------------------------------------------------------------
bool TetGenCells::ReadHeader(
  TextScanner& scanner, TetGenKind kind, Header& header, ErrorKind notThis)
{
  const Names& names = GetNames(kind);
  const bool isElements = kind == TetGenKind::Ele;
  header = Header();
  std::int64_t numbers[3] = { 0, isElements ? 4 : 0, 0 };
  if (!ReadTetGenHeader(scanner, numbers, isElements ? 3 : 2, notThis, names.Header))
  {
    return false;
  }
  int perRow = 1;
  if (isElements)
  {
    scanner.SkipSpace();
    const std::int64_t nodes = numbers[1], attributes = numbers[2];
    if (!IsKnownNumberOfNodes(nodes))
    {
      return scanner.FailAt(scanner.GetPosition(), ErrorKind::Unsupported,
        "elements with 3, 4, 6 or 10 nodes, as the second number of the first line",
        std::to_string(nodes));
    }
    if (!CheckTetGenAttributes(scanner, attributes, "elements"))
    {
      return false;
    }
    header.NumberOfNodes = static_cast<int>(nodes);
    header.Corners = nodes == 4 || nodes == TetrahedronNodes ? 4 : 3;
    header.Columns.Attributes = static_cast<int>(attributes);
    perRow += header.NumberOfNodes + header.Columns.Attributes;
  }
  else
  {
    header.Corners = header.NumberOfNodes = kind == TetGenKind::Face ? 3 : 2;
    header.Columns.Markers = numbers[1] != 0;
    perRow += header.Corners;
  }
  if (!scanner.ReadCount(header.Count, BytesPerNumber * perRow, names.Count))
  {
    return false;
  }
  scanner.SkipLine();
  return true;
}

//------------------------------------------------------------------------------
// Midside nodes belong to one edge each and are not vertices; markers and tetrahedra repeat, or are
// not node ids. This is inferred from the first edges.
bool TetGenCells::HasMidpoints(TextScanner scanner, const TetGenNodes& nodes) const
{
  constexpr std::int64_t Enough = 100;
  std::set<std::int32_t> corners, midpoints;
  const std::int64_t count = std::min(this->Table.Count, Enough);
  for (std::int64_t i = 0; i < count; ++i)
  {
    TextRow row(scanner, RowLayout::OneLine);
    std::int64_t numbers[4] = { 0, 0, 0, 0 };
    for (std::int64_t& number : numbers)
    {
      if (!row.ReadInteger(number, ""))
      {
        return false;
      }
    }
    const std::int32_t midpoint = nodes.Find(numbers[3]);
    if (midpoint < 0 || !midpoints.insert(midpoint).second)
    {
      return false;
    }
    corners.insert({ nodes.Find(numbers[1]), nodes.Find(numbers[2]) });
    scanner.SkipLine();
  }
  return std::none_of(midpoints.begin(), midpoints.end(),
    [&](std::int32_t midpoint) { return corners.count(midpoint) > 0; });
}

//------------------------------------------------------------------------------
// Reads a row into a cell of the piece, or, with -1, only checks it.
bool TetGenCells::ReadRow(
  TextRow& row, vtkIdType number, const TetGenNodes& nodes, std::int32_t* points, vtkIdType cell)
{
  const Names& names = GetNames(this->Kind);
  std::int32_t id;
  if (!row.ReadId(id, 0, INT32_MAX, names.Id))
  {
    return false;
  }
  const int size = this->Table.NumberOfNodes;
  for (int i = 0; i < size; ++i)
  {
    if (!nodes.ReadPoint(row, points[i], names.Node))
    {
      return false;
    }
  }
  if (id != number && this->CountsFromZero.load(std::memory_order_relaxed))
  {
    this->CountsFromZero = false;
  }
  if (number == 0)
  {
    this->FirstCell.assign(points, points + size);
  }
  if (cell >= 0)
  {
    this->Ids[cell] = id;
  }
  if (this->AllIds.size() > 0)
  {
    this->AllIds[number] = id;
  }
  return this->Columns.Read(row, number, cell);
}

//------------------------------------------------------------------------------
bool TetGenCells::ReadHeaderAndColumns(
  TextScanner& scanner, const TetGenNodes& nodes, ErrorKind notThis)
{
  if (!ReadHeader(scanner, this->Kind, this->Table, notThis))
  {
    return false;
  }
  Header& table = this->Table;
  if (this->Kind == TetGenKind::Ele && table.Corners == 4 && nodes.GetDimension() == 2)
  {
    return scanner.FailAt(scanner.GetPosition(), ErrorKind::Unsupported,
      "elements with 3 or 6 nodes, as nodes are in 2 dimensions",
      std::to_string(table.NumberOfNodes));
  }
  if (this->Kind != TetGenKind::Ele && table.Count > 0)
  {
    const int columns = CountColumns(scanner);
    if (this->Kind == TetGenKind::Face)
    {
      SetFaceColumns(columns, table.Columns.Markers, table);
    }
    else
    {
      // A single further column is the marker if the header declares one.
      const bool mayHave = columns > (table.Columns.Markers ? 4 : 3);
      SetEdgeColumns(
        columns, table.Columns.Markers, mayHave && this->HasMidpoints(scanner, nodes), table);
    }
  }
  if (table.Count * table.NumberOfNodes > INT32_MAX)
  {
    return scanner.FailAt(scanner.GetPosition(), ErrorKind::Unsupported,
      "fewer than 2147483648 nodes of all cells together",
      std::to_string(table.Count * table.NumberOfNodes));
  }
  return true;
}

//------------------------------------------------------------------------------
bool TetGenCells::Read(TextScanner& scanner, const TextLines* lines, const TetGenNodes& nodes,
  const PieceRequest& request, CellMeshPiece& piece, const Progress& progress, ErrorKind notThis)
{
  if (!this->ReadHeaderAndColumns(scanner, nodes, notThis))
  {
    return false;
  }
  const vtkIdType count = this->Table.Count;
  const unsigned char type = GetType(this->Table.Corners, this->IsQuadratic());
  this->IsWhole = request.NumberOfPieces <= 1;
  this->AllIds = Buffer<std::int32_t>(this->KeepsIds && !this->IsWhole ? count : 0);
  this->CountsFromZero = true;
  this->FirstCell.clear();
  this->Columns.Start(this->Table.Columns, count);
  const PieceRows rows(
    scanner, lines, { nodes.GetCount(), count, type, this->Table.NumberOfNodes });
  if (!rows.Find(request, piece, progress.Part(0, 0.7),
        [&](vtkIdType i, TextRow& row, std::int32_t* points)
        { return this->ReadRow(row, i, nodes, points, -1); }))
  {
    return false;
  }
  this->Ids = Buffer<std::int32_t>(piece.GetNumberOfCells());
  this->Columns.Allocate(piece.GetNumberOfCells());
  if (!rows.Read(piece, this->Mesh, progress.Part(this->IsWhole ? 0 : 0.7, 1),
        [&](vtkIdType i, TextRow& row, std::int32_t* points, vtkIdType cell)
        { return this->ReadRow(row, i, nodes, points, cell); }))
  {
    return false;
  }
  // If rows of a whole mesh were read twice, because the file was read again, they may differ.
  vtkIdType same = 0;
  while (this->IsWhole && same < count && this->Ids[same] == same)
  {
    ++same;
  }
  this->CountsFromZero = this->IsWhole ? same == count : this->CountsFromZero.load();
  return true;
}

//------------------------------------------------------------------------------
void TetGenCells::AddArrays(vtkUnstructuredGrid* grid)
{
  this->Columns.AddTo(grid->GetCellData(), "Region");
  if (!this->CountsFromZero)
  {
    AddIntegers(grid->GetCellData(), "OriginalCellId", std::move(this->Ids));
  }
}

//------------------------------------------------------------------------------
void TetGenCells::Warn(Warnings& warnings) const
{
  const Names& names = GetNames(this->Kind);
  this->Columns.Warn(warnings, names.One, names.Many);
}
}
