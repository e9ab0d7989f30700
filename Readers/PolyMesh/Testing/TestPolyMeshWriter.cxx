// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Written OpenFOAM meshes: exact bytes, the order and orientation of faces, and what happens to the
// folder. TestPolyMesh.py has them read by OpenFOAM and by ParaView.
#include "Base/Progress.h"
#include "FormatTesting.h"
#include "Scan/Inflation.h"
#include "TemporaryFolder.h"
#include "TestMeshes.h"
#include "vtkPolyMeshWriter.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
// A case in a folder of its own.
struct Case
{
  TemporaryFolder Folder;
  std::vector<std::string> Warnings, Errors;

  std::filesystem::path GetMesh() const { return this->Folder.Path / "constant" / "polyMesh"; }

  bool Write(vtkDataObject* mesh, const std::function<void(vtkPolyMeshWriter*)>& configure = {})
  {
    const Written written =
      WriteTo<vtkPolyMeshWriter>((this->Folder.Path / "case.foam").string(), mesh, configure);
    this->Warnings = written.Warnings;
    this->Errors = written.Errors;
    return written.Success != 0;
  }

  /// A file without its header and blank lines around.
  std::string Read(const std::string& name) const
  {
    const std::string text = GetBytes((this->GetMesh() / name).string());
    const std::size_t end = text.find("}\n");
    return end == std::string::npos ? "" : text.substr(end + 3);
  }

  std::vector<int> ReadLabels(const std::string& name) const
  {
    std::string text = this->Read(name);
    for (char& c : text)
    {
      c = c == '(' || c == ')' ? ' ' : c;
    }
    std::istringstream stream(text);
    std::vector<int> labels{ std::istream_iterator<int>(stream), std::istream_iterator<int>() };
    labels.erase(labels.begin()); // their number
    return labels;
  }

  std::size_t CountEntries() const
  {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(this->Folder.Path))
    {
      (void)entry;
      ++count;
    }
    return count;
  }
};

//------------------------------------------------------------------------------
// Whether faces are in upper triangular order and point out of their owner, for cells whose
// centers are given.
void ExpectOutwardFaces(
  const Case& written, vtkUnstructuredGrid* grid, const std::vector<std::array<double, 3>>& centers)
{
  const std::vector<int> owner = written.ReadLabels("owner");
  const std::vector<int> neighbor = written.ReadLabels("neighbour");
  const std::vector<int> words = written.ReadLabels("faces");
  std::pair<int, int> last(-1, -1);
  std::size_t word = 0;
  for (std::size_t face = 0; face < owner.size(); ++face)
  {
    if (face < neighbor.size())
    {
      const std::pair<int, int> cells(owner[face], neighbor[face]);
      EXPECT_LT(cells.first, cells.second);
      EXPECT_LT(last, cells);
      last = cells;
    }
    double normal[3] = {}, middle[3] = {};
    const int size = words[word++];
    for (int i = 0; i < size; ++i)
    {
      double a[3], b[3];
      grid->GetPoint(words[word + i], a);
      grid->GetPoint(words[word + (i + 1) % size], b);
      for (int c = 0; c < 3; ++c)
      {
        const int d = (c + 1) % 3, e = (c + 2) % 3;
        normal[c] += a[d] * b[e] - a[e] * b[d];
        middle[c] += a[c] / size;
      }
    }
    word += static_cast<std::size_t>(size);
    double outward = 0;
    for (int c = 0; c < 3; ++c)
    {
      outward += normal[c] * (middle[c] - centers[static_cast<std::size_t>(owner[face])][c]);
    }
    EXPECT_GT(outward, 0) << face;
  }
  EXPECT_EQ(word, words.size());
}

//------------------------------------------------------------------------------
std::vector<std::array<double, 3>> GetCenters(int nx, int ny, int nz)
{
  std::vector<std::array<double, 3>> centers;
  for (int z = 0; z < nz; ++z)
  {
    for (int y = 0; y < ny; ++y)
    {
      for (int x = 0; x < nx; ++x)
      {
        centers.push_back({ x + 0.5, y + 0.5, z + 0.5 });
      }
    }
  }
  return centers;
}

