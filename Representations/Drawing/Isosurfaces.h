// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::Isosurfaces
 * @brief Makes the isosurfaces of a mesh on the graphics card, and keeps them there.
 *
 * The cells are cut into tetrahedra once (CellTetrahedra.h); then a geometry shader makes the
 * triangles of each tetrahedron and value. Blocks of cells that a value does not meet are left out.
 * Runs only when the mesh, the array or the values changed; the camera does not matter.
 */
#ifndef camaron_Isosurfaces_h
#define camaron_Isosurfaces_h

#include "FeedbackProgram.h"
#include "TextureBuffer.h"

#include "vtkSmartPointer.h" // for the array

#include <array>  // for ranges
#include <string> // for errors
#include <vector> // for the values

class vtkDataArray;

namespace camaron
{
class InspectionMesh;

class Isosurfaces
{
public:
  /**
   * Brings the surfaces up to date. Needs the context current and no program in use; changes
   * texture units.
   * @param array of the points; of several components the length is taken; null makes no surface
   * @return false when the graphics card refuses; GetError says why
   */
  bool Update(InspectionMesh& mesh, vtkDataArray* array, const std::vector<double>& isovalues);

  /// One row for each corner of a triangle: two points, where between them (of 2^24), the
  /// tetrahedron.
  const TextureBuffer& GetTable() const { return this->Table; }
  std::size_t GetNumberOfTriangles() const { return this->NumberOfTriangles; }
  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  void UpdateValues(InspectionMesh& mesh, vtkDataArray* array);
  void Draw(const InspectionMesh& mesh, const std::vector<double>& isovalues) const;

  FeedbackProgram Program;
  TextureBuffer Values{ TextureBuffer::Row::Float };
  TextureBuffer Table{ TextureBuffer::Row::UInt4 };
  std::vector<std::array<float, 2>> BlockRanges;
  int Version = -1;
  vtkSmartPointer<vtkDataArray> Array;
  unsigned long long ArrayTime = 0;
  double Origin = 0; ///< of the values
  std::vector<double> Isovalues;
  std::size_t NumberOfTriangles = 0;
  std::string Error;
};
}

#endif
