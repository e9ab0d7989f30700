// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Lists of ids in rows of binary files, and what is looked for in them.
#include "Intake/CellMesh/CellMesh.h"
#include "Intake/Ids/RepeatedIds.h"
#include "Intake/Rows/Bytes.h"
#include "Intake/Rows/IdLists.h"
#include "Intake/Rows/ListRows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

using namespace camaron;

namespace
{
// Lists one after the other, and the same in rows with some bytes before and behind each.
struct Lists
{
  std::vector<std::int32_t> Offsets{ 0 };
  std::vector<std::int32_t> Ids;
  std::string Bytes;
  static constexpr int Before = 1, Behind = 2;

  void Add(std::int32_t size, bool swap, std::mt19937& random)
  {
    this->Bytes.append(Before, 'b');
    for (std::int32_t i = 0; i < size; ++i)
    {
      this->Ids.push_back(static_cast<std::int32_t>(random() % 9));
      AppendBytes(this->Bytes, this->Ids.back(), swap);
    }
    this->Bytes.append(Behind, 'e');
    this->Offsets.push_back(static_cast<std::int32_t>(this->Ids.size()));
  }
  ListRows GetRows(bool swap) const
  {
    ListRows rows;
    rows.Begin = this->Bytes.data() + Before;
    rows.Rest = Before + Behind;
    rows.Swap = swap;
    return rows;
  }
};

void ExpectCopies(const ListRows& rows, const Lists& lists)
{
  const auto count = static_cast<vtkIdType>(lists.Offsets.size()) - 1;
  for (vtkIdType first = 0; first <= count; first += 3)
  {
    for (vtkIdType last = first; last <= count; last += 5)
    {
      const std::vector<std::int32_t> expected(
        lists.Ids.begin() + lists.Offsets[first], lists.Ids.begin() + lists.Offsets[last]);
      std::vector<std::int32_t> ids(expected.size()); // no longer, for the sanitizer
      ASSERT_EQ(rows.GetNumberOfIds(first, last), static_cast<vtkIdType>(ids.size()));
      rows.Copy(first, last, ids.data());
      EXPECT_EQ(ids, expected) << first << " to " << last;
    }
  }
}

void ExpectRepeatedPoints(const Lists& lists, std::int32_t size)
{
  const auto count = static_cast<vtkIdType>(lists.Offsets.size()) - 1;
  constexpr vtkIdType First = 1000;
  Tally expected, found;
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (HasRepeatedIdsAnywhere(
          lists.Ids.data() + lists.Offsets[i], lists.Offsets[i + 1] - lists.Offsets[i]))
    {
      expected.Add(First + i);
    }
  }
  FindRepeatedPoints(
    lists.Ids.data(), size < 0 ? lists.Offsets.data() : nullptr, size, First, count, found);
  EXPECT_EQ(found.Count, expected.Count);
  EXPECT_EQ(found.First, expected.First);
}
}

//------------------------------------------------------------------------------
TEST(ListRows, OfOneSize)
{
  std::mt19937 random(1);
  for (const bool swap : { false, true })
  {
    for (std::int32_t size = 0; size < 10; ++size)
    {
      Lists lists;
      for (int i = 0; i < 40; ++i)
      {
        lists.Add(size, swap, random);
      }
      ListRows rows = lists.GetRows(swap);
      rows.Size = size;
      ExpectCopies(rows, lists);
      ExpectRepeatedPoints(lists, size);
    }
  }
}

//------------------------------------------------------------------------------
TEST(ListRows, OfAnySize)
{
  std::mt19937 random(2);
  for (const bool swap : { false, true })
  {
    for (const unsigned most : { 1u, 3u, 4u, 5u, 12u })
    {
      Lists lists;
      for (int i = 0; i < 200; ++i)
      {
        lists.Add(static_cast<std::int32_t>(random() % (most + 1)), swap, random);
      }
      ListRows rows = lists.GetRows(swap);
      rows.Offsets = lists.Offsets.data();
      ExpectCopies(rows, lists);
      ExpectRepeatedPoints(lists, -1);
    }
  }
}

