// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UpstreamFiles.h
 * @brief The files from which the input of an algorithm was read.
 */
#ifndef camaron_UpstreamFiles_h
#define camaron_UpstreamFiles_h

#include "Intake/Write/InputFiles.h"

class vtkAlgorithm;

namespace camaron
{
/**
 * The files that the readers upstream of an algorithm, or the algorithm itself, have opened: those
 * of this plugin report every file, other readers the names that they were given. Files that lists
 * name, such as the pieces of a .pvtu file, follow from InputFiles.
 */
InputFiles FindUpstreamFiles(vtkAlgorithm* algorithm);
}

#endif
