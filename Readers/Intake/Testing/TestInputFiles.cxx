// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Files that outputs must not replace; that commands and writers ask is tested in Python.
#include "Intake/Write/InputFiles.h"
#include "Intake/Write/OutputFile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace camaron;
namespace fs = std::filesystem;

namespace
{
class InputFilesTest : public ::testing::Test
{
protected:
  InputFilesTest() { fs::create_directories(this->Folder); }
  ~InputFilesTest() override { fs::remove_all(this->Folder); }

  std::string Make(const std::string& name, const std::string& text = "")
  {
    const fs::path path = this->Folder / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
    return path.string();
  }
  std::string At(const std::string& name) const { return (this->Folder / name).string(); }

  const fs::path Folder = fs::path(::testing::TempDir()) /
    ("InputFiles-" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};
}

//------------------------------------------------------------------------------
TEST_F(InputFilesTest, AreKnownByAnyName)
{
  InputFiles files;
  const std::string path = this->Make("a.visf");
  files.Add(path);
  files.Add("");
  files.Add(path);
  EXPECT_EQ(files.GetPaths().size(), 1u);
  this->Make("b.visf");
  fs::create_symlink(path, this->At("link"));
  fs::create_hard_link(path, this->At("hard"));
  for (const char* name : { "a.visf", "./a.visf", "link", "hard" })
  {
    EXPECT_EQ(files.FindReplaced(this->At(name)), path) << name;
  }
  EXPECT_EQ(files.FindReplaced(this->At("b.visf")), "");
  EXPECT_EQ(files.FindReplaced(this->At("new.visf")), "");
}

//------------------------------------------------------------------------------
TEST_F(InputFilesTest, IncludeFilesThatListsName)
{
  this->Make("parts/0.vtu");
  this->Make("with blank.vtu");
  this->Make("data.h5");
  const std::string inner = this->Make("inner.pvtu", "<Piece Source=\"parts/0.vtu\"/>");
  const std::string outer = this->Make("outer.pvd",
    "<DataSet file=\"inner.pvtu\"/>\n<DataSet file='with blank.vtu'/>\n<DataSet "
    "file='outer.pvd'/>");
  const std::string xdmf = this->Make("x.xmf", "<DataItem>\n  data.h5:/points\n</DataItem>");
  InputFiles files;
  files.Add(outer);
  files.Add(xdmf);
  for (const char* name : { "outer.pvd", "inner.pvtu", "parts/0.vtu", "with blank.vtu" })
  {
    EXPECT_EQ(files.FindReplaced(this->At(name)), outer) << name;
  }
  EXPECT_EQ(files.FindReplaced(this->At("data.h5")), xdmf);
  this->Make("other.vtu");
  EXPECT_EQ(files.FindReplaced(this->At("other.vtu")), "");
}

//------------------------------------------------------------------------------
// Also of many files: a series, and a list of blocks.
TEST_F(InputFilesTest, AnswerForManyTargets)
{
  constexpr int count = 3000;
  InputFiles files;
  std::string names;
  std::vector<std::string> targets, inputs;
  for (int i = 0; i < count; ++i)
  {
    const std::string name = std::to_string(i) + ".vtu";
    names += "<DataSet file=\"blocks/" + name + "\"/>\n";
    targets.push_back(this->Make("series/" + name));
    files.Add(targets.back());
    targets.push_back(this->Make("blocks/" + name));
    targets.push_back(this->Make("other/" + name));
  }
  const std::string list = this->Make("blocks.vtm", names);
  files.Add(list);
  for (int i = 0; i < count; ++i)
  {
    inputs.insert(inputs.end(), { targets[3 * static_cast<std::size_t>(i)], list, "" });
  }
  EXPECT_EQ(files.FindReplaced(targets), inputs);
}

//------------------------------------------------------------------------------
TEST_F(InputFilesTest, IncludeWhatDecksInclude)
{
  InputFiles files;
  std::string itself;
  for (int label = 0; label < 1000; ++label)
  {
    itself += "/INPUT,deck,dat,,:label\n"; // continues at a label of the same deck
  }
  const std::string deck =
    this->Make("deck.dat", "/PREP7\n /input,nodes,inp\n/INPUT,'all',,parts\n" + itself);
  files.Add(deck);
  for (const char* name : { "nodes.inp", "parts/all", "parts/more.cdb" })
  {
    EXPECT_EQ(files.FindReplaced(this->At(name)), "") << name;
    this->Make(
      name, fs::path(name).filename() == "all" ? "/INPUT,more.cdb\n/INPUT,deck,dat,..\n" : "");
    EXPECT_EQ(files.FindReplaced(this->At(name)), deck) << name;
  }
  EXPECT_EQ(files.FindReplaced(this->Make("parts/nodes.inp")), "");
}

//------------------------------------------------------------------------------
TEST_F(InputFilesTest, IncludeTheCaseOfOpenFOAM)
{
  const std::string foam = this->Make("case/a.foam");
  InputFiles files;
  files.Add(foam);
  for (const char* name :
    { "case/constant/polyMesh/points", "case/0.5/U", "case/1e-05/p", "case/system/controlDict",
      "case/processor3/constant/polyMesh/faces", "case/processor3/0/U" })
  {
    EXPECT_EQ(files.FindReplaced(this->Make(name)), foam) << name;
  }
  for (const char* name : { "case/constant/polyMesh/sets/bad", "case/report/summary.json",
         "case/log.checkMesh", "elsewhere/0/U", "case/processor3/sets" })
  {
    EXPECT_EQ(files.FindReplaced(this->Make(name)), "") << name;
  }
}

//------------------------------------------------------------------------------
TEST_F(InputFilesTest, IncludePiecesOfExodus)
{
  const std::string first = this->Make("can.e.4.0");
  InputFiles files;
  files.Add(first);
  EXPECT_EQ(files.FindReplaced(this->Make("can.e.4.3")), first);
  EXPECT_EQ(files.FindReplaced(this->Make("can.e.8.3")), "");
  EXPECT_EQ(files.FindReplaced(this->Make("can.e")), "");
  EXPECT_EQ(files.FindReplaced(this->Make("other/can.e.4.1")), "");
}

//------------------------------------------------------------------------------
TEST_F(InputFilesTest, AreNotReplacedByOutputFiles)
{
  const std::string path = this->Make("a.visf", "mesh");
  InputFiles files;
  files.Add(path);
  {
    const InputFiles::Protection protection(files);
    OutputFile file(path);
    file.Write("x");
    EXPECT_FALSE(file.Commit());
    EXPECT_NE(file.GetError().Message.find("was read from this file"), std::string::npos);
  }
  std::string text;
  std::ifstream(path) >> text;
  EXPECT_EQ(text, "mesh");
  OutputFile file(path);
  file.Write("x");
  EXPECT_TRUE(file.Commit());
}
