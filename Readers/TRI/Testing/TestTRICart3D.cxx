// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Features of Cart3D files only: scalars, and binary Fortran records.
#include "FormatTesting.h"
#include "Intake/Rows/Bytes.h"
#include "vtkTRIReader.h"

#include "vtkErrorCode.h"

#include <cstdint>

using namespace camaron;
using namespace camaron::testing;

namespace
{
Result ReadTRIQ(const std::string& bytes)
{
  return ReadWith<vtkTRIReader>(File(bytes, "test.triq").Path);
}

//------------------------------------------------------------------------------
/// A strip of triangles between points (i, i % 2, 0.1), of which triangle i has component i / 10
/// and scalar k of point i is i + k / 4.
struct Strip
{
  int Triangles;
  bool HasComponents = true;
  int Scalars = 0; ///< per vertex
  int Counted = 0; ///< as declared in the first record, if any
  int GetNumberOfPoints() const { return this->Triangles + 2; }

  std::vector<std::int32_t> GetCounts() const
  {
    std::vector<std::int32_t> counts{ this->GetNumberOfPoints(), this->Triangles };
    if (this->Counted > 0)
    {
      counts.push_back(this->Counted);
    }
    return counts;
  }
  std::vector<double> GetCoordinates() const
  {
    std::vector<double> values;
    for (int i = 0; i < this->GetNumberOfPoints(); ++i)
    {
      values.insert(values.end(), { double(i), double(i % 2), 0.1 });
    }
    return values;
  }
  std::vector<std::int32_t> GetCorners() const
  {
    std::vector<std::int32_t> ids;
    for (int i = 1; i <= this->Triangles; ++i)
    {
      ids.insert(ids.end(), { i, i + 1, i + 2 });
    }
    return ids;
  }
  std::vector<std::int32_t> GetComponents() const
  {
    std::vector<std::int32_t> components;
    for (int i = 0; i < this->Triangles; ++i)
    {
      components.push_back(i / 10);
    }
    return components;
  }
  std::vector<double> GetScalars() const
  {
    std::vector<double> values;
    for (int i = 0; i < this->GetNumberOfPoints(); ++i)
    {
      for (int k = 0; k < this->Scalars; ++k)
      {
        values.push_back(i + k / 4.);
      }
    }
    return values;
  }
};

//------------------------------------------------------------------------------
template <typename Target, typename Value>
std::string MakeRecord(const std::vector<Value>& values, ByteOrder order)
{
  const bool swap = order != GetByteOrder();
  std::string bytes(values.size() * sizeof(Target) + 8, '\0');
  const auto length = static_cast<std::int32_t>(bytes.size() - 8);
  Store(bytes.data(), length, swap);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    Store(bytes.data() + 4 + i * sizeof(Target), static_cast<Target>(values[i]), swap);
  }
  Store(bytes.data() + bytes.size() - 4, length, swap);
  return bytes;
}

//------------------------------------------------------------------------------
template <typename Real>
std::string MakeBinary(const Strip& strip, ByteOrder order)
{
  std::string bytes = MakeRecord<std::int32_t>(strip.GetCounts(), order) +
    MakeRecord<Real>(strip.GetCoordinates(), order) +
    MakeRecord<std::int32_t>(strip.GetCorners(), order);
  if (strip.HasComponents)
  {
    bytes += MakeRecord<std::int32_t>(strip.GetComponents(), order);
  }
  if (strip.Scalars > 0)
  {
    bytes += MakeRecord<Real>(strip.GetScalars(), order);
  }
  return bytes;
}

//------------------------------------------------------------------------------
template <typename Value>
void AppendRows(std::string& text, const std::vector<Value>& values, std::size_t size)
{
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    text += std::to_string(values[i]) + ((i + 1) % size == 0 ? "\n" : " ");
  }
}

//------------------------------------------------------------------------------
/// @param row number of scalars per line
std::string MakeText(const Strip& strip, std::size_t row)
{
  std::string text;
  AppendRows(text, strip.GetCounts(), strip.GetCounts().size());
  AppendRows(text, strip.GetCoordinates(), 3);
  AppendRows(text, strip.GetCorners(), 3);
  if (strip.HasComponents)
  {
    AppendRows(text, strip.GetComponents(), row);
  }
  AppendRows(text, strip.GetScalars(), row);
  return text + "\n";
}