//------------------------------------------------------------------------------
void AddArray(vtkDataSet* mesh, const char* name, const std::vector<int>& values)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  for (const int value : values)
  {
    array->InsertNextValue(value);
  }
  mesh->GetCellData()->AddArray(array);
}
}

//------------------------------------------------------------------------------
// If this fails, OpenFOAM may not read what is written.
TEST(PolyMeshWriter, WritesText)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0.1 }, { 1, 1, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 4, 2, 3 } } });
  AddArray(grid, "Selected", { 0, 1 });
  Case written;
  ASSERT_TRUE(written.Write(grid));
  EXPECT_TRUE(written.Warnings.empty());
  EXPECT_EQ(GetBytes((written.Folder.Path / "case.foam").string()), "");
  const std::string header =
    "FoamFile\n{\n    version     2.0;\n    format      ascii;\n    arch        "
    "\"LSB;label=32;scalar=64\";\n    class       ";
  EXPECT_EQ(GetBytes((written.GetMesh() / "points").string()),
    header +
      "vectorField;\n    location    \"constant/polyMesh\";\n    object      points;\n}\n"
      "\n5\n(\n(0 0 0)\n(1 0 0)\n(0 1 0)\n(0 0 0.1)\n(1 1 1)\n)\n");
  EXPECT_EQ(GetBytes((written.GetMesh() / "owner").string()),
    header +
      "labelList;\n    note        \"nPoints:5  nCells:2  nFaces:7  nInternalFaces:1\";\n"
      "    location    \"constant/polyMesh\";\n    object      owner;\n}\n"
      "\n7\n(\n0\n0\n0\n0\n1\n1\n1\n)\n");
  EXPECT_EQ(written.Read("neighbour"), "1\n(\n1\n)\n");
  EXPECT_EQ(written.Read("boundary"),
    "1\n(\n    defaultFaces\n    {\n        type            patch;\n        nFaces          6;\n"
    "        startFace       1;\n    }\n)\n");
  EXPECT_EQ(written.Read("sets/Selected"), "1\n(\n1\n)\n");
  EXPECT_FALSE(std::filesystem::exists(written.GetMesh() / "cellZones"));
  ExpectOutwardFaces(written, grid, { { 0.25, 0.25, 0.025 }, { 0.5, 0.5, 0.275 } });
}

//------------------------------------------------------------------------------
// If this fails, faces of cells that other programs wrote carelessly point the wrong way.
TEST(PolyMeshWriter, OrientsFaces)
{
  const auto centers = GetCenters(3, 2, 2);
  for (const bool asPolyhedra : { false, true })
  {
    const Grid grid = MakeHexahedra(3, 2, 2, asPolyhedra);
    Case written;
    ASSERT_TRUE(written.Write(grid));
    ExpectOutwardFaces(written, grid, centers);
    const std::vector<int> owner = written.ReadLabels("owner");
    EXPECT_EQ(owner.size(), 52u);
    EXPECT_EQ(written.ReadLabels("neighbour").size(), 20u);
  }
  // Every second face of every second polyhedron reversed; all faces; mirrored hexahedra.
  const Grid hexahedra = MakeHexahedra(3, 2, 2, false);
  std::vector<Faces> mixed, inward;
  for (vtkIdType cell = 0; cell < hexahedra->GetNumberOfCells(); ++cell)
  {
    Faces some = GetFaces(hexahedra, cell), all = some;
    for (std::size_t face = 0; face < some.size(); ++face)
    {
      if ((face + static_cast<std::size_t>(cell)) % 3 == 0)
      {
        std::reverse(some[face].begin(), some[face].end());
      }
      std::reverse(all[face].begin(), all[face].end());
    }
    mixed.push_back(some);
    inward.push_back(all);
  }
  const Grid mirrored = MakeHexahedra(3, 2, 2, false);
  for (vtkIdType point = 0; point < mirrored->GetNumberOfPoints(); ++point)
  {
    double x[3];
    mirrored->GetPoint(point, x);
    x[2] = 2 - x[2];
    mirrored->GetPoints()->SetPoint(point, x);
  }
  auto mirroredCenters = centers;
  for (auto& center : mirroredCenters)
  {
    center[2] = 2 - center[2];
  }
  Case written;
  ASSERT_TRUE(written.Write(MakePolyhedra(hexahedra->GetPoints(), mixed)));
  ExpectOutwardFaces(written, hexahedra, centers);
  Case turned;
  ASSERT_TRUE(turned.Write(MakePolyhedra(hexahedra->GetPoints(), inward)));
  ExpectOutwardFaces(turned, hexahedra, centers);
  Case mirror;
  ASSERT_TRUE(mirror.Write(mirrored));
  ExpectOutwardFaces(mirror, mirrored, mirroredCenters);
}

