// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Fluent files in HDF5 give the same meshes as those in text, whatever their layout.
#include "FluentHDF5Samples.h"

#include "vtk_zlib.h"

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
/// Layouts that differ in everything.
std::vector<ContainerLayout> GetLayouts()
{
  std::vector<ContainerLayout> all(5);
  all[1].Sections = 3;
  all[1].ReversesNames = true;
  all[1].ChunkSize = 2;
  all[2].TrimsSides = true;
  all[2].HasMoreFilters = true;
  all[2].HasZoneTypes = false;
  all[3].Sections = 1000; // one per element
  all[3].TrimsSides = true;
  all[3].HasTypeNames = false;
  all[4].ChunkSize = 5;
  all[4].IsShuffled = true;
  return all;
}

//------------------------------------------------------------------------------
FluentSample MakePolyhedra()
{
  FluentSample mesh = MakeMixed(2);
  for (FluentSample::Cell& cell : mesh.Cells)
  {
    cell.Element = 7;
  }
  return mesh;
}

//------------------------------------------------------------------------------
void ExpectSameAsText(const FluentSample& mesh, const char* what)
{
  const std::string text = Encode(mesh);
  for (const int pieces : { 1, 3 })
  {
    for (int piece = 0; piece < pieces; ++piece)
    {
      const int ghosts = pieces > 1 ? piece : 0;
      const std::string expected =
        Describe<vtkFluentMeshReader>(text, "test.msh", piece, pieces, ghosts);
      for (const ContainerLayout& layout : GetLayouts())
      {
        EXPECT_EQ(expected,
          Describe<vtkFluentHDF5Reader>(
            EncodeContainer(mesh, layout), "test.msh.h5", piece, pieces, ghosts))
          << what << ", piece " << piece << " of " << pieces << ", " << layout.Sections
          << " sections";
      }
    }
  }
}
}

//------------------------------------------------------------------------------
// If this fails, a file in HDF5 shows another mesh, other zones or boundaries than the same mesh in
// text, or this depends on how data are divided into sections and chunks.
TEST(FluentHDF5Reader, SameAsText)
{
  ExpectSameAsText(MakeMixed(3), "mixed");
  ExpectSameAsText(MakePolyhedra(), "polyhedra");
  ExpectSameAsText(MakeFlat(7), "flat");
  FluentSample unknown = MakeMixed(1);
  for (FluentSample::Cell& cell : unknown.Cells)
  {
    cell.Element = 0;
  }
  ExpectSameAsText(unknown, "undeclared");
}

//------------------------------------------------------------------------------
// If this fails, meshes of more than one batch are misread: faces, cells and points of later ones.
TEST(FluentHDF5Reader, ManyBatches)
{
  constexpr int Columns = 6000; // some 60,000 faces
  FluentSample mesh;
  mesh.Dimension = 2;
  for (int i = 0; i <= Columns; ++i)
  {
    mesh.AddPoint(i, 0);
    mesh.AddPoint(i, 1);
  }
  for (int i = 0; i < Columns; ++i)
  {
    mesh.Cells.push_back({ 3, i < Columns / 2 ? 2 : 5 });
    mesh.Faces.push_back({ { 2 * i, 2 * i + 2 }, { i, -1 } });
    mesh.Faces.push_back({ { 2 * i + 3, 2 * i + 1 }, { i, -1 } });
    if (i > 0)
    {
      mesh.Faces.push_back({ { 2 * i, 2 * i + 1 }, { i - 1, i } });
    }
  }
  mesh.Faces.push_back({ { 1, 0 }, { 0, -1 } });
  mesh.Faces.push_back({ { 2 * Columns, 2 * Columns + 1 }, { Columns - 1, -1 } });
  const std::string expected = Describe<vtkFluentMeshReader>(Encode(mesh), "test.msh");
  for (const int sections : { 1, 7 })
  {
    ContainerLayout layout;
    layout.Sections = sections;
    layout.ChunkSize = 1000;
    EXPECT_TRUE(
      expected == Describe<vtkFluentHDF5Reader>(EncodeContainer(mesh, layout), "test.msh.h5"));
  }
}

