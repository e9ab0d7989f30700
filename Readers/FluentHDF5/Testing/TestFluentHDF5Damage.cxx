// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What the reader reports about Fluent files in HDF5 with wrong numbers, missing objects, and data
// that are not in the file.
#include "FluentHDF5Samples.h"

#include "Sanitized.h"
#include "vtkErrorCode.h"

#include <random>

#if defined(__linux__)
#include <iostream>
#include <sys/resource.h>
#include <sys/wait.h>
#endif

using namespace camaron;
using namespace camaron::testing;

namespace
{
using Change = std::function<void(const ContainerWriting&)>;

// Two cells, of the first of which all faces are given.
const std::string& GetSample()
{
  static const std::string bytes = EncodeContainer(MakeMixed(1));
  return bytes;
}

//------------------------------------------------------------------------------
/// Whether there is one error, about this place in the file, with this code.
void ExpectError(const Change& change, unsigned long code, const std::string& message)
{
  const Result result = ReadContainer(ChangeContainer(GetSample(), change));
  ASSERT_TRUE(result.IsProperError()) << message;
  EXPECT_EQ(result.ErrorCode, code) << result.Errors[0];
  EXPECT_NE(result.Errors[0].find("test.msh.h5: " + message), std::string::npos)
    << result.Errors[0] << "\nexpected: " << message;
}

//------------------------------------------------------------------------------
Change Set(const std::string& path, std::size_t index, long long value)
{
  return [=](const ContainerWriting& writing) { writing.SetEntry(path, index, value); };
}
Change SetNumber(const std::string& path, const char* name, long long value)
{
  return [=](const ContainerWriting& writing) { writing.Number(path, name, value); };
}
Change Remove(const std::string& path)
{
  return [=](const ContainerWriting& writing) { writing.Remove(path); };
}

const unsigned long Format = vtkErrorCode::FileFormatError;
const unsigned long End = vtkErrorCode::PrematureEndOfFileError;
}

//------------------------------------------------------------------------------
// If this fails, wrong ids lead out of arrays, or users do not learn where they are.
TEST(FluentHDF5Damage, Ids)
{
  ExpectError(Set("meshes/1/faces/nodes/1/nodes", 17, 15), Format,
    "meshes/1/faces/nodes/1/nodes[17]: expected a node of face 5 from 1 to 14, found 15");
  ExpectError(Set("meshes/1/faces/nodes/1/nodes", 0, 0), Format,
    "meshes/1/faces/nodes/1/nodes[0]: expected a node of face 1 from 1 to 14, found 0");
  ExpectError(Set("meshes/1/faces/nodes/1/nodes", 0, 4000000000), Format,
    "meshes/1/faces/nodes/1/nodes[0]: expected a node of face 1 from 1 to 14, found ");
  ExpectError(Set("meshes/1/faces/c0/1", 3, 6), Format,
    "meshes/1/faces/c0/1[3]: expected a cell of face 4 from 0 to 5, found 6");
  ExpectError(Set("meshes/1/faces/c1/1", 2, 4294967295), Format,
    "meshes/1/faces/c1/1[2]: expected a cell of face 3 from 0 to 5, found -1");
  ExpectError(Set("meshes/1/cells/ctype/1/cell-types", 4, 8), Format,
    "meshes/1/cells/ctype/1/cell-types[4]: expected the type of cell 5 from 0 to 7, found 8");
  ExpectError(
    [](const ContainerWriting& writing)
    {
      const std::string path = "meshes/1/faces/tree/1";
      writing.Integers(path + "/nkids", { 2 }, H5T_STD_I16LE);
      writing.Integers(path + "/kids", { 1, 22 }, H5T_STD_U32LE);
      writing.Number(path, "minId", 21);
      writing.Number(path, "maxId", 21);
    },
    Format, "meshes/1/faces/tree/1/kids[1]: expected a part from 1 to 21, found 22");
  ExpectError(Set("meshes/1/faces/zoneTopology/id", 1, 0), Format,
    "meshes/1/faces/zoneTopology/id[1]: expected a zone id from 1 to 2147483646, found 0");
}

