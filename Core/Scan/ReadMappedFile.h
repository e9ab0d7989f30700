// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReadMappedFile.h
 * @brief The frame of a reader: opens the file, provides threads, converts exceptions to errors.
 */
#ifndef camaron_ReadMappedFile_h
#define camaron_ReadMappedFile_h

#include "Base/Parallel.h"
#include "Scan/MappedFile.h"

#include "vtkUnstructuredGrid.h" // to empty it

#include <new>       // for std::bad_alloc
#include <stdexcept> // for std::length_error

namespace camaron
{
/**
 * Returns the result of @a read(const MappedFile&), or false with the reason in @a error, for
 * example that the file was changed while reading.
 */
template <typename Read>
bool ReadMappedFile(const std::string& path, ScanError& error, Read&& read)
{
  bool good = false;
  const auto fail = [&]
  { error = { ErrorKind::Memory, GetFileName(path) + ": not enough memory for the mesh" }; };
  try
  {
    WithThreads(
      [&]
      {
        MappedFile file;
        if (file.Open(path, error))
        {
          try
          {
            good = read(static_cast<const MappedFile&>(file));
          }
          catch (...)
          {
            if (file.IsUnchanged(error))
            {
              throw;
            }
          }
          // If the file was changed, this error replaces all others.
          good = file.IsUnchanged(error) && good;
        }
      });
  }
  catch (const std::bad_alloc&)
  {
    fail();
  }
  catch (const std::length_error&)
  {
    fail();
  }
  return good && !error;
}

/// The same for a reader that fills @a grid, which is emptied first, and also, like @a warnings, if
/// reading fails.
template <typename Read>
bool ReadMappedFile(const std::string& path, vtkUnstructuredGrid* grid, Warnings& warnings,
  ScanError& error, Read&& read)
{
  grid->Initialize();
  const bool good = ReadMappedFile(path, error, read);
  if (!good)
  {
    grid->Initialize();
    warnings = Warnings();
  }
  return good;
}
}

#endif
