// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPolyMeshWriter
 * @brief Writes a mesh of 3D cells as the mesh of an OpenFOAM case.
 *
 * The file name is that of a marker, case.foam, which is created empty; the mesh is the folder
 * constant/polyMesh beside it. See Readers/PolyMesh/README.md. Patches and zones come from the
 * arrays that vtkFluentMeshWriter writes, too; cells whose array "Selected" is not 0 become the
 * cellSet Selected.
 */
#ifndef vtkPolyMeshWriter_h
#define vtkPolyMeshWriter_h

#include "vtkCellMeshFileWriter.h"

class CAMARONREADERS_EXPORT vtkPolyMeshWriter : public vtkCellMeshFileWriter
{
public:
  static vtkPolyMeshWriter* New();
  vtkTypeMacro(vtkPolyMeshWriter, vtkCellMeshFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum EncodingType
  {
    ASCII = 0,
    BINARY = 1 ///< in the byte order of the machine
  };

  ///@{
  /// Encoding of the files. Default: ASCII.
  vtkSetClampMacro(Encoding, int, ASCII, BINARY);
  vtkGetMacro(Encoding, int);
  ///@}

  ///@{
  /// Whether the files are compressed by gzip. Default: off.
  vtkSetMacro(Compress, bool);
  vtkGetMacro(Compress, bool);
  vtkBooleanMacro(Compress, bool);
  ///@}

  enum LabelSizeType
  {
    LABELS_32 = 0,
    LABELS_64 = 1
  };

  ///@{
  /// Size of integers in binary files: that of the OpenFOAM that will read them. Default:
  /// LABELS_32.
  vtkSetClampMacro(LabelSize, int, LABELS_32, LABELS_64);
  vtkGetMacro(LabelSize, int);
  ///@}

  ///@{
  /// Factor for the coordinates, greater than 0: 0.001 for a mesh in millimeters, as OpenFOAM's
  /// unit is the meter. Default: 1.
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /// Whether a mesh in constant/polyMesh is replaced. Default: off, which is an error.
  vtkSetMacro(Overwrite, bool);
  vtkGetMacro(Overwrite, bool);
  vtkBooleanMacro(Overwrite, bool);
  ///@}

protected:
  vtkPolyMeshWriter() = default;
  ~vtkPolyMeshWriter() override = default;

  bool HasZones() const override { return true; }
  bool WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) override;

private:
  vtkPolyMeshWriter(const vtkPolyMeshWriter&) = delete;
  void operator=(const vtkPolyMeshWriter&) = delete;

  int Encoding = ASCII;
  bool Compress = false;
  int LabelSize = LABELS_32;
  double Scale = 1;
  bool Overwrite = false;
};

#endif
