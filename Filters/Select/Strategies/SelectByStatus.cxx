// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include "Cell/CellDefects.h"

#include <sstream>
#include <stdexcept>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
/// All bits if the text is empty.
unsigned ParseBits(std::string text)
{
  for (char& c : text)
  {
    c = c == ',' || c == ';' ? ' ' : c;
  }
  std::istringstream words(text);
  std::string word, known;
  unsigned bits = 0;
  while (words >> word)
  {
    unsigned bit = 0;
    known.clear();
    for (const CellDefect& defect : CellDefects)
    {
      bit |= word == defect.Name ? defect.Bit : 0;
      known += (known.empty() ? "" : ", ") + std::string(defect.Name);
    }
    if (bit == 0)
    {
      throw std::invalid_argument(
        "Status Bits: expected names of " + known + ", found '" + word + "'");
    }
    bits |= bit;
  }
  return bits ? bits : ~0u;
}
}

//------------------------------------------------------------------------------
std::string SelectByStatus(const SelectionTask& task, SelectionMarks& marks)
{
  const unsigned bits = ParseBits(task.Parameters.StatusBits);
  const BlockValues values(task.Blocks, "CellStatus", task.Reducer);
  task.Blocks.RequireAny(values.Get().size(),
    "there is no cell array CellStatus; add it with Element Quality", task.Reducer);
  MarkValues(values, marks,
    [&](const ValueBlock& block, vtkIdType i)
    {
      // NaN has no bits.
      return block.Values[i] >= 1 && (static_cast<unsigned>(block.Values[i]) & bits) != 0;
    });
  return "";
}
}
