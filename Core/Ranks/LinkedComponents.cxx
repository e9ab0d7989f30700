// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/LinkedComponents.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace camaron
{
namespace
{
// "The component of your cell touches mine."
struct Touch
{
  std::int32_t Piece, Cell;
  std::int64_t Component;
};

struct Relabeling
{
  std::int64_t Component, Label;
};
}

//------------------------------------------------------------------------------
LinkedComponents::LinkedComponents(const std::vector<LinkedPiece>& pieces,
  const std::vector<std::vector<Index>>& ofCells, Index numberOfComponents,
  camaron::Reducer& reducer)
  : Reducer(reducer)
{
  const std::vector<std::int64_t> own = { numberOfComponents };
  this->First = { 0 };
  for (const std::int64_t size : reducer.GatherItems(own))
  {
    this->First.push_back(this->First.back() + size);
  }
  this->Labels.resize(static_cast<std::size_t>(numberOfComponents));
  std::iota(this->Labels.begin(), this->Labels.end(), this->GetOwnFirst());
  this->FindContacts(pieces, ofCells);
  this->Propagate();
}

//------------------------------------------------------------------------------
int LinkedComponents::GetProcess(std::int64_t label) const
{
  return static_cast<int>(
    std::upper_bound(this->First.begin(), this->First.end(), label) - this->First.begin() - 1);
}

//------------------------------------------------------------------------------
void LinkedComponents::FindContacts(
  const std::vector<LinkedPiece>& pieces, const std::vector<std::vector<Index>>& ofCells)
{
  std::vector<std::vector<Touch>> touches(this->Reducer.GetNumberOfProcesses());
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const LinkedPiece& piece = pieces[p];
    if (!piece.Options.Links)
    {
      continue;
    }
    const MeshView& mesh = piece.Topology->GetMesh();
    for (std::size_t i = 0; i < ofCells[p].size(); ++i)
    {
      if (ofCells[p][i] < 0)
      {
        continue;
      }
      const auto cell = static_cast<vtkIdType>(i);
      const int dimension = GetCellShape(mesh.GetCellType(cell)).Dimension;
      const FacetTable& table = piece.Topology->GetFacets(dimension);
      const FacetLinks& links = piece.Options.Links->GetFacets(dimension);
      const std::int64_t own = this->GetOwnFirst() + ofCells[p][i];
      for (const CellFacet use : table.GetCellFacets(cell))
      {
        links.ForEach(use.Facet(), [&](const LinkedCell& other, bool)
          { touches[other.Process].push_back({ other.Piece, other.Cell, own }); });
      }
    }
  }
  for (const std::vector<Touch>& list : this->Reducer.ExchangeItems(std::move(touches)))
  {
    for (const Touch& touch : list)
    {
      const std::int64_t own = this->GetOwnFirst() + ofCells[touch.Piece][touch.Cell];
      this->Contacts.push_back({ { own, touch.Component } });
    }
  }
  std::sort(this->Contacts.begin(), this->Contacts.end());
  this->Contacts.erase(
    std::unique(this->Contacts.begin(), this->Contacts.end()), this->Contacts.end());
}

//------------------------------------------------------------------------------
// The smallest number spreads over all components in contact, one step per round.
void LinkedComponents::Propagate()
{
  std::vector<unsigned char> changed(this->Labels.size(), 1);
  for (std::int64_t changes = 1; changes > 0;)
  {
    std::vector<std::vector<Relabeling>> sent(this->Reducer.GetNumberOfProcesses());
    for (const auto& [component, other] : this->Contacts)
    {
      const std::int64_t own = component - this->GetOwnFirst();
      if (changed[own])
      {
        sent[this->GetProcess(other)].push_back({ other, this->Labels[own] });
      }
    }
    changed.assign(changed.size(), 0);
    for (const auto& list : this->Reducer.ExchangeItems(std::move(sent)))
    {
      for (const Relabeling& relabeling : list)
      {
        const std::int64_t own = relabeling.Component - this->GetOwnFirst();
        if (relabeling.Label < this->Labels[own])
        {
          this->Labels[own] = relabeling.Label;
          changed[own] = 1;
        }
      }
    }
    changes = std::count(changed.begin(), changed.end(), 1);
    this->Reducer.Sum(&changes, 1);
  }
}
}
