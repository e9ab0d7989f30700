// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads valid files, truncated files, and files with wrong bytes of the chosen format. The files
// are the seeds of the format and, if CAMARON_SHARED_DATA names a folder of meshes, those of this
// format.
#include "CrashMessage.h"
#include "ReaderTrial.h"
#include "SharedData.h"

#include "Sanitized.h"
#include "Scan/ScanError.h"
#include "vtkMeshFileReader.h"

#include "vtkErrorCode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <random>
#include <set>

using namespace camaron;
using namespace camaron::testing;

namespace
{
/// Larger files are tried less often under a sanitizer, which is some ten times slower.
constexpr std::size_t LargeFile = 40000;
/// Smaller files are tried with all checks.
constexpr std::size_t SmallFile = 4000;
constexpr int MaxFaults = 5; // shown per test

struct Sample
{
  std::string Name;
  MeshFiles Files;
  bool IsGood = true;
};

//------------------------------------------------------------------------------
/// Files with which other programs have problems, some of them rightly, are not samples.
bool IsOdd(const std::filesystem::path& path)
{
  const std::filesystem::path folder = path.parent_path().filename();
  return folder == "malformed" || folder == "reports";
}

//------------------------------------------------------------------------------
const std::vector<Sample>& GetSamples()
{
  static const std::vector<Sample> samples = []
  {
    std::vector<Sample> found;
    const std::filesystem::path seeds = IsSharedDataAlone() ? "" : GetFormat().SeedFolder;
    for (const auto& folder : { seeds, GetSharedData() })
    {
      for (const auto& path : FindMeshFiles(folder, GetFormat()))
      {
        const std::string name = path.filename().string();
        if (!IsOdd(path))
        {
          found.push_back(
            { name, LoadMeshFiles(path, GetFormat()), name.compare(0, 4, "bad-") != 0 });
        }
      }
    }
    return found;
  }();
  return samples;
}

//------------------------------------------------------------------------------
/// Tries files one after the other, and keeps those of the first faults.
class Trials
{
public:
  Reading Try(const MeshFiles& files, const std::string& description, int laws = NoFurtherLaws)
  {
    const CrashMessage words(GetFormat().Name + ": " + description + "; the files are in " +
      this->Trial.GetFolder().GetPath().string());
    Reading reading = this->Trial.Try(files, laws);
    if (!reading.Fault.empty())
    {
      ++this->Faults;
      ADD_FAILURE() << description << ": " << reading.Fault << "\n(kept in " << this->Keep() << ")";
    }
    return reading;
  }
  bool HasSeenEnough() const { return this->Faults >= MaxFaults; }

private:
  std::string Keep() const
  {
    namespace fs = std::filesystem;
    const fs::path kept = fs::current_path() / "damage" /
      (GetFormat().Name + "-" + ::testing::UnitTest::GetInstance()->current_test_info()->name() +
        "-" + std::to_string(this->Faults));
    std::error_code error;
    fs::remove_all(kept, error);
    fs::create_directories(kept, error);
    fs::copy(this->Trial.GetFolder().GetPath(), kept, fs::copy_options::recursive, error);
    return error ? error.message() : kept.string();
  }

  ReaderTrial Trial;
  int Faults = 0;
};

//------------------------------------------------------------------------------
int CountTrials(const Sample& sample, int wanted)
{
  return IsSanitized && GetTotalSize(sample.Files) > LargeFile ? wanted / 20 : wanted;
}

//------------------------------------------------------------------------------
int ChooseLaws(const Sample& sample, int trial)
{
  return GetTotalSize(sample.Files) <= SmallFile || trial % 20 == 0 ? AllLaws : NoFurtherLaws;
}

//------------------------------------------------------------------------------
ErrorKind FindKind(const std::string& word)
{
  static const std::pair<const char*, ErrorKind> kinds[] = { { "OPEN", ErrorKind::Open },
    { "NOT_THIS_FORMAT", ErrorKind::NotThisFormat }, { "TRUNCATED", ErrorKind::Truncated },
    { "SYNTAX", ErrorKind::Syntax }, { "COUNT", ErrorKind::Count }, { "INDEX", ErrorKind::Index },
    { "UNSUPPORTED", ErrorKind::Unsupported }, { "COMPANION", ErrorKind::Companion } };
  for (const auto& kind : kinds)
  {
    if (word == kind.first)
    {
      return kind.second;
    }
  }
  return ErrorKind::None;
}

//------------------------------------------------------------------------------
/// The codes in a row such as "| a.off | 309 | ... | 353535235358 vertices -> COUNT |".
std::set<unsigned long> FindExpectedCodes(const std::string& readMe, const std::string& file)
{
  std::set<unsigned long> codes;
  std::ifstream stream(readMe);
  for (std::string row; std::getline(stream, row);)
  {
    const std::size_t arrow = row.find("-> ");
    if (row.compare(0, file.size() + 4, "| " + file + " |") != 0 || arrow == std::string::npos)
    {
      continue;
    }
    std::string words = row.substr(arrow + 3);
    std::replace(words.begin(), words.end(), '/', ' ');
    std::istringstream list(words);
    for (std::string word; list >> word;)
    {
      if (FindKind(word) != ErrorKind::None)
      {
        codes.insert(GetVTKErrorCode(FindKind(word)));
      }
    }
  }
  return codes;
}
}

