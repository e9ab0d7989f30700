// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/OutputMesh.h"
#include "Intake/CellMesh/OutputWarnings.h"
#include "Intake/Write/RealFormat.h"
#include "Intake/Write/WriteRows.h"
#include "TSurf.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The value for NaN in a property: that of GOCAD, or with more nines if values are as low.
std::string ChooseNoData(vtkDataArray* property)
{
  constexpr double Usual = -99999, Least = -999999999999999; // still an exact integer
  double least = 0;
  for (int c = 0; c < property->GetNumberOfComponents(); ++c)
  {
    least = std::min(least, property->GetFiniteRange(c)[0]);
  }
  double noData = Usual;
  while (noData >= least && noData > Least)
  {
    noData = noData * 10 - 9;
  }
  return std::to_string(static_cast<vtkIdType>(noData));
}

//------------------------------------------------------------------------------
class TSurfWriting
{
public:
  TSurfWriting(vtkDataSet* input, const OutputMesh& mesh);
  void Warn(Warnings& warnings) const;
  bool Write(OutputFile& file, const Progress& progress) const;

private:
  // First point and triangle of an object; its end is the next object.
  struct Start
  {
    vtkIdType Point;
    vtkIdType Triangle;
  };

  void FindProperties();
  bool FindParts();
  bool HasFaces() const;
  vtkIdType GetFace(vtkIdType triangle) const;
  vtkStringArray* FindTexts(const char* name) const;
  std::string GetText(const char* name, std::size_t object) const;
  std::string MakeFirstLines(std::size_t object) const;
  void AppendPoint(vtkIdType point, vtkIdType id, std::string& text) const;

  vtkDataSet* Input;
  const OutputMesh& Mesh;
  std::vector<Start> Starts; // of objects, and one more, for the end
  std::vector<vtkDataArray*> Properties;
  std::vector<std::string> NoData; // of properties, the value for NaN
  vtkDataArray* Faces;             // numbers of the faces of cells; nullptr if it is one per object
  WrittenArrays Written;
};

//------------------------------------------------------------------------------
TSurfWriting::TSurfWriting(vtkDataSet* input, const OutputMesh& mesh)
  : Input(input)
  , Mesh(mesh)
  , Faces(input->GetCellData()->GetArray(FaceArray))
{
  this->FindProperties();
  if (this->FindParts())
  {
    this->Written.Cells.emplace_back(PartArray);
  }
  else
  {
    this->Starts = { { 0, 0 }, { mesh.GetNumberOfPoints(), mesh.GetNumberOfCells() } };
  }
  if (this->HasFaces())
  {
    this->Written.Cells.emplace_back(FaceArray);
  }
  else
  {
    this->Faces = nullptr;
  }
  for (const TSurfText& text : TSurfTexts)
  {
    if (this->FindTexts(text.Array))
    {
      this->Written.Fields.emplace_back(text.Array);
    }
  }
}

//------------------------------------------------------------------------------
void TSurfWriting::FindProperties()
{
  vtkPointData* data = this->Input->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    // A name is a word, or quoted.
    const bool hasName = !name.empty() &&
      std::none_of(
        name.begin(), name.end(), [](char c) { return c == '"' || c == '\n' || c == '\r'; });
    if (!hasName || array == data->GetGlobalIds() || array->GetNumberOfComponents() < 1 ||
      name == vtkDataSetAttributes::GhostArrayName() || name == PointIdArray)
    {
      continue;
    }
    this->Properties.push_back(array);
    this->NoData.push_back(ChooseNoData(array));
    this->Written.Points.push_back(name);
  }
}

//------------------------------------------------------------------------------
// Finds the starts of parts, which must be contiguous in the triangles as well as in the points.
bool TSurfWriting::FindParts()
{
  const vtkIdType triangles = this->Mesh.GetNumberOfCells();
  vtkDataArray* const parts = this->Input->GetCellData()->GetArray(PartArray);
  if (!parts || parts->GetNumberOfComponents() != 1 || triangles == 0)
  {
    return false;
  }
  this->Starts = { { 0, 0 } };
  vtkIdType nextPoint = 0; // after all points of the parts so far
  double part = 0;
  for (vtkIdType triangle = 0; triangle < triangles; ++triangle)
  {
    const IndexRange corners = this->Mesh.GetCellPoints(triangle);
    const double next = parts->GetComponent(this->Mesh.GetInputCell(triangle), 0);
    // A part without triangles would need points, and nothing says which.
    if (next == part + 1)
    {
      this->Starts.push_back({ nextPoint, triangle });
      part = next;
    }
    if (next != part ||
      std::min({ corners[0], corners[1], corners[2] }) < this->Starts.back().Point)
    {
      return false;
    }
    nextPoint = std::max({ nextPoint, corners[0] + 1, corners[1] + 1, corners[2] + 1 });
  }
  this->Starts.push_back({ this->Mesh.GetNumberOfPoints(), triangles });
  return true;
}

//------------------------------------------------------------------------------
vtkIdType TSurfWriting::GetFace(vtkIdType triangle) const
{
  return this->Faces
    ? static_cast<vtkIdType>(this->Faces->GetComponent(this->Mesh.GetInputCell(triangle), 0))
    : 0;
}