//------------------------------------------------------------------------------
// If this fails, a cell that a moved point inverted is hidden from checkMesh.
TEST(PolyMeshWriter, KeepsInvertedCells)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, 0.5 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 2, 1, 4 } } });
  Case written; // point 4 should be below the common face
  ASSERT_TRUE(written.Write(grid));
  const std::vector<int> words = written.ReadLabels("faces");
  const std::vector<int> first(words.begin(), words.begin() + 4);
  EXPECT_TRUE((first == std::vector<int>{ 3, 0, 2, 1 })) << ::testing::PrintToString(first);
}

//------------------------------------------------------------------------------
// If this fails, zones, patches or their order are lost.
TEST(PolyMeshWriter, WritesZones)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 4, 2, 3 } }, { VTK_TRIANGLE, { 1, 2, 3 } },
      { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 1, 4, 2 } } });
  AddArray(grid, "Zone", { 2, 3, 4, 5, 6 });
  AddArray(grid, "BoundaryType", { 0, 0, 2, 3, 7 });
  Case written;
  ASSERT_TRUE(written.Write(grid));
  EXPECT_EQ(written.Read("cellZones"),
    "2\n(\nfluid-2\n{\n    type            cellZone;\n    cellLabels      List<label> "
    "\n1\n(\n0\n)\n;\n}\n"
    "fluid-3\n{\n    type            cellZone;\n    cellLabels      List<label> "
    "\n1\n(\n1\n)\n;\n}\n)\n");
  EXPECT_EQ(written.Read("faceZones"),
    "1\n(\ninterior-4\n{\n    type            faceZone;\n    faceLabels      List<label> "
    "\n1\n(\n0\n)\n;\n"
    "    flipMap         List<bool> \n1\n(\n0\n)\n;\n}\n)\n");
  const std::string boundary = written.Read("boundary");
  const auto find = [&](const std::string& text) { return boundary.find(text); };
  EXPECT_NE(
    find("    wall-5\n    {\n        type            wall;\n        inGroups        1(wall);\n"
         "        nFaces          1;\n"),
    std::string::npos);
  EXPECT_NE(find("symmetry-6\n    {\n        type            symmetry;\n"), std::string::npos);
  EXPECT_NE(
    find("defaultFaces\n    {\n        type            patch;\n        nFaces          4;\n"),
    std::string::npos);
}

//------------------------------------------------------------------------------
// If this fails, an outlet becomes a wall, as some Fluent files number all faces as walls.
TEST(PolyMeshWriter, NamedTypeOfZoneGoesBeforeItsNumber)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 0, 1, 2 } } });
  AddArray(grid, "Zone", { 2, 5 });
  AddArray(grid, "BoundaryType", { 0, 3 });
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ZoneIds");
  ids->InsertNextValue(5);
  grid->GetFieldData()->AddArray(ids);
  for (const auto& [array, text] :
    { std::make_pair("ZoneNames", "out"), { "ZoneTypes", "pressure-outlet" } })
  {
    vtkNew<vtkStringArray> texts;
    texts->SetName(array);
    texts->InsertNextValue(text);
    grid->GetFieldData()->AddArray(texts);
  }
  Case written;
  ASSERT_TRUE(written.Write(grid));
  EXPECT_NE(written.Read("boundary")
              .find("    out\n    {\n        type            patch;\n"
                    "        inGroups        1(pressure-outlet);\n"),
    std::string::npos)
    << written.Read("boundary");
}

