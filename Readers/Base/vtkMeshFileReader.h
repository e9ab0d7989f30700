// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshFileReader
 * @brief Base class of the readers of mesh files.
 *
 * A subclass tells how to recognize and read a file; this class handles the file name, pieces and
 * ghost cells, progress and abort, warnings and errors. After an error the output is empty, one
 * message has been reported, and GetErrorCode() returns its vtkErrorCode. The request still
 * succeeds, so the pipeline neither adds a message of its own nor reads the file again before
 * something changes.
 *
 * If every process of the global controller reads the piece of its rank, an error in one makes all
 * fail. Process 0 reports the first error, and the warnings of all processes, each once.
 */
#ifndef vtkMeshFileReader_h
#define vtkMeshFileReader_h

#include "CamaronReadersModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory> // for the files
#include <string> // for paths

namespace camaron
{
class InputFiles;
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
  int CanReadFile(const char* fileName);

  /// All files that were opened since the reader exists, also those that belong to the named one.
  const camaron::InputFiles& GetFilesRead() const { return *this->FilesRead; }

protected:
  /// Whether the beginning of a file is in the format. Reports no errors.
  using IsFormat = bool (*)(const std::string& path);
  /// Reads a piece of a file into @a output; false with the error set, or without one if aborted.
  /// @param chunk bytes of text per task
  using ReadFormat = bool (*)(const std::string& path, const camaron::PieceRequest& request,
    vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
    const camaron::Progress& progress, vtkIdType chunk);

  /// @param read nullptr if the subclass has options, and implements ReadMesh
  vtkMeshFileReader(IsFormat is, ReadFormat read = nullptr);
  ~vtkMeshFileReader() override;

  /// Reads a piece of a file as ReadFormat does.
  virtual bool ReadMesh(const std::string& path, const camaron::PieceRequest& request,
    vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
    const camaron::Progress& progress);

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMeshFileReader(const vtkMeshFileReader&) = delete;
  void operator=(const vtkMeshFileReader&) = delete;

  char* FileName = nullptr;
  IsFormat Is;
  ReadFormat Read;
  std::unique_ptr<camaron::InputFiles> FilesRead;
};

#endif
