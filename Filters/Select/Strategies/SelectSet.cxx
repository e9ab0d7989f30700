// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include "Base/Number.h"
#include "Base/Parallel.h"
#include "Base/Text.h"
#include "Ranks/Collective.h"
#include "Scan/MappedFile.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace fs = std::filesystem;

namespace camaron
{
namespace
{
/// Labels of cells and points in OpenFOAM's sets and zones.
struct FoamLabels
{
  bool ArePoints = false;
  std::int64_t NumberOfCells = -1;  ///< of the mesh to which a set of faces belongs, else -1
  std::vector<std::int64_t> Labels; ///< ascending, each once
};

//------------------------------------------------------------------------------
// The file with this path, or with .gz appended.
fs::path FindFile(const fs::path& path)
{
  std::error_code ignored;
  const fs::path compressed = path.string() + ".gz";
  return !fs::exists(path, ignored) && fs::exists(compressed, ignored) ? compressed : path;
}

//------------------------------------------------------------------------------
// One of OpenFOAM's files: its header, and a position behind it.
class FoamInput
{
public:
  explicit FoamInput(const fs::path& path)
  {
    ScanError error;
    if (!this->File.Open(path.string(), error))
    {
      throw std::runtime_error(error.Message);
    }
    this->Place = this->File.begin();
    this->ReadHeader();
  }

  const std::string& GetKind() const { return this->Kind; }

  bool Is(char c)
  {
    this->SkipSpace();
    return this->Place < this->File.end() && *this->Place == c;
  }
  bool TakeIf(char c)
  {
    const bool is = this->Is(c);
    this->Place += is;
    return is;
  }
  void Take(char c)
  {
    if (!this->TakeIf(c))
    {
      this->Fail(std::string(1, c));
    }
  }
  /// Up to a blank or one of the characters with a meaning.
  std::string_view TakeWord(const char* expected)
  {
    this->SkipSpace();
    const char* const begin = this->Place;
    while (this->Place < this->File.end() && !IsSpace(*this->Place) &&
      std::string_view("(){};").find(*this->Place) == std::string_view::npos)
    {
      ++this->Place;
    }
    if (this->Place == begin)
    {
      this->Fail(expected);
    }
    return { begin, static_cast<std::size_t>(this->Place - begin) };
  }
  std::int64_t TakeInteger(const char* expected)
  {
    this->SkipSpace();
    const char* const begin = this->Place;
    std::int64_t value = 0;
    const char* const end = ParseInteger(begin, this->File.end(), value);
    if (!end)
    {
      this->Fail(expected);
    }
    this->Place = end;
    return value;
  }

  /// A list "n(...)" or "n{label}" of labels, in text also "(...)"; in binary files without blanks
  /// in it.
  std::vector<std::int64_t> TakeLabels(bool isBinary)
  {
    std::vector<std::int64_t> labels;
    if (!isBinary && this->TakeIf('('))
    {
      while (!this->TakeIf(')'))
      {
        labels.push_back(this->TakeInteger("a label"));
      }
      return labels;
    }
    const std::int64_t count = this->TakeInteger("the number of labels");
    if (count >= 0 && this->TakeIf('{'))
    {
      labels.push_back(this->TakeInteger("a label"));
      this->Take('}');
      return labels;
    }
    const std::int64_t least = isBinary ? this->LabelSize : 2; // a digit and a blank
    if (count < 0 || count > (this->File.end() - this->Place + 1) / least)
    {
      this->Fail("a list with " + std::to_string(count) + " labels");
    }
    labels.reserve(static_cast<std::size_t>(count));
    if (count == 0 && !this->Is('('))
    {
      return labels;
    }
    this->Take('(');
    for (std::int64_t i = 0; i < count; ++i)
    {
      labels.push_back(isBinary ? this->TakeBytes() : this->TakeInteger("a label"));
    }
    this->Take(')');
    return labels;
  }
  std::vector<std::int64_t> TakeLabels() { return this->TakeLabels(this->IsBinary); }

  /// Throws if anything but comments follows.
  void TakeEnd()
  {
    this->SkipSpace();
    if (this->Place < this->File.end())
    {
      this->Fail("the end of the file");
    }
  }

