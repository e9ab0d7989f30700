// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetGenFiles.h
 * @brief The files of a mesh of TetGen or Triangle: their content and paths.
 */
#ifndef camaron_TetGenFiles_h
#define camaron_TetGenFiles_h

#include "Scan/MappedFile.h"

#include <string> // for paths

namespace camaron
{
/// Content of a file, by its extension.
enum class TetGenKind
{
  Node,  ///< points
  Ele,   ///< tetrahedra or triangles
  Face,  ///< triangles
  Edge,  ///< line segments
  Neigh, ///< neighbors of elements
  Poly,  ///< facets, or segments in two dimensions
  Smesh, ///< facets of one polygon each
  None   ///< none of these
};

TetGenKind GetTetGenKind(const std::string& path);

/**
 * Whether the name is that of edges, faces or cells of a Voronoi diagram of TetGen, whose rows
 * differ from those of a mesh.
 */
bool IsTetGenVoronoi(const std::string& path);

/// Path of the file of a kind that belongs to @a path, which differs in the last extension.
std::string GetTetGenCompanion(const std::string& path, TetGenKind kind);

/// Whether a file of this kind, perhaps compressed, exists next to @a path.
bool HasTetGenCompanion(const std::string& path, TetGenKind kind);

/**
 * Opens the file of a kind that belongs to @a path, or the compressed one.
 * @param content what it contains, for errors, e.g. "nodes"
 */
bool OpenTetGenCompanion(const std::string& path, TetGenKind kind, const char* content,
  MappedFile& file, ScanError& error);
}

#endif
