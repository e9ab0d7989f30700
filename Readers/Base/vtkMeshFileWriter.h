// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshFileWriter
 * @brief Common part of the writers of mesh files.
 *
 * A writer of a format says how to write a vtkUnstructuredGrid or vtkPolyData; this class does the
 * rest: the name of the file, input of other types (any vtkDataSet, composite data, whose blocks
 * are merged), time steps, progress and abort, warnings and errors. A file appears under its name
 * only when it is complete; after an error or an abort one that was there before is as it was.
 * Write() returns 1, or 0 after an error, with GetErrorCode() telling the kind (vtkErrorCode). What
 * the format cannot hold is left out with one warning per kind. An empty mesh is written, unless it
 * is empty because something upstream has failed, such as a reader.
 *
 * In parallel every process asks for its piece, and the first one gathers all and writes one file.
 * Ghost and hidden cells are left out, points of the same global id and place are merged; where
 * there are global ids, points and cells are sorted by them. Without such ids points of different
 * pieces at the same place are merged, with a warning. So are the pieces of a file that is written
 * as it was read (.pvtu, .pvtp), by one process, too. All processes of the controller must call
 * Write().
 */
#ifndef vtkMeshFileWriter_h
#define vtkMeshFileWriter_h

#include "CamaronFormatsModule.h" // for export macro
#include "vtkNew.h"               // for members
#include "vtkWriter.h"

#include <string> // for paths

class vtkDataSet;
class vtkMultiProcessController;
class vtkPartitionedDataSet;

namespace camaron
{
class Progress;
class Warnings;
struct ScanError;
}

class CAMARONFORMATS_EXPORT vtkMeshFileWriter : public vtkWriter
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

  ///@{
  /**
   * Whether to write one file per time step of the input, their numbers from 0 added to the name
   * (mesh_0.visf), instead of one of the current time step. Default: off.
   */
  vtkSetMacro(WriteTimeSteps, bool);
  vtkGetMacro(WriteTimeSteps, bool);
  vtkBooleanMacro(WriteTimeSteps, bool);
  ///@}

  ///@{
  /**
   * The processes that have the mesh together. Default: the global controller; none for a process
   * of its own.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkMeshFileWriter();
  ~vtkMeshFileWriter() override;

  /// Writes a mesh to a file; false with the error set, or without one if stopped.
  virtual bool WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) = 0;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void WriteData() override {}

private:
  vtkMeshFileWriter(const vtkMeshFileWriter&) = delete;
  void operator=(const vtkMeshFileWriter&) = delete;

  void WriteTo(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings);

  char* FileName = nullptr;
  bool WriteTimeSteps = false;
  int NumberOfTimeSteps = 0;
  int TimeStep = 0;
  vtkMultiProcessController* Controller = nullptr;
  int NumberOfPieces = 1;               // that a process asks for, one after the other
  vtkNew<vtkPartitionedDataSet> Pieces; // those that are there so far
};

#endif
