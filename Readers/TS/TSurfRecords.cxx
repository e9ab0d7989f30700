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

//------------------------------------------------------------------------------
// Reads the ids of a line, and returns their number; 0 after an error.
int ReadLineIds(TSurfLine what, TextRow& row, std::int32_t ids[3])
{
  const bool isVertex = what == TSurfLine::Vertex || what == TSurfLine::PropertyVertex;
  const int count = isVertex ? 1 : what == TSurfLine::Triangle ? 3 : 2;
  for (int i = 0; i < count; ++i)
  {
    if (!ReadAnyId(row, ids[i]))
    {
      return 0;
    }
  }
  return count;
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
const char* TSurfRecords::ReadIds(Chunk& chunk) const
{
  return ForEachLine(chunk,
    [&chunk](TSurfLine what, TextRow& row, const char* line)
    {
      if (what == TSurfLine::Face)
      {
        chunk.FaceStarts.push_back(static_cast<vtkIdType>(chunk.Corners.size()) / 3);
        return true;
      }
      std::int32_t ids[3];
      const int count = ReadLineIds(what, row, ids);
      if (count == 1)
      {
        chunk.Vertices.push_back(ids[0]);
      }
      else if (count == 2)
      {
        chunk.Atoms.push_back({ ids[0], ids[1], what == TSurfLine::PropertyAtom, line });
      }
      else
      {
        chunk.Corners.insert(chunk.Corners.end(), ids, ids + count);
      }
      chunk.HasProperties = chunk.HasProperties || what == TSurfLine::PropertyVertex;
      return count > 0;
    });
}

//------------------------------------------------------------------------------
// Sums the counts of chunks up to those before each.
bool TSurfRecords::Sum()
{
  Chunk sum{};
  for (Chunk& chunk : this->Chunks)
  {
    chunk.Points = sum.Points;
    chunk.Triangles = sum.Triangles;
    chunk.Faces = chunk.Object == sum.Object ? sum.Faces : 0;
    sum.Object = chunk.Object;
    sum.Points += static_cast<vtkIdType>(chunk.Vertices.size());
    sum.Triangles += static_cast<vtkIdType>(chunk.Corners.size()) / 3;
    sum.Faces = chunk.Faces + static_cast<vtkIdType>(chunk.FaceStarts.size());
  }
  return std::max(sum.Points, 3 * sum.Triangles) <= INT32_MAX ||
    this->Scanner.FailAt(this->Scanner.GetPosition(), ErrorKind::Unsupported,
      "fewer than 2147483648 vertices, and vertices of triangles", "more");
}

//------------------------------------------------------------------------------
// Replaces the ids of the corners of an object by points.
bool TSurfRecords::MapObject(std::size_t firstChunk, std::size_t endChunk, CellMesh& mesh)
{
  const vtkIdType firstPoint = this->Chunks[firstChunk].Points;
  const auto points = static_cast<std::int32_t>(this->Chunks[endChunk].Points - firstPoint);
  std::vector<Atom> atoms;
  for (std::size_t i = firstChunk; i < endChunk; ++i)
  {
    Chunk& chunk = this->Chunks[i];
    std::copy(chunk.Vertices.begin(), chunk.Vertices.end(), this->Ids.data() + chunk.Points);
    atoms.insert(atoms.end(), chunk.Atoms.begin(), chunk.Atoms.end());
    chunk.Vertices = {};
    chunk.Atoms = {};
  }
  const auto hasProperties = [](const Atom& atom) { return atom.HasProperties; };
  this->PropertyAtoms += std::count_if(atoms.begin(), atoms.end(), hasProperties);
  IdMap vertices, names;
  vertices.Build(this->Ids.data() + firstPoint, points);
  this->Repeated += vertices.GetNumberOfRepeated();
  std::vector<std::int32_t> ids, vertexOfAtom;
  for (const Atom& atom : atoms)
  {
    ids.push_back(atom.Id);
    vertexOfAtom.push_back(vertices.Find(atom.Vertex));
    if (vertexOfAtom.back() < 0)
    {
      return this->Scanner.FailAt(
        atom.Line, ErrorKind::Index, ExistingId, std::to_string(atom.Vertex));
    }
  }
  names.Build(ids.data(), static_cast<vtkIdType>(ids.size()));
  constexpr std::size_t None = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> wrong(endChunk - firstChunk, None); // corners of chunks
  ParallelFor(static_cast<vtkIdType>(wrong.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Chunk& chunk = this->Chunks[firstChunk + i];
        std::int32_t* to = mesh.Connectivity.data() + 3 * chunk.Triangles;
        for (std::size_t c = 0; c < chunk.Corners.size() && wrong[i] == None; ++c)
        {
          const std::int32_t id = chunk.Corners[c], atom = names.Find(id);
          const std::int32_t vertex = atom < 0 ? vertices.Find(id) : vertexOfAtom[atom];
          *to++ = static_cast<std::int32_t>(firstPoint) + vertex;
          wrong[i] = vertex < 0 ? c : None;
        }
      }
    });
  for (std::size_t i = 0; i < wrong.size(); ++i)
  {
    Chunk& chunk = this->Chunks[firstChunk + i];
    if (wrong[i] != None)
    {
      std::size_t triangle = wrong[i] / 3;
      const char* const line = ForEachLine(chunk, [&triangle](TSurfLine what, TextRow&, const char*)
        { return what != TSurfLine::Triangle || triangle-- != 0; });
      return this->Scanner.FailAt(line ? line : chunk.Begin, ErrorKind::Index, ExistingId,
        std::to_string(chunk.Corners[wrong[i]]));
    }
    chunk.Corners = {};
  }
  return true;
}

//------------------------------------------------------------------------------
bool TSurfRecords::Read(CellMesh& mesh, Warnings& warnings, const Progress& progress)
{
  if (!this->ForEachChunk(
        progress, [this](Chunk& chunk) { return this->ReadIds(chunk); },
        [](std::size_t, TSurfLine what, TextRow& row)
        {
          std::int32_t ids[3];
          ReadLineIds(what, row, ids);
        }) ||
    !this->Sum())
  {
    return false;
  }
  const Chunk& totals = this->Chunks.back();
  mesh = CellMesh(totals.Points, totals.Triangles, VTK_TRIANGLE, 3);
  this->Ids = Buffer<std::int32_t>(totals.Points);
  for (std::size_t first = 0, end = 1; first + 1 < this->Chunks.size(); first = end)
  {
    while (this->Chunks[end].Object == this->Chunks[first].Object)
    {
      ++end;
    }
    if (!this->MapObject(first, end, mesh))
    {
      return false;
    }
  }
  vtkIdType same = 0;
  while (same < this->Ids.size() && this->Ids[same] == same)
  {
    ++same;
  }
  this->Ids = same == this->Ids.size() ? Buffer<std::int32_t>() : std::move(this->Ids);
  const auto warn = [&warnings](const char* what, vtkIdType count, const char* rest)
  {
    if (count > 0)
    {
      warnings.Add(what + std::to_string(count) + rest);
    }
  };
  warn("vertices with the id of another vertex of their surface: ", this->Repeated,
    "; triangles use the last vertex with each id");
  warn("atoms with properties, which are not read: ", this->PropertyAtoms, "");
  return true;
}
}
