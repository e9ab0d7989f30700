// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Written Fluent files in HDF5: the layout of Fluent Meshing, and the same meshes as those in text.
#include "FluentHDF5Samples.h"
#include "vtkFluentHDF5Writer.h"
#include "vtkFluentMeshWriter.h"

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
/// Both outputs of the reader of a file in text.
vtkSmartPointer<vtkMultiBlockDataSet> ReadBoth(const std::string& text)
{
  const File file(text, "test.msh");
  vtkNew<vtkFluentMeshReader> reader;
  reader->SetFileName(file.Path.c_str());
  reader->Update();
  auto both = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  both->SetBlock(0, reader->GetOutputDataObject(0));
  both->SetBlock(1, reader->GetOutputDataObject(1));
  return both;
}

//------------------------------------------------------------------------------
Written WriteContainer(vtkDataObject* mesh)
{
  return WriteWith<vtkFluentHDF5Writer>(
    mesh, "test.msh.h5", std::function<void(vtkFluentHDF5Writer*)>());
}
}

//------------------------------------------------------------------------------
// If this fails, points, cells, faces per zone or names change when a mesh is written in HDF5, or
// differ from those of the same mesh in text.
TEST(FluentHDF5Writer, SameAsText)
{
  FluentSample polyhedra = MakeMixed(2);
  for (FluentSample::Cell& cell : polyhedra.Cells)
  {
    cell.Element = 7;
  }
  FluentSample named = MakeMixed(2);
  named.Faces[0].Zone = 6;
  named.BoundaryTypes[6] = 10;
  for (const FluentSample& sample : { MakeMixed(3), polyhedra, MakeFlat(7), named })
  {
    const auto mesh = ReadBoth(Encode(sample));
    const Written text =
      WriteWith<vtkFluentMeshWriter>(mesh, "test.msh", std::function<void(vtkFluentMeshWriter*)>());
    const Written container = WriteContainer(mesh);
    ASSERT_TRUE(text.Success && container.Success);
    EXPECT_EQ(text.Warnings.size(), container.Warnings.size());
    EXPECT_EQ(Describe<vtkFluentMeshReader>(text.Bytes, "test.msh"),
      Describe<vtkFluentHDF5Reader>(container.Bytes, "test.msh.h5"));
  }
}

//------------------------------------------------------------------------------
// If this fails, programs that expect the layout of Fluent Meshing may not open the file.
TEST(FluentHDF5Writer, Layout)
{
  const Written written = WriteContainer(ReadBoth(Encode(MakeMixed(1))));
  ASSERT_TRUE(written.Success);
  const ContainerWriting file(written.Bytes);
  using Values = std::vector<long long>;
  EXPECT_EQ(file.Read("meshes/1/faces/zoneTopology/zoneType"), (Values{ 2, 3 }));
  EXPECT_EQ(file.Read("meshes/1/faces/zoneTopology/minId"), (Values{ 1, 5 }));
  EXPECT_EQ(file.Read("meshes/1/faces/c1/2"), Values(17, 0));
  EXPECT_EQ(file.Read("meshes/1/faces/nodes/1/nnodes"), (Values{ 4, 4, 4, 3 }));
  EXPECT_EQ(file.Read("meshes/1/cells/zoneTopology/id"), (Values{ 2, 5, 2 }));
  std::string bytes = written.Bytes;
  const HDF5File content("test.msh.h5", bytes.data(), bytes.data() + bytes.size());
  EXPECT_NE(bytes.find("ANSYS_FLUENT_MESHING"), std::string::npos);
  EXPECT_NE(bytes.find("(39 (4 wall skin 1)("), std::string::npos);
  EXPECT_NE(bytes.find("inside;skin"), std::string::npos);
}

//------------------------------------------------------------------------------
// If this fails, a name with the character that separates names becomes two.
TEST(FluentHDF5Writer, Names)
{
  std::string text = Encode(MakeMixed(1));
  text.replace(text.find("skin"), 4, "s;in");
  const Written written = WriteContainer(ReadBoth(text));
  ASSERT_TRUE(written.Success);
  ASSERT_EQ(written.Warnings.size(), 2u); // and of split zones
  EXPECT_NE(
    written.Warnings[1].find("1 zone with ; in the name, written as \"-\""), std::string::npos);
  EXPECT_NE(Describe<vtkFluentHDF5Reader>(written.Bytes, "test.msh.h5").find("4 s-in wall 3"),
    std::string::npos);
}
