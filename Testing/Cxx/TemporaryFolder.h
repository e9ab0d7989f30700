// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TemporaryFolder.h
 * @brief A folder for the files of a test or benchmark.
 */
#ifndef camaron_TemporaryFolder_h
#define camaron_TemporaryFolder_h

#include <cstdint>    // for std::uint32_t
#include <filesystem> // for paths
#include <random>     // for the name
#include <string>     // for the name

namespace camaron
{
/// A new folder, never one (or a link) that is already there, removed by the destructor.
class TemporaryFolder
{
public:
  /// Throws std::filesystem::filesystem_error if the parent is not writable.
  explicit TemporaryFolder(
    const std::filesystem::path& parent = std::filesystem::temp_directory_path())
  {
    std::random_device random;
    do
    {
      // Names have a constant length, so that messages with the name do not look new to a fuzzer.
      const std::uint32_t number = random() | 1u << 31;
      this->Path = parent / ("camaron-test-" + std::to_string(number));
    } while (!std::filesystem::create_directory(this->Path));
    std::filesystem::permissions(this->Path, std::filesystem::perms::owner_all);
  }
  ~TemporaryFolder()
  {
    std::error_code error;
    std::filesystem::remove_all(this->Path, error);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  void operator=(const TemporaryFolder&) = delete;

  std::filesystem::path Path;
};
}

#endif
