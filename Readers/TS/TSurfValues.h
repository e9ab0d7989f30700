// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TSurfValues
 * @brief Reads coordinates and properties of the vertices of TSurf objects in a piece.
 *
 * Properties of the same name and size become one array, with NaN for vertices without a value.
 */
#ifndef camaron_TSurfValues_h
#define camaron_TSurfValues_h

#include "Intake/CellMesh/CellMeshPiece.h"
#include "TSurfRecords.h"

class vtkDataArray;
class vtkDataSetAttributes;

namespace camaron
{
class TSurfValues
{
public:
  /// @param scanner for errors
  TSurfValues(TextScanner& scanner, const std::vector<TSurfObject>& objects)
    : Scanner(scanner)
    , Objects(objects)
  {
  }

  /// False with the error in the scanner, or if aborted.
  bool Read(TSurfRecords& records, const CellMeshPiece& piece, const Progress& progress);

  ///@{
  /// Move out the results; each may be called once.
  vtkSmartPointer<vtkDataArray> TakePoints();
  void AddArrays(vtkDataSetAttributes* data);
  ///@}

private:
  struct Array
  {
    std::string Name;
    int Size;
    Buffer<double> Values;
  };

  bool MakeArrays(const TSurfRecords& records, vtkIdType numberOfPoints);
  bool AddObject(const TSurfObject& object, std::vector<std::size_t>& arrays);
  bool ReadVertex(TextRow& row, TSurfLine what, std::size_t object, vtkIdType point);

  TextScanner& Scanner;
  const std::vector<TSurfObject>& Objects;
  Buffer<double> Coordinates;
  Buffer<vtkIdType> Ids; ///< of the file, if they differ from those of VTK
  std::vector<Array> Arrays;
  std::vector<std::vector<std::size_t>> ArraysOfObjects; ///< one for each property
};
}

#endif
