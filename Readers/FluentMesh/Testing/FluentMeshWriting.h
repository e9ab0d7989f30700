// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// For tests of written Fluent files: files in memory, and comparison of the meshes read from them.
#ifndef camaron_FluentMeshWriting_h
#define camaron_FluentMeshWriting_h

#include "FluentMeshSamples.h"
#include "TestMeshes.h"
#include "vtkFluentMeshWriter.h"

namespace camaron
{
namespace testing
{
//------------------------------------------------------------------------------
inline Written Write(
  vtkDataObject* mesh, const std::function<void(vtkFluentMeshWriter*)>& configure = {})
{
  return WriteWith<vtkFluentMeshWriter>(mesh, "test.msh", configure);
}

inline Written WriteAs(vtkDataObject* mesh, int encoding)
{
  return Write(mesh, [encoding](vtkFluentMeshWriter* writer) { writer->SetEncoding(encoding); });
}

inline Result Read(const std::string& bytes)
{
  return ReadWith<vtkFluentMeshReader>(File(bytes, "test.msh").Path);
}

//------------------------------------------------------------------------------
// Same points (to the precision), types, and orientation of faces.
inline void ExpectSameCells(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b, bool single = false)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double x = a->GetPoint(i)[c];
      const double y = b->GetPoint(i)[c];
      EXPECT_TRUE(single ? static_cast<float>(x) == static_cast<float>(y) : x == y) << i;
    }
  }
  for (vtkIdType cell = 0; cell < a->GetNumberOfCells(); ++cell)
  {
    EXPECT_EQ(a->GetCellType(cell), b->GetCellType(cell)) << cell;
    EXPECT_EQ(GetFaceSet(a, cell), GetFaceSet(b, cell)) << cell;
  }
}
}
}

#endif
