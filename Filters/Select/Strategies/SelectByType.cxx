// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/IdRanges.h"
#include "Strategies/Strategy.h"

#include "Base/Text.h"
#include "Criteria/Criterion.h"
#include "Criteria/Evaluation.h"
#include "Grouping.h"
#include "PropertyValues.h"

#include "vtkCellType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace camaron
{
namespace
{
using TypeSet = std::array<bool, VTK_NUMBER_OF_CELL_TYPES>;

//------------------------------------------------------------------------------
/// Accepts VTK's names without "vtk", and VTK's numbers.
TypeSet ParseTypes(std::string text)
{
  std::replace(text.begin(), text.end(), ',', ' ');
  std::replace(text.begin(), text.end(), ';', ' ');
  std::istringstream words(text);
  std::string word;
  TypeSet types = {};
  while (words >> word)
  {
    bool isKnown = false;
    for (int type = 0; type < VTK_NUMBER_OF_CELL_TYPES; ++type)
    {
      if (ToLower(word) == ToLower(GetCellTypeLabel(type)) || word == std::to_string(type))
      {
        types[type] = true;
        isKnown = true;
      }
    }
    if (!isKnown)
    {
      throw std::invalid_argument(
        "Cell Types: expected names such as Tetra, Hexahedron or Polyhedron, "
        "or VTK's numbers, found '" +
        word + "'");
    }
  }
  if (std::none_of(types.begin(), types.end(), [](bool isSet) { return isSet; }))
  {
    throw std::invalid_argument("Cell Types is empty");
  }
  return types;
}
}

//------------------------------------------------------------------------------
std::string SelectByType(const SelectionTask& task, SelectionMarks& marks)
{
  const TypeSet types = ParseTypes(task.Parameters.CellTypes);
  std::vector<std::vector<double>> families(marks.size());
  if (task.Parameters.ByTopology)
  {
    const DistributedMesh& pieces = task.GetPieces();
    for (std::size_t piece = 0; piece < marks.size(); ++piece)
    {
      families[piece].resize(marks[piece].size());
      Evaluate(pieces.GetTopology(piece), pieces.GetOptions(piece),
        { { FindCriterion("CellFamilyId"), families[piece].data() } }, [](double) { return true; });
    }
  }
  MarkElements(marks,
    [&](std::size_t b, vtkIdType cell)
    {
      // Cells without a family are identified by their type.
      const double family = families[b].empty() ? std::nan("") : families[b][cell];
      const int type = std::isnan(family) ? task.Blocks.Get()[b].Data->GetCellType(cell)
                                          : static_cast<int>(family);
      return type >= 0 && type < VTK_NUMBER_OF_CELL_TYPES && types[type];
    });
  return "";
}

//------------------------------------------------------------------------------
std::string SelectByCount(const SelectionTask& task, SelectionMarks& marks)
{
  const Criterion* criterion =
    FindCriterion(ParseChoice<const char*>("Counted", task.Parameters.Counted,
      { { "Faces", "FaceCount" }, { "Edges", "EdgeCount" }, { "Vertices", "VertexCount" } }));
  const std::vector<IdRange> counts = ParseIdRanges("Counts", task.Parameters.Counts);
  if (counts.empty())
  {
    throw std::invalid_argument("Counts is empty");
  }
  const DistributedMesh& pieces = task.GetPieces();
  for (std::size_t piece = 0; piece < marks.size(); ++piece)
  {
    std::vector<double> values(marks[piece].size());
    Evaluate(pieces.GetTopology(piece), pieces.GetOptions(piece), { { criterion, values.data() } },
      [](double) { return true; });
    for (std::size_t cell = 0; cell < values.size(); ++cell)
    {
      // NaN if the cell has no such elements.
      marks[piece][cell] =
        values[cell] >= 0 && Contains(counts, static_cast<std::int64_t>(values[cell]));
    }
  }
  return "";
}
}
