// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TSurfValues.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camaron
{
namespace
{
constexpr char Value[] = "a value of a property";
constexpr char IdName[] = "OriginalPointId";
// Arrays that are not properties.
constexpr std::string_view OwnNames[] = { IdName, "GlobalPointIds", "vtkGhostType" };
}

//------------------------------------------------------------------------------
std::size_t TSurfValues::FindArray(
  const TSurfProperty& property, const std::vector<std::size_t>& used)
{
  const auto isTaken = [this](const std::string& name)
  {
    const auto* const end = std::end(OwnNames);
    return std::find(std::begin(OwnNames), end, name) != end ||
      std::any_of(this->Arrays.begin(), this->Arrays.end(),
        [&](const Array& array) { return array.Name == name; });
  };
  const std::string base = property.Name.empty() ? "Property" : property.Name;
  std::string name = base;
  for (int number = 2;; ++number)
  {
    const auto same = std::find_if(this->Arrays.begin(), this->Arrays.end(),
      [&](const Array& array) { return array.Name == name && array.Size == property.Size; });
    const auto place = static_cast<std::size_t>(same - this->Arrays.begin());
    if (same != this->Arrays.end() && std::find(used.begin(), used.end(), place) == used.end())
    {
      return place;
    }
    if (!isTaken(name))
    {
      this->Arrays.push_back({ name, property.Size, {} });
      return this->Arrays.size() - 1;
    }
    name = base + "_" + std::to_string(number);
  }
}

//------------------------------------------------------------------------------
// Before memory is allocated, checks that the file can contain so many values.
bool TSurfValues::MakeArrays(const TSurfRecords& records, vtkIdType numberOfPlaces)
{
  this->ArraysOfObjects.resize(this->Objects.size());
  for (std::size_t i = 0; i < this->Objects.size(); ++i)
  {
    const TSurfObject& object = this->Objects[i];
    const vtkIdType number = records.GetNumberOfPropertyRecords(i);
    if (number == 0)
    {
      continue; // no vertex of the object has properties
    }
    constexpr int ValueBytes = 2; // "0" and a blank
    const std::int64_t possible = (object.End - object.Begin) / (number * ValueBytes);
    if (object.GetNumberOfValues() > possible)
    {
      return this->Scanner.FailAt(object.Begin, ErrorKind::Count,
        "properties with at most " + std::to_string(possible) + " values in total before this line",
        std::to_string(object.GetNumberOfValues()));
    }
    for (const TSurfProperty& property : object.Properties)
    {
      this->ArraysOfObjects[i].push_back(this->FindArray(property, this->ArraysOfObjects[i]));
    }
  }
  // With a few vertices with many values, and many without any, arrays might not fit into memory.
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
    array.Values = Buffer<double>(numberOfPlaces * array.Size);
    std::fill(array.Values.data(), array.Values.data() + array.Values.size(),
      std::numeric_limits<double>::quiet_NaN());
  }
  return true;
}

//------------------------------------------------------------------------------
// Calls take(array, component, value) for the values of a row, up to its end or to CNXYZ.
template <typename Take>
bool TSurfValues::ReadProperties(TextRow& row, std::size_t object, Fit& fit, Take&& take) const
{
  constexpr std::string_view Control = "CNXYZ"; // constraint of a vertex
  std::string_view word;
  double value;
  const std::vector<TSurfProperty>& properties = this->Objects[object].Properties;
  const std::vector<std::size_t>& arrays = this->ArraysOfObjects[object];
  for (std::size_t p = 0; p < arrays.size(); ++p)
  {
    for (int c = 0; c < properties[p].Size; ++c)
    {
      if (!row.HasMore() || !row.ReadWord(word, Value) || word == Control)
      {
        fit = Fit::Short;
        return true;
      }
      const char* const end = word.data() + word.size();
      if (ParseReal(word.data(), end, value) != end)
      {
        return row.FailAt(word.data(), ErrorKind::Syntax, Value);
      }
      const bool isNone = properties[p].HasNoData && value == properties[p].NoData;
      take(arrays[p], c, isNone ? std::numeric_limits<double>::quiet_NaN() : value);
    }
  }
  if (row.HasMore() && row.ReadWord(word, Value) &&
    ParseReal(word.data(), word.data() + word.size(), value) == word.data() + word.size())
  {
    fit = Fit::Long;
  }
  return true;
}

