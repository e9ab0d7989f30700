// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::InspectionColors
 * @brief The colors that a mapper has computed from an array, in graphics memory.
 */
#ifndef camaron_InspectionColors_h
#define camaron_InspectionColors_h

#include "TextureBuffer.h"

#include "vtkSmartPointer.h" // for members
#include "vtkType.h"         // for vtkMTimeType

class vtkDataArray;

namespace camaron
{
class InspectionColors
{
public:
  enum class Kind
  {
    None,
    Cells,      ///< one color per cell
    Points,     ///< one color per point
    Coordinates ///< texture coordinates of the points in a color texture
  };

  /// Uploads @a array, with tuples of 1 to 4 bytes or 2 floats, unless it is already uploaded.
  void Update(Kind kind, vtkDataArray* array);
  /// The `#define` line for the shaders; empty without colors.
  const char* GetDefine() const;
  const TextureBuffer& GetTable() const
  {
    return this->What == Kind::Coordinates ? this->Coordinates : this->Colors;
  }
  void Release();

private:
  Kind What = Kind::None;
  vtkSmartPointer<vtkDataArray> Array;
  vtkMTimeType Time = 0;
  TextureBuffer Colors{ TextureBuffer::Row::Color };
  TextureBuffer Coordinates{ TextureBuffer::Row::Float2 };
};
}

#endif
