// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TSurfRecords.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <limits>

namespace camaron
{
namespace
{
constexpr char ExistingId[] = "the id of a vertex of the surface";
constexpr std::int64_t MaxId = std::numeric_limits<std::int32_t>::max();
constexpr std::int32_t Unknown = -1; // point of an atom
constexpr std::int32_t Sought = -2;

//------------------------------------------------------------------------------
// Ids in objects may also be negative.
bool ReadAnyId(TextRow& row, std::int32_t& id)
{
  std::int64_t value;
  if (!row.ReadInteger(value, VertexId))
  {
    return false;
  }
  id = static_cast<std::int32_t>(value);
  return id == value || row.FailAtLast(ErrorKind::Index, "a vertex id below 2147483648");
}
}

//------------------------------------------------------------------------------
TSurfRecords::TSurfRecords(
  TextScanner& scanner, const std::vector<TSurfObject>& objects, vtkIdType chunk)
  : Scanner(scanner)
  , Objects(objects)
{
  for (std::size_t i = 0; i < objects.size(); ++i)
  {
    // At least one chunk each, so that every object has a first one.
    const char* text = objects[i].Begin;
    do
    {
      const char* const next = CutAtLine(text, objects[i].End, chunk);
      this->Chunks.push_back({ i, text, next });
      text = next;
    } while (text < objects[i].End);
  }
  this->Chunks.push_back({ objects.size(), scanner.GetEnd(), scanner.GetEnd() });
}

//------------------------------------------------------------------------------
vtkIdType TSurfRecords::GetNumberOfPropertyRecords(std::size_t object) const
{
  const auto find = [this](std::size_t o)
  {
    return std::lower_bound(this->Chunks.begin(), this->Chunks.end(), o,
      [](const Chunk& chunk, std::size_t sought) { return chunk.Object < sought; })
      ->PropertyRecords;
  };
  return find(object + 1) - find(object);
}

//------------------------------------------------------------------------------
// Counts the records of every chunk, and sums them up to the counts before it.
bool TSurfRecords::Count(const Progress& progress)
{
  progress.For(this->GetNumberOfChunks(),
    [this](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        Chunk& chunk = this->Chunks[i];
        ForEachLine(chunk,
          [&chunk](TSurfLine what, TextRow&, const char*)
          {
            const bool isRecord = what != TSurfLine::Triangle && what != TSurfLine::Face;
            chunk.Triangles += what == TSurfLine::Triangle;
            chunk.Faces += what == TSurfLine::Face;
            chunk.Records += isRecord;
            chunk.Points += isRecord && !IsAtom(what);
            chunk.PropertyRecords += HasProperties(what);
            return true;
          });
      }
    });
  Chunk sum{};
  for (Chunk& chunk : this->Chunks)
  {
    if (chunk.Object != sum.Object)
    {
      sum.Object = chunk.Object;
      sum.Faces = 0;
    }
    const auto add = [](vtkIdType& total, vtkIdType& count)
    {
      std::swap(total, count);
      total += count;
    };
    add(sum.Records, chunk.Records);
    add(sum.Points, chunk.Points);
    add(sum.Triangles, chunk.Triangles);
    add(sum.Faces, chunk.Faces);
    add(sum.PropertyRecords, chunk.PropertyRecords);
  }
  const Chunk& totals = this->Chunks.back();
  if (std::max(totals.Records, 3 * totals.Triangles) > INT32_MAX)
  {
    return this->Scanner.FailAt(this->Scanner.GetPosition(), ErrorKind::Unsupported,
      "fewer than 2147483648 vertices, and vertices of triangles", "more");
  }
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
bool TSurfRecords::ReadId(TSurfLine what, TextRow& row, std::int32_t* ids) const
{
  return ReadAnyId(row, ids[0]) &&
    (what != TSurfLine::Triangle || (ReadAnyId(row, ids[1]) && ReadAnyId(row, ids[2])));
}

//------------------------------------------------------------------------------
bool TSurfRecords::ReadIds(CellMesh& mesh, const Progress& progress)
{
  const Chunk& totals = this->Chunks.back();
  mesh = CellMesh(totals.Points, totals.Triangles, VTK_TRIANGLE, 3);
  this->Ids = Buffer<std::int32_t>(totals.Records);
  this->Points = Buffer<std::int32_t>(totals.Records > totals.Points ? totals.Records : 0);
  std::int32_t* const corners = mesh.Connectivity.data();
  return this->ForEachChunk(
    progress,
    [&](Chunk& chunk)
    {
      const Chunk& next = *(&chunk + 1);
      vtkIdType record = chunk.Records, point = chunk.Points, triangle = chunk.Triangles;
      const char* const wrong = ForEachLine(chunk,
        [&](TSurfLine what, TextRow& row, const char* line)
        {
          if (what == TSurfLine::Face)
          {
            return true;
          }
          if (what == TSurfLine::Triangle ? triangle == next.Triangles : record == next.Records)
          {
            return false; // the file has changed since the records were counted
          }
          if (what == TSurfLine::Triangle)
          {
            return this->ReadId(what, row, corners + 3 * triangle++);
          }
          std::int32_t& id = this->Ids[record];
          if (!this->ReadId(what, row, &id))
          {
            return false;
          }
          if (IsAtom(what))
          {
            chunk.Atoms.push_back({ static_cast<std::int32_t>(record), what, line });
          }
          else if (id != point)
          {
            this->Plain.store(false, std::memory_order_relaxed);
          }
          if (this->Points.size() > 0)
          {
            this->Points[record] = IsAtom(what) ? Unknown : static_cast<std::int32_t>(point);
          }
          point += !IsAtom(what);
          ++record;
          return true;
        });
      const bool isComplete =
        record == next.Records && point == next.Points && triangle == next.Triangles;
      return wrong || isComplete ? wrong : chunk.Begin;
    },
    [this](TSurfLine what, TextRow& row)
    {
      std::int32_t ids[3];
      this->ReadId(what, row, ids);
    });
}

//------------------------------------------------------------------------------
void TSurfRecords::BuildMaps(Warnings& warnings)
{
  this->FirstRecords.clear();
  for (const Chunk& chunk : this->Chunks)
  {
    if (chunk.Object == this->FirstRecords.size())
    {
      this->FirstRecords.push_back(chunk.Records);
    }
  }
  this->Maps = std::vector<IdMap>(this->Objects.size());
  vtkIdType repeated = 0;
  for (std::size_t i = 0; i < this->Maps.size(); ++i)
  {
    const vtkIdType first = this->FirstRecords[i];
    this->Maps[i].Build(this->Ids.data() + first, this->FirstRecords[i + 1] - first);
    repeated += this->Maps[i].GetNumberOfRepeated();
  }
  if (repeated > 0)
  {
    warnings.Add("vertices with the id of another vertex of their surface: " +
      std::to_string(repeated) + "; triangles use the last vertex with each id");
  }
}

//------------------------------------------------------------------------------
// Atoms may refer to other atoms, which may not be resolved yet.
bool TSurfRecords::ResolveAtoms()
{
  std::vector<const Atom*> atoms;
  for (const Chunk& chunk : this->Chunks)
  {
    for (const Atom& atom : chunk.Atoms)
    {
      atoms.push_back(&atom);
    }
  }
  std::size_t object = 0;
  std::vector<std::int32_t> path;
  for (const Atom* start : atoms)
  {
    while (start->Record >= this->FirstRecords[object + 1])
    {
      ++object;
    }
    path.clear();
    const Atom* atom = start;
    while (this->Points[atom->Record] < 0)
    {
      path.push_back(atom->Record);
      this->Points[atom->Record] = Sought;
      this->Scanner.SetPosition(atom->Text);
      std::int64_t id;
      TextRow row(this->Scanner, RowLayout::OneLine);
      std::string_view keyword;
      if (!row.ReadWord(keyword, "") || !row.ReadInteger(id, VertexId) ||
        !row.ReadInteger(id, ExistingId))
      {
        return false;
      }
      const std::int32_t found = this->Maps[object].Find(id);
      const vtkIdType record = this->FirstRecords[object] + found;
      if (found < 0 || this->Points[record] == Sought)
      {
        return this->Scanner.FailAt(atom->Text, ErrorKind::Index,
          found < 0 ? ExistingId : "an atom that refers to a vertex, not to itself",
          std::to_string(id));
      }
      if (this->Points[record] >= 0)
      {
        for (const std::int32_t r : path)
        {
          this->Points[r] = this->Points[record];
        }
        break;
      }
      atom = *std::lower_bound(atoms.begin(), atoms.end(), record,
        [](const Atom* a, vtkIdType sought) { return a->Record < sought; });
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool TSurfRecords::MapTriangles(CellMesh& mesh, const Progress& progress)
{
  constexpr vtkIdType None = std::numeric_limits<vtkIdType>::max();
  std::atomic<vtkIdType> wrong{ None };
  progress.For(this->GetNumberOfChunks(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Chunk& chunk = this->Chunks[i];
        const IdMap& map = this->Maps[chunk.Object];
        const vtkIdType first = this->FirstRecords[chunk.Object];
        const vtkIdType last = 3 * this->Chunks[i + 1].Triangles;
        for (vtkIdType c = 3 * chunk.Triangles; c < last; ++c)
        {
          std::int32_t& corner = mesh.Connectivity[c];
          const std::int32_t record = map.Find(corner);
          if (record < 0)
          {
            LowerTo(wrong, c);
            break;
          }
          corner = this->GetPoint(first + record);
        }
      }
    });
  if (wrong == None)
  {
    return !progress.IsStopped();
  }
  const vtkIdType triangle = wrong / 3;
  const auto next = std::upper_bound(this->Chunks.begin(), this->Chunks.end() - 1, triangle,
    [](vtkIdType sought, const Chunk& chunk) { return sought < chunk.Triangles; });
  this->ExplainTriangle(*(next - 1), triangle);
  return false;
}

//------------------------------------------------------------------------------
void TSurfRecords::ExplainTriangle(const Chunk& chunk, vtkIdType triangle)
{
  vtkIdType at = chunk.Triangles;
  const char* const line = ForEachLine(chunk, [&](TSurfLine what, TextRow&, const char*)
    { return what != TSurfLine::Triangle || at++ != triangle; });
  this->Explain(line,
    [&](TSurfLine, TextRow& row)
    {
      for (int i = 0; i < 3; ++i)
      {
        std::int64_t id;
        if (row.ReadInteger(id, VertexId) && this->Maps[chunk.Object].Find(id) < 0)
        {
          this->Scanner.FailAt(row.GetPosition(), ErrorKind::Index, ExistingId, std::to_string(id));
        }
      }
    });
}

//------------------------------------------------------------------------------
bool TSurfRecords::Read(CellMesh& mesh, Warnings& warnings, const Progress& progress)
{
  if (!this->Count(progress.Part(0, 0.3)) || !this->ReadIds(mesh, progress.Part(0.3, 0.8)))
  {
    return false;
  }
  this->BuildMaps(warnings);
  const bool good = (this->Points.size() == 0 || this->ResolveAtoms()) &&
    this->MapTriangles(mesh, progress.Part(0.8, 1));
  this->Maps.clear();
  if (this->Plain)
  {
    this->Ids = Buffer<std::int32_t>();
  }
  return good;
}
}