//------------------------------------------------------------------------------
// If this fails, an inlet becomes part of a wall because their zones have the same number.
TEST(PolyMeshWriter, KeepsZonesOfOneIdApart)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 1, 3 } },
      { VTK_TRIANGLE, { 1, 2, 3 } }, { VTK_TRIANGLE, { 0, 2, 3 } } });
  AddArray(grid, "Zone", { 6, 5, 5, 5, 7 });
  AddArray(grid, "BoundaryType", { 0, 3, 10, 3, 3 });
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkStringArray> names;
  ids->SetName("ZoneIds");
  names->SetName("ZoneNames");
  for (const auto& [id, name] : { std::make_pair(5, "side"), { 5, "door" }, { 7, "end" } })
  {
    ids->InsertNextValue(id);
    names->InsertNextValue(name);
  }
  grid->GetFieldData()->AddArray(ids);
  grid->GetFieldData()->AddArray(names);
  Case written;
  ASSERT_TRUE(written.Write(grid));
  const std::string boundary = written.Read("boundary");
  const auto has = [&boundary](const std::string& name, const char* type, int count)
  {
    const std::size_t at =
      boundary.find("    " + name + "\n    {\n        type            " + type);
    const std::size_t faces = boundary.find("nFaces          ", at);
    return at != std::string::npos && boundary[faces + 16] == '0' + count;
  };
  EXPECT_TRUE(has("side", "wall", 2)) << boundary;
  EXPECT_TRUE(has("side-velocity-inlet", "patch", 1)) << boundary;
  EXPECT_TRUE(has("end", "wall", 1)) << boundary;
  const char* const warnings[] = {
    "1 zone with an id that another name has as well, whose elements "
    "get the first name: zone 5",
    "faces of zone 5 have another boundary type than its first one, and become a zone: "
    "'side-velocity-inlet'"
  };
  ASSERT_EQ(written.Warnings.size(), 2u);
  EXPECT_NE(written.Warnings[0].find(warnings[0]), std::string::npos) << written.Warnings[0];
  EXPECT_NE(written.Warnings[1].find(warnings[1]), std::string::npos) << written.Warnings[1];
}

//------------------------------------------------------------------------------
// If this fails, binary or compressed files are not as OpenFOAM expects them.
TEST(PolyMeshWriter, WritesBinary)
{
  const Grid grid = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0.1 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  for (const int size : { vtkPolyMeshWriter::LABELS_32, vtkPolyMeshWriter::LABELS_64 })
  {
    Case written;
    ASSERT_TRUE(written.Write(grid,
      [size](vtkPolyMeshWriter* writer)
      {
        writer->SetEncoding(vtkPolyMeshWriter::BINARY);
        writer->SetLabelSize(size);
        writer->SetScale(1000);
      }));
    const std::size_t label = size == vtkPolyMeshWriter::LABELS_64 ? 8 : 4;
    const std::string points = written.Read("points"), faces = written.Read("faces");
    ASSERT_EQ(points.size(), std::string("4\n()\n").size() + 4 * 3 * sizeof(double));
    double height;
    std::memcpy(&height, points.data() + 3 + 11 * sizeof(double), sizeof(double));
    EXPECT_EQ(height, 0.1 * 1000);
    EXPECT_EQ(faces.substr(0, 3), "5\n(");
    const std::size_t second = 3 + 5 * label + 2;
    EXPECT_EQ(faces.substr(second, 5), "\n12\n(");
    EXPECT_EQ(faces.size(), second + 5 + 12 * label + 2);
    EXPECT_EQ(written.Read("neighbour"), "0\n\n"); // OpenFOAM's form of an empty binary list
  }
  Case text, compressed;
  ASSERT_TRUE(text.Write(grid));
  ASSERT_TRUE(compressed.Write(grid, [](vtkPolyMeshWriter* writer) { writer->CompressOn(); }));
  const std::string packed = GetBytes((compressed.GetMesh() / "faces.gz").string());
  Inflation faces;
  ScanError error;
  ASSERT_TRUE(
    faces.Inflate("faces.gz", packed.data(), packed.data() + packed.size(), error, Progress()));
  EXPECT_EQ(std::string(faces.begin(), faces.end()), GetBytes((text.GetMesh() / "faces").string()));
}

