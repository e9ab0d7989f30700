// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "M3DReading.h"

#include "Intake/CellMesh/CellGrid.h"
#include "Intake/CellMesh/CellRows.h"
#include "Intake/Pieces/ReadMappedFile.h"
#include "M3DElements.h"
#include "M3DSections.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <memory>

namespace camaron
{
namespace
{
constexpr int NodeBytes = 8;    // "1 0 0 0" and a line end
constexpr int MVMNodeBytes = 6; // without a code
constexpr int ElementBytes = 8; // "t 0 1 2" and a line end

//------------------------------------------------------------------------------
struct NodeRow
{
  double Position[3];
  std::int64_t Code = 1;
  double Projection[3] = { 0, 0, 0 };
};

//------------------------------------------------------------------------------
bool ReadNode(TextRow& row, M3DDialect dialect, NodeRow& node)
{
  if (dialect != M3DDialect::MVM)
  {
    if (!row.ReadInteger(node.Code, "the code of a node"))
    {
      return false;
    }
    if (node.Code != static_cast<int>(node.Code))
    {
      return row.FailAtLast(ErrorKind::Syntax, "a 32-bit code of a node");
    }
  }
  return row.ReadPoint(node.Position, "a coordinate of a node") &&
    ((node.Code != 2 && node.Code != 3) ||
      row.ReadPoint(node.Projection, "the projection of a node of code 2 or 3"));
}

//------------------------------------------------------------------------------
class M3DReading
{
public:
  M3DReading(const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings)
    : Request(request)
    , Grid(grid)
    , Messages(warnings)
  {
  }

  /// May be called repeatedly; every call starts anew.
  bool Read(TextScanner& scanner, const TextLines* lines, const Progress& progress);

private:
  bool ReadCounts(TextScanner& scanner);
  bool ReadElements(TextScanner& scanner, const TextLines* lines, const Progress& progress);
  const ElementKind* ReadCell(TextRow& row, std::int32_t* points);
  bool ReadNodes(
    const TextScanner& start, const TextLines* lines, bool withCodes, const Progress& progress);
  bool ReadMaterials(TextScanner scanner, const TextLines* lines, const Progress& progress);
  void AddMaterials();
  void WarnOfRest(TextScanner& scanner);

  PieceRequest Request;
  vtkUnstructuredGrid* Grid;
  Warnings& Messages;

