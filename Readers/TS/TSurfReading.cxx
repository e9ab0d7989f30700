// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The records of the objects of a file, and their grid.
#include "Base/Parallel.h"
#include "Intake/CellMesh/CellGrid.h"
#include "Intake/Ids/IdMap.h"
#include "Intake/Rows/LineChunks.h"
#include "Intake/Rows/TextRows.h"
#include "TSurf.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// A second id of a vertex.
struct Atom
{
  std::int32_t Id;
  std::int32_t Vertex; // its id
};

// A part of an object that one thread reads, whole lines.
struct Chunk
{
  std::size_t Object;
  const char* Begin;
  const char* End;
  std::vector<std::int32_t> Vertices; // their ids
  std::vector<Atom> Atoms;
  vtkIdType NumberOfTriangles = 0;
  std::vector<vtkIdType> FaceTriangles; // triangles of the chunk before each TFACE
  bool HasValues = false;               // of properties
  vtkIdType AtomsWithValues = 0;
  // What is before the chunk, faces in its object.
  vtkIdType Points = 0;
  vtkIdType Triangles = 0;
  vtkIdType Faces = 0;
  vtkIdType Next = 0; // vertex or triangle of the chunk when it is read again
};

// The vertices of an object by their ids.
struct VertexMap
{
  vtkIdType FirstPoint;
  IdMap Vertices, Atoms;
  std::vector<std::int32_t> OfAtoms;

  std::int32_t Find(std::int32_t id) const
  {
    const std::int32_t atom = this->Atoms.Find(id);
    return atom < 0 ? this->Vertices.Find(id) : this->OfAtoms[atom];
  }
};

// Properties of the same name in several objects.
struct PropertyArray
{
  std::string Name;
  int Size;
  Buffer<double> Values;
};

//------------------------------------------------------------------------------
// The first CR that is not followed by LF, or the end.
const char* FindLoneReturn(const char* begin, const char* end)
{
  const std::string_view text(begin, static_cast<std::size_t>(end - begin));
  std::size_t at = text.find('\r');
  while (at != text.npos && at + 1 < text.size() && text[at + 1] == '\n')
  {
    at = text.find('\r', at + 1);
  }
  return at == text.npos ? end : begin + at;
}

//------------------------------------------------------------------------------
bool IsVertex(std::string_view keyword)
{
  return keyword == "VRTX" || keyword == "PVRTX";
}

//------------------------------------------------------------------------------
bool IsAtom(std::string_view keyword)
{
  return keyword == "ATOM" || keyword == "PATOM";
}

