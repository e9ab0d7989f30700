// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VisfWriting.h"

#include "CellMesh/OutputWarnings.h"
#include "Mesh/CellFacets.h"
#include "Mesh/MeshTopology.h"
#include "Scan/Buffer.h"
#include "Scan/Bytes.h"
#include "Scan/MappedFile.h"
#include "Scan/Number.h"
#include "Scan/WriteChunks.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <new>
#include <stdexcept>

namespace camaron
{
namespace
{
constexpr vtkIdType ChunkSize = 4096;

//------------------------------------------------------------------------------
// Lists in the form of the file, n id1 ... idn, with the word at which every chunk of lists begins.
struct WordLists
{
  vtkIdType Count = 0;
  Buffer<std::int32_t> Words;
  std::vector<vtkIdType> Starts;
  vtkIdType GetNumberOfChunks() const { return static_cast<vtkIdType>(this->Starts.size()) - 1; }
};

//------------------------------------------------------------------------------
// What a cell of VTK is to Visf.
enum class Role
{
  Polyhedron,
  Polygon,
  Strip,
  None
};

//------------------------------------------------------------------------------
// The polygons and polyhedra of a mesh, and how they are numbered.
class VisfLists
{
public:
  VisfLists(vtkDataSet* mesh, Warnings& warnings)
    : Topology(mesh)
    , Mesh(this->Topology.GetMesh())
    , Faces(this->Topology.GetFaces())
    , Shapes(&GetCellShape(0))
  {
    this->Classify(warnings);
    if (!this->Cloud)
    {
      this->Build();
    }
  }

  int GetType() const
  {
    return this->Polyhedra.Count > 0 ? 2 : this->Polygons.Count > 0 ? 1 : 0;
  }
  const MeshView& GetMesh() const { return this->Mesh; }

  WordLists Polygons;
  WordLists Polyhedra;

private:
  Role GetRole(vtkIdType cell) const;
  void Classify(Warnings& warnings);
  bool IsClosed(vtkIdType cell) const;
  void ShareFacet(Index facet);
  void FindExtraUses();
  void Build();
  struct Scratch
  {
    CellFacets Facets;
    std::vector<vtkIdType> Polygon;
  };
  template <typename Visit>
  void ForEachPolygon(Scratch& scratch, vtkIdType cell, Visit&& visit) const;
  std::int32_t GetPolygon(vtkIdType cell, Index local, Index facet) const;

