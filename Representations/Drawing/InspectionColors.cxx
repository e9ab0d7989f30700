// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InspectionColors.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <vector>

namespace camaron
{
namespace
{
// Converts luminance, luminance with alpha, and RGB to RGBA.
std::vector<std::array<unsigned char, 4>> ToRGBA(vtkUnsignedCharArray* colors)
{
  const int size = colors->GetNumberOfComponents();
  const bool isGray = size < 3;
  const bool hasAlpha = size == 2 || size == 4;
  std::vector<std::array<unsigned char, 4>> rows(colors->GetNumberOfTuples());
  const unsigned char* from = colors->GetPointer(0);
  for (auto& row : rows)
  {
    row[0] = from[0];
    row[1] = from[isGray ? 0 : 1];
    row[2] = from[isGray ? 0 : 2];
    row[3] = hasAlpha ? from[size - 1] : 255;
    from += size;
  }
  return rows;
}
}

//------------------------------------------------------------------------------
void InspectionColors::Update(Kind kind, vtkDataArray* array)
{
  const vtkMTimeType time = array ? array->GetMTime() : 0;
  if (this->What == kind && this->Array == array && this->Time == time)
  {
    return;
  }
  this->Release();
  this->What = kind;
  this->Array = array;
  this->Time = time;
  if (auto* colors = vtkUnsignedCharArray::SafeDownCast(array))
  {
    if (colors->GetNumberOfComponents() == 4)
    {
      this->Colors.Upload(colors->GetPointer(0), colors->GetNumberOfTuples());
    }
    else
    {
      const auto rows = ToRGBA(colors);
      this->Colors.Upload(rows.data(), rows.size());
    }
  }
  else if (auto* coordinates = vtkFloatArray::SafeDownCast(array))
  {
    this->Coordinates.Upload(coordinates->GetPointer(0), coordinates->GetNumberOfTuples());
  }
}

//------------------------------------------------------------------------------
const char* InspectionColors::GetDefine() const
{
  switch (this->What)
  {
    case Kind::Cells:
      return "#define HAS_CELL_COLORS\n";
    case Kind::Points:
      return "#define HAS_POINT_COLORS\n";
    case Kind::Coordinates:
      return "#define HAS_COLOR_COORDINATES\n";
    default:
      return "";
  }
}

//------------------------------------------------------------------------------
void InspectionColors::Release()
{
  this->Colors.Release();
  this->Coordinates.Release();
  this->Array = nullptr;
  this->What = Kind::None;
}
}
