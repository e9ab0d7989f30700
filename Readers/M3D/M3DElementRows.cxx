// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "M3DElementRows.h"

#include <vector>

namespace camaron
{
namespace
{
constexpr char Node[] = "a node of an element";
constexpr char TooManyNodes[] = "fewer than 2147483648 nodes of all elements together";
constexpr char Element[] = "an element (T, P, R, H, t or q)";
constexpr char MVMElement[] = "an element (T, P, R, H or Q)";
// In MVM files triangles have the same letter as tetrahedra.
constexpr ElementKind MVMTriangle = { 'T', VTK_TRIANGLE, 3 };

//------------------------------------------------------------------------------
// Node counts of consecutive elements; each in a cache line of its own.
struct alignas(64) NodeCount
{
  vtkIdType Before = 0; // in other pieces
  vtkIdType Size = 0;
};
}

//------------------------------------------------------------------------------
// Reads the letter of an element, which may be followed by its number of nodes.
const ElementKind* M3DElementRows::ReadKind(TextRow& row, bool& hasNumber) const
{
  const bool isMVM = this->Dialect == M3DDialect::MVM;
  const char* const what = isMVM ? MVMElement : Element;
  std::string_view word;
  if (!row.ReadWord(word, what))
  {
    return nullptr;
  }
  const ElementKind* kind = FindElementKind(word[0], this->Dialect);
  if (!kind)
  {
    row.FailAt(word.data(), ErrorKind::Syntax, what);
    return nullptr;
  }
  hasNumber = word.size() > 1 && IsDigit(word[1]);
  if (hasNumber)
  {
    std::int64_t number = 0;
    ParseInteger(word.data() + 1, word.data() + word.size(), number);
    const bool mayBeTriangle = isMVM && kind->Letter == MVMTriangle.Letter;
    if (mayBeTriangle && number == MVMTriangle.NumberOfNodes)
    {
      return &MVMTriangle;
    }
    if (number != kind->NumberOfNodes)
    {
      row.FailAt(word.data(), ErrorKind::Unsupported,
        std::string("an element of type ") + kind->Letter + " with " +
          (mayBeTriangle ? "3 or " : "") + std::to_string(kind->NumberOfNodes) + " nodes");
      return nullptr;
    }
  }
  return kind;
}

//------------------------------------------------------------------------------
const ElementKind* M3DElementRows::ReadElement(TextRow& row, std::int32_t* nodes) const
{
  bool hasNumber = false;
  const ElementKind* kind = this->ReadKind(row, hasNumber);
  for (int i = 0; kind && i < kind->NumberOfNodes; ++i)
  {
    // Without a number, it is a triangle if nothing follows.
    if (i == MVMTriangle.NumberOfNodes && kind->Letter == MVMTriangle.Letter && !hasNumber &&
      this->Dialect == M3DDialect::MVM && !row.HasMore())
    {
      return &MVMTriangle;
    }
    if (!row.ReadId(nodes[i], 0, this->NumberOfNodes - 1, Node))
    {
      return nullptr;
    }
  }
  return kind;
}

//------------------------------------------------------------------------------
// Reads as much of a line as gives its size: the letter is enough, except in MVM files.
const ElementKind* M3DElementRows::ReadSize(TextRow& row) const
{
  std::int32_t unused[MaxElementNodes];
  bool hasNumber = false;
  return this->Dialect == M3DDialect::MVM ? this->ReadElement(row, unused)
                                          : this->ReadKind(row, hasNumber);
}

//------------------------------------------------------------------------------
const ElementKind* M3DElementRows::ReadCell(
  TextRow& row, std::int32_t* points, MaterialTally& materials) const
{
  std::int32_t nodes[MaxElementNodes];
  const ElementKind* const kind = this->ReadElement(row, nodes);
  if (!kind)
  {
    return nullptr;
  }
  const int* const order = kind->GetOrder();
  for (int i = 0; i < kind->NumberOfNodes; ++i)
  {
    points[i] = nodes[order[i]];
  }
  if (this->Dialect != M3DDialect::MVM)
  {
    materials.Add(row);
  }
  return kind;
}

//------------------------------------------------------------------------------
bool M3DElementRows::ReadInParallel(const TextLines& lines, const TextLines::Section& section,
  char comment, CellMesh& mesh, MaterialTally& materials, const Progress& progress) const
{
  std::vector<NodeCount> counts(static_cast<std::size_t>(lines.GetNumberOfPieces(section)));
  if (!VisitRows(lines, section, comment, progress.Part(0, 0.2),
        [&](vtkIdType i, vtkIdType piece, TextRow& row)
        {
          const ElementKind* const kind = this->ReadSize(row);
          if (kind)
          {
            mesh.Types[i] = kind->Type;
            mesh.Offsets[i] = static_cast<std::int32_t>(counts[piece].Size);
            counts[piece].Size += kind->NumberOfNodes;
          }
          return kind != nullptr;
        }))
  {
    return false;
  }
  vtkIdType sum = 0;
  for (NodeCount& count : counts)
  {
    count.Before = sum;
    sum += count.Size;
  }
  if (sum > INT32_MAX)
  {
    return false; // the serial method reports the error
  }
  mesh.Offsets[mesh.NumberOfCells] = static_cast<std::int32_t>(sum);
  mesh.Connectivity = Buffer<std::int32_t>(sum);
  return VisitRows(lines, section, comment, progress.Part(0.2, 1),
    [&](vtkIdType i, vtkIdType piece, TextRow& row)
    {
      mesh.Offsets[i] += static_cast<std::int32_t>(counts[piece].Before);
      return this->ReadCell(row, mesh.Connectivity.data() + mesh.Offsets[i], materials) != nullptr;
    });
}

//------------------------------------------------------------------------------
bool M3DElementRows::ReadOneByOne(
  TextScanner& scanner, CellMesh& mesh, MaterialTally& materials, const Progress& progress) const
{
  std::int64_t sum = 0;
  TextScanner sizes = scanner;
  const bool good = ReadRows(
    scanner, nullptr, mesh.NumberOfCells, progress.Part(0, 0.5),
    [&](vtkIdType i, TextRow& row)
    {
      std::int32_t unused[MaxElementNodes];
      const ElementKind* const kind = this->ReadElement(row, unused);
      if (kind)
      {
        mesh.Types[i] = kind->Type;
        mesh.Offsets[i] = static_cast<std::int32_t>(sum);
        sum += kind->NumberOfNodes;
      }
      return kind &&
        (sum <= INT32_MAX || row.FailAt(row.GetPosition(), ErrorKind::Unsupported, TooManyNodes));
    },
    this->Layout);
  if (!good)
  {
    return false;
  }
  mesh.Offsets[mesh.NumberOfCells] = static_cast<std::int32_t>(sum);
  mesh.Connectivity = Buffer<std::int32_t>(sum);
  return ReadRows(
    sizes, nullptr, mesh.NumberOfCells, progress.Part(0.5, 1),
    [&](vtkIdType i, TextRow& row)
    {
      return this->ReadCell(row, mesh.Connectivity.data() + mesh.Offsets[i], materials) != nullptr;
    },
    this->Layout);
}

//------------------------------------------------------------------------------
bool M3DElementRows::ReadWhole(TextScanner& scanner, const TextLines* lines, vtkIdType count,
  CellMesh& mesh, MaterialTally& materials, const Progress& progress) const
{
  mesh = CellMesh();
  mesh.NumberOfPoints = this->NumberOfNodes;
  mesh.NumberOfCells = count;
  mesh.Types = Buffer<unsigned char>(count);
  mesh.Offsets = Buffer<std::int32_t>(count + 1);
  if (!lines)
  {
    return this->ReadOneByOne(scanner, mesh, materials, progress);
  }
  const TextLines::Section section = lines->Find(scanner.GetPosition(), count);
  if (!section ||
    !this->ReadInParallel(*lines, section, scanner.GetComment(), mesh, materials, progress))
  {
    return false; // the caller reads the text again serially
  }
  scanner.SetPosition(section.End);
  return true;
}

//------------------------------------------------------------------------------
bool M3DElementRows::ReadPiece(TextScanner& scanner, const TextLines* lines,
  const Buffer<unsigned char>& types, const CellMeshPiece& piece, CellMesh& mesh,
  MaterialTally& materials, const Progress& progress) const
{
  const std::vector<std::int32_t> cells = piece.GetCells().GetMembers();
  const auto size = static_cast<vtkIdType>(cells.size());
  mesh = CellMesh();
  mesh.NumberOfPoints = piece.GetNumberOfPoints();
  mesh.NumberOfCells = size;
  mesh.Types = Buffer<unsigned char>(size);
  mesh.Offsets = Buffer<std::int32_t>(size + 1);
  mesh.Offsets[0] = 0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    mesh.Types[i] = types[cells[i]];
    mesh.Offsets[i + 1] = mesh.Offsets[i] + this->GetSize(mesh.Types[i]);
  }
  mesh.Connectivity = Buffer<std::int32_t>(mesh.Offsets[size]);
  return ReadRowsOnce(
    scanner, lines, types.size(), progress,
    [&](vtkIdType i, TextRow& row)
    {
      const vtkIdType cell = piece.FindCell(i);
      if (cell < 0 && this->Layout == RowLayout::OneLine)
      {
        row.Skip();
        return true;
      }
      std::int32_t others[MaxElementNodes];
      std::int32_t* const points =
        cell < 0 ? others : mesh.Connectivity.data() + mesh.Offsets[cell];
      const ElementKind* const kind = this->ReadCell(row, points, materials);
      for (int p = 0; kind && cell >= 0 && p < kind->NumberOfNodes; ++p)
      {
        points[p] = static_cast<std::int32_t>(piece.FindPoint(points[p]));
      }
      return kind != nullptr;
    },
    this->Layout);
}

