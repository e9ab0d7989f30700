// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRenameData.h"

#include "vtkAbstractArray.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkShortArray.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkRenameData);

//------------------------------------------------------------------------------
void vtkRenameData::AddArrayName(const char* from, const char* to)
{
  this->ArrayNames[from] = to;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRenameData::RemoveArrayNames()
{
  this->ArrayNames.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRenameData::AddBlockName(const char* from, const char* to)
{
  this->BlockNames[from] = to;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRenameData::RemoveBlockNames()
{
  this->BlockNames.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRenameData::SetLongIntegers(const char* choice)
{
  this->LongIntegers = choice ? choice : "Keep";
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRenameData::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
// A copy of the array with new names, because the input also uses the array; the array itself if no
// name changes.
vtkSmartPointer<vtkAbstractArray> vtkRenameData::Rename(vtkAbstractArray* array) const
{
  const auto find = [this](const char* name)
  { return name ? this->ArrayNames.find(name) : this->ArrayNames.end(); };
  vtkSmartPointer<vtkAbstractArray> renamed = array;
  const auto getCopy = [&]
  {
    if (renamed == array)
    {
      renamed.TakeReference(array->NewInstance());
      auto* const numbers = vtkDataArray::SafeDownCast(renamed);
      numbers ? numbers->ShallowCopy(vtkDataArray::SafeDownCast(array)) : renamed->DeepCopy(array);
    }
    return renamed;
  };
  for (int c = 0; c < array->GetNumberOfComponents() && array->HasAComponentName(); ++c)
  {
    const auto name = find(array->GetComponentName(c));
    if (name != this->ArrayNames.end())
    {
      getCopy()->SetComponentName(c, name->second.c_str());
    }
  }
  const auto name = find(array->GetName());
  if (name != this->ArrayNames.end())
  {
    getCopy()->SetName(name->second.c_str());
  }
  return renamed;
}

//------------------------------------------------------------------------------
// The values as a table can store them, in which VTK writes integers of a byte as characters; the
// array itself if it is one of other numbers.
vtkSmartPointer<vtkAbstractArray> vtkRenameData::QuoteTexts(vtkAbstractArray* array) const
{
  auto* const texts = vtkStringArray::SafeDownCast(array);
  const bool isOfBytes =
    array->GetDataType() == VTK_CHAR || array->GetDataType() == VTK_SIGNED_CHAR;
  if (this->QuotesTexts && isOfBytes)
  {
    const auto numbers = vtkSmartPointer<vtkShortArray>::New();
    numbers->DeepCopy(array);
    return numbers;
  }
  if (!texts || !this->QuotesTexts)
  {
    return array;
  }
  const auto quoted = vtkSmartPointer<vtkStringArray>::New();
  quoted->DeepCopy(texts);
  for (vtkIdType i = 0; i < quoted->GetNumberOfValues(); ++i)
  {
    std::string text;
    for (const char c : quoted->GetValue(i))
    {
      text.append(c == '"' ? 2 : 1, c);
    }
    const bool isFormula =
      !text.empty() && std::string("=+-@\t\r\n").find(text[0]) != std::string::npos;
    quoted->SetValue(i, (isFormula ? "'" : "") + text);
  }
  return quoted;
}

//------------------------------------------------------------------------------
// The array converted as LongIntegers requires; the array itself if its type does not change.
vtkSmartPointer<vtkAbstractArray> vtkRenameData::Retype(vtkAbstractArray* array) const
{
  auto* const numbers = vtkDataArray::SafeDownCast(array);
  const bool toInt64 = this->LongIntegers == "Int64" && vtkIdTypeArray::SafeDownCast(array);
  const bool toDouble = this->LongIntegers == "Double";
  if (!numbers || !numbers->IsIntegral() || numbers->GetDataTypeSize() != sizeof(std::int64_t) ||
    (!toInt64 && !toDouble))
  {
    return array;
  }
  for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
  {
    const double* const range = numbers->GetRange(c);
    if (range[0] < std::numeric_limits<std::int32_t>::min() ||
      range[1] > std::numeric_limits<std::int32_t>::max())
    {
      auto other = vtkSmartPointer<vtkDataArray>::Take(
        toInt64 ? static_cast<vtkDataArray*>(vtkTypeInt64Array::New()) : vtkDoubleArray::New());
      other->DeepCopy(numbers);
      return other;
    }
  }
  return array;
}

//------------------------------------------------------------------------------
void vtkRenameData::RenameFields(vtkFieldData* fields) const
{
  auto* const attributes = vtkDataSetAttributes::SafeDownCast(fields);
  std::vector<std::pair<vtkSmartPointer<vtkAbstractArray>, int>>
    arrays; // with their attribute types
  bool isRenamed = false;
  for (int i = 0; fields && i < fields->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = fields->GetAbstractArray(i);
    arrays.emplace_back(this->Rename(this->QuoteTexts(this->Retype(array))),
      attributes ? attributes->IsArrayAnAttribute(i) : -1);
    isRenamed = isRenamed || arrays.back().first != array;
  }
  if (!isRenamed)
  {
    return;
  }
  fields->Initialize();
  for (const auto& [array, active] : arrays)
  {
    const int i = fields->AddArray(array);
    if (active >= 0)
    {
      attributes->SetActiveAttribute(i, active);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRenameData::RenameArrays(vtkDataObject* object) const
{
  for (int type = 0; type < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++type)
  {
    this->RenameFields(object->GetAttributesAsFieldData(type));
  }
}

//------------------------------------------------------------------------------
void vtkRenameData::RenameBlocks(vtkDataObject* object) const
{
  auto* const tree = vtkDataObjectTree::SafeDownCast(object);
  if (!tree)
  {
    return;
  }
  const auto it = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  it->VisitOnlyLeavesOff();
  it->SkipEmptyNodesOff();
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    vtkInformation* const data = it->HasCurrentMetaData() ? it->GetCurrentMetaData() : nullptr;
    const char* const name = data ? data->Get(vtkCompositeDataSet::NAME()) : nullptr;
    const auto known = name ? this->BlockNames.find(name) : this->BlockNames.end();
    if (known != this->BlockNames.end())
    {
      data->Set(vtkCompositeDataSet::NAME(), known->second.c_str());
    }
  }
}

//------------------------------------------------------------------------------
int vtkRenameData::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* const output = vtkDataObject::GetData(outputVector);
  auto* const inputs = vtkCompositeDataSet::SafeDownCast(input);
  auto* const outputs = vtkCompositeDataSet::SafeDownCast(output);
  if (!inputs || !outputs)
  {
    output->ShallowCopy(input);
    this->RenameArrays(output);
    return 1;
  }
  outputs->CopyStructure(inputs);
  outputs->GetFieldData()->ShallowCopy(inputs->GetFieldData());
  this->RenameFields(outputs->GetFieldData());
  const auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(inputs->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    vtkDataObject* const block = it->GetCurrentDataObject();
    const auto copy = vtkSmartPointer<vtkDataObject>::Take(block->NewInstance());
    copy->ShallowCopy(block);
    this->RenameArrays(copy);
    outputs->SetDataSet(it, copy);
  }
  this->RenameBlocks(outputs);
  return 1;
}
