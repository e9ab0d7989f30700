// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFluentHDF5Reader
 * @brief Reads meshes from mesh and case files of Ansys Fluent in HDF5 (Common Fluids Format).
 *
 * The same mesh as of a file in text: see Readers/FluentHDF5/README.md for the files, and
 * vtkFluentReader for the outputs. The fields of a data file become cell arrays of output 0, if
 * they are chosen: float or double as in the file, NaN in cells without a value.
 */
#ifndef vtkFluentHDF5Reader_h
#define vtkFluentHDF5Reader_h

#include "vtkFluentReader.h"
#include "vtkNew.h" // for the selections

#include <memory> // for the request

class vtkDataArraySelection;

namespace camaron
{
struct FluentFieldRequest;
}

class CAMARONREADERS_EXPORT vtkFluentHDF5Reader : public vtkFluentReader
{
public:
  static vtkFluentHDF5Reader* New();
  vtkTypeMacro(vtkFluentHDF5Reader, vtkFluentReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Path of the data file. Default: none, which means case.dat.h5 beside case.cas.h5, if it exists.
   */
  vtkSetFilePathMacro(DataFile);
  vtkGetFilePathMacro(DataFile);
  ///@}

  /**
   * The fields of cells in the data file, after UpdateInformation, and whether they are read.
   * Default: none is.
   */
  vtkDataArraySelection* GetCellArraySelection();

  /**
   * The zones of cells and boundary faces in the file, after UpdateInformation, and whether they
   * are read. Default: all are. Cells of the others, and points that only these have, are left out.
   */
  vtkDataArraySelection* GetZoneSelection();

  vtkMTimeType GetMTime() override;

protected:
  vtkFluentHDF5Reader();
  ~vtkFluentHDF5Reader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool ReadZones(const std::string& path, const camaron::PieceRequest& request,
    vtkUnstructuredGrid* grid, vtkMultiBlockDataSet* boundaries, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) override;

private:
  vtkFluentHDF5Reader(const vtkFluentHDF5Reader&) = delete;
  void operator=(const vtkFluentHDF5Reader&) = delete;

  void FindFields(const std::string& path);

  char* DataFile = nullptr;
  vtkNew<vtkDataArraySelection> CellArrays;
  vtkNew<vtkDataArraySelection> Zones;
  bool HasListedZones = false;
  std::unique_ptr<camaron::FluentFieldRequest> Fields; ///< of the file that is read
};

#endif