//------------------------------------------------------------------------------
void ExpectStrip(const Result& result, const Strip& strip, int realType, const std::string& name)
{
  ASSERT_TRUE(result.Errors.empty()) << name << ": " << result.Errors[0];
  EXPECT_TRUE(result.Warnings.empty()) << name << ": " << result.Warnings[0];
  vtkUnstructuredGrid* const grid = result.Grid;
  ASSERT_EQ(grid->GetNumberOfPoints(), strip.GetNumberOfPoints()) << name;
  ASSERT_EQ(Count(grid, VTK_TRIANGLE), strip.Triangles) << name;
  EXPECT_EQ(grid->GetPoints()->GetDataType(), realType) << name;
  EXPECT_EQ(grid->GetPoint(7)[0], 7) << name;
  EXPECT_EQ(grid->GetPoint(7)[2], realType == VTK_FLOAT ? 0.1f : 0.1) << name;
  EXPECT_EQ(grid->GetCell(12)->GetPointId(2), 14) << name;
  vtkDataArray* const components = grid->GetCellData()->GetArray("Component");
  ASSERT_EQ(components != nullptr, strip.HasComponents) << name;
  EXPECT_TRUE(!components || components->GetTuple1(12) == 1) << name;
  vtkDataArray* const scalars = grid->GetPointData()->GetArray("Scalars");
  ASSERT_EQ(scalars != nullptr, strip.Scalars > 0) << name;
  if (scalars)
  {
    ASSERT_EQ(scalars->GetNumberOfComponents(), strip.Scalars) << name;
    EXPECT_EQ(scalars->GetDataType(), realType) << name;
    EXPECT_EQ(scalars->GetComponent(13, strip.Scalars - 1), 13 + (strip.Scalars - 1) / 4.) << name;
  }
}

const Strip Strips[] = { { 20, false, 0, 0 }, { 20, true, 0, 0 }, { 20, true, 1, 1 },
  { 20, true, 6, 6 }, { 20, true, 6, 5 } };
}

//------------------------------------------------------------------------------
// If this fails, files of some byte order or precision, or with certain records, are misread.
TEST(TRICart3D, BinaryOfEveryKind)
{
  for (const Strip& strip : Strips)
  {
    for (const ByteOrder order : { ByteOrder::Little, ByteOrder::Big })
    {
      const std::string name =
        std::to_string(strip.Scalars) + (order == ByteOrder::Big ? " big" : " little");
      ExpectStrip(ReadTRIQ(MakeBinary<float>(strip, order)), strip, VTK_FLOAT, name);
      ExpectStrip(ReadTRIQ(MakeBinary<double>(strip, order)), strip, VTK_DOUBLE, name);
    }
  }
}

//------------------------------------------------------------------------------
// Scalars on lines of their own, all of a vertex on one line, or wherever Fortran breaks lines.
TEST(TRICart3D, ScalarsInText)
{
  for (const Strip& strip : Strips)
  {
    for (const std::size_t row : { 1, 2, 6, 7, 1000 })
    {
      ExpectStrip(ReadTRIQ(MakeText(strip, row)), strip, VTK_DOUBLE, std::to_string(row));
    }
  }
}

//------------------------------------------------------------------------------
TEST(TRICart3D, PiecesMakeTheWhole)
{
  const Strip strip{ 100, true, 3, 3 };
  for (const std::string& bytes : { MakeBinary<double>(strip, ByteOrder::Big), MakeText(strip, 2) })
  {
    const File file(bytes, "test.triq");
    ExpectPiecesMakeTheWhole<vtkTRIReader>(file.Path, 3, 0);
    ExpectPiecesMakeTheWhole<vtkTRIReader>(file.Path, 3, 2);
    ExpectPiecesMakeTheWhole<vtkTRIReader>(file.Path, 120, 1);
  }
}

//------------------------------------------------------------------------------
TEST(TRICart3D, RecordsWithoutTrianglesAreACloud)
{
  Strip strip{ 0, false, 2, 2 };
  const Result result = ReadTRIQ(MakeBinary<float>(strip, ByteOrder::Little));
  EXPECT_TRUE(result.IsProperError()); // scalars come after components
  strip.HasComponents = true;
  const Result cloud = ReadTRIQ(MakeBinary<float>(strip, ByteOrder::Little));
  ASSERT_TRUE(cloud.Errors.empty()) << cloud.Errors[0];
  EXPECT_EQ(Count(cloud.Grid, VTK_VERTEX), 2);
  EXPECT_EQ(cloud.Grid->GetPointData()->GetArray("Scalars")->GetNumberOfComponents(), 2);
}

