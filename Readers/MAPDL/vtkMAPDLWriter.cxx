// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMAPDLWriter.h"

#include "Base/Buffer.h"
#include "Base/Text.h"
#include "Intake/CellMesh/CellConversion.h"
#include "Intake/CellMesh/OutputWarnings.h"
#include "Intake/Ids/IdMap.h"
#include "Intake/Write/RealFormat.h"
#include "Intake/Write/WriteRows.h"
#include "MAPDLCommands.h"
#include "MAPDLElements.h"
#include "MAPDLOutputTypes.h"
#include "Scan/MappedFile.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <map>

namespace camaron
{
namespace
{
constexpr int ElementWidth = 10; // of a column of EBLOCK and CMBLOCK
constexpr int FieldsPerLine = 19;
constexpr int HeaderFields = 11;
constexpr int ValuesPerLine = 8;     // of CMBLOCK
constexpr std::int32_t EndMark = -1; // of EBLOCK, in place of the material

//------------------------------------------------------------------------------
/// Ids of nodes or elements.
class OutputIds
{
public:
  /**
   * Uses ids from @a numbers, at @a getInput(i) for item i, if they are unique; zeros are replaced
   * by ids after the greatest. Otherwise ids are 1 to @a size.
   */
  template <typename GetInput>
  OutputIds(const MAPDLNumbers& numbers, vtkIdType size, GetInput&& getInput)
    : Greatest(static_cast<std::int32_t>(size))
  {
    if (!numbers.HasArray() || size == 0)
    {
      return;
    }
    Buffer<std::int32_t> ids(size);
    std::int64_t greatest = 0, zeros = 0;
    bool good = true;
    for (vtkIdType i = 0; i < size; ++i)
    {
      ids[i] = numbers[getInput(i)];
      greatest = std::max<std::int64_t>(greatest, ids[i]);
      zeros += ids[i] == 0;
      good = good && ids[i] >= 0 && numbers.IsKept(getInput(i));
    }
    good = good && greatest > 0 && greatest + zeros <= MaxMAPDLId;
    for (vtkIdType i = 0; good && zeros > 0 && i < size; ++i)
    {
      if (ids[i] == 0)
      {
        ids[i] = static_cast<std::int32_t>(++greatest);
      }
    }
    if (good)
    {
      IdMap map;
      map.Build(ids.data(), size);
      good = map.GetNumberOfRepeated() == 0;
    }
    this->Unusable = !good;
    if (good)
    {
      this->Ids = std::move(ids);
      this->Greatest = static_cast<std::int32_t>(greatest);
    }
  }

