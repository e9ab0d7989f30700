// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// DamageTests FORMAT [OPTION...]: tests the reader of a format; the options are those of
// GoogleTest.
#include "Base/Parallel.h"
#include "FormatUnderTest.h"
#include "SharedData.h"

#include <gtest/gtest.h>

#include <cstdio>

int main(int count, char* arguments[])
{
  ::testing::InitGoogleTest(&count, arguments);
  if (count != 2 || !camaron::testing::ChooseFormat(arguments[1]))
  {
    std::fprintf(stderr, "usage: %s FORMAT [OPTION...]\n", arguments[0]);
    return 2;
  }
  if (camaron::testing::IsSharedDataAlone())
  {
    GTEST_FLAG_SET(filter, "Damage.*");
  }
  const int status = RUN_ALL_TESTS();
  camaron::AwaitSleepingThreads();
  return status;
}
