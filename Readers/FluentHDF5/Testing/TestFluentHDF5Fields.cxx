// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Fields of the data file of a case become cell arrays with the values of their cells; wrong data
// files give one error.
#include "FluentHDF5Samples.h"

#include "vtkErrorCode.h"

#include <cmath>

using namespace camaron;
using namespace camaron::testing;

namespace
{
const std::vector<std::string> All = { "SV_P", "SV_T", "SV_VOF-phase_1", "SV_Y" };

//------------------------------------------------------------------------------
// A chain of squares, of which pieces have some.
FluentSample MakeChain(int cells)
{
  FluentSample mesh;
  mesh.Dimension = 2;
  for (int i = 0; i <= cells; ++i)
  {
    mesh.AddPoint(i, 0);
    mesh.AddPoint(i, 1);
  }
  for (int i = 0; i < cells; ++i)
  {
    mesh.Cells.push_back({ 3, i < cells / 2 ? 2 : 5 });
    mesh.Faces.push_back({ { 2 * i, 2 * i + 2 }, { i, -1 } });
    mesh.Faces.push_back({ { 2 * i + 3, 2 * i + 1 }, { i, -1 } });
    if (i > 0)
    {
      mesh.Faces.push_back({ { 2 * i, 2 * i + 1 }, { i - 1, i } });
    }
  }
  mesh.Faces.push_back({ { 1, 0 }, { 0, -1 } });
  mesh.Faces.push_back({ { 2 * cells, 2 * cells + 1 }, { cells - 1, -1 } });
  return mesh;
}

//------------------------------------------------------------------------------
/// Whether the fields of all cells are those of EncodeResults; the id of a cell of a chain is told
/// by its place.
void ExpectValues(vtkUnstructuredGrid* grid)
{
  vtkCellData* const data = grid->GetCellData();
  for (const std::string& name : All)
  {
    ASSERT_TRUE(data->GetArray(name.c_str())) << name;
  }
  EXPECT_EQ(data->GetArray("SV_P")->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(data->GetArray("SV_T")->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(data->GetArray("SV_Y")->GetNumberOfComponents(), 2);
  int wrong = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    grid->GetCellBounds(cell, bounds);
    const double id = std::floor(bounds[0]) + 1;
    const double t = data->GetArray("SV_T")->GetComponent(cell, 0);
    const bool hasT = id >= 2 && id <= 4;
    wrong += data->GetArray("SV_P")->GetComponent(cell, 0) != 100 + id ||
      data->GetArray("SV_VOF-phase_1")->GetComponent(cell, 0) != -id ||
      data->GetArray("SV_Y")->GetComponent(cell, 0) != 100 + id ||
      data->GetArray("SV_Y")->GetComponent(cell, 1) != 0.5 + id ||
      (hasT ? t != 0.5 + id : !std::isnan(t));
  }
  EXPECT_EQ(wrong, 0);
}

//------------------------------------------------------------------------------
/// Whether there is one error, about this place in the data file.
void ExpectError(const std::vector<std::string>& fields,
  const std::function<void(const ContainerWriting&)>& change, const std::string& message)
{
  static const std::string mesh = EncodeContainer(MakeChain(6)), data = EncodeResults(6);
  const Result result = ReadResults(mesh, ChangeContainer(data, change), fields);
  ASSERT_TRUE(result.IsProperError()) << message;
  EXPECT_NE(result.Errors[0].find("test.dat.h5: " + message), std::string::npos)
    << result.Errors[0] << "\nexpected: " << message;
}
}

//------------------------------------------------------------------------------
// If this fails, cells have the values of other cells, which depends on the division into sections
// and chunks, or on the piece.
TEST(FluentHDF5Fields, Values)
{
  for (const int cells : { 6, 70000 })
  {
    const std::string mesh = EncodeContainer(MakeChain(cells));
    for (const int sections : { 1, 5 })
    {
      ContainerLayout layout;
      layout.Sections = sections;
      layout.ReversesNames = true;
      layout.ChunkSize = cells / 3;
      layout.HasMoreFilters = sections > 1;
      const std::string data = EncodeResults(static_cast<std::size_t>(cells), layout);
      for (const int pieces : { 1, 3 })
      {
        for (int piece = 0; piece < pieces; ++piece)
        {
          const Result result = ReadResults(mesh, data, All, piece, pieces, pieces > 1 ? piece : 0);
          ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
          EXPECT_TRUE(result.Warnings.empty());
          EXPECT_GT(result.Grid->GetNumberOfCells(), 0);
          ExpectValues(result.Grid);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, users do not see the fields of the file, get some that they did not choose, or
// nothing happens when they choose another one.
TEST(FluentHDF5Fields, Choice)
{
  const File mesh(EncodeContainer(MakeChain(6)), "test.cas.h5");
  const File data(EncodeResults(6), "test.dat.h5");
  vtkNew<vtkFluentHDF5Reader> reader;
  reader->SetFileName(mesh.Path.c_str());
  reader->UpdateInformation();
  ASSERT_EQ(reader->GetCellArraySelection()->GetNumberOfArrays(), static_cast<int>(All.size()));
  for (std::size_t i = 0; i < All.size(); ++i)
  {
    EXPECT_EQ(reader->GetCellArraySelection()->GetArrayName(static_cast<int>(i)), All[i]);
    EXPECT_EQ(reader->GetCellArraySelection()->ArrayIsEnabled(All[i].c_str()), 0);
  }
  reader->Update();
  vtkCellData* const arrays = reader->GetOutput()->GetCellData();
  EXPECT_EQ(arrays->GetNumberOfArrays(), 1); // Zone
  reader->GetCellArraySelection()->SetArraySetting("SV_T", 1);
  reader->Update();
  EXPECT_TRUE(arrays->HasArray("SV_T"));
  EXPECT_EQ(arrays->GetNumberOfArrays(), 2);
  reader->GetCellArraySelection()->SetArraySetting("SV_T", 0);
  reader->Update();
  EXPECT_EQ(arrays->GetNumberOfArrays(), 1);

  // Another file, which does not have a chosen field.
  reader->GetCellArraySelection()->SetArraySetting("SV_T", 1);
  const File other(ChangeContainer(EncodeResults(6),
                     [](const ContainerWriting& writing)
                     {
                       writing.Remove("results/1/phase-1/cells/SV_T");
                       writing.Remove("results/1/phase-2");
                     }),
    "other.dat.h5");
  std::vector<std::string> warnings;
  Observe(reader, vtkCommand::WarningEvent, warnings);
  reader->SetDataFile(other.Path.c_str());
  reader->Update();
  EXPECT_EQ(arrays->GetNumberOfArrays(), 1);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("test.cas.h5: other.dat.h5 has no field SV_T"), std::string::npos);
  EXPECT_EQ(reader->GetCellArraySelection()->GetNumberOfArrays(), 3);
}

//------------------------------------------------------------------------------
// If this fails, users do not learn why a mesh has no fields, or get an error although they only
// want the mesh.
TEST(FluentHDF5Fields, NoDataFile)
{
  const std::string mesh = EncodeContainer(MakeChain(6));
  const File file(mesh, "alone.cas.h5");
  const auto read = [&file](const char* field, const std::string& data)
  {
    return ReadWith<vtkFluentHDF5Reader>(file.Path, 0, 1, 0,
      [&](vtkFluentHDF5Reader* reader)
      {
        reader->SetDataFile(data.c_str());
        if (field)
        {
          reader->GetCellArraySelection()->SetArraySetting(field, 1);
        }
      });
  };
  EXPECT_TRUE(read(nullptr, "").Warnings.empty());
  const Result warned = read("SV_P", "");
  EXPECT_TRUE(warned.Errors.empty());
  ASSERT_EQ(warned.Warnings.size(), 1u);
  EXPECT_NE(warned.Warnings[0].find("there is no data file"), std::string::npos);
  EXPECT_TRUE(read(nullptr, file.Path + ".dat.h5").IsProperError());
  const Result swapped = read(nullptr, file.Path);
  ASSERT_TRUE(swapped.IsProperError());
  EXPECT_NE(swapped.Errors[0].find("a mesh only"), std::string::npos) << swapped.Errors[0];
  EXPECT_TRUE(ReadResults(mesh, "damaged", {}).Errors.empty());
  EXPECT_TRUE(ReadResults(mesh, "damaged", { "SV_P" }).IsProperError());
}

//------------------------------------------------------------------------------
// If this fails, a field whose only section has no cells crashes the reader.
TEST(FluentHDF5Fields, WithoutCells)
{
  const std::string data = ChangeContainer(EncodeResults(6),
    [](const ContainerWriting& writing)
    {
      const std::string section = "results/1/phase-1/cells/SV_P/1";
      writing.Data(section, std::vector<double>(), H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE);
      writing.Number(section, "minId", 1);
      writing.Number(section, "maxId", 0);
    });
  const Result result = ReadResults(EncodeContainer(MakeChain(6)), data, { "SV_P" });
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  vtkDataArray* const values = result.Grid->GetCellData()->GetArray("SV_P");
  ASSERT_TRUE(values);
  EXPECT_EQ(values->GetNumberOfTuples(), 6);
  EXPECT_TRUE(std::isnan(values->GetComponent(0, 0)));
}

//------------------------------------------------------------------------------
// If this fails, wrong data files lead out of arrays, need too much memory, or give cells wrong
// values.
TEST(FluentHDF5Fields, Damage)
{
  const std::string field = "results/1/phase-1/cells/SV_P", section = field + "/1";
  const auto setRange = [&section](long long first, long long last)
  {
    return [=](const ContainerWriting& writing)
    {
      writing.Number(section, "minId", first);
      writing.Number(section, "maxId", last);
    };
  };
  const std::vector<std::string> one = { "SV_P" };
  ExpectError(
    one, setRange(1, 5), section + ": expected 5 entries, as minId and maxId say, found 6");
  ExpectError(one, setRange(2, 7), field + ": expected cells up to 6, found 7");
  ExpectError(
    one, setRange(0, 5), field + ": expected cells not before 1 in the next section, found 0");
  ExpectError(one, setRange(-(1LL << 62), 1LL << 62), section + ": expected ");
  ExpectError(
    one, [&](const ContainerWriting& writing) { writing.Number(field, "nSections", 2); },
    field + ": expected 2 sections, as nSections says, found 1");
  const auto addSection = [&](long long first, std::vector<double> values, hsize_t columns)
  {
    return [=](const ContainerWriting& writing)
    {
      const auto rows = static_cast<long long>(values.size() / columns);
      writing.Number(field, "nSections", 2);
      writing.Data(field + "/2", values, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, columns);
      writing.Number(field + "/2", "minId", first);
      writing.Number(field + "/2", "maxId", first + rows - 1);
    };
  };
  ExpectError(one, addSection(6, { 1, 2 }, 1),
    field + ": expected cells not before 7 in the next section, found 6 to 7");
  ExpectError(one, addSection(6, { 1, 2 }, 2), field + "/2: expected rows of 1 value, found 2");
  ExpectError(
    one, [&](const ContainerWriting& writing)
    { writing.Integers(section, { 1, 2, 3, 4, 5, 6 }, H5T_STD_I32LE); },
    section + ": expected the attribute minId, found none");
  ExpectError(
    one,
    [&](const ContainerWriting& writing)
    {
      writing.Integers(section, { 1, 2, 3, 4, 5, 6 }, H5T_STD_I32LE);
      setRange(1, 6)(writing);
    },
    section + ": expected a data set of reals, found something else");
  ExpectError(
    one,
    [&](const ContainerWriting& writing)
    {
      constexpr std::size_t Many = 1 << 22;
      writing.Data(
        section, std::vector<double>(Many), H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, hsize_t(Many));
      setRange(1, 1)(writing);
    },
    section + ": expected data sets that are together at most 100 times as large as the file");
  ExpectError(
    one,
    [&](const ContainerWriting& writing)
    {
      constexpr std::size_t Many = 1 << 16;
      writing.Data(
        section, std::vector<double>(Many), H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, hsize_t(Many));
      setRange(1, 1)(writing);
    },
    field +
      ": expected data sets that are together at most 100 times as large as the file, found "
      "one of 3145728 bytes after others");
}
