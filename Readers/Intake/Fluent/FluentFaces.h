// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentFaces
 * @brief All faces of a Fluent file: their nodes, and the cells on both sides.
 *
 * Binary faces are read in place; those in text are stored, if necessary, in the form of a binary
 * file. Faces are numbered by position, in the order of their ids.
 *
 * @sa FluentFaceBatches, which visits all faces without keeping them
 */
#ifndef camaron_FluentFaces_h
#define camaron_FluentFaces_h

#include "Base/Buffer.h"
#include "Base/FunctionRef.h"
#include "Intake/Fluent/ConsecutiveRanges.h"
#include "Intake/Fluent/FluentFile.h"
#include "Intake/Ids/IdSet.h"
#include "Intake/Rows/Bytes.h"
#include "Intake/Rows/IdLists.h"

#include <algorithm> // for the ends of batches
#include <memory>    // for lines
#include <string>    // for names of types
#include <vector>    // for runs

namespace camaron
{
/// A face, read in place. Nodes and cells are ids of the file: from 1, with 0 for no cell.
struct FluentFace
{
  IdList Nodes;
  std::int32_t GetCell(int side) const { return this->Nodes[this->Nodes.Size + side]; }
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
///@}

class FluentFaces
{
public:
  /// The faces of one zone, or of one section of it.
  struct Run
  {
    vtkIdType Begin = 0, End = 0; ///< positions
    std::int64_t FirstId = 0;
    int Zone = 0;
    int BoundaryType = 0;
    std::int32_t Size = 0; ///< number of nodes of every face, 0 if each states its own
    bool Bounds = true;    ///< whether the faces bound cells of the mesh
    const FluentSection* Section = nullptr;
    const char* Data = nullptr; ///< if accessible
    const char* DataEnd = nullptr;
    bool Swap = false;
    std::vector<const char*> Blocks;  ///< begins of every 1024th face, if sizes differ
    Buffer<std::int32_t> Words;       ///< of text
    std::unique_ptr<FluentRows> Rows; ///< of text that is read whenever it is visited
    FluentFile* Source = nullptr;     ///< of stored faces that are loaded whenever they are visited

    bool IsOfBoundary() const
    {
      return this->BoundaryType != FluentBoundary::Interior &&
        this->BoundaryType != FluentBoundary::Parent;
    }
  };

  /// Reads the headers of the face sections of a file, which must stay alive; false with the error
  /// in it.
  bool Open(FluentFile& file);

  /// Makes all faces accessible, or only those of boundaries, for ForEachOf. False with the error
  /// in the file, or if aborted.
  bool Keep(FluentFile& file, bool boundariesOnly, vtkIdType chunk, const Progress& progress);
  /**
   * Prepares text with one face per line, and stored faces, to be visited by ForEach without being
   * kept. ForEach then fails, for text without an error, if a node or cell id is out of range.
   * False for other layouts, or if aborted.
   */
  bool Stream(FluentFile& file, std::int64_t nodes, std::int64_t cells, vtkIdType chunk,
    const Progress& progress);
  void StopStreaming();
  /// Releases the memory of all faces except those of boundaries.
  void KeepBoundariesOnly();

  /// Checks all node ids (1 to @a nodes) and cell ids (0 to @a cells); false with the error in the
  /// file.
  bool Check(
    FluentFile& file, std::int64_t nodes, std::int64_t cells, const Progress& progress) const;

  vtkIdType GetCount() const { return this->Runs.empty() ? 0 : this->Runs.back().End; }
  const std::vector<Run>& GetRuns() const { return this->Runs; }
  const Run& GetRun(vtkIdType face) const { return this->Runs[this->Finder.Find(face)]; }
  /// Position of the face with an id, or -1.
  vtkIdType FindId(std::int64_t id) const;

