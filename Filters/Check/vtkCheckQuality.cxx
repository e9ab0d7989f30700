// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCheckQuality.h"

#include "AcceptableRanges.h"
#include "CheckTables.h"
#include "CheckedCells.h"
#include "ControllerReducer.h"
#include "ElementBlocks.h"
#include "ElementPlaces.h"
#include "Grouping.h"
#include "PropertyValues.h"
#include "RequestFailure.h"
#include "Rules/ParsedRules.h"
#include "vtkElementQuality.h"
#include "vtkMeshElements.h"

#include "vtkCommand.h"
#include "vtkDataArraySelection.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <iterator>

vtkStandardNewMacro(vtkCheckQuality);

namespace
{
constexpr const char* Automatic = "Automatic";
constexpr const char* NoPreset = "None";
constexpr const char* DefaultPreset = "General";
constexpr const char* NameOfText = "rules";
constexpr const char* Sizes[] = { "Volume", "Area" };
constexpr double EvaluationShare = 0.8; // of the progress

//------------------------------------------------------------------------------
vtkSmartPointer<vtkStringArray> MakeChoices()
{
  auto choices = vtkSmartPointer<vtkStringArray>::New();
  choices->InsertNextValue(Automatic);
  const auto others = camaron::MakePresetNames(NoPreset);
  choices->InsertTuples(1, others->GetNumberOfValues(), 0, others);
  return choices;
}

//------------------------------------------------------------------------------
// Collective.
std::int64_t CountCells(const camaron::ElementBlocks& blocks, camaron::Reducer& reducer)
{
  std::int64_t count = 0;
  for (const camaron::ElementBlock& block : blocks.Get())
  {
    count += block.Skip.empty()
      ? block.GetSize()
      : std::count(block.Skip.begin(), block.Skip.end(), static_cast<unsigned char>(0));
  }
  reducer.Sum(&count, 1);
  return count;
}

//------------------------------------------------------------------------------
// The output of vtkMeshElements with the elements of a rule; -1 for cells.
int GetElementsPort(const camaron::Rule& rule)
{
  const std::vector<std::string>& known = camaron::GetJudgedElements();
  const auto found = std::find(known.begin(), known.end(), rule.GetElements());
  return static_cast<int>(found - known.begin()) - 1;
}

//------------------------------------------------------------------------------
// Indices of rules with the same cells and the same criterion, in the order of their first rule.
using RuleGroups = std::vector<std::vector<std::size_t>>;

template <typename GetKey>
RuleGroups GroupRules(const std::vector<std::size_t>& indices, GetKey&& getKey)
{
  RuleGroups groups;
  std::vector<std::string> keys;
  for (const std::size_t i : indices)
  {
    const std::string key = getKey(i);
    const auto found = std::find(keys.begin(), keys.end(), key);
    if (found == keys.end())
    {
      keys.push_back(key);
      groups.push_back({ i });
    }
    else
    {
      groups[found - keys.begin()].push_back(i);
    }
  }
  return groups;
}
}

//------------------------------------------------------------------------------
vtkCheckQuality::vtkCheckQuality()
  : PresetNames(MakeChoices())
{
  this->SetNumberOfOutputPorts(2);
  this->Evaluator->SetContainerAlgorithm(this);
  this->Elements->SetContainerAlgorithm(this);
  this->Evaluator->AddObserver(vtkCommand::ProgressEvent, this, &vtkCheckQuality::ForwardProgress);
}

//------------------------------------------------------------------------------
vtkCheckQuality::~vtkCheckQuality() = default;

