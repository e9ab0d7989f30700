// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The main function of the programs with the unit tests: PROGRAM [TestFoo] [OPTION...] runs the
// tests of the source file TestFoo.cxx, or all; the options are those of GoogleTest.
#include "Base/Parallel.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <string>

namespace
{
//------------------------------------------------------------------------------
/// A filter for the tests of a source file; empty if there are none.
std::string FindTests(const std::string& file)
{
  std::string filter;
  const ::testing::UnitTest& all = *::testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i)
  {
    const ::testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j)
    {
      const ::testing::TestInfo& test = *suite.GetTestInfo(j);
      if (std::filesystem::path(test.file()).stem() == file)
      {
        filter += std::string(suite.name()) + "." + test.name() + ":";
      }
    }
  }
  return filter;
}
}

//------------------------------------------------------------------------------
int main(int count, char* arguments[])
{
  ::testing::InitGoogleTest(&count, arguments);
  if (count > 1)
  {
    const std::string filter = FindTests(arguments[1]);
    if (filter.empty())
    {
      std::fprintf(stderr, "%s has no test of a file %s.cxx\n", arguments[0], arguments[1]);
      return 2;
    }
    GTEST_FLAG_SET(filter, filter);
  }
  const int status = RUN_ALL_TESTS();
  camaron::AwaitSleepingThreads();
  return status;
}
