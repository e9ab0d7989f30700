// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// OFF files read by several threads, and in pieces by several processes.
#include "PolygonOFFReading.h"
#include "PolygonOFFSamples.h"

#include "vtkSMPTools.h"

using namespace camaron;
using namespace camaron::testing;

//------------------------------------------------------------------------------
// If this fails, the mesh depends on threads, or on where text is split for them.
TEST(PolygonOFFPieces, ThreadsAndChunksChangeNothing)
{
  Sample colored;
  colored.Keyword = "STCNOFF";
  colored.HasTexture = colored.HasColors = colored.HasNormals = true;
  std::string late = Sample().GetText(2000); // the last face has a color, or another size
  std::string wrapped = late;
  wrapped[wrapped.rfind(' ')] = '\n';
  for (const std::string& text : { Sample().GetText(2000), colored.GetText(2000),
         MakeMixedText(200), MakeMixedText(200, "\r\n\r\n# x\r\n"), MakeMixedText(200, "\r"),
         late.insert(late.size() - 1, " 1 2 3"), wrapped, colored.GetBinary(20000) })
  {
    const File file(text, "test.off");
    vtkNew<vtkUnstructuredGrid> expected;
    Warnings warnings;
    ScanError error;
    vtkSMPTools::LocalScope(vtkSMPTools::Config(1), [&]
      { ASSERT_TRUE(ReadPolygonOFF(file.Path, {}, expected, warnings, error)) << error.Message; });
    EXPECT_GE(expected->GetNumberOfCells(), 2000);
    for (const int threads : { 1, 2, 3 })
    {
      for (const vtkIdType chunk : { 50, 1000, 20000 })
      {
        vtkNew<vtkUnstructuredGrid> grid;
        Warnings again;
        vtkSMPTools::LocalScope(vtkSMPTools::Config(threads), [&]
          { ASSERT_TRUE(ReadPolygonOFF(file.Path, {}, grid, again, error, Progress(), chunk)); });
        ExpectSameGrid(expected, grid);
        EXPECT_EQ(again.GetSentences(), warnings.GetSentences());
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, ranks together lack parts of the mesh, or colors depend on the data of a rank.
TEST(PolygonOFFPieces, PiecesMakeTheWhole)
{
  Sample colored;
  colored.Keyword = "STCNOFF";
  colored.HasTexture = colored.HasColors = colored.HasNormals = true;
  const std::string unequal =
    "COFF\n6 2 0\n0 0 0 1 0 0\n1 0 0 0 1 0\n0 1 0 0 1 0\n0 0 1 8 8 8\n1 0 1 8 8 8\n"
    "0 1 1 8 8 8\n3 0 1 2 1 1 1\n3 3 4 5 0.5 0 0\n";
  std::string sizes =
    "OFF\n43 40 0\n"; // triangles and quadrilaterals, of which the last has a color
  for (int i = 0; i < 43; ++i)
  {
    sizes += std::to_string(i) + " " + std::to_string(i * i % 7) + " 0\n";
  }
  sizes += "\n# faces\n";
  for (int i = 0; i < 40; ++i)
  {
    const std::string first = std::to_string(i) + " " + std::to_string(i + 1) + " ";
    sizes += (i % 2 == 0 ? "  3 " + first : "4 " + first + std::to_string(i + 2) + " ") +
      std::to_string(i + 3) + (i == 39 ? " 1 2 3\n" : "\n");
  }
  const vtkIdType usual = TextLines::DefaultChunk;
  for (const std::string& text : { colored.GetText(100), colored.GetBinary(100), MakeMixedText(3),
         unequal, sizes, std::string("OFF\n2 0 0\n0 0 0\n1 0 0\n") })
  {
    const File file(text, "test.off");
    for (const vtkIdType chunk : { usual, vtkIdType(64) })
    {
      TextLines::DefaultChunk = chunk;
      ExpectPiecesMakeTheWhole<vtkPolygonOFFReader>(file.Path, 3, 0);
      ExpectPiecesMakeTheWhole<vtkPolygonOFFReader>(file.Path, 3, 2);
      ExpectPiecesMakeTheWhole<vtkPolygonOFFReader>(file.Path, 120, 1);
    }
  }
  TextLines::DefaultChunk = usual;
}