//------------------------------------------------------------------------------
// If this fails, a mesh is written that OpenFOAM cannot have.
TEST(PolyMeshWriter, RefusesOtherMeshes)
{
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 },
    { -1, -1, -1 } };
  const Faces open = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 } };
  const std::pair<Grid, const char*> meshes[] = {
    { MakePolyhedron(points, open),
      "closed cells whose edges belong to two faces each, found 1 other cell: cell 0" },
    { MakeGrid(points,
        { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 2, 1, 5 } },
          { VTK_TETRA, { 0, 1, 2, 4 } } }),
      "expected faces with at most two cells, found 1" },
    { MakeGrid(points, { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 0, 1, 4 } } }),
      "found 1 2D cell that is none: cell 1" },
    { MakeGrid(points, { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_LINE, { 0, 1 } } }), "line" },
    { MakeGrid(points, { { VTK_TRIANGLE, { 0, 1, 2 } } }), "expected 3D cells, found none" },
    { MakeGrid(points, { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 0, 1, 1 } } }),
      "cells of at least 4 faces, found 1 collapsed one: cell 1" },
    { MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, std::nan("") } },
        { { VTK_TETRA, { 0, 1, 2, 3 } } }),
      "expected finite coordinates, found 1 point with others: point 3" },
  };
  for (const auto& [mesh, reason] : meshes)
  {
    Case written;
    EXPECT_FALSE(written.Write(mesh));
    ASSERT_EQ(written.Errors.size(), 1u) << reason;
    EXPECT_NE(written.Errors[0].find(reason), std::string::npos) << written.Errors[0];
    EXPECT_EQ(written.CountEntries(), 0u);
  }
  Case written;
  const std::pair<double, const char*> scales[] = { { 0, "0" }, { -1, "-1" }, { 1e-320, "1e-320" },
    { std::numeric_limits<double>::infinity(), "inf" },
    { std::numeric_limits<double>::quiet_NaN(), "nan" } };
  for (const auto& [scale, found] : scales)
  {
    EXPECT_FALSE(written.Write(MakeHexahedra(1, 1, 1, false),
      [value = scale](vtkPolyMeshWriter* writer) { writer->SetScale(value); }));
    const std::string message = "case.foam: expected a Scale from 2.3e-308 to 1.7e308, found ";
    EXPECT_NE(written.Errors.at(0).find(message + found), std::string::npos) << written.Errors[0];
  }
  EXPECT_EQ(written.CountEntries(), 0u);
}

