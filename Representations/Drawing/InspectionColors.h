// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::InspectionColors
 * @brief The colors that a mapper made of an array, in graphics memory.
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
    Cells,      ///< a color for each cell
    Points,     ///< a color for each point
    Coordinates ///< of the points in a texture
  };

  /// Uploads @a array, rows of 1 to 4 bytes or of 2 floats, unless it is there already.
  void Update(Kind kind, vtkDataArray* array);
  Kind GetKind() const { return this->What; }
  /// What the shaders are to know; empty for none.
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
