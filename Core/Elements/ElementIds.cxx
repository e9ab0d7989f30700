// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/ElementIds.h"

#include "Ranks/KeyRanks.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// A key and its block as one number; keeps the order.
class KeyPacker
{
public:
  /// Collective.
  KeyPacker(const std::vector<KeyedElements>& pieces, Reducer& reducer)
  {
    std::int64_t limits[] = { 1, 1, 1 }, hasNegative = 0;
    for (const KeyedElements& piece : pieces)
    {
      limits[0] = std::max<std::int64_t>(limits[0], piece.Block + 1);
      for (const ElementKey& key : piece.Keys)
      {
        limits[1] = std::max(limits[1], key[0] + 1);
        limits[2] = std::max(limits[2], key[1] + 1);
        hasNegative |= key[0] < 0 || key[1] < 0;
      }
    }
    reducer.Max(limits, 3);
    reducer.Max(&hasNegative, 1);
    this->Factors = { limits[1], limits[2] };
    this->FitsAll = !hasNegative &&
      static_cast<double>(limits[0]) * static_cast<double>(limits[1]) *
          static_cast<double>(limits[2]) <
        static_cast<double>(std::numeric_limits<std::int64_t>::max());
  }
  bool CanPack() const { return this->FitsAll; }
  std::int64_t Pack(int block, const ElementKey& key) const
  {
    return (block * this->Factors[0] + key[0]) * this->Factors[1] + key[1];
  }

private:
  std::array<std::int64_t, 2> Factors;
  bool FitsAll;
};
}

//------------------------------------------------------------------------------
std::vector<ElementKey> MakeKeys(vtkPolyData* elements)
{
  std::vector<ElementKey> keys;
  vtkDataArray* ids = elements->GetPointData()->GetGlobalIds();
  vtkNew<vtkIdList> points;
  for (vtkIdType i = 0; ids && i < elements->GetNumberOfCells(); ++i)
  {
    elements->GetCellPoints(i, points);
    ElementKey key = { 0, 0 };
    for (vtkIdType k = 0; k < points->GetNumberOfIds(); ++k)
    {
      key[k] = static_cast<std::int64_t>(ids->GetComponent(points->GetId(k), 0));
    }
    std::sort(key.begin(), key.begin() + points->GetNumberOfIds());
    keys.push_back(key);
  }
  return keys;
}

//------------------------------------------------------------------------------
std::vector<std::vector<vtkIdType>> NumberElements(
  const std::vector<KeyedElements>& pieces, Reducer& reducer)
{
  const KeyPacker packer(pieces, reducer);
  if (!packer.CanPack())
  {
    return {};
  }
  std::vector<KeyCounts> all;
  for (const KeyedElements& piece : pieces)
  {
    for (std::size_t i = 0; i < piece.Keys.size(); ++i)
    {
      const bool isGhost = piece.Ghosts && (piece.Ghosts[i] & vtkDataSetAttributes::DUPLICATECELL);
      all.push_back({ packer.Pack(piece.Block, piece.Keys[i]), { isGhost ? 0 : 1, 0 } });
    }
  }
  const auto isBefore = [](const KeyCounts& a, const KeyCounts& b) { return a.Key < b.Key; };
  std::sort(all.begin(), all.end(), isBefore);
  std::size_t size = 0; // of the distinct keys
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (size > 0 && all[size - 1].Key == all[i].Key)
    {
      all[size - 1].Counts[0] += all[i].Counts[0];
    }
    else
    {
      all[size++] = all[i];
    }
  }
  all.resize(size);
  const std::vector<KeyRank> ranks = RankKeys(all, reducer);
  std::int64_t isRepeated =
    std::any_of(ranks.begin(), ranks.end(), [](const KeyRank& rank) { return rank.Counts[0] > 1; });
  reducer.Max(&isRepeated, 1);
  if (isRepeated)
  {
    return {};
  }
  std::vector<std::vector<vtkIdType>> ids(pieces.size());
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    for (const ElementKey& key : pieces[p].Keys)
    {
      const KeyCounts wanted = { packer.Pack(pieces[p].Block, key), {} };
      const auto found = std::lower_bound(all.begin(), all.end(), wanted, isBefore);
      ids[p].push_back(static_cast<vtkIdType>(ranks[found - all.begin()].Before[0]));
    }
  }
  return ids;
}
}
