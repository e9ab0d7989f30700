// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TSurfWriting
 * @brief Writes triangles as TSurf objects of GOCAD.
 *
 * Point arrays become properties. The cell array "Part" splits the mesh into several objects if
 * every part has points of its own, as after reading such a file; "TFace" splits these into faces
 * if it does not decrease. Field data "PartName", "ZPositive" and "AxisUnit" with a value per
 * object is written, too.
 */
#ifndef camaron_TSurfWriting_h
#define camaron_TSurfWriting_h

#include "Base/Progress.h"
#include "Intake/CellMesh/OutputMesh.h"
#include "Intake/CellMesh/OutputWarnings.h"
#include "Intake/Write/OutputFile.h"

#include <string> // for names
#include <vector> // for objects

class vtkDataArray;
class vtkDataSet;
class vtkStringArray;

namespace camaron
{
class TSurfWriting
{
public:
  /// @param input the mesh from which @a mesh was converted
  TSurfWriting(vtkDataSet* input, const OutputMesh& mesh);

  /// Warns about data the file cannot store.
  void Warn(Warnings& warnings) const;

  /// False with the error in @a file, or if aborted.
  bool Write(OutputFile& file, const Progress& progress) const;

private:
  /// First point and triangle of an object; its end is the next object.
  struct Object
  {
    vtkIdType Point;
    vtkIdType Triangle;
  };

  void FindProperties();
  void FindObjects();
  void FindFaces();
  void ListFields();
  vtkIdType GetFace(vtkIdType triangle) const;
  vtkStringArray* FindTexts(const char* name) const;
  std::string GetText(const char* name, std::size_t object) const;
  std::string MakePreamble(std::size_t object) const;
  void AppendPoint(vtkIdType point, vtkIdType id, std::string& text) const;

  vtkDataSet* Input;
  const OutputMesh& Mesh;
  std::vector<Object> Objects; ///< and one more, for the end
  std::vector<vtkDataArray*> Properties;
  std::vector<std::string> NoData; ///< of properties, the value for NaN
  vtkDataArray* Faces = nullptr;
  WrittenArrays Written;
};
}

#endif