//------------------------------------------------------------------------------
// Whether faces ascend from 0 in every object.
bool TSurfWriting::HasFaces() const
{
  if (!this->Faces || this->Faces->GetNumberOfComponents() != 1)
  {
    return false;
  }
  for (std::size_t object = 0; object + 1 < this->Starts.size(); ++object)
  {
    double face = 0;
    for (vtkIdType i = this->Starts[object].Triangle; i < this->Starts[object + 1].Triangle; ++i)
    {
      const double next = this->Faces->GetComponent(this->Mesh.GetInputCell(i), 0);
      if (!(next == face || next == face + 1))
      {
        return false;
      }
      face = next;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Field data with one value per object; nullptr if there is none.
vtkStringArray* TSurfWriting::FindTexts(const char* name) const
{
  auto* texts = vtkStringArray::SafeDownCast(this->Input->GetFieldData()->GetAbstractArray(name));
  const auto objects = static_cast<vtkIdType>(this->Starts.size()) - 1;
  return texts && texts->GetNumberOfValues() == objects ? texts : nullptr;
}

//------------------------------------------------------------------------------
std::string TSurfWriting::GetText(const char* name, std::size_t object) const
{
  vtkStringArray* const texts = this->FindTexts(name);
  if (!texts)
  {
    return "";
  }
  std::string text = texts->GetValue(static_cast<vtkIdType>(object));
  text.erase(std::remove_if(text.begin(), text.end(),
               [](char c) { return c == '\n' || c == '\r' || c == '{' || c == '}'; }),
    text.end());
  return text;
}

//------------------------------------------------------------------------------
std::string TSurfWriting::MakeFirstLines(std::size_t object) const
{
  const std::string name = this->GetText("PartName", object);
  const std::string zPositive = this->GetText("ZPositive", object);
  const std::string unit = this->GetText("AxisUnit", object);
  std::string text = "GOCAD TSurf 1\nHEADER {\nname:" +
    (name.empty() ? "surface" + std::to_string(object + 1) : name) + "\n}\n";
  if (!zPositive.empty() || !unit.empty())
  {
    text += "GOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME Default\nAXIS_NAME \"X\" \"Y\" \"Z\"\n";
    text += unit.empty() ? "" : "AXIS_UNIT " + unit + "\n";
    text += zPositive.empty() ? "" : "ZPOSITIVE " + zPositive + "\n";
    text += "END_ORIGINAL_COORDINATE_SYSTEM\n";
  }
  if (!this->Properties.empty())
  {
    std::string names, sizes, values;
    for (std::size_t i = 0; i < this->Properties.size(); ++i)
    {
      vtkDataArray* const property = this->Properties[i];
      const std::string word = property->GetName();
      const bool isQuoted = word.find_first_of(" \t#") != std::string::npos;
      names += isQuoted ? " \"" + word + "\"" : " " + word;
      sizes += " " + std::to_string(property->GetNumberOfComponents());
      values += " " + this->NoData[i];
    }
    text += "PROPERTIES" + names + "\nESIZES" + sizes + "\nNO_DATA_VALUES" + values + "\n";
  }
  return text;
}

//------------------------------------------------------------------------------
void TSurfWriting::AppendPoint(vtkIdType point, vtkIdType id, std::string& text) const
{
  double x[3];
  this->Mesh.GetPoint(point, x);
  text += this->Properties.empty() ? "VRTX " : "PVRTX ";
  AppendNumber(text, id);
  text += ' ';
  RealFormat::Shortest(this->Mesh.HasFloatPoints())
    .AppendRow(text, x, 3, this->Properties.empty() ? '\n' : ' ');
  for (std::size_t i = 0; i < this->Properties.size(); ++i)
  {
    vtkDataArray* const property = this->Properties[i];
    const RealFormat format = RealFormat::Shortest(property->GetDataType() == VTK_FLOAT);
    for (int c = 0; c < property->GetNumberOfComponents(); ++c)
    {
      const double value = property->GetComponent(this->Mesh.GetInputPoint(point), c);
      if (std::isnan(value))
      {
        text += this->NoData[i];
      }
      else
      {
        format.Append(text, value);
      }
      text += ' ';
    }
  }
  text.back() = '\n';
}

//------------------------------------------------------------------------------
void TSurfWriting::Warn(Warnings& warnings) const
{
  WarnOfArrays(this->Input, "TSurf", warnings, this->Written);
  for (vtkDataArray* property : this->Properties)
  {
    WarnOfIntegers(property, warnings);
  }
}

//------------------------------------------------------------------------------
bool TSurfWriting::Write(OutputFile& file, const Progress& progress) const
{
  const std::size_t objects = this->Starts.size() - 1;
  for (std::size_t object = 0; object < objects; ++object)
  {
    const Start& from = this->Starts[object];
    const Start& to = this->Starts[object + 1];
    const Progress part = progress.Part(
      static_cast<double>(object) / objects, static_cast<double>(object + 1) / objects);
    // All points come first, in one face: their order matters more than the faces of points.
    file.Write(this->MakeFirstLines(object) + "TFACE\n");
    const bool good = WriteRows(file, to.Point - from.Point, part.Part(0, 0.5),
                        [&](vtkIdType row, std::string& text)
                        { this->AppendPoint(from.Point + row, row + 1, text); }) &&
      WriteRows(file, to.Triangle - from.Triangle, part.Part(0.5, 1),
        [&](vtkIdType row, std::string& text)
        {
          const vtkIdType triangle = from.Triangle + row;
          const vtkIdType before = row == 0 ? 0 : this->GetFace(triangle - 1);
          text += this->GetFace(triangle) > before ? "TFACE\nTRGL" : "TRGL";
          const IndexRange corners = this->Mesh.GetCellPoints(triangle);
          for (vtkIdType i = 0; i < 3; ++i)
          {
            text += ' ';
            AppendNumber(text, corners[i] - from.Point + 1);
          }
          text += '\n';
        });
    file.Write("END\n");
    if (!good)
    {
      return false;
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
bool WriteTSurf(OutputFile& file, vtkDataSet* input, const OutputMesh& mesh, Warnings& warnings,
  const Progress& progress)
{
  const TSurfWriting writing(input, mesh);
  writing.Warn(warnings);
  return writing.Write(file, progress);
}
}
