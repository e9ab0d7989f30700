// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The zones of written Fluent files: of cells, boundaries and interior faces, by id, name and type.
#include "FluentMeshWriting.h"
#include "SharedData.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <set>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
// Cells and boundaries, as combined by Group Datasets.
vtkSmartPointer<vtkMultiBlockDataSet> GroupOutputs(vtkFluentMeshReader* reader)
{
  auto both = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  both->SetBlock(0, reader->GetOutputDataObject(0));
  both->SetBlock(1, reader->GetOutputDataObject(1));
  return both;
}

//------------------------------------------------------------------------------
// A reader that has read a file.
vtkSmartPointer<vtkFluentMeshReader> Open(const std::string& path)
{
  auto reader = vtkSmartPointer<vtkFluentMeshReader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader;
}

//------------------------------------------------------------------------------
// Both outputs of a reader, written to a file and read again; nothing is lost, and there are no
// warnings.
void WriteBothOutputs(
  vtkFluentMeshReader* reader, Written& written, vtkSmartPointer<vtkFluentMeshReader>& second)
{
  const auto both = GroupOutputs(reader);
  written = Write(both);
  ASSERT_EQ(written.Success, 1);
  EXPECT_TRUE(written.Warnings.empty()) << written.Warnings[0];
  const File copy(written.Bytes, "copy.msh");
  second = Open(copy.Path);
  ExpectSameCells(reader->GetOutput(), second->GetOutput());
}

//------------------------------------------------------------------------------
// All data of every zone, and its number of faces.
std::set<std::string> DescribeZones(vtkFluentMeshReader* reader)
{
  std::set<std::string> zones;
  vtkFieldData* const data = reader->GetOutput()->GetFieldData();
  const auto get = [data](const char* name, vtkIdType i)
  { return data->GetAbstractArray(name)->GetVariantValue(i).ToString(); };
  for (vtkIdType i = 0; i < data->GetArray("ZoneIds")->GetNumberOfTuples(); ++i)
  {
    zones.insert(get("ZoneIds", i) + " " + get("ZoneNames", i) + " " + get("ZoneTypes", i));
  }
  auto* const blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(1));
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    auto* const surface = vtkPolyData::SafeDownCast(blocks->GetBlock(i));
    std::map<std::pair<int, int>, int> counts;
    for (vtkIdType face = 0; face < surface->GetNumberOfCells(); ++face)
    {
      const auto value = [&](const char* name)
      { return static_cast<int>(surface->GetCellData()->GetArray(name)->GetTuple1(face)); };
      ++counts[{ value("Zone"), value("BoundaryType") }];
    }
    for (const auto& count : counts)
    {
      zones.insert(std::to_string(count.second) + " faces of kind " +
        std::to_string(count.first.second) + " in " + std::to_string(count.first.first) + " " +
        blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()));
    }
  }
  if (vtkDataArray* interior = data->GetArray("InteriorZones"))
  {
    for (vtkIdType i = 0; i < interior->GetNumberOfTuples(); ++i)
    {
      std::string row = "faces inside:";
      for (int c = 0; c < interior->GetNumberOfComponents(); ++c)
      {
        row += " " + std::to_string(static_cast<int>(interior->GetComponent(i, c)));
      }
      zones.insert(row);
    }
  }
  return zones;
}

//------------------------------------------------------------------------------
// The polygons or lines of a surface by the positions of their points, each from its least one on.
std::multiset<std::vector<std::array<double, 3>>> GetRings(vtkPolyData* surface)
{
  std::multiset<std::vector<std::array<double, 3>>> rings;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    vtkIdList* const ids = surface->GetCell(cell)->GetPointIds();
    std::vector<std::array<double, 3>> ring(static_cast<std::size_t>(ids->GetNumberOfIds()));
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      surface->GetPoint(ids->GetId(static_cast<vtkIdType>(i)), ring[i].data());
    }
    if (ring.size() > 2)
    {
      std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    }
    rings.insert(ring);
  }
  return rings;
}

//------------------------------------------------------------------------------
void AddZones(vtkUnstructuredGrid* grid, const std::vector<int>& zones)
{
  vtkNew<vtkIntArray> array;
  array->SetName("Zone");
  for (const int zone : zones)
  {
    array->InsertNextValue(zone);
  }
  grid->GetCellData()->AddArray(array);
}
}

//------------------------------------------------------------------------------
// If this fails, a point array with the name of the cell zones is lost without a warning.
TEST(FluentMeshOutputZones, ZonesOfPointsAreLeftOut)
{
  const Grid grid = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  vtkNew<vtkIntArray> zones;
  zones->SetName("Zone");
  zones->SetNumberOfTuples(4);
  zones->Fill(3);
  grid->GetPointData()->AddArray(zones);
  const Written written = Write(grid);
  ASSERT_EQ(written.Warnings.size(), 1u);
  EXPECT_NE(written.Warnings[0].find("not written: Zone"), std::string::npos)
    << written.Warnings[0];
}

