// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::IdSet
 * @brief A set of ids below a limit, filled by several threads; numbers its members in ascending
 * order.
 *
 * Adding ids outside [0, limit) has no effect. They occur if another program changes a file after
 * it was checked.
 */
#ifndef camaron_IdSet_h
#define camaron_IdSet_h

#include "vtkType.h" // for vtkIdType

#include <atomic>  // for filling from several threads
#include <cstddef> // for places
#include <cstdint> // for the words
#include <vector>  // for the words

namespace camaron
{
class IdSet
{
public:
  IdSet() = default;
  /// The empty set of ids in [0, limit).
  explicit IdSet(vtkIdType limit)
    : Limit(limit)
    , Words(static_cast<std::size_t>((limit + 63) / 64))
  {
  }

  vtkIdType GetLimit() const { return this->Limit; }
  bool Contains(vtkIdType id) const
  {
    return this->IsBelowLimit(id) &&
      (this->Words[id >> 6].load(std::memory_order_relaxed) >> (id & 63) & 1);
  }
  /// Adds an id. Thread-safe.
  void Add(vtkIdType id)
  {
    if (!this->IsBelowLimit(id))
    {
      return;
    }
    const std::uint64_t bit = std::uint64_t(1) << (id & 63);
    std::atomic<std::uint64_t>& word = this->Words[id >> 6];
    if (!(word.load(std::memory_order_relaxed) & bit))
    {
      word.fetch_or(bit, std::memory_order_relaxed);
    }
  }
  /**
   * Adds ids for one thread. Consecutive ids in the same word are combined into one atomic
   * operation, which is expensive; the ids of a mesh are usually close to previous ones. All ids
   * are added when the adder goes out of scope.
   */
  class Adder
  {
  public:
    explicit Adder(IdSet& set)
      : Set(set)
    {
    }
    ~Adder()
    {
      for (Part& part : this->Parts)
      {
        this->Flush(part);
      }
    }
    Adder(const Adder&) = delete;
    void operator=(const Adder&) = delete;

    void Add(vtkIdType id)
    {
      if (!this->Set.IsBelowLimit(id))
      {
        return;
      }
      const vtkIdType word = id >> 6;
      Part& part = this->Parts[static_cast<std::size_t>(word) % NumberOfParts];
      if (part.Word != word)
      {
        this->Flush(part);
        part.Word = word;
      }
      part.Bits |= std::uint64_t(1) << (id & 63);
    }

  private:
    static constexpr std::size_t NumberOfParts = 256;
    struct Part
    {
      vtkIdType Word = 0;
      std::uint64_t Bits = 0; ///< bits to add
    };
    void Flush(Part& part)
    {
      if (part.Bits)
      {
        std::atomic<std::uint64_t>& word = this->Set.Words[part.Word];
        if (part.Bits & ~word.load(std::memory_order_relaxed))
        {
          word.fetch_or(part.Bits, std::memory_order_relaxed);
        }
        part.Bits = 0;
      }
    }
    IdSet& Set;
    Part Parts[NumberOfParts];
  };

  /// Adds all ids in [0, limit) that are not in @a other, which must have the same limit.
  void AddMissing(const IdSet& other);
  void AddAll(const IdSet& other);

  ///@{
  /**
   * Numbers the current members in ascending order from 0; returns their number.
   */
  vtkIdType Number();
  vtkIdType GetNumberOfMembers() const { return this->Members; }
  /// Number of a member; requires Number.
  vtkIdType GetNumber(vtkIdType id) const
  {
    if (!this->IsBelowLimit(id))
    {
      return 0;
    }
    const std::uint64_t below = (std::uint64_t(1) << (id & 63)) - 1;
    return this->Before[id >> 6] +
      CountBits(this->Words[id >> 6].load(std::memory_order_relaxed) & below);
  }
  /// The members, in ascending order.
  std::vector<std::int32_t> GetMembers() const;
  ///@}

private:
  bool IsBelowLimit(vtkIdType id) const
  {
    return static_cast<std::uint64_t>(id) < static_cast<std::uint64_t>(this->Limit);
  }
  static int CountBits(std::uint64_t v)
  {
    v -= v >> 1 & 0x5555555555555555u;
    v = (v & 0x3333333333333333u) + (v >> 2 & 0x3333333333333333u);
    v = (v + (v >> 4)) & 0x0f0f0f0f0f0f0f0fu;
    return static_cast<int>(v * 0x0101010101010101u >> 56);
  }

  vtkIdType Limit = 0;
  vtkIdType Members = 0;
  std::vector<std::atomic<std::uint64_t>> Words;
  std::vector<std::uint32_t> Before; ///< number of members in previous words
};
}

#endif