//------------------------------------------------------------------------------
void TSurfValues::FindOutside(const TSurfRecords& records, const CellMeshPiece& piece)
{
  for (const TSurfRecords::Chunk& chunk : records.GetChunks())
  {
    for (const TSurfRecords::Atom& atom : chunk.Atoms)
    {
      const std::int32_t point = records.GetPoint(atom.Record);
      if (atom.What == TSurfLine::PropertyAtom && piece.FindPoint(point) < 0)
      {
        this->Outside.push_back(point);
      }
    }
  }
  std::sort(this->Outside.begin(), this->Outside.end());
  this->Outside.erase(std::unique(this->Outside.begin(), this->Outside.end()), this->Outside.end());
}

//------------------------------------------------------------------------------
vtkIdType TSurfValues::FindPlace(vtkIdType point, const CellMeshPiece& piece) const
{
  const vtkIdType local = piece.FindPoint(point);
  if (local >= 0)
  {
    return local;
  }
  const auto found = std::lower_bound(this->Outside.begin(), this->Outside.end(), point);
  return found != this->Outside.end() && *found == point
    ? piece.GetNumberOfPoints() + (found - this->Outside.begin())
    : -1;
}

//------------------------------------------------------------------------------
// Reads any vertex or atom; place is -1 if its values are not needed.
bool TSurfValues::ReadVertex(
  TextRow& row, TSurfLine what, std::size_t object, vtkIdType place, Fit& fit)
{
  std::int64_t id;
  if (!row.ReadInteger(id, VertexId))
  {
    return false;
  }
  if (!IsAtom(what))
  {
    double x[3];
    if (!row.ReadPoint(x, Coordinate))
    {
      return false;
    }
    if (place >= 0)
    {
      std::copy(x, x + 3, this->Coordinates.data() + 3 * place);
    }
  }
  else if (!row.ReadInteger(id, VertexId))
  {
    return false;
  }
  return !HasProperties(what) ||
    this->ReadProperties(row, object, fit,
      [this, place](std::size_t array, int component, double value)
      {
        if (place >= 0)
        {
          Array& to = this->Arrays[array];
          to.Values[place * to.Size + component] = value;
        }
      });
}

//------------------------------------------------------------------------------
const char* TSurfValues::ReadChunk(
  const TSurfRecords& records, const TSurfRecords::Chunk& chunk, const CellMeshPiece& piece)
{
  const TSurfRecords::Chunk& next = *(&chunk + 1);
  vtkIdType record = chunk.Records, point = chunk.Points, shortRecords = 0, longRecords = 0;
  const char* const wrong = TSurfRecords::ForEachLine(chunk,
    [&](TSurfLine what, TextRow& row, const char*)
    {
      if (what == TSurfLine::Triangle || what == TSurfLine::Face)
      {
        return true;
      }
      // The values of atoms are read later.
      const bool isAtom = IsAtom(what);
      if (record == next.Records || (!isAtom && point == next.Points))
      {
        return false; // the file has changed since the records were counted
      }
      const vtkIdType place = isAtom ? -1 : this->FindPlace(point, piece);
      Fit fit = Fit::Exact;
      if (!this->ReadVertex(row, what, chunk.Object, place, fit))
      {
        return false;
      }
      if (place >= 0 && this->Ids.size() > 0)
      {
        this->Ids[place] = records.GetId(record);
      }
      shortRecords += fit == Fit::Short;
      longRecords += fit == Fit::Long;
      point += !isAtom;
      ++record;
      return true;
    });
  this->Short += shortRecords;
  this->Long += longRecords;
  return wrong;
}

