// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentFaceBatches
 * @brief Visits the faces of a Fluent file in the order of their ids, some at a time.
 *
 * Faces of text that are not kept are read from the file, so that there is never more of them in
 * memory than one batch. Faces that are accessible are taken from where they are, block by block.
 * Only text with one face per line can be visited; what else there is, is left to FluentFaces.
 *
 * Cells are made of what their faces say. Every face is looked at once, by any thread, which puts
 * what it says of its two cells into shares of cells; then each thread takes what is in its share,
 * in the order of the faces. So no two threads change the same cell.
 */
#ifndef camaron_FluentFaceBatches_h
#define camaron_FluentFaceBatches_h

#include "FluentCellFaces.h"

#include <algorithm>  // for the ends of blocks
#include <array>      // for shares
#include <atomic>     // for what threads say
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
    const char* Nodes; ///< ids of the file, from 1; not checked if they are binary
    std::int32_t Size;
    std::int32_t Cells[2]; ///< of the piece, -1 for none
  };
  /// What a visitor wants to know of faces.
  enum class Want
  {
    Cells, ///< and sizes
    All
  };
  static constexpr vtkIdType BlockSize = FluentFaces::BlockSize;

  /**
   * @param nodes the largest id of a node
   * @param chunk bytes of text that are read as one piece
   */
  FluentFaceBatches(
    const FluentFile& file, const FluentMesh& mesh, std::int64_t nodes, vtkIdType chunk)
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
    const Face* Read; ///< if they were text
    bool Swap;
  };

  /// In how many shares cells are made, a power of two.
  static int GetNumberOfShares();

  /**
   * Calls for all faces that bound cells look(run, faces, count), for some faces at a time, in any
   * order, and has a Side, with a member Cell, made of each face for each of its cells by
   * make(batch, position, face, side, made). Then it calls add(share, sides, count), with the sides
   * of a cell always in the same share, and in the order of the faces. All are called by several
   * threads, but for one share by one at a time. False if add() is, if some faces are wrong or laid
   * out otherwise, or if stopped.
   */
  template <typename Side, typename Look, typename Make, typename Add>
  bool ForEachSide(Want want, const Progress& progress, Look&& look, Make&& make, Add&& add)
  {
    const vtkIdType shares = GetNumberOfShares();
    const vtkIdType limit = shares == 1 ? 1 : shares * BlocksPerShare;
    const vtkIdType small = this->Mesh.Piece.GetNumberOfCells() / CellsPerBlock;
    const vtkIdType blocks = std::max<vtkIdType>(1, std::min(limit, small));
    // The sides of every block, sorted by the share of their cells, and where shares begin.
    Buffer<Side> sides(blocks * SidesPerBlock);
    std::vector<Begins> begins(static_cast<std::size_t>(blocks));
    return this->ForEach(want, progress,
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
  /// So many at once that waiting for other threads costs little, but few enough for the cache of
  /// the processor, and a small part of the memory of the cells.
  static constexpr vtkIdType BlocksPerShare = 32, CellsPerBlock = 8 * BlockSize;
  using Begins = std::array<std::uint32_t, MaxShares + 1>;

  /// Which share a cell is of. Shares are many ranges of cells, so that all have some in every
  /// batch.
  static std::size_t GetShare(std::int32_t cell, vtkIdType shares)
  {
    constexpr int RangeBits = 9;
    return static_cast<std::size_t>(cell >> RangeBits & (shares - 1));
  }
  /// Calls put(place, face, side) for all sides with a cell, places being sorted by shares; returns
  /// where shares begin.
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
  /// some faces are wrong or laid out otherwise, or if stopped.
  bool ForEach(Want want, const Progress& progress, const std::function<bool(const Batch&)>& visit);
  bool ReadText(
    Want want, const TextLines& lines, const Run& run, const char*& place, vtkIdType count);
  bool ReadLine(const Run& run, const char* text, const char* end, Face& face, char* nodes) const;
  bool SkimLine(const Run& run, const char* text, const char* end, Face& face) const;
  bool AreNodesGood(const Face& face, bool swap) const;
  bool SetCells(const std::int64_t* cells, Face& face) const;
  bool Find(const Run& run, vtkIdType begin, vtkIdType end, Face* faces) const;
  template <int Size>
  bool FindPlain(const Run& run, vtkIdType begin, vtkIdType end, Face* faces) const;

  const FluentFile& File;
  const FluentMesh& Mesh;
  std::int64_t Nodes;
  vtkIdType Chunk;
  bool IsPlain;                                  ///< whether cells are numbered as in the file
  std::vector<std::unique_ptr<TextLines>> Lines; ///< of every run, if it is text
  Buffer<Face> Faces;                            ///< of text
  Buffer<std::int32_t> Words;                    ///< their nodes
};
}

#endif
