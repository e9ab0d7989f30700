// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grouping.h"

#include "Base/Parallel.h"
#include "Mesh/MeshView.h"
#include "Ranks/Collective.h"
#include "StatisticsArrays.h"
#include "vtkCamaronCompat.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

namespace camaron
{
namespace
{
constexpr int NoGroup = -1; // for elements that only belong to the group of all
constexpr std::size_t Any = std::numeric_limits<std::size_t>::max();

//------------------------------------------------------------------------------
// The keys of groups in the order of their first appearance.
class KeyList
{
public:
  explicit KeyList(std::size_t maxSize)
    : MaxSize(maxSize)
  {
  }

  /// The number of a key. Adds a new key, but at most one more than MaxSize, so that the caller
  /// notices the excess; then NoGroup.
  int GetNumber(double key)
  {
    if (this->Last == NoGroup || this->Keys[this->Last] != key)
    {
      if (this->Keys.size() > this->MaxSize && this->Numbers.count(key) == 0)
      {
        return NoGroup;
      }
      const auto added = this->Numbers.emplace(key, static_cast<int>(this->Keys.size()));
      if (added.second)
      {
        this->Keys.push_back(key);
      }
      this->Last = added.first->second;
    }
    return this->Last;
  }

  const std::vector<double>& Get() const { return this->Keys; }

private:
  std::size_t MaxSize;
  std::map<double, int> Numbers;
  std::vector<double> Keys;
  int Last = NoGroup;
};

//------------------------------------------------------------------------------
// The array of that name if it has one component, else nullptr.
vtkStringArray* GetStrings(const ElementBlock& block, const std::string& name)
{
  auto* array = vtkStringArray::SafeDownCast(block.GetAttributes()->GetAbstractArray(name.c_str()));
  return array && array->GetNumberOfComponents() == 1 ? array : nullptr;
}

//------------------------------------------------------------------------------
bool IsBlank(const std::string& text)
{
  return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

//------------------------------------------------------------------------------
// The array to group by, and the texts on all processes, sorted, if some of its values are texts.
struct GroupArray
{
  std::string Name;
  std::vector<std::string> Texts;
};

//------------------------------------------------------------------------------
void NumberCellTypes(
  const ElementBlock& block, const GroupArray&, KeyList& keys, std::vector<int>& numbers)
{
  const vtkIdType size = block.Data->GetNumberOfCells();
  const MeshView mesh(block.Data);
  const bool hasView = mesh.GetNumberOfCells() == size;
  numbers.assign(size, NoGroup);
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    if (!block.IsGhost(cell))
    {
      const int type = hasView ? mesh.GetCellType(cell) : block.Data->GetCellType(cell);
      numbers[cell] = keys.GetNumber(type);
    }
  }
}

std::string GetTypeLabelOfKey(const ElementBlock&, double cellType)
{
  return GetCellTypeLabel(static_cast<int>(cellType));
}

//------------------------------------------------------------------------------
// The keys of texts are their places in the list.
void NumberTexts(const ElementBlock& block, vtkStringArray* array,
  const std::vector<std::string>& texts, KeyList& keys, std::vector<int>& numbers)
{
  std::size_t place = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const auto element = static_cast<vtkIdType>(i);
    const std::string& text = array->GetValue(element);
    if (block.IsGhost(element) || IsBlank(text))
    {
      continue;
    }
    if (texts[place] != text) // neighbors often have the same
    {
      place = std::lower_bound(texts.begin(), texts.end(), text) - texts.begin();
    }
    numbers[i] = keys.GetNumber(static_cast<double>(place));
  }
}

//------------------------------------------------------------------------------
// Integers are keys, whatever the type of the array: a region may be stored as double.
void NumberArrayValues(
  const ElementBlock& block, const GroupArray& by, KeyList& keys, std::vector<int>& numbers)
{
  numbers.assign(block.GetSize(), NoGroup);
  vtkStringArray* strings = GetStrings(block, by.Name);
  vtkDataArray* array = block.GetArray(by.Name);
  if (strings && !by.Texts.empty())
  {
    NumberTexts(block, strings, by.Texts, keys, numbers);
  }
  if (!array)
  {
    return;
  }
  vtkNew<vtkDoubleArray> values;
  values->DeepCopy(array);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const auto element = static_cast<vtkIdType>(i);
    const double value = values->GetValue(element);
    if (IsExactInteger(value) && !block.IsGhost(element))
    {
      numbers[i] = keys.GetNumber(value);
    }
  }
}

std::string ToText(double integer)
{
  return std::to_string(static_cast<std::int64_t>(integer));
}

std::string GetNumberLabel(const ElementBlock&, double key)
{
  return ToText(key);
}

