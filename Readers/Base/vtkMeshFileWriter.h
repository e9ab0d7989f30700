// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshFileWriter
 * @brief Base class of the writers of mesh files.
 *
 * A subclass writes a vtkUnstructuredGrid or vtkPolyData; this class handles the file name, input
 * of other types (any vtkDataSet; composite data, whose blocks are merged), time steps, progress
 * and abort, warnings and errors. The file appears under its name only when it is complete; after
 * an error or an abort, an existing file is unchanged. Files from which the input was read are not
 * replaced. Write() returns 1, or 0 after an error, and
 * GetErrorCode() returns its vtkErrorCode. Data the format cannot store is left out, with one
 * warning per category. An empty mesh is written, unless it is empty because an upstream filter or
 * reader failed.
 *
 * In parallel every process requests its piece, and process 0 gathers all and writes one file.
 * Ghost and hidden cells are left out, points with the same global id and position are merged;
 * points and cells with global ids are sorted by them. Without such ids, points of different pieces
 * at the same position are merged, with a warning. A single process does the same with the pieces
 * of a file that is written as it was read (.pvtu, .pvtp). All processes of the controller must
 * call Write().
 */
#ifndef vtkMeshFileWriter_h
#define vtkMeshFileWriter_h

#include "CamaronReadersModule.h" // for export macro
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

class CAMARONREADERS_EXPORT vtkMeshFileWriter : public vtkWriter
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
   * Whether to write all time steps of the input, one file each, with a number from 0 added to the
   * name (mesh_0.visf), instead of the current one only. Default: off.
   */
  vtkSetMacro(WriteTimeSteps, bool);
  vtkGetMacro(WriteTimeSteps, bool);
  vtkBooleanMacro(WriteTimeSteps, bool);
  ///@}

  ///@{
  /**
   * Whether a file is also written where rounding of the coordinates, to single precision or to
   * some digits, changes the length of an edge by more than 1 %, or the sign of the volume of a
   * cell. Default: off, which is an error.
   */
  vtkSetMacro(AllowRounding, bool);
  vtkGetMacro(AllowRounding, bool);
  vtkBooleanMacro(AllowRounding, bool);
  ///@}

  ///@{
  /**
   * Controller of the processes among which the mesh is distributed; nullptr if each writes its
   * own. Default: the global controller.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkMeshFileWriter();
  ~vtkMeshFileWriter() override;

  /// Writes a mesh to a file; false with the error set, or without one if aborted. May throw
  /// std::bad_alloc and std::length_error.
  virtual bool WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) = 0;

  /// Number of significant decimal digits of the coordinates in the file, see CheckRoundedCells.
  virtual int GetDigitsOfCoordinates() const { return 0; } // all

  /// Whether the format has names of boundaries, which blocks of 2D cells give, see NameZones.
  virtual bool HasZones() const { return false; }

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
  bool AllowRounding = false;
  int NumberOfTimeSteps = 0;
  int TimeStep = 0;
  vtkMultiProcessController* Controller = nullptr;
  int NumberOfPieces = 1;               // that a process requests, one after the other
  vtkNew<vtkPartitionedDataSet> Pieces; // received so far
};

#endif