  std::int32_t operator[](vtkIdType i) const
  {
    return this->Ids.size() > 0 ? this->Ids[i] : static_cast<std::int32_t>(i) + 1;
  }
  std::int32_t GetGreatest() const { return this->Greatest; }
  bool IsUnusable() const { return this->Unusable; }

private:
  Buffer<std::int32_t> Ids;
  std::int32_t Greatest;
  bool Unusable = false;
};

//------------------------------------------------------------------------------
// An array of points or cells that is a component.
struct Component
{
  std::string Name;
  bool OfNodes;
  const unsigned char* Flags;
};

//------------------------------------------------------------------------------
// Creates a name that the manual allows (Ansys, Mechanical APDL Command Reference, CM), in the way
// Ansys Mechanical does for its named selections. Beyond the manual, decks of Ansys programs
// contain `-`, and `_` at the beginning.
std::string MakeName(const std::string& upper)
{
  constexpr std::size_t MaxLength = 240;
  std::string name = upper;
  const auto isLetter = [](char c) { return c >= 'A' && c <= 'Z'; };
  for (char& c : name)
  {
    c = isLetter(c) || IsDigit(c) || c == '.' || c == '-' ? c : '_';
  }
  const bool isReserved = name == "ALL" || name == "STAT" || name == "DEFA";
  if (!name.empty() && (isReserved || (!isLetter(name[0]) && upper[0] != '_')))
  {
    name.insert(0, "C_");
  }
  return name.substr(0, MaxLength);
}

//------------------------------------------------------------------------------
std::vector<Component> FindComponents(vtkDataSet* mesh, WrittenArrays& written, Warnings& warnings)
{
  std::vector<Component> components;
  std::string changes, doubles;
  for (const bool ofNodes : { true, false })
  {
    std::map<std::string, std::string> names; // and the arrays they are for
    vtkDataSetAttributes* const data =
      ofNodes ? static_cast<vtkDataSetAttributes*>(mesh->GetPointData()) : mesh->GetCellData();
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      auto* const array = vtkUnsignedCharArray::SafeDownCast(data->GetAbstractArray(i));
      if (!array || array->GetNumberOfComponents() != 1 || !array->GetName() ||
        array->GetName() == std::string(vtkDataSetAttributes::GhostArrayName()))
      {
        continue;
      }
      const unsigned char* const flags = array->GetPointer(0);
      const std::string name = MakeName(ToUpperMAPDL(TrimMAPDL(array->GetName())));
      if (name.empty() ||
        !std::all_of(
          flags, flags + array->GetNumberOfValues(), [](unsigned char f) { return f < 2; }))
      {
        continue;
      }
      const std::string own = array->GetName();
      (ofNodes ? written.Points : written.Cells).push_back(own);
      const auto found = names.emplace(name, own);
      if (!found.second)
      {
        doubles +=
          (doubles.empty() ? "" : ", ") + own + " (" + name + " is " + found.first->second + ")";
        continue;
      }
      components.push_back({ name, ofNodes, flags });
      if (name != own)
      {
        changes += (changes.empty() ? "" : ", ") + own + " to " + name;
      }
    }
  }
  if (!changes.empty())
  {
    warnings.Add("names of components are converted to valid ones: " + changes);
  }
  if (!doubles.empty())
  {
    warnings.Add("components omitted whose names collide after conversion: " + doubles);
  }
  return components;
}

//------------------------------------------------------------------------------
class DeckWriter
{
public:
  DeckWriter(vtkDataSet* mesh, const OutputMesh& output, bool originalIds, int digits)
    : Output(output)
    , OriginalIds(originalIds)
    , Digits(digits)
    , Types(mesh, output)
    , Nodes(MAPDLNumbers(mesh->GetPointData(), originalIds ? "NodeId" : "", 0),
        output.GetNumberOfPoints(), [&output](vtkIdType i) { return output.GetInputPoint(i); })
    , Elements(MAPDLNumbers(mesh->GetCellData(), originalIds ? "ElementId" : "", 0),
        output.GetNumberOfCells(), [&output](vtkIdType i) { return output.GetInputCell(i); })
    , Material(mesh->GetCellData(), "Material", 1, EndMark)
    , Real(mesh->GetCellData(), "Real", 1)
    , Section(mesh->GetCellData(), "Section", 1)
  {
  }

  void Warn(vtkDataSet* mesh, WrittenArrays written, Warnings& warnings) const;
  bool Write(
    OutputFile& file, const std::vector<Component>& components, const Progress& progress) const;

private:
  bool WriteNodes(OutputFile& file, const Progress& progress) const;
  bool WriteElements(OutputFile& file, const Progress& progress) const;
  bool WriteComponent(OutputFile& file, const Component& component, const Progress& progress) const;