//------------------------------------------------------------------------------
// If this fails, cells get another zone without a warning.
TEST(FluentMeshOutputZones, ZonesThatAreNone)
{
  const std::vector<double> odd = { -3, 2.5, 4294967296. };
  for (const double zone : odd)
  {
    const Grid grid = MakeGrid(
      { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
    vtkNew<vtkDoubleArray> zones;
    zones->SetName("Zone");
    zones->InsertNextValue(zone);
    grid->GetCellData()->AddArray(zones);
    const Written written = Write(grid);
    ASSERT_EQ(written.Warnings.size(), 1u);
    EXPECT_NE(written.Warnings[0].find("1 cell whose Zone is not an integer"), std::string::npos)
      << written.Warnings[0];
    EXPECT_EQ(Read(written.Bytes).Grid->GetCellData()->GetArray("Zone")->GetTuple1(0), 2);
  }
}

//------------------------------------------------------------------------------
// If this fails, zones of cells or boundaries get lost between reading and writing.
TEST(FluentMeshOutputZones, KeepsZonesOfMergedBlocks)
{
  for (FluentSample mesh : { MakeMixed(2), MakeFlat(5) })
  {
    mesh.BoundaryTypes[11] = 10;
    for (FluentSample::Cell& cell : mesh.Cells)
    {
      cell.Zone = 2;
    }
    int inlets = 0;
    for (FluentSample::Face& face : mesh.Faces)
    {
      face.Zone = face.Cells[1] < 0 && inlets < 3 ? 11 : 0;
      inlets += face.Zone == 11;
    }
    const std::string names = "(45 (11 velocity-inlet inlet)())\n";
    const File file(Encode(mesh) + names, "test.msh");
    const auto reader = Open(file.Path);
    Written written;
    vtkSmartPointer<vtkFluentMeshReader> second;
    WriteBothOutputs(reader, written, second);
    ASSERT_TRUE(second);
    auto* const blocks = vtkMultiBlockDataSet::SafeDownCast(second->GetOutputDataObject(1));
    ASSERT_EQ(blocks->GetNumberOfBlocks(), 2u);
    std::map<std::string, vtkIdType> sizes;
    for (unsigned int i = 0; i < 2; ++i)
    {
      auto* const surface = vtkPolyData::SafeDownCast(blocks->GetBlock(i));
      const std::string name = blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME());
      sizes[name] = surface->GetNumberOfCells();
      EXPECT_EQ(
        surface->GetCellData()->GetArray("BoundaryType")->GetTuple1(0), name == "inlet" ? 10 : 3);
    }
    EXPECT_EQ(sizes["inlet"], 3);
    EXPECT_GT(sizes["skin"], 3);
  }
}

//------------------------------------------------------------------------------
// If this fails, other programs read a boundary as a wall if only its cells have the boundary type.
TEST(FluentMeshOutputZones, NamesZonesByTheKindOfTheirCells)
{
  Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 0, 1, 3 } } });
  for (const char* name : { "Zone", "BoundaryType" })
  {
    vtkNew<vtkIntArray> array;
    array->SetName(name);
    array->InsertNextValue(1);
    array->InsertNextValue(*name == 'Z' ? 5 : 10);
    grid->GetCellData()->AddArray(array);
  }
  const Written written = Write(grid);
  ASSERT_EQ(written.Success, 1);
  EXPECT_NE(written.Bytes.find("(45 (5 velocity-inlet velocity-inlet-5)())"), std::string::npos)
    << written.Bytes;
}