  /// The labels of a zone, in the dictionaries of a file of zones.
  std::vector<std::int64_t> TakeZone(const std::string& zone)
  {
    std::vector<std::string> names;
    std::int64_t count = this->TakeInteger("the number of zones");
    for (this->Take('('); count > 0; --count)
    {
      names.push_back(this->TakeName());
      std::vector<std::int64_t> labels;
      for (this->Take('{'); !this->TakeIf('}');)
      {
        this->TakeEntry(labels);
      }
      if (names.back() == zone)
      {
        return labels;
      }
    }
    this->Take(')');
    std::string list;
    for (const std::string& name : names)
    {
      list += (list.empty() ? "" : ", ") + name;
    }
    throw std::runtime_error(
      this->File.GetName() + ": expected a zone named '" + zone + "', found " + list);
  }

private:
  [[noreturn]] void Fail(const std::string& expected) const
  {
    const std::string_view rest(
      this->Place, static_cast<std::size_t>(this->File.end() - this->Place));
    throw std::runtime_error(this->File.GetName() + ": byte " +
      std::to_string(this->Place - this->File.begin()) + ": expected " + expected + ", found " +
      (rest.empty() ? "the end of the file" : QuoteWord(rest)));
  }

  /// Blanks and comments.
  void SkipSpace()
  {
    const char* const end = this->File.end();
    const auto begins = [&](const char* text)
    { return end - this->Place >= 2 && this->Place[0] == text[0] && this->Place[1] == text[1]; };
    for (const char* before = nullptr; before != this->Place;)
    {
      before = this->Place;
      while (this->Place < end && IsSpace(*this->Place))
      {
        ++this->Place;
      }
      const bool isLine = begins("//");
      if (isLine || begins("/*"))
      {
        const std::string_view rest(this->Place, static_cast<std::size_t>(end - this->Place));
        const std::size_t close = rest.find(isLine ? "\n" : "*/", 2);
        this->Place =
          close == std::string_view::npos ? end : this->Place + close + (isLine ? 1 : 2);
      }
    }
  }

  void ReadHeader()
  {
    if (this->TakeWord("FoamFile") != "FoamFile")
    {
      this->Place = this->File.begin();
      this->Fail("FoamFile");
    }
    for (this->Take('{'); !this->TakeIf('}');)
    {
      const std::string key(this->TakeWord("a key of the header"));
      this->SkipSpace();
      const char* const begin = this->Place;
      this->SkipValue();
      const std::string value(begin, this->Place);
      this->Take(';');
      this->Kind = key == "class" ? value : this->Kind;
      this->IsBinary = key == "format" ? value == "binary" : this->IsBinary;
      constexpr int Wide = 8;
      const bool isWide = key == "arch" && value.find("label=64") != std::string::npos;
      this->LabelSize = isWide ? Wide : this->LabelSize;
      if (key == "arch" && this->IsBinary && value.find("MSB") != std::string::npos)
      {
        throw std::runtime_error(this->File.GetName() +
          ": expected a file in text, or with the byte order LSB, found " + value);
      }
    }
  }
  /// Whether the position is within quotation marks that opened after @a begin.
  bool IsQuoted(const char* begin) const { return std::count(begin, this->Place, '"') % 2 == 1; }

  std::int64_t TakeBytes()
  {
    std::int64_t wide = 0;
    std::int32_t narrow = 0;
    const bool isWide = this->LabelSize == sizeof(wide);
    std::memcpy(isWide ? static_cast<void*>(&wide) : &narrow, this->Place,
      static_cast<std::size_t>(this->LabelSize));
    this->Place += this->LabelSize;
    return isWide ? wide : narrow;
  }

  /// An entry of a zone: its labels, or any other.
  void TakeEntry(std::vector<std::int64_t>& labels)
  {
    const std::string key(this->TakeWord("an entry of a zone"));
    const std::string suffix = "Labels";
    if (key.size() > suffix.size() && key.substr(key.size() - suffix.size()) == suffix)
    {
      this->SkipType("List<label>");
      labels = this->TakeLabels();
    }
    else if (key == "flipMap")
    {
      this->SkipType("List<bool>");
      this->SkipFlags();
    }
    else
    {
      this->SkipValue();
    }
    this->Take(';');
  }