  const OutputMesh& Output;
  bool OriginalIds;
  int Digits;
  MAPDLOutputTypes Types;
  OutputIds Nodes, Elements;
  MAPDLNumbers Material, Real, Section;
};

//------------------------------------------------------------------------------
void DeckWriter::Warn(vtkDataSet* mesh, WrittenArrays written, Warnings& warnings) const
{
  const auto addIds =
    [&](vtkDataSetAttributes* attributes, const char* name, std::vector<std::string>& names)
  {
    if (!this->OriginalIds || MAPDLNumbers(attributes, name, 0).HasArray())
    {
      names.push_back(name);
    }
  };
  addIds(mesh->GetPointData(), "NodeId", written.Points);
  addIds(mesh->GetCellData(), "ElementId", written.Cells);
  const auto add = [&](const MAPDLNumbers& numbers, const char* name)
  {
    if (!numbers.HasArray())
    {
      return;
    }
    written.Cells.push_back(name);
    vtkIdType replaced = 0;
    for (vtkIdType cell = 0; cell < this->Output.GetNumberOfCells(); ++cell)
    {
      replaced += !numbers.IsKept(this->Output.GetInputCell(cell));
    }
    if (replaced > 0)
    {
      warnings.Add(CountOf(replaced, "value of ", "values of ") + name + " cannot be stored (" +
        (name == std::string("Material") ? "-1 or " : "") +
        "outside -999999999 to 2147483647); 1 is written instead");
    }
  };
  add(this->Material, "Material");
  add(this->Real, "Real");
  add(this->Section, "Section");
  if (this->Types.UsesArrays())
  {
    written.Cells.insert(written.Cells.end(), { "TypeId", "ElementType" });
    warnings.Add(this->Types.FindOtherTypes(), "cell", "cells",
      "written with another TypeId or ElementType, as an element of the given type would be "
      "another cell",
      FromZero);
  }
  written.Fields = { "NodeComponents", "ElementComponents" };
  WarnOfArrays(mesh, "MAPDL", warnings, written);
  if (this->Nodes.IsUnusable())
  {
    warnings.Add(
      "values of NodeId are not unique or not from 1 to 2147483647; nodes are numbered from 1");
  }
  if (this->Elements.IsUnusable())
  {
    warnings.Add("values of ElementId are not unique or not from 1 to 2147483647; elements are "
                 "numbered from 1");
  }
}

//------------------------------------------------------------------------------
bool DeckWriter::WriteNodes(OutputFile& file, const Progress& progress) const
{
  constexpr int NarrowWidth = 9;
  const int width = this->Nodes.GetGreatest() > 999999999 ? NarrowWidth + 1 : NarrowWidth;
  const int decimals = this->Digits - 1;
  // Sign, digit, point, and an exponent with a sign and three digits.
  const int realWidth = decimals + 8;
  std::string header = "NBLOCK,6,SOLID,";
  AppendAligned(header, this->Nodes.GetGreatest(), ElementWidth);
  header += ',';
  AppendAligned(header, this->Output.GetNumberOfPoints(), ElementWidth);
  header += "\n(3i" + std::to_string(width) + ",6e" + std::to_string(realWidth) + '.' +
    std::to_string(decimals) + "e3)\n";
  file.Write(header);
  const RealFormat format = RealFormat::Field(realWidth, decimals, 3);
  const bool good = WriteRows(file, this->Output.GetNumberOfPoints(), progress,
    [&](vtkIdType point, std::string& text)
    {
      double x[3];
      this->Output.GetPoint(point, x);
      AppendAligned(text, this->Nodes[point], width);
      AppendAligned(text, 0, width);
      AppendAligned(text, 0, width);
      for (const double coordinate : x)
      {
        format.Append(text, coordinate);
      }
      text += '\n';
    });
  file.Write("N,UNBL,LOC,       -1,\n");
  return good;
}

//------------------------------------------------------------------------------
bool DeckWriter::WriteElements(OutputFile& file, const Progress& progress) const
{
  std::string header = "EBLOCK,19,SOLID,";
  AppendAligned(header, this->Elements.GetGreatest(), ElementWidth);
  header += ',';
  AppendAligned(header, this->Output.GetNumberOfCells(), ElementWidth);
  file.Write(header + "\n(19i10)\n");
  const bool good = WriteRows(file, this->Output.GetNumberOfCells(), progress,
    [&](vtkIdType cell, std::string& text)
    {
      const vtkIdType from = this->Output.GetInputCell(cell);
      const MAPDLOutputTypes::Choice& type = this->Types.GetType(cell);
      const MAPDLForm& form = type.Form;
      const IndexRange points = this->Output.GetCellPoints(cell);
      const std::int32_t fields[HeaderFields] = { this->Material[from], type.Id, this->Real[from],
        this->Section[from], 0, 0, 0, 0, form.NumberOfNodes, 0, this->Elements[cell] };
      for (const std::int32_t field : fields)
      {
        AppendAligned(text, field, ElementWidth);
      }
      for (int node = 0; node < form.NumberOfNodes; ++node)
      {
        if (node == FieldsPerLine - HeaderFields)
        {
          text += '\n';
        }
        AppendAligned(text, this->Nodes[points[form.Order[node]]], ElementWidth);
      }
      text += '\n';
    });
  file.Write("        -1\n");
  return good;
}

//------------------------------------------------------------------------------
bool DeckWriter::WriteComponent(
  OutputFile& file, const Component& component, const Progress& progress) const
{
  // Runs of consecutive ids become the first id and the negative of the last one.
  std::vector<std::int32_t> ids;
  const vtkIdType size =
    component.OfNodes ? this->Output.GetNumberOfPoints() : this->Output.GetNumberOfCells();
  for (vtkIdType i = 0; i < size; ++i)
  {
    const vtkIdType from =
      component.OfNodes ? this->Output.GetInputPoint(i) : this->Output.GetInputCell(i);
    if (component.Flags[from])
    {
      ids.push_back(component.OfNodes ? this->Nodes[i] : this->Elements[i]);
    }
  }
  std::sort(ids.begin(), ids.end());
  std::vector<std::int32_t> values;
  for (std::size_t i = 0; i < ids.size();)
  {
    std::size_t end = i + 1;
    while (end < ids.size() && ids[end] == ids[end - 1] + 1)
    {
      ++end;
    }
    values.push_back(ids[i]);
    if (end - i > 1)
    {
      values.push_back(-ids[end - 1]);
    }
    i = end;
  }
  std::string header = "CMBLOCK," + component.Name + (component.OfNodes ? ",NODE," : ",ELEM,");
  constexpr int CountWidth = 8;
  AppendAligned(header, values.size(), CountWidth);
  const bool isWide = !ids.empty() && ids.back() > 999999999; // ten digits, and a sign
  const int width = isWide ? ElementWidth + 1 : ElementWidth;
  file.Write(header + "\n(8i" + std::to_string(width) + ")\n");
  const auto numberOfValues = static_cast<vtkIdType>(values.size());
  return WriteRows(file, (numberOfValues + ValuesPerLine - 1) / ValuesPerLine, progress,
    [&](vtkIdType row, std::string& text)
    {
      const vtkIdType end = std::min((row + 1) * ValuesPerLine, numberOfValues);
      for (vtkIdType i = row * ValuesPerLine; i < end; ++i)
      {
        AppendAligned(text, values[i], width);
      }
      text += '\n';
    });
}

//------------------------------------------------------------------------------
bool DeckWriter::Write(
  OutputFile& file, const std::vector<Component>& components, const Progress& progress) const
{
  std::string head = "/COM,Mesh written by Camaron for ParaView\n/PREP7\n/NOPR\n";
  for (const auto& entry : this->Types.GetTypes())
  {
    const std::string id = std::to_string(entry.first);
    head += "ET," + id + ',' + std::to_string(entry.second.Element) + '\n';
    if (entry.second.Shape > 0)
    {
      head += "KEYOP," + id + ",1," + std::to_string(entry.second.Shape) + '\n';
    }
  }
  file.Write(head);
  bool good = this->WriteNodes(file, progress.Part(0, 0.4)) &&
    this->WriteElements(file, progress.Part(0.4, 0.9));
  const auto size = static_cast<double>(components.size());
  for (std::size_t i = 0; i < components.size() && good; ++i)
  {
    const auto at = static_cast<double>(i);
    good = this->WriteComponent(
      file, components[i], progress.Part(0.9 + 0.1 * at / size, 0.9 + 0.1 * (at + 1) / size));
  }
  file.Write("/GO\nFINISH\n");
  return good;
}
}
}