//------------------------------------------------------------------------------
// Collective. The places of texts are no keys beside integers of other blocks.
void RefuseNumbers(const std::string& arrayName, const ElementBlocks& blocks, Reducer& reducer)
{
  std::int64_t hasNumbers = std::any_of(blocks.Get().begin(), blocks.Get().end(),
    [&](const ElementBlock& block) { return block.GetArray(arrayName) != nullptr; });
  reducer.Max(&hasNumbers, 1);
  if (hasNumbers)
  {
    throw std::invalid_argument(
      "the array '" + arrayName + "' has texts in some blocks and numbers in others");
  }
}

//------------------------------------------------------------------------------
void NumberBlock(
  const ElementBlock& block, const GroupArray&, KeyList& keys, std::vector<int>& numbers)
{
  numbers.assign(1, keys.GetNumber(block.Number));
}

std::string GetBlockLabel(const ElementBlock& block, double)
{
  return block.Name.empty() ? "Block 0" : block.Name;
}

//------------------------------------------------------------------------------
// A way to group. Groups are ordered by key.
struct Way
{
  const char* Name;
  /// Sets the group number of each element, or a single number for all of them. Numbers of ghosts
  /// are not used.
  void (*SetNumbers)(
    const ElementBlock& block, const GroupArray& array, KeyList& keys, std::vector<int>& numbers);
  std::string (*GetLabel)(const ElementBlock& block, double key);
  std::size_t MaxNumberOfGroups; ///< more groups are an error
  bool IsForPoints;
};
const Way Ways[] = {
  { "None", nullptr, nullptr, Any, true },
  { "Cell type", NumberCellTypes, GetTypeLabelOfKey, Any, false },
  { "Block", NumberBlock, GetBlockLabel, Any, true },
  { "Cell array", NumberArrayValues, GetNumberLabel, 1000,
    true }, // arrays with more values are ids or measurements
};

const Way& FindWay(const std::string& name)
{
  for (const Way& way : Ways)
  {
    if (name == way.Name)
    {
      return way;
    }
  }
  throw std::invalid_argument("there is no way to group by '" + name + "'");
}

//------------------------------------------------------------------------------
// Collective. Skips ids and ghost types.
std::string FindArrayName(const std::string& told, const ElementBlocks& blocks, Reducer& reducer)
{
  std::vector<std::string> ofIntegers, all, ofTexts;
  for (const ElementBlock& block : blocks.Get())
  {
    vtkDataSetAttributes* attributes = block.GetAttributes();
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      const char* name = attributes->GetArrayName(i);
      vtkDataArray* array = name ? block.GetArray(name) : nullptr;
      if (array && array != attributes->GetGlobalIds() && array != attributes->GetPedigreeIds() &&
        std::strcmp(name, vtkDataSetAttributes::GhostArrayName()) != 0)
      {
        (IsOfIntegers(array) ? ofIntegers : all).emplace_back(name);
      }
      else if (name && GetStrings(block, name))
      {
        ofTexts.emplace_back(name);
      }
    }
  }
  return AgreeOnName(told, { ofIntegers, all, ofTexts }, reducer);
}

//------------------------------------------------------------------------------
// Collective. At most one text more than there may be groups, so that the caller notices the
// excess.
std::vector<std::string> FindTexts(
  const std::string& arrayName, const ElementBlocks& blocks, std::size_t most, Reducer& reducer)
{
  std::set<std::string> found;
  for (const ElementBlock& block : blocks.Get())
  {
    vtkStringArray* array = GetStrings(block, arrayName);
    for (vtkIdType i = 0; array && i < array->GetNumberOfValues() && found.size() <= most; ++i)
    {
      const std::string& text = array->GetValue(i);
      if (!block.IsGhost(i) && !IsBlank(text))
      {
        found.insert(text);
      }
    }
  }
  const std::vector<std::string> gathered = reducer.GatherNames({ found.begin(), found.end() });
  const std::set<std::string> all(gathered.begin(), gathered.end());
  return { all.begin(), all.end() };
}

//------------------------------------------------------------------------------
using Label = std::pair<double, std::string>; // an integer key and its label

// Collective. The union over all processes, by key.
std::vector<Label> GatherLabels(const std::set<Label>& labels, Reducer& reducer)
{
  std::vector<std::string> names;
  for (const Label& label : labels)
  {
    names.push_back(ToText(label.first) + ' ' + label.second);
  }
  std::set<Label> all;
  for (const std::string& name : reducer.GatherNames(names))
  {
    const std::size_t end = name.find(' ');
    all.emplace(std::stoll(name), name.substr(end + 1));
  }
  return { all.begin(), all.end() };
}

