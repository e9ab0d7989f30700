// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ConversionFindings.h
 * @brief Statistics of the conversion of cells to a format, and messages about it.
 */
#ifndef camaron_ConversionFindings_h
#define camaron_ConversionFindings_h

#include "Intake/CellMesh/CellConversion.h"

#include <array>  // for numbers per type
#include <string> // for messages

namespace camaron
{
/// Counts per cell type of the input; merging does not depend on the order.
struct ConversionFindings
{
  std::array<Tally, 256> Unsupported;
  std::array<Tally, 256> Reduced;
  std::array<Tally, 256> Cut;
  Tally Surface;
  Tally Uncut;       ///< polygons without a valid triangulation
  Tally NotPositive; ///< cells with tetrahedra without positive volume
  vtkIdType NumberOfNotPositive = 0;
  vtkIdType NumberOfFaces = 0;
  vtkIdType NumberOfLostPoints = 0; ///< points of omitted cells; total over all types

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

/// Whether there are cells that the format cannot store.
bool HasUnsupported(const ConversionFindings& found);

/// Error message: which cells cannot be written, and which option or other format would help.
/// @a holdsSome: whether other cells can be written.
std::string DescribeRefusal(const CellConversion& how, const ConversionFindings& found,
  bool holdsSome, const std::string& path);

/// Warns about cells that are not written unchanged.
void WarnOfConversion(
  const CellConversion& how, const ConversionFindings& found, Warnings& warnings);
}

#endif
