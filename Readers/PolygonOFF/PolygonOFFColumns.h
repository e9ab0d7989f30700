// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::OFFColumns
 * @brief The arrays of a mesh that are written to an OFF file.
 */
#ifndef camaron_PolygonOFFColumns_h
#define camaron_PolygonOFFColumns_h

#include "Scan/ScanError.h"

#include <string> // for names

class vtkDataArray;
class vtkDataSet;

namespace camaron
{
/// The arrays to write; the names of colors are empty or "None" for none.
struct OFFColumnNames
{
  bool Normals;
  bool Texture;
  std::string VertexColors, FaceColors;
};

class OFFColumns
{
public:
  /**
   * Finds the arrays with these names, and warns about those that are not written. False
   * with the error in @a error if one cannot be written.
   */
  bool Find(vtkDataSet* mesh, const OFFColumnNames& names, const std::string& path,
    Warnings& warnings, ScanError& error);

  vtkDataArray* Normals = nullptr;
  vtkDataArray* Texture = nullptr;
  vtkDataArray* VertexColors = nullptr;
  vtkDataArray* FaceColors = nullptr;  ///< with three or four components
  vtkDataArray* FaceIndices = nullptr; ///< into a color map
};

/// Whether colors of an array are real numbers from 0 to 1, not integers from 0 to 255.
bool IsReal(vtkDataArray* array);
}

#endif
