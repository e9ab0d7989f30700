// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OutputWarnings.h
 * @brief Warnings about data that is lost when a mesh is written.
 */
#ifndef camaron_OutputWarnings_h
#define camaron_OutputWarnings_h

#include "Scan/ScanError.h"

#include <optional> // for formats without arrays
#include <string>   // for names
#include <vector>   // for names

class vtkAbstractArray;
class vtkDataArray;
class vtkDataSet;

namespace camaron
{
class OutputMesh;

/// Names of the arrays that are written.
struct WrittenArrays
{
  std::vector<std::string> Points;
  std::vector<std::string> Cells;
  std::vector<std::string> Fields;
};

/// The name of an array for messages, also of an unnamed one.
std::string DescribeArray(vtkAbstractArray* array);

/// The same for a point or cell array; adds which of these it is if both exist.
std::string DescribeArray(vtkDataSet* mesh, vtkAbstractArray* array, bool ofCells);

/**
 * Warns about arrays that are not written, except those for VTK's internal use (global ids,
 * ghosts, time).
 * @param format e.g. "Visf"
 * @param known arrays of the mesh that are written; without it, the format stores no arrays at all
 */
void WarnOfArrays(vtkDataSet* mesh, const char* format, Warnings& warnings,
  const std::optional<WrittenArrays>& known = {});

/**
 * Warns about points whose coordinates change in single precision. Returns false with an error if
 * a coordinate is out of range.
 * @param mesh as for MeshView
 * @param path of the file, for the error
 */
bool CheckSinglePrecision(
  vtkDataSet* mesh, const std::string& path, Warnings& warnings, ScanError& error);

/// Numbers of significant decimal digits of coordinates that stand for others.
constexpr int AllDigits = 0, DigitsOfFloat = -1;

/**
 * Whether cells keep their shape when coordinates are rounded: false, with an error that names the
 * worst cell, if the length of an edge changes by more than 1 %, or the sign of the volume of a
 * cell.
 * @param mesh as for MeshView
 * @param digits that remain
 * @param path of the file, for the error
 */
bool CheckRoundedCells(vtkDataSet* mesh, int digits, const std::string& path, ScanError& error);

/**
 * As CheckSinglePrecision for an array, or nullptr for none.
 * @param components number of components written
 * @param one name of a tuple, e.g. "normal"
 */
bool CheckSinglePrecision(vtkDataArray* array, int components, const char* one, const char* many,
  const std::string& path, Warnings& warnings, ScanError& error);

/// Warns about integers that change in double precision, which formats use for numbers.
void WarnOfIntegers(vtkDataArray* array, Warnings& warnings);

/// The number of significant digits that keeps the coordinates of the written points: 9 if these
/// are enough, else 17.
int ChooseDigits(vtkDataSet* mesh, const OutputMesh& output);

/**
 * Warns about written points whose coordinates have more significant digits than @a digits; and if
 * the error exceeds a millionth of the size of the mesh, because it is far from the origin or
 * there are too few digits.
 * @param digits AllDigits for no warning
 */
void WarnOfDigits(vtkDataSet* mesh, const OutputMesh& output, int digits, Warnings& warnings);

/**
 * Warns about 3D cells with negative volume, except polyhedra, for formats that list faces without
 * their side: such cells are no longer inverted after reading.
 * @param format e.g. "Visf"
 */
void WarnOfInvertedCells(vtkDataSet* mesh, const char* format, Warnings& warnings);
}

#endif
