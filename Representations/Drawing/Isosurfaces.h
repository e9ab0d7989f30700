// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::Isosurfaces
 * @brief Computes the isosurfaces of a mesh on the graphics card, and stores them there.
 *
 * Cells are cut into tetrahedra once (CellTetrahedra.h); a geometry shader then creates the
 * triangles of each tetrahedron and isovalue. Blocks of cells whose range does not contain an
 * isovalue are skipped. Runs only if the mesh, the array or the isovalues have changed, not when
 * the camera moves.
 */
#ifndef camaron_Isosurfaces_h
#define camaron_Isosurfaces_h

#include "FeedbackProgram.h"
#include "TextureBuffer.h"

#include "vtkSmartPointer.h" // for the array

#include <array>  // for ranges
#include <vector> // for the values

class vtkDataArray;

namespace camaron
{
class InspectionMesh;

class Isosurfaces
{
public:
  /**
   * Updates the surfaces. Requires that the context is current and no program is in use; changes
   * texture units.
   *
   * @param array point array, of which the magnitude is used if it has several components; null: no
   * surface
   * @throw std::exception if the graphics card cannot create them
   */
  void Update(InspectionMesh& mesh, vtkDataArray* array, const std::vector<double>& isovalues);

  /// One row per vertex of a triangle: two points, the position between them (in units of 2^-24),
  /// and the tetrahedron.
  const TextureBuffer& GetTable() const { return this->Table; }
  std::size_t GetNumberOfTriangles() const { return this->NumberOfTriangles; }
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
  double Origin = 0; ///< subtracted from the values
  std::vector<double> Isovalues;
  std::size_t NumberOfTriangles = 0;
};
}

#endif
