// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TSurfValues
 * @brief Reads coordinates and properties of the vertices of TSurf objects in a piece.
 *
 * Properties of the same name and size become one array, with NaN for vertices without a value.
 *
 * Atoms of vertices outside of the piece are compared with them, too, so that every piece finds all
 * conflicts.
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

  void Warn(Warnings& warnings) const;
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

  bool MakeArrays(const TSurfRecords& records, vtkIdType numberOfPlaces);
  // An array of that name and size, possibly of another object, but not one that this object has
  // used already.
  std::size_t FindArray(const TSurfProperty& property, const std::vector<std::size_t>& used);
  /// How the number of values of a record compares to the number of properties.
  enum class Fit
  {
    Exact,
    Short,
    Long
  };
  template <typename Take>
  bool ReadProperties(TextRow& row, std::size_t object, Fit& fit, Take&& take) const;
  void FindOutside(const TSurfRecords& records, const CellMeshPiece& piece);
  /// Place of the values of a point: its index in the piece, or after all of these if it is
  /// Outside; -1 if there is none.
  vtkIdType FindPlace(vtkIdType point, const CellMeshPiece& piece) const;
  bool ReadVertex(TextRow& row, TSurfLine what, std::size_t object, vtkIdType place, Fit& fit);
  const char* ReadChunk(
    const TSurfRecords& records, const TSurfRecords::Chunk& chunk, const CellMeshPiece& piece);
  void ReadAtoms(const TSurfRecords& records, const CellMeshPiece& piece);
  /// The values of the points of the piece.
  template <typename VTKArray, typename Value>
  vtkSmartPointer<VTKArray> TakeOfPiece(Buffer<Value>& values, int size, const char* name) const;

  TextScanner& Scanner;
  const std::vector<TSurfObject>& Objects;
  vtkIdType NumberOfPoints = 0;      ///< of the piece
  std::vector<std::int32_t> Outside; ///< points of property atoms that the piece lacks, ascending
  Buffer<double> Coordinates;
  Buffer<vtkIdType> Ids; ///< of the file, if they differ from those of VTK
  std::vector<Array> Arrays;
  std::vector<std::vector<std::size_t>> ArraysOfObjects; ///< one for each property
  std::atomic<vtkIdType> Short{ 0 }; ///< records with fewer values than properties
  std::atomic<vtkIdType> Long{ 0 };  ///< records with more
  vtkIdType Conflicts = 0;           ///< atoms whose values differ from those of their vertex
};
}

#endif
