// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentCellFaces.h"

#include "Mesh/MeshTopology.h"

namespace camaron
{
//------------------------------------------------------------------------------
void FluentFaceTree::Build()
{
  std::stable_sort(this->Entries.begin(), this->Entries.end(),
    [](const Entry& a, const Entry& b) { return a.Child < b.Child; });
  std::vector<vtkIdType> parents;
  for (const Entry& entry : this->Entries)
  {
    parents.push_back(entry.Parent);
  }
  std::sort(parents.begin(), parents.end());
  for (const vtkIdType parent : parents)
  {
    if (this->Parents.empty() || this->Parents.back().first != parent)
    {
      this->Parents.emplace_back(parent, 0);
    }
    ++this->Parents.back().second;
  }
}

//------------------------------------------------------------------------------
vtkIdType FluentFaceTree::GetNumberOfParts(vtkIdType parent) const
{
  const auto found = std::lower_bound(
    this->Parents.begin(), this->Parents.end(), std::make_pair(parent, vtkIdType(0)));
  return found != this->Parents.end() && found->first == parent ? found->second : 0;
}

//------------------------------------------------------------------------------
vtkIdType FluentFaceTree::FindParent(vtkIdType child) const
{
  const auto entry = std::lower_bound(this->Entries.begin(), this->Entries.end(), child,
    [](const Entry& e, vtkIdType face) { return e.Child < face; });
  return entry != this->Entries.end() && entry->Child == child ? entry->Parent : -1;
}

//------------------------------------------------------------------------------
FluentShape GetFluentShape(FluentElement element)
{
  static constexpr FluentShape Shapes[] = { {}, { VTK_TRIANGLE, 3, 3 }, { VTK_TETRA, 4, 4 },
    { VTK_QUAD, 4, 4 }, { VTK_HEXAHEDRON, 8, 6 }, { VTK_PYRAMID, 5, 5 }, { VTK_WEDGE, 6, 5 } };
  return Shapes[static_cast<std::size_t>(element)];
}

//------------------------------------------------------------------------------
FluentShape FluentMesh::GetShape(vtkIdType cell) const
{
  const FluentElement element = this->Cells.GetElement(this->Piece.GetLeaf(cell));
  return element != FluentElement::Polyhedron
    ? GetFluentShape(element)
    : FluentShape{ static_cast<unsigned char>(this->Dimension == 2 ? VTK_POLYGON : VTK_POLYHEDRON),
        0, 0 };
}

//------------------------------------------------------------------------------
void FluentMesh::ProvideFaces(vtkUnstructuredGrid* grid, LargeVector<Index>&& lists) const
{
  vtkIdType count = this->Faces.GetCount();
  if (!this->Piece.IsWhole())
  {
    IdSet used(count);
    for (const Index face : lists)
    {
      used.Add(face);
    }
    count = used.Number();
    for (Index& face : lists)
    {
      face = static_cast<Index>(used.GetNumber(face));
    }
  }
  MeshTopology::Provide(grid, std::move(lists), static_cast<Index>(count));
}

//------------------------------------------------------------------------------
// Replaces all parts of a split face by this face. If some of its parts belong to other cells, it
// is a face of a parent of the cell; its parts remain.
bool FluentCellFaces::JoinOnce(std::vector<vtkIdType>& faces) const
{
  const FluentFaceTree& tree = this->Mesh.Tree;
  std::vector<std::pair<vtkIdType, vtkIdType>> found; // parent and part
  for (const vtkIdType face : faces)
  {
    const vtkIdType parent = tree.FindParent(face);
    if (parent >= 0)
    {
      found.emplace_back(parent, face);
    }
  }
  std::sort(found.begin(), found.end());
  bool isChanged = false;
  for (auto begin = found.begin(); begin != found.end();)
  {
    auto end = begin;
    while (end != found.end() && end->first == begin->first)
    {
      ++end;
    }
    if (end - begin == tree.GetNumberOfParts(begin->first))
    {
      for (auto part = begin; part != end; ++part)
      {
        faces.erase(std::remove(faces.begin(), faces.end(), part->second), faces.end());
      }
      faces.push_back(begin->first);
      isChanged = true;
    }
    begin = end;
  }
  return isChanged;
}

//------------------------------------------------------------------------------
// Joins parts of split faces, if that gives the wanted number of faces.
bool FluentCellFaces::Join(std::size_t wanted)
{
  constexpr std::size_t MaxFaces = 256; // cells at hanging nodes do not have more
  if (this->Positions.size() > MaxFaces)
  {
    return false;
  }
  std::vector<vtkIdType> joined = this->Positions;
  while (joined.size() > wanted)
  {
    const std::size_t before = joined.size();
    if (!this->JoinOnce(joined) || joined.size() >= before)
    {
      return false;
    }
  }
  if (joined.size() != wanted)
  {
    return false;
  }
  // The nodes of a split face are nodes of its parts; otherwise the tree is not that of this cell.
  std::vector<std::int32_t> nodes;
  for (const IdList& list : this->Lists)
  {
    for (std::int32_t i = 0; i < list.Size; ++i)
    {
      nodes.push_back(list[i]);
    }
  }
  std::sort(nodes.begin(), nodes.end());
  const std::int64_t cell = this->Cell;
  this->Clear();
  for (const vtkIdType position : joined)
  {
    const FluentFace face = this->Mesh.Faces[position];
    for (std::int32_t i = 0; i < face.Nodes.Size; ++i)
    {
      if (!std::binary_search(nodes.begin(), nodes.end(), face.Nodes[i]))
      {
        return false;
      }
    }
    this->Add(cell, position);
    if (face.GetCell(0) != cell && face.GetCell(1) != cell)
    {
      this->Directions.back() = FaceDirection::Unknown;
    }
  }
  this->Joined = true;
  return true;
}

//------------------------------------------------------------------------------
bool FluentCellFaces::Match(unsigned char type)
{
  const std::size_t wanted = type == VTK_TRIANGLE ? 3
    : type == VTK_QUAD || type == VTK_TETRA       ? 4
    : type == VTK_HEXAHEDRON                      ? 6
    : type == VTK_POLYGON                         ? this->Lists.size()
                                                  : 5;
  if (this->Lists.size() != wanted && (this->Lists.size() < wanted || !this->Join(wanted)))
  {
    return false;
  }
  return this->Mesh.Dimension == 2 ? this->MakeRing() : this->MatchVolume(type);
}

//------------------------------------------------------------------------------
bool FluentCellFaces::MatchVolume(unsigned char type)
{
  std::int32_t triangles = 0, quads = 0;
  for (const IdList& list : this->Lists)
  {
    triangles += list.Size == 3;
    quads += list.Size == 4;
  }
  return PrimitiveMatcher::Guess(static_cast<std::int32_t>(this->Lists.size()), triangles, quads) ==
    type &&
    this->Matcher.Match(type, this->Lists.data(), this->Directions.data());
}

//------------------------------------------------------------------------------
// Finds a ring of the edges, counterclockwise if the cells are on the sides declared in the file.
bool FluentCellFaces::MakeRing()
{
  this->Edges.clear();
  this->Loops.clear();
  for (std::size_t i = 0; i < this->Lists.size(); ++i)
  {
    const IdList& list = this->Lists[i];
    if (list.Size != 2)
    {
      return false;
    }
    if (list[0] == list[1])
    {
      this->Loops.push_back(list[0]);
      continue;
    }
    // The first cell is on the left.
    const bool isLeft = this->Directions[i] != FaceDirection::Outward;
    this->Edges.push_back({ list[isLeft ? 0 : 1], list[isLeft ? 1 : 0],
      this->Directions[i] != FaceDirection::Unknown });
  }
  constexpr std::size_t MaxShort = 16;
  if (!(this->Edges.size() > MaxShort ? this->MakeLongRing() : this->MakeShortRing()))
  {
    return false;
  }
  for (const std::int32_t node : this->Loops)
  {
    const auto place = std::find(this->Ring.begin(), this->Ring.end(), node);
    if (place == this->Ring.end())
    {
      return false;
    }
    this->Ring.insert(place, node);
  }
  return true;
}

//------------------------------------------------------------------------------
bool FluentCellFaces::MakeShortRing()
{
  // Start with an edge of known orientation; others follow it.
  const auto known = std::find_if(
    this->Edges.begin(), this->Edges.end(), [](const Edge& edge) { return edge.Directed; });
  if (this->Edges.size() < 2 || known == this->Edges.end())
  {
    return false;
  }
  std::rotate(this->Edges.begin(), known, this->Edges.end());
  this->Ring.assign(1, this->Edges.front().From);
  for (std::size_t i = 1; i < this->Edges.size(); ++i)
  {
    const std::int32_t end = this->Edges[i - 1].To;
    std::size_t next = i;
    while (next < this->Edges.size() && this->Edges[next].From != end &&
      (this->Edges[next].Directed || this->Edges[next].To != end))
    {
      ++next;
    }
    if (next == this->Edges.size())
    {
      return false;
    }
    if (this->Edges[next].From != end)
    {
      std::swap(this->Edges[next].From, this->Edges[next].To);
    }
    std::swap(this->Edges[i], this->Edges[next]);
    this->Ring.push_back(end);
  }
  return this->Edges.back().To == this->Ring.front();
}

//------------------------------------------------------------------------------
// The same for polygons with many edges, all of known orientation.
bool FluentCellFaces::MakeLongRing()
{
  this->Ring.assign(1, this->Edges.front().From);
  std::int32_t node = this->Edges.front().To;
  std::sort(this->Edges.begin(), this->Edges.end(),
    [](const Edge& a, const Edge& b) { return a.From < b.From; });
  for (std::size_t i = 1; i < this->Edges.size(); ++i)
  {
    if (node == this->Ring.front())
    {
      return false; // closed too early
    }
    this->Ring.push_back(node);
    const auto next = std::lower_bound(this->Edges.begin(), this->Edges.end(), node,
      [](const Edge& edge, std::int32_t from) { return edge.From < from; });
    if (next == this->Edges.end() || next->From != node)
    {
      return false;
    }
    node = next->To;
  }
  return node == this->Ring.front();
}

//------------------------------------------------------------------------------
void FluentCellFaces::MakeShell()
{
  this->Shell.Load(this->Lists.data(), static_cast<std::int32_t>(this->Lists.size()));
  for (std::size_t i = 0; i < this->Lists.size(); ++i)
  {
    if (this->Directions[i] == FaceDirection::Inward)
    {
      this->Shell.Turn(static_cast<std::int32_t>(i));
    }
  }
}
}