//------------------------------------------------------------------------------
// If this fails, sections with the wrong ids move data to other elements.
TEST(FluentHDF5Damage, SectionsAndZones)
{
  ExpectError(SetNumber("meshes/1/faces/c0/1", "minId", 2), Format,
    "meshes/1/faces/c0/1: expected 20 entries, as minId and maxId say, found 21");
  ExpectError(SetNumber("meshes/1/faces/nodes/1", "maxId", 1LL << 40), Format,
    "meshes/1/faces/nodes/1/nnodes: expected 1099511627776 entries");
  ExpectError(SetNumber("meshes/1/faces/nodes", "nSections", 2), Format,
    "meshes/1/faces/nodes: expected 2 sections, as nSections says, found 1");
  ExpectError(SetNumber("meshes/1/faces/zoneTopology", "nZones", 9), Format,
    "meshes/1/faces/zoneTopology: expected 9 zones, as nZones says, found 2");
  ExpectError(Set("meshes/1/faces/zoneTopology/minId", 1, 3), Format,
    "meshes/1/faces/zoneTopology: expected faces from 5 in the next section, found 3 to 21");
  ExpectError(Set("meshes/1/faces/zoneTopology/minId", 1, 6), Format,
    "meshes/1/faces/zoneTopology: expected faces from 5 in the next section, found 6 to 21");
  ExpectError(Set("meshes/1/faces/zoneTopology/maxId", 1, 16), End,
    "meshes/1/faces/zoneTopology: expected faces up to 21 in its sections, found 16");
  ExpectError(Set("meshes/1/cells/zoneTopology/maxId", 2, 500), Format,
    "meshes/1/cells/zoneTopology: expected cells up to 5, found 500");
  ExpectError([](const ContainerWriting& writing)
    { writing.Text("meshes/1/faces/zoneTopology/name", "inside"); }, Format,
    "meshes/1/faces/zoneTopology/name: expected 2 names of zones, found 1");
  ExpectError(
    [](const ContainerWriting& writing)
    {
      writing.Integers("meshes/1/faces/c1/1", { 1, 2 }, H5T_STD_U32LE);
      writing.Number("meshes/1/faces/c1/1", "minId", 3);
      writing.Number("meshes/1/faces/c1/1", "maxId", 4);
    },
    End,
    "meshes/1/faces: expected second cells (c1) of the interior faces 1 to 4, found none for some");
}

//------------------------------------------------------------------------------
// If this fails, numbers that do not fit together cause reading beyond the data.
TEST(FluentHDF5Damage, Counts)
{
  ExpectError(
    Set("meshes/1/faces/nodes/1/nnodes", 0, 5), Format, "meshes/1/faces/nodes/1/nodes: expected ");
  ExpectError(Set("meshes/1/faces/nodes/1/nnodes", 3, -1), Format,
    "meshes/1/faces/nodes/1/nnodes[3]: expected a number of nodes, found -1");
  ExpectError(SetNumber("meshes/1", "faceCount", 22), End,
    "meshes/1/faces/zoneTopology: expected faces up to 22 in its sections, found 21");
  ExpectError(SetNumber("meshes/1", "nodeCount", 13), Format,
    "meshes/1/nodes/coords: expected nodes up to 13, found 14");
  ExpectError(SetNumber("meshes/1", "cellCount", 1LL << 40), Format,
    "meshes/1: expected the attribute cellCount from 0 to 2147483647, found 1099511627776");
  ExpectError(SetNumber("meshes/1", "cellCount", -1), Format,
    "meshes/1: expected the attribute cellCount from 0 to 2147483647, found -1");
  ExpectError(SetNumber("meshes/1", "dimension", 4), Format,
    "meshes/1: expected the attribute dimension from 2 to 3, found 4");
  ExpectError(SetNumber("meshes/1", "dimension", 2), Format,
    "meshes/1/nodes/coords/1: expected rows of 2 values, found 3");
  ExpectError(SetNumber("meshes/1/cells/ctype/1", "elementType", 8), Format,
    "meshes/1/cells/ctype/1: expected the attribute elementType from 0 to 7, found 8");
}

