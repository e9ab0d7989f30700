// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeText.h
 * @brief Parses a convex shape or a closed surface from text.
 *
 * The keywords sphere, normals and polygons are those of the program Camarón.
 */
#ifndef camaron_ShapeText_h
#define camaron_ShapeText_h

#include <string> // for text
#include <vector> // for numbers

namespace camaron
{
/// The numbers of a shape, and what they mean.
struct ShapeText
{
  enum class Kind
  {
    Sphere,   ///< one row: center, radius, optionally the number of vertices to draw
    Normals,  ///< one row per plane: outward normal, then a point of the plane
    Polygons, ///< one row per polygon: its points
  };
  Kind What = Kind::Sphere;
  std::vector<std::vector<double>> Rows;
};

/**
 * The first word is the keyword that says what the numbers mean. Each plane and each polygon has
 * its own line. Commas, semicolons, colons, equal signs and brackets count as blanks, and so do the
 * words center, radius, vertices, normal and point; `#` starts a comment. Throws
 * std::invalid_argument with file, line, what was expected and what was found.
 *
 * @param file file name for messages
 */
ShapeText ParseShape(const std::string& file, const std::string& text);
}

#endif