//------------------------------------------------------------------------------
// If this fails, a link becomes a folder, or a file is lost.
TEST(PolyMeshWriter, KeepsLinks)
{
  Case written;
  const std::filesystem::path real = written.Folder.Path / "real";
  std::filesystem::create_directories(real);
  std::filesystem::create_directories(written.Folder.Path / "constant");
  std::filesystem::create_directory_symlink(real, written.GetMesh());
  std::ofstream(real / "blockMeshDict") << "mine";
  ASSERT_TRUE(written.Write(MakeHexahedra(1, 1, 1, false)));
  EXPECT_TRUE(std::filesystem::is_symlink(written.GetMesh()));
  EXPECT_TRUE(std::filesystem::exists(real / "points"));
  EXPECT_TRUE(std::filesystem::exists(real / "blockMeshDict"));

  Case file;
  std::filesystem::create_directories(file.Folder.Path / "constant");
  std::ofstream(file.GetMesh()) << "mine";
  EXPECT_FALSE(file.Write(
    MakeHexahedra(1, 1, 1, false), [](vtkPolyMeshWriter* writer) { writer->OverwriteOn(); }));
  EXPECT_EQ(GetBytes(file.GetMesh().string()), "mine");
  EXPECT_EQ(file.CountEntries(), 2u);
}

//------------------------------------------------------------------------------
// If this fails, OpenFOAM takes the name of a zone for a number.
TEST(PolyMeshWriter, WritesWords)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 0, 1, 2 } },
      { VTK_TRIANGLE, { 0, 1, 3 } } });
  AddArray(grid, "Zone", { 2, 3, 4 });
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkStringArray> names;
  ids->SetName("ZoneIds");
  names->SetName("ZoneNames");
  const char* given[] = { "1", "3.5", "(x) // c" };
  for (int i = 0; i < 3; ++i)
  {
    ids->InsertNextValue(i + 2);
    names->InsertNextValue(given[i]);
  }
  grid->GetFieldData()->AddArray(ids);
  grid->GetFieldData()->AddArray(names);
  Case written;
  ASSERT_TRUE(written.Write(grid));
  EXPECT_NE(written.Read("cellZones").find("zone_1\n{"), std::string::npos);
  EXPECT_NE(written.Read("boundary").find("    zone_3.5\n    {"), std::string::npos);
  EXPECT_NE(written.Read("boundary").find("    zone_-x--__-c\n    {"), std::string::npos);
}

//------------------------------------------------------------------------------
// If this fails, a mesh or a setting of the user is lost, or files of an old mesh stay.
TEST(PolyMeshWriter, KeepsOtherFiles)
{
  Case written;
  const Grid first = MakeHexahedra(2, 1, 1, false), second = MakeHexahedra(3, 1, 1, false);
  AddArray(first, "Zone", { 2, 3 });
  AddArray(first, "Selected", { 1, 0 });
  ASSERT_TRUE(written.Write(first));
  std::ofstream(written.GetMesh() / "blockMeshDict") << "mine";
  std::ofstream(written.Folder.Path / "case.foam") << "mine";
  const std::string before = GetBytes((written.GetMesh() / "owner").string());
  EXPECT_FALSE(written.Write(second));
  ASSERT_EQ(written.Errors.size(), 1u);
  EXPECT_NE(written.Errors[0].find("set Overwrite"), std::string::npos) << written.Errors[0];
  EXPECT_EQ(GetBytes((written.GetMesh() / "owner").string()), before);

  const auto overwrite = [](vtkPolyMeshWriter* writer) { writer->OverwriteOn(); };
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const auto abort = [&](vtkPolyMeshWriter* writer)
  {
    overwrite(writer);
    writer->AddObserver(vtkCommand::ProgressEvent, stop);
  };
  EXPECT_FALSE(written.Write(second, abort));
  EXPECT_EQ(GetBytes((written.GetMesh() / "owner").string()), before);

  ASSERT_TRUE(written.Write(second, overwrite));
  EXPECT_NE(GetBytes((written.GetMesh() / "owner").string()), before);
  EXPECT_EQ(GetBytes((written.GetMesh() / "blockMeshDict").string()), "mine");
  EXPECT_EQ(GetBytes((written.Folder.Path / "case.foam").string()), "mine");
  EXPECT_FALSE(std::filesystem::exists(written.GetMesh() / "cellZones"));
  EXPECT_FALSE(std::filesystem::exists(written.GetMesh() / "sets"));
  // case.foam, constant, polyMesh and six files in it
  EXPECT_EQ(written.CountEntries(), 9u);
}
