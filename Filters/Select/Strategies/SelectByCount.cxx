// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/IdRanges.h"
#include "Strategies/Strategy.h"

#include "Criteria/Evaluation.h"
#include "ParseChoice.h"

#include <stdexcept>

namespace camaron
{
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
      marks[piece][cell] = values[cell] >= 0 && Contains(counts, { values[cell] });
    }
  }
  return "";
}
}
