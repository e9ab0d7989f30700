// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The table of all criteria. Each family has its functions and rows in a separate .cxx file.
#include "Criteria/Criterion.h"

namespace camaron
{
std::vector<Criterion> SizeCriteria();
std::vector<Criterion> AngleCriteria();
std::vector<Criterion> NeighborNormalCriteria();
std::vector<Criterion> RatioCriteria();
std::vector<Criterion> MomentCriteria();
std::vector<Criterion> CornerCriteria();
std::vector<Criterion> JacobianCriteria();
std::vector<Criterion> SimplexCriteria();
std::vector<Criterion> FaceCriteria();
std::vector<Criterion> DecompositionCriteria();
std::vector<Criterion> KernelCriteria();
std::vector<Criterion> VemCriteria();
std::vector<Criterion> ValidityCriteria();
std::vector<Criterion> ConnectivityCriteria();
std::vector<Criterion> FiniteVolumeCriteria();
std::vector<Criterion> VerdictCriteria();

namespace
{
struct Family
{
  const char* Title;
  std::vector<Criterion> (*GetCriteria)();
};

// In display order.
constexpr Family Families[] = {
  { "Size and counts", SizeCriteria },
  { "Angles", AngleCriteria },
  { "Angles", NeighborNormalCriteria },
  { "Ratios of any polygon or polyhedron", RatioCriteria },
  { "Ratios of any polygon or polyhedron", MomentCriteria },
  { "Ratios of any polygon or polyhedron", CornerCriteria },
  { "Finite element maps", JacobianCriteria },
  { "Triangles and tetrahedra", SimplexCriteria },
  { "Faces of a cell", FaceCriteria },
  { "Decomposition into tetrahedra", DecompositionCriteria },
  { "Kernel and balls", KernelCriteria },
  { "Virtual elements", VemCriteria },
  { "Validity", ValidityCriteria },
  { "Connectivity", ConnectivityCriteria },
  { "Finite volumes", FiniteVolumeCriteria },
  { "Verdict", VerdictCriteria },
};

//------------------------------------------------------------------------------
std::vector<Criterion> ListCriteria()
{
  std::vector<Criterion> criteria;
  for (const Family& family : Families)
  {
    for (Criterion criterion : family.GetCriteria())
    {
      criterion.Family = family.Title;
      criteria.push_back(criterion);
    }
  }
  return criteria;
}
}

//------------------------------------------------------------------------------
const std::vector<Criterion>& GetCriteria()
{
  static const std::vector<Criterion> criteria = ListCriteria();
  return criteria;
}

//------------------------------------------------------------------------------
const Criterion* FindCriterion(std::string_view name)
{
  for (const Criterion& criterion : GetCriteria())
  {
    if (name == criterion.Name)
    {
      return &criterion;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
std::string Criterion::UnitLabel(AngleUnit angles) const
{
  return GetUnitLabel(this->Unit, angles);
}
}