  /// The type of a list, which may be missing.
  void SkipType(std::string_view type)
  {
    this->SkipSpace();
    const auto left = static_cast<std::size_t>(this->File.end() - this->Place);
    const bool has = std::string_view(this->Place, left).substr(0, type.size()) == type;
    this->Place += has ? type.size() : 0;
  }

  /// A word, or a text in quotation marks.
  std::string TakeName()
  {
    if (!this->TakeIf('"'))
    {
      return std::string(this->TakeWord("the name of a zone"));
    }
    const char* const begin = this->Place;
    this->Place = std::find(begin, this->File.end(), '"');
    const std::string name(begin, this->Place);
    this->Take('"');
    return name;
  }

  /// Any value up to its semicolon.
  void SkipValue()
  {
    const char* const begin = this->Place;
    while (this->Place < this->File.end() && (*this->Place != ';' || this->IsQuoted(begin)))
    {
      ++this->Place;
    }
  }

  /// "n(...)" or "n{value}", in binary files of one byte each.
  void SkipFlags()
  {
    const std::int64_t count = this->TakeInteger("the number of flags");
    if (this->IsBinary && this->Is('('))
    {
      if (count < 0 || count > this->File.end() - this->Place - 1)
      {
        this->Fail("a list with " + std::to_string(count) + " flags");
      }
      this->Place += 1 + count;
      this->Take(')');
      return;
    }
    while (this->Place < this->File.end() && !this->Is(';'))
    {
      ++this->Place;
    }
  }