//------------------------------------------------------------------------------
// If this fails, cells at hanging nodes are not those of the same mesh in text.
TEST(FluentHDF5Reader, HangingNodes)
{
  const auto read = [](auto* reader, const std::string& path)
  {
    reader->SetFileName(path.c_str());
    reader->Update();
    std::ostringstream text;
    for (vtkIdType cell = 0; cell < reader->GetOutput()->GetNumberOfCells(); ++cell)
    {
      text << reader->GetOutput()->GetCellType(cell) << " "
           << reader->GetOutput()->GetCell(cell)->GetNumberOfFaces() << "\n";
    }
    return text.str();
  };
  const File text(MakeHanging(true, 4), "test.msh");
  FluentSample mesh = MakeHangingSample(true, 4);
  const std::string bytes = ChangeContainer(EncodeContainer(mesh),
    [&mesh](const ContainerWriting& writing)
    {
      const auto face = static_cast<long long>(mesh.Faces.size());
      const std::string path = "meshes/1/faces/tree/1";
      writing.Integers(path + "/nkids", { 4 }, H5T_STD_I16LE);
      writing.Integers(path + "/kids", { 1, 2, 3, 4 }, H5T_STD_U32LE);
      writing.Number(path, "minId", face);
      writing.Number(path, "maxId", face);
      // The parent of the refined cells.
      std::vector<long long> types = writing.Read("meshes/1/cells/zoneTopology/zoneType");
      writing.SetEntry("meshes/1/cells/zoneTopology/zoneType", types.size() - 1, 32);
    });
  const File container(bytes, "test.msh.h5");
  vtkNew<vtkFluentMeshReader> textReader;
  vtkNew<vtkFluentHDF5Reader> reader;
  EXPECT_EQ(read(textReader.Get(), text.Path), read(reader.Get(), container.Path));
}

//------------------------------------------------------------------------------
// If this fails, faces of nonconformal interfaces become faces of cells.
TEST(FluentHDF5Reader, NonconformalInterfaces)
{
  FluentSample mesh = MakeMixed(1);
  const auto before = static_cast<long long>(mesh.Faces.size());
  mesh.Faces.push_back({ { 0, 1, 4 }, { 0, 1 }, 20 });
  mesh.Faces.push_back({ { 1, 5, 4 }, { 0, 1 }, 20 });
  const auto describe = [](const std::string& bytes)
  { return Describe<vtkFluentHDF5Reader>(bytes, "test.msh.h5"); };
  mesh.BoundaryTypes[20] = 1012;
  ContainerLayout layout;
  layout.HasTypeNames = false;
  const std::string typed = EncodeContainer(mesh, layout);
  EXPECT_EQ(describe(typed), Describe<vtkFluentMeshReader>(Encode(mesh), "test.msh"));
  // The same through the table, whatever the type of the faces: zone, first and last face.
  mesh.BoundaryTypes[20] = 3;
  const std::string walls = EncodeContainer(mesh);
  for (const hsize_t columns : { 1, 3 })
  {
    const std::string listed = ChangeContainer(walls,
      [&](const ContainerWriting& writing)
      {
        const std::string path = "meshes/1/faces/interface";
        writing.Integers(
          path + "/nciTopology", { 20, before + 1, before + 2 }, H5T_STD_I32LE, columns);
        writing.Number(path, "nData", 3);
      });
    const Result result = ReadContainer(listed), same = ReadContainer(typed);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_EQ(result.Grid->GetCellType(0), VTK_HEXAHEDRON);
    ASSERT_EQ(result.Grid->GetNumberOfCells(), same.Grid->GetNumberOfCells());
    for (vtkIdType cell = 0; cell < same.Grid->GetNumberOfCells(); ++cell)
    {
      EXPECT_EQ(result.Grid->GetCellType(cell), same.Grid->GetCellType(cell));
      EXPECT_EQ(GetFaceSet(result.Grid, cell), GetFaceSet(same.Grid, cell));
    }
  }
  const Result unlisted = ReadContainer(walls);
  EXPECT_NE(unlisted.Grid->GetCellType(0), VTK_HEXAHEDRON);
}

