// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshElementsTesting.h
 * @brief What the tests of faces, edges and vertices share: all of them of a mesh, with all arrays.
 */
#ifndef camaron_MeshElementsTesting_h
#define camaron_MeshElementsTesting_h

#include "Elements/MeshElements.h"
#include "TestMeshes.h"

#include "vtkCellData.h"
#include "vtkPolyData.h"

#include <memory>
#include <string>
#include <vector>

namespace camaron
{
namespace testing
{
inline double Get(vtkPolyData* data, const char* name, vtkIdType i)
{
  return data->GetCellData()->GetArray(name)->GetComponent(i, 0);
}

inline double Sum(vtkPolyData* data, const char* name)
{
  double sum = 0;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    sum += Get(data, name, i);
  }
  return sum;
}

inline std::vector<std::string> GetNames(const std::vector<ElementArray>& rows)
{
  std::vector<std::string> names;
  for (const ElementArray& row : rows)
  {
    names.emplace_back(row.Name);
  }
  return names;
}

// With all arrays that there are.
struct Elements
{
  vtkNew<vtkPolyData> Faces, Edges, Vertices;
  explicit Elements(vtkDataSet* mesh, double mergeTolerance = 0, const ElementSource& source = {})
  {
    const MeshTopology topology(mesh);
    const ElementContext context(mesh, topology, EvaluationOptions(), mergeTolerance, source);
    MakeFaces(context, GetNames(GetFaceArrays()), this->Faces);
    MakeEdges(context, GetNames(GetEdgeArrays()), this->Edges);
    MakeVertices(context, GetNames(GetVertexArrays()), this->Vertices);
    AddWorstOfCells(context, this->Vertices);
  }
};
}
}

#endif
