// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeText.h
 * @brief A convex shape as text: the words of Camarón's panel, sphere, normals or polygons, and
 * numbers.
 */
#ifndef camaron_ShapeText_h
#define camaron_ShapeText_h

#include <string> // for text
#include <vector> // for numbers

namespace camaron
{
struct ShapeText
{
  enum class Kind
  {
    Sphere,   ///< one row: center, radius, and perhaps how many vertices to draw it with
    Normals,  ///< a row for each plane: its normal, which points outward, and a point
    Polygons, ///< a row for each polygon: its points
  };
  Kind What = Kind::Sphere;
  std::vector<std::vector<double>> Rows;
};

/**
 * The first word says what the numbers after it are; each plane and each polygon has a line of its
 * own. Commas, semicolons, colons, equal signs and brackets count as blanks, and so do the words
 * center, radius, vertices, normal and point; `#` begins a comment. Throws std::invalid_argument
 * with file, line, what was expected and what was found.
 * @param file name for messages
 */
ShapeText ParseShape(const std::string& file, const std::string& text);
}

#endif
