// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshFileWriter
 * @brief Common part of the writers of mesh files.
 *
 * A writer of a format says how to write a mesh; this class does the rest: the name of the file, the
 * input (a vtkUnstructuredGrid or vtkPolyData), progress and abort, warnings and errors. A file
 * appears under its name only when it is complete; after an error or an abort one that was there
 * before is as it was. Write() returns 1, or 0 after an error, with GetErrorCode() telling the kind
 * (vtkErrorCode). What the format cannot hold is left out with one warning per kind.
 */
#ifndef vtkMeshFileWriter_h
#define vtkMeshFileWriter_h

#include "CamaronWritersModule.h" // for export macro
#include "vtkWriter.h"

#include <string> // for paths

class vtkDataSet;

namespace camaron
{
class Progress;
class Warnings;
struct ScanError;
}

class CAMARONWRITERS_EXPORT vtkMeshFileWriter : public vtkWriter
{
public:
  vtkAbstractTypeMacro(vtkMeshFileWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Path of the file. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkMeshFileWriter() = default;
  ~vtkMeshFileWriter() override;

  /// Writes a mesh to a file; false with the error set, or without one if stopped.
  virtual bool WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) = 0;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkMeshFileWriter(const vtkMeshFileWriter&) = delete;
  void operator=(const vtkMeshFileWriter&) = delete;

  char* FileName = nullptr;
};

#endif
