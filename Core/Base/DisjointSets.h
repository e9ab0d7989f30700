// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::DisjointSets
 * @brief Union-find: disjoint sets of numbers that can be joined, each represented by its smallest
 * member.
 */
#ifndef camaron_DisjointSets_h
#define camaron_DisjointSets_h

#include "vtkType.h" // for vtkIdType

#include <algorithm> // for std::min
#include <cstddef>   // for std::size_t
#include <vector>    // for the members

namespace camaron
{
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t size)
    : Parents(size, -1)
  {
  }
  bool Contains(vtkIdType item) const { return this->Parents[item] >= 0; }
  void Insert(vtkIdType item)
  {
    if (!this->Contains(item))
    {
      this->Parents[item] = item;
    }
  }
  vtkIdType Find(vtkIdType item)
  {
    while (this->Parents[item] != item)
    {
      this->Parents[item] = this->Parents[this->Parents[item]];
      item = this->Parents[item];
    }
    return item;
  }
  /// Both must have been inserted.
  void Join(vtkIdType a, vtkIdType b)
  {
    a = this->Find(a);
    b = this->Find(b);
    this->Parents[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<vtkIdType> Parents;
};
}

#endif