//------------------------------------------------------------------------------
void vtkCheckQuality::SetText(std::string& member, const char* text)
{
  const std::string value = text ? text : "";
  if (member != value)
  {
    member = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkCheckQuality::AddNamedRules(const char* name, const char* text)
{
  this->NamedRules.emplace_back(name ? name : "", text ? text : "");
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkCheckQuality::ClearNamedRules()
{
  if (!this->NamedRules.empty())
  {
    this->NamedRules.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkCheckQuality::ForwardProgress()
{
  this->UpdateProgress(EvaluationShare * this->Evaluator->GetProgress());
}

//------------------------------------------------------------------------------
camaron::ParsedRules vtkCheckQuality::Parse(const camaron::RulesText* file) const
{
  std::vector<camaron::RulesText> texts;
  if (file)
  {
    texts.push_back(*file);
  }
  else if (!this->RulesFile.empty())
  {
    texts.push_back({ this->RulesFile, "" });
    camaron::RuleProblem problem;
    if (!camaron::ReadRulesFile(this->RulesFile, texts[0].Text, problem))
    {
      return { {}, { problem } };
    }
  }
  if (this->Rules.find_first_not_of(" \t\r\n") != std::string::npos)
  {
    texts.push_back({ NameOfText, this->Rules });
  }
  for (const auto& [name, text] : this->NamedRules)
  {
    texts.push_back({ name, text });
  }
  const bool isAutomatic = this->Preset == Automatic || this->Preset.empty();
  const std::string preset = isAutomatic ? (texts.empty() ? DefaultPreset : "")
    : this->Preset == NoPreset           ? ""
                                         : this->Preset;
  return camaron::ParseRules(texts, preset, this->Tolerate);
}

//------------------------------------------------------------------------------
camaron::ParsedRules vtkCheckQuality::ParseCollectively(camaron::Reducer& reducer) const
{
  if (this->RulesFile.empty())
  {
    return this->Parse();
  }
  camaron::RulesText file{ this->RulesFile, "" };
  camaron::RuleProblem problem;
  std::vector<char> bytes; // the text and 't', or a problem and 'p'
  if (reducer.GetProcess() == 0)
  {
    const bool isRead = camaron::ReadRulesFile(this->RulesFile, file.Text, problem);
    const std::string& text = isRead ? file.Text : problem.Text;
    bytes.assign(text.begin(), text.end());
    bytes.push_back(isRead ? 't' : 'p');
  }
  std::vector<std::size_t> sizes;
  bytes = reducer.Gather(bytes, sizes);
  file.Text.assign(bytes.begin(), bytes.end() - 1);
  return bytes.back() == 't' ? this->Parse(&file)
                             : camaron::ParsedRules{ {}, { { this->RulesFile, 0, file.Text } } };
}

//------------------------------------------------------------------------------
vtkStringArray* vtkCheckQuality::GetProblems()
{
  this->Problems->Initialize();
  for (const camaron::RuleProblem& problem : this->Parse().Problems)
  {
    this->Problems->InsertNextValue(problem.Source);
    this->Problems->InsertNextValue(std::to_string(problem.Line));
    this->Problems->InsertNextValue(problem.Text);
  }
  return this->Problems;
}

//------------------------------------------------------------------------------
vtkStringArray* vtkCheckQuality::GetParsedRules()
{
  this->ParsedRules->Initialize();
  for (const camaron::Rule& rule : this->Parse().Rules)
  {
    this->ParsedRules->InsertNextValue(rule.Source);
    this->ParsedRules->InsertNextValue(std::to_string(rule.Line));
    this->ParsedRules->InsertNextValue(rule.Preset);
    this->ParsedRules->InsertNextValue(rule.GetLineText());
  }
  return this->ParsedRules;
}

//------------------------------------------------------------------------------
double vtkCheckQuality::GetEstimatedSeconds()
{
  const camaron::ParsedRules parsed = this->Parse();
  if (!parsed.Problems.empty() || this->GetNumberOfInputConnections(0) == 0)
  {
    return 0;
  }
  this->ChooseCriteria(parsed);
  this->Evaluator->SetInputDataObject(this->GetInputDataObject(0, 0));
  const double seconds = this->Evaluator->GetEstimatedSeconds();
  this->Evaluator->SetInputDataObject(nullptr);
  return seconds;
}

//------------------------------------------------------------------------------
int vtkCheckQuality::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
void vtkCheckQuality::ChooseCriteria(const camaron::ParsedRules& parsed)
{
  camaron::ChooseCriteria(parsed.Rules, *this->Evaluator);
  for (const char* size : Sizes)
  {
    this->Evaluator->SetCriterionStatus(size, 1);
  }
}

//------------------------------------------------------------------------------
vtkDataObject* vtkCheckQuality::Evaluate(vtkDataObject* input, vtkInformation* outInfo)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  this->Evaluator->SetEvaluationOptions(this);
  this->Evaluator->SetInputDataObject(input);
  this->Evaluator->Modified(); // its output of the last time is gone
  const bool isDone = this->Evaluator->UpdatePiece(outInfo->Get(Pipeline::UPDATE_PIECE_NUMBER()),
    outInfo->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()), 0);
  return isDone ? this->Evaluator->GetOutputDataObject(0) : nullptr;
}

//------------------------------------------------------------------------------
bool vtkCheckQuality::MakeElements(
  vtkDataObject* input, const camaron::ParsedRules& parsed, vtkInformation* outInfo)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  this->Elements->ClearFaceArrays();
  this->Elements->ClearEdgeArrays();
  this->Elements->ClearVertexArrays();
  for (const camaron::Rule& rule : parsed.Rules)
  {
    const int port = GetElementsPort(rule);
    vtkDataArraySelection* const arrays = port == 0 ? this->Elements->GetFaceArrays()
      : port == 1                                   ? this->Elements->GetEdgeArrays()
      : port == 2                                   ? this->Elements->GetVertexArrays()
                                                    : nullptr;
    if (arrays)
    {
      arrays->SetArraySetting(rule.Criterion.c_str(), 1);
    }
  }
  this->Elements->SetEvaluationOptions(this);
  this->Elements->SetInputDataObject(input);
  this->Elements->Modified();
  return this->Elements->UpdatePiece(outInfo->Get(Pipeline::UPDATE_PIECE_NUMBER()),
    outInfo->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()), 0);
}

//------------------------------------------------------------------------------
bool vtkCheckQuality::Check(vtkDataObject* input, const camaron::ParsedRules& parsed,
  vtkInformationVector* outputVector, camaron::Reducer& reducer)
{
  camaron::CheckNumber("Number Of Worst", this->NumberOfWorst, 0);
  this->ChooseCriteria(parsed);
  vtkDataObject* const evaluated = this->Evaluate(input, outputVector->GetInformationObject(0));
  camaron::CheckAbortOnAllRanks(this, EvaluationShare, reducer);
  if (!evaluated)
  {
    return false; // the evaluator reported why
  }
  const camaron::ElementBlocks blocks(evaluated, reducer);
  camaron::CheckResults results;
  results.Rules = parsed.Rules;
  results.Results.resize(parsed.Rules.size());
  results.NumberOfCells = CountCells(blocks, reducer);
  results.IdSpaces.resize(parsed.Rules.size());
  results.BlockNames = camaron::GetBlockNames(blocks, reducer);
  camaron::CheckScopes(parsed.Rules, camaron::GetLeaves(input), results.BlockNames, reducer);
  std::vector<camaron::BlockWeights> sizes;
  sizes.reserve(std::size(Sizes));
  for (const char* size : Sizes)
  {
    sizes.emplace_back(blocks, size, reducer);
  }

  const bool hasOthers = std::any_of(parsed.Rules.begin(), parsed.Rules.end(),
    [](const camaron::Rule& rule) { return !rule.IsOfCells(); });
  if (hasOthers && !this->MakeElements(input, parsed, outputVector->GetInformationObject(0)))
  {
    camaron::CheckAbortOnAllRanks(this, EvaluationShare, reducer);
    return false; // the filter reported why
  }
  std::vector<camaron::ElementBlocks> others;
  for (int port = 0; hasOthers && port < this->Elements->GetNumberOfOutputPorts(); ++port)
  {
    others.emplace_back(this->Elements->GetOutputDataObject(port), reducer);
  }

  std::vector<std::size_t> all(parsed.Rules.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i] = i;
  }
  std::size_t numberDone = 0;
  for (const auto& sameCells :
    GroupRules(all, [&](std::size_t i) { return parsed.Rules[i].GetScopeText(); }))
  {
    const int port = GetElementsPort(parsed.Rules[sameCells[0]]);
    const camaron::ElementBlocks& own = port < 0 ? blocks : others[port];
    const camaron::CheckedCells cells(parsed.Rules[sameCells[0]].Scope, own, reducer);
    for (const auto& sameCriterion :
      GroupRules(sameCells, [&](std::size_t i) { return parsed.Rules[i].Criterion; }))
    {
      const camaron::BlockValues values(own, parsed.Rules[sameCriterion[0]].Criterion, reducer);
      std::vector<const camaron::Rule*> rules;
      for (const std::size_t i : sameCriterion)
      {
        rules.push_back(&parsed.Rules[i]);
      }
      std::vector<camaron::Weights> weights;
      for (std::size_t size = 0; port < 0 && size < sizes.size(); ++size)
      {
        weights.push_back(sizes[size].GetWeights(values));
      }
      std::vector<camaron::RuleResult> found = camaron::CheckRules(rules, cells.Restrict(values),
        weights, this->NumberOfWorst, reducer, [&](camaron::WorstElement& element)
        { camaron::DescribeElement(own, values, reducer.GetProcess(), element); });
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        results.Results[sameCriterion[i]] = std::move(found[i]);
        results.IdSpaces[sameCriterion[i]] = own.GetIdSpace();
      }
      numberDone += rules.size();
      camaron::CheckAbortOnAllRanks(this,
        EvaluationShare +
          (1 - EvaluationShare) * static_cast<double>(numberDone) / static_cast<double>(all.size()),
        reducer);
    }
  }
  if (reducer.GetProcess() == 0)
  {
    camaron::AddRuleRows(vtkTable::GetData(outputVector, 0), results);
    camaron::AddFailingRows(vtkTable::GetData(outputVector, 1), results);
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkCheckQuality::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    vtkTable::GetData(outputVector, port)->Initialize();
  }
  camaron::AddRuleColumns(vtkTable::GetData(outputVector, 0));
  camaron::AddFailingColumns(vtkTable::GetData(outputVector, 1));
  camaron::ControllerReducer reducer;
  const camaron::ParsedRules parsed = this->ParseCollectively(reducer);
  if (!parsed.Problems.empty())
  {
    vtkErrorMacro(<< parsed.GetMessage());
    return 0;
  }
  int succeeds = 1;
  try
  {
    succeeds = this->Check(vtkDataObject::GetData(inputVector[0]), parsed, outputVector, reducer);
  }
  catch (...)
  {
    succeeds = camaron::FailRequest(this, "", outputVector);
  }
  this->Evaluator->SetInputDataObject(nullptr);
  this->Elements->SetInputDataObject(nullptr);
  for (int port = 0; port < this->Elements->GetNumberOfOutputPorts(); ++port)
  {
    if (vtkDataObject* elements = this->Elements->GetOutputDataObject(port))
    {
      elements->Initialize();
    }
  }
  if (vtkDataObject* evaluated = this->Evaluator->GetOutputDataObject(0))
  {
    evaluated->Initialize(); // the evaluator keeps the arrays of criteria only
  }
  return succeeds;
}
