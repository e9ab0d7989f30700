// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PLYParts.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The list with one of these names, or else the only list of integers.
int FindList(const PLYElement& element, std::initializer_list<const char*> names)
{
  const int named = element.Find(names, true);
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
}

//------------------------------------------------------------------------------
// Camarón writes edges as five integers that the header does not declare.
void CompleteElement(PLYElement& element)
{
  if (element.Name != "edge" || !element.Properties.empty())
  {
    return;
  }
  for (const char* name : { "vertex1", "vertex2", "red", "green", "blue" })
  {
    TableProperty property;
    property.Name = name;
    property.Type = ValueType::Int32;
    element.Properties.push_back(property);
  }
  element.HasByteColors = true;
}

//------------------------------------------------------------------------------
PLYPart MakePart(const PLYElement& element, bool hasPoints)
{
  PLYPart part;
  part.Element = element;
  const std::string& name = element.Name;
  std::vector<int> used;
  if (name == "vertex" && !hasPoints)
  {
    part.Role = PLYRole::Points;
  }
  else if (name == "face" || name == "tristrips")
  {
    part.List = FindList(element, { "vertex_indices", "vertex_index" });
    part.Role = part.List < 0 ? PLYRole::None : name == "face" ? PLYRole::Faces : PLYRole::Strips;
  }
  else if (name == "edge")
  {
    part.Ends[0] = element.Find({ "vertex1", "v1" }, false);
    part.Ends[1] = element.Find({ "vertex2", "v2" }, false);
    const bool hasEnds = part.Ends[0] >= 0 && part.Ends[1] >= 0;
    part.List = hasEnds ? -1 : FindList(element, { "vertex_indices", "vertex_index" });
    part.Role = hasEnds || part.List >= 0 ? PLYRole::Edges : PLYRole::None;
    used = hasEnds ? std::vector<int>{ part.Ends[0], part.Ends[1] } : std::vector<int>();
  }
  else if (name == "cell" || name == "polyhedron")
  {
    part.List = element.Find({ "face_indices", "face_index" }, true);
    part.Role = part.List >= 0 ? PLYRole::Polyhedra : PLYRole::None;
  }
  if (part.List >= 0)
  {
    used.push_back(part.List);
  }
  part.Used.resize(element.Properties.size(), false);
  for (const int property : used)
  {
    part.Used[property] = true;
  }
  return part;
}
}