//------------------------------------------------------------------------------
TEST(ListRows, IdsInRange)
{
  for (const vtkIdType limit : { 0, 1, 7, INT32_MAX })
  {
    for (const std::int32_t id : { INT32_MIN, -2, -1, 0, 1, 6, 7, INT32_MAX - 1, INT32_MAX })
    {
      std::vector<std::int32_t> ids(9, limit > 0 ? 0 : id);
      ids[5] = id;
      EXPECT_EQ(AreIds(ids.data(), 9, limit), id >= 0 && id < limit) << id << " of " << limit;
      EXPECT_EQ(AreIds(ids.data(), 9, limit, true), id >= -1 && id < limit)
        << id << " of " << limit;
    }
  }
  EXPECT_TRUE(AreIds(nullptr, 0, 0));
}

//------------------------------------------------------------------------------
// If this fails, lists that a reader has in memory are not those that it would scan.
TEST(ListRows, WithoutSizesAreTheSame)
{
  constexpr vtkIdType count = 3 * IdLists::BlockSize + 5;
  for (const std::int32_t most : { 3, 6 }) // all of one size, or of several
  {
    Buffer<std::int32_t> words(count * (most + 1)), ids(count * most), offsets(count + 1);
    vtkIdType word = 0, id = 0;
    std::mt19937 random(1);
    for (vtkIdType i = 0; i < count; ++i)
    {
      offsets[i] = static_cast<std::int32_t>(id);
      const auto size = most == 3 ? most : static_cast<std::int32_t>(random() % (most + 1));
      words[word++] = size;
      for (std::int32_t j = 0; j < size; ++j)
      {
        words[word++] = ids[id++] = static_cast<std::int32_t>(random() % 9);
      }
    }
    offsets[count] = static_cast<std::int32_t>(id);
    Buffer<std::int32_t> exact(id);
    std::copy_n(ids.data(), id, exact.data());
    IdSet usedInFile(9), usedInMemory(9);
    IdLists::Expectation inFile, inMemory;
    inFile.Limit = inMemory.Limit = 9;
    inFile.FindsRepeating = inMemory.FindsRepeating = true;
    inFile.Used = &usedInFile;
    inMemory.Used = &usedInMemory;
    IdLists scanned, opened;
    ASSERT_TRUE(scanned.Open(words, count, inFile, Progress()));
    ASSERT_TRUE(opened.Open(std::move(exact),
      most == 3 ? Buffer<std::int32_t>() : std::move(offsets), most, count, inMemory, Progress()));
    EXPECT_EQ(opened.GetNumberOfIds(), id);
    EXPECT_EQ(opened.GetCommonSize(), scanned.GetCommonSize());
    EXPECT_EQ(inMemory.Empty.Count, inFile.Empty.Count);
    EXPECT_EQ(inMemory.Short.First, inFile.Short.First);
    EXPECT_EQ(inMemory.Repeating.Count, inFile.Repeating.Count);
    EXPECT_EQ(usedInMemory.Number(), usedInFile.Number());
    IdSet needed(count);
    needed.Add(7);
    needed.Add(count - 1);
    needed.Number();
    ASSERT_TRUE(opened.MakeRandomAccess(needed, Progress()));
    vtkIdType visited = 0;
    scanned.ForEachInOrder(
      [&](vtkIdType i, const IdList& expected)
      {
        const IdList found = opened[i];
        ASSERT_EQ(found.Size, expected.Size) << i;
        EXPECT_EQ(opened.GetSize(i), expected.Size);
        for (std::int32_t j = 0; j < expected.Size; ++j)
        {
          EXPECT_EQ(found[j], expected[j]) << i;
        }
        ++visited;
      });
    EXPECT_EQ(visited, count);
    std::atomic<vtkIdType> sum{ 0 };
    opened.ForEach(Progress(), [&](vtkIdType, const IdList& list) { sum += list.Size; });
    EXPECT_EQ(sum, id);
    IdListGroup block;
    opened.ReadBlock(2 * IdLists::BlockSize, 2 * IdLists::BlockSize + 9, block);
    EXPECT_EQ(block.size(), 9);
    EXPECT_EQ(block[8].Size, scanned.GetSize(2 * IdLists::BlockSize + 8));
  }
}
