// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TSurfValues.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr char IdName[] = "OriginalPointId";
}

//------------------------------------------------------------------------------
// Finds the arrays of the properties of an object, which other objects may share.
bool TSurfValues::AddObject(const TSurfObject& object, std::vector<std::size_t>& arrays)
{
  constexpr std::string_view OwnNames[] = { IdName, "GlobalPointIds", "vtkGhostType" };
  for (const TSurfProperty& property : object.Properties)
  {
    const std::string name = property.Name.empty() ? "Property" : property.Name;
    const auto same = std::find_if(this->Arrays.begin(), this->Arrays.end(),
      [&name](const Array& array) { return array.Name == name; });
    const auto place = static_cast<std::size_t>(same - this->Arrays.begin());
    if (same == this->Arrays.end())
    {
      this->Arrays.push_back({ name, property.Size, {} });
    }
    if (this->Arrays[place].Size != property.Size ||
      std::find(arrays.begin(), arrays.end(), place) != arrays.end() ||
      std::find(std::begin(OwnNames), std::end(OwnNames), name) != std::end(OwnNames))
    {
      return this->Scanner.FailAt(object.Begin, ErrorKind::Unsupported,
        "properties with a name of their own, or with as many values as in other surfaces, before "
        "this line",
        "'" + name + "'");
    }
    arrays.push_back(place);
  }
  return true;
}

//------------------------------------------------------------------------------
bool TSurfValues::MakeArrays(const TSurfRecords& records, vtkIdType numberOfPoints)
{
  this->ArraysOfObjects.resize(this->Objects.size());
  std::vector<bool> haveProperties(this->Objects.size() + 1);
  for (const TSurfRecords::Chunk& chunk : records.GetChunks())
  {
    haveProperties[chunk.Object] = haveProperties[chunk.Object] || chunk.HasProperties;
  }
  for (std::size_t i = 0; i < this->Objects.size(); ++i)
  {
    if (haveProperties[i] && !this->AddObject(this->Objects[i], this->ArraysOfObjects[i]))
    {
      return false;
    }
  }
  // With many values of a few vertices, arrays might not fit into memory.
  constexpr int MaxGrowth = 10;
  std::int64_t values = 0;
  for (const Array& array : this->Arrays)
  {
    values += array.Size;
  }
  const vtkIdType fileSize = this->Scanner.GetEnd() - this->Objects[0].Begin;
  const vtkIdType points = records.GetChunks().back().Points;
  constexpr int DoubleBytes = sizeof(double);
  if (values > 0 && points > MaxGrowth * fileSize / (DoubleBytes * values))
  {
    return this->Scanner.FailAt(this->Objects[0].Begin, ErrorKind::Unsupported,
      "properties for a larger part of the vertices",
      std::to_string(values) + " values per vertex");
  }
  for (Array& array : this->Arrays)
  {
    array.Values = Buffer<double>(numberOfPoints * array.Size);
    std::fill(array.Values.data(), array.Values.data() + array.Values.size(), NaN);
  }
  return true;
}

//------------------------------------------------------------------------------
// Reads a vertex; point is its index in the piece, or -1 if its values are not needed.
bool TSurfValues::ReadVertex(TextRow& row, TSurfLine what, std::size_t object, vtkIdType point)
{
  std::int64_t id;
  double x[3], value;
  if (!row.ReadInteger(id, VertexId) || !row.ReadPoint(x, Coordinate))
  {
    return false;
  }
  if (point >= 0)
  {
    std::copy(x, x + 3, this->Coordinates.data() + 3 * point);
  }
  const std::vector<TSurfProperty>& properties = this->Objects[object].Properties;
  const std::vector<std::size_t>& arrays = this->ArraysOfObjects[object];
  for (std::size_t p = 0; what == TSurfLine::PropertyVertex && p < arrays.size(); ++p)
  {
    Array& array = this->Arrays[arrays[p]];
    for (int c = 0; c < array.Size; ++c)
    {
      if (!row.ReadReal(value, "a value of a property"))
      {
        return false;
      }
      if (point >= 0 && !(properties[p].HasNoData && value == properties[p].NoData))
      {
        array.Values[point * array.Size + c] = value;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool TSurfValues::Read(TSurfRecords& records, const CellMeshPiece& piece, const Progress& progress)
{
  if (!this->MakeArrays(records, piece.GetNumberOfPoints()))
  {
    return false;
  }
  this->Coordinates = Buffer<double>(3 * piece.GetNumberOfPoints());
  this->Ids = Buffer<vtkIdType>(records.GetIds().size() > 0 ? piece.GetNumberOfPoints() : 0);
  return records.ForEachChunk(
    progress,
    [&](const TSurfRecords::Chunk& chunk)
    {
      const vtkIdType end = (&chunk + 1)->Points;
      vtkIdType vertex = chunk.Points;
      return TSurfRecords::ForEachLine(chunk,
        [&](TSurfLine what, TextRow& row, const char*)
        {
          if (what != TSurfLine::Vertex && what != TSurfLine::PropertyVertex)
          {
            return true;
          }
          if (vertex == end)
          {
            return false; // the file has changed since the vertices were counted
          }
          const vtkIdType point = piece.FindPoint(vertex);
          if (point >= 0 && this->Ids.size() > 0)
          {
            this->Ids[point] = records.GetIds()[vertex];
          }
          ++vertex;
          return this->ReadVertex(row, what, chunk.Object, point);
        });
    },
    [this](std::size_t object, TSurfLine what, TextRow& row)
    { this->ReadVertex(row, what, object, -1); });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> TSurfValues::TakePoints()
{
  return this->Coordinates.TakeArray<vtkDoubleArray>(3);
}

//------------------------------------------------------------------------------
void TSurfValues::AddArrays(vtkDataSetAttributes* data)
{
  for (Array& array : this->Arrays)
  {
    data->AddArray(array.Values.TakeArray<vtkDoubleArray>(array.Size, array.Name.c_str()));
  }
  if (this->Ids.size() > 0)
  {
    data->AddArray(this->Ids.TakeArray<vtkIdTypeArray>(1, IdName));
  }
}
}
