// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MAPDLSamples.h
 * @brief Small decks, and functions that read them.
 */
#ifndef MAPDLSamples_h
#define MAPDLSamples_h

#include "FormatTesting.h"
#include "MAPDLReading.h"
#include "vtkMAPDLReader.h"

#include <cstdarg>
#include <cstdio>

namespace camaron
{
namespace testing
{
inline Result ReadDeck(const std::string& text)
{
  return ReadWith<vtkMAPDLReader>(File(text, "test.cdb").Path);
}

inline std::string Format(const char* format, ...)
{
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof(text), format, arguments);
  va_end(arguments);
  return text;
}

/// Position of a node of a sample: none are on a line or plane, and node 1 is not the origin.
inline void GetPlace(int id, double x[3])
{
  x[0] = id;
  x[1] = 0.5 * id * id;
  x[2] = 0.25 * id * id * id - 1;
}

/// N commands for nodes first to last.
inline std::string MakeNodes(int first, int last)
{
  std::string text;
  for (int id = first; id <= last; ++id)
  {
    double x[3];
    GetPlace(id, x);
    text += Format("N,%d,%.17g,%.17g,%.17g\n", id, x[0], x[1], x[2]);
  }
  return text;
}

/// A row of a SOLID block in columns of @a width, with the necessary number of lines.
inline std::string MakeRow(int id, int type, const std::vector<int>& nodes, int width = 9)
{
  std::string text =
    Format("%*d%*d%*d%*d%*d%*d%*d%*d%*d%*d%*d", width, 2, width, type, width, 3, width, 4, width, 0,
      width, 0, width, 0, width, 0, width, static_cast<int>(nodes.size()), width, 0, width, id);
  int fields = 11;
  for (const int node : nodes)
  {
    if (fields == 19)
    {
      text += "\n";
      fields = 0;
    }
    text += Format("%*d", width, node);
    ++fields;
  }
  return text + "\n";
}

/// Ids of the nodes of a cell.
inline std::vector<int> GetNodes(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkNew<vtkIdList> points;
  grid->GetCellPoints(cell, points);
  std::vector<int> nodes;
  for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
  {
    nodes.push_back(
      static_cast<int>(grid->GetPointData()->GetArray("NodeId")->GetTuple1(points->GetId(i))));
  }
  return nodes;
}

inline int GetValue(vtkUnstructuredGrid* grid, const char* array, vtkIdType cell)
{
  vtkDataArray* const values = grid->GetCellData()->GetArray(array);
  return values ? static_cast<int>(values->GetTuple1(cell)) : -999;
}

/// A bar of bricks of 8 or 20 nodes, of wedges and shells, in blocks, with components.
inline std::string MakeBar(int bricks, bool quadratic, const std::string& lineEnd = "\n")
{
  std::string text = "/COM,ANSYS RELEASE 2024\n/PREP7\nET,1,186\nET,2,SHELL181\n";
  // Nodes: 12 per cross section, of which 4 are vertices.
  const int nodes = 12 * (bricks + 1);
  text += Format("NBLOCK,6,SOLID,%10d,%10d\n(3i9,6e21.13e3)\n", nodes, nodes);
  for (int id = 1; id <= nodes; ++id)
  {
    const int section = (id - 1) / 12, i = (id - 1) % 12;
    text += Format("%9d%9d%9d%21.13E%21.13E%21.13E\n", id, 0, 0, section + 0.5 * (i >= 8),
      i % 4 == 1 || i % 4 == 2 ? 1. : 0.01 * i, i % 4 >= 2 ? 1. : 0.);
  }
  text +=
    Format("N,UNBL,LOC,       -1,\nEBLOCK,19,SOLID,%10d,%10d\n(19i9)\n", 3 * bricks, 3 * bricks);
  for (int b = 0; b < bricks; ++b)
  {
    const int a = 12 * b + 1, z = a + 12;
    std::vector<int> brick{ a, a + 1, a + 2, a + 3, z, z + 1, z + 2, z + 3 };
    if (quadratic && b % 3 != 1)
    {
      brick.insert(brick.end(),
        { a + 4, a + 5, a + 6, b % 5 == 2 ? 0 : a + 7, z + 4, z + 5, z + 6, z + 7, a + 8, a + 9,
          a + 10, a + 11 });
    }
    text += MakeRow(3 * b + 1, 1, brick);
    text += MakeRow(3 * b + 2, 1, { a, a + 1, a + 2, a + 2, z, z + 1, z + 2, z + 2 });
    text += MakeRow(3 * b + 3, 2, { a, a + 1, a + 2, a + 3 });
  }
  text += "       -1\nCMBLOCK,EVERY,NODE,2\n(8i10)\n";
  text += Format("%10d%10d\n", 1, -nodes);
  text += "CMBLOCK,Wedges,ELEM," + std::to_string(bricks) + "\n(8i10)\n";
  for (int b = 0; b < bricks; ++b)
  {
    text += Format("%10d", 3 * b + 2) + (b % 8 == 7 || b + 1 == bricks ? "\n" : "");
  }
  text += "FINISH\n";
  if (lineEnd != "\n")
  {
    std::string other;
    for (const char c : text)
    {
      other += c == '\n' ? lineEnd : std::string(1, c);
    }
    return other;
  }
  return text;
}
}
}

#endif
