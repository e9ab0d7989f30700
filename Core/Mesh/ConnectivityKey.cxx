// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/ConnectivityKey.h"

#include "Mesh/FacetKey.h"
#include "Parallel.h"
#include "vtkCamaronCompat.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <cstring>

namespace camaron
{
namespace
{
constexpr std::size_t MaxDataSets = 16;
constexpr vtkIdType BlockSize = 1 << 20; // bytes

//------------------------------------------------------------------------------
// In four lanes, which a processor works on at the same time.
std::uint64_t HashBytes(const unsigned char* bytes, vtkIdType size, std::uint64_t seed)
{
  std::uint64_t lanes[4] = { seed, seed + 1, seed + 2, seed + 3 };
  std::uint64_t words[4];
  for (; size >= static_cast<vtkIdType>(sizeof(words)); size -= sizeof(words), bytes += sizeof(words))
  {
    std::memcpy(words, bytes, sizeof(words));
    for (int i = 0; i < 4; ++i)
    {
      lanes[i] = FacetKey::Mix(lanes[i], words[i]);
    }
  }
  std::memset(words, 0, sizeof(words));
  std::memcpy(words, bytes, static_cast<std::size_t>(size));
  std::uint64_t hash = FacetKey::Mix(seed, static_cast<std::uint64_t>(size));
  for (int i = 0; i < 4; ++i)
  {
    hash = FacetKey::Mix(hash, FacetKey::Mix(lanes[i], words[i]));
  }
  return hash;
}

//------------------------------------------------------------------------------
// Arrays that are computed have no content but their parameters, which change with their time.
std::uint64_t HashValues(vtkDataArray* array, std::uint64_t seed)
{
  std::uint64_t hash = FacetKey::Mix(seed, static_cast<std::uint64_t>(array->GetNumberOfValues()));
  if (!array->HasStandardMemoryLayout())
  {
    return hash;
  }
  const auto* const bytes = static_cast<const unsigned char*>(array->GetVoidPointer(0));
  const vtkIdType size = array->GetNumberOfValues() * array->GetDataTypeSize();
  std::atomic<std::uint64_t> sum{ 0 }; // so that the order of blocks does not matter
  ParallelFor((size + BlockSize - 1) / BlockSize, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType block = begin; block < end; ++block)
      {
        const vtkIdType first = block * BlockSize;
        sum += HashBytes(bytes + first, std::min(BlockSize, size - first), FacetKey::Mix(hash, block));
      }
    });
  return FacetKey::Mix(hash, sum);
}
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
    this->Content = HashValues(static_cast<vtkDataArray*>(std::get<0>(array)), this->Content);
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
