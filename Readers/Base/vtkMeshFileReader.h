// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshFileReader
 * @brief Base class of the readers of mesh files.
 *
 * A subclass recognizes and reads a file; this class handles the file name, pieces and ghost cells,
 * progress and abort, warnings and errors. After an error the output is empty, one message has been
 * reported, and GetErrorCode() returns its vtkErrorCode. The request still succeeds, so the
 * pipeline neither adds a message of its own nor reads the file again before something changes.
 *
 * If every process of the global controller reads the piece of its rank, an error in one makes all
 * fail. Process 0 reports the first error, and the warnings of all processes, each once.
 */
#ifndef vtkMeshFileReader_h
#define vtkMeshFileReader_h

#include "CamaronReadersModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // for paths

namespace camaron
{
class Progress;
class Warnings;
struct PieceRequest;
struct ScanError;
}

class CAMARONREADERS_EXPORT vtkMeshFileReader : public vtkUnstructuredGridAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkMeshFileReader, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Path of the file. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * 1 if the content of the file is in this format, else 0. Reads the beginning of the file only
   * and reports no errors.
   */
  virtual int CanReadFile(const char* fileName) = 0;

protected:
  vtkMeshFileReader();
  ~vtkMeshFileReader() override;

  /// Reads a piece of a file into @a output; false with the error set, or without one if aborted.
  virtual bool ReadMesh(const std::string& path, const camaron::PieceRequest& request,
    vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
    const camaron::Progress& progress) = 0;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMeshFileReader(const vtkMeshFileReader&) = delete;
  void operator=(const vtkMeshFileReader&) = delete;

  char* FileName = nullptr;
};

#endif
