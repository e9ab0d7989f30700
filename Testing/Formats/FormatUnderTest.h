// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FormatUnderTest.h
 * @brief The format of Readers/Formats.cmake that a test program tests.
 *
 * The programs of this folder and of Testing/Fuzz choose it when they start.
 */
#ifndef camaron_FormatUnderTest_h
#define camaron_FormatUnderTest_h

#include "vtkSmartPointer.h"

#include <string> // for names
#include <vector> // for extensions

class vtkMeshFileReader;
class vtkMeshFileWriter;

namespace camaron
{
namespace testing
{
struct FormatUnderTest
{
  std::string Name;
  std::vector<std::string> Extensions; ///< without the dot, the default one first
  std::string SeedFolder;              ///< Readers/<Name>/Testing/Seeds
  std::string Dictionary;              ///< Readers/<Name>/Testing/<Name>.dict
  /// Whether a library reads the bytes. What it does with wrong ones is tested by the format, in a
  /// process of its own.
  bool IsOfLibrary;
};

/// To be called first, with the name of a format; false if there is no such format.
bool ChooseFormat(const std::string& name);

const FormatUnderTest& GetFormat();
vtkSmartPointer<vtkMeshFileReader> MakeReader();
/// nullptr if the format has no writer.
vtkSmartPointer<vtkMeshFileWriter> MakeWriter();
}
}

#endif
