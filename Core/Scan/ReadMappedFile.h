// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReadMappedFile.h
 * @brief The frame of a reader: opens the file, provides threads, turns exceptions into errors.
 */
#ifndef camaron_ReadMappedFile_h
#define camaron_ReadMappedFile_h

#include "Base/Parallel.h"
#include "Scan/MappedFile.h"

#include <new>       // for std::bad_alloc
#include <stdexcept> // for std::length_error

namespace camaron
{
/**
 * Returns what @a read(const MappedFile&) returns, or false with the reason in @a error, which may
 * be that the file was changed while it was read.
 */
template <typename Read>
bool ReadMappedFile(const std::string& path, ScanError& error, Read&& read)
{
  bool good = false;
  // Nothing may be thrown through WithThreads, which has to set VTK's backend back.
  WithThreads(
    [&]
    {
      const auto fail = [&]
      { error = { ErrorKind::Memory, GetFileName(path) + ": not enough memory for the mesh" }; };
      try
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
          // What is wrong with a file that was changed meanwhile is that.
          good = file.IsUnchanged(error) && good;
        }
      }
      catch (const std::bad_alloc&)
      {
        fail();
      }
      catch (const std::length_error&)
      {
        fail();
      }
    });
  return good && !error;
}
}

#endif
