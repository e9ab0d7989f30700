// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ConversionFindings.h
 * @brief What happened while cells were made to fit a format, in numbers and in words.
 */
#ifndef camaron_ConversionFindings_h
#define camaron_ConversionFindings_h

#include "CellMesh/CellConversion.h"

#include <array>  // for numbers per type
#include <string> // for messages

namespace camaron
{
/// Counts per type of the input; merging does not depend on the order.
struct ConversionFindings
{
  std::array<Tally, 256> Unsupported;
  std::array<Tally, 256> Reduced;
  std::array<Tally, 256> Cut;
  Tally Surface;
  Tally Uncut;       ///< polygons that do not say where to cut
  Tally NotPositive; ///< cells with tetrahedra of no positive volume
  vtkIdType NumberOfNotPositive = 0;
  vtkIdType NumberOfFaces = 0;
  vtkIdType NumberOfLostPoints = 0; ///< of cells that are not written; of all together

  void Merge(const ConversionFindings& other)
  {
    for (std::size_t type = 0; type < 256; ++type)
    {
      this->Unsupported[type].Merge(other.Unsupported[type]);
      this->Reduced[type].Merge(other.Reduced[type]);
      this->Cut[type].Merge(other.Cut[type]);
    }
    this->Surface.Merge(other.Surface);
    this->Uncut.Merge(other.Uncut);
    this->NotPositive.Merge(other.NotPositive);
    this->NumberOfNotPositive += other.NumberOfNotPositive;
    this->NumberOfFaces += other.NumberOfFaces;
  }
};

/// Whether anything was met that the format cannot hold.
bool HasUnsupported(const ConversionFindings& found);

/// Says what cannot be written, and which option or other format would help; @a holdsSome says
/// whether other cells can be.
std::string DescribeRefusal(const CellConversion& how, const ConversionFindings& found,
  bool holdsSome, const std::string& path);

/// Says what is not written as it was.
void WarnOfConversion(
  const CellConversion& how, const ConversionFindings& found, Warnings& warnings);
}

#endif
