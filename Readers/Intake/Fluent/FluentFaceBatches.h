// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentFaceBatches
 * @brief Visits the faces of a Fluent file in the order of their ids, in batches.
 *
 * Faces in text that are not kept, and stored ones, are read from the file, at most one batch at a
 * time. Accessible faces are read in place, block by block. Only text with one face per line can be
 * visited; other layouts are left to FluentFaces.
 *
 * Cells are created from the data of their faces. Any thread may read a face; it sorts the data for
 * the two cells into shares, sets of cells. Each thread then processes one share, in the order of
 * the faces. So no two threads change the same cell.
 */
#ifndef camaron_FluentFaceBatches_h
#define camaron_FluentFaceBatches_h

#include "Base/Parallel.h"
#include "Intake/Fluent/FluentMesh.h"

#include <algorithm>  // for the ends of blocks
#include <array>      // for shares
#include <atomic>     // for errors of threads
#include <functional> // for visitors
#include <memory>     // for lines
#include <vector>     // for blocks

namespace camaron
{
class FluentFaceBatches
{
public:
  struct Face
  {
    const char* Nodes; ///< ids of the file, from 1; not checked if binary
    std::int32_t Size;
    std::int32_t Cells[2]; ///< of the piece, -1 for none
  };
  static constexpr vtkIdType BlockSize = FluentFaces::BlockSize;

  /**
   * @param nodes the greatest node id
   * @param chunk bytes of text per task
   */
  FluentFaceBatches(FluentFile& file, const FluentMesh& mesh, std::int64_t nodes, vtkIdType chunk)
    : File(file)
    , Mesh(mesh)
    , Nodes(nodes)
    , Chunk(chunk)
    , IsPlain(mesh.Piece.IsWhole() && !mesh.Cells.HasOtherCells())
  {
  }

  /// Consecutive faces of a run.
  class Batch
  {
  public:
    const FluentFaces::Run& GetRun() const { return *this->Of; }
    /// A node of a face.
    std::int32_t GetNode(const Face& face, std::int32_t i) const
    {
      return Load<std::int32_t>(face.Nodes + 4 * std::ptrdiff_t(i), this->Swap);
    }

  private:
    friend class FluentFaceBatches;
    const FluentFaces::Run* Of;
    vtkIdType Begin, End;
    const Face* Read; ///< for text
    bool Swap;
  };

  /// Number of shares of the cells, a power of two.
  static int GetNumberOfShares();

  /**
   * Visits all faces that bound cells. Calls look(run, faces, count) for blocks of faces in any
   * order, and make(batch, position, face, side, made) for each cell of each face, which fills a
   * Side that has a member Cell. Then it calls add(share, sides, count), with the sides of a cell
   * always in the same share, in the order of the faces. Several threads call these functions, but
   * each share is used by one thread at a time. False if add() returns false, if faces are invalid
   * or in another layout, or if aborted.
   */
  template <typename Side, typename Look, typename Make, typename Add>
  bool ForEachSide(const Progress& progress, Look&& look, Make&& make, Add&& add)
  {
    const vtkIdType shares = GetNumberOfShares();
    const vtkIdType limit = shares == 1 ? 1 : shares * BlocksPerShare;
    const vtkIdType small = this->Mesh.Piece.GetNumberOfCells() / CellsPerBlock;
    const vtkIdType blocks = std::max<vtkIdType>(1, std::min(limit, small));
    // The sides of every block, sorted by the shares of their cells, and the begins of shares.
    Buffer<Side> sides(blocks * SidesPerBlock);
    std::vector<Begins> begins(static_cast<std::size_t>(blocks));
    return this->ForEach(progress,
      [&](const Batch& batch)
      {
        std::atomic<bool> good{ true };
        for (vtkIdType first = batch.Begin; first < batch.End && good; first += blocks * BlockSize)
        {
          const vtkIdType last = std::min(first + blocks * BlockSize, batch.End);
          const vtkIdType count = (last - first + BlockSize - 1) / BlockSize;
          constexpr vtkIdType Grain = 8;
          ParallelFor(count, Grain,
            [&](vtkIdType from, vtkIdType to)
            {
              std::vector<Face> found(batch.Read ? 0 : static_cast<std::size_t>(BlockSize));
              for (vtkIdType block = from; block < to && good; ++block)
              {
                const vtkIdType begin = first + block * BlockSize;
                const vtkIdType end = std::min(begin + BlockSize, last);
                const Face* const faces =
                  batch.Read ? batch.Read + (begin - batch.Begin) : found.data();
                if (!batch.Read && !this->Find(*batch.Of, begin, end, found.data()))
                {
                  good = false;
                  break;
                }
                look(*batch.Of, faces, end - begin);
                begins[static_cast<std::size_t>(block)] = SortSides(faces, end - begin, shares,
                  [&](vtkIdType place, vtkIdType face, int side)
                  {
                    make(
                      batch, begin + face, faces[face], side, sides[block * SidesPerBlock + place]);
                  });
              }
            });
          ParallelFor(good ? shares : 0, 1,
            [&](vtkIdType from, vtkIdType to)
            {
              for (vtkIdType share = from; share < to; ++share)
              {
                for (vtkIdType block = 0; block < count && good; ++block)
                {
                  const Begins& places = begins[static_cast<std::size_t>(block)];
                  const auto place = places[static_cast<std::size_t>(share)];
                  const auto end = places[static_cast<std::size_t>(share) + 1];
                  if (!add(share, &sides[block * SidesPerBlock + place], vtkIdType(end) - place))
                  {
                    good = false;
                  }
                }
              }
            });
        }
        return good.load();
      });
  }

private:
  using Run = FluentFaces::Run;
  static constexpr int MaxShares = 8;
  static constexpr vtkIdType SidesPerBlock = 2 * BlockSize;
  /// Large enough that waiting for other threads costs little, and small enough for the processor's
  /// cache, and compared with the memory of the cells.
  static constexpr vtkIdType BlocksPerShare = 32, CellsPerBlock = 8 * BlockSize;
  using Begins = std::array<std::uint32_t, MaxShares + 1>;

