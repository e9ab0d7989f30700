// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VisfWriting.h
 * @brief Writes Visf mesh files.
 */
#ifndef camaron_VisfWriting_h
#define camaron_VisfWriting_h

#include "Base/Progress.h"
#include "Scan/ScanError.h"

#include <string> // for paths

class vtkDataSet;

namespace camaron
{
enum class VisfEncoding
{
  Ascii = 0,    ///< version 0.3, text
  Little = 1,   ///< version 0.3, little endian
  Big = 2,      ///< version 0.3, big endian
  Little02 = 3, ///< version 0.2, little endian
};

/**
 * Writes all cells of a vtkUnstructuredGrid or vtkPolyData. Every face of 3D cells becomes one
 * polygon, oriented as in the first cell that has it; a third and fourth cell at the same face use
 * a second polygon, and so do open cells that orient the face alike. 2D cells become polygons of
 * their own. A mesh with vertices only becomes a cloud of its points; in others, vertices and lines
 * become polygons with one and two vertices.
 * @param neighbors also write, for every polygon, those that share at least two vertices with it
 * @return false with the error in @a error, or without one if aborted; the file is then unchanged
 */
bool WriteVisf(const std::string& path, vtkDataSet* mesh, VisfEncoding encoding, bool neighbors,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress());
}

#endif
