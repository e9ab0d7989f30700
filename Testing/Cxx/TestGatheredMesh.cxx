// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Pieces that become one mesh again, which is written to one file.
#include "GatheredMesh.h"
#include "TestMeshes.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

using namespace camaron;
using namespace camaron::testing;

//------------------------------------------------------------------------------
// If this fails, a file depends on the number of processes that wrote it.
TEST(GatheredMesh, KeepsTheOrderAndTheRoleOfArrays)
{
  std::vector<Grid> grids;
  std::vector<vtkDataSet*> pieces;
  for (int p = 0; p < 2; ++p)
  {
    grids.push_back(MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } }));
    for (const char* name : { "zeta", "alpha", "mid" })
    {
      vtkNew<vtkDoubleArray> ofPoints, ofCells;
      ofPoints->SetName(name);
      ofPoints->SetNumberOfComponents(3);
      ofPoints->SetNumberOfTuples(3);
      ofPoints->Fill(p);
      ofCells->SetName(name);
      ofCells->InsertNextValue(p);
      grids[p]->GetPointData()->AddArray(ofPoints);
      grids[p]->GetCellData()->AddArray(ofCells);
    }
    grids[p]->GetPointData()->SetActiveNormals("mid");
    pieces.push_back(grids[p]);
  }
  const auto merged = MergePieces(pieces);
  ASSERT_EQ(merged->GetPointData()->GetNumberOfArrays(), 3);
  ASSERT_EQ(merged->GetCellData()->GetNumberOfArrays(), 3);
  const char* const expected[] = { "zeta", "alpha", "mid" };
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_STREQ(merged->GetPointData()->GetArrayName(i), expected[i]);
    EXPECT_STREQ(merged->GetCellData()->GetArrayName(i), expected[i]);
    EXPECT_EQ(merged->GetCellData()->GetArray(i)->GetTuple1(1), 1);
  }
  ASSERT_NE(merged->GetPointData()->GetNormals(), nullptr);
  EXPECT_STREQ(merged->GetPointData()->GetNormals()->GetName(), "mid");
}