  /// The share of a cell. Shares consist of many ranges of cells, so that all are used in every
  /// batch.
  static std::size_t GetShare(std::int32_t cell, vtkIdType shares)
  {
    constexpr int RangeBits = 9;
    return static_cast<std::size_t>(cell >> RangeBits & (shares - 1));
  }
  /// Calls put(place, face, side) for all sides with a cell, with positions sorted by share;
  /// returns the begins of shares.
  template <typename Put>
  static Begins SortSides(const Face* faces, vtkIdType count, vtkIdType shares, Put&& put)
  {
    Begins begins{}, places;
    for (vtkIdType i = 0; i < count && shares > 1; ++i)
    {
      for (const std::int32_t cell : faces[i].Cells)
      {
        begins[GetShare(std::max(cell, 0), shares) + 1] += cell >= 0;
      }
    }
    for (std::size_t share = 1; share <= MaxShares; ++share)
    {
      begins[share] += begins[share - 1];
    }
    places = begins;
    for (vtkIdType i = 0; i < count; ++i)
    {
      for (int side = 0; side < 2; ++side)
      {
        if (faces[i].Cells[side] >= 0)
        {
          put(places[GetShare(faces[i].Cells[side], shares)]++, i, side);
        }
      }
    }
    begins[1] = shares > 1 ? begins[1] : places[0];
    return begins;
  }

  /// Calls visit(batch) for all faces that bound cells, until it returns false. False if it did, if
  /// faces are invalid or in another layout, or if aborted.
  bool ForEach(const Progress& progress, const std::function<bool(const Batch&)>& visit);
  bool ReadText(const TextLines& lines, const Run& run, const char*& place, vtkIdType count);
  bool ReadLine(const Run& run, const char* text, const char* end, Face& face, char* nodes) const;
  bool AreNodesGood(const Face& face, bool swap) const;
  bool SetCells(const std::int64_t* cells, Face& face) const;
  bool Find(const Run& run, vtkIdType begin, vtkIdType end, Face* faces) const;
  template <int Size>
  bool FindPlain(const Run& run, vtkIdType begin, vtkIdType end, Face* faces) const;

  FluentFile& File;
  const FluentMesh& Mesh;
  std::int64_t Nodes;
  vtkIdType Chunk;
  bool IsPlain;                                  ///< whether cells are numbered as in the file
  std::vector<std::unique_ptr<TextLines>> Lines; ///< of every run, if it is text
  Buffer<Face> Faces;                            ///< of text
  Buffer<std::int32_t> Words;                    ///< their nodes
  Run Stored;                                    ///< loaded faces of a stored run
};
}

#endif
