// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Peculiarities of old programs in text files, for every text format: bytes after the end, and
// numbers as printed by run-time libraries of Microsoft. The files are the seeds of the chosen
// format.
#include "Gzip.h"
#include "MeshChecks.h"
#include "ReaderTrial.h"

#include "Base/Number.h"

#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
struct TextSample
{
  std::string Name;
  MeshFiles Files;
};

//------------------------------------------------------------------------------
// The seeds that are valid and text; those of Fluent may contain binary sections.
std::vector<TextSample> GetTextSamples(ReaderTrial& trial)
{
  std::vector<TextSample> samples;
  for (const auto& path : FindMeshFiles(GetFormat().SeedFolder, GetFormat()))
  {
    MeshFiles files = LoadMeshFiles(path, GetFormat());
    const bool isText = std::all_of(files.begin(), files.end(),
      [](const MeshFile& file)
      {
        return std::all_of(file.Bytes.begin(), file.Bytes.end(),
          [](char c) { return static_cast<unsigned char>(c) >= ' ' || IsSpace(c); });
      });
    if (isText && trial.Try(files).Errors.empty())
    {
      samples.push_back({ path.filename().string(), std::move(files) });
    }
  }
  return samples;
}

//------------------------------------------------------------------------------
bool IsDivider(char c)
{
  return IsSpace(c) || c == '(' || c == ')' || c == ',' || c == '{' || c == '}';
}

//------------------------------------------------------------------------------
// Begin and end of the words that are real numbers.
std::vector<std::pair<std::size_t, std::size_t>> FindReals(const std::string& bytes)
{
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t begin = 0; begin < bytes.size();)
  {
    std::size_t end = begin;
    while (end < bytes.size() && !IsDivider(bytes[end]))
    {
      ++end;
    }
    double value = 0;
    const char* const text = bytes.data();
    if (end > begin && ParseReal(text + begin, text + end, value) == text + end)
    {
      found.emplace_back(begin, end);
    }
    begin = end + 1;
  }
  return found;
}

//------------------------------------------------------------------------------
// Replaces a word of the bytes by another at least as wide as the old one, so that columns remain.
std::string Replace(
  const std::string& bytes, std::pair<std::size_t, std::size_t> place, const std::string& word)
{
  const std::size_t size = place.second - place.first;
  const std::string fill(word.size() < size ? size - word.size() : 0, ' ');
  return bytes.substr(0, place.first) + fill + word + bytes.substr(place.second);
}
}

//------------------------------------------------------------------------------
// If this fails, a file from an old editor or tape is refused or misread.
TEST(Spelling, PaddingBehindText)
{
  using namespace std::string_literals;
  ReaderTrial trial;
  const std::vector<TextSample> samples = GetTextSamples(trial);
  if (GetFormat().IsOfLibrary)
  {
    GTEST_SKIP() << "the format has no text";
  }
  ASSERT_FALSE(samples.empty());
  for (const TextSample& sample : samples)
  {
    const Reading expected = trial.Try(sample.Files);
    for (const std::string& padding :
      { "\x1a"s, "\0"s, std::string(700, '\x1a'), std::string(700, '\0'), "\x1a\r\n\0\0"s })
    {
      MeshFiles files = sample.Files;
      for (MeshFile& file : files)
      {
        // After a word, several zeros mean that a part of the file was lost.
        const bool endsLine = file.Bytes.empty() || IsSpace(file.Bytes.back());
        file.Bytes += (endsLine || padding.size() == 1 ? "" : "\n") + padding;
      }
      const Reading reading = trial.Try(files, Parallel);
      EXPECT_EQ(reading.Fault, "") << sample.Name;
      EXPECT_EQ(reading.Errors, std::vector<std::string>()) << sample.Name;
      EXPECT_EQ(reading.Warnings, expected.Warnings) << sample.Name;
      EXPECT_EQ(FindDifference(reading.Grid, expected.Grid), "") << sample.Name;
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, files that gzip has compressed are refused or misread.
TEST(Spelling, Compressed)
{
  ReaderTrial trial;
  for (const TextSample& sample : GetTextSamples(trial))
  {
    const Reading expected = trial.Try(sample.Files);
    MeshFiles files = sample.Files;
    for (MeshFile& file : files)
    {
      file.Bytes = Gzip(file.Bytes);
      file.Extension += ".gz";
    }
    const Reading reading = trial.Try(files, Parallel);
    EXPECT_EQ(reading.Fault, "") << sample.Name;
    EXPECT_EQ(reading.Errors, std::vector<std::string>()) << sample.Name;
    EXPECT_EQ(reading.Warnings.size(), expected.Warnings.size()) << sample.Name;
    EXPECT_EQ(FindDifference(reading.Grid, expected.Grid), "") << sample.Name;
    files[0].Bytes.resize(files[0].Bytes.size() / 2);
    EXPECT_EQ(trial.Try(files).Errors.size(), 1u) << sample.Name;
  }
}

//------------------------------------------------------------------------------
// If this fails, 1.#QNAN and the like are not read as nan and inf at some position.
TEST(Spelling, NumbersOfMicrosoft)
{
  const std::pair<const char*, const char*> spellings[] = { { "1.#QNAN", "nan" },
    { "-1.#IND00", "-nan" }, { "1.#INF", "inf" }, { "-1.#INF000", "-inf" } };
  constexpr std::size_t MaxPlaces = 60; // per file
  ReaderTrial trial;
  int places = 0, read = 0;
  if (GetFormat().IsOfLibrary)
  {
    GTEST_SKIP() << "the format has no text";
  }
  for (const TextSample& sample : GetTextSamples(trial))
  {
    for (std::size_t f = 0; f < sample.Files.size(); ++f)
    {
      const std::string& bytes = sample.Files[f].Bytes;
      const auto reals = FindReals(bytes);
      const std::size_t step = reals.size() / MaxPlaces + 1;
      for (std::size_t i = 0; i < reals.size(); i += step)
      {
        const auto& [theirs, plain] = spellings[(i / step) % std::size(spellings)];
        MeshFiles files = sample.Files;
        // Both with the same width, for formats with columns.
        const std::string wide =
          std::string(std::string(theirs).size() - std::string(plain).size(), ' ');
        files[f].Bytes = Replace(bytes, reals[i], wide + plain);
        const Reading expected = trial.Try(files);
        files[f].Bytes = Replace(bytes, reals[i], theirs);
        const Reading reading = trial.Try(files, Parallel);
        const std::string place = sample.Name + ", byte " + std::to_string(reals[i].first) +
          " of ." + files[f].Extension + " is " + theirs;
        EXPECT_EQ(reading.Fault, "") << place;
        // Instead of an integer, nan may be read as a name, for a zone or a component.
        if (bytes.find('.', reals[i].first) >= reals[i].second)
        {
          continue;
        }
        ASSERT_EQ(reading.Errors.empty(), expected.Errors.empty())
          << place << ": " << (reading.Errors.empty() ? expected.Errors[0] : reading.Errors[0]);
        EXPECT_EQ(reading.Warnings.size(), expected.Warnings.size()) << place;
        EXPECT_EQ(FindDifference(reading.Grid, expected.Grid), "") << place;
        ++places;
        read += reading.Errors.empty();
      }
    }
  }
  EXPECT_GT(places, 0);
  EXPECT_GT(read, 0) << "no place of a seed may be no number";
}
