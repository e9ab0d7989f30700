// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TSurfRecords
 * @brief The vertices and triangles of TSurf objects by their ids, before coordinates are read.
 *
 * The text is split at line ends into chunks, each within one object, which are read in parallel.
 * A record is a line with an id: a vertex, or an atom, which is a second id for a vertex. Points
 * are the vertices of all objects in the order of the file.
 */
#ifndef camaron_TSurfRecords_h
#define camaron_TSurfRecords_h

#include "Intake/CellMesh/CellMesh.h"
#include "Intake/Ids/IdMap.h"
#include "Intake/Rows/LineChunks.h"
#include "TSurfObjects.h"

#include <atomic> // for what several threads find

namespace camaron
{
class TSurfRecords
{
public:
  struct Atom
  {
    std::int32_t Record;
    TSurfLine What;
    const char* Text; ///< its line
  };

  struct Chunk
  {
    std::size_t Object;
    const char* Begin;
    const char* End;
    vtkIdType Records = 0; ///< number before the chunk; likewise the following
    vtkIdType Points = 0;
    vtkIdType Triangles = 0;
    vtkIdType Faces = 0; ///< of the same object
    vtkIdType PropertyRecords = 0;
    std::vector<Atom> Atoms; ///< in the chunk
  };

  /**
   * @param scanner for errors
   * @param chunk bytes of text per task
   */
  TSurfRecords(TextScanner& scanner, const std::vector<TSurfObject>& objects, vtkIdType chunk);

  /// Finds all records and triangles; false with the error in the scanner, or if aborted.
  bool Read(CellMesh& mesh, Warnings& warnings, const Progress& progress);

  /// All chunks, and one more with the totals.
  const std::vector<Chunk>& GetChunks() const { return this->Chunks; }
  vtkIdType GetNumberOfChunks() const { return static_cast<vtkIdType>(this->Chunks.size()) - 1; }
  /// Of one object.
  vtkIdType GetNumberOfPropertyRecords(std::size_t object) const;

  /// Id of a record in the file; only if ids are not plain.
  std::int32_t GetId(vtkIdType record) const { return this->Ids[record]; }
  /// Whether all ids equal the point ids of VTK.
  bool HasPlainIds() const { return this->Plain; }
  /// Point of a record; for atoms, of their vertex.
  std::int32_t GetPoint(vtkIdType record) const
  {
    return this->Points.size() > 0 ? this->Points[record] : static_cast<std::int32_t>(record);
  }

  /**
   * Calls @a visit(TSurfLine, TextRow&, const char* line) for every line of a chunk, with the row
   * after the keyword; lines with other keywords are skipped. Returns the line for which @a visit
   * returned false, or nullptr.
   */
  template <typename Visit>
  static const char* ForEachLine(const Chunk& chunk, Visit&& visit)
  {
    for (const char* text = chunk.Begin; text < chunk.End;)
    {
      const Line line(text, chunk.End);
      const char* row = text;
      const TSurfLine what = ReadKeyword(row, line.End);
      if (what != TSurfLine::Other)
      {
        TextRow values(row, line.End, '#');
        if (!visit(what, values, text))
        {
          return text;
        }
      }
      text = line.Next;
    }
    return nullptr;
  }

  /**
   * Calls @a visit(chunk), which returns an invalid line or nullptr, for all chunks in parallel.
   * For the first such line, calls @a explain(TSurfLine, TextRow&), which sets the error with a row
   * of the scanner. Returns false then, or if aborted.
   */
  template <typename Visit, typename Explain>
  bool ForEachChunk(const Progress& progress, Visit&& visit, Explain&& explain)
  {
    std::atomic<const char*> wrong{ nullptr };
    progress.For(this->GetNumberOfChunks(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const char* const line = visit(this->Chunks[i]);
          const char* first = wrong;
          while (line && (!first || line < first) && !wrong.compare_exchange_weak(first, line))
          {
          }
        }
      });
    if (wrong && !progress.IsStopped())
    {
      this->Explain(wrong, explain);
    }
    return !wrong && !progress.IsStopped();
  }

private:
  template <typename Explanation>
  void Explain(const char* line, Explanation&& explain)
  {
    this->Scanner.SetPosition(line);
    const TSurfLine what = ReadKeyword(line, this->Scanner.GetEnd());
    TextRow row(this->Scanner, RowLayout::OneLine);
    std::string_view keyword;
    row.ReadWord(keyword, "");
    explain(what, row);
  }

  bool Count(const Progress& progress);
  bool ReadIds(CellMesh& mesh, const Progress& progress);
  bool ReadId(TSurfLine what, TextRow& row, std::int32_t* ids) const;
  void BuildMaps(Warnings& warnings);
  bool ResolveAtoms();
  bool MapTriangles(CellMesh& mesh, const Progress& progress);
  void ExplainTriangle(const Chunk& chunk, vtkIdType triangle);

  TextScanner& Scanner;
  const std::vector<TSurfObject>& Objects;
  std::vector<Chunk> Chunks;
  Buffer<std::int32_t> Ids;
  Buffer<std::int32_t> Points; ///< of records, if there are atoms
  std::vector<IdMap> Maps;     ///< of objects, from ids to records; only while these are read
  std::vector<vtkIdType> FirstRecords; ///< of objects, and one more
  std::atomic<bool> Plain{ true };
};
}

#endif