//------------------------------------------------------------------------------
// Reads ids, which may also be negative.
bool ReadAnyIds(TextRow& row, int count, std::int32_t* ids)
{
  for (int i = 0; i < count; ++i)
  {
    std::int64_t value;
    if (!row.ReadInteger(value, "the id of a vertex"))
    {
      return false;
    }
    ids[i] = static_cast<std::int32_t>(value);
    if (ids[i] != value)
    {
      return row.FailAtLast(ErrorKind::Index, "a vertex id below 2147483648");
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool FailAtUnknown(TextRow& row, std::int32_t id)
{
  return row.FailAt(
    row.GetPosition(), ErrorKind::Index, "the id of a vertex of the surface", std::to_string(id));
}

//------------------------------------------------------------------------------
class TSurfReading
{
public:
  TSurfReading(TextScanner& scanner, const std::vector<TSurfObject>& objects, vtkIdType chunkSize);

  bool Read(const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings,
    const Progress& progress);

private:
  template <typename IsNeeded, typename Visit>
  bool ForEachLine(const Progress& progress, IsNeeded&& isNeeded, Visit&& visit);
  bool ReadIds(const Progress& progress);
  bool NumberVertices(Warnings& warnings);
  bool ReadTriangles(CellMesh& mesh, const Progress& progress);
  bool AddProperties(std::size_t object);
  bool MakeArrays(vtkIdType numberOfPoints);
  bool ReadVertices(const CellMeshPiece& piece, const Progress& progress);
  bool ReadValues(TextRow& row, std::size_t object, vtkIdType point);
  void AddParts(const CellMeshPiece& piece, vtkUnstructuredGrid* grid) const;
  void AddTexts(vtkUnstructuredGrid* grid) const;

  TextScanner& Scanner; // for errors
  const std::vector<TSurfObject>& Objects;
  std::vector<Chunk> Chunks;   // and one more, with the totals
  std::vector<VertexMap> Maps; // of objects
  bool HasOtherIds = false;    // than those of VTK
  Buffer<double> Coordinates;
  Buffer<vtkIdType> Ids;
  std::vector<PropertyArray> Arrays;
  std::vector<std::vector<std::size_t>> ArraysOfObjects; // one for each property
};

//------------------------------------------------------------------------------
TSurfReading::TSurfReading(
  TextScanner& scanner, const std::vector<TSurfObject>& objects, vtkIdType chunkSize)
  : Scanner(scanner)
  , Objects(objects)
{
  for (std::size_t i = 0; i < objects.size(); ++i)
  {
    const char* text = objects[i].Begin;
    while (text < objects[i].End)
    {
      const char* const next = CutAtLine(text, objects[i].End, chunkSize);
      this->Chunks.push_back({ i, text, next });
      text = next;
    }
  }
  this->Chunks.push_back({ objects.size(), scanner.GetEnd(), scanner.GetEnd() });
}

//------------------------------------------------------------------------------
// Calls visit(chunk, keyword, row) for all lines of chunks that isNeeded(chunk), those of a chunk
// in order, with the row after the keyword; and again for the first line for which it returned
// false, with a row that sets the error. False then, or if stopped.
template <typename IsNeeded, typename Visit>
bool TSurfReading::ForEachLine(const Progress& progress, IsNeeded&& isNeeded, Visit&& visit)
{
  std::vector<const char*> invalid(this->Chunks.size() - 1, nullptr);
  progress.For(static_cast<vtkIdType>(invalid.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        Chunk& chunk = this->Chunks[i];
        chunk.Next = 0;
        const char* line = isNeeded(chunk) ? chunk.Begin : chunk.End;
        while (line < chunk.End && !invalid[i])
        {
          TextRow row(line, chunk.End, '#');
          std::string_view keyword;
          invalid[i] = row.ReadWord(keyword, "") && !visit(chunk, keyword, row) ? line : nullptr;
          line = Line(row.GetPosition(), chunk.End).Next;
        }
      }
    });
  for (std::size_t i = 0; i < invalid.size() && !progress.IsStopped(); ++i)
  {
    if (invalid[i])
    {
      this->Scanner.SetPosition(invalid[i]);
      TextRow row(this->Scanner, RowLayout::OneLine);
      std::string_view keyword;
      row.ReadWord(keyword, "");
      visit(this->Chunks[i], keyword, row);
      return false;
    }
  }
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
// Reads the ids of vertices, and counts triangles.
bool TSurfReading::ReadIds(const Progress& progress)
{
  return this->ForEachLine(
    progress, [](const Chunk&) { return true; },
    [](Chunk& chunk, std::string_view keyword, TextRow& row)
    {
      std::int32_t ids[2];
      const bool hasValues = keyword[0] == 'P';
      if (keyword == "TRGL")
      {
        ++chunk.NumberOfTriangles;
      }
      else if (IsVertex(keyword))
      {
        if (!ReadAnyIds(row, 1, ids))
        {
          return false;
        }
        chunk.Vertices.push_back(ids[0]);
        chunk.HasValues = chunk.HasValues || hasValues;
      }
      else if (IsAtom(keyword))
      {
        if (!ReadAnyIds(row, 2, ids))
        {
          return false;
        }
        chunk.Atoms.push_back({ ids[0], ids[1] });
        chunk.AtomsWithValues += hasValues;
      }
      else if (keyword == "TFACE")
      {
        chunk.FaceTriangles.push_back(chunk.NumberOfTriangles);
      }
      return true;
    });
}

//------------------------------------------------------------------------------
// Numbers points, triangles and faces over all chunks, and maps the ids of vertices.
bool TSurfReading::NumberVertices(Warnings& warnings)
{
  this->Maps.resize(this->Objects.size());
  vtkIdType points = 0, triangles = 0, repeated = 0, atomsWithValues = 0;
  auto chunk = this->Chunks.begin();
  for (std::size_t object = 0; object < this->Objects.size(); ++object)
  {
    VertexMap& map = this->Maps[object];
    map.FirstPoint = points;
    std::vector<std::int32_t> ids, idsOfAtoms;
    std::vector<Atom> atoms;
    for (vtkIdType faces = 0; chunk->Object == object; ++chunk)
    {
      chunk->Points = points;
      chunk->Triangles = triangles;
      chunk->Faces = faces;
      for (const std::int32_t id : chunk->Vertices)
      {
        this->HasOtherIds = this->HasOtherIds || id != points;
        ++points;
      }
      triangles += chunk->NumberOfTriangles;
      faces += static_cast<vtkIdType>(chunk->FaceTriangles.size());
      ids.insert(ids.end(), chunk->Vertices.begin(), chunk->Vertices.end());
      atoms.insert(atoms.end(), chunk->Atoms.begin(), chunk->Atoms.end());
      atomsWithValues += chunk->AtomsWithValues;
    }
    if (std::max(points, 3 * triangles) > INT32_MAX)
    {
      return this->Scanner.FailAt(this->Scanner.GetPosition(), ErrorKind::Unsupported,
        "fewer than 2147483648 vertices, and vertices of triangles", "more");
    }
    map.Vertices.Build(ids.data(), static_cast<vtkIdType>(ids.size()));
    repeated += map.Vertices.GetNumberOfRepeated();
    for (const Atom& atom : atoms)
    {
      idsOfAtoms.push_back(atom.Id);
      map.OfAtoms.push_back(map.Vertices.Find(atom.Vertex));
    }
    map.Atoms.Build(idsOfAtoms.data(), static_cast<vtkIdType>(atoms.size()));
  }
  chunk->Points = points; // the totals
  chunk->Triangles = triangles;
  if (repeated > 0)
  {
    warnings.Add("vertices with the id of another vertex of their surface: " +
      std::to_string(repeated) + "; triangles use the last vertex with each id");
  }
  if (atomsWithValues > 0)
  {
    warnings.Add("atoms with properties, which are not read: " + std::to_string(atomsWithValues));
  }
  return true;
}

//------------------------------------------------------------------------------
bool TSurfReading::ReadTriangles(CellMesh& mesh, const Progress& progress)
{
  return this->ForEachLine(
    progress,
    [](const Chunk& chunk) { return chunk.NumberOfTriangles > 0 || !chunk.Atoms.empty(); },
    [&](Chunk& chunk, std::string_view keyword, TextRow& row)
    {
      const VertexMap& map = this->Maps[chunk.Object];
      std::int32_t ids[3];
      if (IsAtom(keyword))
      {
        return ReadAnyIds(row, 2, ids) &&
          (map.Vertices.Find(ids[1]) >= 0 || FailAtUnknown(row, ids[1]));
      }
      if (keyword != "TRGL")
      {
        return true;
      }
      // There are more only if the file has changed since they were counted.
      if (chunk.Next == chunk.NumberOfTriangles || !ReadAnyIds(row, 3, ids))
      {
        return false;
      }
      std::int32_t* to = mesh.Connectivity.data() + 3 * (chunk.Triangles + chunk.Next);
      for (const std::int32_t id : ids)
      {
        const std::int32_t vertex = map.Find(id);
        if (vertex < 0)
        {
          return FailAtUnknown(row, id);
        }
        *to++ = static_cast<std::int32_t>(map.FirstPoint) + vertex;
      }
      ++chunk.Next;
      return true;
    });
}

//------------------------------------------------------------------------------
// Adds arrays for the properties of an object, unless other objects have them, too.
bool TSurfReading::AddProperties(std::size_t object)
{
  constexpr std::string_view OwnNames[] = { PointIdArray, "GlobalPointIds", "vtkGhostType" };
  std::vector<std::size_t>& arrays = this->ArraysOfObjects[object];
  for (const TSurfProperty& property : this->Objects[object].Properties)
  {
    const std::string& name = property.Name;
    const auto same = std::find_if(this->Arrays.begin(), this->Arrays.end(),
      [&name](const PropertyArray& array) { return array.Name == name; });
    const auto place = static_cast<std::size_t>(same - this->Arrays.begin());
    if (same == this->Arrays.end())
    {
      this->Arrays.push_back({ name, property.Size, {} });
    }
    if (this->Arrays[place].Size != property.Size ||
      std::find(arrays.begin(), arrays.end(), place) != arrays.end() ||
      std::find(std::begin(OwnNames), std::end(OwnNames), name) != std::end(OwnNames))
    {
      return this->Scanner.FailAt(this->Objects[object].Begin, ErrorKind::Unsupported,
        "properties with a name of their own, or with as many values as in other surfaces, before "
        "this line",
        "'" + name + "'");
    }
    arrays.push_back(place);
  }
  return true;
}

//------------------------------------------------------------------------------
bool TSurfReading::MakeArrays(vtkIdType numberOfPoints)
{
  this->ArraysOfObjects.resize(this->Objects.size());
  for (const Chunk& chunk : this->Chunks)
  {
    if (chunk.HasValues && this->ArraysOfObjects[chunk.Object].empty() &&
      !this->AddProperties(chunk.Object))
    {
      return false;
    }
  }
  // With many values of a few vertices, arrays might not fit into memory.
  constexpr int MaxGrowth = 10;
  std::int64_t values = 0;
  for (const PropertyArray& array : this->Arrays)
  {
    values += array.Size;
  }
  const vtkIdType fileSize = this->Scanner.GetEnd() - this->Objects[0].Begin;
  constexpr int DoubleBytes = sizeof(double);
  if (values > 0 && this->Chunks.back().Points > MaxGrowth * fileSize / (DoubleBytes * values))
  {
    return this->Scanner.FailAt(this->Objects[0].Begin, ErrorKind::Unsupported,
      "properties for a larger part of the vertices",
      std::to_string(values) + " values per vertex");
  }
  for (PropertyArray& array : this->Arrays)
  {
    array.Values = Buffer<double>(numberOfPoints * array.Size);
    std::fill(array.Values.data(), array.Values.data() + array.Values.size(), NaN);
  }
  this->Coordinates = Buffer<double>(3 * numberOfPoints);
  this->Ids = Buffer<vtkIdType>(this->HasOtherIds ? numberOfPoints : 0);
  return true;
}

//------------------------------------------------------------------------------
// Reads coordinates and properties of the vertices of a piece.
bool TSurfReading::ReadVertices(const CellMeshPiece& piece, const Progress& progress)
{
  return this->MakeArrays(piece.GetNumberOfPoints()) &&
    this->ForEachLine(
      progress, [](const Chunk& chunk) { return !chunk.Vertices.empty(); },
      [&](Chunk& chunk, std::string_view keyword, TextRow& row)
      {
        if (!IsVertex(keyword))
        {
          return true;
        }
        const auto vertices = static_cast<vtkIdType>(chunk.Vertices.size());
        std::int32_t id;
        double x[3];
        if (chunk.Next == vertices || !ReadAnyIds(row, 1, &id) || !row.ReadPoint(x, Coordinate))
        {
          return false;
        }
        const vtkIdType point = piece.FindPoint(chunk.Points + chunk.Next);
        if (point >= 0)
        {
          std::copy(x, x + 3, this->Coordinates.data() + 3 * point);
        }
        if (point >= 0 && this->HasOtherIds)
        {
          this->Ids[point] = id;
        }
        if (keyword == "PVRTX" && !this->ReadValues(row, chunk.Object, point))
        {
          return false;
        }
        ++chunk.Next;
        return true;
      });
}

//------------------------------------------------------------------------------
// Reads the properties of a vertex; point is its index in the piece, or -1 if it is in another one.
bool TSurfReading::ReadValues(TextRow& row, std::size_t object, vtkIdType point)
{
  const std::vector<TSurfProperty>& properties = this->Objects[object].Properties;
  const std::vector<std::size_t>& arrays = this->ArraysOfObjects[object];
  for (std::size_t p = 0; p < arrays.size(); ++p)
  {
    for (int c = 0; c < properties[p].Size; ++c)
    {
      double value;
      if (!row.ReadReal(value, "a value of a property"))
      {
        return false;
      }
      if (point >= 0 && !(properties[p].HasNoData && value == properties[p].NoData))
      {
        this->Arrays[arrays[p]].Values[point * properties[p].Size + c] = value;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Adds the object, and the face in it, to which each triangle belongs.
void TSurfReading::AddParts(const CellMeshPiece& piece, vtkUnstructuredGrid* grid) const
{
  Buffer<int> parts(piece.GetNumberOfCells()), faces(piece.GetNumberOfCells());
  ParallelForEach(static_cast<vtkIdType>(this->Chunks.size()) - 1, 1,
    [&](vtkIdType i)
    {
      const Chunk& chunk = this->Chunks[i];
      // Triangles before the first TFACE belong to the same face as those after it.
      vtkIdType face = chunk.Faces - 1;
      auto next = chunk.FaceTriangles.begin();
      for (vtkIdType triangle = 0; triangle < chunk.NumberOfTriangles; ++triangle)
      {
        for (; next != chunk.FaceTriangles.end() && *next <= triangle; ++next)
        {
          ++face;
        }
        if (const vtkIdType cell = piece.FindCell(chunk.Triangles + triangle); cell >= 0)
        {
          parts[cell] = static_cast<int>(chunk.Object);
          faces[cell] = static_cast<int>(std::max<vtkIdType>(face, 0));
        }
      }
    });
  grid->GetCellData()->AddArray(parts.TakeArray<vtkIntArray>(1, PartArray));
  grid->GetCellData()->AddArray(faces.TakeArray<vtkIntArray>(1, FaceArray));
}

//------------------------------------------------------------------------------
void TSurfReading::AddTexts(vtkUnstructuredGrid* grid) const
{
  for (const TSurfText& text : TSurfTexts)
  {
    vtkNew<vtkStringArray> array;
    array->SetName(text.Array);
    bool isEmpty = true;
    for (const TSurfObject& object : this->Objects)
    {
      array->InsertNextValue(object.*text.Text);
      isEmpty = isEmpty && (object.*text.Text).empty();
    }
    if (!isEmpty)
    {
      grid->GetFieldData()->AddArray(array);
    }
  }
}

//------------------------------------------------------------------------------
bool TSurfReading::Read(const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings,
  const Progress& progress)
{
  if (!this->ReadIds(progress.Part(0.1, 0.3)) || !this->NumberVertices(warnings))
  {
    return false;
  }
  const Chunk& totals = this->Chunks.back();
  CellMesh mesh(totals.Points, totals.Triangles, VTK_TRIANGLE, 3);
  if (!this->ReadTriangles(mesh, progress.Part(0.3, 0.5)))
  {
    return false;
  }
  const bool hasTriangles = totals.Triangles > 0;
  if (!hasTriangles)
  {
    mesh = MakeCloud(totals.Points);
  }
  CellMeshPiece piece;
  if (!piece.Select(mesh, request, progress.Part(0.5, 0.55)))
  {
    return false;
  }
  KeepPiece(mesh, piece); // before there is memory for values
  if (!this->ReadVertices(piece, progress.Part(0.55, 0.9)))
  {
    return false;
  }
  if (request.Piece == 0)
  {
    piece.WarnOfRepeatedPoints(mesh, warnings, progress.Part(0.9, 1), "triangle", "triangles");
  }
  else
  {
    warnings = Warnings();
  }
  FillGrid(mesh, piece, this->Coordinates.TakeArray<vtkDoubleArray>(3), grid);
  for (PropertyArray& array : this->Arrays)
  {
    grid->GetPointData()->AddArray(
      array.Values.TakeArray<vtkDoubleArray>(array.Size, array.Name.c_str()));
  }
  if (this->HasOtherIds)
  {
    grid->GetPointData()->AddArray(this->Ids.TakeArray<vtkIdTypeArray>(1, PointIdArray));
  }
  if (hasTriangles)
  {
    this->AddParts(piece, grid);
  }
  this->AddTexts(grid);
  return !progress.IsStopped();
}
}

//------------------------------------------------------------------------------
bool ReadTSurf(const MappedFile& file, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress, vtkIdType chunk)
{
  const char* const end = FindTextEnd(file.begin(), file.end());
  TextScanner scanner(file.GetName(), file.begin(), end, '#');
  std::vector<TSurfObject> objects;
  const char* const lone = FindLoneReturn(scanner.GetBegin(), end);
  const bool good = lone < end
    ? scanner.FailAt(lone, ErrorKind::Unsupported, "lines that end with LF or CRLF", "CR")
    : FindObjects(scanner, objects, warnings) &&
      TSurfReading(scanner, objects, chunk).Read(request, grid, warnings, progress);
  error = progress.IsStopped() ? ScanError() : scanner.GetError();
  return good && !error;
}
}
