// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "M3DReading.h"

#include "Intake/CellMesh/CellGrid.h"
#include "Intake/Pieces/ReadMappedFile.h"
#include "M3DElementRows.h"
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
  M3DReading(const PieceRequest& request, const M3DOptions& options, vtkUnstructuredGrid* grid,
    Warnings& warnings)
    : Request(request)
    , Options(options)
    , Grid(grid)
    , Messages(warnings)
  {
  }

  /// May be called repeatedly; every call starts anew.
  bool Read(
    TextScanner& scanner, const TextLines* lines, RowLayout layout, const Progress& progress);

private:
  bool ReadCounts(TextScanner& scanner);
  bool ReadElements(TextScanner& scanner, const TextLines* lines, const Progress& progress);
  bool ReadNodes(TextScanner scanner, const TextLines* lines, const CellMeshPiece& piece,
    const Progress& progress);
  bool ReadCodes(TextScanner scanner, const TextLines* lines, const CellMeshPiece& piece,
    const Progress& progress);
  bool ReadMaterials(TextScanner scanner, const TextLines* lines, const CellMeshPiece& piece,
    const Progress& progress);
  void AddMaterials();
  void WarnOfRest(TextScanner& scanner);

  PieceRequest Request;
  M3DOptions Options;
  vtkUnstructuredGrid* Grid;
  Warnings& Messages;

  RowLayout Layout = RowLayout::OneLine;
  M3DDialect Dialect = M3DDialect::M3D;
  std::int64_t NumberOfNodes = 0;
  std::int64_t NumberOfElements = 0;
  OtherSections Others;
  CellMeshPiece Piece;
  CellMesh Mesh;
  std::unique_ptr<MaterialTally> Found;
  const char* NodesEnd = nullptr;
  std::atomic<bool> HasCodes{ false };
  vtkSmartPointer<vtkDataArray> Points, Codes, Projections, Materials;
};

//------------------------------------------------------------------------------
bool M3DReading::ReadElements(
  TextScanner& scanner, const TextLines* lines, const Progress& progress)
{
  this->Found = std::make_unique<MaterialTally>(scanner.GetEnd());
  if (this->NumberOfElements == 0)
  {
    return MakeCloud(this->NumberOfNodes, this->Request, this->Piece, this->Mesh);
  }
  const M3DElementRows rows(this->Dialect, this->NumberOfNodes, this->Layout);
  return rows.Read(scanner, lines, this->NumberOfElements, this->Request, this->Piece, this->Mesh,
    *this->Found, progress);
}

//------------------------------------------------------------------------------
// Checks all nodes for codes, and keeps the coordinates of those in the piece.
bool M3DReading::ReadNodes(
  TextScanner scanner, const TextLines* lines, const CellMeshPiece& piece, const Progress& progress)
{
  Buffer<double> coordinates(3 * piece.GetNumberOfPoints());
  const bool good = ReadRows(
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
        this->HasCodes.store(true, std::memory_order_relaxed);
      }
      if (const vtkIdType point = piece.FindPoint(i); point >= 0)
      {
        const double factor = node.Code == 2 && this->Options.AddProjection ? 1 : 0;
        for (int c = 0; c < 3; ++c)
        {
          coordinates[3 * point + c] = node.Position[c] + factor * node.Projection[c];
        }
      }
      return true;
    },
    this->Layout);
  this->Points = coordinates.TakeArray<vtkDoubleArray>(3);
  return good && scanner.GetPosition() == this->NodesEnd;
}

//------------------------------------------------------------------------------
bool M3DReading::ReadCodes(
  TextScanner scanner, const TextLines* lines, const CellMeshPiece& piece, const Progress& progress)
{
  Buffer<int> codes(piece.GetNumberOfPoints());
  Buffer<double> projections(3 * piece.GetNumberOfPoints());
  const bool good = ReadRows(
    scanner, lines, this->NumberOfNodes, progress,
    [&](vtkIdType i, TextRow& row)
    {
      NodeRow node;
      const bool isGood = ReadNode(row, this->Dialect, node);
      if (const vtkIdType point = piece.FindPoint(i); isGood && point >= 0)
      {
        codes[point] = static_cast<int>(node.Code);
        std::copy(node.Projection, node.Projection + 3, projections.data() + 3 * point);
      }
      return isGood;
    },
    this->Layout);
  this->Codes = codes.TakeArray<vtkIntArray>(1, NodeCodeName);
  this->Projections = projections.TakeArray<vtkDoubleArray>(3, ProjectionName);
  return good;
}