//------------------------------------------------------------------------------
// If this fails, a file without some of its parts crashes the reader, or its message does not name
// them.
TEST(FluentHDF5Damage, MissingObjects)
{
  for (const char* path : { "meshes/1", "meshes/1/nodes", "meshes/1/nodes/coords", "meshes/1/cells",
         "meshes/1/cells/zoneTopology", "meshes/1/cells/zoneTopology/maxId",
         "meshes/1/cells/ctype/1/cell-types", "meshes/1/faces", "meshes/1/faces/nodes",
         "meshes/1/faces/nodes/1/nnodes", "meshes/1/faces/nodes/1/nodes", "meshes/1/faces/c0",
         "meshes/1/faces/zoneTopology/id" })
  {
    ExpectError(
      Remove(path), End, std::string(path) + ": expected a group or data set, found none");
  }
  ExpectError(Remove("meshes"), vtkErrorCode::UnrecognizedFileTypeError,
    "expected a Fluent mesh in the group meshes, found another content");
  ExpectError(
    [](const ContainerWriting& writing)
    {
      writing.Remove("meshes");
      writing.Group("results/1");
    },
    vtkErrorCode::UnrecognizedFileTypeError,
    "expected a Fluent mesh in the group meshes, found results only");
  ExpectError(
    [](const ContainerWriting& writing)
    {
      const HDF5Id object(H5Oopen(writing.GetFile(), "meshes/1", H5P_DEFAULT));
      H5Adelete(object, "nodeCount");
    },
    Format, "meshes/1: expected the attribute nodeCount, found none");
}

//------------------------------------------------------------------------------
// If this fails, data of the wrong type are taken for numbers.
TEST(FluentHDF5Damage, Types)
{
  ExpectError([](const ContainerWriting& writing)
    { writing.Text("meshes/1/faces/zoneTopology/minId", "1;5"); }, Format,
    "meshes/1/faces/zoneTopology/minId: expected 2 entries, found 1");
  ExpectError(
    [](const ContainerWriting& writing)
    {
      writing.Data("meshes/1/faces/zoneTopology/minId", std::vector<double>{ 1, 5 }, H5T_IEEE_F64LE,
        H5T_NATIVE_DOUBLE);
    },
    Format, "meshes/1/faces/zoneTopology/minId: expected a data set of integers");
  ExpectError(
    [](const ContainerWriting& writing)
    {
      writing.Integers("meshes/1/nodes/coords/1", std::vector<long long>(42), H5T_STD_I32LE, 3);
      writing.Number("meshes/1/nodes/coords/1", "minId", 1);
      writing.Number("meshes/1/nodes/coords/1", "maxId", 14);
    },
    Format, "meshes/1/nodes/coords/1: expected a data set of reals");
  ExpectError(
    [](const ContainerWriting& writing)
    {
      writing.Integers("meshes/1/faces/c0/1", std::vector<long long>(42), H5T_STD_U32LE, 2);
      writing.Number("meshes/1/faces/c0/1", "minId", 1);
      writing.Number("meshes/1/faces/c0/1", "maxId", 21);
    },
    Format, "meshes/1/faces/c0/1: expected rows of 1 value, found 2");
  ExpectError(
    [](const ContainerWriting& writing)
    {
      writing.Remove("meshes/1/faces/c0");
      writing.Integers("meshes/1/faces/c0", { 1 }, H5T_STD_I32LE);
    },
    Format, "meshes/1/faces/c0: expected a group, found a data set");
  ExpectError([](const ContainerWriting& writing)
    { writing.Integers("meshes/1/faces/zoneTopology/name", { 1 }, H5T_STD_I32LE); }, Format,
    "meshes/1/faces/zoneTopology/name: expected one string, found something else");
}