  MeshTopology Topology;
  const MeshView& Mesh;
  const FacetTable& Faces;
  const CellShape* Shapes;
  bool Cloud = true;
  std::vector<std::int32_t> PolygonOfFacet;
  // A use of a facet by a cell, as the cell and its local number.
  using Use = std::pair<vtkIdType, Index>;
  // Of a use that does not share the first polygon of its facet.
  struct ExtraUse
  {
    Use Start; // the use whose polygon it has; it may be its own
    std::int32_t Polygon;
  };
  std::map<Use, ExtraUse> ExtraUses;
};

//------------------------------------------------------------------------------
Role VisfLists::GetRole(vtkIdType cell) const
{
  const unsigned char type = this->Mesh.GetCellType(cell);
  const CellShape& shape = this->Shapes[type];
  switch (shape.Dimension)
  {
    case 3:
      return type == VTK_POLYHEDRON || shape.NumberOfFaces > 0 ? Role::Polyhedron : Role::None;
    case 2:
      return type == VTK_TRIANGLE_STRIP ? Role::Strip : Role::Polygon;
    case 1:
    case 0:
      return type == VTK_LINE || type == VTK_VERTEX ? Role::Polygon : Role::None;
    default:
      return type == VTK_EMPTY_CELL ? Role::Polyhedron : Role::None;
  }
}

//------------------------------------------------------------------------------
void VisfLists::Classify(Warnings& warnings)
{
  Tally higherOrder, small, others;
  vtkIdType corners = 0;
  for (vtkIdType cell = 0; cell < this->Mesh.GetNumberOfCells(); ++cell)
  {
    const CellShape& shape = this->Shapes[this->Mesh.GetCellType(cell)];
    const Role role = this->GetRole(cell);
    corners += this->Cloud ? this->Mesh.GetCellPoints(cell).Size : 0;
    if (shape.IsHigherOrder && role != Role::None)
    {
      higherOrder.Add(cell);
    }
    if (shape.Dimension != 0)
    {
      this->Cloud = false;
    }
    if (role == Role::None)
    {
      others.Add(cell);
    }
    else if (shape.Dimension == 0 || shape.Dimension == 1)
    {
      small.Add(cell);
    }
  }
  // Every point of a cloud is read as a cell.
  const bool coversPoints = this->Mesh.GetNumberOfCells() == 0 || corners == this->Mesh.GetNumberOfPoints();
  this->Cloud = this->Cloud && coversPoints;
  if (this->Cloud)
  {
    return;
  }
  warnings.Add(higherOrder, "cell", "cells", "of higher order, written by the corners");
  warnings.Add(small, "cell", "cells", "of one or two points, written as polygons with so many vertices");
  warnings.Add(others, "cell", "cells", "of types that Visf cannot hold, left out");
}

//------------------------------------------------------------------------------
// Whether every edge belongs to two faces; what the reader can turn by itself.
bool VisfLists::IsClosed(vtkIdType cell) const
{
  std::vector<std::pair<vtkIdType, vtkIdType>> edges;
  CellFacets(this->Mesh)
    .ForEach(cell,
      [&edges](const vtkIdType* points, vtkIdType size, vtkIdType)
      {
        for (vtkIdType i = 0; i < size; ++i)
        {
          const vtkIdType a = points[i], b = points[i + 1 < size ? i + 1 : 0];
          if (a != b)
          {
            edges.emplace_back(std::min(a, b), std::max(a, b));
          }
        }
      });
  std::sort(edges.begin(), edges.end());
  bool closed = edges.size() % 2 == 0;
  for (std::size_t i = 0; closed && i < edges.size(); i += 2)
  {
    closed = edges[i] == edges[i + 1] && (i == 0 || edges[i] != edges[i - 1]);
  }
  return closed;
}

//------------------------------------------------------------------------------
// Visf allows a polygon two polyhedra, and it can face outward for both only if these run around it in
// opposite directions. Readers turn closed cells as need be; others need polygons of their own.
void VisfLists::ShareFacet(Index facet)
{
  std::vector<Index> cells;
  this->Faces.GetCells(facet, cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  const Use none(-1, -1);
  Use first = none;
  Use waiting = none; // has a polygon that another use may share
  bool waitingIsReversed = false;
  for (const Index cell : cells)
  {
    const FacetTable::Range facets = this->Faces.GetCellFacets(cell);
    for (Index local = 0; local < facets.size(); ++local)
    {
      if (facets[local].Facet() != facet)
      {
        continue;
      }
      const Use use(cell, local);
      const bool isReversed = facets[local].IsReversed();
      if (waiting != none &&
        (isReversed != waitingIsReversed || (this->IsClosed(cell) && this->IsClosed(waiting.first))))
      {
        if (waiting != first)
        {
          this->ExtraUses[use] = { waiting, -1 };
        }
        waiting = none;
        continue;
      }
      if (first == none)
      {
        first = use;
      }
      else
      {
        this->ExtraUses[use] = { use, -1 };
      }
      waiting = use;
      waitingIsReversed = isReversed;
    }
  }
}

//------------------------------------------------------------------------------
void VisfLists::FindExtraUses()
{
  std::vector<Index> facets;
  std::mutex mutex;
  Progress().For(this->Mesh.GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Index> found;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        for (const CellFacet use : this->Faces.GetCellFacets(cell))
        {
          const FacetTable::CellPair cells = this->Faces.GetCells(use.Facet());
          if (cells.Second >= 0 && !use.IsReversed() &&
            (cells.First != cell || cells.Second == cell ||
              this->Faces.GetNumberOfCells(use.Facet()) > 2))
          {
            found.push_back(use.Facet());
          }
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      facets.insert(facets.end(), found.begin(), found.end());
    });
  std::sort(facets.begin(), facets.end());
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  for (const Index facet : facets)
  {
    this->ShareFacet(facet);
  }
}

//------------------------------------------------------------------------------
// Calls visit(points, size, local) for the polygons that a cell is the first to have; local is the
// number of a face of a 3D cell.
template <typename Visit>
void VisfLists::ForEachPolygon(Scratch& scratch, vtkIdType cell, Visit&& visit) const
{
  switch (this->GetRole(cell))
  {
    case Role::Polyhedron:
    {
      if (this->Mesh.GetCellType(cell) == VTK_EMPTY_CELL)
      {
        return;
      }
      const FacetTable::Range cellFacets = this->Faces.GetCellFacets(cell);
      scratch.Facets.ForEach(cell,
        [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
        {
          const Index facet = cellFacets[static_cast<Index>(local)].Facet();
          bool first = this->Faces.GetCells(facet).First == cell;
          for (Index earlier = 0; first && earlier < local; ++earlier)
          {
            first = cellFacets[earlier].Facet() != facet;
          }
          if (!first && !this->ExtraUses.empty())
          {
            const Use use(cell, static_cast<Index>(local));
            const auto extra = this->ExtraUses.find(use);
            first = extra != this->ExtraUses.end() && extra->second.Start == use;
          }
          if (first)
          {
            visit(points, size, local);
          }
        });
      return;
    }
    case Role::Strip:
    {
      const IndexRange points = this->Mesh.GetCellPoints(cell);
      for (vtkIdType i = 0; i + 2 < points.Size; ++i)
      {
        const vtkIdType triangle[3] = { points[i], points[i + 1 + i % 2], points[i + 2 - i % 2] };
        visit(triangle, vtkIdType(3), vtkIdType(-1));
      }
      return;
    }
    case Role::Polygon:
      scratch.Facets.GetPolygon(cell, scratch.Polygon);
      visit(scratch.Polygon.data(), static_cast<vtkIdType>(scratch.Polygon.size()), vtkIdType(-1));
      return;
    default:
      return;
  }
}

//------------------------------------------------------------------------------
std::int32_t VisfLists::GetPolygon(vtkIdType cell, Index local, Index facet) const
{
  if (!this->ExtraUses.empty())
  {
    const auto extra = this->ExtraUses.find(Use(cell, local));
    if (extra != this->ExtraUses.end())
    {
      return extra->second.Polygon;
    }
  }
  return this->PolygonOfFacet[facet];
}

//------------------------------------------------------------------------------
void VisfLists::Build()
{
  this->FindExtraUses();
  const vtkIdType numberOfCells = this->Mesh.GetNumberOfCells();
  const vtkIdType numberOfChunks = (numberOfCells + ChunkSize - 1) / ChunkSize;
  struct Sizes
  {
    vtkIdType Polygons = 0, PolygonWords = 0, Polyhedra = 0, PolyhedronWords = 0;
  };
  std::vector<Sizes> sizes(static_cast<std::size_t>(numberOfChunks) + 1);
  const auto forChunks = [&](auto&& visit)
  {
    Progress().For(numberOfChunks,
      [&](vtkIdType first, vtkIdType last)
      {
        Scratch scratch{ CellFacets(this->Mesh), {} };
        for (vtkIdType chunk = first; chunk < last; ++chunk)
        {
          visit(scratch, chunk, chunk * ChunkSize, std::min((chunk + 1) * ChunkSize, numberOfCells));
        }
      });
  };
  forChunks(
    [&](Scratch& scratch, vtkIdType chunk, vtkIdType begin, vtkIdType end)
    {
      Sizes sum;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        this->ForEachPolygon(scratch, cell,
          [&sum](const vtkIdType*, vtkIdType size, vtkIdType)
          {
            ++sum.Polygons;
            sum.PolygonWords += 1 + size;
          });
        if (this->GetRole(cell) == Role::Polyhedron)
        {
          ++sum.Polyhedra;
          sum.PolyhedronWords += 1 + this->Faces.GetCellFacets(cell).size();
        }
      }
      sizes[chunk + 1] = sum;
    });
  for (vtkIdType chunk = 1; chunk <= numberOfChunks; ++chunk)
  {
    sizes[chunk].Polygons += sizes[chunk - 1].Polygons;
    sizes[chunk].PolygonWords += sizes[chunk - 1].PolygonWords;
    sizes[chunk].Polyhedra += sizes[chunk - 1].Polyhedra;
    sizes[chunk].PolyhedronWords += sizes[chunk - 1].PolyhedronWords;
  }
  const Sizes& total = sizes.back();
  if (std::max(total.Polygons, this->Mesh.GetNumberOfPoints()) > INT32_MAX)
  {
    throw std::length_error("more polygons or vertices than Visf can number");
  }
  this->Polygons.Count = total.Polygons;
  this->Polygons.Words = Buffer<std::int32_t>(total.PolygonWords);
  this->Polyhedra.Count = total.Polyhedra;
  this->Polyhedra.Words = Buffer<std::int32_t>(total.PolyhedronWords);
  for (const Sizes& size : sizes)
  {
    this->Polygons.Starts.push_back(size.PolygonWords);
    this->Polyhedra.Starts.push_back(size.PolyhedronWords);
  }

  this->PolygonOfFacet.resize(static_cast<std::size_t>(this->Faces.GetNumberOfFacets()));
  forChunks(
    [&](Scratch& scratch, vtkIdType chunk, vtkIdType begin, vtkIdType end)
    {
      auto polygon = static_cast<std::int32_t>(sizes[chunk].Polygons);
      std::int32_t* word = this->Polygons.Words.data() + sizes[chunk].PolygonWords;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        this->ForEachPolygon(scratch, cell,
          [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
          {
            *word++ = static_cast<std::int32_t>(size);
            for (vtkIdType i = 0; i < size; ++i)
            {
              *word++ = static_cast<std::int32_t>(points[i]);
            }
            if (local >= 0)
            {
              const auto extra = this->ExtraUses.find(Use(cell, static_cast<Index>(local)));
              if (extra != this->ExtraUses.end())
              {
                extra->second.Polygon = polygon; // every entry has one writer
              }
              else
              {
                const Index facet =
                  this->Faces.GetCellFacets(cell)[static_cast<Index>(local)].Facet();
                this->PolygonOfFacet[facet] = polygon;
              }
            }
            ++polygon;
          });
      }
    });
  for (auto& entry : this->ExtraUses)
  {
    entry.second.Polygon = this->ExtraUses[entry.second.Start].Polygon;
  }

  forChunks(
    [&](Scratch&, vtkIdType chunk, vtkIdType begin, vtkIdType end)
    {
      std::int32_t* word = this->Polyhedra.Words.data() + sizes[chunk].PolyhedronWords;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        if (this->GetRole(cell) == Role::Polyhedron)
        {
          const FacetTable::Range facets = this->Faces.GetCellFacets(cell);
          *word++ = facets.size();
          for (Index local = 0; local < facets.size(); ++local)
          {
            *word++ = this->GetPolygon(cell, local, facets[local].Facet());
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
// For every polygon those that share at least two vertices with it.
WordLists FindNeighbors(const WordLists& polygons, vtkIdType numberOfPoints)
{
  std::vector<vtkIdType> begins; // word of every polygon
  std::vector<vtkIdType> ends(static_cast<std::size_t>(numberOfPoints) + 1, 0);
  const auto getIds = [&](vtkIdType polygon, std::vector<std::int32_t>& ids)
  {
    const std::int32_t* word = polygons.Words.data() + begins[polygon];
    ids.assign(word + 1, word + 1 + *word);
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  };
  std::vector<std::int32_t> ids;
  vtkIdType at = 0;
  for (vtkIdType polygon = 0; polygon < polygons.Count; ++polygon)
  {
    begins.push_back(at);
    getIds(polygon, ids);
    for (const std::int32_t id : ids)
    {
      ++ends[id + 1];
    }
    at += 1 + polygons.Words[at];
  }
  for (std::size_t id = 1; id < ends.size(); ++id)
  {
    ends[id] += ends[id - 1];
  }
  Buffer<std::int32_t> polygonsOf(ends.back());
  for (vtkIdType polygon = 0; polygon < polygons.Count; ++polygon)
  {
    getIds(polygon, ids);
    for (const std::int32_t id : ids)
    {
      polygonsOf[ends[id]++] = static_cast<std::int32_t>(polygon);
    }
  }

  // ends[id] is now where the polygons of id end, and those of the next begin.
  const vtkIdType numberOfChunks = (polygons.Count + ChunkSize - 1) / ChunkSize;
  std::vector<std::vector<std::int32_t>> chunks(static_cast<std::size_t>(numberOfChunks));
  Progress().For(numberOfChunks,
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<std::int32_t> points, candidates;
      for (vtkIdType chunk = first; chunk < last; ++chunk)
      {
        std::vector<std::int32_t>& words = chunks[chunk];
        const vtkIdType end = std::min((chunk + 1) * ChunkSize, polygons.Count);
        for (vtkIdType polygon = chunk * ChunkSize; polygon < end; ++polygon)
        {
          getIds(polygon, points);
          candidates.clear();
          for (const std::int32_t id : points)
          {
            candidates.insert(candidates.end(), polygonsOf.data() + (id > 0 ? ends[id - 1] : 0),
              polygonsOf.data() + ends[id]);
          }
          std::sort(candidates.begin(), candidates.end());
          const std::size_t size = words.size();
          words.push_back(0);
          for (std::size_t i = 1; i < candidates.size(); ++i)
          {
            const bool isSecond = candidates[i] == candidates[i - 1] &&
              (i < 2 || candidates[i] != candidates[i - 2]);
            if (isSecond && candidates[i] != polygon)
            {
              words.push_back(candidates[i]);
              ++words[size];
            }
          }
        }
      }
    });
  WordLists neighbors;
  neighbors.Count = polygons.Count;
  neighbors.Starts.push_back(0);
  for (const auto& words : chunks)
  {
    neighbors.Starts.push_back(neighbors.Starts.back() + static_cast<vtkIdType>(words.size()));
  }
  neighbors.Words = Buffer<std::int32_t>(neighbors.Starts.back());
  for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk)
  {
    std::copy(chunks[chunk].begin(), chunks[chunk].end(),
      neighbors.Words.data() + neighbors.Starts[chunk]);
  }
  return neighbors;
}

//------------------------------------------------------------------------------
// Puts the parts of a file into bytes.
class VisfOutput
{
public:
  VisfOutput(OutputFile& file, VisfEncoding encoding)
    : File(file)
    , Text(encoding == VisfEncoding::Ascii)
    , Swap((encoding == VisfEncoding::Big) != (GetByteOrder() == ByteOrder::Big))
  {
    const char first[] = { '2', '1', '0', '\1' }; // by encoding
    this->File.Write(&first[static_cast<int>(encoding)], 1);
    if (this->Text)
    {
      this->File.Write(" ", 1);
    }
  }

  void WriteCount(vtkIdType count)
  {
    std::string bytes;
    this->Append(bytes, static_cast<std::int32_t>(count), '\n');
    this->File.Write(bytes);
  }

  bool WritePoints(const MeshView& mesh, const Progress& progress)
  {
    const vtkIdType size = mesh.GetNumberOfPoints();
    return WriteChunks(this->File, (size + ChunkSize - 1) / ChunkSize, progress,
      [&](vtkIdType chunk, std::string& bytes)
      {
        for (vtkIdType id = chunk * ChunkSize; id < std::min((chunk + 1) * ChunkSize, size); ++id)
        {
          double x[3];
          mesh.GetPoint(id, x);
          this->Append(bytes, static_cast<float>(x[0]), ' ');
          this->Append(bytes, static_cast<float>(x[1]), ' ');
          this->Append(bytes, static_cast<float>(x[2]), '\n');
        }
      });
  }

  bool WriteLists(const WordLists& lists, const Progress& progress)
  {
    return WriteChunks(this->File, lists.GetNumberOfChunks(), progress,
      [&](vtkIdType chunk, std::string& bytes)
      {
        const std::int32_t* word = lists.Words.data() + lists.Starts[chunk];
        const std::int32_t* const end = lists.Words.data() + lists.Starts[chunk + 1];
        while (word < end)
        {
          const std::int32_t size = *word;
          for (std::int32_t i = 0; i <= size; ++i)
          {
            this->Append(bytes, *word++, i < size ? ' ' : '\n');
          }
        }
      });
  }

private:
  template <typename Number>
  void Append(std::string& bytes, Number number, char separator) const
  {
    if (this->Text)
    {
      AppendNumber(bytes, number);
      bytes += separator;
    }
    else
    {
      char word[4];
      Store(word, number, this->Swap);
      bytes.append(word, 4);
    }
  }

  OutputFile& File;
  bool Text;
  bool Swap;
};

//------------------------------------------------------------------------------
bool Write(OutputFile& file, vtkDataSet* mesh, VisfEncoding encoding, bool neighbors,
  Warnings& warnings, const Progress& progress)
{
  const VisfLists lists(mesh, warnings);
  WarnOfArrays(mesh, "Visf", warnings);
  WarnOfRounding(mesh, warnings);
  if (!progress.Report(0.3))
  {
    return false;
  }
  VisfOutput output(file, encoding);
  output.WriteCount(lists.GetType());
  output.WriteCount(lists.GetMesh().GetNumberOfPoints());
  bool good = output.WritePoints(lists.GetMesh(), progress.Part(0.3, 0.4));
  if (good && (lists.Polygons.Count > 0 || lists.Polyhedra.Count > 0))
  {
    output.WriteCount(lists.Polygons.Count);
    good = output.WriteLists(lists.Polygons, progress.Part(0.4, 0.7));
    if (good && lists.Polygons.Count > 0)
    {
      output.WriteCount(neighbors ? 1 : 0);
      good = !neighbors ||
        output.WriteLists(FindNeighbors(lists.Polygons, lists.GetMesh().GetNumberOfPoints()),
          progress.Part(0.7, 0.8));
    }
  }
  if (good && lists.Polyhedra.Count > 0)
  {
    output.WriteCount(lists.Polyhedra.Count);
    good = output.WriteLists(lists.Polyhedra, progress.Part(0.8, 1));
  }
  return good && !file.HasFailed() && file.Commit();
}
}

//------------------------------------------------------------------------------
bool WriteVisf(const std::string& path, vtkDataSet* mesh, VisfEncoding encoding, bool neighbors,
  Warnings& warnings, ScanError& error, const Progress& progress)
{
  bool good = false;
  WithThreads(
    [&]
    {
      OutputFile file(path);
      try
      {
        good = !file.HasFailed() && Write(file, mesh, encoding, neighbors, warnings, progress);
        error = file.GetError();
      }
      catch (const std::bad_alloc&)
      {
        error = { ErrorKind::Memory, GetFileName(path) + ": not enough memory to write the mesh" };
      }
      catch (const std::length_error& reason)
      {
        error = { ErrorKind::Unsupported, GetFileName(path) + ": " + reason.what() };
      }
    });
  return good && !error;
}
}
