// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TSurfRecords
 * @brief The vertices and triangles of TSurf objects by their ids, before coordinates are read.
 *
 * The text is split at line ends into chunks, each within one object, which are read in parallel.
 * Points are the vertices of all objects in the order of the file; an atom is a second id for a
 * vertex.
 */
#ifndef camaron_TSurfRecords_h
#define camaron_TSurfRecords_h

#include "Intake/CellMesh/CellMesh.h"
#include "Intake/Ids/IdMap.h"
#include "Intake/Rows/LineChunks.h"
#include "TSurfObjects.h"

namespace camaron
{
class TSurfRecords
{
public:
  struct Atom
  {
    std::int32_t Id;
    std::int32_t Vertex; ///< its id
    bool HasProperties;
    const char* Line;
  };

  struct Chunk
  {
    std::size_t Object;
    const char* Begin;
    const char* End;
    ///@{
    /// What is before the chunk in all objects, faces in its own.
    vtkIdType Points = 0;
    vtkIdType Triangles = 0;
    vtkIdType Faces = 0;
    ///@}
    std::vector<vtkIdType> FaceStarts; ///< triangles of the chunk before each TFACE
    bool HasProperties = false;
    ///@{
    /// Ids, only while they are read.
    std::vector<std::int32_t> Vertices;
    std::vector<std::int32_t> Corners; ///< of triangles
    std::vector<Atom> Atoms;
    ///@}
  };

  /**
   * @param scanner for errors
   * @param chunk bytes of text per task
   */
  TSurfRecords(TextScanner& scanner, const std::vector<TSurfObject>& objects, vtkIdType chunk);

  /// Finds all points and triangles; false with the error in the scanner, or if aborted.
  bool Read(CellMesh& mesh, Warnings& warnings, const Progress& progress);

  /// All chunks, and one more with the totals.
  const std::vector<Chunk>& GetChunks() const { return this->Chunks; }
  vtkIdType GetNumberOfChunks() const { return static_cast<vtkIdType>(this->Chunks.size()) - 1; }

  /// Ids of all points in the file; empty if they equal those of VTK.
  const Buffer<std::int32_t>& GetIds() const { return this->Ids; }

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
      TextRow row(text, line.End, '#');
      const TSurfLine what = ReadKeyword(row);
      if (what != TSurfLine::Other && !visit(what, row, text))
      {
        return text;
      }
      text = line.Next;
    }
    return nullptr;
  }

  /**
   * Calls @a visit(chunk), which returns an invalid line or nullptr, for all chunks in parallel.
   * For the first such line, calls @a explain(object, TSurfLine, TextRow&), which sets the error
   * with a row of the scanner. Returns false then, or if aborted.
   */
  template <typename Visit, typename Explain>
  bool ForEachChunk(const Progress& progress, Visit&& visit, Explain&& explain)
  {
    std::vector<const char*> wrong(this->Chunks.size(), nullptr);
    progress.For(this->GetNumberOfChunks(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          wrong[i] = visit(this->Chunks[i]);
        }
      });
    for (std::size_t i = 0; i < wrong.size() && !progress.IsStopped(); ++i)
    {
      if (wrong[i])
      {
        this->Scanner.SetPosition(wrong[i]);
        TextRow row(this->Scanner, RowLayout::OneLine);
        const TSurfLine what = ReadKeyword(row);
        explain(this->Chunks[i].Object, what, row);
        return false;
      }
    }
    return !progress.IsStopped();
  }

private:
  const char* ReadIds(Chunk& chunk) const;
  bool Sum();
  bool MapObject(std::size_t firstChunk, std::size_t endChunk, CellMesh& mesh);

  TextScanner& Scanner;
  const std::vector<TSurfObject>& Objects;
  std::vector<Chunk> Chunks;
  Buffer<std::int32_t> Ids;
  vtkIdType Repeated = 0; ///< vertices with the id of another one
  vtkIdType PropertyAtoms = 0;
};
}

#endif
