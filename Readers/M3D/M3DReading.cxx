// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "M3DReading.h"

#include "Base/Text.h"
#include "Intake/CellMesh/CellGrid.h"
#include "Intake/CellMesh/CellRows.h"
#include "Intake/Pieces/ReadMappedFile.h"
#include "M3DElements.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>

namespace camaron
{
namespace
{
constexpr int NodeBytes = 8;    // "1 0 0 0" and a line end
constexpr int ElementBytes = 8; // "t 0 1 2" and a line end

//------------------------------------------------------------------------------
// Sections that are skipped.
struct OtherSections
{
  vtkIdType Count = 0;
  std::string First; // word, quoted
};

//------------------------------------------------------------------------------
// Whether a text begins with a keyword, which is in lower case, in any case, whatever follows.
bool BeginsWith(const char* text, const char* end, std::string_view keyword)
{
  const std::string_view rest(text, static_cast<std::size_t>(end - text));
  return EqualsInAnyCase(rest.substr(0, keyword.size()), keyword);
}

//------------------------------------------------------------------------------
// Moves past the heading of the section that begins with a keyword, skipping other sections. False
// if none begins within a number of bytes.
bool FindSection(
  TextScanner& scanner, std::string_view keyword, vtkIdType bytes, OtherSections& others)
{
  const char* const end = scanner.GetEnd();
  const char* const limit = scanner.GetPosition() + std::min(bytes, scanner.GetBytesLeft());
  while (scanner.GetPosition() < limit && scanner.SkipSpace())
  {
    const char* const text = scanner.GetPosition();
    if (BeginsWith(text, end, keyword))
    {
      const char* const lineEnd = FindLineEnd(text, end);
      const char* const bracket = std::find(text, lineEnd, ']');
      scanner.SetPosition(bracket + (bracket < lineEnd));
      return true;
    }
    if (*text == '[' && others.Count++ == 0)
    {
      others.First = QuoteWord({ text, static_cast<std::size_t>(end - text) });
    }
    scanner.SkipLine();
  }
  return false;
}

//------------------------------------------------------------------------------
// Moves past the heading of the section of nodes.
bool ReadHeading(TextScanner& scanner, OtherSections& others)
{
  constexpr vtkIdType MaxBytesBefore = 65536; // of other sections and of remarks
  scanner.SkipSpace();
  const char* const begin = scanner.GetPosition();
  constexpr char Expected[] = "an M3D file, which begins with '[Nodes, ARRAY1<STRING>]'";
  return FindSection(scanner, "[nodes,", MaxBytesBefore, others) ||
    (BeginsWith(begin, scanner.GetEnd(), "3dmo")
        ? scanner.FailAt(
            begin, ErrorKind::NotThisFormat, Expected, "a binary Model 3D file ('3DMO')")
        : scanner.FailAt(begin, ErrorKind::NotThisFormat, Expected));
}

//------------------------------------------------------------------------------
struct Node
{
  double Position[3];
  std::int64_t Code;
  double Projection[3] = { 0, 0, 0 };
};

//------------------------------------------------------------------------------
// code x y z [px py pz]
bool ReadNode(TextRow& row, Node& node)
{
  if (!row.ReadInteger(node.Code, "the code of a node"))
  {
    return false;
  }
  if (node.Code != static_cast<int>(node.Code))
  {
    return row.FailAtLast(ErrorKind::Syntax, "a 32-bit code of a node");
  }
  return row.ReadPoint(node.Position, "a coordinate of a node") &&
    ((node.Code != 2 && node.Code != 3) ||
      row.ReadPoint(node.Projection, "the projection of a node of code 2 or 3"));
}

//------------------------------------------------------------------------------
// letter id id ...; the nodes become those of VTK. nullptr on errors.
const ElementKind* ReadElement(TextRow& row, vtkIdType numberOfNodes, std::int32_t* points)
{
  constexpr char what[] = "an element (T, P, R, H, t or q)";
  std::string_view word;
  if (!row.ReadWord(word, what))
  {
    return nullptr;
  }
  const ElementKind* const kind =
    FindElementKind([&](const ElementKind& one) { return one.Letter == word[0]; });
  if (!kind)
  {
    row.FailAt(word.data(), ErrorKind::Syntax, what);
    return nullptr;
  }
  std::int64_t size = kind->NumberOfNodes; // may follow the letter
  ParseInteger(word.data() + 1, word.data() + word.size(), size);
  if (size != kind->NumberOfNodes)
  {
    row.FailAt(word.data(), ErrorKind::Unsupported,
      std::string("an element of type ") + kind->Letter + " with " +
        std::to_string(kind->NumberOfNodes) + " nodes");
    return nullptr;
  }
  std::int32_t nodes[MaxElementNodes];
  if (!row.ReadIds(nodes, kind->NumberOfNodes, 0, numberOfNodes - 1, "a node of an element"))
  {
    return nullptr;
  }
  const int* const order = kind->GetOrder();
  std::transform(
    order, order + kind->NumberOfNodes, points, [&nodes](int place) { return nodes[place]; });
  return kind;
}

//------------------------------------------------------------------------------
// Three numbers after the nodes of an element. A word that is not a number is not a material;
// Camarón ignores it.
bool ReadMaterial(TextRow& row, double* values)
{
  for (int c = 0; c < MaterialSize; ++c)
  {
    std::string_view word;
    const bool good = row.HasMore() && row.ReadWord(word, "");
    const char* const end = word.data() + word.size();
    if (!good || ParseReal(word.data(), end, values[c]) != end)
    {
      return false;
    }
  }
  return true;
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
  bool FindElements(TextScanner& scanner, const RowSequence& nodes, const Progress& progress);
  bool ReadElements(const RowSequence& rows, const Progress& progress);
  void ReadFirstMaterial(TextScanner scanner);
  void CompareMaterial(TextRow& row, const char* end);
  bool ReadMaterials(const RowSequence& elements, const Progress& progress);
  bool ReadNodes(const RowSequence& rows, bool withCodes, const Progress& progress);
  void WarnOfRest(TextScanner& scanner);

  PieceRequest Request;
  vtkUnstructuredGrid* Grid;
  Warnings& Messages;

  std::int64_t NumberOfNodes = 0;
  std::int64_t NumberOfElements = 0;
  OtherSections Others;
  CellMeshPiece Piece;
  CellMesh Mesh;
  std::string_view FirstMaterial;               // its text, empty if the first element has none
  std::atomic<bool> HasOtherMaterials{ false }; // than the first one
  std::atomic<bool> LacksMaterials{ false };    // of some elements
  vtkSmartPointer<vtkDataArray> Points, Codes, Projections, Materials; // of cells or field data
};

//------------------------------------------------------------------------------
// Finds the section of elements, behind that of nodes.
bool M3DReading::FindElements(
  TextScanner& scanner, const RowSequence& nodes, const Progress& progress)
{
  if (!nodes.Skip(progress,
        [](vtkIdType, vtkIdType, TextRow& row)
        {
          Node node;
          return ReadNode(row, node);
        }))
  {
    return false;
  }
  if (scanner.SkipSpace() && *scanner.GetPosition() != '[')
  {
    this->Messages.Add("the section of nodes has more lines than it declares");
  }
  if (!FindSection(scanner, "[elements,", scanner.GetBytesLeft(), this->Others))
  {
    return scanner.FailAt(scanner.GetEnd(), ErrorKind::Truncated, "the section '[Elements,'");
  }
  return scanner.ReadCount(this->NumberOfElements, ElementBytes, "the number of elements");
}

//------------------------------------------------------------------------------
// All rows are read to check them and to find the piece, then those of the piece to store them.
bool M3DReading::ReadElements(const RowSequence& rows, const Progress& progress)
{
  if (rows.GetCount() == 0)
  {
    return MakeCloud(this->NumberOfNodes, this->Request, this->Piece, this->Mesh);
  }
  const char* const end = rows.GetScanner().GetEnd();
  const auto read = [&](TextRow& row, std::int32_t* points)
  {
    const ElementKind* const kind = ReadElement(row, this->NumberOfNodes, points);
    if (kind)
    {
      this->CompareMaterial(row, end);
    }
    return kind;
  };
  if (!this->Piece.Find(this->NumberOfNodes, rows.GetCount(), this->Request,
        [&]
        {
          return rows.ForEach(progress.Part(0, 0.7),
            [&](vtkIdType i, vtkIdType, TextRow& row)
            {
              std::int32_t points[MaxElementNodes];
              const ElementKind* const kind = read(row, points);
              if (kind)
              {
                this->Piece.Visit(i, points, kind->NumberOfNodes);
              }
              return kind != nullptr;
            });
        }))
  {
    return false;
  }
  this->Mesh.NumberOfPoints = this->Piece.GetNumberOfPoints();
  return ReadCells(rows, this->Mesh, progress.Part(this->Piece.IsWhole() ? 0 : 0.7, 1),
    [&](vtkIdType i, TextRow& row, CellSink& sink)
    {
      if (this->Piece.FindCell(i) < 0)
      {
        row.Skip();
        return true;
      }
      std::int32_t points[MaxElementNodes];
      const ElementKind* const kind = read(row, points);
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
    });
}

//------------------------------------------------------------------------------
void M3DReading::ReadFirstMaterial(TextScanner scanner)
{
  std::int32_t points[MaxElementNodes];
  double values[MaterialSize];
  TextRow row(scanner, RowLayout::OneLine);
  this->FirstMaterial = {};
  this->Materials = nullptr;
  this->HasOtherMaterials = this->LacksMaterials = false;
  ReadElement(row, this->NumberOfNodes, points);
  const char* const text = row.GetPosition();
  if (ReadMaterial(row, values))
  {
    this->FirstMaterial = { text, static_cast<std::size_t>(row.GetPosition() - text) };
    vtkNew<vtkDoubleArray> array;
    array->SetName(MaterialName);
    array->SetNumberOfComponents(MaterialSize);
    array->InsertNextTuple(values);
    this->Materials = array;
  }
}

//------------------------------------------------------------------------------
// Finds out whether all elements have the material of the first one, by its text.
void M3DReading::CompareMaterial(TextRow& row, const char* end)
{
  const std::size_t size = this->FirstMaterial.size();
  const char* const text = row.GetPosition();
  const bool isFirst = static_cast<std::size_t>(end - text) >= size &&
    std::string_view(text, size) == this->FirstMaterial &&
    (text + size == end || IsSpace(text[size]));
  if (size > 0 && !isFirst)
  {
    (row.HasMore() ? this->HasOtherMaterials : this->LacksMaterials)
      .store(true, std::memory_order_relaxed);
  }
}

//------------------------------------------------------------------------------
// Reads the materials of all elements, unless some have none.
bool M3DReading::ReadMaterials(const RowSequence& elements, const Progress& progress)
{
  Buffer<double> materials(MaterialSize * this->Piece.GetNumberOfCells());
  const bool good = elements.ForEach(progress,
    [&](vtkIdType i, vtkIdType, TextRow& row)
    {
      std::int32_t points[MaxElementNodes];
      double unused[MaterialSize];
      const vtkIdType cell = this->Piece.FindCell(i);
      double* const values = cell < 0 ? unused : materials.data() + MaterialSize * cell;
      if (!ReadElement(row, this->NumberOfNodes, points))
      {
        return false;
      }
      if (!ReadMaterial(row, values))
      {
        this->LacksMaterials.store(true, std::memory_order_relaxed);
      }
      return true;
    });
  if (good)
  {
    this->Materials = materials.TakeArray<vtkDoubleArray>(MaterialSize, MaterialName);
  }
  return good;
}

//------------------------------------------------------------------------------
// Reads the nodes of the piece; if any node of the file has a code, again with the codes.
bool M3DReading::ReadNodes(const RowSequence& rows, bool withCodes, const Progress& progress)
{
  const vtkIdType size = this->Piece.GetNumberOfPoints();
  Buffer<double> coordinates(3 * size), projections(withCodes ? 3 * size : 0);
  Buffer<int> codes(withCodes ? size : 0);
  std::atomic<bool> hasCodes{ false };
  if (!rows.ForEach(progress,
        [&](vtkIdType i, vtkIdType, TextRow& row)
        {
          Node node;
          if (!ReadNode(row, node))
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
        }))
  {
    return false;
  }
  if (hasCodes && !withCodes)
  {
    return this->ReadNodes(rows, true, progress);
  }
  this->Points = coordinates.TakeArray<vtkDoubleArray>(3);
  if (withCodes)
  {
    this->Codes = codes.TakeArray<vtkIntArray>(1, "NodeCode");
    this->Projections = projections.TakeArray<vtkDoubleArray>(3, "Projection");
  }
  return true;
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
      ", the first is " + this->Others.First);
  }
}

