// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetGenFiles.h
 * @brief The files that make up a mesh of TetGen or Triangle: which is what, and where the others
 * are.
 */
#ifndef camaron_TetGenFiles_h
#define camaron_TetGenFiles_h

#include "Scan/MappedFile.h"

#include <string> // for paths

namespace camaron
{
/// What a file holds, as its extension says.
enum class TetGenKind
{
  Node,  ///< points
  Ele,   ///< tetrahedra or triangles
  Face,  ///< triangles
  Edge,  ///< line segments
  Neigh, ///< neighbors of elements
  Poly,  ///< facets, or segments in two dimensions
  Smesh, ///< facets of one polygon each
  None   ///< not one of these files
};

TetGenKind GetTetGenKind(const std::string& path);

/**
 * Whether the name is that of edges, faces or cells of a Voronoi diagram of TetGen, whose rows are
 * others than those of a mesh.
 */
bool IsTetGenVoronoi(const std::string& path);

/**
 * Path of the file of a kind that belongs to @a path: the last extension is another one. Upper case
 * is kept if there is such a file.
 */
std::string GetTetGenCompanion(const std::string& path, TetGenKind kind);

/// Whether there is a file of this kind beside @a path.
bool HasTetGenCompanion(const std::string& path, TetGenKind kind);

/**
 * Opens the file of a kind that belongs to @a path.
 * @param content what is in it, for errors, e.g. "nodes"
 */
bool OpenTetGenCompanion(const std::string& path, TetGenKind kind, const char* content,
  MappedFile& file, ScanError& error);
}

#endif