using namespace camaron;

vtkStandardNewMacro(vtkMAPDLWriter);

//------------------------------------------------------------------------------
// Nodes, elements, their types, and a component for each byte array with values 0 or 1. Types and
// attributes of elements are taken from the arrays that the reader creates, if they match the
// cells.
bool vtkMAPDLWriter::WriteMesh(const std::string& path, vtkDataSet* mesh,
  camaron::Warnings& warnings, camaron::ScanError& error, const camaron::Progress& progress)
{
  const CellTypeSet held = { VTK_VERTEX, VTK_LINE, VTK_QUADRATIC_EDGE, VTK_TRIANGLE,
    VTK_QUADRATIC_TRIANGLE, VTK_QUAD, VTK_QUADRATIC_QUAD, VTK_TETRA, VTK_QUADRATIC_TETRA,
    VTK_PYRAMID, VTK_QUADRATIC_PYRAMID, VTK_WEDGE, VTK_QUADRATIC_WEDGE, VTK_HEXAHEDRON,
    VTK_QUADRATIC_HEXAHEDRON };
  const CellConversion how{ "MAPDL", held, this->GetOtherCells() };
  OutputMesh output;
  if (!ConvertCells(mesh, how, path, output, warnings, error, progress.Part(0, 0.3)))
  {
    return false;
  }
  if (std::max(output.GetNumberOfPoints(), output.GetNumberOfCells()) > MaxMAPDLId)
  {
    error = { ErrorKind::Unsupported,
      camaron::GetFileName(path) + ": expected at most 2147483647 nodes and elements, found more" };
    return false;
  }
  WrittenArrays written;
  const std::vector<Component> components = FindComponents(mesh, written, warnings);
  const DeckWriter writer(mesh, output, this->OriginalIds, this->Digits);
  writer.Warn(mesh, std::move(written), warnings);
  WarnOfDigits(mesh, output, this->Digits, warnings);
  OutputFile file(path);
  return file.Finish(writer.Write(file, components, progress.Part(0.3, 1)), error);
}

//------------------------------------------------------------------------------
void vtkMAPDLWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OriginalIds: " << this->OriginalIds << "\n";
  os << indent << "Digits: " << this->Digits << "\n";
}