//------------------------------------------------------------------------------
bool M3DReading::Read(TextScanner& scanner, const TextLines* lines, const Progress& progress)
{
  this->Grid->Initialize();
  this->Messages = Warnings();
  this->Others = OtherSections();
  this->Codes = this->Materials = nullptr;
  if (!ReadHeading(scanner, this->Others) ||
    !scanner.ReadCount(this->NumberOfNodes, NodeBytes, "the number of nodes"))
  {
    return false;
  }
  // The nodes come first, but the elements determine which of them a piece needs.
  const RowSequence nodes(scanner, lines, this->NumberOfNodes, RowLayout::OneLine);
  this->Piece.SetPoints(
    [&](const PieceOfSpace::Visit& visit)
    {
      return nodes.ForEach(Progress(),
        [&](vtkIdType i, vtkIdType, TextRow& row)
        {
          Node node;
          const bool isGood = ReadNode(row, node);
          if (isGood)
          {
            visit(i, node.Position);
          }
          return isGood;
        });
    });
  if (!this->FindElements(scanner, nodes, progress.Part(0, 0.05)))
  {
    return false;
  }
  this->ReadFirstMaterial(scanner);
  const RowSequence elements(scanner, lines, this->NumberOfElements, RowLayout::OneLine);
  if (!this->ReadElements(elements, progress.Part(0.05, 0.5)) ||
    !this->ReadNodes(nodes, false, progress.Part(0.5, 0.8)) ||
    (this->HasOtherMaterials && !this->LacksMaterials &&
      !this->ReadMaterials(elements, progress.Part(0.8, 0.9))))
  {
    return false;
  }
  if (this->HasOtherMaterials && this->LacksMaterials)
  {
    this->Messages.Add("materials are not read, as some elements have none");
  }
  this->Piece.WarnOfRepeatedPoints(
    this->Mesh, this->Messages, progress.Part(0.9, 1), "element", "elements");
  this->WarnOfRest(scanner);
  if (this->Request.Piece > 0) // the first piece has warned
  {
    this->Messages = Warnings();
  }
  FillGrid(this->Mesh, this->Piece, this->Points, this->Grid);
  if (this->Codes)
  {
    this->Grid->GetPointData()->AddArray(this->Codes);
    this->Grid->GetPointData()->AddArray(this->Projections);
  }
  if (this->Materials && !this->LacksMaterials)
  {
    vtkFieldData* const data =
      this->HasOtherMaterials ? this->Grid->GetCellData() : this->Grid->GetFieldData();
    data->AddArray(this->Materials);
  }
  return !progress.IsStopped();
}
}

//------------------------------------------------------------------------------
bool IsM3D(const std::string& path)
{
  const MappedFile file(path);
  TextScanner scanner("", file.begin(), file.end(), '#');
  OtherSections others;
  std::int64_t nodes;
  return ReadHeading(scanner, others) && scanner.ReadInteger(nodes, "");
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
