// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFluentReader
 * @brief Base class of the readers of meshes of Ansys Fluent: in text and binary, and in HDF5.
 *
 * Output 0: a vtkUnstructuredGrid of the cells, with the zone of every cell in "Zone" and the zones
 * in "ZoneIds", "ZoneNames", "ZoneTypes" and "ZoneBoundaryTypes" as field data. Points are double,
 * or float for binary files of single precision. Faces distinguish inside from outside, so inverted
 * cells remain inverted.
 *
 * Output 1: a vtkMultiBlockDataSet with the boundary faces of every zone, by name.
 *
 * In parallel every process scans the file and keeps its part of the cells, with the requested
 * ghost cells, "GlobalPointIds" and "GlobalCellIds".
 */
#ifndef vtkFluentReader_h
#define vtkFluentReader_h

#include "vtkMeshFileReader.h"

class vtkMultiBlockDataSet;

class CAMARONREADERS_EXPORT vtkFluentReader : public vtkMeshFileReader
{
public:
  vtkAbstractTypeMacro(vtkFluentReader, vtkMeshFileReader);

protected:
  using ReadFormat = bool (*)(const std::string& path, const camaron::PieceRequest& request,
    vtkUnstructuredGrid* grid, vtkMultiBlockDataSet* boundaries, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress);

  /// @param read nullptr if the subclass has options, and implements ReadZones
  explicit vtkFluentReader(IsFormat is, ReadFormat read = nullptr);
  ~vtkFluentReader() override = default;

  /// Reads a piece of a file, with the boundaries if these are given, which are empty; false with
  /// the error, or without one if aborted.
  virtual bool ReadZones(const std::string& path, const camaron::PieceRequest& request,
    vtkUnstructuredGrid* grid, vtkMultiBlockDataSet* boundaries, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress);

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool ReadMesh(const std::string& path, const camaron::PieceRequest& request,
    vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
    const camaron::Progress& progress) override;

private:
  vtkFluentReader(const vtkFluentReader&) = delete;
  void operator=(const vtkFluentReader&) = delete;

  ReadFormat Read;
  vtkMultiBlockDataSet* Boundaries = nullptr; ///< during RequestData
};

#endif
