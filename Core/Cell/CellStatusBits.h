// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellStatusBits.h
 * @brief What may be wrong with a cell: the bits of the criterion CellStatus.
 *
 * The first nine mean what those of vtkCellStatus mean (VTK 9.6).
 */
#ifndef camaron_CellStatusBits_h
#define camaron_CellStatusBits_h

namespace camaron
{
enum CellStatusBits : unsigned
{
  WrongNumberOfPoints = 0x1,
  IntersectingEdges = 0x2,
  IntersectingFaces = 0x4,
  NoncontiguousEdges = 0x8, ///< a face that comes to a point twice
  Nonconvex = 0x10,
  FacesAreOrientedIncorrectly = 0x20,
  NonPlanarFaces = 0x40,
  DegenerateFaces = 0x80,
  CoincidentPoints = 0x100,
  NotWatertight = 0x1000,     ///< an edge of one face
  NonManifoldEdge = 0x2000,   ///< an edge of more than two faces
  NonManifoldVertex = 0x4000, ///< faces around a point that do not form one ring
  InvertedOrZeroVolume = 0x8000,
  ZeroLengthEdge = 0x10000,
  NotStarShaped = 0x20000,
  NonFinitePoint = 0x40000,
  OpenCell = 0x80000 ///< face vectors that do not add up to zero
};
}

#endif