  /// Calls visit(run, position, face) for all faces in parallel, ascending in each thread.
  template <typename Visit>
  bool ForEach(const Progress& progress, Visit&& visit) const
  {
    bool good = progress.For(static_cast<vtkIdType>(this->Parts.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          const Part& part = this->Parts[i];
          const Run& run = this->Runs[part.Run];
          if (run.Data)
          {
            ForEachOf(run, part.Begin, part.End,
              [&](vtkIdType face, const FluentFace& record) { visit(run, face, record); });
          }
        }
      });
    for (const Run& run : this->Runs)
    {
      const auto visitOf = [&](vtkIdType face, const FluentFace& record)
      { visit(run, face, record); };
      good = good && (!run.Rows || this->ForEachLineOf(run, progress, visitOf)) &&
        (!run.Source || run.Data || this->ForEachStored(run, progress, visitOf));
    }
    return good;
  }
  /// Sets @a part to faces of a stored run from @a begin on; false with the error in the file.
  static bool Load(FluentFile& file, const Run& run, vtkIdType begin, vtkIdType end, Run& part);
  /// Calls visit(position, face) for faces of a run from @a begin on, which must begin a block.
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
      place += (run.Size > 0 ? 0 : 4) + GetStride(record.Nodes.Size);
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
    if (run.Size > 0)
    {
      return { { place, run.Size, run.Swap } };
    }
    // The face fits, unless another program has changed the file.
    const std::ptrdiff_t room = (run.DataEnd - place) / 4 - 3;
    if (room < 0)
    {
      static constexpr std::int32_t NoCells[2] = { 0, 0 };
      return { { reinterpret_cast<const char*>(NoCells), 0, 0 } };
    }
    const auto size = camaron::Load<std::int32_t>(place, run.Swap);
    return { { place + 4, size >= 0 && size <= room ? size : 0, run.Swap } };
  }

  /// Calls visit(position, face) for the faces of a run in text.
  template <typename Visit>
  bool ForEachLineOf(const Run& run, const Progress& progress, Visit&& visit) const
  {
    std::vector<std::vector<std::int32_t>> words(
      static_cast<std::size_t>(run.Rows->Lines.GetNumberOfPieces(run.Rows->Records)));
    return run.Rows->Lines.ForEach(run.Rows->Records, progress,
      [&](vtkIdType piece, vtkIdType line, const char* text, const char* end)
      {
        std::vector<std::int32_t>& numbers = words[static_cast<std::size_t>(piece)];
        const bool good = this->ReadLine(run, text, end, numbers);
        if (good)
        {
          visit(run.Begin + line,
            FluentFace{ { reinterpret_cast<const char*>(numbers.data()),
              static_cast<std::int32_t>(numbers.size()) - 2, 0 } });
        }
        return good;
      });
  }
  /// The same for the faces of a stored run.
  template <typename Visit>
  bool ForEachStored(const Run& run, const Progress& progress, Visit&& visit) const
  {
    const Progress own = progress.Part(this->GetShare(run.Begin), this->GetShare(run.End));
    const auto count = static_cast<double>(run.End - run.Begin);
    vtkIdType done = 0;
    return this->ForEachPart(run,
      [&](const Run& part)
      {
        const vtkIdType before = done, size = part.End - part.Begin;
        done += size;
        const auto from = static_cast<double>(before), to = static_cast<double>(done);
        return own.Part(from / count, to / count)
          .ForBlocks(size, BlockSize, [&](vtkIdType first, vtkIdType last)
            { ForEachOf(part, part.Begin + first, part.Begin + last, visit); });
      });
  }
  /// Calls visit(part) for parts of a stored run, which this process loads or gets from others.
  bool ForEachPart(const Run& run, FunctionRef<bool(const Run&)> visit) const;
  double GetShare(vtkIdType position) const
  {
    return static_cast<double>(position) / static_cast<double>(this->GetCount());
  }
  bool ReadLine(
    const Run& run, const char* text, const char* end, std::vector<std::int32_t>& numbers) const;

  const char* FindInFile(const Run& run, const char* word) const;
  bool AddRuns(FluentFile& file);
  bool CheckSize(FluentFile& file, const Run& run) const;
  bool ReadText(FluentFile& file, Run& run, vtkIdType chunk, const Progress& progress);
  static bool SetWords(const std::int32_t* words, vtkIdType size, Run& run);
  bool ReadLines(const FluentFile& file, Run& run, vtkIdType chunk, const Progress& progress);
  bool ReadWords(FluentFile& file, Run& run);
  static bool FindBlocks(Run& run);
  void LeaveOutInterfaces(FluentFile& file);

  std::vector<Run> Runs;
  ConsecutiveRanges Finder;
  std::int64_t Nodes = 0, Cells = 0; ///< greatest ids, for text that is not stored
  std::vector<Part> Parts;
};
}

#endif