//------------------------------------------------------------------------------
// The names that the arrays Ids and Names of the field data, such as ZoneIds and ZoneNames, give to
// values of an array.
std::set<Label> FindValueNames(const ElementBlock& block, const std::string& arrayName)
{
  std::set<Label> found;
  vtkFieldData* data = block.Data->GetFieldData();
  vtkDataArray* ids = data->GetArray((arrayName + "Ids").c_str());
  auto* names = vtkStringArray::SafeDownCast(data->GetAbstractArray((arrayName + "Names").c_str()));
  if (ids && names && ids->GetNumberOfComponents() == 1 &&
    ids->GetNumberOfTuples() == names->GetNumberOfValues())
  {
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    {
      const double key = ids->GetComponent(i, 0);
      if (IsExactInteger(key) && !IsBlank(names->GetValue(i)))
      {
        found.emplace(key, names->GetValue(i));
      }
    }
  }
  return found;
}

//------------------------------------------------------------------------------
// Replaces numbers by names. A number with several names keeps none; a name that is not the only
// one, or reads as the label of another group, stands beside its number.
void NameNumbers(const std::vector<Label>& names, std::vector<Group>& groups)
{
  std::map<double, std::string> ofKeys;
  for (const Label& name : names)
  {
    const auto [known, isNew] = ofKeys.emplace(name);
    known->second = isNew ? name.second : std::string(); // names are sorted by key
  }
  std::map<std::string, int> uses;
  for (const Group& group : groups)
  {
    const auto name = ofKeys.find(group.Key);
    const bool isNamed = !group.IsAll && name != ofKeys.end() && !name->second.empty();
    uses[group.Label] += isNamed ? 1 : 0; // of a number that another group may have as its name
    ++uses[isNamed ? name->second : group.Label];
  }
  for (Group& group : groups)
  {
    const auto name = ofKeys.find(group.Key);
    if (group.IsAll || name == ofKeys.end() || name->second.empty())
    {
      continue;
    }
    const std::string number = " (" + group.Label + ")";
    std::string label = name->second + (uses[name->second] == 1 ? "" : number);
    while (label != name->second && uses.count(label) > 0)
    {
      label += number;
    }
    group.Label = label;
  }
}

//------------------------------------------------------------------------------
// A text that reads as the group of all, and a name that does or is not the only one, as of blocks,
// get a suffix.
void TellApart(bool areTexts, std::vector<Group>& groups)
{
  std::map<std::string, int> uses;
  for (const Group& group : groups)
  {
    ++uses[group.Label];
  }
  for (Group& group : groups)
  {
    std::string label = group.Label;
    while (!group.IsAll && uses[label] > (label == group.Label ? 1 : 0))
    {
      label += areTexts ? " (text)" : " (" + ToText(group.Key) + ")";
    }
    group.Label = label;
  }
}
}

//------------------------------------------------------------------------------
Grouping::Grouping(const std::string& name, const std::string& arrayName,
  const ElementBlocks& blocks, Reducer& reducer)
  : Blocks(blocks)
  , Groups(1, Group{ true, {}, "All" })
{
  const Way& way = FindWay(name);
  if (!way.SetNumbers)
  {
    return;
  }
  if (blocks.GetKind() == ElementKind::Points && !way.IsForPoints)
  {
    throw std::invalid_argument("points cannot be grouped by '" + name + "'");
  }
  GroupArray by;
  std::set<Label> valueNames;
  if (way.SetNumbers == &NumberArrayValues)
  {
    this->ArrayName = FindArrayName(arrayName, blocks, reducer);
    blocks.RequireExactIntegers(blocks.GetKind(), this->ArrayName, reducer);
    by = { this->ArrayName, FindTexts(this->ArrayName, blocks, way.MaxNumberOfGroups, reducer) };
    this->RefuseMany(by.Texts.size(), way.MaxNumberOfGroups);
    if (!by.Texts.empty())
    {
      RefuseNumbers(this->ArrayName, blocks, reducer);
    }
  }
  KeyList keys(way.MaxNumberOfGroups);
  std::set<Label> labels;
  std::int64_t numberWithoutGroup = 0;
  for (const ElementBlock& block : blocks.Get())
  {
    const std::size_t numberBefore = keys.Get().size();
    std::vector<int> numbers;
    way.SetNumbers(block, by, keys, numbers);
    for (std::size_t k = numberBefore; k < keys.Get().size(); ++k)
    {
      labels.emplace(keys.Get()[k], way.GetLabel(block, keys.Get()[k]));
    }
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      numberWithoutGroup += numbers[i] == NoGroup && !block.IsGhost(static_cast<vtkIdType>(i));
    }
    this->GroupNumbers.push_back(std::move(numbers));
    if (!this->ArrayName.empty())
    {
      valueNames.merge(FindValueNames(block, this->ArrayName));
    }
  }
  reducer.Sum(&numberWithoutGroup, 1);
  for (const Label& label : GatherLabels(labels, reducer))
  {
    this->Groups.push_back({ false, label.first, label.second });
  }
  this->RefuseMany(this->Groups.size() - 1, way.MaxNumberOfGroups);
  std::vector<int> numbersOfKeys;
  for (const double key : keys.Get())
  {
    const auto group = std::find_if(this->Groups.begin() + 1, this->Groups.end(),
      [&](const Group& candidate) { return candidate.Key == key; });
    numbersOfKeys.push_back(static_cast<int>(group - this->Groups.begin()));
  }
  for (std::vector<int>& numbers : this->GroupNumbers)
  {
    for (int& number : numbers)
    {
      number = number == NoGroup ? NoGroup : numbersOfKeys[number];
    }
  }
  const bool areTexts = !by.Texts.empty();
  for (std::size_t i = 1; i < this->Groups.size() && areTexts; ++i)
  {
    Group& group = this->Groups[i];
    group = { false, {}, by.Texts[static_cast<std::size_t>(group.Key)] };
  }
  if (areTexts || this->ArrayName.empty())
  {
    TellApart(areTexts, this->Groups);
  }
  else
  {
    NameNumbers(GatherLabels(valueNames, reducer), this->Groups);
  }
  this->OneGroup = this->Groups.size() == 2 && numberWithoutGroup == 0;
}

