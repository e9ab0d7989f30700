// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OutputWarnings.h
 * @brief Says what of a mesh is lost when it is written, or would be.
 */
#ifndef camaron_OutputWarnings_h
#define camaron_OutputWarnings_h

#include "Scan/ScanError.h"

#include <string> // for names
#include <vector> // for names

class vtkAbstractArray;
class vtkDataArray;
class vtkDataSet;

namespace camaron
{
class OutputMesh;

/// Names of the arrays of a mesh that are written.
struct WrittenArrays
{
  std::vector<std::string> Points;
  std::vector<std::string> Cells;
  std::vector<std::string> Fields;
};

/// The name of an array, or words for one without.
std::string DescribeArray(vtkAbstractArray* array);

/// The same for an array of points or of cells; says of which if the others have one of this name.
std::string DescribeArray(vtkDataSet* mesh, vtkAbstractArray* array, bool ofCells);

///@{
/**
 * Warns of arrays that are not written, except those for VTK's own use (global ids, ghosts, time).
 * @param format e.g. "Visf"
 * @param written of the mesh; without it the format holds no arrays at all
 */
void WarnOfArrays(vtkDataSet* mesh, const char* format, Warnings& warnings);
void WarnOfArrays(
  vtkDataSet* mesh, const char* format, Warnings& warnings, const WrittenArrays& written);
///@}

/**
 * Warns of points whose coordinates are not the same in single precision. False with the error if
 * one is beyond its range.
 * @param mesh as for MeshView
 * @param path of the file, for the error
 */
bool CheckSinglePrecision(
  vtkDataSet* mesh, const std::string& path, Warnings& warnings, ScanError& error);

/**
 * The same for an array, nullptr for none.
 * @param components how many of each tuple are written
 * @param one what a tuple is, e.g. "normal"
 */
bool CheckSinglePrecision(vtkDataArray* array, int components, const char* one, const char* many,
  const std::string& path, Warnings& warnings, ScanError& error);

/// Warns of integers that are not the same as numbers in double precision, which formats have for
/// them.
void WarnOfIntegers(vtkDataArray* array, Warnings& warnings);

/**
 * Warns of points that are written and whose coordinates have more than so many significant digits,
 * and where those keep less than a millionth of the size of the mesh, as far from the origin or as
 * they are so few.
 * @param digits 0 for as many as there are
 */
void WarnOfDigits(vtkDataSet* mesh, const OutputMesh& output, int digits, Warnings& warnings);

/**
 * Warns of 3D cells of negative volume, other than polyhedra, for formats that give cells by faces
 * which do not say where the inside is: they are healthy when they are read.
 * @param format e.g. "Visf"
 */
void WarnOfInvertedCells(vtkDataSet* mesh, const char* format, Warnings& warnings);
}

#endif
