// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentNodes.h"

#include "Base/Parallel.h"
#include "Intake/Fluent/FluentText.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace camaron
{
namespace
{
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
  using Put = std::function<void(vtkIdType point, const Real* x)>;

  /// @param some nodes to read, or nullptr for all
  /// @param put receives the coordinates of a node, from any thread
  NodeReading(FluentFile& file, const IdSet* some, vtkIdType chunk, Put put)
    : File(file)
    , Some(some)
    , Chunk(chunk)
    , PutNode(std::move(put))
  {
  }

  /// False with the error in the file, or if stopped.
  /// @param inLines whether nodes in text must be in lines, and are passed only once
  bool ReadAll(bool inLines, const Progress& progress)
  {
    const auto size = static_cast<double>(this->File.Nodes.size());
    for (std::size_t i = 0; i < this->File.Nodes.size(); ++i)
    {
      if (!this->Read(this->File.Nodes[i], inLines, progress.Part(i / size, (i + 1) / size)))
      {
        return false;
      }
    }
    return true;
  }

private:
  bool Read(const FluentSection& section, bool inLines, const Progress& progress)
  {
    const int dimension = GetDimension(this->File, section);
    if (section.IsStored)
    {
      return this->ReadStored(section, dimension, progress);
    }
    if (section.IsText())
    {
      const bool isLarge = section.End - section.Begin >= 2 * this->Chunk;
      return isLarge && inLines ? this->ReadLines(section, dimension, progress)
                                : this->ReadWords(section, dimension);
    }
    return section.RealSize == 4 ? this->template ReadBinary<float>(section, dimension, progress)
                                 : this->template ReadBinary<double>(section, dimension, progress);
  }

  void Pass(const FluentSection& section, vtkIdType row, const Real* x)
  {
    const vtkIdType point = section.Header[1] - 1 + row;
    if (!this->Some || this->Some->Contains(point))
    {
      this->PutNode(point, x);
    }
  }

  template <typename Source>
  bool ReadBinary(const FluentSection& section, int dimension, const Progress& progress)
  {
    const bool swap = this->File.IsSwapped();
    const vtkIdType count = section.GetCount();
    return progress.For((count + MediumGrain - 1) / MediumGrain,
      [&](vtkIdType first, vtkIdType last)
      {
        const vtkIdType end = std::min(last * MediumGrain, count);
        for (vtkIdType row = first * MediumGrain; row < end; ++row)
        {
          const char* source =
            section.Begin + row * dimension * static_cast<std::ptrdiff_t>(sizeof(Source));
          Real x[3] = { 0, 0, 0 };
          for (std::size_t c = 0; c < static_cast<std::size_t>(dimension); ++c)
          {
            x[c] = static_cast<Real>(Load<Source>(source + c * sizeof(Source), swap));
          }
          this->Pass(section, row, x);
        }
      });
  }

  bool ReadStored(const FluentSection& section, int dimension, const Progress& progress)
  {
    PieceExchange none(nullptr);
    PieceExchange& exchange = this->File.Exchange ? *this->File.Exchange : none;
    const std::int64_t count = section.GetCount();
    std::int64_t done = 0;
    return exchange.ForBatches<double>(
      -2 - count, count, FluentFile::GetStoredBatch(count), // places unlike those of faces
      [&](std::int64_t begin, std::int64_t end, Buffer<double>& values) -> std::int64_t
      {
        const bool good = this->File.LoadStored(section, begin, end - begin, values);
        return good ? (end - begin) * dimension : -1;
      },
      [&](std::int64_t first, std::int64_t last, const double* values, std::int64_t size)
      {
        ParallelFor(size == (last - first) * dimension ? last - first : 0, MediumGrain,
          [&](vtkIdType begin, vtkIdType end)
          {
            for (vtkIdType row = begin; row < end; ++row)
            {
              const double* const source = values + dimension * row;
              const Real x[3] = { static_cast<Real>(source[0]), static_cast<Real>(source[1]),
                dimension == 3 ? static_cast<Real>(source[2]) : 0 };
              this->Pass(section, first + row, x);
            }
          });
        done += last - first;
        return progress.Report(static_cast<double>(done) / static_cast<double>(count));
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
          this->Pass(section, row, x);
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
      this->Pass(section, row, x);
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
  const IdSet* Some;
  vtkIdType Chunk;
  Put PutNode;
};

//------------------------------------------------------------------------------
template <typename Real, typename Array>
vtkSmartPointer<vtkDataArray> ReadAs(
  FluentFile& file, vtkIdType nodes, const IdSet* some, vtkIdType chunk, const Progress& progress)
{
  Buffer<Real> coordinates(3 * (some ? some->GetNumberOfMembers() : nodes));
  NodeReading<Real> reading(file, some, chunk,
    [&](vtkIdType point, const Real* x)
    {
      const vtkIdType index = some ? some->GetNumber(point) : point;
      std::copy(x, x + 3, coordinates.data() + 3 * index);
    });
  if (!reading.ReadAll(true, progress) &&
    (progress.IsStopped() || !reading.ReadAll(false, progress)))
  {
    return nullptr;
  }
  return coordinates.template TakeArray<Array>(3);
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
    if (!section->HasBody())
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
bool FindFluentSpace(
  FluentFile& file, vtkIdType chunk, const Progress& progress, PieceOfSpace& space)
{
  const auto find = [&](bool inLines)
  {
    return space.Find([&](const PieceOfSpace::Visit& visit)
      { return NodeReading<double>(file, nullptr, chunk, visit).ReadAll(inLines, progress); });
  };
  return find(true) || (!progress.IsStopped() && find(false));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> ReadFluentNodes(
  FluentFile& file, vtkIdType nodes, const IdSet* some, vtkIdType chunk, const Progress& progress)
{
  const bool isSingle = !file.Nodes.empty() &&
    std::all_of(file.Nodes.begin(), file.Nodes.end(),
      [](const FluentSection& section) { return section.RealSize == 4; });
  return isSingle ? ReadAs<float, vtkFloatArray>(file, nodes, some, chunk, progress)
                  : ReadAs<double, vtkDoubleArray>(file, nodes, some, chunk, progress);
}
}