//------------------------------------------------------------------------------
// Serial, as several atoms may refer to the same vertex. They set values that it lacks.
void TSurfValues::ReadAtoms(const TSurfRecords& records, const CellMeshPiece& piece)
{
  for (const TSurfRecords::Chunk& chunk : records.GetChunks())
  {
    for (const TSurfRecords::Atom& atom : chunk.Atoms)
    {
      if (atom.What != TSurfLine::PropertyAtom)
      {
        continue;
      }
      const vtkIdType place = this->FindPlace(records.GetPoint(atom.Record), piece);
      const Line line(atom.Text, this->Scanner.GetEnd());
      const char* text = line.Begin;
      ReadKeyword(text, line.End);
      TextRow row(text, line.End, '#');
      std::int64_t id;
      Fit fit;
      bool isOther = false;
      row.ReadInteger(id, VertexId);
      row.ReadInteger(id, VertexId);
      this->ReadProperties(row, chunk.Object, fit,
        [&](std::size_t array, int component, double value)
        {
          Array& to = this->Arrays[array];
          double& present = to.Values[place * to.Size + component];
          isOther = isOther || (!std::isnan(present) && !std::isnan(value) && present != value);
          present = std::isnan(present) ? value : present;
        });
      this->Conflicts += isOther;
    }
  }
}

//------------------------------------------------------------------------------
bool TSurfValues::Read(TSurfRecords& records, const CellMeshPiece& piece, const Progress& progress)
{
  this->NumberOfPoints = piece.GetNumberOfPoints();
  this->FindOutside(records, piece);
  const vtkIdType places = this->NumberOfPoints + static_cast<vtkIdType>(this->Outside.size());
  if (!this->MakeArrays(records, places))
  {
    return false;
  }
  this->Coordinates = Buffer<double>(3 * places);
  this->Ids = Buffer<vtkIdType>(records.HasPlainIds() ? 0 : places);
  std::size_t object = 0;
  const bool good = records.ForEachChunk(
    progress, [&](TSurfRecords::Chunk& chunk) { return this->ReadChunk(records, chunk, piece); },
    [&](TSurfLine what, TextRow& row)
    {
      while (
        object + 1 < this->Objects.size() && row.GetPosition() >= this->Objects[object + 1].Begin)
      {
        ++object;
      }
      Fit fit;
      this->ReadVertex(row, what, object, -1, fit);
    });
  if (good)
  {
    this->ReadAtoms(records, piece);
  }
  return good;
}

//------------------------------------------------------------------------------
void TSurfValues::Warn(Warnings& warnings) const
{
  const auto warn = [&warnings](const char* what, vtkIdType count)
  {
    if (count > 0)
    {
      warnings.Add(what + std::to_string(count));
    }
  };
  warn("vertices with fewer values than the properties have: ", this->Short);
  warn("vertices with more values than the properties have, which are omitted: ", this->Long);
  warn(
    "atoms whose values differ from those of their vertex, which keeps its own: ", this->Conflicts);
}

//------------------------------------------------------------------------------
template <typename VTKArray, typename Value>
vtkSmartPointer<VTKArray> TSurfValues::TakeOfPiece(
  Buffer<Value>& values, int size, const char* name) const
{
  const auto array = values.template TakeArray<VTKArray>(size, name);
  if (!this->Outside.empty())
  {
    array->Resize(this->NumberOfPoints); // without values outside of the piece
  }
  return array;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> TSurfValues::TakePoints()
{
  return this->TakeOfPiece<vtkDoubleArray>(this->Coordinates, 3, nullptr);
}

//------------------------------------------------------------------------------
void TSurfValues::AddArrays(vtkDataSetAttributes* data)
{
  for (Array& array : this->Arrays)
  {
    data->AddArray(this->TakeOfPiece<vtkDoubleArray>(array.Values, array.Size, array.Name.c_str()));
  }
  if (this->Ids.size() > 0)
  {
    data->AddArray(this->TakeOfPiece<vtkIdTypeArray>(this->Ids, 1, IdName));
  }
}
}
