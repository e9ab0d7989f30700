// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSelectElements.h"

#include "AcceptableRanges.h"
#include "Base/Buffer.h"
#include "ControllerReducer.h"
#include "MeshOutputs.h"
#include "Strategies/CurrentSelection.h"
#include "Strategies/Strategy.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <exception>
#include <map>
#include <stdexcept>

vtkStandardNewMacro(vtkSelectElements);

namespace
{
//------------------------------------------------------------------------------
// An array with one value per element of a data set.
template <typename Array, typename Value>
vtkSmartPointer<Array> MakeArray(const char* name, const std::vector<Value>& values)
{
  const auto array = camaron::MakeLargeArray<Array>(static_cast<vtkIdType>(values.size()));
  array->SetName(name);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

//------------------------------------------------------------------------------
// Selects by global ids if there are any, because these do not change when the mesh is split
// differently.
void AddNode(vtkSelection* selection, const camaron::ElementBlocks& blocks, std::size_t number,
  const std::vector<unsigned char>& marks, int process)
{
  const camaron::ElementBlock& block = blocks.Get()[number];
  const camaron::ValueBlock values = blocks.GetValueBlock(block);
  vtkNew<vtkIdTypeArray> ids;
  for (std::size_t i = 0; i < marks.size(); ++i)
  {
    if (marks[i])
    {
      const auto index = static_cast<vtkIdType>(i);
      ids->InsertNextValue(blocks.HasGlobalIds() ? values.GetId(index) : index);
    }
  }
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(
    blocks.HasGlobalIds() ? vtkSelectionNode::GLOBALIDS : vtkSelectionNode::INDICES);
  node->SetFieldType(
    block.Kind == camaron::ElementKind::Cells ? vtkSelectionNode::CELL : vtkSelectionNode::POINT);
  node->SetSelectionList(ids);
  node->GetProperties()->Set(vtkSelectionNode::PROCESS_ID(), process);
  if (blocks.IsComposite())
  {
    node->GetProperties()->Set(
      vtkSelectionNode::COMPOSITE_INDEX(), static_cast<int>(block.FlatIndex));
  }
  selection->AddNode(node);
}
}

//------------------------------------------------------------------------------
vtkSelectElements::vtkSelectElements()
  : Parameters(std::make_unique<camaron::SelectionParameters>())
  , PresetNames(camaron::MakePresetNames(camaron::GetDefaultRangesName()))
{
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkSelectElements::~vtkSelectElements() = default;

//------------------------------------------------------------------------------
vtkStringArray* vtkSelectElements::GetStrategyNames()
{
  if (!this->StrategyNames)
  {
    this->StrategyNames = vtkSmartPointer<vtkStringArray>::New();
    for (const camaron::Strategy& strategy : camaron::GetStrategies())
    {
      this->StrategyNames->InsertNextValue(strategy.Name);
    }
  }
  return this->StrategyNames;
}

//------------------------------------------------------------------------------
void vtkSelectElements::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ElementType: " << this->GetElementType() << '\n';
  os << indent << "Combination: " << this->GetCombination() << '\n';
  os << indent << "Strategy: " << this->GetStrategy() << '\n';
  os << indent << "Ids: " << this->GetIds() << '\n';
  os << indent << "IdSpace: " << this->GetIdSpace() << '\n';
  os << indent << "Array: " << this->GetArray() << '\n';
  os << indent << "PointArray: " << this->GetPointArray() << '\n';
  os << indent << "Side: " << this->GetSide() << '\n';
  os << indent << "Range: " << this->GetRange() << '\n';
  os << indent << "Preset: " << this->GetPreset() << '\n';
  os << indent << "RangesFile: " << this->GetRangesFile() << '\n';
  os << indent << "LowerLimit: " << this->GetLowerLimit() << '\n';
  os << indent << "UpperLimit: " << this->GetUpperLimit() << '\n';
  os << indent << "NumberOfWorst: " << this->GetNumberOfWorst() << '\n';
  os << indent << "WorstShare: " << this->GetWorstShare() << '\n';
  os << indent << "CellTypes: " << this->GetCellTypes() << '\n';
  os << indent << "Counted: " << this->GetCounted() << '\n';
  os << indent << "Counts: " << this->GetCounts() << '\n';
  os << indent << "NumberOfFailures: " << this->GetNumberOfFailures() << '\n';
  os << indent << "ByTopology: " << this->GetByTopology() << '\n';
  os << indent << "StatusBits: " << this->GetStatusBits() << '\n';
  os << indent << "WorstValues: " << this->GetWorstValues() << '\n';
  os << indent << "Adjacency: " << this->GetAdjacency() << '\n';
  os << indent << "NumberOfRings: " << this->GetNumberOfRings() << '\n';
  os << indent << "FeatureAngle: " << this->GetFeatureAngle() << '\n';
  os << indent << "OnlyBoundary: " << this->GetOnlyBoundary() << '\n';
  os << indent << "OnlyInRange: " << this->GetOnlyInRange() << '\n';
  os << indent << "PartNumber: " << this->GetPartNumber() << '\n';
  os << indent << "Quantifier: " << this->GetQuantifier() << '\n';
  os << indent << "Placement: " << this->GetPlacement() << '\n';
  os << indent << "InsideOut: " << this->GetInsideOut() << '\n';
  os << indent << "Shape: " << this->GetShape() << '\n';
  os << indent << "ShapeFile: " << this->GetShapeFile() << '\n';
  os << indent << "Numbers of planes: " << this->Parameters->Planes.size() << '\n';
  os << indent << "LeaveNulls: " << this->GetLeaveNulls() << '\n';
  os << indent << "NumberOfSelectedElements: " << this->NumberOfSelectedElements << '\n';
  os << indent << "Report: " << this->Report << '\n';
}

//------------------------------------------------------------------------------
void vtkSelectElements::SetText(std::string& member, const char* text)
{
  const std::string value = text ? text : "";
  if (member != value)
  {
    member = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkSelectElements::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Parameters->Shape ? std::max(own, this->Parameters->Shape->GetMTime()) : own;
}

//------------------------------------------------------------------------------
void vtkSelectElements::SetShape(vtkImplicitFunction* shape)
{
  if (this->Parameters->Shape != shape)
  {
    this->Parameters->Shape = shape;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImplicitFunction* vtkSelectElements::GetShape() const
{
  return this->Parameters->Shape;
}

//------------------------------------------------------------------------------
void vtkSelectElements::AddPlaneNumber(double number)
{
  this->Parameters->Planes.push_back(number);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSelectElements::ClearPlanes()
{
  if (!this->Parameters->Planes.empty())
  {
    this->Parameters->Planes.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
// Text properties.
#define CAMARON_TEXT_PROPERTY(name)                                                                \
  void vtkSelectElements::Set##name(const char* text)                                              \
  {                                                                                                \
    this->SetText(this->Parameters->name, text);                                                   \
  }                                                                                                \
  const char* vtkSelectElements::Get##name() const                                                 \
  {                                                                                                \
    return this->Parameters->name.c_str();                                                         \
  }
CAMARON_TEXT_PROPERTY(ElementType)
CAMARON_TEXT_PROPERTY(Strategy)
CAMARON_TEXT_PROPERTY(Combination)
CAMARON_TEXT_PROPERTY(Ids)
CAMARON_TEXT_PROPERTY(IdSpace)
CAMARON_TEXT_PROPERTY(Array)
CAMARON_TEXT_PROPERTY(PointArray)
CAMARON_TEXT_PROPERTY(Side)
CAMARON_TEXT_PROPERTY(Range)
CAMARON_TEXT_PROPERTY(Preset)
CAMARON_TEXT_PROPERTY(RangesFile)
CAMARON_TEXT_PROPERTY(LowerLimit)
CAMARON_TEXT_PROPERTY(UpperLimit)
CAMARON_TEXT_PROPERTY(WorstValues)
CAMARON_TEXT_PROPERTY(ShapeFile)
CAMARON_TEXT_PROPERTY(Placement)
CAMARON_TEXT_PROPERTY(Quantifier)
CAMARON_TEXT_PROPERTY(Adjacency)
CAMARON_TEXT_PROPERTY(StatusBits)
CAMARON_TEXT_PROPERTY(CellTypes)
CAMARON_TEXT_PROPERTY(Counted)
CAMARON_TEXT_PROPERTY(Counts)
#undef CAMARON_TEXT_PROPERTY

//------------------------------------------------------------------------------
// Numbers and choices; the strategies check ranges.
#define CAMARON_NUMBER_PROPERTY(name, type)                                                        \
  void vtkSelectElements::Set##name(type value)                                                    \
  {                                                                                                \
    if (this->Parameters->name != value)                                                           \
    {                                                                                              \
      this->Parameters->name = value;                                                              \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  type vtkSelectElements::Get##name() const                                                        \
  {                                                                                                \
    return this->Parameters->name;                                                                 \
  }
CAMARON_NUMBER_PROPERTY(NumberOfWorst, int)
CAMARON_NUMBER_PROPERTY(NumberOfRings, int)
CAMARON_NUMBER_PROPERTY(PartNumber, int)
CAMARON_NUMBER_PROPERTY(NumberOfFailures, int)
CAMARON_NUMBER_PROPERTY(FeatureAngle, double)
CAMARON_NUMBER_PROPERTY(WorstShare, double)
CAMARON_NUMBER_PROPERTY(LeaveNulls, bool)
CAMARON_NUMBER_PROPERTY(InsideOut, bool)
CAMARON_NUMBER_PROPERTY(ByTopology, bool)
CAMARON_NUMBER_PROPERTY(OnlyBoundary, bool)
CAMARON_NUMBER_PROPERTY(OnlyInRange, bool)
#undef CAMARON_NUMBER_PROPERTY

//------------------------------------------------------------------------------
int vtkSelectElements::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkSelection");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  if (port > 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSelectElements::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkDataObject" : "vtkSelection");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSelectElements::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  if (!input)
  {
    return 0;
  }
  camaron::MakeOutput(input->GetDataObjectType(), 0, outputVector);
  camaron::MakeOutput(VTK_SELECTION, 1, outputVector);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSelectElements::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  vtkSelection* selection = vtkSelection::GetData(outputVector, 1);
  this->Report.clear();
  this->NumberOfSelectedElements = 0;
  try
  {
    camaron::ControllerReducer reducer;
    camaron::ElementBlocks blocks(
      input, reducer, camaron::ParseElementKind(this->Parameters->ElementType));
    const int numberOfPieces = outputVector->GetInformationObject(0)->Get(
      vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES());
    const camaron::SelectionInputs inputs = { input, vtkSelection::GetData(inputVector[1]),
      vtkDataObject::GetData(inputVector[2]), vtkDataObject::GetData(inputVector[3]) };
    camaron::SelectionTask task(*this->Parameters, inputs, blocks, numberOfPieces, reducer);
    camaron::SelectionMarks marks = this->Select(task, blocks);

    std::int64_t selected = 0;
    std::map<unsigned int, std::size_t> blockOfFlatIndex; // without empty data sets
    for (std::size_t b = 0; b < marks.size(); ++b)
    {
      blockOfFlatIndex[blocks.Get()[b].FlatIndex] = b;
      selected += std::count(marks[b].begin(), marks[b].end(), 1);
      AddNode(selection, blocks, b, marks[b], reducer.GetProcess());
    }
    reducer.Sum(&selected, 1);
    this->NumberOfSelectedElements = static_cast<vtkIdType>(selected);
    if (!this->Report.empty() && reducer.GetProcess() == 0)
    {
      vtkWarningMacro("" << this->Report << '.');
    }
    task.MarkCopies(marks);
    task.MarkGhostCells(marks);
    std::int64_t hasCounts = !task.FailedCriteriaCounts.empty();
    reducer.Max(&hasCounts, 1);
    const auto kind = static_cast<int>(blocks.GetKind());
    const auto otherKind = static_cast<int>(camaron::GetOtherKind(blocks.GetKind()));
    camaron::CopyDataSets(input, output,
      [&](vtkDataSet* copy, unsigned int flatIndex)
      {
        const auto found = blockOfFlatIndex.find(flatIndex);
        const bool isEmpty = found == blockOfFlatIndex.end();
        // A mesh has one selection: remove marks of the other element type.
        copy->GetAttributes(otherKind)->RemoveArray(GetSelectedArrayName());
        copy->GetAttributes(kind)->AddArray(MakeArray<vtkUnsignedCharArray>(
          GetSelectedArrayName(), isEmpty ? std::vector<unsigned char>() : marks[found->second]));
        if (hasCounts)
        {
          copy->GetAttributes(kind)->AddArray(MakeArray<vtkIntArray>("FailedCriteriaCount",
            isEmpty ? std::vector<int>() : task.FailedCriteriaCounts[found->second]));
        }
      });
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("The selection cannot be computed: " << error.what() << '.');
    output->Initialize();
    return 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
camaron::SelectionMarks vtkSelectElements::Select(
  camaron::SelectionTask& task, camaron::ElementBlocks& blocks)
{
  const camaron::Strategy& strategy = camaron::FindStrategy(this->Parameters->Strategy);
  if (blocks.GetKind() == camaron::ElementKind::Points && !strategy.IsForPoints)
  {
    throw std::invalid_argument("the strategy '" + this->Parameters->Strategy +
      "' selects cells, but Element Type is Points");
  }
  task.Current = camaron::FindCurrentSelection(task);
  if (this->Parameters->Combination == "Refine")
  {
    blocks.Restrict(task.Current);
  }
  camaron::SelectionMarks marks = camaron::MakeMarks(blocks);
  this->Report = strategy.Select(task, marks);
  camaron::MarkElements(
    marks, [&](std::size_t b, vtkIdType i) { return marks[b][i] && !blocks.Get()[b].IsGhost(i); });
  camaron::CombineSelections(this->Parameters->Combination, task.Current, marks);
  return marks;
}
