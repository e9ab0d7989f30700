// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PointNormals
 * @brief Normals of the points of a mesh in graphics memory: given normals, or those of the outer
 * faces.
 */
#ifndef camaron_PointNormals_h
#define camaron_PointNormals_h

#include "TextureBuffer.h"

#include "vtkSmartPointer.h" // for the array
#include "vtkType.h"         // for vtkMTimeType

class vtkDataArray;

namespace camaron
{
class InspectionMesh;

class PointNormals
{
public:
  /**
   * Creates the table if it does not exist. Points that are not on the outer faces have a normal of
   * length 0.
   *
   * @param given an array with three components; or null for means of the outer faces, weighted by
   * area
   */
  void Update(const InspectionMesh& mesh, vtkDataArray* given);
  bool IsEmpty() const { return !this->Normals.IsUploaded(); }
  const TextureBuffer& GetTable() const { return this->Normals; }
  void Release();

private:
  int Version = -1;
  vtkSmartPointer<vtkDataArray> Given;
  vtkMTimeType Time = 0;
  TextureBuffer Normals{ TextureBuffer::Row::Float4 };
};
}

#endif
