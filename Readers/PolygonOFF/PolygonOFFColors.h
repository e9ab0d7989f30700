// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::OFFColors
 * @brief Colors of vertices or faces of an OFF file, in any of their forms.
 *
 * A color is three or four integers from 0 to 255, or three or four real numbers from 0 to 1, or
 * one integer, an index into a color map. Numbers are real if any of them is written as such. If
 * all are 0 or 1 and written as integers, the other rows of the file decide, so colors are
 * converted at the end.
 */
#ifndef camaron_PolygonOFFColors_h
#define camaron_PolygonOFFColors_h

#include "vtkType.h" // for sizes

#include <cstdint> // for integers of known size
#include <vector>  // for colors

class vtkDataSetAttributes;

namespace camaron
{
/// Largest value of a component of a color in bytes.
constexpr int FullColor = 255;

/// The nearest one for a number, which ranges from 0 to 1 if it is real; 0 for NaN.
int ToColorByte(double value, bool isReal);

/// The numbers of one color.
struct OFFColor
{
  double Values[4] = { 0, 0, 0, 0 };
  int Count = 0; ///< 0 for no color
  bool IsReal = false;

  /// Whether bytes are at most 255 and real numbers from 0 to 1; true if there is no color.
  bool IsInRange() const;
};

class OFFColors
{
public:
  /// The forms found in all rows of a file; each thread has its own.
  struct Census
  {
    bool HasColors = false;
    bool HasIndices = false;
    bool HasReals = false;
    bool HasBytes = false; ///< integers above 1

    /// Counts a color; false if it is not a valid one.
    bool Add(const OFFColor& color);
    void Merge(const Census& other);
  };

  OFFColors() = default;
  /// For rows without a color.
  explicit OFFColors(vtkIdType size) { this->Resize(size); }
  vtkIdType size() const { return static_cast<vtkIdType>(this->Kinds.size()); }

  /// Sets a color; thread-safe.
  void Set(vtkIdType i, const OFFColor& color);
  /// Drops colors, or adds rows without a color.
  void Resize(vtkIdType size);

  /// Adds the arrays "RGBA" and "ColorIndex", if the file has such colors.
  void AddTo(vtkDataSetAttributes* attributes, const Census& census, bool areSmallReal);

private:
  enum Kind : unsigned char
  {
    None,
    Index,
    Bytes,
    SmallRGB, ///< integers 0 and 1, which are bytes or real numbers
    SmallRGBA
  };
  std::vector<std::uint32_t> Values; ///< four bytes, or an index
  std::vector<Kind> Kinds;
};
}

#endif
