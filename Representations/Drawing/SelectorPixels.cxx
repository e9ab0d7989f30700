// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SelectorPixels.h"

#include "vtkDataArray.h"
#include "vtkHardwareSelector.h"

namespace camaron
{
//------------------------------------------------------------------------------
vtkIdType GetLargestId(vtkDataArray* ids, vtkIdType size)
{
  const vtkIdType largest = ids && size > 0 ? static_cast<vtkIdType>(ids->GetRange(0)[1]) : 0;
  return largest > size - 1 ? largest : size - 1;
}

//------------------------------------------------------------------------------
void MapSelectorPixels(vtkHardwareSelector* selector, const std::vector<unsigned int>& pixelOffsets,
  int lowPass, int highPass, vtkDataArray* ids)
{
  const unsigned char* low = selector->GetRawPixelBuffer(lowPass);
  const unsigned char* high = selector->GetRawPixelBuffer(highPass); // null for few elements
  unsigned char* pixels = selector->GetPixelBuffer(selector->GetCurrentPass());
  if (!ids || !low || !pixels)
  {
    return;
  }
  const int firstBit = selector->GetCurrentPass() == highPass ? 24 : 0;
  for (const unsigned int pixel : pixelOffsets)
  {
    const vtkIdType painted = low[pixel] | low[pixel + 1] << 8 | low[pixel + 2] << 16 |
      (high ? static_cast<vtkIdType>(high[pixel]) << 24 : 0);
    if (painted < ids->GetNumberOfTuples())
    {
      const auto id = static_cast<vtkIdType>(ids->GetComponent(painted, 0)) >> firstBit;
      pixels[pixel] = id & 0xff;
      pixels[pixel + 1] = (id >> 8) & 0xff;
      pixels[pixel + 2] = (id >> 16) & 0xff;
    }
  }
}
}