//------------------------------------------------------------------------------
// If this fails, one side of a thin wall, which is a face in a zone of its own, is lost.
TEST(FluentMeshOutputZones, KeepsBothSidesOfThinWalls)
{
  for (FluentSample mesh : { MakeMixed(2), MakeFlat(5) })
  {
    mesh.BoundaryTypes[11] = mesh.BoundaryTypes[12] = 3;
    for (FluentSample::Cell& cell : mesh.Cells)
    {
      cell.Zone = 2;
    }
    const std::size_t size = mesh.Faces.size();
    int walls = 0;
    for (std::size_t i = 0; i < size; ++i)
    {
      FluentSample::Face far = mesh.Faces[i];
      if (far.Cells[1] >= 0 && i % 2 == 0)
      {
        far.Cells[0] = std::exchange(far.Cells[1], -1);
        std::reverse(far.Nodes.begin(), far.Nodes.end());
        far.Zone = 12;
        mesh.Faces[i].Cells[1] = -1;
        mesh.Faces[i].Zone = 11;
        mesh.Faces.push_back(far);
        ++walls;
      }
    }
    ASSERT_GT(walls, 0);
    const File file(
      Encode(mesh) + "(45 (11 wall thin)())(45 (12 wall thin-shadow)())\n", "test.msh");
    const auto reader = Open(file.Path);
    Written written;
    vtkSmartPointer<vtkFluentMeshReader> second;
    WriteBothOutputs(reader, written, second);
    ASSERT_TRUE(second);
    EXPECT_EQ(DescribeZones(second), DescribeZones(reader));
    EXPECT_TRUE(
      DescribeZones(second).count(std::to_string(walls) + " faces of kind 3 in 12 thin-shadow"));
    // Each side belongs to its cell and is oriented outward of it.
    const auto again = GroupOutputs(second);
    EXPECT_EQ(Write(again).Bytes, written.Bytes);
    for (const unsigned int block : { 0u, 1u, 2u })
    {
      auto* const a = vtkPolyData::SafeDownCast(
        vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(1))->GetBlock(block));
      auto* const b = vtkPolyData::SafeDownCast(
        vtkMultiBlockDataSet::SafeDownCast(second->GetOutputDataObject(1))->GetBlock(block));
      EXPECT_EQ(GetRings(a), GetRings(b));
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, interior faces get into another of several zones, or zones that cannot be
// distinguished disappear without a warning.
TEST(FluentMeshOutputZones, KeepsZonesOfInteriorFaces)
{
  const std::string names = "(45 (20 interior triangles)())(45 (21 interior quads)())\n"
                            "(45 (22 interior others)())\n";
  for (const int cellElement : { 0, 7 }) // as they are, and as polyhedra
  {
    FluentSample mesh = MakeMixed(3);
    mesh.BoundaryTypes = { { 20, 2 }, { 21, 2 }, { 22, 2 } };
    for (FluentSample::Cell& cell : mesh.Cells)
    {
      cell.Element = cellElement > 0 ? cellElement : cell.Element;
    }
    int between = 0; // faces with four nodes between cells of zone 5
    for (FluentSample::Face& face : mesh.Faces)
    {
      const bool isInside = face.Cells[1] >= 0;
      face.Zone = isInside ? face.Nodes.size() == 3 ? 20 : 21 : 0;
      if (isInside && face.Nodes.size() == 4 && mesh.Cells[face.Cells[0]].Zone == 5 &&
        mesh.Cells[face.Cells[1]].Zone == 5)
      {
        face.Zone = ++between % 2 ? 21 : 22;
      }
    }
    ASSERT_GT(between, 1);
    const File file(Encode(mesh) + names, "test.msh");
    const auto reader = Open(file.Path);
    const Written written = Write(reader->GetOutput());
    ASSERT_EQ(written.Success, 1);
    const auto warnsOf = [&](const std::string& text)
    {
      return std::any_of(written.Warnings.begin(), written.Warnings.end(),
        [&](const std::string& warning) { return warning.find(text) != std::string::npos; });
    };
    EXPECT_TRUE(warnsOf("omitted: inside, others;")); // the sample names a zone without faces
    const Result second = Read(written.Bytes);
    ASSERT_TRUE(second.Errors.empty());
    std::map<std::array<int, 3>, int> tables[2];
    for (vtkUnstructuredGrid* grid : { reader->GetOutput(), second.Grid.Get() })
    {
      vtkDataArray* const table = grid->GetFieldData()->GetArray("InteriorZones");
      ASSERT_NE(table, nullptr);
      for (vtkIdType row = 0; row < table->GetNumberOfTuples(); ++row)
      {
        const double* entry = table->GetTuple4(row);
        tables[grid == second.Grid][{ static_cast<int>(entry[1]), static_cast<int>(entry[2]),
          static_cast<int>(entry[3]) }] = static_cast<int>(entry[0]);
      }
    }
    for (const auto& entry : tables[0])
    {
      EXPECT_EQ(tables[1][entry.first], entry.second);
    }
    EXPECT_GT(tables[0].size(), 1u);
    EXPECT_EQ(tables[0].count({ 5, 5, 4 }), 0u);
  }
}

//------------------------------------------------------------------------------
// If this fails, the faces of a zone are in two sections, which a reader joins, so writing again
// gives another file.
TEST(FluentMeshOutputZones, InteriorFacesOfNoZoneJoinTheOnlyOne)
{
  const Grid grid =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 }, { 2, 1, 1 } },
      { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 4, 2, 3 } },
        { VTK_TETRA, { 1, 5, 4, 3 } } });
  AddZones(grid, { 5, 5, 6 });
  vtkNew<vtkIntArray> ids, table;
  ids->SetName("ZoneIds");
  ids->InsertNextValue(3);
  vtkNew<vtkStringArray> types;
  types->SetName("ZoneTypes");
  types->InsertNextValue("interior");
  table->SetName("InteriorZones");
  table->SetNumberOfComponents(4);
  table->InsertNextTuple4(3, 5, 5, 3);
  for (vtkAbstractArray* array : std::initializer_list<vtkAbstractArray*>{ ids, types, table })
  {
    grid->GetFieldData()->AddArray(array);
  }
  const Written written = Write(grid);
  ASSERT_EQ(written.Success, 1);
  EXPECT_NE(written.Bytes.find("(13 (3 1 2 2 3)("), std::string::npos) << written.Bytes;
}

