// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentFaces
 * @brief All faces of a Fluent file: their nodes, and the cells on both sides.
 *
 * Faces are loaded and checked batch by batch, whenever they are visited. They are numbered by
 * position, in the order of their ids.
 */
#ifndef camaron_FluentFaces_h
#define camaron_FluentFaces_h

#include "Base/Buffer.h"
#include "Base/FunctionRef.h"
#include "Intake/Fluent/FluentFile.h"
#include "Intake/Fluent/FluentNumbers.h"

#include <algorithm> // for shares
#include <atomic>    // for errors
#include <string>    // for names of types
#include <vector>    // for runs

namespace camaron
{
/// A face in memory. Nodes and cells are ids of the file: from 1, with 0 for no cell.
struct FluentFace
{
  const Unaligned<std::int32_t>* Nodes; ///< and the cells behind them
  std::int32_t Size;                    ///< number of nodes
  std::int32_t GetCell(int side) const { return this->Nodes[std::ptrdiff_t(this->Size) + side]; }
};

/// Boundary types in the headers of face sections.
struct FluentBoundary
{
  static constexpr int Interior = 2, Wall = 3, Parent = 31, Nonconformal = 1000;
};

///@{
/// Name of a boundary type, the usual one of several, or empty; and the type of a name, or 0.
std::string GetFluentBoundaryName(int type);
int GetFluentBoundaryType(const std::string& name);
/// What is shown as the type of a zone of faces whose type has no name in the file.
std::string GetFluentZoneType(int boundaryType);
///@}

class FluentFaces
{
public:
  using Word = Unaligned<std::int32_t>;

  /// The faces of one zone, or of one section of it, or a batch of these.
  struct Run
  {
    vtkIdType Begin = 0, End = 0; ///< positions
    std::int64_t FirstId = 0;
    int Zone = 0;
    int BoundaryType = 0;
    std::int32_t Size = 0; ///< number of nodes of every face, 0 if each states its own
    bool Bounds = true;    ///< whether the faces bound cells of the mesh
    const FluentSection* Section = nullptr;
    ///@{
    /// Of a batch: the words as in a binary file, begins of every 1024th face if sizes differ, and
    /// whether some id is out of range.
    const Word* Words = nullptr;
    std::vector<const Word*> Blocks;
    const FluentFaces* Of = nullptr;
    std::atomic<bool>* HasBadIds = nullptr;
    ///@}

    bool IsOfBoundary() const
    {
      return this->BoundaryType != FluentBoundary::Interior &&
        this->BoundaryType != FluentBoundary::Parent;
    }
    /// Whether a face has the same cell on both sides, or as an interior one a cell on one side
    /// only.
    bool HasOddCells(std::int32_t first, std::int32_t second) const
    {
      return this->Bounds &&
        (first == second
            ? first != 0
            : this->BoundaryType == FluentBoundary::Interior && (first == 0 || second == 0));
    }
  };
  static constexpr vtkIdType BlockSize = FluentFile::BlockSize; ///< faces per block of a run

  /// Reads the headers of the face sections of a file, which must stay alive; false with the error
  /// in it. @a nodes is the greatest node id.
  bool Open(FluentFile& file, std::int64_t nodes);
  void SetNumberOfCells(std::int64_t cells) { this->Cells = static_cast<std::uint32_t>(cells); }

  vtkIdType GetCount() const { return this->Runs.empty() ? 0 : this->Runs.back().End; }
  const std::vector<Run>& GetRuns() const { return this->Runs; }
  /// Position of the face with an id, or -1.
  vtkIdType FindId(std::int64_t id) const;

  ///@{
  /**
   * Calls visit(batch, progress) for consecutive faces of one run, until it returns false. False if
   * it did, with the error in the file, or if aborted.
   * @param inOrder whether the order matters; otherwise processes share the work of loading
   */
  using VisitBatch = FunctionRef<bool(const Run& batch, const Progress& progress)>;
  bool ForEachBatch(const Progress& progress, bool inOrder, VisitBatch visit) const;
  bool ForBatchesOf(const Run& run, bool inOrder, const Progress& progress, VisitBatch visit) const;
  ///@}

  /// Calls visit(run, position, face) for all faces in parallel, ascending in each thread; false
  /// with the error in the file, or if aborted.
  template <typename Visit>
  bool ForEach(const Progress& progress, Visit&& visit) const
  {
    return this->ForEachBatch(progress, false,
      [&](const Run& batch, const Progress& part)
      {
        return part.ForBlocks(batch.End - batch.Begin, BlockSize,
          [&](vtkIdType first, vtkIdType last)
          {
            ForEachOf(batch, batch.Begin + first, batch.Begin + last,
              [&](vtkIdType face, const FluentFace& record) { visit(batch, face, record); });
          });
      });
  }
  /// Calls visit(position, face) for faces of a batch from @a begin on, which must begin a block.
  /// Faces with ids out of range are left out; then loading fails after the batch.
  template <typename Visit>
  static void ForEachOf(const Run& run, vtkIdType begin, vtkIdType end, Visit&& visit)
  {
    const Word* word = run.Size > 0
      ? run.Words + (begin - run.Begin) * (run.Size + 2)
      : run.Blocks[static_cast<std::size_t>((begin - run.Begin) / BlockSize)];
    const auto forEach = [&](auto common) // a size that the compiler knows is faster
    {
      for (vtkIdType face = begin; face < end; ++face)
      {
        const std::int32_t size = common > 0 ? common
          : run.Size > 0                     ? run.Size
                                             : std::int32_t(*word++);
        const FluentFace record{ word, size };
        if (run.Of->HasGoodIds(record))
        {
          visit(face, record);
        }
        else
        {
          run.HasBadIds->store(true, std::memory_order_relaxed);
        }
        word += std::ptrdiff_t(size) + 2;
      }
    };
    run.Size == 3     ? forEach(std::integral_constant<std::int32_t, 3>())
      : run.Size == 4 ? forEach(std::integral_constant<std::int32_t, 4>())
                      : forEach(std::integral_constant<std::int32_t, 0>());
  }

private:
  Progress GetPart(const Progress& progress, const Run& run) const
  {
    const auto count = static_cast<double>(std::max<vtkIdType>(this->GetCount(), 1));
    return progress.Part(
      static_cast<double>(run.Begin) / count, static_cast<double>(run.End) / count);
  }
  bool CheckSection(const FluentSection& section, std::int64_t lastId);
  void LeaveOutInterfaces();
  bool IsId(std::int32_t value, bool isNode) const
  {
    const auto id = static_cast<std::uint32_t>(value);
    return isNode ? id - 1 < this->Nodes : id <= this->Cells;
  }
  bool HasGoodIds(const FluentFace& face) const
  {
    bool good = this->IsId(face.GetCell(0), false) && this->IsId(face.GetCell(1), false);
    for (std::int32_t i = 0; i < face.Size; ++i)
    {
      good &= this->IsId(face.Nodes[i], true);
    }
    return good;
  }
  void FailAtBadId(const Run& batch, const FluentNumbers<std::int32_t>& numbers) const;
  bool ForBatchesInFile(const Run& run, FunctionRef<bool(const Run&)> visit) const;
  void FailInFace(const FluentNumbers<std::int32_t>& numbers, const Run& batch) const;
  static std::int64_t SetWords(const Word* words, std::int64_t size, Run& batch);

  FluentFile* File = nullptr;
  std::uint32_t Nodes = 0, Cells = 0; ///< greatest ids
  std::vector<Run> Runs;
};
}

#endif
