// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentFaces
 * @brief All faces of a Fluent file: their nodes, and the cells on both sides.
 *
 * Binary faces stay where they are in the file; those of text are kept, where they have to be, as a
 * binary file would have them. Faces are numbered by position, in the order of their ids.
 *
 * @sa FluentFaceBatches, which visits all faces without keeping them
 */
#ifndef camaron_FluentFaces_h
#define camaron_FluentFaces_h

#include "FluentFile.h"
#include "FluentRuns.h"
#include "Scan/Buffer.h"
#include "Scan/Bytes.h"
#include "Scan/IdLists.h"
#include "Scan/TextLines.h"

#include <vector> // for runs

namespace camaron
{
/// A face in place. Nodes and cells are ids of the file: from 1, and 0 for no cell.
struct FluentFace
{
  IdList Nodes;
  std::int32_t GetCell(int side) const { return this->Nodes[this->Nodes.Size + side]; }
};

/// What the zone type in the header of a face section means.
struct FluentBoundary
{
  static constexpr int Interior = 2, Wall = 3, Parent = 31, Nonconformal = 1000;
};

class FluentFaces
{
public:
  /// Faces of one zone, or what one section has of it.
  struct Run
  {
    vtkIdType Begin = 0, End = 0; ///< positions
    std::int64_t FirstId = 0;
    int Zone = 0;
    int BoundaryType = 0;
    std::int32_t Size = 0; ///< nodes of every face, 0 if they say so themselves
    bool Bounds = true;    ///< whether these are faces of cells of the mesh
    const FluentSection* Section = nullptr;
    const char* Data = nullptr; ///< if accessible
    bool Swap = false;
    std::vector<const char*> Blocks; ///< where every 1024th begins if they are of any size
    Buffer<std::uint32_t> Starts;    ///< of each of these, words from the start of its block
    Buffer<std::int32_t> Words;      ///< of text

    bool IsOfBoundary() const
    {
      return this->BoundaryType != FluentBoundary::Interior &&
        this->BoundaryType != FluentBoundary::Parent;
    }
  };

  /// Takes what the headers say of the faces of a file, which must stay alive; false with the error
  /// in it.
  bool Open(FluentFile& file);

  ///@{
  /**
   * Make faces accessible: all of them, or those of boundaries, for ForEachOf only. False with the
   * error in the file, or if stopped.
   */
  bool KeepAll(FluentFile& file, vtkIdType chunk, const Progress& progress);
  bool KeepBoundaries(FluentFile& file, vtkIdType chunk, const Progress& progress);
  ///@}
  /// Gives the memory of all faces but those of boundaries back.
  void KeepBoundariesOnly();

  /// Checks all ids of nodes (1 to @a nodes) and cells (0 to @a cells); false with the error in the
  /// file.
  bool Check(
    FluentFile& file, std::int64_t nodes, std::int64_t cells, const Progress& progress) const;

  vtkIdType GetCount() const { return this->Runs.empty() ? 0 : this->Runs.back().End; }
  const std::vector<Run>& GetRuns() const { return this->Runs; }
  const Run& GetRun(vtkIdType face) const { return this->Runs[this->Finder.Find(face)]; }
  /// Position of the face of an id, or -1.
  vtkIdType FindId(std::int64_t id) const;

  FluentFace operator[](vtkIdType face) const { return At(this->GetRun(face), face); }
  /// Announces that a face will be read soon.
  void Prefetch(vtkIdType face) const { camaron::Prefetch(GetPlace(this->GetRun(face), face)); }

  /// Calls visit(run, position, face) for all faces in parallel; one thread visits ascending ones.
  template <typename Visit>
  bool ForEach(const Progress& progress, Visit&& visit) const
  {
    return progress.For(static_cast<vtkIdType>(this->Parts.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          const Part& part = this->Parts[i];
          const Run& run = this->Runs[part.Run];
          ForEachOf(run, part.Begin, part.End,
            [&](vtkIdType face, const FluentFace& record) { visit(run, face, record); });
        }
      });
  }
  /// Calls visit(position, face) for faces of a run from @a begin, which is the first of a block.
  template <typename Visit>
  static void ForEachOf(const Run& run, vtkIdType begin, vtkIdType end, Visit&& visit)
  {
    const char* place = run.Size > 0
      ? run.Data + (begin - run.Begin) * GetStride(run.Size)
      : run.Blocks[static_cast<std::size_t>((begin - run.Begin) / BlockSize)];
    for (vtkIdType face = begin; face < end; ++face)
    {
      const FluentFace record = Read(run, place);
      visit(face, record);
      place = record.Nodes.Ids + GetStride(record.Nodes.Size);
    }
  }

  static constexpr vtkIdType BlockSize = FluentFile::BlockSize; ///< faces per block of a run

private:
  struct Part
  {
    std::uint32_t Run;
    vtkIdType Begin, End;
  };

  static std::ptrdiff_t GetStride(std::int32_t size) { return 4 * (std::ptrdiff_t(size) + 2); }
  static FluentFace Read(const Run& run, const char* place)
  {
    return run.Size > 0
      ? FluentFace{ { place, run.Size, run.Swap } }
      : FluentFace{ { place + 4, camaron::Load<std::int32_t>(place, run.Swap), run.Swap } };
  }
  static const char* GetPlace(const Run& run, vtkIdType face)
  {
    const vtkIdType i = face - run.Begin;
    return run.Size > 0
      ? run.Data + i * GetStride(run.Size)
      : run.Blocks[static_cast<std::size_t>(i / BlockSize)] + 4 * std::ptrdiff_t(run.Starts[i]);
  }
  static FluentFace At(const Run& run, vtkIdType face) { return Read(run, GetPlace(run, face)); }

  const char* FindInFile(const Run& run, const char* word) const;
  bool AddRuns(FluentFile& file);
  bool CheckSize(FluentFile& file, const Run& run) const;
  template <typename IsWanted>
  bool Keep(FluentFile& file, vtkIdType chunk, const Progress& progress, IsWanted&& isWanted);
  bool ReadText(FluentFile& file, Run& run, vtkIdType chunk, const Progress& progress);
  bool ReadLines(const FluentFile& file, Run& run, vtkIdType chunk, const Progress& progress);
  bool ReadWords(FluentFile& file, Run& run);
  void FindBlocks(Run& run);
  void FindStarts(Run& run, const Progress& progress);
  void LeaveOutInterfaces(FluentFile& file);

  std::vector<Run> Runs;
  FluentRuns Finder;
  std::vector<Part> Parts;
};
}

#endif
