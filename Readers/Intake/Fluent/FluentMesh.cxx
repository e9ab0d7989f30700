// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentMesh.h"

#include <algorithm>

namespace camaron
{
//------------------------------------------------------------------------------
FluentShape GetFluentShape(FluentElement element)
{
  static constexpr FluentShape Shapes[] = { {}, { VTK_TRIANGLE, 3, 3 }, { VTK_TETRA, 4, 4 },
    { VTK_QUAD, 4, 4 }, { VTK_HEXAHEDRON, 8, 6 }, { VTK_PYRAMID, 5, 5 }, { VTK_WEDGE, 6, 5 } };
  return Shapes[static_cast<std::size_t>(element)];
}

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
FluentShape FluentMesh::GetShape(vtkIdType cell) const
{
  const FluentElement element = this->Cells.GetElement(this->Piece.GetLeaf(cell));
  return element != FluentElement::Polyhedron
    ? GetFluentShape(element)
    : FluentShape{ static_cast<unsigned char>(this->Dimension == 2 ? VTK_POLYGON : VTK_POLYHEDRON),
        0, 0 };
}
}
