// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelStyle.h
 * @brief Which elements of a Mesh Inspection have id labels, and how these look.
 */
#ifndef camaron_LabelStyle_h
#define camaron_LabelStyle_h

#include "InspectionStyle.h"

#include <algorithm> // for std::count
#include <array>     // for one value per element type

namespace camaron
{
/// Element types that have ids.
enum class LabelKind
{
  Point,
  Edge,
  Face,
  Cell
};
constexpr int NumberOfLabelKinds = 4;

template <typename Value>
using OfLabelKinds = std::array<Value, NumberOfLabelKinds>;

/// Properties of the labels.
struct LabelStyle
{
  OfLabelKinds<bool> Shows = { { false, false, false, false } };
  int MaxLabels = 300; ///< for all element types together
  int FontSize = 12;   ///< points
  OfLabelKinds<Color> Colors = { { { { 0.75, 0, 0 } }, { { 0, 0.4, 0 } }, { { 0, 0, 0.8 } },
    { { 0, 0, 0 } } } };

  bool Has(LabelKind kind) const { return this->Shows[static_cast<int>(kind)]; }
  bool IsEmpty() const
  {
    return this->MaxLabels <= 0 || std::count(this->Shows.begin(), this->Shows.end(), true) == 0;
  }
};
}

#endif
