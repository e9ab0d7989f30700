// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Selection/KindChange.h"

#include "Base/Hash.h"
#include "Base/Parallel.h"

#include <algorithm>
#include <numeric>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Hashes of the cells of one dimension, except duplicates; zero for other cells.
std::vector<SetHash> HashCells(const LinkedPiece& piece, int dimension)
{
  const MeshView& mesh = piece.Topology->GetMesh();
  const CellElements corners(*piece.Topology, Adjacency::Vertex);
  std::vector<SetHash> hashes(mesh.GetNumberOfCells());
  ParallelForEach(mesh.GetNumberOfCells(), MediumGrain,
    [&](vtkIdType cell)
    {
      if (!piece.IsCopy(cell) && GetCellShape(mesh.GetCellType(cell)).Dimension == dimension)
      {
        corners.ForEach(cell, [&](vtkIdType point) { hashes[cell].Add(Mix(point)); });
      }
    });
  return hashes;
}

//------------------------------------------------------------------------------
/// Finds cells by their points.
class CellFinder
{
public:
  /// @param next receives for each cell the next one with the same points, or -1
  CellFinder(const std::vector<SetHash>& hashes, std::vector<vtkIdType>& next)
    : Hashes(hashes)
  {
    std::size_t size = 16;
    while (size < 2 * hashes.size())
    {
      size *= 2;
    }
    this->Slots.resize(size, -1);
    for (std::size_t cell = 0; cell < hashes.size(); ++cell)
    {
      if (!(hashes[cell] == SetHash()))
      {
        vtkIdType& slot = this->Slots[this->FindSlot(hashes[cell])];
        next[cell] = slot;
        slot = static_cast<vtkIdType>(cell);
      }
    }
  }

  /// The last one, or -1.
  vtkIdType Find(const SetHash& hash) const { return this->Slots[this->FindSlot(hash)]; }

private:
  std::size_t FindSlot(const SetHash& hash) const
  {
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t slot = hash.Low & mask;
    while (this->Slots[slot] >= 0 && !(this->Hashes[this->Slots[slot]] == hash))
    {
      slot = (slot + 1) & mask;
    }
    return slot;
  }

  const std::vector<SetHash>& Hashes;
  std::vector<vtkIdType> Slots; // a power of two of them
};

//------------------------------------------------------------------------------
Adjacency GetAdjacency(int dimension)
{
  return dimension == 2 ? Adjacency::Facet : dimension == 1 ? Adjacency::Edge : Adjacency::Vertex;
}

//------------------------------------------------------------------------------
bool Holds(Quantifier quantifier, bool hasSelected, bool hasOther)
{
  return hasSelected && (quantifier == Quantifier::Any || !hasOther);
}
}

//------------------------------------------------------------------------------
KindChange::KindChange(
  const std::vector<LinkedPiece>& pieces, const BoundingElements& bounding, Reducer& reducer)
  : Pieces(pieces)
  , Bounding(bounding)
  , Elements(MakeElements(pieces, GetAdjacency(bounding.Dimension)))
  , Shared(pieces, this->Elements, reducer)
{
  for (std::size_t piece = 0; piece < pieces.size() && bounding.Pieces; ++piece)
  {
    this->FindBounding(piece);
  }
}

//------------------------------------------------------------------------------
// Hashes of the elements of relevant cells; zero for others.
std::vector<SetHash> KindChange::HashElements(std::size_t piece) const
{
  std::vector<SetHash> hashes(this->Elements[piece].GetSize());
  CellFacets facets(this->Pieces[piece].Topology->GetMesh());
  for (vtkIdType cell = 0; cell < this->Pieces[piece].Topology->GetMesh().GetNumberOfCells();
    ++cell)
  {
    if (this->TakesPart(piece, cell))
    {
      this->Elements[piece].ForEach(cell, facets,
        [&](vtkIdType element, const vtkIdType* points, vtkIdType size)
        {
          if (hashes[element] == SetHash())
          {
            std::for_each(
              points, points + size, [&](vtkIdType point) { hashes[element].Add(Mix(point)); });
          }
        });
    }
  }
  return hashes;
}

