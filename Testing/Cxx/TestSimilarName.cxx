// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The name that a message suggests for a misspelled word.
#include "Base/Text.h"

#include <gtest/gtest.h>

using namespace camaron;

//------------------------------------------------------------------------------
// Expected names are those of Python 3.11's difflib.get_close_matches(word, names, 1), ignoring
// case.
TEST(SimilarName, SameAsDifflib)
{
  const std::vector<std::string> names = { "Volume", "Area", "MinDihedralAngle", "MaxDihedralAngle",
    "EdgeLengthRatio", "MaxFaceSkewness", "Tetra", "Quad", "tolerate", "abab", "baba" };
  const std::pair<const char*, const char*> cases[] = { { "volume", "Volume" },
    { "MinDihedralAngel", "MinDihedralAngle" }, { "DihedralAngle", "MinDihedralAngle" },
    { "EdgeLenghtRatio", "EdgeLengthRatio" }, { "SkewnessMax", "MaxFaceSkewness" },
    { "Tetraeder", "Tetra" }, { "tolerat", "tolerate" }, { "bab", "baba" }, { "aba", "baba" },
    { "q", "" }, { "", "" }, { "Ar", "Area" }, { "A", "" } };
  for (const auto& [word, name] : cases)
  {
    EXPECT_EQ(FindSimilarName(word, names), name) << word;
  }
  EXPECT_EQ(FindSimilarName("anything", {}), "");
  EXPECT_EQ(FindSimilarName(std::string(100000, 'M'), names), "");
}
