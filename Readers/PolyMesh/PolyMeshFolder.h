// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PolyMeshFolder
 * @brief The folder constant/polyMesh of an OpenFOAM case, which appears when it is complete.
 *
 * The files are written into a temporary folder beside it. Until Commit, and after errors, an
 * existing mesh is unchanged and nothing else remains. Files of other kinds in it, such as
 * blockMeshDict, are kept.
 */
#ifndef camaron_PolyMeshFolder_h
#define camaron_PolyMeshFolder_h

#include "Base/FunctionRef.h" // for changes of files
#include "Scan/ScanError.h"

#include <filesystem> // for paths
#include <vector>     // for created folders

namespace camaron
{
class PolyMeshFolder
{
public:
  /// @param marker path of the file case.foam
  explicit PolyMeshFolder(const std::string& marker);
  ~PolyMeshFolder();
  PolyMeshFolder(const PolyMeshFolder&) = delete;
  PolyMeshFolder& operator=(const PolyMeshFolder&) = delete;

  /// Whether the mesh may be written; false with the error if there is one that must stay.
  bool Check(bool overwrites, ScanError& error) const;
  /// Creates the temporary folder, and one for sets in it if needed; false with the error.
  bool Open(bool hasSets, ScanError& error);
  const std::filesystem::path& GetPath() const { return this->Temporary; }
  /// Puts the mesh in place, and the marker if there is none; false with the error.
  bool Commit(ScanError& error);

private:
  bool Try(ScanError& error, FunctionRef<void()> change) const;

  std::filesystem::path Marker, Mesh, Temporary;
  std::vector<std::filesystem::path> Created; ///< folders that were missing, outer first
};
}

#endif
