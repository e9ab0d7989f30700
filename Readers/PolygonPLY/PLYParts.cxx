// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PLYParts.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The list of vertices, which has its usual name or is the only list of integers.
int FindList(const PLYElement& element)
{
  const int named = element.Find({ "vertex_indices", "vertex_index" }, true);
  if (named >= 0)
  {
    return named;
  }
  int found = -1;
  for (std::size_t i = 0; i < element.Properties.size(); ++i)
  {
    if (element.Properties[i].IsList && !IsReal(element.Properties[i].Type))
    {
      if (found >= 0)
      {
        return -1;
      }
      found = static_cast<int>(i);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
// Camarón writes edges as five integers that the header does not declare.
void AddPropertiesOfCamaron(PLYElement& element)
{
  for (const char* name : { "vertex1", "vertex2", "red", "green", "blue" })
  {
    element.Properties.push_back({ name, ValueType::Int32 });
  }
  element.HasByteColors = true;
}

//------------------------------------------------------------------------------
// Appends the triangles of a strip, whose parts -1 separates; orientation alternates. Those with a
// repeated vertex, which connect parts of a strip, are left out.
void AppendTriangles(const std::int32_t* ids, vtkIdType size, std::vector<std::int32_t>& triangles)
{
  vtkIdType begin = 0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (ids[i] < 0)
    {
      begin = i + 1;
    }
    else if (i >= begin + 2)
    {
      const bool isOdd = ((i - begin) & 1) != 0;
      const std::int32_t a = ids[i - 2], b = ids[isOdd ? i : i - 1], c = ids[isOdd ? i - 1 : i];
      if (a != b && b != c && c != a)
      {
        triangles.insert(triangles.end(), { a, b, c });
      }
    }
  }
}

//------------------------------------------------------------------------------
bool LoadStrips(CellLists::Part& part, const Progress& progress)
{
  ListSizes sizes;
  Buffer<std::int32_t> strips;
  if (!part.Rows->ReadLists(part.List, part.Expected, sizes, strips, progress))
  {
    return false;
  }
  part.Ids.reserve(static_cast<std::size_t>(3 * sizes.Total)); // at most
  for (vtkIdType row = 0; row < part.Rows->GetCount(); ++row)
  {
    AppendTriangles(strips.data() + sizes.GetOffset(row), sizes.GetSize(row), part.Ids);
  }
  part.Sizes.Common = 3;
  return true;
}

//------------------------------------------------------------------------------
bool LoadEdges(CellLists::Part& part, const Progress& progress)
{
  part.Ids.resize(static_cast<std::size_t>(2 * part.Rows->GetCount()));
  part.Sizes.Common = 2;
  ListSizes sizes;
  sizes.Common = 1;
  bool good = true;
  for (int end = 0; end < 2 && good; ++end)
  {
    good = part.Rows->ReadIds(
      static_cast<const PLYPart&>(part).Ends[end], part.Expected, sizes, nullptr,
      [&](vtkIdType first, vtkIdType count, const std::int32_t* ids)
      {
        for (vtkIdType i = 0; i < count; ++i)
        {
          part.Ids[static_cast<std::size_t>(2 * (first + i) + end)] = ids[i];
        }
      },
      nullptr, progress);
  }
  return good;
}
}

//------------------------------------------------------------------------------
PLYPart MakePart(const PLYElement& element, bool hasPoints)
{
  PLYPart part;
  part.Element = element;
  const std::string& name = element.Name;
  if (name == "edge" && element.Properties.empty())
  {
    AddPropertiesOfCamaron(part.Element);
  }
  const auto find = [&](std::initializer_list<const char*> names, bool isList)
  { return part.Element.Find(names, isList); };
  if (name == "vertex" && !hasPoints)
  {
    part.Role = PLYRole::Points;
  }
  else if (name == "face" || name == "tristrips")
  {
    part.List = FindList(part.Element);
    part.Role = part.List < 0 ? PLYRole::None : name == "face" ? PLYRole::Faces : PLYRole::Strips;
    part.Expected.What = name == "face" ? "a vertex of a face" : "a vertex of a strip";
  }
  else if (name == "edge")
  {
    part.Ends[0] = find({ "vertex1", "v1" }, false);
    part.Ends[1] = find({ "vertex2", "v2" }, false);
    const bool hasEnds = part.Ends[0] >= 0 && part.Ends[1] >= 0;
    part.List = hasEnds ? -1 : FindList(part.Element);
    part.Role = hasEnds || part.List >= 0 ? PLYRole::Edges : PLYRole::None;
    part.Load = hasEnds ? LoadEdges : nullptr;
    part.Expected.What = "a vertex of an edge";
    part.AreLines = true;
  }
  else if (name == "cell" || name == "polyhedron")
  {
    part.List = find({ "face_indices", "face_index" }, true);
    part.Role = part.List >= 0 ? PLYRole::Polyhedra : PLYRole::None;
    part.Expected.What = "a face of a cell";
  }
  if (part.Role == PLYRole::Strips)
  {
    part.Load = LoadStrips;
    part.Expected.HasBreaks = IsSigned(part.Element.Properties[part.List].Type);
  }
  part.Used.resize(part.Element.Properties.size(), false);
  for (const int property : { part.List, part.Load == LoadEdges ? part.Ends[0] : -1,
         part.Load == LoadEdges ? part.Ends[1] : -1 })
  {
    if (property >= 0)
    {
      part.Used[property] = true;
    }
  }
  return part;
}
}
