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
Warning Describe(const std::vector<vtkIdType>& cells)
{
  Tally tally;
  for (const vtkIdType cell : cells)
  {
    tally.Add(cell);
  }
  return { "not closed: with an edge of one face", tally, "cell", "cells", FromZero };
}

Warning Say(const char* sentence)
{
  return { sentence };
}

using Sentences = std::vector<std::string>;
using OfProcess = std::vector<Warning>;

Sentences Merge(const std::vector<OfProcess>& ofProcesses)
{
  std::vector<Warnings> all;
  for (const OfProcess& warnings : ofProcesses)
  {
    all.emplace_back();
    for (const Warning& warning : warnings)
    {
      all.back().Add(warning);
    }
  }
  return MergeWarnings(all).GetSentences();
}

Sentences Of(const OfProcess& warnings)
{
  return Merge({ warnings });
}
}

//------------------------------------------------------------------------------
// If this fails, the counts of a mesh depend on the number of processes.
TEST(MergedWarnings, AddsWhatPiecesCounted)
{
  const Sentences all = Of({ Describe({ 3, 10, 12, 17, 40, 41, 99 }) });
  EXPECT_EQ(
    all[0], "7 cells not closed: with an edge of one face, the first is cell 3 (counted from 0)");
  EXPECT_EQ(
    Merge({ { Describe({ 3, 10 }) }, { Describe({ 12, 17, 40 }) }, { Describe({ 41, 99 }) } }),
    all);
  EXPECT_EQ(Merge({ {}, { Describe({ 41, 99 }) }, { Describe({ 3, 10, 12, 17, 40 }) } }), all);
  EXPECT_EQ(Merge({ { Describe({ 8 }) }, { Describe({ 5 }) } }), Of({ Describe({ 5, 8 }) }));
  EXPECT_EQ(
    Merge({ { Describe({ 8 }) }, {}, { Describe({ 9, 10 }) } }), Of({ Describe({ 8, 9, 10 }) }));
  EXPECT_EQ(Merge({ {}, {}, { Describe({ 8 }) } }), Of({ Describe({ 8 }) }));
}

//------------------------------------------------------------------------------
// If this fails, what all processes have found in the whole file is counted by each.
TEST(MergedWarnings, SaysTheSameOnce)
{
  const Warning whole = Describe({ 3, 10, 12 });
  EXPECT_EQ(Merge({ { whole }, { whole }, { whole } }), Of({ whole }));
  const OfProcess texts = { Say("a"), Say("3 is a number"), Say("") };
  EXPECT_EQ(Merge({ texts, texts }), Of(texts));
}

//------------------------------------------------------------------------------
// If this fails, sentences come in another order than one process has.
TEST(MergedWarnings, KeepsTheOrder)
{
  const Warning a = Say("a"), b = Say("b"), c = Say("c");
  EXPECT_EQ(Merge({ { a, c }, { Describe({ 1 }), b, c }, { a, Describe({ 5 }), c } }).size(), 4u);
  EXPECT_EQ(Merge({ { a, Describe({ 1 }), c }, { a, Describe({ 5 }), b, c } }),
    Of({ a, Describe({ 1, 5 }), b, c }));
  EXPECT_EQ(Merge({ { b }, { a, b } }), Of({ a, b }));
  EXPECT_TRUE(Merge({ {}, {} }).empty());
}
