// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentMesh.h"

#include "Base/Parallel.h"
#include "Intake/Fluent/FluentNumbers.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"

#include <algorithm>

namespace camaron
{
namespace
{
using Visit = PieceOfSpace::Visit;

//------------------------------------------------------------------------------
int GetDimension(const FluentFile& file, const FluentSection& section)
{
  const std::int64_t dimension = section.GetElement();
  return dimension == 2 || dimension == 3 ? static_cast<int>(dimension) : file.GetDimension();
}

//------------------------------------------------------------------------------
// Passes the nodes of a section, batch by batch.
bool VisitSection(
  FluentFile& file, const FluentSection& section, const Visit& visit, const Progress& progress)
{
  const std::int64_t count = section.GetCount();
  const int dimension = GetDimension(file, section);
  std::int64_t done = 0;
  const auto pass = [&](std::int64_t first, std::int64_t rows, const auto* values)
  {
    ParallelForEach(rows, MediumGrain,
      [&](vtkIdType row)
      {
        double x[3] = { 0, 0, 0 };
        std::copy_n(values + dimension * row, dimension, x);
        visit(section.Header[1] - 1 + first + row, x);
      });
    done += rows;
    return progress.Report(static_cast<double>(done) / static_cast<double>(count));
  };
  if (section.IsStored)
  {
    PieceExchange none(nullptr);
    PieceExchange& exchange = file.Exchange ? *file.Exchange : none;
    return exchange.ForBatches<double>(
      -2 - count, count, FluentFile::GetStoredBatch(count), // places unlike those of faces
      [&](std::int64_t begin, std::int64_t end, Buffer<double>& values)
      {
        file.LoadStored(section, begin, end - begin, values);
        return (end - begin) * dimension;
      },
      [&](std::int64_t begin, std::int64_t end, const double* values, std::int64_t size)
      { return pass(begin, size == (end - begin) * dimension ? end - begin : 0, values); });
  }
  FluentNumbers<double> numbers(file, section);
  const std::ptrdiff_t batch = numbers.GetBatch();
  const auto failAt = [&](std::int64_t word, const std::string& expected, ErrorKind kind)
  {
    const char* const place = numbers.Find(word);
    file.FailAt(place, place == section.End ? ErrorKind::Truncated : kind, expected);
    return false;
  };
  while (done < count)
  {
    numbers.Read(batch, true);
    const std::int64_t rows = std::min(count - done, numbers.GetCount() / dimension);
    if (rows == 0)
    {
      const std::int64_t id = section.Header[1] + done;
      return failAt(
        numbers.GetCount(), "a coordinate of node " + std::to_string(id), ErrorKind::Syntax);
    }
    if (!pass(done, rows, numbers.GetData()))
    {
      return false;
    }
    numbers.Skip(rows * dimension);
  }
  return numbers.Find(0) == section.End ||
    failAt(0, "the end of the section after " + std::to_string(count) + " nodes", ErrorKind::Count);
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
bool ForEachFluentNode(FluentFile& file, const PieceOfSpace::Visit& visit, const Progress& progress)
{
  const auto size = static_cast<double>(file.Nodes.size());
  for (std::size_t i = 0; i < file.Nodes.size(); ++i)
  {
    const auto from = static_cast<double>(i), to = static_cast<double>(i + 1);
    const FluentSection& section = file.Nodes[i];
    if (!VisitSection(file, section, visit, progress.Part(from / size, to / size)))
    {
      return false;
    }
  }
  return true;
}

namespace
{
//------------------------------------------------------------------------------
template <typename Array, typename Real>
vtkSmartPointer<vtkDataArray> ReadAs(
  FluentFile& file, vtkIdType nodes, const IdSet* some, const Progress& progress)
{
  Buffer<Real> coordinates(3 * (some ? some->GetNumberOfMembers() : nodes));
  const auto put = [&](vtkIdType point, const double* x)
  {
    if (!some || some->Contains(point))
    {
      Real* const place = coordinates.data() + 3 * (some ? some->GetNumber(point) : point);
      std::transform(x, x + 3, place, [](double value) { return static_cast<Real>(value); });
    }
  };
  return ForEachFluentNode(file, put, progress) ? coordinates.template TakeArray<Array>(3)
                                                : nullptr;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> ReadFluentNodes(
  FluentFile& file, vtkIdType nodes, const IdSet* some, const Progress& progress)
{
  const bool isSingle = !file.Nodes.empty() &&
    std::all_of(file.Nodes.begin(), file.Nodes.end(),
      [](const FluentSection& section) { return section.RealSize == 4; });
  return isSingle ? ReadAs<vtkFloatArray, float>(file, nodes, some, progress)
                  : ReadAs<vtkDoubleArray, double>(file, nodes, some, progress);
}
}
