// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FoamLabels.h
 * @brief Labels of cells and points in OpenFOAM's sets and zones.
 */
#ifndef camaron_FoamLabels_h
#define camaron_FoamLabels_h

#include <cstdint> // for labels
#include <string>  // for paths
#include <vector>  // for labels

namespace camaron
{
struct FoamLabels
{
  bool ArePoints = false;
  std::int64_t NumberOfCells = -1;  ///< of the mesh to which a set of faces belongs, else -1
  std::vector<std::int64_t> Labels; ///< ascending, each once
};

/**
 * Reads a cellSet, faceSet or pointSet, or one of the zones in cellZones, faceZones or pointZones,
 * in text or binary, compressed or not. Faces become the cells on both sides, by the files owner
 * and neighbour of the mesh.
 *
 * @param path such as constant/polyMesh/sets/nonOrthoFaces, with or without .gz
 * @param zone name of a zone; empty for a set
 * @throw std::runtime_error with the file, the byte, what was expected, and what was found
 */
FoamLabels ReadFoamLabels(const std::string& path, const std::string& zone);
}

#endif
