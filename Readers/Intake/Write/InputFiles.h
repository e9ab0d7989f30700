// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::InputFiles
 * @brief The files from which data was read, which no output may replace.
 *
 * Files are the same if the system says so: other spellings of a path, symbolic and hard links, and
 * names in another case on file systems that ignore it. Files that list others, such as .pvtu,
 * .vtm, .pvd, .xmf or EnSight's .case, include the files that they name, and OpenFOAM's .foam the
 * files of the case. Lists are only read when an existing file is about to be replaced.
 */
#ifndef camaron_InputFiles_h
#define camaron_InputFiles_h

#include <set>    // for what is known
#include <string> // for paths
#include <vector> // for paths

namespace camaron
{
class InputFiles
{
public:
  void Add(const std::string& path);
  void Add(const InputFiles& others);
  const std::vector<std::string>& GetPaths() const { return this->Paths; }

  ///@{
  /**
   * The file added that each of the targets would replace or change, or that lists it; empty if
   * there is none.
   */
  std::vector<std::string> FindReplaced(const std::vector<std::string>& targets) const;
  std::string FindReplaced(const std::string& target) const;
  ///@}

  /**
   * Protects files until the object is destroyed: OutputFile refuses to replace them in this
   * thread. A thread can only have one such object at a time.
   */
  class Protection
  {
  public:
    explicit Protection(const InputFiles& files);
    ~Protection();
    Protection(const Protection&) = delete;
    void operator=(const Protection&) = delete;
  };
  /// FindReplaced of the files protected in this thread.
  static std::string FindProtected(const std::string& target);

private:
  std::vector<std::string> Paths;
  std::set<std::string> Known;
};
}

#endif