//------------------------------------------------------------------------------
// If this fails, users learn that the type of a cell is wrong, but not which face is the reason.
TEST(FluentHDF5Damage, CellsOfFaces)
{
  struct Case
  {
    std::size_t Face;
    int Cells[2];
    const char* Warning;
    const char* Place;
  };
  const Case cases[] = {
    { 2, { 0, -1 }, "1 face of interior zones without the second cell (c1): face 3",
      " (meshes/1/faces/c1/1[2])" },
    { 1, { -1, 2 }, "1 face of interior zones without the first cell (c0): face 2",
      " (meshes/1/faces/c0/1[1])" },
    { 0, { 1, 1 }, "1 face with the same cell on both sides (c0 and c1): face 1",
      " (meshes/1/faces/c1/1[0])" },
  };
  for (const Case& one : cases)
  {
    FluentSample mesh = MakeMixed(1);
    mesh.Faces[one.Face].Zone = 3; // also if it is like one of the boundary now
    std::copy_n(one.Cells, 2, mesh.Faces[one.Face].Cells);
    const Result text = ReadBytes(Encode(mesh)), container = ReadContainer(EncodeContainer(mesh));
    ASSERT_FALSE(text.Warnings.empty()) << one.Warning;
    ASSERT_EQ(text.Warnings.size(), container.Warnings.size()) << one.Warning;
    EXPECT_NE(text.Warnings[0].find(one.Warning), std::string::npos) << text.Warnings[0];
    EXPECT_NE(container.Warnings[0].find(std::string(one.Warning) + one.Place), std::string::npos)
      << container.Warnings[0];
    long pieces = 0; // that say it
    for (int piece = 0; piece < 3; ++piece)
    {
      const Result part = ReadContainer(EncodeContainer(mesh), piece, 3, 1);
      pieces += std::count_if(part.Warnings.begin(), part.Warnings.end(),
        [&](const auto& warning) { return warning.find(one.Warning) != std::string::npos; });
    }
    EXPECT_EQ(pieces, 1) << one.Warning;
  }
  // A face at the boundary in an interior zone fits the types of its cell.
  FluentSample mesh = MakeMixed(1);
  const auto face = std::find_if(mesh.Faces.begin(), mesh.Faces.end(),
    [](const FluentSample::Face& one) { return one.Cells[1] < 0; });
  face->Zone = 3;
  const Result text = ReadBytes(Encode(mesh));
  ASSERT_EQ(text.Warnings.size(), 1u);
  EXPECT_NE(text.Warnings[0].find("1 face of interior zones without the second cell (c1): face "),
    std::string::npos)
    << text.Warnings[0];
}

//------------------------------------------------------------------------------
// If this fails, a file makes ParaView read other files or load libraries, or its links go in
// circles.
TEST(FluentHDF5Damage, DataElsewhere)
{
  const unsigned long code = vtkErrorCode::FileFormatError;
  const auto link = [](const char* path, bool isExternal)
  {
    return [=](const ContainerWriting& writing)
    {
      writing.Remove(path);
      isExternal
        ? H5Lcreate_external("other.h5", "/", writing.GetFile(), path, H5P_DEFAULT, H5P_DEFAULT)
        : H5Lcreate_soft("/meshes/1", writing.GetFile(), path, H5P_DEFAULT, H5P_DEFAULT);
    };
  };
  for (const char* path : { "meshes/1", "meshes/1/faces/c0/1", "meshes/1/faces/nodes/1" })
  {
    for (const bool isExternal : { true, false })
    {
      ExpectError(link(path, isExternal), code,
        std::string(path) + ": expected an object in this place of the file, found a link");
    }
  }
  const auto create = [](const std::function<void(std::int64_t)>& setUp)
  {
    return [setUp](const ContainerWriting& writing)
    {
      writing.Remove("meshes/1/faces/c0/1");
      const hsize_t size = 21;
      const HDF5Id space(H5Screate_simple(1, &size, nullptr));
      const HDF5Id properties(H5Pcreate(H5P_DATASET_CREATE));
      setUp(properties);
      const HDF5Id data = ContainerWriting::Check(H5Dcreate2(writing.GetFile(),
        "meshes/1/faces/c0/1", H5T_STD_U32LE, space, H5P_DEFAULT, properties, H5P_DEFAULT));
      writing.Number("meshes/1/faces/c0/1", "minId", 1);
      writing.Number("meshes/1/faces/c0/1", "maxId", 21);
    };
  };
  ExpectError(
    create([](std::int64_t properties) { H5Pset_external(properties, "/etc/passwd", 0, 84); }),
    code, "meshes/1/faces/c0/1: expected data in this file, found data that are elsewhere");
  ExpectError(create(
                [](std::int64_t properties)
                {
                  const hsize_t size = 21;
                  const HDF5Id space(H5Screate_simple(1, &size, nullptr));
                  H5Pset_virtual(properties, space, "other.h5", "data", space);
                }),
    code, "meshes/1/faces/c0/1: expected data in this file, found data that are elsewhere");
  ExpectError(create(
                [](std::int64_t properties)
                {
                  constexpr H5Z_filter_t Foreign = 32015;
                  const hsize_t chunk = 21;
                  H5Pset_chunk(properties, 1, &chunk);
                  H5Pset_filter(properties, Foreign, H5Z_FLAG_OPTIONAL, 0, nullptr);
                }),
    code, "meshes/1/faces/c0/1: expected filters that are part of HDF5, found filter 32015");
}

