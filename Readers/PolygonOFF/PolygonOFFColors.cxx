// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonOFFColors.h"

#include "Base/Buffer.h"
#include "Base/Parallel.h"

#include "vtkDataSetAttributes.h"
#include "vtkIntArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace camaron
{
namespace
{
constexpr std::uint32_t Default =
  0xaaaaaaaa; // red, green, blue and alpha of 2/3, the default of Geomview
constexpr int NoIndex = -1;

//------------------------------------------------------------------------------
bool IsIndex(const OFFColor& color)
{
  const double value = color.Values[0];
  return color.Count == 1 && std::fabs(value) <= INT32_MAX && std::trunc(value) == value;
}

//------------------------------------------------------------------------------
bool IsSmall(const OFFColor& color)
{
  return !color.IsReal &&
    std::all_of(color.Values, color.Values + color.Count, [](double v) { return v <= 1; });
}
}

//------------------------------------------------------------------------------
int ToColorByte(double value, bool isReal)
{
  const double scaled = isReal ? value * FullColor + 0.5 : value;
  return scaled > 0 ? static_cast<int>(std::min(scaled, double(FullColor))) : 0;
}

//------------------------------------------------------------------------------
bool OFFColor::IsInRange() const
{
  const double last = this->IsReal ? 1 : FullColor;
  return this->Count < 3 ||
    std::all_of(
      this->Values, this->Values + this->Count, [=](double v) { return v >= 0 && v <= last; });
}

//------------------------------------------------------------------------------
bool OFFColors::Census::Add(const OFFColor& color)
{
  if (IsIndex(color))
  {
    this->HasIndices = true;
    return true;
  }
  if (color.Count < 3)
  {
    return color.Count == 0;
  }
  this->HasColors = true;
  this->HasReals = this->HasReals || color.IsReal;
  this->HasBytes = this->HasBytes || (!color.IsReal && !IsSmall(color));
  return true;
}

//------------------------------------------------------------------------------
void OFFColors::Census::Merge(const Census& other)
{
  this->HasColors = this->HasColors || other.HasColors;
  this->HasIndices = this->HasIndices || other.HasIndices;
  this->HasReals = this->HasReals || other.HasReals;
  this->HasBytes = this->HasBytes || other.HasBytes;
}

//------------------------------------------------------------------------------
void OFFColors::Resize(vtkIdType size)
{
  this->Values.resize(static_cast<std::size_t>(size), Default);
  this->Kinds.resize(static_cast<std::size_t>(size), None);
}

//------------------------------------------------------------------------------
void OFFColors::Set(vtkIdType i, const OFFColor& color)
{
  if (IsIndex(color))
  {
    this->Kinds[i] = Index;
    this->Values[i] = static_cast<std::uint32_t>(static_cast<std::int32_t>(color.Values[0]));
    return;
  }
  if (color.Count < 3)
  {
    this->Kinds[i] = None;
    this->Values[i] = Default;
    return;
  }
  const bool hasAlpha = color.Count == 4;
  unsigned char bytes[4];
  for (int c = 0; c < 4; ++c)
  {
    const bool isGiven = c < 3 || hasAlpha;
    bytes[c] = isGiven ? ToColorByte(color.Values[c], color.IsReal) : FullColor;
  }
  std::memcpy(&this->Values[i], bytes, sizeof(bytes));
  this->Kinds[i] = !IsSmall(color) ? Bytes : hasAlpha ? SmallRGBA : SmallRGB;
}

//------------------------------------------------------------------------------
void OFFColors::AddTo(vtkDataSetAttributes* attributes, const Census& census, bool areSmallReal)
{
  Buffer<int> indices(census.HasIndices ? this->size() : 0);
  Buffer<unsigned char> colors(census.HasColors ? 4 * this->size() : 0);
  ParallelFor(this->size(), LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const unsigned char kind = this->Kinds[i];
        if (census.HasIndices)
        {
          indices[i] = kind == Index ? static_cast<int>(this->Values[i]) : NoIndex;
        }
        if (census.HasColors)
        {
          const std::uint32_t value = kind == Index ? Default : this->Values[i];
          unsigned char* const bytes = colors.data() + 4 * i;
          std::memcpy(bytes, &value, sizeof(value));
          const int small = kind == SmallRGB ? 3 : kind == SmallRGBA ? 4 : 0;
          for (int c = 0; c < small && areSmallReal; ++c)
          {
            bytes[c] = bytes[c] ? FullColor : 0;
          }
        }
      }
    });
  if (census.HasIndices)
  {
    attributes->AddArray(indices.TakeArray<vtkIntArray>(1, "ColorIndex"));
  }
  if (census.HasColors)
  {
    attributes->AddArray(colors.TakeArray<vtkUnsignedCharArray>(4, "RGBA"));
  }
}
}
