// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::OFFColumns
 * @brief The arrays of a mesh that are written to an OFF file.
 */
#ifndef camaron_PolygonOFFColumns_h
#define camaron_PolygonOFFColumns_h

#include "PolygonOFFWriting.h"

class vtkDataArray;

namespace camaron
{
class OFFColumns
{
public:
  /**
   * Finds the arrays that the options request, and warns about those that are not written. False
   * with the error in @a error if one cannot be written.
   */
  bool Find(vtkDataSet* mesh, const OFFOptions& options, const std::string& path,
    Warnings& warnings, ScanError& error);

  /// The first word of the file.
  std::string GetKeyword() const;

  vtkDataArray* Normals = nullptr;
  vtkDataArray* Texture = nullptr;
  vtkDataArray* VertexColors = nullptr;
  vtkDataArray* FaceColors = nullptr;  ///< with three or four components
  vtkDataArray* FaceIndices = nullptr; ///< into a color map
};

/// Red, green, blue and alpha from 0 to 255, from an array of integers, or of real numbers from 0
/// to 1.
void GetOFFColor(vtkDataArray* colors, vtkIdType tuple, int bytes[4]);
}

#endif