//------------------------------------------------------------------------------
// If this fails, files of programs that write strings of variable length, zones without faces, or a
// separator after the last name are refused.
TEST(FluentHDF5Reader, NamesAndEmptyZones)
{
  const std::string bytes = EncodeContainer(MakeMixed(1));
  const std::string topology = "meshes/1/faces/zoneTopology/";
  for (const char* names : { "inside;skin;nothing;", "inside;skin;nothing", "inside;skin;" })
  {
    for (const long long first : { 0, 1, 22 })
    {
      const Result result = ReadContainer(ChangeContainer(bytes,
        [&](const ContainerWriting& writing)
        {
          const auto append = [&](const char* name, long long value)
          {
            std::vector<long long> values = writing.Read(topology + name);
            values.push_back(value);
            writing.Integers(topology + name, values, H5T_STD_I64LE);
          };
          append("id", 9);
          append("minId", first);
          append("maxId", std::max<long long>(first - 1, 0));
          append("zoneType", 10);
          writing.Number("meshes/1/faces/zoneTopology", "nZones", 3);
          writing.Remove(topology + "name");
          const HDF5Id type(H5Tcopy(H5T_C_S1)), space(H5Screate(H5S_SCALAR));
          H5Tset_size(type, H5T_VARIABLE);
          const HDF5Id data = ContainerWriting::Check(H5Dcreate2(writing.GetFile(),
            (topology + "name").c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
          H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, &names);
        }));
      ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
      vtkFieldData* const fields = result.Grid->GetFieldData();
      auto* const found = vtkStringArray::SafeDownCast(fields->GetAbstractArray("ZoneNames"));
      std::string all;
      for (vtkIdType i = 0; i < found->GetNumberOfValues(); ++i)
      {
        all += found->GetValue(i) + " ";
      }
      const bool isNamed = std::string(names).find("nothing") != std::string::npos;
      EXPECT_NE(all.find(isNamed ? "inside skin nothing" : "inside skin zone-9"), std::string::npos)
        << all;
      EXPECT_EQ(result.Grid->GetCellType(0), VTK_HEXAHEDRON);
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, single precision becomes double, or its values change.
TEST(FluentHDF5Reader, SinglePrecision)
{
  for (const bool isShuffled : { false, true })
  {
    ContainerLayout layout;
    layout.IsSingle = true;
    layout.IsShuffled = isShuffled;
    const Result result = ReadContainer(EncodeContainer(MakeMixed(1), layout));
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_EQ(result.Grid->GetPoints()->GetDataType(), VTK_FLOAT);
    double x[3];
    result.Grid->GetPoint(4, x);
    EXPECT_EQ(x[1], static_cast<double>(1.1f));
  }
}

//------------------------------------------------------------------------------
// If this fails, surface meshes of Fluent Meshing, which have no cells, cannot be opened.
TEST(FluentHDF5Reader, Surfaces)
{
  FluentSample mesh = MakeMixed(1);
  mesh.Cells.clear();
  for (FluentSample::Face& face : mesh.Faces)
  {
    face.Cells[0] = face.Cells[1] = -1;
  }
  const std::string bytes = EncodeContainer(mesh);
  const auto getCells = [](const Result& result)
  {
    std::vector<std::vector<vtkIdType>> cells;
    for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
    {
      cells.push_back(GetSortedPoints(result.Grid, cell));
    }
    return cells;
  };
  const Result expected = ReadBytes(Encode(mesh));
  ASSERT_GT(expected.Grid->GetNumberOfCells(), 10);
  EXPECT_EQ(getCells(expected), getCells(ReadContainer(bytes)));
  const std::string without = ChangeContainer(bytes,
    [](const ContainerWriting& writing)
    {
      for (const char* name : { "meshes/1/faces/c0", "meshes/1/faces/c1", "meshes/1/cells" })
      {
        writing.Remove(name);
      }
    });
  EXPECT_EQ(getCells(expected), getCells(ReadContainer(without)));
}

//------------------------------------------------------------------------------
// If this fails, zones of a surface mesh that are switched off are read, or others are not.
TEST(FluentHDF5Reader, ZonesOfSurfaces)
{
  FluentSample mesh = MakeMixed(1);
  mesh.Cells.clear();
  std::map<int, vtkIdType> sizes;
  for (FluentSample::Face& face : mesh.Faces)
  {
    face.Cells[0] = face.Cells[1] = -1;
    face.Zone = face.Nodes.size() == 3 ? 8 : 9;
    ++sizes[face.Zone];
  }
  const File file(EncodeContainer(mesh), "test.msh.h5");
  for (const int pieces : { 1, 2 })
  {
    for (const int zone : { 8, 9 })
    {
      vtkIdType cells = 0;
      for (int piece = 0; piece < pieces; ++piece)
      {
        const Result result = ReadWith<vtkFluentHDF5Reader>(file.Path, piece, pieces, 0,
          [&](vtkFluentHDF5Reader* reader)
          { reader->GetZoneSelection()->SetArraySetting(zone == 8 ? "zone-9" : "zone-8", 0); });
        ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
        std::set<vtkIdType> points;
        for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
        {
          EXPECT_EQ(result.Grid->GetCellData()->GetArray("Zone")->GetTuple1(cell), zone);
          const std::vector<vtkIdType> ids = GetSortedPoints(result.Grid, cell);
          points.insert(ids.begin(), ids.end());
        }
        EXPECT_EQ(static_cast<vtkIdType>(points.size()), result.Grid->GetNumberOfPoints());
        cells += result.Grid->GetNumberOfCells();
      }
      EXPECT_GT(cells, 0);
      EXPECT_EQ(cells, sizes[zone]);
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, users do not learn that parts of the file are not in the mesh.
TEST(FluentHDF5Reader, UnusedData)
{
  const std::string bytes = EncodeContainer(MakeMixed(1));
  EXPECT_TRUE(ReadContainer(bytes).Warnings.empty());
  const Result result = ReadContainer(ChangeContainer(bytes,
    [](const ContainerWriting& writing)
    {
      writing.Group("meshes/2");
      writing.Group("meshes/1/cells/partition");
      writing.Group("meshes/1/edges");
      writing.Group("special/Overset_DCI");
      writing.Integers("meshes/1/faces/zoneTopology/shadowZoneId", { 0, 0, 4 }, H5T_STD_I32LE);
      writing.Integers("meshes/1/faces/zoneTopology/childZoneId", { 0, 0, 0 }, H5T_STD_I32LE);
    }));
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(
    result.Warnings[0].find("the file has data that are not used: meshes/2, meshes/1/edges, "
                            "meshes/1/cells/partition, meshes/1/faces/zoneTopology/shadowZoneId, "
                            "special/Overset_DCI"),
    std::string::npos)
    << result.Warnings[0];
}

//------------------------------------------------------------------------------
// If this fails, files cannot be read whose last chunks have only the rows that exist, as those of
// Fluent Meshing.
TEST(FluentHDF5Reader, ShortLastChunk)
{
  const FluentSample mesh = MakeMixed(1);
  const std::string bytes = ChangeContainer(EncodeContainer(mesh),
    [](const ContainerWriting& writing)
    {
      constexpr hsize_t Size = 21, Chunk = 16;
      const std::string path = "meshes/1/faces/c0/1";
      const std::vector<long long> cells = writing.Read(path);
      ASSERT_EQ(cells.size(), Size);
      writing.Remove(path);
      const HDF5Id space(H5Screate_simple(1, &Size, nullptr));
      const HDF5Id properties(H5Pcreate(H5P_DATASET_CREATE));
      H5Pset_chunk(properties, 1, &Chunk);
      H5Pset_deflate(properties, 6);
      const HDF5Id data = ContainerWriting::Check(H5Dcreate2(writing.GetFile(), path.c_str(),
        H5T_NATIVE_UINT32, space, H5P_DEFAULT, properties, H5P_DEFAULT));
      for (hsize_t begin = 0; begin < Size; begin += Chunk)
      {
        const std::vector<std::uint32_t> rows(
          cells.begin() + begin, cells.begin() + std::min(begin + Chunk, Size));
        std::vector<Bytef> stored(1000);
        uLongf length = stored.size();
        compress(stored.data(), &length, reinterpret_cast<const Bytef*>(rows.data()),
          rows.size() * sizeof(rows[0]));
        H5Dwrite_chunk(data, H5P_DEFAULT, 0, &begin, length, stored.data());
      }
      writing.Number(path, "minId", 1);
      writing.Number(path, "maxId", Size);
    });
  EXPECT_EQ(Describe<vtkFluentMeshReader>(Encode(mesh), "test.msh"),
    Describe<vtkFluentHDF5Reader>(bytes, "test.msh.h5"));
}
