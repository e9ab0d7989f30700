// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Files that another program changes while the reader of the chosen format reads them: the seeds
// of the format.
#include "CrashMessage.h"
#include "MeshFiles.h"
#include "ScopedValue.h"

#include "Intake/Rows/TextLines.h"
#include "Scan/MappedFile.h"
#include "vtkMeshFileReader.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <random>

#if !defined(_WIN32)
using namespace camaron;
using namespace camaron::testing;
namespace fs = std::filesystem;

namespace
{
//------------------------------------------------------------------------------
/// Runs a function at the n-th progress event of a reader.
struct Meddler
{
  int Wait;
  std::function<void()> Act;
  bool HasActed = false;
};

void Meddle(vtkObject*, unsigned long, void* meddler, void* fraction)
{
  auto& self = *static_cast<Meddler*>(meddler);
  const double now = *static_cast<double*>(fraction);
  if (now > 0 && now < 1 && self.Wait-- == 0) // the pipeline reports the beginning and the end
  {
    self.Act();
    self.HasActed = true;
  }
}

//------------------------------------------------------------------------------
void Collect(vtkObject*, unsigned long, void* messages, void* data)
{
  static_cast<std::vector<std::string>*>(messages)->push_back(static_cast<const char*>(data));
}

//------------------------------------------------------------------------------
// Changes happen in place: a file that is replaced remains accessible for those who opened it.
void Overwrite(const fs::path& path, const std::string& bytes, bool truncate)
{
  const auto mode = std::ios::binary | std::ios::out | (truncate ? std::ios::trunc : std::ios::in);
  std::fstream(path, mode) << bytes;
}

//------------------------------------------------------------------------------
constexpr int NumberOfChanges = 6;
constexpr const char* Descriptions[NumberOfChanges] = { "emptied", "cut off in the middle",
  "cut off and written anew", "shifted by a byte", "other numbers", "bytes at random" };

void Change(const fs::path& path, const std::string& bytes, int change, std::mt19937& random)
{
  std::string other = bytes;
  switch (change)
  {
    case 0:
      fs::resize_file(path, 0);
      return;
    case 1:
      fs::resize_file(path, bytes.size() / 2);
      return;
    case 2:
      std::rotate(
        other.begin(), other.begin() + static_cast<std::ptrdiff_t>(other.size() / 3), other.end());
      Overwrite(path, other, true);
      return;
    case 3:
      std::rotate(other.begin(), other.begin() + 1, other.end());
      break;
    case 4:
      for (char& byte : other)
      {
        byte = byte >= '0' && byte <= '8' ? static_cast<char>(byte + 1)
          : byte >= 0 && byte < 16        ? static_cast<char>(byte + 1)
                                          : byte;
      }
      break;
    default:
      for (int i = 0; i < 1 + static_cast<int>(random() % 40); ++i)
      {
        other[random() % other.size()] = static_cast<char>(random());
      }
  }
  Overwrite(path, other, false);
}

//------------------------------------------------------------------------------
/// False if the reader had finished before the change.
bool Try(
  const MeshFiles& files, std::size_t which, int change, int wait, int pieces, std::mt19937& random)
{
  const Folder folder;
  const std::string path = folder.Write(files);
  const fs::path changed = folder.GetPath() / ("mesh." + files[which].Extension);
  // Changes are detected by time stamps: this file gets an old one.
  fs::last_write_time(changed, fs::last_write_time(changed) - std::chrono::hours(1));

  std::vector<std::string> errors;
  Meddler meddler{ wait, [&] { Change(changed, files[which].Bytes, change, random); } };
  vtkNew<vtkCallbackCommand> meddle, collect;
  meddle->SetCallback(Meddle);
  meddle->SetClientData(&meddler);
  collect->SetCallback(Collect);
  collect->SetClientData(&errors);
  const vtkSmartPointer<vtkMeshFileReader> reader = MakeReader();
  reader->AddObserver(vtkCommand::ProgressEvent, meddle);
  reader->AddObserver(vtkCommand::ErrorEvent, collect);
  vtkNew<vtkCallbackCommand> silence;
  reader->AddObserver(vtkCommand::WarningEvent, silence);
  reader->SetFileName(path.c_str());
  reader->UpdatePiece(pieces - 1, pieces, pieces > 1);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(reader->GetOutputDataObject(0));
  if (!meddler.HasActed || errors.empty())
  {
    // The file had been closed by then, or the changed file was never opened.
    return meddler.HasActed;
  }
  EXPECT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].find("another program changed it"), std::string::npos) << errors[0];
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::CannotOpenFileError));
  EXPECT_EQ(grid->GetNumberOfPoints() + grid->GetNumberOfCells(), 0);
  return true;
}
}

//------------------------------------------------------------------------------
// If this fails, a program that rewrites a mesh while ParaView reads it crashes ParaView, or half
// of the mesh is shown.
TEST(Changes, WhileAFileIsRead)
{
  const ScopedValue<bool> map(MappedFile::MayMap, true);
  const ScopedValue<vtkIdType> chunk(TextLines::DefaultChunk, 16);
  constexpr int MaxReports = 60; // while reading a small file
  std::mt19937 random(1);
  for (const fs::path& seed : FindMeshFiles(GetFormat().SeedFolder, GetFormat()))
  {
    const MeshFiles files = LoadMeshFiles(seed, GetFormat());
    for (std::size_t which = 0; which < files.size(); ++which)
    {
      // What a library does with wrong bytes is not tested here.
      constexpr int Truncations = 2;
      const int changes = GetFormat().IsOfLibrary ? Truncations : NumberOfChanges;
      for (int trial = 0; trial < 2 * changes && !files[which].Bytes.empty(); ++trial)
      {
        const int change = trial / 2, pieces = trial % 2 ? 3 : 1;
        bool isInTime = true;
        for (int wait = 0; wait < MaxReports && isInTime && !HasFailure(); ++wait)
        {
          const CrashMessage words(GetFormat().Name + ": " + seed.filename().string() + ", ." +
            files[which].Extension + " " + Descriptions[change] + " at report " +
            std::to_string(wait) + ", " + std::to_string(pieces) + " pieces");
          isInTime = Try(files, which, change, wait, pieces, random);
        }
      }
    }
  }
}
#endif
