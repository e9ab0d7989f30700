// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FacetLinks.h"

#include <algorithm>

namespace camaron
{
//------------------------------------------------------------------------------
const FacetLinks::Entry& FacetLinks::Find(Index facet) const
{
  return *std::lower_bound(this->Entries.begin(), this->Entries.end(), facet,
    [](const Entry& entry, Index f) { return entry.Facet < f; });
}
}