//------------------------------------------------------------------------------
bool M3DElementRows::Read(TextScanner& scanner, const TextLines* lines, vtkIdType count,
  const PieceRequest& request, CellMeshPiece& piece, CellMesh& mesh, MaterialTally& materials,
  const Progress& progress) const
{
  // All rows are read to check them and to find the piece, then those of the piece to store them.
  const TextScanner start = scanner;
  Buffer<unsigned char> types(request.NumberOfPieces > 1 ? count : 0);
  if (!piece.Find(this->NumberOfNodes, count, request,
        [&]
        {
          scanner = start;
          return ReadRowsOnce(
            scanner, lines, count, progress.Part(0, 0.7),
            [&](vtkIdType i, TextRow& row)
            {
              std::int32_t points[MaxElementNodes];
              const ElementKind* const kind = this->ReadCell(row, points, materials);
              if (kind)
              {
                types[i] = kind->Type;
                piece.Visit(i, points, kind->NumberOfNodes);
              }
              return kind != nullptr;
            },
            this->Layout);
        }))
  {
    return false;
  }
  if (piece.IsWhole())
  {
    return this->ReadWhole(scanner, lines, count, mesh, materials, progress);
  }
  std::int64_t sum = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    sum += this->GetSize(types[i]);
  }
  if (sum > INT32_MAX)
  {
    return scanner.FailAt(scanner.GetPosition(), ErrorKind::Unsupported, TooManyNodes);
  }
  scanner = start;
  return this->ReadPiece(scanner, lines, types, piece, mesh, materials, progress.Part(0.7, 1));
}
}
