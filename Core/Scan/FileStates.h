// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FileStates
 * @brief Records the states of the files that this thread opens during the lifetime of the object.
 *
 * Ranks that read parts of the same files can only combine them if all found the files in the same
 * state. The state of all files is summarized in three numbers, regardless of the order in which
 * they were opened. A thread can only have one such object at a time.
 */
#ifndef camaron_FileStates_h
#define camaron_FileStates_h

#include <string> // for paths
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
    long long Identity = 0; ///< which files, and their modification times, on that machine
  };
  /// The properties of one file that MappedFile knows.
  struct File
  {
    long long Device, Node, Size, Seconds, Nanoseconds;
  };

  FileStates();
  ~FileStates();
  FileStates(const FileStates&) = delete;
  void operator=(const FileStates&) = delete;

  const State& Get() const { return this->Sum; }
  /// Paths of the files, in the order of opening.
  const std::vector<std::string>& GetPaths() const { return this->Paths; }
  /// Records a file, if this thread has a FileStates object.
  static void Add(const std::string& path, const File& file);

  /**
   * Whether these may be the same states. Sizes must be equal everywhere; copies on other machines
   * are different files with other modification times.
   */
  static bool AreSame(const std::vector<State>& states);

private:
  State Sum;
  std::vector<std::string> Paths;
};
}

#endif
