// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentNodes.h"

#include "FluentText.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr vtkIdType BlockSize = 4096;

//------------------------------------------------------------------------------
int GetDimension(const FluentFile& file, const FluentSection& section)
{
  const std::int64_t dimension = section.GetElement();
  return dimension == 2 || dimension == 3 ? static_cast<int>(dimension) : file.GetDimension();
}

//------------------------------------------------------------------------------
template <typename Real>
class NodeReading
{
public:
  NodeReading(FluentFile& file, const FluentPiece& piece, vtkIdType chunk)
    : File(file)
    , Piece(piece)
    , Chunk(chunk)
    , Coordinates(3 * piece.GetNumberOfPoints())
  {
  }

  bool Read(const FluentSection& section, const Progress& progress)
  {
    const int dimension = GetDimension(this->File, section);
    if (section.IsText())
    {
      const bool isLarge = section.End - section.Begin >= 2 * this->Chunk;
      return (isLarge && this->ReadLines(section, dimension, progress)) ||
        (!progress.IsStopped() && this->ReadWords(section, dimension));
    }
    return section.RealSize == 4 ? this->template ReadBinary<float>(section, dimension, progress)
                                 : this->template ReadBinary<double>(section, dimension, progress);
  }

  Buffer<Real>& GetCoordinates() { return this->Coordinates; }

private:
  /// Where to store the coordinates of a node, or nullptr.
  Real* GetPlace(const FluentSection& section, vtkIdType row)
  {
    const vtkIdType point = this->Piece.FindPoint(section.Header[1] - 1 + row);
    return point >= 0 ? &this->Coordinates[3 * point] : nullptr;
  }

  void Store(const FluentSection& section, vtkIdType row, const Real* x)
  {
    if (Real* place = this->GetPlace(section, row))
    {
      std::copy(x, x + 3, place);
    }
  }

  template <typename Source>
  bool ReadBinary(const FluentSection& section, int dimension, const Progress& progress)
  {
    const bool swap = this->File.IsSwapped();
    const vtkIdType count = section.GetCount();
    return progress.For((count + BlockSize - 1) / BlockSize,
      [&](vtkIdType first, vtkIdType last)
      {
        const vtkIdType end = std::min(last * BlockSize, count);
        for (vtkIdType row = first * BlockSize; row < end; ++row)
        {
          if (Real* place = this->GetPlace(section, row))
          {
            const char* source =
              section.Begin + row * dimension * static_cast<std::ptrdiff_t>(sizeof(Source));
            place[2] = 0;
            for (std::size_t c = 0; c < static_cast<std::size_t>(dimension); ++c)
            {
              place[c] = static_cast<Real>(Load<Source>(source + c * sizeof(Source), swap));
            }
          }
        }
      });
  }

  /// Reads one node per line, in parallel; false for other layouts and errors.
  bool ReadLines(const FluentSection& section, int dimension, const Progress& progress)
  {
    const FluentRows rows = this->File.FindRows(section, progress.Part(0, 0.1), this->Chunk);
    return rows.Records &&
      rows.Lines.ForEach(rows.Records, progress.Part(0.1, 1),
        [&](vtkIdType, vtkIdType row, const char* text, const char* end)
        {
          Real x[3] = { 0, 0, 0 };
          for (int c = 0; c < dimension; ++c)
          {
            text = ParseReal(SkipSpaceFrom(text, end), end, x[c]);
            if (!text || (text < end && !IsSpace(*text)))
            {
              return false;
            }
          }
          this->Store(section, row, x);
          return SkipSpaceFrom(text, end) == end;
        });
  }

  /// Reads nodes in any layout.
  bool ReadWords(const FluentSection& section, int dimension)
  {
    TextScanner scanner(this->File.GetName(), this->File.GetBegin(), section.End);
    scanner.SetPosition(section.Begin);
    const vtkIdType count = section.GetCount();
    for (vtkIdType row = 0; row < count; ++row)
    {
      Real x[3] = { 0, 0, 0 };
      for (int c = 0; c < dimension; ++c)
      {
        scanner.SkipSpace();
        const char* const text = scanner.GetPosition();
        if (!scanner.ReadReal(x[c], ""))
        {
          this->File.FailAt(text, text == section.End ? ErrorKind::Truncated : ErrorKind::Syntax,
            "a coordinate of node " + std::to_string(section.Header[1] + row));
          return false;
        }
      }
      this->Store(section, row, x);
    }
    if (scanner.SkipSpace())
    {
      this->File.FailAt(scanner.GetPosition(), ErrorKind::Count,
        "the end of the section after " + std::to_string(count) + " nodes");
      return false;
    }
    return true;
  }

  FluentFile& File;
  const FluentPiece& Piece;
  vtkIdType Chunk;
  Buffer<Real> Coordinates;
};

//------------------------------------------------------------------------------
template <typename Real, typename Array>
vtkSmartPointer<vtkDataArray> ReadAs(
  FluentFile& file, const FluentPiece& piece, vtkIdType chunk, const Progress& progress)
{
  NodeReading<Real> reading(file, piece, chunk);
  for (std::size_t i = 0; i < file.Nodes.size(); ++i)
  {
    const auto size = static_cast<double>(file.Nodes.size());
    if (!reading.Read(file.Nodes[i], progress.Part(i / size, (i + 1) / size)))
    {
      return nullptr;
    }
  }
  return reading.GetCoordinates().template TakeArray<Array>(3);
}
}

//------------------------------------------------------------------------------
vtkIdType CountFluentNodes(FluentFile& file)
{
  std::int64_t count = 0;
  for (const FluentSection* section : FluentFile::SortById(file.Nodes))
  {
    if (section->Header[1] != count + 1)
    {
      file.FailAt(section->Place, ErrorKind::Index,
        "the nodes from " + std::to_string(count + 1) + " on", std::to_string(section->Header[1]));
      return -1;
    }
    const std::int64_t values = section->GetCount() * GetDimension(file, *section);
    const std::int64_t bytes = section->Begin ? section->End - section->Begin : 0;
    if (section->IsText() && values > (bytes + 1) / 2)
    {
      file.FailAt(section->Place, ErrorKind::Truncated,
        std::to_string(values) + " coordinates in the section that begins here",
        std::to_string(bytes) + " characters");
      return -1;
    }
    if (!section->Begin)
    {
      file.FailAt(section->Place, ErrorKind::Truncated, "coordinates in parentheses", "none");
      return -1;
    }
    count = section->Header[2];
  }
  const FluentTotal& declared = file.DeclaredNodes;
  if (count != declared.Count && declared.Count >= 0)
  {
    file.FailAt(declared.Place, count > declared.Count ? ErrorKind::Index : ErrorKind::Truncated,
      std::to_string(declared.Count) + " nodes, as declared", std::to_string(count));
    return -1;
  }
  return count;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> ReadFluentNodes(
  FluentFile& file, const FluentPiece& piece, vtkIdType chunk, const Progress& progress)
{
  const bool isSingle = !file.Nodes.empty() &&
    std::all_of(file.Nodes.begin(), file.Nodes.end(),
      [](const FluentSection& section) { return section.RealSize == 4; });
  return isSingle ? ReadAs<float, vtkFloatArray>(file, piece, chunk, progress)
                  : ReadAs<double, vtkDoubleArray>(file, piece, chunk, progress);
}
}
