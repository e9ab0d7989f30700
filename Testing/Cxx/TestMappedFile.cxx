// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/MappedFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csetjmp>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/mman.h>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace camaron;
namespace fs = std::filesystem;

namespace
{
//------------------------------------------------------------------------------
/// A file of this many letters x, removed by the destructor.
class TestFile
{
public:
  explicit TestFile(std::size_t size)
  {
    std::string path = (fs::temp_directory_path() / "camaron-mapped-XXXXXX").string();
    close(mkstemp(path.data()));
    this->Path = path;
    std::ofstream(path) << std::string(size, 'x');
  }
  ~TestFile() { fs::remove(this->Path); }

  fs::path Path;
};

constexpr std::size_t Size = std::size_t(1) << 20;

//------------------------------------------------------------------------------
sigjmp_buf Back;
void JumpBack(int)
{
  siglongjmp(Back, 1);
}

//------------------------------------------------------------------------------
/// Mapping is off under a sanitizer, so these tests are skipped.
class MappedFileTest : public ::testing::Test
{
protected:
  void SetUp() override { MappedFile::MayMap = true; }
  void TearDown() override { MappedFile::MayMap = this->Before; }
  bool Before = MappedFile::MayMap;
};
}

//------------------------------------------------------------------------------
// If this fails, the process dies when another program truncates a file that several threads read.
TEST_F(MappedFileTest, CutOff)
{
  const TestFile test(Size);
  ScanError error;
  MappedFile file;
  ASSERT_TRUE(file.Open(test.Path.string(), error));
  EXPECT_EQ(std::count(file.begin(), file.end(), 'x'), static_cast<std::ptrdiff_t>(Size));
  EXPECT_TRUE(file.IsUnchanged(error));
  EXPECT_FALSE(MappedFile::HasAnyChanged());

  fs::resize_file(test.Path, 5000);
  std::vector<std::thread> threads;
  std::vector<std::ptrdiff_t> counts(4, -1);
  for (std::ptrdiff_t& count : counts)
  {
    threads.emplace_back([&] { count = std::count(file.begin(), file.end(), 'x'); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const std::ptrdiff_t count : counts)
  {
    EXPECT_LT(count, static_cast<std::ptrdiff_t>(Size));
  }
  EXPECT_EQ(std::count(file.begin(), file.end(), '\0'), static_cast<std::ptrdiff_t>(Size));
  EXPECT_TRUE(MappedFile::HasAnyChanged());
  EXPECT_FALSE(file.IsUnchanged(error));
  EXPECT_EQ(error.Kind, ErrorKind::Changed);
  EXPECT_NE(error.Message.find("another program changed it"), std::string::npos);
}

//------------------------------------------------------------------------------
// If this fails, a file that was rewritten is treated as the one that was read.
TEST_F(MappedFileTest, WrittenAnew)
{
  const TestFile test(Size);
  fs::last_write_time(test.Path, fs::last_write_time(test.Path) - std::chrono::hours(1));
  for (const bool maps : { true, false })
  {
    MappedFile::MayMap = maps;
    ScanError error;
    MappedFile file;
    ASSERT_TRUE(file.Open(test.Path.string(), error));
    EXPECT_TRUE(file.IsUnchanged(error));
    std::fstream(test.Path, std::ios::in | std::ios::out) << "y";
    EXPECT_FALSE(file.IsUnchanged(error)) << "mapped: " << maps;
    fs::last_write_time(test.Path, fs::last_write_time(test.Path) - std::chrono::hours(1));
  }
}

//------------------------------------------------------------------------------
// If this fails, faults outside of mapped files do not reach the handlers of others, or handlers
// installed before a file was opened are lost afterwards.
TEST_F(MappedFileTest, OtherHandlers)
{
  struct sigaction theirs = {}, before, after;
  theirs.sa_handler = JumpBack;
  sigaction(SIGBUS, &theirs, &before);
  {
    const TestFile test(Size), other(Size);
    ScanError error;
    MappedFile first, second;
    ASSERT_TRUE(first.Open(test.Path.string(), error));
    ASSERT_TRUE(second.Open(test.Path.string(), error));
    const int descriptor = open(other.Path.c_str(), O_RDONLY);
    const char* const mapping =
      static_cast<const char*>(mmap(nullptr, Size, PROT_READ, MAP_PRIVATE, descriptor, 0));
    ASSERT_NE(mapping, MAP_FAILED);
    close(descriptor);
    fs::resize_file(other.Path, 0);
    volatile bool hasReturned = false;
    if (sigsetjmp(Back, 1) == 0)
    {
      static_cast<void>(*static_cast<const volatile char*>(mapping));
    }
    else
    {
      hasReturned = true;
    }
    EXPECT_TRUE(hasReturned);
    EXPECT_TRUE(first.IsUnchanged(error) && second.IsUnchanged(error));
    munmap(const_cast<char*>(mapping), Size);
  }
  sigaction(SIGBUS, &before, &after);
  EXPECT_EQ(after.sa_handler, JumpBack);
}

//------------------------------------------------------------------------------
// If this fails, a file is mapped without protection, as other code has replaced the signal
// handler.
TEST_F(MappedFileTest, HandlerOnTop)
{
  const TestFile test(Size);
  ScanError error;
  MappedFile first;
  ASSERT_TRUE(first.Open(test.Path.string(), error));
  struct sigaction theirs = {}, ours;
  theirs.sa_handler = JumpBack;
  sigaction(SIGBUS, &theirs, &ours);
  MappedFile second;
  ASSERT_TRUE(second.Open(test.Path.string(), error));
  sigaction(SIGBUS, &ours, nullptr);
  fs::resize_file(test.Path, 0);
  EXPECT_EQ(std::count(second.begin(), second.end(), 'x'), static_cast<std::ptrdiff_t>(Size));
  EXPECT_EQ(std::count(first.begin(), first.end(), 'x'), 0);
}
