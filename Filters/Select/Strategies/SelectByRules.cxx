// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include "CheckedCells.h"
#include "Grouping.h"
#include "RequestFailure.h"
#include "Rules/ParsedRules.h"
#include "vtkElementQuality.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"

#include <cmath>
#include <stdexcept>

namespace camaron
{
namespace
{
// What the evaluation takes of the progress of the filter.
constexpr double EvaluationStart = 0.1, EvaluationEnd = 0.7;

//------------------------------------------------------------------------------
// Lets a filter report the progress of the evaluation, which also lets users abort it.
void ForwardProgress(vtkAlgorithm* filter, vtkElementQuality& evaluator)
{
  vtkNew<vtkCallbackCommand> forward;
  forward->SetClientData(filter);
  forward->SetCallback(
    [](vtkObject* caller, unsigned long, void* to, void*)
    {
      const double done = static_cast<vtkAlgorithm*>(caller)->GetProgress();
      static_cast<vtkAlgorithm*>(to)->UpdateProgress(
        EvaluationStart + (EvaluationEnd - EvaluationStart) * done);
    });
  evaluator.AddObserver(vtkCommand::ProgressEvent, forward);
}

//------------------------------------------------------------------------------
// Collective.
void MarkFailing(
  const Rule& rule, const ElementBlocks& blocks, SelectionMarks& marks, Reducer& reducer)
{
  const BlockValues values(blocks, rule.Criterion, reducer);
  const CheckedCells cells(rule.Scope, blocks, reducer);
  const double least = rule.GetLeast(), most = rule.GetMost();
  const Population checked = cells.Restrict(values);
  for (std::size_t b = 0; b < checked.size(); ++b)
  {
    const ValueBlock& block = checked[b];
    unsigned char* const mark = marks[values.GetBlockNumbers()[b]].data();
    ParallelForEach(block.Size, LightGrain,
      [&](vtkIdType i)
      {
        const double value = block.Values[i];
        const bool fails = std::isnan(value)
          ? rule.UndefinedFails && block.GetNullReason(i) != NullReason::NotApplicable
          : value < least || value > most;
        mark[i] |= static_cast<unsigned char>(fails && block.Contains(i));
      });
  }
}
}

//------------------------------------------------------------------------------
// Evaluates the criteria of the rules itself, as vtkCheckQuality does.
std::string SelectByRules(const SelectionTask& task, SelectionMarks& marks)
{
  const ParsedRules parsed = ParseRules({ { "rules", task.Parameters.Rules } });
  if (!std::all_of(parsed.Rules.begin(), parsed.Rules.end(),
        [](const Rule& rule) { return rule.IsOfCells(); }))
  {
    throw std::invalid_argument("rules of faces, edges and vertices select no cells: apply Mesh "
                                "Elements, and select its elements by their criteria");
  }
  if (!parsed.Problems.empty())
  {
    throw std::invalid_argument(parsed.GetMessage());
  }
  vtkNew<vtkElementQuality> evaluator;
  ChooseCriteria(parsed.Rules, *evaluator);
  evaluator->SetEvaluationOptions(task.Inputs.Filter);
  evaluator->SetContainerAlgorithm(task.Inputs.Filter);
  ForwardProgress(task.Inputs.Filter, *evaluator);
  evaluator->SetInputDataObject(task.Inputs.Mesh);
  const bool isDone =
    evaluator->UpdatePiece(task.Reducer.GetProcess(), task.GetNumberOfRequestedPieces(), 0);
  CheckAbortOnAllRanks(task.Inputs.Filter, EvaluationEnd, task.Reducer);
  if (!isDone)
  {
    throw std::runtime_error("the criteria of the rules cannot be evaluated");
  }
  const ElementBlocks blocks(evaluator->GetOutputDataObject(0), task.Reducer);
  CheckScopes(
    parsed.Rules, GetLeaves(task.Inputs.Mesh), GetBlockNames(blocks, task.Reducer), task.Reducer);
  for (const Rule& rule : parsed.Rules)
  {
    MarkFailing(rule, blocks, marks, task.Reducer);
    CheckAbortOnAllRanks(task.Inputs.Filter, EvaluationEnd, task.Reducer);
  }
  return "";
}
}
