// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedData.h
 * @brief The folder of collected meshes of other programs, which CAMARON_SHARED_DATA names.
 *
 * A test that includes this gets the label shared-data, so tests can be run with a folder of meshes
 * alone.
 */
#ifndef camaron_SharedData_h
#define camaron_SharedData_h

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace camaron
{
namespace testing
{
//------------------------------------------------------------------------------
/// A file or folder of the collected meshes; empty if there is no collection.
inline std::filesystem::path GetSharedData(const std::string& name = "")
{
  const char* const folder = std::getenv("CAMARON_SHARED_DATA");
  const bool isThere = folder && std::filesystem::is_directory(folder);
  return isThere ? std::filesystem::path(folder) / name : std::filesystem::path();
}

//------------------------------------------------------------------------------
/// Whether what does without the collected meshes was tried before, see CAMARON_SHARED_DATA_ONLY in
/// Testing/Python.
inline bool IsSharedDataAlone()
{
  const char* const only = std::getenv("CAMARON_SHARED_DATA_ONLY");
  return only && *only && !GetSharedData().empty();
}
}
}

/// Skips a test that needs the collection if there is none; otherwise the file or folder `name`
/// must exist in it.
#define CAMARON_NEEDS_SHARED_DATA(name)                                                            \
  if (camaron::testing::GetSharedData().empty())                                                   \
  {                                                                                                \
    GTEST_SKIP() << "CAMARON_SHARED_DATA names no folder of meshes";                               \
  }                                                                                                \
  ASSERT_TRUE(std::filesystem::exists(camaron::testing::GetSharedData(name)) &&                    \
    !std::filesystem::is_empty(camaron::testing::GetSharedData(name)))                             \
    << (name) << " is not in " << camaron::testing::GetSharedData()

#endif