//------------------------------------------------------------------------------
// If this fails, a damaged file is accepted, or its error lacks the position.
TEST(TRICart3D, SaysWhatIsWrongAndWhere)
{
  const Strip strip{ 20, true, 2, 2 };
  const std::string good = MakeBinary<float>(strip, ByteOrder::Little);
  const auto with = [&](std::size_t place, std::int32_t value)
  {
    std::string bytes = good;
    Store(bytes.data() + place, value, ByteOrder::Little != GetByteOrder());
    return bytes;
  };
  const std::size_t coordinates = 20, corners = coordinates + 8 + 22 * 12,
                    components = corners + 8 + 20 * 12, scalars = components + 8 + 20 * 4;
  const struct
  {
    std::string Bytes;
    unsigned long Code;
    std::string Message;
  } cases[] = {
    { with(4, -1), vtkErrorCode::FileFormatError, "byte 4: expected the numbers of vertices" },
    { with(4, 21), vtkErrorCode::FileFormatError,
      "byte 20: expected a record of 252 bytes with the coordinates of the vertices, found 264" },
    { with(4, 2147483647), vtkErrorCode::PrematureEndOfFileError,
      "the coordinates of the vertices, found 264" },
    { with(coordinates, 1000000), vtkErrorCode::PrematureEndOfFileError,
      "the coordinates of the vertices" },
    { with(corners - 4, 7), vtkErrorCode::FileFormatError,
      "the length 264 again at the end of the record" },
    { with(corners, -9), vtkErrorCode::FileFormatError, "at most 2147483647 bytes" },
    { with(corners + 4, 0), vtkErrorCode::FileFormatError,
      "byte " + std::to_string(corners + 4) +
        ": expected a vertex of a triangle from 1 to 22, found 0" },
    { with(corners + 16, 23), vtkErrorCode::FileFormatError, "found 23" },
    { with(corners + 8, INT32_MIN), vtkErrorCode::FileFormatError, "found -2147483648" },
    { with(8, 19), vtkErrorCode::FileFormatError,
      "a record of 228 bytes with the vertices of the triangles" },
    { with(12, 5), vtkErrorCode::PrematureEndOfFileError,
      "a record of 440 bytes with the scalars" },
    { with(12, 0), vtkErrorCode::NoError, "" },
    { good.substr(0, scalars), vtkErrorCode::PrematureEndOfFileError,
      "the scalars of the vertices, found the end" },
    { good.substr(0, good.size() - 1), vtkErrorCode::PrematureEndOfFileError,
      "the length of a record at its end" },
    { "3 1 2\n0 0 0\n1 0 0\n0 1 0\n1 2 3\n1\n1 2 3 4 5\n", vtkErrorCode::PrematureEndOfFileError,
      "test.triq:7: expected the 2 scalars of each of the 3 vertices, found 5 numbers" },
    { "3 1 2\n0 0 0\n1 0 0\n0 1 0\n1 2 3\n1\n1 2 3 4 5 6 7\n", vtkErrorCode::FileFormatError,
      "found 7 numbers" },
    { "3 1 2\n0 0 0\n1 0 0\n0 1 0\n1 2 3\n1\n1 2 3 x 5 6\n", vtkErrorCode::FileFormatError,
      "test.triq:7: expected a scalar of a vertex, found 'x'" },
    { "3 1 2\n0 0 0\n1 0 0\n0 1 0\n1 2 3\n", vtkErrorCode::PrematureEndOfFileError,
      "the component of a triangle" },
    { "3 1 2\n0 0 0\n1 0 0\n0 1 0\n1 2 3\n0.5\n", vtkErrorCode::FileFormatError,
      "the component of a triangle" },
    { "3 1 999999\n0 0 0\n1 0 0\n0 1 0\n1 2 3\n", vtkErrorCode::PrematureEndOfFileError,
      "the number of scalars" },
  };
  for (const auto& wrong : cases)
  {
    const Result result = ReadTRIQ(wrong.Bytes);
    if (wrong.Code == vtkErrorCode::NoError)
    {
      EXPECT_TRUE(result.Errors.empty());
      EXPECT_EQ(result.Warnings.size(), 1u); // more data
      continue;
    }
    ASSERT_TRUE(result.IsProperError()) << wrong.Message;
    EXPECT_EQ(result.ErrorCode, wrong.Code) << result.Errors[0];
    EXPECT_NE(result.Errors[0].find(wrong.Message), std::string::npos) << result.Errors[0] << "\n"
                                                                       << wrong.Message;
  }
}

//------------------------------------------------------------------------------
TEST(TRICart3D, KnowsItsFiles)
{
  vtkNew<vtkTRIReader> reader;
  const auto canRead = [&](const std::string& bytes)
  { return reader->CanReadFile(File(bytes, "test.tri").Path.c_str()); };
  EXPECT_EQ(canRead(MakeBinary<float>(Strips[0], ByteOrder::Big)), 1);
  EXPECT_EQ(canRead(MakeBinary<double>(Strips[4], ByteOrder::Little)), 1);
  EXPECT_EQ(canRead(MakeText(Strips[3], 6)), 1);
  // Without the lengths of Fortran records, and with a record of something else.
  EXPECT_EQ(canRead(MakeBinary<float>(Strips[0], ByteOrder::Big).substr(4)), 0);
  EXPECT_EQ(
    canRead(MakeRecord<std::int32_t>(std::vector<int>{ 1, 2, 3, 4 }, ByteOrder::Little)), 0);
}

//------------------------------------------------------------------------------
// The header of this file counts two scalars in addition to the pressure coefficient.
TEST(TRICart3D, CollectedFile)
{
  const char* const folder = std::getenv("CAMARON_SHARED_DATA");
  const std::string path = std::string(folder ? folder : "") + "/reports/cart3d_scalars.tri";
  if (!folder || !std::filesystem::exists(path))
  {
    GTEST_SKIP() << "CAMARON_SHARED_DATA has no file reports/cart3d_scalars.tri";
  }
  const Result result = ReadWith<vtkTRIReader>(path);
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  vtkDataArray* const scalars = result.Grid->GetPointData()->GetArray("Scalars");
  ASSERT_EQ(scalars->GetNumberOfComponents(), 3);
  EXPECT_EQ(scalars->GetComponent(0, 0), -0.5);
  EXPECT_EQ(scalars->GetComponent(3, 0), 0.3);
  EXPECT_EQ(scalars->GetComponent(3, 2), 2.0);
}