  MappedFile File;
  const char* Place = nullptr;
  std::string Kind;
  bool IsBinary = false;
  std::int64_t LabelSize = 4;
};

//------------------------------------------------------------------------------
// The cells on both sides of faces, and the number of cells of the mesh.
std::vector<std::int64_t> GetCells(
  const fs::path& mesh, const std::vector<std::int64_t>& faces, std::int64_t& numberOfCells)
{
  std::vector<std::int64_t> cells;
  for (const char* name : { "owner", "neighbour" })
  {
    const std::vector<std::int64_t> sides = FoamInput(FindFile(mesh / name)).TakeLabels();
    const bool isOwner = name[0] == 'o';
    for (const std::int64_t cell : sides)
    {
      numberOfCells = std::max(numberOfCells, cell + 1);
    }
    for (const std::int64_t face : faces)
    {
      if (face >= 0 && face < static_cast<std::int64_t>(sides.size()))
      {
        cells.push_back(sides[static_cast<std::size_t>(face)]);
      }
      else if (isOwner)
      {
        throw std::runtime_error("there is no face " + std::to_string(face) + " in " +
          (mesh / name).string() + ": the set is of another mesh");
      }
    }
  }
  return cells;
}
//------------------------------------------------------------------------------
/**
 * Reads a cellSet, faceSet or pointSet, or one of the zones in cellZones, faceZones or pointZones,
 * in text or binary, compressed or not. Faces become the cells on both sides, by the files owner
 * and neighbour of the mesh.
 *
 * @param path such as constant/polyMesh/sets/nonOrthoFaces, with or without .gz
 * @param zone name of a zone; empty for a set
 * @throw std::runtime_error with the file, the byte, what was expected, and what was found
 */
FoamLabels ReadFoamLabels(const std::string& path, const std::string& zone)
{
  FoamInput input(FindFile(path));
  const fs::path folder = fs::path(path).parent_path();
  const std::string stem = fs::path(path).filename().string();
  const bool isZones = stem.find("Zones") != std::string::npos;
  const std::string kind = isZones ? stem : input.GetKind();
  if (isZones == zone.empty())
  {
    throw std::runtime_error(isZones ? stem + " has zones: no Set Name is chosen"
                                     : stem + " is a set: Set Name is for files of zones");
  }
  const auto isOf = [&](const char* begin) { return kind.rfind(begin, 0) == 0; };
  if (!isZones && !isOf("cellSet") && !isOf("faceSet") && !isOf("pointSet"))
  {
    throw std::runtime_error(stem +
      ": expected a cellSet, faceSet or pointSet, or a file of "
      "zones, found a file of class " +
      QuoteWord(kind));
  }
  FoamLabels found;
  if (isZones)
  {
    found.Labels = input.TakeZone(zone);
  }
  else
  {
    found.Labels = input.TakeLabels(false); // sets are in text, whatever the header says
    input.TakeEnd();
  }
  found.ArePoints = isOf("point");
  if (isOf("face"))
  {
    const fs::path mesh = isZones ? folder : folder.parent_path();
    found.Labels = GetCells(mesh, found.Labels, found.NumberOfCells);
  }
  std::sort(found.Labels.begin(), found.Labels.end());
  found.Labels.erase(std::unique(found.Labels.begin(), found.Labels.end()), found.Labels.end());
  return found;
}

//------------------------------------------------------------------------------
// Collective. Process 0 reads the file.
FoamLabels ReadLabels(const SelectionTask& task)
{
  FoamLabels labels;
  RunCollectively(task.Reducer,
    [&]
    {
      if (task.Reducer.GetProcess() == 0)
      {
        labels = ReadFoamLabels(task.Parameters.SetFile, task.Parameters.SetName);
      }
    });
  std::int64_t facts[] = { labels.ArePoints, labels.NumberOfCells };
  task.Reducer.Max(facts, 2);
  return { facts[0] != 0, facts[1], task.Reducer.GatherItems(labels.Labels) };
}

//------------------------------------------------------------------------------
// Whether a block has elements with labels: the cells of a case, not its patches.
bool HasLabels(const ElementBlock& block, bool hasOthers)
{
  return !hasOthers || !vtkPolyData::SafeDownCast(block.Data);
}
}

//------------------------------------------------------------------------------
// Labels are indices in the whole mesh, or global ids where it has some.
std::string SelectSet(const SelectionTask& task, SelectionMarks& marks)
{
  if (task.Parameters.SetFile.empty())
  {
    throw std::invalid_argument("no Set File is chosen");
  }
  const FoamLabels set = ReadLabels(task);
  if (set.ArePoints == task.HasCells())
  {
    throw std::invalid_argument(set.ArePoints ? "the set has points, but Element Type is Cells"
                                              : "the set has cells, but Element Type is Points");
  }
  const std::vector<ElementBlock>& blocks = task.Blocks.Get();
  std::int64_t hasOthers = std::any_of(blocks.begin(), blocks.end(),
    [](const ElementBlock& block) { return !vtkPolyData::SafeDownCast(block.Data); });
  task.Reducer.Max(&hasOthers, 1);
  std::int64_t found = 0, pieces = 0, elements = 0;
  for (std::size_t b = 0; b < marks.size(); ++b)
  {
    const ElementBlock& block = blocks[b];
    if (!HasLabels(block, hasOthers != 0))
    {
      continue;
    }
    pieces += !marks[b].empty();
    for (std::size_t i = 0; i < marks[b].size(); ++i)
    {
      elements += !block.IsGhost(static_cast<vtkIdType>(i));
    }
    const ValueBlock ids = task.Blocks.GetValueBlock(block);
    ParallelForEach(static_cast<vtkIdType>(marks[b].size()), LightGrain,
      [&](vtkIdType i)
      {
        const std::int64_t label = task.Blocks.HasGlobalIds() ? ids.GetId(i) : block.GetIndex(i);
        marks[b][i] =
          !block.IsGhost(i) && std::binary_search(set.Labels.begin(), set.Labels.end(), label);
      });
    found += std::count(marks[b].begin(), marks[b].end(), 1);
  }
  std::int64_t sums[] = { found, pieces, elements };
  task.Reducer.Sum(sums, 3);
  if (set.NumberOfCells >= 0 && set.NumberOfCells != sums[2])
  {
    throw std::invalid_argument("the faces of the set are those of a mesh with " +
      std::to_string(set.NumberOfCells) + " cells, and this one has " + std::to_string(sums[2]));
  }
  if (sums[1] > 1 && !task.Blocks.HasGlobalIds())
  {
    throw std::invalid_argument("labels are those of a whole mesh, and this one is in " +
      std::to_string(sums[1]) + " pieces");
  }
  const auto size = static_cast<std::int64_t>(set.Labels.size());
  return sums[0] == size ? ""
                         : std::to_string(size - sums[0]) + " of " + std::to_string(size) +
      " labels of " + GetFileName(task.Parameters.SetFile) + " do not exist";
}
}
