// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TSurfValues
 * @brief Reads coordinates and properties of the vertices of TSurf objects that a piece has.
 *
 * Properties of the same name and size are one array, with nan for vertices that have none.
 */
#ifndef camaron_TSurfValues_h
#define camaron_TSurfValues_h

#include "CellMesh/CellMeshPiece.h"
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

  /// False with the error in the scanner, or if stopped.
  bool Read(TSurfRecords& records, const CellMeshPiece& piece, const Progress& progress);

  void Warn(Warnings& warnings) const;
  ///@{
  /// What was read; once each.
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
  // An array of that name and size, which objects share, but none that this object has used
  // already.
  std::size_t FindArray(const TSurfProperty& property, const std::vector<std::size_t>& used);
  /// Whether a record has as many values as there are properties.
  enum class Fit
  {
    Exact,
    Short,
    Long
  };
  template <typename Take>
  bool ReadProperties(TextRow& row, std::size_t object, Fit& fit, Take&& take) const;
  bool ReadVertex(TextRow& row, TSurfLine what, std::size_t object, vtkIdType point, Fit& fit);
  const char* ReadChunk(
    const TSurfRecords& records, const TSurfRecords::Chunk& chunk, const CellMeshPiece& piece);
  void ReadAtoms(const TSurfRecords& records, const CellMeshPiece& piece);

  TextScanner& Scanner;
  const std::vector<TSurfObject>& Objects;
  Buffer<double> Coordinates;
  Buffer<vtkIdType> Ids; ///< of the file, if they differ from VTK's
  std::vector<Array> Arrays;
  std::vector<std::vector<std::size_t>> ArraysOfObjects; ///< one for each property
  std::atomic<vtkIdType> Short{ 0 }; ///< records with fewer values than properties
  std::atomic<vtkIdType> Long{ 0 };  ///< records with more
  vtkIdType Conflicts = 0;           ///< atoms with other values than their vertex
};
}

#endif
