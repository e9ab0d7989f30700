// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// PLY: values and lists of every type, in text and binary.
#include "PLYSamples.h"

using namespace camaron;
using namespace camaron::testing;

namespace
{
constexpr const char* IntegerTypes[] = { "char", "uchar", "short", "ushort", "int", "uint", "int64",
  "uint64" };
}

//------------------------------------------------------------------------------
// If this fails, values of some type are misread or change their type.
TEST(PolygonPLYTypes, KeepsTheTypesOfAllProperties)
{
  const struct
  {
    const char* Name;
    const char* Alias;
    int Type;
    double Least, Greatest;
  } types[] = { { "char", "int8", VTK_SIGNED_CHAR, -128, 127 },
    { "uchar", "uint8", VTK_UNSIGNED_CHAR, 0, 255 }, { "short", "int16", VTK_SHORT, -32768, 32767 },
    { "ushort", "uint16", VTK_UNSIGNED_SHORT, 0, 65535 },
    { "int", "int32", VTK_INT, -2147483648., 2147483647 },
    { "uint", "uint32", VTK_UNSIGNED_INT, 0, 4294967295. },
    { "int64", "int64", VTK_TYPE_INT64, -9007199254740992., 9007199254740992. },
    { "uint64", "uint64", VTK_TYPE_UINT64, 0, 9007199254740992. },
    { "float", "float32", VTK_FLOAT, -1.5f, 3.25e30f },
    { "double", "float64", VTK_DOUBLE, -0.1, 1e300 } };
  for (const char* format : { "ascii", "binary_little_endian", "binary_big_endian" })
  {
    for (const bool alias : { false, true })
    {
      Sample sample;
      Element& vertices = sample.AddElement("vertex");
      vertices.Add("float", "x").Add("float", "y").Add("float", "z");
      for (const auto& type : types)
      {
        vertices.Add(alias ? type.Alias : type.Name, std::string("a_") + type.Name);
      }
      vertices.Rows = { { { 0 }, { 1 }, { 2 } }, { { 3 }, { 4 }, { 5 } } };
      for (const auto& type : types)
      {
        vertices.Rows[0].push_back({ type.Least });
        vertices.Rows[1].push_back({ type.Greatest });
      }
      const Result result = ReadBytes(sample.Encode(format));
      ASSERT_TRUE(result.Errors.empty()) << format << ": " << result.Errors[0];
      for (const auto& type : types)
      {
        vtkDataArray* const array =
          result.Grid->GetPointData()->GetArray((std::string("a_") + type.Name).c_str());
        ASSERT_NE(array, nullptr) << type.Name;
        EXPECT_EQ(array->GetDataType(), type.Type) << type.Name;
        EXPECT_EQ(array->GetTuple1(0), type.Least) << type.Name;
        EXPECT_EQ(array->GetTuple1(1), type.Greatest) << type.Name;
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, 64-bit integers in text differ from those in binary files.
TEST(PolygonPLYTypes, TextHasTheWholeRangeOfIntegers)
{
  const auto read = [](const std::string& first, const std::string& second)
  {
    return ReadBytes(
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nproperty int64 id\nproperty uint64 uid\nend_header\n0 0 0 " +
      first + " " + second + "\n");
  };
  for (const std::string sign : { "", "+" })
  {
    const Result result = read("-9223372036854775808", sign + "18446744073709551615");
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    vtkPointData* const data = result.Grid->GetPointData();
    EXPECT_EQ(*static_cast<vtkTypeInt64*>(data->GetArray("id")->GetVoidPointer(0)), INT64_MIN);
    EXPECT_EQ(*static_cast<vtkTypeUInt64*>(data->GetArray("uid")->GetVoidPointer(0)), UINT64_MAX);
  }
  for (const char* wrong :
    { "18446744073709551616", "-1", "-9223372036854775809", "1.5", "+", "1x" })
  {
    const Result result = read("0", wrong);
    ASSERT_TRUE(result.IsProperError()) << wrong;
    EXPECT_NE(result.Errors[0].find(
                "10: expected 'uid' of 'vertex' (uint64), found '" + std::string(wrong) + "'"),
      std::string::npos)
      << result.Errors[0];
  }
}

//------------------------------------------------------------------------------
// If this fails, a mistake in a header is not reported.
TEST(PolygonPLYTypes, PropertyGivenTwice)
{
  const Result result =
    ReadBytes("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
              "property float x\nend_header\n0 0 0\n");
  ASSERT_FALSE(result.Warnings.empty());
  EXPECT_NE(
    result.Warnings[0].find("'vertex' has the property 'x' more than once"), std::string::npos)
    << result.Warnings[0];
}

//------------------------------------------------------------------------------
// If this fails, lists of some type are read in one encoding and not in another.
TEST(PolygonPLYTypes, ListsOfEveryType)
{
  for (const char* format : Formats)
  {
    for (const std::string count : IntegerTypes)
    {
      for (const std::string item : IntegerTypes)
      {
        const std::string type = "list " + count + " " + item;
        Sample sample;
        sample.AddVertices(5);
        Element& faces = sample.AddElement("face");
        faces.Add(type, "vertex_indices");
        faces.Rows = { { { 0, 1, 2 } }, { { 1, 2, 3, 4 } } };
        Element& strips = sample.AddElement("tristrips");
        strips.Add(type, "vertex_indices");
        const bool isSigned = item[0] != 'u'; // only then, there is -1
        strips.Rows = { { isSigned ? std::vector<double>{ 0, 1, 2, -1, 4, 3, 2 }
                                   : std::vector<double>{ 0, 1, 2, 2, 4, 4, 3, 2 } } };
        const Result result = ReadBytes(sample.Encode(format));
        ASSERT_TRUE(result.Errors.empty()) << format << type << result.Errors[0];
        ASSERT_EQ(result.Grid->GetNumberOfCells(), 4) << format << type;
        EXPECT_EQ(result.Grid->GetCellType(1), VTK_QUAD) << format << type;
        EXPECT_EQ(MeshView(result.Grid).GetCellPoints(3)[0], 4) << format << type;
        // Only strips have breaks, and the largest value of a smaller type is not one.
        for (const double wrong : { -1., item == "char" ? 127. : item == "uchar" ? 254. : 32767. })
        {
          const bool isStrip = wrong > 0;
          (isStrip ? strips : faces).Rows[0][0][0] = wrong;
          const Result refused = ReadBytes(sample.Encode(format));
          (isStrip ? strips : faces).Rows[0][0][0] = 0;
          ASSERT_TRUE(refused.IsProperError()) << format << type;
          EXPECT_NE(refused.Errors[0].find("expected a vertex of"), std::string::npos)
            << refused.Errors[0];
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, faces with real indices vanish, or point to other vertices.
TEST(PolygonPLYTypes, ListsOfRealIds)
{
  for (const char* format : Formats)
  {
    for (const std::string item : { "float", "double" })
    {
      Sample sample;
      sample.AddVertices(5);
      Element& faces = sample.AddElement("face");
      faces.Add("list uchar " + item, "vertex_indices");
      faces.Rows = { { { 0, 1, 2 } }, { { 1, 2, 3, 4 } } };
      Element& strips = sample.AddElement("tristrips");
      strips.Add("list int " + item, "vertex_indices");
      strips.Rows = { { { 0, 1, 2, -1, 4, 3, 2 } } };
      const Result result = ReadBytes(sample.Encode(format));
      ASSERT_TRUE(result.Errors.empty()) << format << item << result.Errors[0];
      ASSERT_EQ(result.Grid->GetNumberOfCells(), 4) << format << item;
      EXPECT_EQ(result.Grid->GetCellType(1), VTK_QUAD) << format << item;
      EXPECT_EQ(MeshView(result.Grid).GetCellPoints(3)[0], 4) << format << item;
      for (const double wrong : { -1., 0.5, 5., 4294967296., 1e30, NaN, Infinity })
      {
        faces.Rows[0][0][0] = wrong;
        const Result refused = ReadBytes(sample.Encode(format));
        ASSERT_TRUE(refused.IsProperError()) << format << item << wrong;
        EXPECT_NE(refused.Errors[0].find("expected a vertex of"), std::string::npos)
          << refused.Errors[0];
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, numbers that are invalid as id or length are accepted, or the message lacks them.
TEST(PolygonPLYTypes, RefusesListsBeyondTheirRange)
{
  const auto read = [](const std::string& type, const std::string& list)
  {
    return ReadBytes("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                     "property float z\nelement tristrips 1\nproperty list " +
      type + " " + type + " vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n" + list + "\n");
  };
  for (const std::string type : { "int64", "uint64" })
  {
    for (const std::string number : { "9223372036854775807", "9223372036854775808",
           "18446744073709551615", "18446744073709551616", "-2", "-9223372036854775809", "1x" })
    {
      const std::string found = "found '" + number + "'";
      const Result length = read(type, number + " 0 1 2");
      ASSERT_TRUE(length.IsProperError()) << type << number;
      EXPECT_NE(length.Errors[0].find("13: expected the length of"), std::string::npos)
        << length.Errors[0];
      EXPECT_NE(length.Errors[0].find(found), std::string::npos) << length.Errors[0];
      const Result id = read(type, "3 0 1 " + number);
      ASSERT_TRUE(id.IsProperError()) << type << number;
      EXPECT_NE(id.Errors[0].find("13: expected a vertex of"), std::string::npos) << id.Errors[0];
      EXPECT_NE(id.Errors[0].find(found), std::string::npos) << id.Errors[0];
    }
  }
}