//------------------------------------------------------------------------------
// If this fails, a small file takes all memory: data sets with many values that are not in it.
TEST(FluentHDF5Damage, Sizes)
{
  const auto create = [](hsize_t size, hsize_t chunk)
  {
    return [=](const ContainerWriting& writing)
    {
      writing.Remove("meshes/1/faces/nodes/1/nodes");
      const HDF5Id space(H5Screate_simple(1, &size, nullptr));
      const HDF5Id properties(H5Pcreate(H5P_DATASET_CREATE));
      if (chunk > 0)
      {
        H5Pset_chunk(properties, 1, &chunk);
        H5Pset_deflate(properties, 9);
      }
      const HDF5Id data =
        ContainerWriting::Check(H5Dcreate2(writing.GetFile(), "meshes/1/faces/nodes/1/nodes",
          H5T_STD_U32LE, space, H5P_DEFAULT, properties, H5P_DEFAULT));
    };
  };
  const std::string place = "meshes/1/faces/nodes/1/nodes: expected ";
  ExpectError(create(hsize_t(1) << 40, 0), End, place + "4398046511104 bytes of data, found ");
  ExpectError(
    create(hsize_t(1) << 40, 1 << 20), End, place + "4398046511104 bytes of data, found ");
  ExpectError(create(hsize_t(1) << 62, 1 << 20), End, place + "more than 1e15 bytes of data");
  ExpectError(create(64, 0), End, place + "256 bytes of data, found 0 bytes in the file");
  ExpectError(
    [](const ContainerWriting& writing)
    {
      // What deflate makes 1000 times smaller.
      ContainerLayout layout;
      layout.ChunkSize = 1 << 22;
      writing.Integers(
        "meshes/1/faces/nodes/1/nodes", std::vector<long long>(1 << 24), H5T_STD_U64LE);
    },
    Format, "meshes/1/faces/nodes/1/nodes: expected data sets that are together at most 100 times");
}

//------------------------------------------------------------------------------
// If this fails, files with a wrong number somewhere crash the reader, or it shows half a mesh.
TEST(FluentHDF5Damage, AnyEntry)
{
  constexpr int Trials = 1000;
  const std::vector<std::string> paths = { "faces/nodes/1/nnodes", "faces/nodes/1/nodes",
    "faces/c0/1", "faces/c1/1", "faces/zoneTopology/id", "faces/zoneTopology/minId",
    "faces/zoneTopology/maxId", "faces/zoneTopology/zoneType", "cells/zoneTopology/id",
    "cells/zoneTopology/minId", "cells/zoneTopology/maxId", "cells/zoneTopology/zoneType",
    "cells/ctype/1/cell-types" };
  const std::vector<std::pair<std::string, const char*>> numbers = { { "", "dimension" },
    { "", "nodeCount" }, { "", "faceCount" }, { "", "cellCount" }, { "/nodes/coords/1", "minId" },
    { "/nodes/coords/1", "maxId" }, { "/faces/nodes/1", "minId" }, { "/faces/nodes/1", "maxId" },
    { "/faces/c0/1", "minId" }, { "/faces/c1/1", "maxId" }, { "/cells/ctype/1", "minId" },
    { "/cells/ctype/1", "maxId" }, { "/cells/ctype/1", "elementType" } };
  const long long values[] = { 0, 1, 2, 3, 4, 5, 7, 8, 21, 22, -1, 31, 32, 255, 32767, 2147483647,
    2147483648, 4294967295, 4294967296, -2147483648LL, 9223372036854775807LL };
  std::mt19937 random(5);
  int good = 0;
  for (int trial = 0; trial < Trials; ++trial)
  {
    const std::string bytes = ChangeContainer(GetSample(),
      [&](const ContainerWriting& writing)
      {
        for (int change = 1 + trial % 2; change > 0; --change)
        {
          const long long value = values[random() % std::size(values)];
          const std::size_t which = random() % (paths.size() + numbers.size());
          if (which < paths.size())
          {
            const std::string path = "meshes/1/" + paths[which];
            writing.SetEntry(path, random() % writing.Read(path).size(), value);
          }
          else
          {
            const auto& number = numbers[which - paths.size()];
            writing.Number("meshes/1" + number.first, number.second, value);
          }
        }
      });
    for (const int pieces : { 1, 2 })
    {
      const Result result = ReadContainer(bytes, pieces - 1, pieces, pieces - 1);
      good += result.Errors.empty();
      EXPECT_TRUE(result.Errors.empty() || result.IsProperError()) << trial;
    }
  }
  EXPECT_GT(good, Trials / 20);
  EXPECT_LT(good, Trials);
}

