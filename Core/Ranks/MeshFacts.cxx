// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/MeshFacts.h"

namespace camaron
{
//------------------------------------------------------------------------------
void MeshFacts::Find(unsigned needs, std::vector<LinkedPiece>& pieces, Reducer& reducer,
  const std::function<void()>& goOn)
{
  const auto provide = [&](unsigned need, auto member, auto& facts, auto&& find, auto&& ofPiece)
  {
    if (!(needs & need) || (!pieces.empty() && pieces[0].Options.*member))
    {
      return;
    }
    goOn();
    facts = find(pieces, reducer);
    for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    {
      pieces[piece].Options.*member = ofPiece(facts, piece);
    }
  };
  const auto same = [](const auto& facts, std::size_t) { return &facts; };
  const auto own = [](const auto& facts, std::size_t piece) { return &facts[piece]; };
  using Options = EvaluationOptions;
  provide(NeedsMeanSizes, &Options::Means, this->Means, GetMeanSizes, same);
  provide(NeedsSurfaceSides, &Options::Sides, this->Sides, FindSurfaceSides, own);
  provide(NeedsRegions, &Options::Regions, this->Regions, FindMeshRegions, own);
  provide(NeedsPointRegions, &Options::PointGroups, this->PointGroups, FindPointRegions, own);
}
}
