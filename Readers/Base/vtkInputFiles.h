// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkInputFiles
 * @brief Tells on the server whether an output would replace a file from which data was read.
 *
 * The commands and the Mesh Inspector ask before they write; see camaron::InputFiles.
 */
#ifndef vtkInputFiles_h
#define vtkInputFiles_h

#include "CamaronReadersModule.h" // for export macro
#include "vtkObject.h"

#include <memory> // for the files
#include <string> // for the answer
#include <vector> // for the targets

class vtkAlgorithm;

namespace camaron
{
class InputFiles;
}

class CAMARONREADERS_EXPORT vtkInputFiles : public vtkObject
{
public:
  static vtkInputFiles* New();
  vtkTypeMacro(vtkInputFiles, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Adds a file that is read.
  void AddFile(const char* path);
  /// Adds the files that the readers of a pipeline have opened so far, of all its steps.
  void AddSource(vtkAlgorithm* source);

  ///@{
  /// The files to be written.
  void AddTarget(const char* path);
  void ClearTargets();
  ///@}
  /// The input that each target would replace, or that lists the target (a .pvtu file lists its
  /// pieces), separated by the character 0x1F; empty if there is none, and on other processes than
  /// the first.
  const char* GetReplaced();

protected:
  vtkInputFiles();
  ~vtkInputFiles() override;

private:
  vtkInputFiles(const vtkInputFiles&) = delete;
  void operator=(const vtkInputFiles&) = delete;

  std::unique_ptr<camaron::InputFiles> Files;
  std::vector<std::string> Targets;
  std::string Replaced;
};

#endif
