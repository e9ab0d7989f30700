// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMAPDLReader
 * @brief Reads meshes from decks of Ansys Mechanical APDL commands.
 *
 * A deck (.cdb of CDWRITE, .dat of Workbench, .inp by hand) is text: commands, and blocks of nodes
 * and elements in fixed columns. NBLOCK, EBLOCK, N, E, EN, EMORE, ET, ETBLOCK, KEYOPT, CMBLOCK, the
 * attributes TYPE, MAT, REAL and SECNUM and parameters with values are read, all else is skipped.
 * See Readers/MAPDL/README.md.
 *
 * Output: a vtkUnstructuredGrid with double coordinates (in the unit of the deck) and linear or
 * quadratic cells in the order of the deck. Point array "NodeId"; cell arrays "ElementId",
 * "Material", "ElementType" (185 for SOLID185), "TypeId" (number of the type in the deck), "Real"
 * and "Section"; one array of 0 and 1 per component, of points or cells, and the names of all in
 * the field arrays "NodeComponents" and "ElementComponents".
 *
 * In parallel every process scans the file and keeps its share of the cells, with the ghost cells
 * asked for, "GlobalPointIds" and "GlobalCellIds".
 *
 * @sa vtkMAPDLWriter
 */
#ifndef vtkMAPDLReader_h
#define vtkMAPDLReader_h

#include "vtkMeshFileReader.h"

class CAMARONFORMATS_EXPORT vtkMAPDLReader : public vtkMeshFileReader
{
public:
  static vtkMAPDLReader* New();
  vtkTypeMacro(vtkMAPDLReader, vtkMeshFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether to make all cells linear. Mid-side nodes are points without cells then. Default: off.
   */
  vtkSetMacro(Linear, bool);
  vtkGetMacro(Linear, bool);
  vtkBooleanMacro(Linear, bool);
  ///@}

  ///@{
  /**
   * Whether to keep elements that lie on the surface of others for contact and loads (151 to 156,
   * 169 to 178). Default: on.
   */
  vtkSetMacro(SurfaceEffects, bool);
  vtkGetMacro(SurfaceEffects, bool);
  vtkBooleanMacro(SurfaceEffects, bool);
  ///@}

  ///@{
  /**
   * Whether elements that are no cells, such as MATRIX27, become sets of points. Otherwise they are
   * left out, with a warning in both cases. Default: off.
   */
  vtkSetMacro(UnknownElementsAsPoints, bool);
  vtkGetMacro(UnknownElementsAsPoints, bool);
  vtkBooleanMacro(UnknownElementsAsPoints, bool);
  ///@}

  int CanReadFile(const char* fileName) override;

protected:
  vtkMAPDLReader() = default;
  ~vtkMAPDLReader() override = default;

  bool ReadMesh(const std::string& path, const camaron::PieceRequest& request,
    vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
    const camaron::Progress& progress) override;

private:
  vtkMAPDLReader(const vtkMAPDLReader&) = delete;
  void operator=(const vtkMAPDLReader&) = delete;

  bool Linear = false;
  bool SurfaceEffects = true;
  bool UnknownElementsAsPoints = false;
};

#endif