//------------------------------------------------------------------------------
void KindChange::FindBounding(std::size_t piece)
{
  const std::vector<SetHash> elements = this->HashElements(piece);
  const std::vector<SetHash> cells =
    HashCells((*this->Bounding.Pieces)[piece], this->Bounding.Dimension);
  this->First.emplace_back(elements.size(), -1);
  this->Next.emplace_back(cells.size(), -1);
  // The faces and edges of Mesh Elements are in the order of the elements if there are no
  // duplicates.
  if (elements == cells)
  {
    std::iota(this->First[piece].begin(), this->First[piece].end(), 0);
    return;
  }
  const CellFinder finder(cells, this->Next[piece]);
  ParallelForEach(static_cast<vtkIdType>(elements.size()), MediumGrain,
    [&](vtkIdType element)
    {
      if (!(elements[element] == SetHash()))
      {
        this->First[piece][element] = finder.Find(elements[element]);
      }
    });
}

//------------------------------------------------------------------------------
bool KindChange::TakesPart(std::size_t piece, vtkIdType cell) const
{
  const unsigned char type = this->Pieces[piece].Topology->GetMesh().GetCellType(cell);
  const int dimension = GetCellShape(type).Dimension;
  return !this->Pieces[piece].IsCopy(cell) &&
    (dimension > this->Bounding.Dimension || (dimension == 0 && !this->Bounding.Pieces));
}

//------------------------------------------------------------------------------
KindChange::Flags KindChange::MakeFlags() const
{
  Flags flags;
  for (const CellElements& elements : this->Elements)
  {
    flags.emplace_back(elements.GetSize());
  }
  return flags;
}

//------------------------------------------------------------------------------
// Calls visit(id) for the bounding elements with the points of an element.
template <typename Visit>
void KindChange::ForEachBounding(std::size_t piece, vtkIdType element, Visit&& visit) const
{
  if (!this->Bounding.Pieces)
  {
    visit(element);
    return;
  }
  for (vtkIdType id = this->First[piece][element]; id >= 0; id = this->Next[piece][id])
  {
    visit(id);
  }
}

//------------------------------------------------------------------------------
CellMarks KindChange::MarkCells(const CellMarks& marks, Quantifier quantifier)
{
  Flags hasSelected = this->MakeFlags(), hasOther = this->MakeFlags();
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    ParallelForEach(this->Elements[piece].GetSize(), MediumGrain,
      [&](vtkIdType element)
      {
        this->ForEachBounding(piece, element,
          [&](vtkIdType id) { (marks[piece][id] ? hasSelected : hasOther)[piece][element] = 1; });
      });
  }
  this->Shared.Share(hasSelected);
  this->Shared.Share(hasOther);
  CellMarks cells;
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    cells.emplace_back(this->Pieces[piece].Topology->GetMesh().GetNumberOfCells());
    ParallelForEach(static_cast<vtkIdType>(cells[piece].size()), MediumGrain,
      [&](vtkIdType cell)
      {
        bool isAny = false, isNotAll = false;
        if (this->TakesPart(piece, cell))
        {
          this->Elements[piece].ForEach(cell,
            [&](vtkIdType element)
            {
              // A shared point is the same in all pieces, whichever is marked.
              const bool isSelected = hasSelected[piece][element] != 0;
              isAny |= isSelected;
              isNotAll |= hasOther[piece][element] && (this->Bounding.Pieces || !isSelected);
            });
        }
        cells[piece][cell] = Holds(quantifier, isAny, isNotAll);
      });
  }
  return cells;
}

//------------------------------------------------------------------------------
CellMarks KindChange::MarkBounding(const CellMarks& marks, Quantifier quantifier)
{
  Flags hasSelected = this->MakeFlags(), hasOther = this->MakeFlags();
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    ParallelForEach(static_cast<vtkIdType>(marks[piece].size()), MediumGrain,
      [&](vtkIdType cell)
      {
        if (this->TakesPart(piece, cell))
        {
          Flags& flags = marks[piece][cell] ? hasSelected : hasOther;
          this->Elements[piece].ForEach(cell,
            [&](vtkIdType element) { flags[piece][element].store(1, std::memory_order_relaxed); });
        }
      });
  }
  this->Shared.Share(hasSelected);
  this->Shared.Share(hasOther);
  CellMarks bounding;
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    const vtkIdType size = this->Elements[piece].GetSize();
    bounding.emplace_back(
      this->Bounding.Pieces ? static_cast<vtkIdType>(this->Next[piece].size()) : size);
    ParallelForEach(size, MediumGrain,
      [&](vtkIdType element)
      {
        const bool holds =
          Holds(quantifier, hasSelected[piece][element] != 0, hasOther[piece][element] != 0);
        this->ForEachBounding(piece, element, [&](vtkIdType id) { bounding[piece][id] = holds; });
      });
  }
  return bounding;
}
}