//------------------------------------------------------------------------------
// True without materials if some are missing.
bool M3DReading::ReadMaterials(
  TextScanner scanner, const TextLines* lines, const CellMeshPiece& piece, const Progress& progress)
{
  const M3DElementRows rows(this->Dialect, this->NumberOfNodes, this->Layout);
  Buffer<double> materials(MaterialSize * piece.GetNumberOfCells());
  const bool good = ReadRowsOnce(
    scanner, lines, this->NumberOfElements, progress,
    [&](vtkIdType i, TextRow& row)
    {
      std::int32_t nodes[MaxElementNodes];
      double unused[MaterialSize];
      const vtkIdType cell = piece.FindCell(i);
      double* const values = cell < 0 ? unused : materials.data() + MaterialSize * cell;
      return rows.ReadElement(row, nodes) && this->Found->Read(row, values);
    },
    this->Layout);
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
bool M3DReading::Read(
  TextScanner& scanner, const TextLines* lines, RowLayout layout, const Progress& progress)
{
  this->Grid->Initialize();
  this->Messages = Warnings();
  this->Others = OtherSections();
  this->Layout = layout;
  this->HasCodes = false;
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
        this->Layout))
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
        this->Layout);
    });
  const TextScanner elements = scanner;
  if (!this->ReadElements(scanner, lines, progress.Part(0.05, 0.5)))
  {
    return false;
  }

  const CellMeshPiece& piece = this->Piece;
  if (!this->ReadNodes(nodes, lines, piece, progress.Part(0.5, 0.7)) ||
    (this->HasCodes && !this->ReadCodes(nodes, lines, piece, progress.Part(0.7, 0.8))) ||
    (this->Found->Varies() && !this->Found->IsMissingSomewhere() &&
      !this->ReadMaterials(elements, lines, piece, progress.Part(0.8, 0.9))))
  {
    return false;
  }

  if (this->Request.Piece == 0)
  {
    if (this->Found->Varies() && this->Found->IsMissingSomewhere())
    {
      this->Messages.Add("materials are not read, as some elements have none");
    }
    piece.WarnOfRepeatedPoints(
      this->Mesh, this->Messages, progress.Part(0.9, 1), "element", "elements");
    this->WarnOfRest(scanner);
  }
  else
  {
    this->Messages = Warnings();
  }
  FillGrid(this->Mesh, piece, this->Points, this->Grid);
  if (this->HasCodes)
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
bool ReadM3D(const std::string& path, const PieceRequest& request, const M3DOptions& options,
  vtkUnstructuredGrid* grid, Warnings& warnings, ScanError& error, const Progress& progress,
  vtkIdType chunk)
{
  M3DReading reading(request, options, grid, warnings);
  return ReadMappedFile(path, request, grid, warnings, error, progress,
    [&](const MappedFile& file, const Progress& rest)
    {
      const auto read = [&](RowLayout layout, vtkIdType chunkSize, ScanError& why)
      {
        return ReadText(file, '#', chunkSize, why, rest,
          [&](TextScanner& scanner, const TextLines* lines, const Progress& part)
          { return reading.Read(scanner, lines, layout, part); });
      };
      if (read(RowLayout::OneLine, chunk, error))
      {
        return true;
      }
      // Camarón reads numbers regardless of line ends; counts and headings must be valid all the
      // same.
      ScanError ignored;
      const bool isFree = error.Kind == ErrorKind::Syntax &&
        read(RowLayout::Free, file.end() - file.begin() + 1, ignored);
      error = isFree || rest.IsStopped() ? ScanError() : error;
      return isFree;
    });
}
}
