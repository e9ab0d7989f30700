// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What processes warn of that read pieces of one file: each thing once, and counts added.
#include "MergedWarnings.h"
#include "Scan/ScanError.h"

#include <gtest/gtest.h>

using namespace camaron;

namespace
{
//------------------------------------------------------------------------------
/// Of cells with these ids that are not closed.
std::string Describe(const std::vector<vtkIdType>& cells)
{
  Tally tally;
  for (const vtkIdType cell : cells)
  {
    tally.Add(cell);
  }
  Warnings warnings;
  warnings.Add(tally, "cell", "cells", "not closed: with an edge of one face", FromZero);
  return warnings.GetSentences()[0];
}

using Sentences = std::vector<std::string>;
}

//------------------------------------------------------------------------------
// If this fails, the counts of a mesh depend on the number of processes.
TEST(MergedWarnings, AddsWhatPiecesCounted)
{
  const std::string all = Describe({ 3, 10, 12, 17, 40, 41, 99 });
  EXPECT_EQ(MergeWarnings(
              { { Describe({ 3, 10 }) }, { Describe({ 12, 17, 40 }) }, { Describe({ 41, 99 }) } }),
    Sentences{ all });
  EXPECT_EQ(MergeWarnings({ {}, { Describe({ 41, 99 }) }, { Describe({ 3, 10, 12, 17, 40 }) } }),
    Sentences{ all });
  EXPECT_EQ(
    MergeWarnings({ { Describe({ 8 }) }, { Describe({ 5 }) } }), Sentences{ Describe({ 5, 8 }) });
  EXPECT_EQ(MergeWarnings({ { Describe({ 8 }) }, {}, { Describe({ 9, 10 }) } }),
    Sentences{ Describe({ 8, 9, 10 }) });
  EXPECT_EQ(MergeWarnings({ {}, {}, { Describe({ 8 }) } }), Sentences{ Describe({ 8 }) });
}

//------------------------------------------------------------------------------
// If this fails, what all processes have found in the whole file is counted by each.
TEST(MergedWarnings, SaysTheSameOnce)
{
  const std::string whole = "12 polygons with fewer than 3 vertices, the first is polygon 7";
  EXPECT_EQ(MergeWarnings({ { whole }, { whole }, { whole } }), Sentences{ whole });
  EXPECT_EQ(MergeWarnings({ { "1 polygon odd: polygon 7" }, { "1 polygon odd: polygon 7" } }),
    Sentences{ "1 polygon odd: polygon 7" });
  const Sentences texts = { "a", "3 is a number",
    "the file is of version 4, the first is version 3", "" };
  EXPECT_EQ(MergeWarnings({ texts, texts }), texts);
}

//------------------------------------------------------------------------------
// If this fails, sentences come in another order than one process has.
TEST(MergedWarnings, KeepsTheOrder)
{
  const Sentences order = { "a", Describe({ 1, 5 }), "b", "c" };
  EXPECT_EQ(
    MergeWarnings({ { "a", "c" }, { Describe({ 1 }), "b", "c" }, { "a", Describe({ 5 }), "c" } })
      .size(),
    4u);
  EXPECT_EQ(
    MergeWarnings({ { "a", Describe({ 1 }), "c" }, { "a", Describe({ 5 }), "b", "c" } }), order);
  EXPECT_EQ(MergeWarnings({ { "b" }, { "a", "b" } }), (Sentences{ "a", "b" }));
  EXPECT_TRUE(MergeWarnings({ {}, {} }).empty());
}