  M3DDialect Dialect = M3DDialect::M3D;
  std::int64_t NumberOfNodes = 0;
  std::int64_t NumberOfElements = 0;
  OtherSections Others;
  CellMeshPiece Piece;
  CellMesh Mesh;
  std::unique_ptr<MaterialTally> Found;
  const char* NodesEnd = nullptr;
  vtkSmartPointer<vtkDataArray> Points, Codes, Projections, Materials;
};

//------------------------------------------------------------------------------
const ElementKind* M3DReading::ReadCell(TextRow& row, std::int32_t* points)
{
  std::int32_t nodes[MaxElementNodes];
  const ElementKind* const kind = ReadElement(row, this->Dialect, this->NumberOfNodes, nodes);
  if (kind)
  {
    const int* const order = kind->GetOrder();
    std::transform(
      order, order + kind->NumberOfNodes, points, [&nodes](int place) { return nodes[place]; });
    if (this->Dialect != M3DDialect::MVM)
    {
      this->Found->Add(row);
    }
  }
  return kind;
}

//------------------------------------------------------------------------------
// All rows are read to check them and to find the piece, then those of the piece to store them.
bool M3DReading::ReadElements(
  TextScanner& scanner, const TextLines* lines, const Progress& progress)
{
  const vtkIdType count = this->NumberOfElements;
  this->Found = std::make_unique<MaterialTally>(scanner.GetEnd());
  if (count == 0)
  {
    return MakeCloud(this->NumberOfNodes, this->Request, this->Piece, this->Mesh);
  }
  const TextScanner start = scanner;
  if (!this->Piece.Find(this->NumberOfNodes, count, this->Request,
        [&]
        {
          scanner = start;
          return ReadRowsOnce(
            scanner, lines, count, progress.Part(0, 0.7),
            [&](vtkIdType i, TextRow& row)
            {
              std::int32_t points[MaxElementNodes];
              const ElementKind* const kind = this->ReadCell(row, points);
              if (kind)
              {
                this->Piece.Visit(i, points, kind->NumberOfNodes);
              }
              return kind != nullptr;
            },
            RowLayout::OneLine);
        }))
  {
    return false;
  }
  scanner = start;
  this->Mesh.NumberOfPoints = this->Piece.GetNumberOfPoints();
  return ReadCells(
    scanner, lines, count, this->Mesh, progress.Part(this->Piece.IsWhole() ? 0 : 0.7, 1),
    [&](vtkIdType i, TextRow& row, CellSink& sink)
    {
      if (this->Piece.FindCell(i) < 0)
      {
        row.Skip();
        return true;
      }
      std::int32_t points[MaxElementNodes];
      const ElementKind* const kind = this->ReadCell(row, points);
      if (!kind)
      {
        return false;
      }
      sink.BeginCell(kind->Type);
      for (int p = 0; p < kind->NumberOfNodes; ++p)
      {
        sink.AddPoint(static_cast<std::int32_t>(this->Piece.FindPoint(points[p])));
      }
      return true;
    },
    RowLayout::OneLine);
}

//------------------------------------------------------------------------------
// Reads the nodes of the piece; if any node of the file has a code, again with the codes.
bool M3DReading::ReadNodes(
  const TextScanner& start, const TextLines* lines, bool withCodes, const Progress& progress)
{
  const vtkIdType size = this->Piece.GetNumberOfPoints();
  Buffer<double> coordinates(3 * size), projections(withCodes ? 3 * size : 0);
  Buffer<int> codes(withCodes ? size : 0);
  std::atomic<bool> hasCodes{ false };
  TextScanner scanner = start;
  if (!ReadRows(
        scanner, lines, this->NumberOfNodes, progress,
        [&](vtkIdType i, TextRow& row)
        {
          NodeRow node;
          if (!ReadNode(row, this->Dialect, node))
          {
            return false;
          }
          if (node.Code != 1)
          {
            hasCodes.store(true, std::memory_order_relaxed);
          }
          const vtkIdType point = this->Piece.FindPoint(i);
          for (int c = 0; c < 3 && point >= 0; ++c)
          {
            // Camarón adds the projection of nodes with code 2.
            const double factor = node.Code == 2 ? 1 : 0;
            coordinates[3 * point + c] = node.Position[c] + factor * node.Projection[c];
          }
          if (withCodes && point >= 0)
          {
            codes[point] = static_cast<int>(node.Code);
            std::copy(node.Projection, node.Projection + 3, projections.data() + 3 * point);
          }
          return true;
        },
        RowLayout::OneLine) ||
    scanner.GetPosition() != this->NodesEnd)
  {
    return false;
  }
  if (hasCodes && !withCodes)
  {
    return this->ReadNodes(start, lines, true, progress);
  }
  this->Points = coordinates.TakeArray<vtkDoubleArray>(3);
  if (withCodes)
  {
    this->Codes = codes.TakeArray<vtkIntArray>(1, NodeCodeName);
    this->Projections = projections.TakeArray<vtkDoubleArray>(3, ProjectionName);
  }
  return true;
}

//------------------------------------------------------------------------------
// True without materials if some are missing.
bool M3DReading::ReadMaterials(
  TextScanner scanner, const TextLines* lines, const Progress& progress)
{
  Buffer<double> materials(MaterialSize * this->Piece.GetNumberOfCells());
  const bool good = ReadRowsOnce(
    scanner, lines, this->NumberOfElements, progress,
    [&](vtkIdType i, TextRow& row)
    {
      std::int32_t nodes[MaxElementNodes];
      double unused[MaterialSize];
      const vtkIdType cell = this->Piece.FindCell(i);
      double* const values = cell < 0 ? unused : materials.data() + MaterialSize * cell;
      return ReadElement(row, this->Dialect, this->NumberOfNodes, nodes) &&
        this->Found->Read(row, values);
    },
    RowLayout::OneLine);
  if (!good)
  {
    return this->Found->IsMissingSomewhere();
  }
  this->Materials = materials.TakeArray<vtkDoubleArray>(MaterialSize, MaterialName);
  return true;
}

//------------------------------------------------------------------------------
// A material common to all elements becomes field data.
void M3DReading::AddMaterials()
{
  if (this->Materials)
  {
    this->Grid->GetCellData()->AddArray(this->Materials);
  }
  else if (this->Found->IsFoundSomewhere() && !this->Found->IsMissingSomewhere())
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(MaterialName);
    array->SetNumberOfComponents(MaterialSize);
    array->InsertNextTuple(this->Found->GetMaterial());
    this->Grid->GetFieldData()->AddArray(array);
  }
}

//------------------------------------------------------------------------------
void M3DReading::WarnOfRest(TextScanner& scanner)
{
  if (scanner.SkipSpace() && *scanner.GetPosition() != '[')
  {
    this->Messages.Add("there is more data after the end of the mesh");
  }
  // No section has this name, so this skips to the end.
  FindSection(scanner, "[\n", scanner.GetBytesLeft(), this->Others);
  if (this->Others.Count > 0)
  {
    this->Messages.Add("sections that are not read: " + std::to_string(this->Others.Count) +
      ", the first is '" + this->Others.First + "'");
  }
}

//------------------------------------------------------------------------------
bool M3DReading::ReadCounts(TextScanner& scanner)
{
  if (!ReadHeading(scanner, this->Dialect, this->Others))
  {
    return false;
  }
  const bool isMVM = this->Dialect == M3DDialect::MVM;
  return scanner.ReadCount(
           this->NumberOfNodes, isMVM ? MVMNodeBytes : NodeBytes, "the number of nodes") &&
    (!isMVM || scanner.ReadCount(this->NumberOfElements, ElementBytes, "the number of elements"));
}

//------------------------------------------------------------------------------
bool M3DReading::Read(TextScanner& scanner, const TextLines* lines, const Progress& progress)
{
  this->Grid->Initialize();
  this->Messages = Warnings();
  this->Others = OtherSections();
  this->Codes = nullptr;
  this->Materials = nullptr;
  if (!this->ReadCounts(scanner))
  {
    return false;
  }
  // The nodes come first, but the elements determine which of them a piece needs.
  const TextScanner nodes = scanner;
  if (!SkipRows(
        scanner, lines, this->NumberOfNodes, progress.Part(0, 0.05),
        [this](vtkIdType, TextRow& row)
        {
          NodeRow node;
          return ReadNode(row, this->Dialect, node);
        },
        RowLayout::OneLine))
  {
    return false;
  }
  this->NodesEnd = scanner.GetPosition();
  if (this->Dialect != M3DDialect::MVM)
  {
    if (scanner.SkipSpace() && *scanner.GetPosition() != '[')
    {
      this->Messages.Add("the section of nodes has more lines than it declares");
    }
    if (!FindSection(scanner, "[elements,", scanner.GetBytesLeft(), this->Others))
    {
      return scanner.FailAt(scanner.GetEnd(), ErrorKind::Truncated, "the section '[Elements,'");
    }
    if (!scanner.ReadCount(this->NumberOfElements, ElementBytes, "the number of elements"))
    {
      return false;
    }
  }
  this->Piece.SetPoints(
    [&](const PieceOfSpace::Visit& visit)
    {
      TextScanner again = nodes;
      return ReadRowsOnce(
        again, lines, this->NumberOfNodes, Progress(),
        [&](vtkIdType i, TextRow& row)
        {
          NodeRow node;
          const bool isGood = ReadNode(row, this->Dialect, node);
          if (isGood)
          {
            visit(i, node.Position);
          }
          return isGood;
        },
        RowLayout::OneLine);
    });
  const TextScanner elements = scanner;
  if (!this->ReadElements(scanner, lines, progress.Part(0.05, 0.5)))
  {
    return false;
  }

  if (!this->ReadNodes(nodes, lines, false, progress.Part(0.5, 0.8)) ||
    (this->Found->Varies() && !this->Found->IsMissingSomewhere() &&
      !this->ReadMaterials(elements, lines, progress.Part(0.8, 0.9))))
  {
    return false;
  }

  if (this->Request.Piece == 0)
  {
    if (this->Found->Varies() && this->Found->IsMissingSomewhere())
    {
      this->Messages.Add("materials are not read, as some elements have none");
    }
    this->Piece.WarnOfRepeatedPoints(
      this->Mesh, this->Messages, progress.Part(0.9, 1), "element", "elements");
    this->WarnOfRest(scanner);
  }
  else
  {
    this->Messages = Warnings();
  }
  FillGrid(this->Mesh, this->Piece, this->Points, this->Grid);
  if (this->Codes)
  {
    this->Grid->GetPointData()->AddArray(this->Codes);
    this->Grid->GetPointData()->AddArray(this->Projections);
  }
  this->AddMaterials();
  return !progress.IsStopped();
}
}

//------------------------------------------------------------------------------
bool IsM3D(const std::string& path)
{
  const MappedFile file(path);
  TextScanner scanner("", file.begin(), file.end(), '#');
  M3DDialect dialect;
  OtherSections others;
  std::int64_t nodes;
  return ReadHeading(scanner, dialect, others) && scanner.ReadInteger(nodes, "");
}

//------------------------------------------------------------------------------
bool ReadM3D(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress, vtkIdType chunk)
{
  M3DReading reading(request, grid, warnings);
  return ReadMappedFile(path, request, grid, warnings, error, progress,
    [&](const MappedFile& file, const Progress& rest)
    {
      return ReadText(file, '#', chunk, error, rest,
        [&](TextScanner& scanner, const TextLines* lines, const Progress& part)
        { return reading.Read(scanner, lines, part); });
    });
}
}
