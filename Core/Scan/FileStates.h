// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FileStates
 * @brief In which state the files are that this thread opens while the object is there.
 *
 * For processes that read parts of the same files: what they have belongs together only if all
 * found the files in the same state. Each state is summed up in three numbers, whatever the order
 * in which files were opened. Only one object per thread can be there at a time.
 */
#ifndef camaron_FileStates_h
#define camaron_FileStates_h

#include <vector> // for the states of several processes

namespace camaron
{
class FileStates
{
public:
  struct State
  {
    long long Place = 0; ///< machine and file systems
    long long Size = 0;
    long long Identity = 0; ///< which files, and when they were changed, on that machine
  };
  /// What MappedFile knows of one file.
  struct File
  {
    long long Device, Node, Size, Seconds, Nanoseconds;
  };

  FileStates();
  ~FileStates();
  FileStates(const FileStates&) = delete;
  void operator=(const FileStates&) = delete;

  const State& Get() const { return this->Sum; }
  /// Takes note of a file, if there is an object.
  static void Add(const File& file);

  /**
   * Whether these may be the same states. Sizes have to be the same everywhere. Copies on other
   * machines are files of their own, which were written at other times.
   */
  static bool AreSame(const std::vector<State>& states);

private:
  State Sum;
};
}

#endif
