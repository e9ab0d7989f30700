// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonOFFColumns.h"

#include "Intake/CellMesh/OutputWarnings.h"
#include "PolygonOFFColors.h"
#include "Scan/MappedFile.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

namespace camaron
{
//------------------------------------------------------------------------------
bool IsReal(vtkDataArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

namespace
{
constexpr char IndexName[] = "ColorIndex"; // name used by the reader

//------------------------------------------------------------------------------
bool IsColor(vtkDataArray* array)
{
  return array->GetNumberOfComponents() == 3 || array->GetNumberOfComponents() == 4;
}

//------------------------------------------------------------------------------
// Warns about colors that GetOFFColor clamps.
void WarnOfColors(vtkDataArray* colors, const char* one, const char* many, Warnings& warnings)
{
  if (!colors || colors->GetDataType() == VTK_UNSIGNED_CHAR)
  {
    return;
  }
  const double last = IsReal(colors) ? 1 : FullColor;
  Tally outOfRange;
  for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < colors->GetNumberOfComponents(); ++c)
    {
      const double value = colors->GetComponent(i, c);
      if (!(value >= 0 && value <= last))
      {
        outOfRange.Add(i);
        break;
      }
    }
  }
  warnings.Add(outOfRange, one, many,
    "with a color outside 0 to 255, or 0 to 1 for real numbers, clamped to this range");
}

//------------------------------------------------------------------------------
// Whether an array is a color by its type or name.
bool LooksLikeColor(vtkDataArray* array, bool ofCells)
{
  return array->GetName() &&
    ((IsColor(array) && array->GetDataType() == VTK_UNSIGNED_CHAR) ||
      (ofCells && array->GetNumberOfComponents() == 1 &&
        std::string(array->GetName()) == IndexName));
}
}

//------------------------------------------------------------------------------
bool OFFColumns::Find(vtkDataSet* mesh, const OFFColumnNames& names, const std::string& path,
  Warnings& warnings, ScanError& error)
{
  vtkPointData* const points = mesh->GetPointData();
  vtkCellData* const cells = mesh->GetCellData();
  const auto find = [&](vtkDataSetAttributes* data, const std::string& name, const char* of,
                      bool mayBeIndex) -> vtkDataArray*
  {
    const bool isNone = name.empty() || name == "None";
    vtkDataArray* const array = isNone ? nullptr : data->GetArray(name.c_str());
    const bool isIndex =
      array && mayBeIndex && array->GetNumberOfComponents() == 1 && !IsReal(array);
    if (!isNone && !error && !(array && (IsColor(array) || isIndex)))
    {
      error = { ErrorKind::Unsupported,
        GetFileName(path) + ": colors of " + of + " need an array with three or four components" +
          (mayBeIndex ? ", or with one integer" : "") + ", " +
          (array ? "but " + name + " has " + std::to_string(array->GetNumberOfComponents())
                 : "and there is no " + name) };
    }
    return array;
  };
  this->VertexColors = find(points, names.VertexColors, "vertices", false);
  this->FaceColors = find(cells, names.FaceColors, "faces", true);
  if (error)
  {
    return false;
  }
  if (this->FaceColors && this->FaceColors->GetNumberOfComponents() == 1)
  {
    std::swap(this->FaceColors, this->FaceIndices);
  }
  if (names.Normals)
  {
    this->Normals = points->GetNormals();
    if (!this->Normals)
    {
      warnings.Add("the mesh has no point normals to write");
    }
  }
  if (names.Texture)
  {
    this->Texture = points->GetTCoords();
    if (!this->Texture)
    {
      warnings.Add("the mesh has no texture coordinates to write");
    }
    else if (this->Texture->GetNumberOfComponents() != 2)
    {
      const bool isMore = this->Texture->GetNumberOfComponents() > 2;
      warnings.Add(std::string("OFF files store two texture coordinates: ") +
        (isMore ? "the third one is not written" : "a second one of 0 is added"));
    }
  }

  WrittenArrays written;
  std::string unasked;
  for (const bool ofCells : { false, true })
  {
    vtkDataSetAttributes* const data =
      mesh->GetAttributes(ofCells ? vtkDataObject::CELL : vtkDataObject::POINT);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* const array = data->GetArray(i);
      const bool isAsked = array &&
        (array == this->Normals || array == this->Texture || array == this->VertexColors ||
          array == this->FaceColors || array == this->FaceIndices);
      const bool isKnown = array &&
        (array == points->GetNormals() || array == points->GetTCoords() ||
          LooksLikeColor(array, ofCells));
      if (isKnown && !isAsked)
      {
        unasked += (unasked.empty() ? "" : ", ") + DescribeArray(mesh, array, ofCells);
      }
      if (isKnown || isAsked)
      {
        (ofCells ? written.Cells : written.Points).push_back(DescribeArray(array));
      }
    }
  }
  if (!unasked.empty())
  {
    warnings.Add(
      "normals, texture coordinates and colors are only written if selected; not written: " +
      unasked);
  }
  WarnOfArrays(mesh, "OFF", warnings, written);
  WarnOfColors(this->VertexColors, "point", "points", warnings);
  WarnOfColors(this->FaceColors, "cell", "cells", warnings);
  return true;
}
}