//------------------------------------------------------------------------------
// If this fails, cells of lower dimensions are written as cells, or lost without a warning.
TEST(FluentMeshOutputZones, CellsOfLowerDimensionsAreMarks)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 5, 5, 5 } },
    { { VTK_TRIANGLE, { 2, 0, 1 } }, { VTK_TETRA, { 0, 1, 2, 3 } },
      { VTK_TRIANGLE, { 0, 1, 4 } } });
  AddZones(grid, { 7, 5, 7 });
  const Written written = Write(grid);
  ASSERT_EQ(written.Success, 1);
  ASSERT_EQ(written.Warnings.size(), 1u);
  EXPECT_NE(written.Warnings[0].find("1 cell of a lower dimension"), std::string::npos)
    << written.Warnings[0];
  EXPECT_NE(written.Bytes.find("(12 (5 1 1 1 2))"), std::string::npos);
  EXPECT_NE(written.Bytes.find("(13 (7 4 4 3 3)(\n1 2 3 1 0\n))"), std::string::npos)
    << written.Bytes;
  EXPECT_EQ(Read(written.Bytes).Grid->GetNumberOfCells(), 1);
}

//------------------------------------------------------------------------------
TEST(FluentMeshOutputZones, OtherPlanesAndNames)
{
  const Grid grid = MakeGrid({ { 0, 0, 3 }, { 1, 0, 3 }, { 0, 1, 3 }, { 1, 1, 3 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 1, 3, 2 } } });
  AddZones(grid, { 8, 0 });
  vtkNew<vtkIntArray> ids;
  ids->SetName("ZoneIds");
  ids->InsertNextValue(8);
  vtkNew<vtkStringArray> names;
  names->SetName("ZoneNames");
  names->InsertNextValue("heiße (Luft)");
  grid->GetFieldData()->AddArray(ids);
  grid->GetFieldData()->AddArray(names);
  const Written written = Write(grid);
  ASSERT_EQ(written.Success, 1);
  ASSERT_EQ(written.Warnings.size(), 2u);
  EXPECT_NE(written.Warnings[0].find("1 zone with blanks, brackets"), std::string::npos);
  EXPECT_NE(written.Warnings[1].find("not exactly in the plane z = 0"), std::string::npos);
  EXPECT_NE(written.Bytes.find("(45 (8 fluid heiße--Luft-)())"), std::string::npos)
    << written.Bytes;
  EXPECT_NE(written.Bytes.find("(12 (2 2 2 1 1))"), std::string::npos) << written.Bytes;
  const Result result = Read(written.Bytes);
  ASSERT_TRUE(result.Errors.empty());
  EXPECT_GT(GetMeasure(result.Grid, 1), 0);
}

//------------------------------------------------------------------------------
// If this fails, a zone of a collected file loses its name, type, number or faces if both outputs
// of the reader are written, or is lost without a warning if only the cells are.
TEST(FluentMeshOutputZones, CollectedFilesKeepTheirZones)
{
  CAMARON_NEEDS_SHARED_DATA("ansys_fluent");
  for (const auto& entry : std::filesystem::directory_iterator(GetSharedData("ansys_fluent")))
  {
    if (entry.path().stem() == "dev_hanging_ascii")
    {
      continue; // joined faces are written as boundary faces
    }
    const auto reader = Open(entry.path().string());
    const std::set<std::string> zones = DescribeZones(reader);
    const auto both = GroupOutputs(reader);
    for (const int encoding : { vtkFluentMeshWriter::ASCII, vtkFluentMeshWriter::BINARY_SINGLE })
    {
      const Written written =
        Write(both, [encoding](vtkFluentMeshWriter* writer) { writer->SetEncoding(encoding); });
      ASSERT_EQ(written.Success, 1) << entry.path();
      const File copy(written.Bytes, "copy.msh");
      const auto second = Open(copy.Path);
      EXPECT_EQ(DescribeZones(second), zones) << entry.path();
    }
    const Written cells = WriteAs(reader->GetOutput(), vtkFluentMeshWriter::ASCII);
    const auto blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(1));
    EXPECT_TRUE(blocks->GetNumberOfBlocks() < 2 ||
      std::any_of(cells.Warnings.begin(), cells.Warnings.end(), [](const std::string& warning)
        { return warning.find("zones without cells or faces in the mesh") != std::string::npos; }))
      << entry.path();
  }
}