//------------------------------------------------------------------------------
void Grouping::RefuseMany(std::size_t number, std::size_t most) const
{
  if (number > most)
  {
    throw std::invalid_argument("the array '" + this->ArrayName + "' has more than " +
      std::to_string(most) + " different values, too many to group by");
  }
}

//------------------------------------------------------------------------------
Population Grouping::GetPopulation(const Group& group, const BlockValues& values)
{
  if (group.IsAll)
  {
    return values.Get();
  }
  // One past the last index if only another mesh has the group.
  const auto number = static_cast<int>(
    std::find(this->Groups.begin(), this->Groups.end(), group) - this->Groups.begin());
  this->Masks.assign(values.Get().size(), {});
  Population population;
  for (std::size_t i = 0; i < values.Get().size(); ++i)
  {
    const std::vector<int>& numbers = this->GroupNumbers[values.GetBlockNumbers()[i]];
    ValueBlock block = values.Get()[i];
    if (numbers.size() != 1)
    {
      std::vector<unsigned char>& mask = this->Masks[i];
      mask.resize(numbers.size());
      ParallelForEach(block.Size, LightGrain,
        [&](vtkIdType cell) { mask[cell] = numbers[cell] != number || !block.Contains(cell); });
      block.Skip = mask.data();
    }
    else if (numbers.front() != number)
    {
      block.Size = 0; // stays in the list, so that indices of blocks remain valid
    }
    population.push_back(block);
  }
  return population;
}

//------------------------------------------------------------------------------
std::vector<Group> JoinGroups(const std::vector<Group>& a, const std::vector<Group>& b)
{
  std::vector<Group> groups = a;
  for (const Group& group : b)
  {
    if (std::find(a.begin(), a.end(), group) == a.end())
    {
      groups.push_back(group);
    }
  }
  std::sort(groups.begin(), groups.end(), [](const Group& x, const Group& y)
    { return std::tie(y.IsAll, x.Key, x.Label) < std::tie(x.IsAll, y.Key, y.Label); });
  return groups;
}

//------------------------------------------------------------------------------
std::string GetCellTypeLabel(int cellType)
{
  const std::string name = GetCellClassName(cellType);
  return name.compare(0, 3, "vtk") == 0 ? name.substr(3) : name;
}

//------------------------------------------------------------------------------
BlockNames GetBlockNames(const ElementBlocks& blocks, Reducer& reducer)
{
  std::set<Label> labels;
  for (const ElementBlock& block : blocks.Get())
  {
    labels.emplace(block.Number, block.Name);
  }
  BlockNames names;
  for (const Label& label : GatherLabels(labels, reducer))
  {
    names.emplace_back(static_cast<int>(label.first), label.second);
  }
  return names;
}

//------------------------------------------------------------------------------
std::string FindBlockName(const BlockNames& names, int number)
{
  const auto found = std::find_if(
    names.begin(), names.end(), [number](const auto& name) { return name.first == number; });
  return found == names.end() ? std::string() : found->second;
}
}
