// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/ConnectivityKey.h"

#include "Base/Hash.h"
#include "vtkCamaronCompat.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr std::size_t MaxDataSets = 16;
}

//------------------------------------------------------------------------------
ConnectivityKey::ConnectivityKey(vtkDataSet* mesh)
  : DataSets{ { mesh, mesh ? mesh->GetMTime() : 0 } }
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh))
  {
    this->Add(grid->GetCells());
    this->Add(GetCellTypes(grid));
    this->Add(grid->GetPolyhedronFaces());
    this->Add(grid->GetPolyhedronFaceLocations());
  }
  else if (auto* surface = vtkPolyData::SafeDownCast(mesh))
  {
    this->Add(surface->GetVerts());
    this->Add(surface->GetLines());
    this->Add(surface->GetPolys());
    this->Add(surface->GetStrips());
  }
}

//------------------------------------------------------------------------------
void ConnectivityKey::Add(vtkCellArray* cells)
{
  if (cells && cells->GetNumberOfCells() > 0)
  {
    this->Add(cells->GetOffsetsArray());
    this->Add(cells->GetConnectivityArray());
  }
}

//------------------------------------------------------------------------------
void ConnectivityKey::Add(vtkDataArray* array)
{
  if (array)
  {
    this->Arrays.emplace_back(array, array->GetMTime(), array->GetNumberOfValues());
  }
}

//------------------------------------------------------------------------------
void ConnectivityKey::Learn()
{
  if (this->HasContent)
  {
    return;
  }
  this->Content = 1;
  for (const ArrayAt& array : this->Arrays)
  {
    this->Content = HashContent(static_cast<vtkDataArray*>(std::get<0>(array)), this->Content);
  }
  this->HasContent = true;
}

//------------------------------------------------------------------------------
bool ConnectivityKey::IsOf(ConnectivityKey& known)
{
  if (this->Arrays != known.Arrays)
  {
    return false;
  }
  std::vector<DataSetAt>& seen = known.DataSets;
  const DataSetAt own = this->DataSets.front();
  if (std::find(seen.begin(), seen.end(), own) != seen.end())
  {
    return true;
  }
  this->Learn();
  if (known.HasContent && this->Content != known.Content)
  {
    return false;
  }
  known.Content = this->Content;
  known.HasContent = true;
  if (seen.size() == MaxDataSets)
  {
    seen.erase(seen.begin());
  }
  seen.push_back(own);
  return true;
}
}
