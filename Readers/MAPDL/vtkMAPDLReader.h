// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMAPDLReader
 * @brief Reads meshes from decks of Ansys Mechanical APDL commands.
 *
 * A deck (.cdb of CDWRITE, .dat of Workbench, .inp written by hand) is text: commands, and blocks
 * of nodes and elements in fixed columns. The reader supports NBLOCK, EBLOCK, N, E, EN, EMORE, ET,
 * ETBLOCK, KEYOPT, CMBLOCK, the attributes TYPE, MAT, REAL and SECNUM, and parameters with values;
 * it skips everything else. See Readers/MAPDL/README.md.
 *
 * Output: a vtkUnstructuredGrid with double coordinates (in the unit of the deck) and linear or
 * quadratic cells in the order of the deck. Point array "NodeId"; cell arrays "ElementId",
 * "Material", "ElementType" (185 for SOLID185), "TypeId" (number of the type in the deck), "Real"
 * and "Section"; one array of 0 and 1 per component, of points or cells, and the names of all in
 * the field arrays "NodeComponents" and "ElementComponents".
 *
 * In parallel every process scans the file and keeps its part of the cells, with the requested
 * ghost cells, "GlobalPointIds" and "GlobalCellIds".
 *
 * @sa vtkMAPDLWriter
 */
#ifndef vtkMAPDLReader_h
#define vtkMAPDLReader_h

#include "vtkMeshFileReader.h"

class CAMARONREADERS_EXPORT vtkMAPDLReader : public vtkMeshFileReader
{
public:
  static vtkMAPDLReader* New();
  vtkTypeMacro(vtkMAPDLReader, vtkMeshFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether to create linear cells only. Mid-side nodes then become points without cells.
   * Default: off.
   */
  vtkSetMacro(Linear, bool);
  vtkGetMacro(Linear, bool);
  vtkBooleanMacro(Linear, bool);
  ///@}

  ///@{
  /**
   * Whether to keep surface elements for contact and loads, which lie on other elements (151 to
   * 156, 169 to 178). Default: on.
   */
  vtkSetMacro(SurfaceEffects, bool);
  vtkGetMacro(SurfaceEffects, bool);
  vtkBooleanMacro(SurfaceEffects, bool);
  ///@}

protected:
  vtkMAPDLReader();
  ~vtkMAPDLReader() override = default;

  bool ReadMesh(const std::string& path, const camaron::PieceRequest& request,
    vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
    const camaron::Progress& progress) override;

private:
  vtkMAPDLReader(const vtkMAPDLReader&) = delete;
  void operator=(const vtkMAPDLReader&) = delete;

  bool Linear = false;
  bool SurfaceEffects = true;
};

#endif