//------------------------------------------------------------------------------
// If this fails, the other tests here damage files that were invalid before, or valid files are
// misread: in parallel, in pieces, or after they were written.
TEST(Damage, GoodFilesAreGood)
{
  Trials trials;
  ASSERT_FALSE(FindMeshFiles(GetFormat().SeedFolder, GetFormat()).empty())
    << GetFormat().SeedFolder << " needs a small file or two of the format";
  ASSERT_TRUE(GetSharedData().empty() || !FindMeshFiles(GetSharedData(), GetFormat()).empty())
    << "no file of the format is in " << GetSharedData();
  for (const Sample& sample : GetSamples())
  {
    const Reading reading = trials.Try(sample.Files, sample.Name, AllLaws);
    EXPECT_EQ(reading.Errors.empty(), sample.IsGood)
      << sample.Name << (reading.Errors.empty() ? " was read" : ": " + reading.Errors[0]);
  }
}

//------------------------------------------------------------------------------
// If this fails, invalid files of other programs are read, or refused for the wrong reason.
TEST(Damage, MalformedFiles)
{
  CAMARON_NEEDS_SHARED_DATA("malformed");
  const auto paths = FindMeshFiles(GetSharedData("malformed"), GetFormat());
  if (paths.empty())
  {
    GTEST_SKIP() << "the collected meshes have no malformed file of this format";
  }
  Trials trials;
  for (const auto& path : paths)
  {
    const std::string name = path.filename().string();
    const Reading reading = trials.Try(LoadMeshFiles(path, GetFormat()), name);
    ASSERT_FALSE(reading.Errors.empty()) << name << " was read";
    const auto codes = FindExpectedCodes(GetSharedData("README.md").string(), name);
    EXPECT_TRUE(codes.empty() || codes.count(reading.ErrorCode) > 0)
      << name << ": " << reading.Errors[0];
  }
}

//------------------------------------------------------------------------------
// If this fails, missing files, folders and unset names are not distinguished from empty meshes.
TEST(Damage, NoFile)
{
  const ReaderTrial trial;
  const Folder parent;
  const std::string missing = (parent.GetPath() / "missing.").string() + GetFormat().Extensions[0];
  const std::string folder = (parent.GetPath() / "folder.").string() + GetFormat().Extensions[0];
  std::filesystem::create_directory(folder);
  for (const std::string& path : { missing, folder })
  {
    const Reading reading = trial.TryWithoutFile(path);
    EXPECT_EQ(reading.Fault, "");
    EXPECT_EQ(reading.ErrorCode, static_cast<unsigned long>(vtkErrorCode::CannotOpenFileError));
    EXPECT_EQ(MakeReader()->CanReadFile(path.c_str()), 0);
  }
  EXPECT_EQ(MakeReader()->CanReadFile(nullptr), 0);
  const vtkSmartPointer<vtkMeshFileReader> reader = MakeReader();
  vtkObject::GlobalWarningDisplayOff();
  reader->Update();
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoFileNameError));
}

//------------------------------------------------------------------------------
// If this fails, a truncated file crashes or hangs the reader, needs excessive memory, or shows
// half a mesh that crashes filters.
TEST(Damage, CutOffAnywhere)
{
  constexpr int Trials200 = 200;
  Trials trials;
  std::mt19937 random(1);
  for (const Sample& sample : GetSamples())
  {
    MeshFiles files = sample.Files;
    const std::string& bytes = sample.Files[0].Bytes;
    std::set<std::size_t> sizes;
    if (bytes.size() <= Trials200)
    {
      for (std::size_t size = 0; size < bytes.size(); ++size)
      {
        sizes.insert(size);
      }
    }
    else
    {
      const auto count = static_cast<std::size_t>(CountTrials(sample, Trials200));
      while (sizes.size() < count)
      {
        sizes.insert(random() % bytes.size());
      }
    }
    int trial = 0;
    for (const std::size_t size : sizes)
    {
      files[0].Bytes = bytes.substr(0, size);
      trials.Try(files, sample.Name + " cut off after " + std::to_string(size) + " bytes",
        ChooseLaws(sample, trial++));
      if (trials.HasSeenEnough())
      {
        return;
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, the same happens for a file with wrong or missing bytes.
TEST(Damage, WrongBytes)
{
  if (GetFormat().IsOfLibrary)
  {
    GTEST_SKIP() << "a library reads the bytes";
  }
  constexpr int NumberOfTrials = 2000;
  constexpr int MaxErased = 9; // bytes at once
  constexpr char Text[] = "0123456789-+.eE \n\r\t#/(){},:|ax";
  Trials trials;
  std::mt19937 random(2);
  std::vector<const Sample*> samples;
  for (const Sample& sample : GetSamples())
  {
    if (GetTotalSize(sample.Files) > 0 && CountTrials(sample, 20) == 20)
    {
      samples.push_back(&sample);
    }
  }
  for (int trial = 0; trial < NumberOfTrials && !samples.empty() && !trials.HasSeenEnough();
    ++trial)
  {
    const Sample& sample = *samples[random() % samples.size()];
    MeshFiles files = sample.Files;
    std::string description = sample.Name;
    for (int changes = 1 + trial % 3; changes > 0 && GetTotalSize(files) > 0; --changes)
    {
      std::size_t at = random() % GetTotalSize(files), file = 0;
      for (; at >= files[file].Bytes.size(); ++file)
      {
        at -= files[file].Bytes.size();
      }
      char& byte = files[file].Bytes[at];
      description += ", byte " + std::to_string(at) + " of ." + files[file].Extension;
      switch (random() % 4)
      {
        case 0:
          byte = static_cast<char>(byte ^ 1 << random() % 8);
          break;
        case 1:
          byte = static_cast<char>(random());
          break;
        case 2:
          byte = Text[random() % (sizeof(Text) - 1)];
          break;
        default:
          files[file].Bytes.erase(at, 1 + random() % MaxErased);
          description += " and some after it are missing";
          continue;
      }
      description += " is " + std::to_string(static_cast<unsigned char>(byte));
    }
    trials.Try(files, description, ChooseLaws(sample, trial));
  }
}