#if defined(__linux__)
namespace
{
//------------------------------------------------------------------------------
/// A file with some wrong or missing bytes, always the same for a number.
std::string GetWithWrongBytes(std::string bytes, unsigned int trial)
{
  std::mt19937 random(trial);
  for (unsigned int change = 1 + trial % 3; change > 0; --change)
  {
    const std::size_t at = random() % bytes.size();
    if (random() % 4 == 0)
    {
      bytes.erase(at, 1 + random() % 9);
    }
    else
    {
      bytes[at] = static_cast<char>(random());
    }
  }
  return bytes;
}

//------------------------------------------------------------------------------
unsigned int ReadNumber(const std::string& path)
{
  unsigned int number = 0;
  std::ifstream stream(path);
  stream >> number;
  return number;
}
}

//------------------------------------------------------------------------------
// If this fails, a file with wrong bytes shows half a mesh, or an error without a message. The
// library reads these bytes, in another process: what it does with them is in the README.
TEST(FluentHDF5Damage, AnyByte)
{
  if (IsSanitized)
  {
    GTEST_SKIP() << "a sanitizer ends the process where the library requests much memory";
  }
  constexpr unsigned int Trials = 1000;
  constexpr const char* Variable = "CAMARON_HDF5_TRIAL"; // a file with the number of a trial
  if (const char* const place = std::getenv(Variable))
  {
    constexpr rlim_t Memory = rlim_t(8) << 30, Seconds = 60;
    const rlimit memory = { Memory, Memory }, seconds = { Seconds, Seconds };
    setrlimit(RLIMIT_AS, &memory);
    setrlimit(RLIMIT_CPU, &seconds);
    for (unsigned int trial = ReadNumber(place); trial < Trials; ++trial)
    {
      std::ofstream(place) << trial + 1;
      const int pieces = 1 + static_cast<int>(trial % 2);
      const Result result =
        ReadContainer(GetWithWrongBytes(GetSample(), trial), pieces - 1, pieces);
      EXPECT_TRUE(result.Errors.empty() || result.IsProperError()) << "trial " << trial;
      static const std::string results = EncodeResults(5);
      const Result data = ReadResults(GetSample(), GetWithWrongBytes(results, trial),
        { "SV_P", "SV_Y", "SV_VOF-phase_1" }, pieces - 1, pieces);
      EXPECT_TRUE(data.Errors.empty() || data.IsProperError()) << "data of trial " << trial;
    }
    return;
  }
  constexpr int MostEnds = 100; // of processes; more would take too long
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  const File place("0", "trial");
  int ends = 0;
  unsigned int trial = 0;
  for (; trial < Trials && ends < MostEnds; trial = ReadNumber(place.Path))
  {
    const int status = std::system((std::string(Variable) + "='" + place.Path + "' '" + program +
      "' --gtest_filter=FluentHDF5Damage.AnyByte")
        .c_str());
    constexpr int Failed = 1; // tests
    ASSERT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) == Failed) << "see above";
    ends += status != 0;
  }
  std::cout << "the HDF5 library ended " << ends << " of " << trial << " readings\n";
}
#endif
